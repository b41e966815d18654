//! Files that are refused, and what is said of them.

use super::read;
use splitstar_formats::{Place, read_curves};

/// A text, the line at fault, and what is said.
type Row = (&'static str, u32, &'static str);

const KEYWORD: &str = "where `segment`, `ray`, `line`, `polyline`, `point`, a geometry of WKT or a GeoJSON object was expected; correct it";

const LINES: &[Row] = &[
    (
        "\nsegment 0 0 1",
        2,
        "the line ends where a segment of two points (`segment x1 y1 x2 y2`) was expected; complete it",
    ),
    (
        "ray\n0 0 1 1",
        1,
        "the line ends where a ray of two points (`ray x1 y1 x2 y2`) was expected; complete it",
    ),
    ("segment 0 0 1 1 2", 1, "`2` where the end of the line was expected; correct it"),
    ("point 1, 2", 1, "`,` between coordinates; write a blank instead"),
    ("segment 0 0 1 1, 2", 1, "`,` where the end of the line was expected; correct it"),
    ("polyline 0,0 1,1", 1, "`,` between coordinates; write a blank instead"),
    ("polyline 0 0; 1 1", 1, "`;` between coordinates; write a blank instead"),
    ("ray 0 0 1 1\npolyline 0 0 1 1, 2 2", 2, "`,` between coordinates; write a blank instead"),
    (
        "star 1 arrangement\nsurface plane\nface 0\nend",
        1,
        "this is an arrangement (star), not a file of curves; give the curves of which it was made; `splitstar locate` asks it about points",
    ),
    (
        "star 1 complex\nend",
        1,
        "this is a model (star), not a file of curves; give curves as text, WKT or GeoJSON",
    ),
    ("point 1 1/0", 1, "`1/0` has the denominator zero; write a fraction p/q with q not zero"),
    ("point nan 1", 1, "`nan` is not finite; write a finite number"),
    ("point 1e401 1", 1, "the exponent of `1e401` is too large in magnitude; the largest allowed is 400"),
    (
        "line 1 2 1 2.0",
        1,
        "both points of the line are the same, so that it has no direction; give two different points",
    ),
    (
        "ray 1 2 1 2",
        1,
        "both points of the ray are the same, so that it has no direction; give two different points",
    ),
    (
        "segment 1 2 1 2",
        1,
        "both ends of the segment are the same point; move one of them, or write `point x y`",
    ),
    (
        "polyline 1 2",
        1,
        "the line ends where a polyline of two points or more (`polyline x1 y1 x2 y2 ...`) was expected; complete it",
    ),
    (
        "polyline 1 2 3 4 5",
        1,
        "the line ends where the second coordinate of the last point was expected; complete it",
    ),
    ("period 1 0", 1, "`0` where a period larger than 0 was expected; correct it"),
    ("period 1", 1, "the line ends where a pair of periods (`period P Q`) was expected; complete it"),
    (
        "point 0 0\nperiod 1 1",
        2,
        "`period` behind another record; make it the first one, and the only `period`",
    ),
    (
        "period 1 1\nray 0 0 1 1",
        2,
        "a ray on a torus cannot be read; it has no end there: give a segment, or remove `period`",
    ),
    ("[1, 2]", 1, "`[` where a GeoJSON object, which begins with `{`, was expected; correct it"),
    ("<svg/>", 1, "XML (SVG, GML, KML) cannot be read; give curves as text, WKT or GeoJSON"),
    ("OFF\n0 0 0", 1, "this is a model (OFF), not a file of curves; give curves as text, WKT or GeoJSON"),
    (
        "circle 0 0 1",
        1,
        "`circle` in a file of the plane cannot be read; it is a curve of the sphere: arrange it with `--surface sphere`",
    ),
    (
        "point 0 0\nArc 1 0 0  0 1 0",
        2,
        "`Arc` in a file of the plane cannot be read; it is a curve of the sphere: arrange it with `--surface sphere`",
    ),
    (
        "circle (0 0, 1 1)",
        1,
        "a geometry `circle` cannot be read; give `segment`, `ray`, `line`, `polyline` or `point`, or a POINT, LINESTRING or POLYGON of WKT",
    ),
];

const WKT: &[Row] = &[
    ("POINT", 1, "the line ends where a point of two coordinates (`point x y`) was expected; complete it"),
    ("POINT Z\n(1 2 3)", 1, "the line ends where `(` or `EMPTY` was expected; complete it"),
    ("LINESTRING 1 2", 1, "`1` where `(` or `EMPTY` was expected; correct it"),
    ("LINESTRING (1 2\n, 3 4\n\n", 3, "the file ends where `,` or `)` was expected; complete it"),
    ("LINESTRING (1 2)", 1, "a polyline of one point; give it a second one, or make it a point"),
    ("LINESTRING ()", 1, "`)` where a coordinate was expected; correct it"),
    ("POINT (1 2) POINT (3 4)", 1, "`POINT` where the end of the line was expected; correct it"),
    ("POINT (1 2 3 4 5)", 1, "`5` where `)` was expected; correct it"),
    ("POINT Z (1 2)", 1, "`)` where a coordinate was expected; correct it"),
    ("POINT M (1 2 3 4)", 1, "`4` where `)` was expected; correct it"),
    ("POINT (1 nan)", 1, "`nan` is not finite; write a finite number"),
    (
        "POLYGON ((0 0, 1 0,\n0 1))",
        1,
        "the ring of a polygon is not closed; repeat its first point at its end",
    ),
    ("POLYGON (0 0, 1 0, 0 1, 0 0)", 1, "`0` where `(` or `EMPTY` was expected; correct it"),
    (
        "CIRCULARSTRING (0 0, 1 1, 2 0)",
        1,
        "a geometry `CIRCULARSTRING` cannot be read; give `segment`, `ray`, `line`, `polyline` or `point`, or a POINT, LINESTRING or POLYGON of WKT",
    ),
    ("GEOMETRYCOLLECTION (\nLINE (1 2))", 2, "`LINE` where a geometry of WKT was expected; correct it"),
    ("SRID=x;POINT(1 2)", 1, "`SRID=x` where `SRID=` and a whole number was expected; correct it"),
    ("SRID=1 POINT(1 2)", 1, "`POINT` where `;` behind the SRID was expected; correct it"),
    ("SRID=1;", 1, "the line ends where a geometry of WKT was expected; complete it"),
];

const GEOJSON: &[Row] = &[
    ("{", 1, "the file ends where a name in quotes or `}` was expected; complete it"),
    ("{}", 1, "a GeoJSON object without the member `type`; add it"),
    (
        "\n{\"type\":\"Topology\",\"objects\":{}}",
        2,
        "an object of type `Topology` cannot be read; give GeoJSON: a geometry, a feature or a collection of features",
    ),
    ("{\"type\":\"Point\"}", 1, "a GeoJSON object without the member `coordinates`; add it"),
    (
        "{\"type\":\"FeatureCollection\",\"features\":[\n{\"type\":\"Point\",\"coordinates\":[1,2]}]}",
        2,
        "`\"Point\"` where a feature was expected; correct it (in feature 0, counted from 0)",
    ),
    (
        "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Feature\",\"geometry\":null}}",
        1,
        "`\"Feature\"` where a geometry was expected; correct it",
    ),
    (
        "{\"type\":\"Feature\",\"geometry\":7}",
        1,
        "`7` where a geometry, which begins with `{`, was expected; correct it",
    ),
    (
        "{\"type\":\"Point\",\"coordinates\":[1]}",
        1,
        "`]` where `,` and a second coordinate was expected; correct it",
    ),
    (
        "{\"type\":\"Point\",\"coordinates\":[\"1\",2]}",
        1,
        "`\"1\"` is no number; write an integer, a decimal or a fraction p/q",
    ),
    ("{\"type\":\"Point\",\"coordinates\":[1,2}", 1, "`}` where `,` or `]` was expected; correct it"),
    ("{\"type\":\"Point\",\"coordinates\":7}", 1, "`7` where `[` with coordinates was expected; correct it"),
    (
        "{\"type\":\"MultiPoint\",\"coordinates\":[[1,2],[]]}",
        1,
        "`]` where a coordinate was expected; correct it",
    ),
    (
        "{\"type\":\"LineString\",\"coordinates\":[[1,2]]}",
        1,
        "a polyline of one point; give it a second one, or make it a point",
    ),
    (
        "{\"type\":\"Point\",\"geometry\":null}",
        1,
        "`\"geometry\"` where a member that fits to the others was expected; correct it",
    ),
    (
        "{\"coordinates\":[1,2],\"coordinates\":[1,2]}",
        1,
        "`\"coordinates\"` where a member that fits to the others was expected; correct it",
    ),
    (
        "{\"features\":[],\n\"type\":\"Feature\"}",
        2,
        "`\"Feature\"` where the type of an object with the member `features` was expected; correct it",
    ),
    ("{\"features\":[]}", 1, "a GeoJSON object without the member `type`; add it"),
    ("{\"type\":\"Point\",\"coordinates\":[[1,2]]}", 1, "`[` where a coordinate was expected; correct it"),
    (
        "{\"type\":\"Point\",\"type\":\"Point\"}",
        1,
        "`\"type\"` where a member that the object does not yet have was expected; correct it",
    ),
    ("{\"a\":1 \"b\":2}", 1, "`\"b\"` where `,` or `}` was expected; correct it"),
    ("{\"a\":1,}", 1, "`}` where a name in quotes was expected; correct it"),
    ("{a:1}", 1, "`a` where a name in quotes was expected; correct it"),
    ("{\"a\" 1}", 1, "`1` where `:` was expected; correct it"),
    ("{\"a\":\"b\n\"}", 1, "`\"b` where a text in quotes was expected; correct it"),
    ("{\"a\":[1 2]}", 1, "`2` where `,` or `]` was expected; correct it"),
    ("{\"a\":[1,]}", 1, "`]` where a value was expected; correct it"),
    ("{\"a\":}", 1, "`}` where a value was expected; correct it"),
    ("{\"a\":[1,\n2", 2, "the file ends where `,` or `]` was expected; complete it"),
    (
        "{\"type\":\"Point\",\"coordinates\":[1,2]} {",
        1,
        "`{` where the end of the line was expected; correct it",
    ),
];

fn message(text: &[u8], file_name: Option<&str>) -> (Option<Place>, String) {
    let error = match read_curves(text, file_name) {
        Ok(file) => panic!("{} gives {:?}", String::from_utf8_lossy(text), file.curves),
        Err(error) => error,
    };
    (error.place, error.sentence())
}

#[test]
fn every_error_has_its_line_and_says_what_to_do() {
    for &(text, line, expected) in [LINES, WKT, GEOJSON].into_iter().flatten() {
        assert_eq!(message(text.as_bytes(), None), (Some(Place::Line(line)), expected.into()), "{text}");
    }
}

#[test]
fn files_of_another_kind_are_named() {
    let at_line = |text: &[u8], name: Option<&str>| message(text, name).1;
    assert_eq!(at_line(b"8 1 2\n", None), format!("`8` {KEYWORD}"));
    assert_eq!(at_line(b"point 1 2\nOFF\n", Some("a.off")), format!("`OFF` {KEYWORD}"));
    let model = |format: &str| {
        format!("this is a model ({format}), not a file of curves; give curves as text, WKT or GeoJSON")
    };
    assert_eq!(at_line(b"8 1 2\n", Some("a.off")), model("OFF"));
    assert_eq!(at_line(b"v 1 2 3\n", None), model("OBJ"));
    for bytes in [&b"\xFF\xFEp\0"[..], b"\xFE\xFF\0p"] {
        assert_eq!(at_line(bytes, None), "a text in UTF-16 cannot be read; write it in UTF-8");
    }
    // What is right is read whatever its name.
    assert!(read_curves(b"point 1 2\n", Some("a.off")).is_ok());
}

#[test]
fn nesting_is_limited() {
    let nested = |open: &str, inside: &str, close: &str, depth: usize| {
        [&open.repeat(depth), inside, &close.repeat(depth)].concat()
    };
    let wkt = |depth| nested("GEOMETRYCOLLECTION(", "POINT(1 2)", ")", depth);
    assert_eq!(read(&wkt(64)).curves.len(), 1);
    let refused = |text: &str| message(text.as_bytes(), None).1;
    assert_eq!(refused(&wkt(65)), "collections nested more than 64 deep cannot be read; nest them less");
    assert!(refused(&wkt(100_000)).starts_with("collections nested"));
    let open = "{\"geometries\":[";
    let close = "],\"type\":\"GeometryCollection\"}";
    let point = "{\"coordinates\":[1,2],\"type\":\"Point\"}";
    let json = |depth| nested(open, point, close, depth);
    assert_eq!(read(&json(31)).curves.len(), 1);
    let too_deep = "brackets nested more than 64 deep cannot be read; nest them less";
    assert_eq!(refused(&json(32)), too_deep);
    assert_eq!(refused(&nested("{\"a\":", "", "}", 100_000)), too_deep);
    assert_eq!(refused(&format!("{{\"a\":{}", "[".repeat(100_000))), too_deep);
    let ahead = |depth| nested("{\"type\":\"GeometryCollection\",\"geometries\":[", point, "]}", depth);
    assert_eq!(read(&ahead(31)).curves.len(), 1);
    assert_eq!(refused(&ahead(100_000)), too_deep);
}
