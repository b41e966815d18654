//! `splitstar arrange`: pictures, limits, what is packed, and the example of the README.

use crate::{Folder, model, run, run_with};
use splitstar::formats;
use std::collections::BTreeSet;
use std::fs;

/// The picture of some curves.
fn picture(text: &str) -> String {
    run_with(&["arrange", "-", "-q", "-o", "-", "--format", "svg"], text.as_bytes()).ok()
}

fn drawn(picture: &str, cell: char) -> usize {
    picture.matches(&format!("data-id=\"{cell}")).count()
}

#[test]
fn the_example_of_the_readme_is_what_the_program_says() {
    let readme = fs::read_to_string(model("../README.md")).unwrap();
    let example = readme.split("$ splitstar arrange models/curves/plane.txt\n").nth(1).expect("an example");
    let table = example.split("```").next().unwrap();
    assert_eq!(run(&["arrange", &model("curves/plane.txt")]).ok(), table);
}

#[test]
fn vertices_are_drawn_as_they_are_counted() {
    for (text, vertices) in [
        ("polyline 0 0 4 0 4 4 0 4 0 0\n", 1),
        ("polyline 0 0 4 0 4 4 0 4 0 0\nline 2 0 2 1\n", 2),
        ("polyline 0 0 1 2 2 0 3 2\n", 2),
        ("segment 0 0 2 2\nsegment 0 2 2 0\npoint 5 5\n", 6),
        ("period 4 3\nsegment -1/2 1 7/2 1\n", 1),
    ] {
        assert_eq!(drawn(&picture(text), 'v'), vertices, "{text}");
    }
}

#[test]
fn tori_have_coloured_faces_and_edges_on_both_sides() {
    let picture = picture("period 4 3\nsegment 0 0 4 0\nsegment 0 0 0 3\nsegment 0 1 4 1\n");
    // The edge at the bottom twice, the two at the left twice, the one across once.
    assert_eq!(drawn(&picture, 'e'), 7);
    // The corner four times, the vertex above it twice.
    assert_eq!(drawn(&picture, 'v'), 6);
    let faces = picture.split("data-layer=\"faces\"").nth(1).unwrap().split("data-layer").next().unwrap();
    let fills: BTreeSet<&str> =
        faces.split("fill=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    assert_eq!((drawn(&picture, 'f'), fills.len()), (2, 2));
    let places = ["faces", "frame", "edges", "vertices"]
        .map(|layer| picture.find(&format!("data-layer=\"{layer}\"")).unwrap());
    assert!(places.is_sorted(), "{places:?}");
}

#[test]
fn coordinates_too_near_each_other_are_noted() {
    let folder = Folder::new("pictures_far");
    let out = folder.path("out.svg");
    let note = format!("note: {out}: coordinates differ too little for a picture; write star");
    for (text, is_noted) in [
        ("point 1e20 0\npoint 100000000000000000001 0\n", true),
        ("segment 1e20 0 100000000000000000001 1\n", true),
        ("segment 1000000000000 0 1000000000001 1\n", true),
        ("segment 1e6 0 1000001 1\n", false),
        ("point 1e20 0\n", false),
        ("point 0 0\npoint 1e-30 0\n", false),
        ("line 1e20 0 1e20 1\n", false),
        ("# nothing\npoint 0 0\n", false),
    ] {
        let file = folder.write("curves.txt", text);
        let told = run(&["arrange", &file, "-o", &out]);
        assert_eq!(told.notes().contains(&note.as_str()), is_noted, "{text}: {}", told.stderr);
        told.ok();
        let told = run(&["arrange", &file, "-o", &folder.path("out.star")]);
        assert_eq!(told.notes(), [""; 0], "{text}");
    }
}

#[test]
fn turns_around_a_torus_are_limited_over_all_files() {
    let folder = Folder::new("pictures_turns");
    let sentence = "up to here the curves go around the torus more than 131072 times, and are cut there; give \
                    larger periods, or fewer or shorter curves";
    let many = folder.write("many.txt", &format!("period 1 1\n{}", "segment 0 0 1000000 1\n".repeat(5)));
    assert_eq!(run(&["arrange", &many]).error(1), format!("error: {many}:2: {sentence}"));
    let first = folder.write("first.txt", "period 1 1\nsegment 0 0 131071 1/2\n");
    let second = folder.write("second.txt", "point 1 1\npolyline 0 0 1/2 0 1/2 2\n");
    assert_eq!(run(&["arrange", &first, &second]).error(1), format!("error: {second}:2: {sentence}"));
    // Numbers that no machine word holds.
    let file = folder.write("far.txt", "period 1e-300 1\nsegment 0 0 1e300 -1e300\n");
    assert_eq!(run(&["arrange", &file]).error(1), format!("error: {file}:2: {sentence}"));
    // What does not go around has no such limit, and what goes around within it is counted.
    let file = folder.write("few.txt", "period 1 1\nsegment 0 0 1000 1\n");
    assert_eq!(run(&["arrange", &file, "--json"]).json()["vertices"], 1);
}

#[test]
fn arrangements_are_packed() {
    let folder = Folder::new("pictures_gzip");
    let file = folder.write("curves.txt", "segment 0 0 2 2\nsegment 0 2 2 0\n");
    for (packed, format, plain) in
        [("a.star.gz", None, "a.star"), ("a.SVG.GZ", None, "a.svg"), ("a", Some("svg.gz"), "a.svg")]
    {
        let (packed, plain) = (folder.path(packed), folder.path(plain));
        run(&["arrange", &file, "-o", &plain]).ok();
        let mut words = vec!["arrange", &file, "-o", &packed];
        words.extend(format.iter().flat_map(|format| ["--format", format]));
        run(&words).ok();
        assert_eq!(fs::read(&packed).unwrap(), formats::pack_gzip(&fs::read(&plain).unwrap()), "{packed}");
    }
    let star = formats::read_arrangement(&fs::read(folder.path("a.star.gz")).unwrap(), None);
    assert_eq!(star.unwrap().counts().vertices, 5);
}

#[test]
fn files_of_curves_are_no_models() {
    let folder = Folder::new("pictures_hint");
    for (name, text) in [
        ("a.txt", "period 1 1\n"),
        ("a.off", "segment 0 0 1 1\n"),
        ("a.wkt", "POINT (1 2)\n"),
        ("a.json", "{\"type\": \"Point\", \"coordinates\": [1, 1]}\n"),
    ] {
        let file = folder.write(name, text);
        let message =
            format!("error: {file}: a file of curves, not a model; `splitstar arrange {file}` reads it");
        assert_eq!(run(&["info", &file]).error(1), message);
        assert_eq!(run(&["convert", &file, "-o", &folder.path("out.off")]).error(1), message);
    }
    let file = folder.write("a.txt", "something else\n");
    assert!(run(&["info", &file]).error(1).contains("no known format"));
}

#[test]
fn notes_are_told_once_for_each_file() {
    let folder = Folder::new("pictures_notes");
    let file = folder.write("a.wkt", "POINT EMPTY\nPOINT (1 1)\n");
    let note = format!("note: {file}: 1 geometry is empty: it has no curve");
    assert_eq!(run(&["arrange", &file, &file]).notes(), [note]);
}
