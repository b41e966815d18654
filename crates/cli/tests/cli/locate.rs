//! `splitstar locate`: answers, strategies, messages.

use crate::{Folder, finish, model, program, run, run_with};
use serde_json::{Value, json};
use std::process::Stdio;

const STRATEGIES: [&str; 5] = ["naive", "walk", "landmarks", "trapezoids", "sweep"];
const OF_RAYS: [&str; 4] = ["naive", "walk", "landmarks", "trapezoids"];

/// A line through the plane, a point above it, and numbers that leave some out.
const LINE: &str = "star 1 arrangement\nsurface plane\ncurve 2 line 0 0 1 0\nvertex 6 0 1\n\
                    edge 4 infinity infinity curve 2\nface 3\nouter -4\nface 8\nouter +4\nisolated 6\nend\n";

/// A point, where it lies, and what rays from there up and down meet.
const ANSWERS: &[(&str, &str, &str, &str)] = &[
    ("0 -1", "face 3", "edge 4", "face 3"),
    ("5 0", "edge 4", "face 8", "face 3"),
    ("point 0 0.5", "face 8", "vertex 6", "edge 4"),
    ("POINT (0 1)", "vertex 6", "face 8", "edge 4"),
    ("1e3 1/3", "face 8", "face 8", "edge 4"),
    ("{\"type\": \"Point\", \"coordinates\": [0.0, 1.25, 7]}", "face 8", "face 8", "vertex 6"),
];

fn column(of: impl Fn(&(&'static str, &'static str, &'static str, &'static str)) -> &'static str) -> String {
    ANSWERS.iter().map(|row| format!("{}\n", of(row))).collect()
}

#[test]
fn cells_have_the_numbers_of_the_file() {
    let folder = Folder::new("locate_numbers");
    let file = folder.write("line.star", LINE);
    let points = folder.write("points.txt", &column(|row| row.0));
    let note = format!("note: {points}: 1 point has more than two coordinates: the others are left out\n");
    let ask = |words: &[&str], expected: &str| {
        let found = run(&[&["locate", &file, &points], words].concat());
        assert_eq!(found.stderr, note, "{words:?}");
        assert_eq!(found.ok(), expected, "{words:?}");
    };
    ask(&[], &column(|row| row.1));
    ask(&["--ray", "up"], &column(|row| row.2));
    ask(&["--ray=down"], &column(|row| row.3));
    for strategy in STRATEGIES {
        ask(&["--strategy", strategy], &column(|row| row.1));
    }
    for strategy in OF_RAYS {
        ask(&["--strategy", strategy, "--ray", "up"], &column(|row| row.2));
        ask(&["--strategy", strategy, "--ray", "down"], &column(|row| row.3));
    }
}

/// Points on a grid of halves: on vertices, in edges, on verticals above and below vertices, far away.
fn grid() -> String {
    let halves = || -8..=28;
    halves().flat_map(|i| halves().map(move |j| format!("{i}/2 {j}/2\n"))).collect()
}

#[test]
fn all_strategies_give_the_same_bytes() {
    let folder = Folder::new("locate_strategies");
    let points = folder.write("points.txt", &grid());
    for name in ["plane", "torus"] {
        let file = folder.path(&format!("{name}.star"));
        run(&["arrange", &model(&format!("curves/{name}.txt")), "-o", &file]).ok();
        for (ray, strategies) in
            [(&[][..], &STRATEGIES[..]), (&["--ray", "up"], &OF_RAYS), (&["--ray", "down"], &OF_RAYS)]
        {
            let ask = |strategy: &[&str]| {
                let words = [&["locate", &file, &points], ray, strategy].concat();
                run(&words).ok()
            };
            let by_default = ask(&[]);
            assert_eq!(by_default.lines().count(), 37 * 37);
            // On this torus every ray meets something.
            let kinds = if ray.is_empty() { &["vertex", "edge", "face"][..] } else { &["vertex", "edge"] };
            for kind in kinds {
                assert!(by_default.contains(kind), "{name} {ray:?}: no {kind}");
            }
            for &strategy in strategies {
                assert_eq!(ask(&["--strategy", strategy]), by_default, "{name} {ray:?}: {strategy}");
            }
        }
    }
}

#[test]
fn strategies_for_few_points_agree_with_those_for_many() {
    let folder = Folder::new("locate_few");
    let file = folder.path("plane.star");
    run(&["arrange", &model("curves/plane.txt"), "-o", &file]).ok();
    let points = folder.write("points.txt", &grid());
    for ray in [&[][..], &["--ray", "up"], &["--ray", "down"]] {
        let many = run(&[&["locate", &file, &points], ray].concat()).ok();
        for (point, answer) in grid().lines().zip(many.lines()).step_by(97) {
            let one = run_with(&[&["locate", &file, "-"], ray].concat(), point.as_bytes()).ok();
            assert_eq!(one, format!("{answer}\n"), "{point} {ray:?}");
        }
    }
}

#[test]
fn on_a_torus_any_coordinates_will_do() {
    let folder = Folder::new("locate_torus");
    let file = folder.path("torus.star");
    let curves = "period 4 3\nPOLYGON ((1 1, 2 1, 2 2, 1 2, 1 1))\nsegment 0 0 4 0\npoint 3 1/2\n";
    let curves = folder.write("curves.txt", curves);
    run(&["arrange", &curves, "-o", &file]).ok();
    let ask = |points: &str, words: &[&str]| {
        run_with(&[&["locate", &file, "-"], words].concat(), points.as_bytes()).ok()
    };
    for words in [&[][..], &["--ray", "up"], &["--ray", "down"]] {
        let here = ask("3/2 3/2\n1 1\n3/2 2\n3 1/2\n1/2 0\n0 0\n7/2 0.1\n", words);
        let there = ask("period 4 3\n11/2 9/2\n-3 -2\n3/2 -1\n3 7/2\n1/2 3000\n-4 9\n-0.5 -5.9\n", words);
        assert_eq!(here, there, "{words:?}");
    }
    // The ray comes back from the other side.
    assert_eq!(ask("1/2 1\n", &["--ray", "up"]), ask("1/2 0\n", &[]));
    let refused = |points: &str, file: &str| run_with(&["locate", file, "-"], points.as_bytes()).error(1);
    assert_eq!(
        refused("period 3 4\n0 0\n", &file),
        "error: -: its torus has `period 3 4`, that of the arrangement has `period 4 3`; make them one, or leave \
         the record out"
    );
    let plane = folder.write("line.star", LINE);
    let message = refused("period 3 4\n0 0\n", &plane);
    assert!(message.contains("the arrangement lies in the plane"), "{message}");
}

#[test]
fn the_object_has_answers_in_order() {
    let folder = Folder::new("locate_json");
    let file = folder.write("line.star", LINE);
    let input = b"0 1\n0 0\n0 -1\n0 -1\n";
    let object = run_with(&["locate", &file, "-", "--json", "--strategy", "trapezoids"], input).json();
    let mut keys: Vec<&str> = object.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    assert_eq!(keys, ["answers", "located", "points", "ray", "seconds", "strategy"]);
    assert_eq!(object["answers"], json!([{"vertex": 6}, {"edge": 4}, {"face": 3}, {"face": 3}]));
    assert_eq!(object["located"], json!({"vertices": 1, "edges": 1, "faces": 2}));
    assert_eq!((&object["points"], &object["ray"]), (&json!(4), &Value::Null));
    assert_eq!(object["strategy"], "trapezoids");
    for key in ["read", "prepare", "compute", "write"] {
        assert!(object["seconds"][key].as_f64().unwrap() >= 0.0, "{key}");
    }
    // The strategy that was chosen is named.
    let object = run_with(&["locate", &file, "-", "--json", "--ray", "down"], input).json();
    assert_eq!(object["ray"], "down");
    assert!(OF_RAYS.contains(&object["strategy"].as_str().unwrap()));
    let curves: String = (0..40).map(|k| format!("point {k} {k}\n")).collect();
    let many = folder.path("many.star");
    run_with(&["arrange", "-", "-o", &many], curves.as_bytes()).ok();
    for (count, words, strategy) in [
        (2, &[][..], "naive"),
        (3, &[], "sweep"),
        (320, &[], "sweep"),
        (400, &[], "trapezoids"),
        (15, &["--ray", "up"], "naive"),
        (16, &["--ray", "up"], "trapezoids"),
    ] {
        let words = [&["locate", &many, "-", "--json"], words].concat();
        let object = run_with(&words, "1 1\n".repeat(count).as_bytes()).json();
        assert_eq!(object["strategy"], strategy, "{count} {words:?}");
    }
    let object = run_with(&["locate", &file, "-", "--json"], b"").json();
    assert_eq!((&object["points"], &object["answers"]), (&json!(0), &json!([])));
}

#[test]
fn answers_are_written_whole() {
    let folder = Folder::new("locate_written");
    let file = folder.write("line.star", LINE);
    let points = folder.write("points.txt", "0 1\n0 0\n");
    let out = folder.path("answers.txt");
    let written = run(&["locate", &file, &points, "-o", &out, "--strategy", "sweep"]);
    let summary = format!("locate (sweep): 2 points, 1 on vertices, 1 on edges, 0 in faces: {out}, ");
    assert!(written.stderr.starts_with(&summary), "{}", written.stderr);
    assert_eq!(written.ok(), "");
    assert_eq!(folder.read("answers.txt"), "vertex 6\nedge 4\n");
    // What is refused leaves it as it was, and no other file.
    run(&["locate", &file, &file, "-o", &out]).error(1);
    assert_eq!(folder.read("answers.txt"), "vertex 6\nedge 4\n");
    assert_eq!(folder.names(), ["answers.txt", "line.star", "points.txt"]);
    // The object and the file.
    let object = run(&["locate", &file, &points, "-o", &out, "--json", "--ray", "down"]).json();
    assert_eq!(object["answers"], json!([{"edge": 4}, {"face": 3}]));
    assert_eq!(folder.read("answers.txt"), "edge 4\nface 3\n");
    // Standard output.
    let dash = run(&["locate", &file, &points, "-o", "-", "-q"]);
    assert_eq!(dash.stderr, "");
    assert_eq!(dash.ok(), "vertex 6\nedge 4\n");
    let message = run(&["locate", &file, &points, "-o", &folder.path("none/out.txt")]).error(1);
    assert!(message.contains("its directory does not exist"), "{message}");
}

#[test]
fn either_operand_may_be_standard_input() {
    let folder = Folder::new("locate_streams");
    let file = folder.write("line.star", LINE);
    let points = folder.write("points.txt", "0 1\n");
    assert_eq!(run_with(&["locate", "-", &points], LINE.as_bytes()).ok(), "vertex 6\n");
    assert_eq!(run_with(&["locate", &file, "-"], b"0 1\n").ok(), "vertex 6\n");
    let nothing = run_with(&["locate", &file, "-"], b"# no point\n");
    assert_eq!(nothing.stderr, "note: -: the file has no point\n");
    assert_eq!(nothing.ok(), "");
    // More than what is looked at before it is read on; the pieces end at a line, and within one.
    for comment in ["# 15 characters", "# not sixteen characters"] {
        let long = format!("{}{LINE}", format!("{comment}\n").repeat(1 << 13));
        assert_eq!(run_with(&["locate", "-", &points], long.as_bytes()).ok(), "vertex 6\n");
        let long = format!("{}0 1\n", format!("{comment}\n").repeat(1 << 13));
        assert_eq!(run_with(&["locate", &file, "-"], long.as_bytes()).ok(), "vertex 6\n");
    }
}

/// The content of both files, and the message without its beginning `error: FOLDER/`.
const BAD: &[(&str, &str, &str)] = &[
    (LINE, "0 0\n0 zero\n", "points.txt:2: `zero` is no number; "),
    (LINE, "0 nan\n", "points.txt:1: `nan` is not finite; "),
    (LINE, "1 1/0\n", "points.txt:1: `1/0`"),
    (LINE, "1\n", "points.txt:1: the line ends where a point of two coordinates (`x y`) was expected"),
    (LINE, "1 2 3\n", "points.txt:1: `3` where the end of the line was expected"),
    (LINE, "0 0\n\nsegment 0 0 1 1\n", "points.txt:3: a segment in a file of points; remove it, or "),
    (LINE, "LINESTRING (0 0, 1 1)\n", "points.txt:1: a polyline in a file of points; remove it, or "),
    (LINE, "OFF\n3 1 0\n", "points.txt:1: this is a model (OFF), not a file of points; give points as "),
    (
        LINE,
        LINE,
        "points.txt:1: this is an arrangement (star), not a file of points; give the arrangement first",
    ),
    (LINE, "0,0\n", "points.txt:1: `,` between coordinates; write a blank instead"),
    (
        LINE,
        "arc 1 0 0  0 1 0\n",
        "points.txt:1: `arc` in a file of points of the plane cannot be read; give points",
    ),
    (
        "",
        "0 0\n",
        "file.star: the file is empty; an arrangement was expected, as `splitstar arrange CURVES -o OUT.star`",
    ),
    (
        "0 0\n",
        "0 0\n",
        "file.star: a file of points, not an arrangement; give a star file, as `splitstar arrange",
    ),
    (
        "0 0 1\n",
        "0 0\n",
        "file.star: a file of points, not an arrangement; give a star file, as `splitstar arrange",
    ),
    ("0 0\n", LINE, "file.star: a file of points, not an arrangement; exchange both: `splitstar locate "),
    (
        "point 0 0\n",
        LINE,
        "file.star: a file of points, not an arrangement; exchange both: `splitstar locate ",
    ),
    ("POINT (0 0)\n", "", "file.star: a file of points, not an arrangement; give a star file"),
    ("segment 0 0 1 1\n", LINE, "file.star: a file of curves, not an arrangement; `splitstar arrange "),
    (
        "star 1 complex\nend\n",
        "0 0\n",
        "file.star:1: a mesh (star kind `complex`) as an arrangement cannot be read; give a file that begins with \
         `star 1 arrangement`, or curves",
    ),
    ("star 2 arrangement\n", "0 0\n", "file.star:1: star version 2 cannot be read"),
    (
        "OFF\n1 0 0\n0 0 0\n",
        "0 0\n",
        "file.star:1: a file of OFF as an arrangement cannot be read; give a star file",
    ),
    ("segment 0 0 1 1\n", "0 0\n", "file.star: a file of curves, not an arrangement; `splitstar arrange "),
    ("star 1 arrangement\nsurface plane\nface 0\n", "0 0\n", "file.star:3: the file ends where "),
];

#[test]
fn bad_files_are_named() {
    let folder = Folder::new("locate_bad");
    for (arrangement, points, expected) in BAD {
        let file = folder.write("file.star", arrangement);
        let points = folder.write("points.txt", points);
        let message = run(&["locate", &file, &points]).error(1);
        let start = format!("error: {}{expected}", folder.path(""));
        assert!(message.starts_with(&start), "{message}\n{start}");
        assert!(message.contains("; "), "it does not say what to do: {message}");
    }
    let file = folder.write("file.star", LINE);
    let missing = folder.path("missing.txt");
    for words in [["locate", &file, &missing], ["locate", &missing, &file]] {
        assert_eq!(run(&words).error(1), format!("error: {missing}: no such file; check the name"));
    }
}

#[test]
fn what_has_no_point_is_noted() {
    let folder = Folder::new("locate_empty");
    let file = folder.write("line.star", LINE);
    let points = folder.write("points.txt", "POINT EMPTY\n0 0\n");
    let told = run(&["locate", &file, &points]);
    assert_eq!(
        told.notes(),
        [format!("note: {points}: 1 geometry is empty: it has no point, and gets no answer")]
    );
    assert_eq!(told.ok(), "edge 4\n");
}

#[test]
fn answers_are_packed() {
    let folder = Folder::new("locate_gzip");
    let file = folder.write("line.star", LINE);
    let points = folder.write("points.txt", "0 1\n0 0\n");
    for name in ["answers.gz", "answers.txt.GZ"] {
        let out = folder.path(name);
        run(&["locate", &file, &points, "-o", &out]).ok();
        let packed = std::fs::read(&out).unwrap();
        assert_eq!(packed, splitstar::formats::pack_gzip(b"vertex 6\nedge 4\n"), "{name}");
    }
}

#[test]
fn wrong_words_open_no_file() {
    let rows: &[(&[&str], &str)] = &[
        (&[], "the file of an arrangement and a file of points expected, 0 given"),
        (&["a.star"], "the file of an arrangement and a file of points expected, 1 given"),
        (&["a.star", "b", "c"], "the file of an arrangement and a file of points expected, 3 given"),
        (&["-", "-"], "standard input `-` can be read once only"),
        (
            &["a.star", "b", "--strategy", "fast"],
            "unknown strategy `fast`: naive, walk, landmarks, trapezoids, sweep",
        ),
        (&["a.star", "b", "--ray", "left"], "unknown direction `left` of a ray: up or down"),
        (
            &["a.star", "b", "--ray", "up", "--strategy", "sweep"],
            "a sweep finds cells, not what a ray meets; give another strategy: naive, walk, landmarks, trapezoids",
        ),
        (
            &["a.star", "b", "-o", "-", "--json"],
            "`-o -` and `--json` both want standard output; write the answers to a file",
        ),
        (&["a.star", "b", "--format", "star"], "unknown option `--format`"),
    ];
    for (words, expected) in rows {
        let message = run(&[&["locate"], *words].concat()).error(2);
        assert_eq!(message, format!("error: locate: {expected}; see `splitstar locate --help`"));
    }
}

#[test]
fn a_stream_without_end_is_not_read() {
    let folder = Folder::new("locate_endless");
    let file = folder.write("line.star", LINE);
    for (words, start, said) in [
        (["locate", &file, "-"], "y\n", "error: -:1: `y` where a point"),
        (["locate", &file, "-"], "0 0\n0\n", "error: -:2: the line ends where"),
        (["locate", "-", &file], "y\n", "error: -:1: `y` where the first line"),
        (["locate", "-", &file], "star 1 arrangement\nsurface plane\n", "error: -:3: "),
        (["locate", "-", &file], "\0", "error: -:1: "),
    ] {
        let mut command = program();
        command.args(words).stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let mut input = child.stdin.take().unwrap();
        // It may stop to read.
        let _ = std::io::Write::write_all(&mut input, start.repeat((1 << 17) / start.len()).as_bytes());
        let output = child.wait_with_output().unwrap();
        drop(input);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{stderr}");
        assert!(stderr.starts_with(said), "{stderr}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_no_answers() {
    let folder = Folder::new("locate_interrupt");
    let file = folder.write("line.star", LINE);
    let mut command = program();
    command.args(["locate", &file, "-", "-o", &folder.path("out.txt")]);
    let mut child = command.stdin(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    // More than a pipe holds: when all of it is taken, the program is reading.
    std::io::Write::write_all(&mut input, &b"0 0\n".repeat(1 << 18)).unwrap();
    let mut kill = std::process::Command::new("kill");
    kill.args(["-INT", &child.id().to_string()]);
    assert_eq!(finish(kill, b"").code, Some(0));
    let status = child.wait().unwrap();
    drop(input);
    assert_eq!(status.code(), Some(130));
    assert_eq!(folder.names(), ["line.star"]);
}
