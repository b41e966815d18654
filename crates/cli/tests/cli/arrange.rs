//! `splitstar arrange`: numbers of cells, messages, what is written.

use crate::{Folder, finish, model, program, run, run_with};
use serde_json::Value;
use std::process::Stdio;

/// A file, the numbers of vertices, edges, faces, isolated vertices and components, and the first three with splits. All of
/// them are counted by hand.
type Row = (&'static str, &'static str, [u64; 5], [u64; 3]);

const ROWS: &[Row] = &[
    ("cross", "segment 0 0 2 2\nsegment 0 2 2 0\n", [5, 4, 1, 0, 1], [5, 4, 1]),
    ("triangle", "segment 0 0 2 0\nsegment 2 0 1 2\nsegment 1 2 0 0\n", [3, 3, 2, 0, 1], [3, 3, 2]),
    ("overlap", "segment 0 0 2 0\nsegment 1 0 3 0\n", [4, 3, 1, 0, 1], [4, 3, 1]),
    ("twice the same", "segment 0 0 1/3 0.1\nsegment 1/3 1e-1 0 0\n", [2, 1, 1, 0, 1], [2, 1, 1]),
    ("three lines", "line 0 0 1 0\nline 0 0 0 1\nline 1 0 0 1\n", [3, 9, 7, 0, 1], [3, 9, 7]),
    ("parallel lines", "line 0 0 1 1\nline 0 1 1 2\n", [0, 2, 3, 0, 2], [0, 2, 3]),
    ("rays", "ray 0 0 1 0\nray 0 0 -1 5\nray 0 0 0 -1\n", [1, 3, 3, 0, 1], [1, 3, 3]),
    ("a line and a segment", "line 0 0 0 1\nsegment -1 0 1 0\n", [3, 4, 2, 0, 1], [3, 4, 2]),
    ("points", "segment 0 0 2 0\npoint 1 0\npoint 1 0\npoint 5 5\n", [4, 2, 1, 1, 2], [4, 2, 1]),
    ("a closed polyline", "polyline 0 0 4 0 4 4 0 4 0 0\n", [1, 1, 2, 0, 1], [4, 4, 2]),
    ("a zigzag", "polyline 0 0 1 2 2 0 3 2\nsegment 0 1 3 1\n", [7, 8, 3, 0, 1], [7, 8, 3]),
    ("a zigzag and a line", "polyline 0 0 1 2 2 0 3 2\nline 0 1 3 1\n", [5, 8, 4, 0, 1], [5, 8, 4]),
    ("a polyline turns back", "polyline 0 0 2 0 1 0\n", [3, 2, 1, 0, 1], [3, 2, 1]),
    (
        "WKT",
        "POLYGON ((0 0, 9 0, 0 9, 0 0),\n (1 1, 2 1, 1 2, 1 1))\nMULTIPOINT (3 3, 20 20)\n",
        [4, 2, 3, 2, 4],
        [8, 6, 3],
    ),
    (
        "GeoJSON",
        "{\"type\": \"LineString\",\n \"coordinates\": [[0, 0], [2, 2], [2, 0], [0, 2]]}\n",
        [3, 3, 2, 0, 1],
        [5, 5, 2],
    ),
    ("nothing", "# no curve\n", [0, 0, 1, 0, 0], [0, 0, 1]),
    ("a torus", "period 4 3\n", [0, 0, 1, 0, 0], [0, 0, 1]),
    ("once around a torus", "period 4 3\nsegment 0 1 4 1\n", [1, 1, 1, 0, 1], [1, 1, 1]),
    ("both ways around", "period 4 3\nsegment 0 1 4 1\nsegment 1 0 1 3\n", [3, 4, 1, 0, 1], [3, 4, 1]),
    ("two strips", "period 4 3\nsegment 0 1 4 1\nsegment 0 2 4 2\n", [2, 2, 2, 0, 2], [2, 2, 2]),
    ("a torus knot", "period 4 3\nsegment 0 0 8 9\n", [1, 1, 1, 0, 1], [4, 4, 1]),
    ("a zigzag around a torus", "period 4 3\npolyline 0 2 1 5/2 2 2 3 5/2 4 2\n", [1, 1, 1, 0, 1], [1, 1, 1]),
    (
        "a square on a torus",
        "period 4 3\nPOLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))\nPOINT (3/2 3/2)\npoint 11/2 3/2\n",
        [2, 1, 2, 1, 2],
        [5, 4, 2],
    ),
    ("turning back on a torus", "period 6 5\npolyline 3 6 7 3 3 6\n", [2, 1, 1, 0, 1], [4, 3, 1]),
    ("turning back on its side", "period 6 5\npolyline 3 3 6 3 3 3\n", [2, 1, 1, 0, 1], [2, 1, 1]),
    ("onto its own tip on a seam", "period 6 5\npolyline 3 3 7 1 0 1\n", [3, 3, 1, 0, 1], [4, 4, 1]),
    ("down a loop of a torus", "period 6 5\npolyline 3 1 1 6 1 0\n", [3, 3, 1, 0, 1], [4, 4, 1]),
    ("across the corner of a torus", "period 4 3\nsegment -1 -1 1 1\n", [2, 1, 1, 0, 1], [3, 2, 1]),
];

const KEYS: [&str; 5] = ["vertices", "edges", "faces", "isolated", "components"];

fn cells(object: &Value) -> ([u64; 5], [u64; 3]) {
    let count = |object: &Value, key: &str| object[key].as_u64().unwrap();
    (
        KEYS.map(|key| count(object, key)),
        ["vertices", "edges", "faces"].map(|key| count(&object["with_splits"], key)),
    )
}

#[test]
fn cells_are_counted() {
    let folder = Folder::new("arrange_counts");
    for (name, text, counts, with_splits) in ROWS {
        let file = folder.write("curves.txt", text);
        let object = run(&["arrange", &file, "--json"]).json();
        assert_eq!(cells(&object), (*counts, *with_splits), "{name}");
        // The order of one-line curves does not matter; `period` stays the first.
        if text.lines().all(|line| line.starts_with(|c: char| c.is_ascii_lowercase())) {
            let (first, rest): (Vec<&str>, Vec<&str>) =
                text.lines().partition(|line| line.starts_with("period"));
            let lines: Vec<&str> = first.into_iter().chain(rest.into_iter().rev()).collect();
            let object = run_with(&["arrange", "-", "--json"], lines.join("\n").as_bytes()).json();
            assert_eq!(cells(&object), (*counts, *with_splits), "{name}, turned round");
        }
        let picture = run(&["arrange", &file, "-o", "-", "--format", "svg"]).ok();
        assert!(picture.starts_with("<svg ") && picture.ends_with("</svg>\n"), "{name}");
        let star = run(&["arrange", &file, "-o", "-", "--format", "star"]).ok();
        let read = splitstar::formats::read_arrangement(star.as_bytes(), None).unwrap();
        let [seen, stored] = [read.counts(), read.counts_with_splits()];
        let seen_numbers = [seen.vertices, seen.edges, seen.faces, seen.isolated, seen.components];
        assert_eq!(seen_numbers.map(|n| n as u64), *counts, "{name}, read back");
        let stored_numbers = [stored.vertices, stored.edges, stored.faces].map(|n| n as u64);
        assert_eq!(stored_numbers, *with_splits, "{name}, read back");
        assert_eq!(splitstar::formats::write_arrangement(&read), star.as_bytes(), "{name}, written again");
        let drawn = |cell: char| picture.matches(&format!("data-id=\"{cell}")).count() as u64;
        assert_eq!(drawn('e'), with_splits[1], "{name}");
        assert_eq!(drawn('f'), with_splits[2], "{name}");
    }
}

#[test]
fn the_example_files_are_counted() {
    for (name, counts, with_splits) in
        [("plane", [25, 38, 18, 2, 5], [34, 47, 18]), ("torus", [8, 9, 3, 1, 3], [12, 13, 3])]
    {
        let object = run(&["arrange", &model(&format!("curves/{name}.txt")), "--json"]).json();
        assert_eq!(cells(&object), (counts, with_splits), "{name}");
    }
}

#[test]
fn the_object_has_these_keys() {
    let object = run_with(&["arrange", "-", "--json"], b"segment 0 0 1 1\n").json();
    let keys = |object: &Value| {
        let mut keys: Vec<String> = object.as_object().unwrap().keys().cloned().collect();
        keys.sort();
        keys
    };
    assert_eq!(
        keys(&object),
        ["components", "edges", "faces", "isolated", "seconds", "vertices", "with_splits"]
    );
    assert_eq!(keys(&object["with_splits"]), ["edges", "faces", "vertices"]);
    assert_eq!(keys(&object["seconds"]), ["compute", "read", "write"]);
}

#[test]
fn without_an_output_there_is_a_table() {
    let run = run_with(&["arrange", "-"], b"polyline 0 0 4 0 4 4 0 4 0 0\npoint 1 1\n");
    assert_eq!(run.stderr, "");
    let table = "vertices    2\nedges       1\nfaces       2\nisolated    1\ncomponents  2\n\
                 with splits vertices 5, edges 4, faces 2\n";
    assert_eq!(run.ok(), table);
}

#[test]
fn files_are_put_together() {
    let folder = Folder::new("arrange_several");
    let a = folder.write("a.txt", "segment 0 0 2 2\n");
    let b = folder.write("b.wkt", "LINESTRING (0 2, 2 0)\n");
    let torus = folder.write("torus.txt", "period 4 3\nsegment 0 1 4 1\n");
    let other = folder.write("other.txt", "period 3 4\npoint 0 0\n");
    let counts = |words: &[&str]| cells(&run(words).json()).0;
    assert_eq!(counts(&["arrange", &a, &b, "--json"]), [5, 4, 1, 0, 1]);
    assert_eq!(counts(&["arrange", &a, &b, "--json", "--surface", "plane"]), [5, 4, 1, 0, 1]);
    // The period of one file is that of all.
    assert_eq!(counts(&["arrange", &a, &torus, "--json"]), [4, 4, 1, 0, 1]);
    assert_eq!(counts(&["arrange", &torus, "--json", "--surface", "torus"]), [1, 1, 1, 0, 1]);
    assert_eq!(counts(&["arrange", &b, "--json", "--period", "4,3"]), [2, 1, 1, 0, 1]);
    assert_eq!(counts(&["arrange", &torus, "--json", "--period", "8/2,3.0"]), [1, 1, 1, 0, 1]);
    let message = run(&["arrange", &torus, &other]).error(1);
    assert!(
        message.ends_with(&format!(
            "other.txt: its torus has `period 3 4`, that of {torus} has `period 4 3`; \
             the curves of an arrangement lie on one torus"
        )),
        "{message}"
    );
    let message = run(&["arrange", &torus, "--period", "5,3"]).error(1);
    assert!(message.contains("`period 4 3`, that of --period has `period 5 3`"), "{message}");
}

/// A file, further words, and the message without its beginning `error: FILE`.
const BAD: &[(&str, &[&str], &str)] = &[
    (
        "segment 0 0 1\n",
        &[],
        ":1: the line ends where a segment of two points (`segment x1 y1 x2 y2`) was expected",
    ),
    ("\n# a\nsegment 1 1 1 1\n", &[], ":3: both ends of the segment are the same point"),
    ("line 0 0 1 1\nray 2 3 4/2 3\n", &[], ":2: both points of the ray are the same"),
    ("segment 0 0 1 nan\n", &[], ":1: `nan` is not finite"),
    ("segment 0 0 1 1/0\n", &[], ":1: `1/0`"),
    ("point 1 2\narch 0 0 1\n", &[], ":2: `arch` where `segment`, `ray`, `line`, `polyline`, `point`"),
    (
        "point 1 2\narc 1 0 0 0 1 0\n",
        &[],
        ":2: `arc` in a file of the plane cannot be read; it is a curve of the sphere: arrange it with `--surface sphere`",
    ),
    ("polyline 0 0\n", &[], ":1: the line ends where a polyline of two points or more"),
    ("LINESTRING (0 0, 1 1\n", &[], ":1: the file ends where"),
    ("CIRCULARSTRING (0 0, 1 1, 2 0)\n", &[], ":1: a geometry `CIRCULARSTRING` cannot be read"),
    ("\n{\"type\": \"Topology\"}\n", &[], ":2: an object of type `Topology` cannot be read"),
    (
        "OFF\n3 1 0\n",
        &[],
        ":1: this is a model (OFF), not a file of curves; give curves as text, WKT or GeoJSON",
    ),
    ("period 4 0\n", &[], ":1: `0` where a period larger than 0 was expected"),
    ("period 4 3\nline 0 0 1 1\n", &[], ":2: a line on a torus cannot be read"),
    (
        "segment 0 0 1 1\n\nray 0 0 1 1\n",
        &["--period", "4,3"],
        ":3: a ray has no end on a torus; give a segment, or arrange in the plane",
    ),
    (
        "segment 0 0 1 1\n",
        &["--surface", "torus"],
        ": a torus needs its periods; make `period P Q` the first record of the file, or give --period P,Q",
    ),
    (
        "period 4 3\npoint 0 0\n",
        &["--surface", "plane"],
        ": it has curves of a torus (`period 4 3`), and --surface is plane; leave out one of both",
    ),
    (
        "period 1e-9 1\nsegment 0 0 1 0\nsegment 0 0 0 1\n",
        &[],
        ":2: up to here the curves go around the torus more than 131072 times, and are cut there; \
         give larger periods, or fewer or shorter curves",
    ),
];

#[test]
fn bad_files_are_refused_with_their_lines() {
    let folder = Folder::new("arrange_bad");
    for (text, words, message) in BAD {
        let file = folder.write("curves.txt", text);
        for output in ["out.svg", "out.star"] {
            let out = folder.path(output);
            let all: Vec<&str> = ["arrange", &file, "-o", &out].iter().chain(words.iter()).copied().collect();
            let said = run(&all).error(1);
            assert!(said.starts_with(&format!("error: {file}{message}")), "{text:?}: {said}");
            assert_eq!(folder.names(), ["curves.txt"], "{text:?}");
        }
    }
}

#[test]
fn wrong_words_are_refused() {
    let folder = Folder::new("arrange_usage");
    let out = folder.path("out.svg");
    let rows: &[(&[&str], &str)] = &[
        (&[], "a file to read expected, 0 given"),
        (
            &["a", "-o", "out.off"],
            "an arrangement is not written as `.off`; use .star or .svg, each also with .gz, or --format",
        ),
        (&["a", "-o", "out.gz"], "not written as `.gz`"),
        (&["a", "-o", "out.off.gz"], "not written as `.off.gz`; use .star or .svg, each also with .gz"),
        (&["a", "-o", &out, "--format", "off"], "unknown format `off`: star or svg, each also with .gz"),
        (&["a", "--format", "svg"], "where is missing: -o OUT"),
        (&["a", "--surface", "ball"], "unknown surface `ball`: plane, torus or sphere"),
        (
            &["a", "--surface", "sphere", "--period", "4,3"],
            "`--surface sphere` and `--period` exclude each other",
        ),
        (
            &["a", "--identification", "1,0"],
            "`--identification` is an option of the sphere; give --surface sphere, too",
        ),
        (
            &["a", "--surface", "torus", "--view", "globe", "-o", "a.svg"],
            "`--view` is an option of the sphere; give --surface sphere, too",
        ),
        (
            &["a", "--surface", "sphere", "--view", "disc", "-o", "a.svg"],
            "unknown view `disc`: globe or unfolded",
        ),
        (
            &["a", "--surface", "sphere", "--view", "globe", "-o", "a.star"],
            "`--view` says how a picture looks, and none is written: -o OUT.svg",
        ),
        (&["a", "--surface", "sphere", "--view", "globe"], "`--view` says how a picture looks"),
        (
            &["a", "--surface", "sphere", "--identification", "0,0.0"],
            "`--identification 0,0` is no direction; give another one, such as -1,0",
        ),
        (
            &["a", "--surface", "sphere", "--identification", "1"],
            "`--identification 1`: 1 numbers given, X,Y expected",
        ),
        (&["a", "--period", "4"], "`--period 4`: 1 numbers given, P,Q expected"),
        (&["a", "--period", "4,0"], "a period of `--period` is not larger than 0"),
        (&["a", "--period", "4,3", "--surface", "plane"], "exclude each other"),
        (&["a", "-o", "-", "--json"], "both want standard output; write the arrangement to a file"),
        (&["a", "--method", "hull"], "unknown option `--method`"),
        (&["-", "-"], "read once only"),
    ];
    for (words, expected) in rows {
        let words: Vec<&str> = ["arrange"].iter().chain(words.iter()).copied().collect();
        let message = run(&words).error(2);
        assert!(message.contains(expected), "{words:?}: {message}");
    }
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn the_ending_tells_what_is_written() {
    let folder = Folder::new("arrange_formats");
    let file = folder.write("curves.txt", "segment 0 0 2 2\nsegment 0 2 2 0\n");
    for (name, format, start) in [
        ("a.svg", None, "<svg "),
        ("a.SVG", None, "<svg "),
        ("a.txt", Some("svg"), "<svg "),
        ("a.star", None, "star 1 arrangement\n"),
        ("a", None, "star 1 arrangement\n"),
        ("b.svg", Some("star"), "star 1 arrangement\n"),
    ] {
        let out = folder.path(name);
        let mut words = vec!["arrange", &file, "-o", &out];
        words.extend(format.iter().flat_map(|format| ["--format", format]));
        let written = run(&words);
        assert!(
            written.stderr.starts_with(&format!("arrange: 5 vertices, 4 edges, 1 face: {out}, ")),
            "{}",
            written.stderr
        );
        assert_eq!(written.ok(), "");
        assert!(folder.read(name).starts_with(start), "{name}");
        // The same bytes again.
        let first = folder.read(name);
        run(&words).ok();
        assert_eq!(folder.read(name), first);
    }
    assert_eq!(folder.names(), ["a", "a.SVG", "a.star", "a.svg", "a.txt", "b.svg", "curves.txt"]);
}

#[test]
fn notes_name_the_file() {
    let folder = Folder::new("arrange_notes");
    let file = folder.write("curves.txt", "polyline 0 0 0 0 1 1\nPOINT Z (1 2 3)\nPOINT EMPTY\n");
    let told = run(&["arrange", &file]);
    assert_eq!(
        told.notes(),
        [
            format!("note: {file}: 1 point has more than two coordinates: the others are left out"),
            format!("note: {file}: 1 point of a polyline is the same as the one before it: left out"),
            format!("note: {file}: 1 geometry is empty: it has no curve"),
        ]
    );
    assert_eq!(run(&["arrange", "-q", &file]).stderr, "");
    assert_eq!(run_with(&["arrange", "-"], b"").notes(), ["note: -: the file has no curve"]);
}

#[test]
fn what_is_too_far_for_a_picture_is_told() {
    let folder = Folder::new("arrange_far");
    let file = folder.write("curves.txt", &format!("point {} 0\n", "9".repeat(400)));
    let out = folder.path("out.svg");
    let message = run(&["arrange", &file, "-o", &out]).error(1);
    assert!(message.starts_with(&format!("error: {out}: not drawn: a coordinate is infinite")), "{message}");
    assert!(message.ends_with("write star, which has no limit"), "{message}");
    assert_eq!(folder.names(), ["curves.txt"]);
    assert_eq!(cells(&run(&["arrange", &file, "--json"]).json()).0, [1, 0, 1, 1, 1]);
}

#[test]
fn a_stream_without_end_is_not_read() {
    // More than a pipe holds: a program that wants all of it does not end while the pipe is open.
    for (start, said) in [
        ("y\n", "error: -:1: `y` where `segment`"),
        ("point 0 0\npoint 0\n", "error: -:2: the line ends where"),
        ("\0", "error: -:1: "),
    ] {
        let mut command = program();
        command.args(["arrange", "-"]).stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let mut input = child.stdin.take().unwrap();
        let text = start.repeat((1 << 17) / start.len());
        // It may stop to read.
        let _ = std::io::Write::write_all(&mut input, text.as_bytes());
        let output = child.wait_with_output().unwrap();
        drop(input);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{stderr}");
        assert!(stderr.starts_with(said), "{stderr}");
    }
}

#[cfg(unix)]
#[test]
fn a_sweep_can_be_interrupted() {
    let folder = Folder::new("arrange_interrupt");
    // A grid of a million vertices: seconds of work.
    let lines = (0..1000).map(|k| format!("segment 0 {k} 2000 {}\nsegment {k} 0 {} 2000\n", k + 1, k + 1));
    let file = folder.write("curves.txt", &lines.collect::<String>());
    let mut command = program();
    command.args(["arrange", &file, "-o", &folder.path("out.svg")]).stderr(Stdio::null());
    let mut child = command.spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(300));
    let mut kill = std::process::Command::new("kill");
    kill.args(["-INT", &child.id().to_string()]);
    assert_eq!(finish(kill, b"").code, Some(0));
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(folder.names(), ["curves.txt"]);
}
