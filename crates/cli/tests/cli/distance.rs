//! `splitstar distance`: relations, distances, depths, paths, messages.

use crate::{Folder, model, program, run, run_with};
use serde_json::{Value, json};
use std::process::Stdio;

/// The cube from -1 to 1 (`cube.off`) and another, moved, with what is said.
struct Row {
    words: &'static [&'static str],
    relation: &'static str,
    squared_distance: &'static str,
    penetration_squared: Value,
    along: Value,
}

fn rows() -> Vec<Row> {
    let row = |words, relation, squared_distance, penetration_squared, along| Row {
        words,
        relation,
        squared_distance,
        penetration_squared,
        along,
    };
    vec![
        row(&[], "overlapping", "0", json!("4"), Value::Null),
        row(&["--along", "0,0,1/2"], "overlapping", "0", json!("4"), json!("4")),
        row(&["--move-b", "0.5,0,0", "--along", "-3,0,0"], "overlapping", "0", json!("9/4"), json!("5/6")),
        row(&["--move-b", "2,2,2"], "touching", "0", Value::Null, Value::Null),
        row(&["--move-b", "2,1,0", "--along", "1,0,0"], "touching", "0", Value::Null, json!("0")),
        row(&["--move-b", "-3,1/2,0"], "disjoint", "1", Value::Null, Value::Null),
        row(&["--move-b", "3,3,3", "--along", "1,1,1"], "disjoint", "3", Value::Null, json!("0")),
        // The turn by 45 degrees has no rational quaternion; this one has the tangent 3/4.
        row(&["--quat-b", "3,0,0,1", "--move-b", "2.4,0,0"], "touching", "0", Value::Null, Value::Null),
        row(&["--quat-b", "3,0,0,1", "--move-b", "12/5,0,7/2"], "disjoint", "9/4", Value::Null, Value::Null),
        row(&["--quat-b", "3,0,0,1", "--along", "2,0,0"], "overlapping", "0", json!("4"), json!("6/5")),
        row(&["--quat-b", "-7,0,0,0", "--move-b", "2,2,2"], "touching", "0", Value::Null, Value::Null),
    ]
}

#[test]
fn answers_are_exact() {
    let cube = model("convex/cube.off");
    for row in rows() {
        let object = run(&[&["distance", &cube, &cube, "--json"], row.words].concat()).json();
        let mut keys: Vec<&str> = object.as_object().unwrap().keys().map(String::as_str).collect();
        keys.sort_unstable();
        assert_eq!(
            keys,
            [
                "along",
                "closest",
                "direction",
                "penetration_squared",
                "relation",
                "squared_distance",
                "witness"
            ]
        );
        let Row { words, relation, squared_distance, penetration_squared, along } = row;
        assert_eq!(object["relation"], relation, "{words:?}");
        assert_eq!(object["squared_distance"], squared_distance, "{words:?}");
        assert_eq!(object["penetration_squared"], penetration_squared, "{words:?}");
        assert_eq!(object["along"], along, "{words:?}");
        assert_eq!(object["direction"].is_null(), relation != "overlapping", "{words:?}");
        for side in ["a", "b"] {
            assert_eq!(object["closest"][side].as_array().map(Vec::len), Some(3), "{words:?}");
            assert!(object["witness"][side].is_object(), "{words:?}");
        }
        assert_eq!(object["closest"]["a"] == object["closest"]["b"], relation != "disjoint", "{words:?}");
    }
}

#[test]
fn closest_points_and_features_are_named() {
    let folder = Folder::new("distance_witness");
    // The vertices of the second count from 1, and one of them is on no facet.
    let flat = folder.write("flat.off", "OFF\n3 1 3\n0 0 0\n4 0 0\n0 4 0\n3 0 1 2\n");
    let upright = folder.write("upright.obj", "v 9 9 9\nv 1 1 2\nv 1 1 7\nv 2 1 2\nf 2 3 4\n");
    let sorted = |feature: &Value, kind: &str| {
        let vertices = feature[kind].as_array().unwrap_or_else(|| panic!("no {kind}: {feature}"));
        let mut vertices: Vec<u64> = vertices.iter().map(|v| v.as_u64().unwrap()).collect();
        vertices.sort_unstable();
        vertices
    };
    let object = run(&["distance", &flat, &upright, "--json", "-q"]).json();
    assert_eq!(object["squared_distance"], "4");
    // Of all points at this distance, the first in lexicographic order.
    assert_eq!(object["closest"], json!({"a": ["1", "1", "0"], "b": ["1", "1", "2"]}));
    assert_eq!(sorted(&object["witness"]["a"], "facet"), [0, 1, 2]);
    assert_eq!(sorted(&object["witness"]["b"], "edge"), [2, 4]);
    let object = run(&["distance", &upright, &flat, "--json", "--move-b", "2,2,5"]).json();
    assert_eq!(object["squared_distance"], "35/26");
    assert_eq!(sorted(&object["witness"]["a"], "edge"), [3, 4]);
    assert_eq!(object["witness"]["b"], json!({"vertex": [0]}));
}

#[test]
fn the_table_is_for_reading() {
    let cube = model("convex/cube.off");
    let table = run(&["distance", &cube, &cube, "--move-b", "3,3,1", "--along", "0,1,0"]).ok();
    let rows: Vec<[&str; 2]> =
        table.lines().map(|line| [line[..20].trim_end(), line[20..].trim_start()]).collect();
    let names: Vec<&str> = rows.iter().map(|row| row[0]).collect();
    assert_eq!(
        names,
        [
            "relation",
            "distance",
            "squared distance",
            "along",
            "closest a",
            "closest b",
            "witness a",
            "witness b"
        ]
    );
    let values: Vec<&str> = rows.iter().map(|row| row[1]).collect();
    assert_eq!(values[..6], ["disjoint", "1.41421", "2", "0", "1 1 0", "2 2 0"]);
    assert!(values[6].starts_with("edge ") && values[7].starts_with("edge "), "{table}");
    let table = run(&["distance", &cube, &cube, "--move-b", "1/2,0,0"]).ok();
    assert!(table.starts_with("relation             overlapping\npenetration          1.5\npenetration squared  9/4\ndirection            1 0 0\n"), "{table}");
}

const PATH: &str =
    "# a cube passes another\n3 0 0\n2 0 0 # contact\n\n1 1/2 0\n1 0.5 0 3 0 0 1\n-5 0 0  1 0 0 1\n-5 0 0\n";

#[test]
fn a_path_has_a_line_for_each_placement() {
    let folder = Folder::new("distance_path");
    let (cube, path) = (model("convex/cube.off"), folder.write("path.txt", PATH));
    let found = run(&["distance", &cube, &cube, "--path", &path]);
    assert_eq!(found.stderr, "");
    let lines = found.ok();
    assert_eq!(lines.lines().count(), 6);
    let expected = "disjoint 1\ntouching 0\noverlapping 1\n";
    assert!(lines.starts_with(expected), "{lines}");
    assert!(lines.ends_with("disjoint 9\ndisjoint 9\n"), "{lines}");
    let along = run_with(&["distance", &cube, &cube, "--path", "-", "--along=1,0,0"], PATH.as_bytes()).ok();
    assert!(along.starts_with("disjoint 1 0\ntouching 0 0\noverlapping 1 1\n"), "{along}");
    // Each line is what a single command says.
    let objects = run(&["distance", &cube, &cube, "--path", &path, "--json"]).ok();
    let single: [&[&str]; 6] = [
        &["--move-b", "3,0,0"],
        &["--move-b", "2,0,0"],
        &["--move-b", "1,1/2,0"],
        &["--move-b", "1,1/2,0", "--quat-b", "3,0,0,1"],
        &["--move-b", "-5,0,0", "--quat-b", "1,0,0,1"],
        &["--move-b", "-5,0,0"],
    ];
    for (line, words) in objects.lines().zip(single) {
        let [found, expected]: [Value; 2] = [
            serde_json::from_str(line).unwrap(),
            run(&[&["distance", &cube, &cube, "--json"], words].concat()).json(),
        ];
        for key in ["relation", "squared_distance", "penetration_squared", "along"] {
            assert_eq!(found[key], expected[key], "{words:?}");
        }
        if found["relation"] != "overlapping" {
            assert_eq!(found, expected, "{words:?}");
        }
    }
    let empty = folder.write("empty.txt", "# nothing\n");
    let found = run(&["distance", &cube, &cube, "--path", &empty]);
    assert_eq!(found.stderr, format!("note: {empty}: the file has no placement\n"));
    assert_eq!(found.ok(), "");
}

#[test]
fn polytopes_of_every_dimension_are_taken() {
    let folder = Folder::new("distance_dimensions");
    let cube = model("convex/cube.off");
    let point = folder.write("point.off", "OFF\n1 0 0\n1 1 1\n");
    let segment = folder.write("segment.off", "OFF\n2 1 0\n0 0 0\n4 0 0\n2 0 1\n");
    let square = folder.write("square.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    let relation = |words: &[&str]| {
        let object = run(&[&["distance", "--json"], words].concat()).json();
        let squared = match object["penetration_squared"].as_str() {
            Some(squared) => squared.to_owned(),
            None => object["squared_distance"].as_str().unwrap().to_owned(),
        };
        format!("{} {squared}", object["relation"].as_str().unwrap())
    };
    assert_eq!(relation(&[&cube, &point]), "touching 0");
    assert_eq!(relation(&[&cube, &point, "--move-b", "-1,-1,-1"]), "overlapping 1");
    assert_eq!(relation(&[&point, &cube, "--move-b", "3,3,3"]), "disjoint 3");
    assert_eq!(relation(&[&cube, &segment]), "overlapping 1");
    assert_eq!(relation(&[&square, &segment]), "touching 0");
    assert_eq!(relation(&[&square, &square]), "touching 0");
    assert_eq!(relation(&[&square, &square, "--move-b", "0,0,1/3"]), "disjoint 1/9");
    assert_eq!(relation(&[&point, &point]), "touching 0");
}

#[test]
fn files_that_are_not_convex_are_refused_or_filled() {
    let (cube, star) = (model("convex/cube.off"), model("nonconvex/star.off"));
    for words in [[&cube, &star], [&star, &cube]] {
        let message = run(&["distance", words[0], words[1]]).error(1);
        assert!(
            message.starts_with(&format!("error: {star}:20: not convex: the edge from vertex 1")),
            "{message}"
        );
        assert!(message.ends_with("--hull takes the convex hull instead"), "{message}");
    }
    let found = run(&["distance", &cube, &star, "--hull", "--move-b", "100,0,0", "--json"]);
    assert!(found.stderr.contains("the convex hull is taken"), "{}", found.stderr);
    assert_eq!(found.json()["relation"], "disjoint");
    let folder = Folder::new("distance_units");
    for (name, unit) in [("mm.star", "millimeter"), ("inch.star", "inch")] {
        run(&["convert", &cube, "-o", &folder.path(name), "--unit", unit]).ok();
    }
    let message = run(&["distance", &folder.path("mm.star"), &folder.path("inch.star")]).error(1);
    assert!(message.contains("its unit is inch, that of "), "{message}");
    let missing = folder.path("missing.off");
    assert_eq!(
        run(&["distance", &cube, &missing]).error(1),
        format!("error: {missing}: no such file; check the name")
    );
}

#[test]
fn wrong_paths_are_named() {
    let folder = Folder::new("distance_bad");
    let cube = model("convex/cube.off");
    for (text, expected) in [
        (
            "1 2\n",
            "1: the line ends where a translation (`x y z`, or `x y z w x y z` with a quaternion) was expected; complete it",
        ),
        (
            "0 0 0\n1 2 3 1 0 0\n",
            "2: the line ends where a quaternion behind the translation (`x y z w x y z`) was expected; complete it",
        ),
        ("1 2 3 0 0 0 0\n", "1: the quaternion is zero; 1 0 0 0 does not rotate"),
        ("1 2 3 1 0 0 0 9\n", "1: `9` where the end of the line was expected; correct it"),
        (
            "\nhere 2 3\n",
            "2: `here` where a translation (`x y z`, or `x y z w x y z` with a quaternion) was expected; correct it",
        ),
    ] {
        let path = folder.write("path.txt", text);
        let message = run(&["distance", &cube, &cube, "--path", &path]).error(1);
        assert_eq!(message, format!("error: {path}:{expected}"));
    }
    let missing = folder.path("none.txt");
    let message = run(&["distance", &cube, &cube, "--path", &missing]).error(1);
    assert_eq!(message, format!("error: {missing}: no such file; check the name"));
}

#[test]
fn a_path_without_end_is_not_read() {
    let cube = model("convex/cube.off");
    let mut command = program();
    command.args(["distance", &cube, &cube, "--path", "-"]);
    command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    // It may stop to read.
    let _ = std::io::Write::write_all(&mut input, "y\n".repeat(1 << 16).as_bytes());
    let output = child.wait_with_output().unwrap();
    drop(input);
    assert_eq!(output.status.code(), Some(1));
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(stderr.starts_with("error: -:1: `y` where a translation"), "{stderr}");
}

#[test]
fn either_operand_may_be_standard_input() {
    let cube = model("convex/cube.off");
    let text = std::fs::read(&cube).unwrap();
    for words in [["distance", "-", &cube], ["distance", &cube, "-"]] {
        let table = run_with(&words, &text).ok();
        assert!(table.starts_with("relation             overlapping\n"), "{table}");
    }
}

#[test]
fn models_with_hundreds_of_features() {
    let [a, b] = ["convex/gs4.off", "convex/rgs4.xoff"].map(model);
    let object = run(&["distance", &a, &b, "--json"]).json();
    assert_eq!((&object["relation"], &object["squared_distance"]), (&json!("overlapping"), &json!("0")));
    let squared = object["penetration_squared"].as_str().unwrap();
    assert!(squared.contains('/'), "{squared}");
    let object = run(&["distance", &a, &b, "--json", "--move-b", "300000,1,1/7"]).json();
    assert_eq!(object["relation"], "disjoint");
}
