//! `models/invalid/EXPECTED.md`, row by row, for every verb.

use crate::{Folder, counts, finish, model, program, run};
use std::fs;

enum Sum {
    /// Exit code 1; the line in the file (0: none), and words of the message.
    Error(u32, &'static [&'static str]),
    /// The counts of the sum with a cube, and words of the note; no note if there are none.
    Result([u64; 3], &'static [&'static str]),
}
use Sum::{Error, Result};

const CUBE: [u64; 3] = [8, 12, 6];

/// File, outcome of `sum`, counts of `hull` (none: it is refused as `sum` refuses it).
const ROWS: &[(&str, Sum, Option<[u64; 3]>)] = &[
    ("open_mesh.off", Error(11, &["vertex 0 (line 3)", "vertex 3 (line 6)", "one side only"]), Some(CUBE)),
    (
        "flipped_facet.off",
        Error(14, &["orientation", "facets 0 (line 11) and 3 (line 14)", "vertex 2 (line 5)"]),
        Some(CUBE),
    ),
    ("inside_out.off", Result(CUBE, &["inside out", "turned"]), Some(CUBE)),
    (
        "non_planar_quad.off",
        Error(12, &["not planar", "0.894427", "--triangulate", "--hull"]),
        Some([8, 13, 7]),
    ),
    ("duplicate_vertex_unused.off", Result(CUBE, &["1 unused vertex"]), Some(CUBE)),
    ("facet_soup.off", Result(CUBE, &["24 vertices welded to 8"]), Some(CUBE)),
    (
        "self_intersecting.off",
        Error(16, &["not convex", "vertex 0 (line 3)", "vertex 5 (line 8)", "reflex", "--hull"]),
        Some([6, 11, 7]),
    ),
    ("overlapping_shells.off", Error(25, &["not convex", "2 shells", "--hull"]), Some([14, 24, 12])),
    ("coordinate_nan.off", Error(3, &["`nan`", "not finite"]), None),
    ("coordinate_inf.off", Error(3, &["`inf`", "not finite"]), None),
    ("coordinate_word.off", Error(3, &["`zero`", "no number"]), None),
    ("zero_denominator.xoff", Error(3, &["`1/0`", "denominator"]), None),
    ("huge_exponent.off", Result(CUBE, &[]), Some(CUBE)),
    (
        "exponent_bomb.off",
        Error(3, &["`1e999999999`", "too large in magnitude; the largest allowed is 400"]),
        None,
    ),
    ("zero_area_facet.off", Result([13, 21, 10], &["joined"]), Some([4, 6, 4])),
    ("two_vertex_facet.off", Error(17, &["facet of two vertices beside polygons"]), None),
    ("repeated_index.off", Error(16, &["vertex 0 twice"]), None),
    ("index_out_of_range.off", Error(16, &["vertex index 8", "8 vertices"]), None),
    ("negative_index.off", Error(16, &["vertex index -1", "8 vertices"]), None),
    ("truncated.off", Error(12, &["ends where a facet was expected", "2 of 6"]), None),
    ("truncated_header.off", Error(2, &["ends where the numbers of vertices, facets and edges"]), None),
    ("wrong_counts.off", Error(16, &["ends where a facet was expected", "6 of 9"]), None),
    ("huge_counts.off", Error(16, &["ends where a vertex was expected", "14 of 4000000000"]), None),
    ("no_header.off", Error(1, &["no known format"]), None),
    ("binary_garbage.off", Error(1, &["no known format"]), None),
    ("binary_after_header.off", Error(3, &["no number"]), None),
    ("empty.off", Error(0, &["empty"]), None),
    ("zero_everything.off", Error(2, &["empty"]), None),
    ("zero_facets.off", Result(CUBE, &["no facets", "point set", "hull"]), Some(CUBE)),
    ("flat.off", Result([10, 15, 7], &["dimension 2"]), Some([3, 3, 1])),
    (
        "non_manifold_edge.off",
        Error(4, &["not convex", "vertex 1 (line 4)", "vertex 6 (line 9)"]),
        Some([12, 18, 8]),
    ),
    ("non_manifold_vertex.off", Error(9, &["not convex", "vertex 6 (line 9)"]), Some([14, 24, 12])),
];

#[test]
fn every_broken_file_has_a_row() {
    let mut expected: Vec<&str> = ROWS.iter().map(|row| row.0).collect();
    expected.push("EXPECTED.md");
    expected.sort_unstable();
    let mut found: Vec<String> = fs::read_dir(model("invalid"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    found.sort();
    assert_eq!(found, expected);
}

#[test]
fn sum_of_every_broken_file() {
    for method in ["overlay", "hull"] {
        let folder = Folder::new(&format!("invalid_sum_{method}"));
        let out = folder.path("out.off");
        let cube = model("convex/cube.off");
        for (name, expected, _) in ROWS {
            let file = model(&format!("invalid/{name}"));
            for operands in [[&file, &cube], [&cube, &file]] {
                let [a, b] = operands.map(String::as_str);
                let run = run(&["sum", a, b, "-o", &out, "--json", "--method", method]);
                check(name, &file, expected, run, &folder);
            }
        }
    }
}

fn check(name: &str, file: &str, expected: &Sum, run: crate::Run, folder: &Folder) {
    match expected {
        Error(line, words) => {
            let message = run.error(1);
            let place =
                if *line == 0 { format!("error: {file}: ") } else { format!("error: {file}:{line}: ") };
            assert!(message.starts_with(&place), "{name}: {message}");
            for word in *words {
                assert!(message.contains(word), "{name}: {message}");
            }
            assert_eq!(folder.names(), [""; 0], "{name}");
        }
        Result(expected, words) => {
            let notes = run.notes().join("\n");
            assert_eq!(notes.is_empty(), words.is_empty(), "{name}: {notes}");
            assert!(notes.is_empty() || notes.starts_with(&format!("note: {file}: ")), "{name}: {notes}");
            for word in *words {
                assert!(notes.contains(word), "{name}: {notes}");
            }
            let object = run.json();
            assert_eq!(counts(&object), *expected, "{name}");
            assert_eq!(object["convex"], true, "{name}");
            fs::remove_file(folder.path("out.off")).unwrap();
        }
    }
}

#[test]
fn hull_of_every_broken_file() {
    let folder = Folder::new("invalid_hull");
    let out = folder.path("out.off");
    for (name, sum, hull) in ROWS {
        let file = model(&format!("invalid/{name}"));
        let run = run(&["hull", &file, "-o", &out, "--json"]);
        match hull {
            Some(expected) => assert_eq!(counts(&run.json()), *expected, "{name}"),
            None => {
                assert!(matches!(sum, Error(..)), "{name}");
                run.error(1);
                assert_eq!(folder.names(), [""; 0], "{name}");
                continue;
            }
        }
        fs::remove_file(&out).unwrap();
    }
}

/// What is a note of `info` is the error of `sum`, or its note, at the same place.
#[test]
fn info_describes_what_parses() {
    let folder = Folder::new("invalid_info");
    for (name, sum, hull) in ROWS {
        let file = model(&format!("invalid/{name}"));
        let run = run(&["info", &file, "--json"]);
        if hull.is_none() {
            check(name, &file, sum, run, &folder);
            continue;
        }
        let (start, words) = match sum {
            Error(line, words) => (format!("note: {file}:{line}: "), words),
            Result(_, words) => (format!("note: {file}: "), words),
        };
        // What to do is said by verbs that need it done.
        let words: Vec<_> = words.iter().filter(|word| !word.starts_with("--")).collect();
        let is_it = |note: &&str| note.starts_with(&start) && words.iter().all(|word| note.contains(**word));
        assert_eq!(run.notes().iter().any(is_it), !words.is_empty(), "{name}: {}", run.stderr);
        run.json();
    }
}

/// File, note of `convert`, and vertices and facets: as they are, cut into triangles, joined.
const CONVERTED: &[(&str, &str, [[u64; 2]; 3])] = &[
    ("open_mesh.off", "", [[8, 5], [8, 10], [8, 5]]),
    ("flipped_facet.off", "", CONVERTED_CUBE),
    ("inside_out.off", TURNED, CONVERTED_CUBE),
    // Refused, unless it is cut into triangles.
    ("non_planar_quad.off", "", [[0, 0], [8, 12], [0, 0]]),
    ("duplicate_vertex_unused.off", "1 unused vertex dropped", CONVERTED_CUBE),
    ("facet_soup.off", "24 vertices welded to 8 at equal positions", CONVERTED_CUBE),
    ("self_intersecting.off", TURNED, [[6, 8]; 3]),
    ("overlapping_shells.off", "", [[16, 12], [16, 24], [16, 12]]),
    ("huge_exponent.off", "", CONVERTED_CUBE),
    ("zero_area_facet.off", "", [[5, 6], [5, 6], [4, 4]]),
    ("zero_facets.off", "", [[8, 0]; 3]),
    ("flat.off", "", [[3, 2]; 3]),
    ("non_manifold_edge.off", "", [[14, 12], [14, 24], [14, 12]]),
    ("non_manifold_vertex.off", "", [[15, 12], [15, 24], [15, 12]]),
];

const CONVERTED_CUBE: [[u64; 2]; 3] = [[8, 6], [8, 12], [8, 6]];
const TURNED: &str = "the mesh is inside out; its facets were turned round";

#[test]
fn convert_of_every_broken_file() {
    let folder = Folder::new("invalid_convert");
    for (name, sum, hull) in ROWS {
        let file = model(&format!("invalid/{name}"));
        let converted = CONVERTED.iter().find(|row| row.0 == *name);
        assert_eq!(converted.is_some(), hull.is_some(), "{name}");
        for (which, option) in ["", "--triangulate", "--join"].into_iter().enumerate() {
            for ending in ["off", "stl", "star"] {
                let out = folder.path(&format!("out.{ending}"));
                let mut words = vec!["convert", &file, "-o", &out, "--json"];
                words.extend((!option.is_empty()).then_some(option));
                let run = run(&words);
                let case = format!("{name} {option} to {ending}");
                let Some(&(_, note, counts)) = converted else {
                    check(&case, &file, sum, run, &folder);
                    continue;
                };
                let [vertices, facets] = counts[which];
                let refused = match (*name, ending) {
                    ("non_planar_quad.off", _) if vertices == 0 => Some(NOT_PLANAR.replace("FILE", &file)),
                    ("huge_exponent.off", "stl") => Some(format!("{out}: not written: {NO_FLOAT}")),
                    ("zero_facets.off", "stl") => Some(format!("{out}: not written: {NO_FACETS}")),
                    _ => None,
                };
                if let Some(message) = refused {
                    assert_eq!(run.error(1), format!("error: {message}"), "{case}");
                    assert_eq!(folder.names(), [""; 0], "{case}");
                    continue;
                }
                let mut notes = Vec::new();
                if !note.is_empty() {
                    notes.push(format!("note: {file}: {note}"));
                }
                if *name == "zero_area_facet.off" && option == "--join" {
                    notes.push(format!("note: {file}: {JOINED}"));
                }
                let triangles = converted.unwrap().2[1][1];
                let cut = ending == "stl" && facets < triangles && facets > 4;
                if cut {
                    let what = format!("the format has triangles only: {facets} facets cut into {triangles}");
                    notes.push(format!("note: {out}: {what}"));
                }
                assert_eq!(run.stderr.lines().collect::<Vec<_>>(), notes, "{case}");
                run.json();
                // What was written is read, and is what was converted.
                let filed = crate::run(&["info", &out, "--json"]).json()["filed"].clone();
                let facets = if cut { triangles } else { facets };
                assert_eq!(filed, serde_json::json!({"vertices": vertices, "facets": facets}), "{case}");
                fs::remove_file(&out).unwrap();
            }
        }
    }
}

const JOINED: &str = "coplanar facets and collinear edges joined: 6 facets and 5 vertices became 4 and 4";
const NOT_PLANAR: &str = "FILE:12: the facet is not planar: vertex 7 (line 10) lies 0.894427 off the plane of its \
                          first corners; the square of this distance is 4/5; --triangulate cuts it into triangles";
const NO_FLOAT: &str = "vertex 1 has a coordinate beyond the largest float; write OFF or star with exact \
                        coordinates, or scale down";
const NO_FACETS: &str =
    "STL has facets only, and there is none of three vertices; write OFF, OBJ, PLY or star";

#[test]
fn the_huge_cube_is_exact() {
    let folder = Folder::new("huge_cube");
    let [file, cube, out] =
        [model("invalid/huge_exponent.off"), model("convex/cube.off"), folder.path("out.off")];
    let object = run(&["sum", &file, &cube, "-o", &out, "--json"]).json();
    assert_eq!(object["bounds"]["min"][0], "-1");
    assert_eq!(object["bounds"]["max"][2], format!("1{}1", "0".repeat(307)));
    // A float has room for it too, and the rounding is known.
    let object = run(&["convert", &out, "-o", &out, "--json", "--float"]).json();
    assert_eq!(object["width_bits"], 1024);
    let message = run(&["convert", &out, "-o", &out, "--scale", "10", "--float"]).error(1);
    assert!(message.contains("beyond the largest float"), "{message}");
}

/// The square of a tiny or huge deviation lies outside of the range of floats.
#[test]
fn deviations_of_any_size_are_told() {
    let folder = Folder::new("deviations");
    let (cube, out) = (model("convex/cube.off"), folder.path("out.off"));
    for (size, deviation, off, inside) in [
        ("3", "0.75", "0.727607", "0.75"),
        ("1", "1e-300", "1e-300", "1e-300"),
        ("1", "1.2e-345", "about 1.2e-345", "about 1.2e-345"),
        ("3e300", "7.5e299", "7.27607e299", "7.5e299"),
        ("3e390", "7.5e389", "about 7.3e389", "about 7.5e389"),
    ] {
        let base = format!("0 0 0\n{size} 0 0\n{size} {size} 0\n0 {size}");
        let sides = "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
        let lifted = format!("OFF\n5 5 0\n{base} {deviation}\n0 0 {size}\n4 3 2 1 0\n{sides}");
        let message = run(&["sum", &folder.write("lifted.off", &lifted), &cube, "-o", &out]).error(1);
        assert!(message.contains(&format!(" lies {off} off the plane")), "{message}");
        let dent = format!(
            "OFF\n6 8 0\n{base} 0\n0 0 {size}\n{deviation} {deviation} {deviation}\n3 1 0 5\n3 2 1 5\n3 3 2 5\n3 0 3 5\n{sides}"
        );
        let run = run(&["sum", "--hull", &folder.write("dent.off", &dent), &cube, "-o", &out]);
        let notes = run.notes().join("\n");
        assert!(notes.ends_with(&format!("lie at most {inside} inside it")), "{notes}");
        run.ok();
    }
}

#[test]
fn a_hull_of_too_many_sums_is_refused() {
    let folder = Folder::new("too_many_sums");
    let out = folder.path("out.off");
    // Corners of a convex polygon, as many as the root of the limit.
    let points: String = (0..16_384_u32).map(|i| format!("{i} {} 0\n", i * i)).collect();
    let parabola = folder.write("parabola.off", &format!("OFF\n16384 0 0\n{points}"));
    let cube = model("convex/cube.off");
    for operands in [&[&parabola, &parabola][..], &[&parabola, &cube, &parabola]] {
        let mut words = vec!["sum", "-q", "--method", "hull", "-o", &out];
        words.extend(operands.iter().map(|operand| operand.as_str()));
        assert_eq!(
            run(&words).error(1),
            format!(
                "error: {parabola}: its 16384 vertices times the 16384 of {parabola} are too many points for a convex \
                 hull, which takes fewer than 268435456; use --method overlay, the default"
            )
        );
    }
    assert_eq!(folder.names(), ["parabola.off"]);
}

/// A file cannot ask for memory by what it promises.
#[cfg(target_os = "linux")]
#[test]
fn promises_allocate_nothing() {
    let folder = Folder::new("promises");
    for name in ["huge_counts.off", "exponent_bomb.off"] {
        let mut command = std::process::Command::new("sh");
        command.args(["-c", "ulimit -v 200000; exec \"$@\"", "sh"]).arg(program().get_program());
        command.args(["hull", &model(&format!("invalid/{name}")), "-o", &folder.path("out.off")]);
        let message = finish(command, b"").error(1);
        assert!(message.contains(name), "{message}");
    }
}
