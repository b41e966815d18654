//! Files of points to be asked about.

use crate::DROPPED_1;
use splitstar_formats::{Place, PlaceList, pack_gzip, read_points};

/// A text, its points, their lines and the notes.
type Row = (&'static str, &'static [&'static str], &'static [u32], &'static [&'static str]);

const ROWS: &[Row] = &[
    ("0 0\n", &["(0, 0)"], &[1], &[]),
    ("  -1 +2 # both\n\n.5\t1/3\r\n1e2 -0.25", &["(-1, 2)", "(1/2, 1/3)", "(100, -1/4)"], &[1, 3, 4], &[]),
    ("point 1 2\nPOINT (3 4)\nPoint 5 6\n", &["(1, 2)", "(3, 4)", "(5, 6)"], &[1, 2, 3], &[]),
    ("MULTIPOINT Z ((1 2 3))\n7 8\n", &["(1, 2)", "(7, 8)"], &[1, 2], &[DROPPED_1]),
    (
        "1 1\n{\"type\": \"MultiPoint\", \"coordinates\":\n [[0.1, 2],\n [0.1, 2]]}\n1 1\n",
        &["(1, 1)", "(1/10, 2)", "(1/10, 2)", "(1, 1)"],
        &[1, 3, 4, 5],
        &[],
    ),
    ("period 4 3\n9 9\n", &["(9, 9)"], &[2], &[]),
    ("", &[], &[], &["the file has no point"]),
    (
        "POINT EMPTY\n",
        &[],
        &[],
        &["1 geometry is empty: it has no point, and gets no answer", "the file has no point"],
    ),
];

#[test]
fn points_are_read() {
    for (text, points, lines, notes) in ROWS {
        let packed = pack_gzip(text.as_bytes());
        for bytes in [text.as_bytes(), &packed] {
            let file = read_points(bytes, None).unwrap_or_else(|error| panic!("{error}\n{text}"));
            let found: Vec<String> = file.points.iter().map(ToString::to_string).collect();
            assert_eq!(found, *points, "{text}");
            let PlaceList::Lines(places) = &file.places else { panic!("points are in a text") };
            assert_eq!(places, lines, "{text}");
            let found: Vec<String> = file.notes.iter().map(ToString::to_string).collect();
            assert_eq!(found, *notes, "{text}");
        }
    }
    let period = read_points(b"period 4 1/3\n", None).unwrap().period.unwrap();
    assert_eq!(period.map(|period| period.to_string()), ["4", "1/3"]);
}

#[test]
fn the_example_of_the_page_is_read() {
    let page = include_str!("../../../../docs/curves.md");
    let (_, example) = page.split_once("```points\n").unwrap();
    let file = read_points(example.split("```").next().unwrap().as_bytes(), None).unwrap();
    assert_eq!((file.points.len(), file.notes.len()), (5, 0));
}

#[test]
fn what_is_no_point_is_refused() {
    let rows: &[(&str, u32, &str)] = &[
        ("0 0\nsegment 0 0 1 1\n", 2, "a segment in a file of points; remove it"),
        ("LINE 0 0 1 1\n", 1, "a line in a file of points"),
        ("ray 0 0 1 1\n", 1, "a ray in a file of points"),
        (
            "POINT (0 0)\nGEOMETRYCOLLECTION (POINT (1 1),\n LINESTRING (0 0, 1 1))\n",
            3,
            "a polyline in a file",
        ),
        ("1\n", 1, "the line ends where a point of two coordinates (`x y`) was expected"),
        ("1 2 3\n", 1, "`3` where the end of the line was expected"),
        ("1 x\n", 1, "`x` is no number"),
        ("0 0\n1.2.3 0\n", 2, "`1.2.3` is no number"),
        ("0 inf\n", 1, "`inf` is not finite"),
        ("1 1/0\n", 1, "`1/0`"),
        ("x 1\n", 1, "`x` where a point as `x y` or `point x y`, a POINT of WKT or a GeoJSON object"),
        ("0 0\nperiod 1 1\n", 2, "`period` behind another record"),
        ("OFF\n", 1, "this is a model (OFF), not a file of points; give points as text, WKT or GeoJSON"),
        (
            "star 1 arrangement\n",
            1,
            "this is an arrangement (star), not a file of points; give the arrangement first, and behind it the points that are asked about",
        ),
        ("star 1 complex\n", 1, "this is a model (star), not a file of points"),
        ("0,0\n", 1, "`,` between coordinates; write a blank instead"),
        ("point 0 0\n1;2\n", 2, "`;` between coordinates; write a blank instead"),
        (
            "arc 1 0 0 0 1 0\n",
            1,
            "`arc` in a file of points of the plane cannot be read; give points as `x y` or `point x y`, or in WKT or GeoJSON",
        ),
    ];
    for (text, line, why) in rows {
        let error = read_points(text.as_bytes(), None).expect_err(text);
        assert_eq!(error.place, Some(Place::Line(*line)), "{text}: {error}");
        assert!(error.sentence().contains(why), "{text}: {error}");
    }
}

#[test]
fn short_lines_are_within_the_budget() {
    let text = "1 2\n".repeat(1_000_000);
    assert_eq!(read_points(text.as_bytes(), None).unwrap().points.len(), 1_000_000);
}
