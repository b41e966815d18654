//! No input takes more memory than 64 times its size and 64 MiB, or runs for long.
//!
//! The peak is what the system counts as resident (`VmHWM`), looked up while the program runs. A limit on its address
//! space, which is larger, stops what is wrong by far.

// What was measured is worth seeing: `cargo test memory -- --nocapture`.
#![allow(clippy::print_stderr)]

use crate::encode::zip;
use crate::{Folder, model};
use std::fmt::Write;
use std::fs;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const MIB: u64 = 1 << 20;
/// No run takes longer, not even on a machine that is busy.
const LONGEST: Duration = Duration::from_secs(60);
/// The lines of the long files. Files of 10^7 lines take ten times as long, and too long for every day.
const LINES: usize = 300_000;

/// Runs every verb that reads one file, and checks what it takes.
fn check(folder: &Folder, name: &str, content: &[u8]) {
    let file = folder.path(name);
    fs::write(&file, content).unwrap();
    let out = folder.path("out.off");
    for words in [&["info", &file][..], &["convert", &file, "-o", &out], &["hull", &file, "-o", &out]] {
        let bound = 64 * content.len() as u64 + 64 * MIB;
        let (peak, time) = measure(words, 4 * bound);
        let factor = peak as f64 / bound as f64;
        eprintln!("{name} {}: {} MiB, {factor:.3} of the bound, {time:?}", words[0], peak / MIB);
        assert!(peak <= bound, "{name} {}: {} MiB of {}", words[0], peak / MIB, bound / MIB);
        assert!(time <= LONGEST, "{name} {}: {time:?}", words[0]);
        // What ends well or badly, ends as it should.
        let _ = fs::remove_file(&out);
    }
    fs::remove_file(&file).unwrap();
    assert_eq!(folder.names(), [""; 0], "{name}");
}

/// The peak of resident memory, in bytes, and the time. The program must not be stopped by anything but itself.
fn measure(words: &[&str], most: u64) -> (u64, Duration) {
    let limited = format!("ulimit -v {}; exec \"$0\" \"$@\"", most / 1024);
    let start = Instant::now();
    let mut child = Command::new("sh")
        .args(["-c", &limited, env!("CARGO_BIN_EXE_splitstar")])
        .args(words)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    let code = loop {
        // A program that has ended has no memory, and is not counted.
        peak = peak.max(fs::read_to_string(&status).ok().as_deref().and_then(resident).unwrap_or(0));
        if let Some(code) = child.try_wait().unwrap() {
            break code;
        }
        if start.elapsed() > 2 * LONGEST {
            child.kill().unwrap();
        }
        std::thread::sleep(Duration::from_millis(1));
    };
    assert!(matches!(code.code(), Some(0 | 1)), "{words:?}: {code}");
    (peak, start.elapsed())
}

fn resident(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(1024 * line.trim().strip_suffix(" kB")?.parse::<u64>().ok()?)
}

#[test]
fn the_measure_measures() {
    let [cube, ball] = ["convex/cube.off", "convex/ball2.off"].map(model);
    // A program may have ended before anybody looks: the best of some runs.
    let peak = |file: &str| (0..20).map(|_| measure(&["info", file], 1 << 30).0).max().unwrap();
    let [small, large] = [&cube, &ball].map(|file| peak(file));
    assert!(small > MIB / 2 && small < 32 * MIB, "{small}");
    assert!(large > small, "{large}");
}

const HUGE: u32 = 4_000_000_000;

fn ply_header(format: &str, vertices: u32, faces: u32) -> String {
    format!(
        "ply\nformat {format} 1.0\nelement vertex {vertices}\nproperty double x\nproperty double y\n\
         property double z\nelement face {faces}\nproperty list uint int vertex_indices\nend_header\n"
    )
}

#[test]
fn headers_that_promise_much() {
    let folder = Folder::new("memory_headers");
    let check = |name: &str, content: &[u8]| check(&folder, name, content);
    check("counts.off", format!("OFF\n{HUGE} {HUGE} 0\n0 0 0\n").as_bytes());
    check("corners.off", format!("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n{HUGE} 0 1 2\n").as_bytes());
    for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
        let binary = format != "ascii";
        let vertex: &[u8] = if binary { &[0; 24] } else { b"0 0 0\n" };
        let list: &[u8] = if binary { &[0xEE; 40] } else { b"4000000000 0 0 0\n" };
        check("counts.ply", &[ply_header(format, HUGE, HUGE).as_bytes(), vertex].concat());
        check("corners.ply", &[ply_header(format, 1, 1).as_bytes(), vertex, list].concat());
        let nothing = ply_header(format, 1, 0).replace("element face 0", "element nothing 4000000000");
        check("nothing.ply", &[nothing.as_bytes(), vertex, list].concat());
        // Elements without properties take no byte.
        let nothing = nothing.replace("property list uint int vertex_indices\n", "");
        check("empty.ply", &[nothing.as_bytes(), vertex].concat());
    }
    check("count.stl", &[&[b' '; 80][..], &[0xFF; 4], &[0; 50]].concat());
    check("counts.star", b"star 1 complex\nvertex 4294967294 0 0 0\nvolume 4294967294\nend\n");
    check("index.obj", b"v 0 0 0\nf 1 2 4294967295\n");
    check("index.wrl", format!("{VRML}{}", faces("0 1 4294967295 -1")).as_bytes());
    // A list of 65,535 files that are not there.
    check("list.3mf", b"PK\x05\x06\0\0\0\0\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x7F\0\0\0\0\0\0");
}

const VRML: &str = "#VRML V2.0 utf8\n";

fn faces(indices: &str) -> String {
    format!(
        "Shape {{ geometry IndexedFaceSet {{ coord Coordinate {{ point [ 0 0 0, 1 0 0, 0 1 0 ] }} coordIndex [ \
         {indices} ] }} }}\n"
    )
}

/// `1e400` is the largest number that is read: 1330 bits from five bytes.
#[test]
fn exponents() {
    let folder = Folder::new("memory_exponents");
    for exponent in ["1e400", "1e-400", "1e401"] {
        let lines = |count: usize, start: &str| format!("{start}{exponent} 9 9\n").repeat(count);
        // Some that are read, and some that are too many.
        for count in [30_000, 100_000] {
            let text = format!("OFF\n{count} 0 0\n{}", lines(count, ""));
            check(&folder, "exponents.off", text.as_bytes());
            check(&folder, "exponents.obj", lines(count, "v ").as_bytes());
            let header = ply_header("ascii", count as u32, 0);
            check(&folder, "exponents.ply", format!("{header}{}", lines(count, "")).as_bytes());
        }
    }
    // Different numbers are not welded.
    let points: String = (0..20_000).fold(String::new(), |mut text, i| {
        writeln!(text, "{i}e-400 {i} {i}e-400").unwrap();
        text
    });
    check(&folder, "points.off", format!("OFF\n20000 0 0\n{points}").as_bytes());
    let points: String = (0..100_000).fold(String::new(), |mut text, i| {
        writeln!(text, "{i}e400 {i}e400 1e400").unwrap();
        text
    });
    check(&folder, "integers.off", format!("OFF\n100000 0 0\n{points}").as_bytes());
    let digits = "7".repeat(4000);
    let points = format!("{digits} 1/{digits} {digits}\n").repeat(500);
    check(&folder, "digits.off", format!("OFF\n500 0 0\n{points}").as_bytes());
    // Refused without being read as a number.
    check(&folder, "digits.obj", format!("v 0 0 {}\n", "7".repeat(1 << 20)).as_bytes());
}

#[test]
fn packed_data_that_unpacks_to_much() {
    let folder = Folder::new("memory_packed");
    // Made by the program itself.
    let packed = |text: &str, format: &str| {
        let plain = folder.write("plain.off", text);
        let out = folder.path(&format!("packed.{format}"));
        crate::run(&["convert", &plain, "-o", &out, "-q"]).ok();
        let bytes = fs::read(&out).unwrap();
        fs::remove_file(&plain).unwrap();
        fs::remove_file(&out).unwrap();
        bytes
    };
    for (name, count) in [("facets.off.gz", 500_000), ("more.off.gz", 1_200_000)] {
        let text = format!("OFF\n3 {count} 0\n0 0 0\n1 0 0\n0 1 0\n{}", "3 0 1 2\n".repeat(count));
        check(&folder, name, &packed(&text, "off.gz"));
        check(&folder, &name.replace("off", "star"), &packed(&text, "star.gz"));
    }
    let digits = "7".repeat(5000);
    let bytes = packed(&format!("OFF\n1 0 0\n{digits} {digits} {digits}\n"), "off.gz");
    check(&folder, "digits.off.gz", &bytes);
    // Members one behind the other are one file.
    check(&folder, "members.off.gz", &bytes.repeat(3000));
}

#[test]
fn long_texts() {
    let folder = Folder::new("memory_long");
    let check = |name: &str, start: &str, line: &str, end: &str| {
        check(&folder, name, [start, &line.repeat(LINES), end].concat().as_bytes());
    };
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    check("blank.off", "OFF\n", "\n", "");
    check("comments.off", "OFF\n", "# \n", "1 0 0\n0 0 0\n");
    check("blank.obj", "v 0 0 0\n", "\n", "");
    check("comments.obj", "", "#\n", "v 0 0 0\n");
    check("vertices.obj", "", "v 0 0 0\n", "");
    check("vertices.off", &format!("OFF\n{LINES} 0 0\n"), "0 0 0\n", "");
    check("facets.obj", triangle, "f 1 2 3\n", "");
    check("facets.off", &format!("OFF\n3 {LINES} 0\n0 0 0\n1 0 0\n0 1 0\n"), "3 0 1 2\n", "");
    check("lines.obj", triangle, "l 1 2\n", "");
    check("points.obj", triangle, "p 1\n", "");
    check("objects.obj", triangle, "o a\nf 1 2 3\n", "");
    check("normals.obj", triangle, "vn 0 0 1\n", "f 1//1 2//2 3//-1\n");
    check("solids.stl", "", "solid a\nendsolid\n", "");
    let facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    check("facets.stl", "solid\n", facet, "endsolid\n");
    check("facets.ply", &(ply_header("ascii", 3, LINES as u32) + "0 0 0\n1 0 0\n0 1 0\n"), "3 0 1 2\n", "");
    check("elements.ply", "ply\nformat ascii 1.0\n", "element a 1\n", "end_header\n");
    check("properties.ply", "ply\nformat ascii 1.0\nelement vertex 1\n", "property int a\n", "end_header\n");
    let star = "star 1 complex\nvertex 0 0 0 0\nvertex 1 1 0 0\nvertex 2 0 1 0\n";
    check("facets.star", star, "facet 0 1 2\n", "end\n");
    check("edges.star", star, "edge 0 1\n", "end\n");
    check("holes.star", &format!("{star}facet 0 1 2"), " hole 0", "\nend\n");
    check(
        "points.wrl",
        &format!("{VRML}Shape {{ geometry PointSet {{ coord Coordinate {{ point [\n"),
        "0 0 0\n",
        "] } } }\n",
    );
    check("groups.wrl", VRML, "Group {}\n", "");
}

fn threemf(resources: &str, build: &str) -> Vec<u8> {
    let text = format!(
        "<model xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02'><resources>{resources}</resources>\
         <build>{build}</build></model>"
    );
    zip(&[(crate::encode::PART, text.as_bytes())])
}

const MESH: &str = "<object id='1'><mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/>\
                    <vertex x='0' y='1' z='0'/></vertices><triangles><triangle v1='0' v2='1' v3='2'/></triangles>\
                    </mesh></object>";

#[test]
fn long_archives() {
    let folder = Folder::new("memory_archives");
    let check = |name: &str, resources: &str, build: &str| check(&folder, name, &threemf(resources, build));
    let item = "<item objectid='1'/>";
    let triangle = "<triangle v1='0' v2='1' v3='2'/>";
    check("triangles.3mf", &MESH.replace(triangle, &format!("{triangle}\n").repeat(LINES)), item);
    check("blank.3mf", &MESH.replace(triangle, &format!("{triangle}{}", "\n".repeat(LINES))), item);
    check("items.3mf", MESH, &item.repeat(LINES / 10));
    // Each object has the one before it, once or twice.
    for (name, count, times) in [("chain.3mf", 20_000, 1), ("laughs.3mf", 60, 2)] {
        let objects: String = (2..count).fold(MESH.to_string(), |mut text, id| {
            let components = format!("<component objectid='{}'/>", id - 1).repeat(times);
            write!(text, "<object id='{id}'><components>{components}</components></object>").unwrap();
            text
        });
        check(name, &objects, &format!("<item objectid='{}'/>", count - 1));
    }
}

#[test]
fn deep_texts() {
    let folder = Folder::new("memory_deep");
    let check = |name: &str, content: &[u8]| check(&folder, name, content);
    let deep = 100_000;
    check("open.wrl", format!("{VRML}{}", "Group { children [ ".repeat(deep)).as_bytes());
    check("unknown.wrl", format!("{VRML}{}", "Foo { a [ ".repeat(deep)).as_bytes());
    check("proto.wrl", format!("{VRML}{}", "PROTO A [] { ".repeat(deep)).as_bytes());
    let nested =
        format!("{}Shape {{ geometry Box {{}} }}{}", "Group { children ".repeat(deep), "}".repeat(deep));
    check("nested.wrl", format!("{VRML}{nested}").as_bytes());
    let used = (1..60).fold("DEF g0 Shape { geometry Box {} }\n".to_string(), |mut text, i| {
        writeln!(text, "DEF g{i} Group {{ children [ USE g{} USE g{} ] }}", i - 1, i - 1).unwrap();
        text
    });
    check("used.wrl", format!("{VRML}{used}").as_bytes());
    check("open.3mf", &threemf(&"<a>".repeat(deep), ""));
    check("nested.3mf", &threemf(&format!("{}{}", "<a>".repeat(deep), "</a>".repeat(deep)), ""));
}

#[test]
fn one_long_line() {
    let folder = Folder::new("memory_line");
    let line = "x".repeat(10 << 20);
    for (name, start, end) in [
        ("word.off", "", ""),
        ("comment.off", "OFF #", ""),
        ("count.off", "OFF ", " 1 1"),
        ("number.obj", "v ", ""),
        ("object.obj", "o ", "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("name.stl", "solid ", "\n"),
        ("comment.ply", "ply\nformat ascii 1.0\ncomment ", "\n"),
        ("element.ply", "ply\nformat ascii 1.0\nelement ", " 3\n"),
        ("object.star", "star 1 complex\nvertex 0 0 0 0\nobject \"", "\"\nend\n"),
        ("open.star", "star 1 complex\nobject \"", ""),
        ("comment.wrl", "#VRML V2.0 utf8 ", "\n"),
        ("string.wrl", "#VRML V2.0 utf8\nWorldInfo { title \"", ""),
        ("name.wrl", "#VRML V2.0 utf8\nDEF ", " Group {}"),
    ] {
        check(&folder, name, [start, &line, end].concat().as_bytes());
    }
    check(
        &folder,
        "corners.obj",
        format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf{}\n", " 1".repeat(1 << 20)).as_bytes(),
    );
    check(&folder, "polyline.obj", format!("v 0 0 0\nv 1 0 0\nl{}\n", " 1 2".repeat(1 << 18)).as_bytes());
}

#[test]
fn curves_are_read_within_the_bound() {
    let folder = Folder::new("memory_curves");
    let deep = format!("{}1{}", "[".repeat(LINES), "]".repeat(LINES));
    let files: [(&str, Vec<u8>); 8] = [
        ("points", b"point 1 2\n".repeat(LINES)),
        ("fractions", b"point 1/3 2/7\n".repeat(LINES)),
        ("segments", b"segment 0 1 2 3\n".repeat(LINES)),
        ("lines", b"line 0 1 2 3\n".repeat(LINES)),
        ("polylines", b"polyline 0 1 2 3\n".repeat(LINES)),
        ("polyline", [b"polyline", b" 1 2 3 4".repeat(LINES).as_slice(), b"\n"].concat()),
        ("multipoint", [b"MULTIPOINT (1 1", b",1 2".repeat(LINES).as_slice(), b")\n"].concat()),
        ("nested", format!("{{\"type\": \"Point\", \"coordinates\": {deep}}}\n").into_bytes()),
    ];
    let check = |name: &str, content: &[u8]| {
        let file = folder.path(name);
        fs::write(&file, content).unwrap();
        let bound = 64 * content.len() as u64 + 64 * MIB;
        let (peak, time) = measure(&["arrange", &file], 4 * bound);
        eprintln!(
            "{name} arrange: {} MiB, {:.3} of the bound, {time:?}",
            peak / MIB,
            peak as f64 / bound as f64
        );
        assert!(peak <= bound, "{name}: {} MiB of {}", peak / MIB, bound / MIB);
        fs::remove_file(&file).unwrap();
    };
    for (name, content) in files {
        // The last line is wrong: all of it is read, and nothing is arranged, for which there is no bound.
        check(name, &[content.as_slice(), b"circle\n"].concat());
    }
}
