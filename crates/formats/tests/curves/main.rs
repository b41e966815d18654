//! Files of curves: what is read from each grammar, what is refused, and that curves come back.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod bad;
mod features;
mod page;
mod points;
mod random;
mod sphere;

use splitstar_formats::{CurveFile, CurvePoint, InputCurve, Place, read_curves, write_curves};
use splitstar_formats::{PlaceList, write_periodic_curves};

fn read(text: &str) -> CurveFile {
    read_curves(text.as_bytes(), None).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The curves as they are written, one a line, without the last line break.
fn shown(file: &CurveFile) -> String {
    let text = String::from_utf8(write_curves(&file.curves)).unwrap();
    text.trim_end().to_string()
}

fn notes(file: &CurveFile) -> Vec<String> {
    file.notes.iter().map(ToString::to_string).collect()
}

fn lines(file: &CurveFile) -> Vec<u32> {
    let PlaceList::Lines(lines) = &file.places else { panic!("curves are in a text") };
    lines.clone()
}

struct Row {
    name: &'static str,
    text: &'static str,
    curves: &'static str,
    notes: &'static [&'static str],
}

const fn row(name: &'static str, text: &'static str, curves: &'static str) -> Row {
    Row { name, text, curves, notes: &[] }
}

const fn noted(
    name: &'static str,
    text: &'static str,
    curves: &'static str,
    notes: &'static [&'static str],
) -> Row {
    Row { name, text, curves, notes }
}

const DROPPED_1: &str = "1 point has more than two coordinates: the others are left out";
const DROPPED_2: &str = "2 points have more than two coordinates: the others are left out";
const REPEATED_1: &str = "1 point of a polyline is the same as the one before it: left out";
const COLLAPSED: &str = "1 polyline has only one point, several times: it is read as a point";
const EMPTY_1: &str = "1 geometry is empty: it has no curve";
const EMPTY_2: &str = "2 geometries are empty: they have no curve";
const NO_CURVES: &str = "the file has no curve";

const LINES: &[Row] = &[
    row("segment", "segment 0 0 1 2\n", "segment 0 0 1 2"),
    row("ray", "ray 0 0 1 2", "ray 0 0 1 2"),
    row("line", "line 0 0 1 2\r\n", "line 0 0 1 2"),
    row("point", "point 1 2\r", "point 1 2"),
    row("polyline", "polyline 0 0 1 0 1 1 0 0", "polyline 0 0 1 0 1 1 0 0"),
    row("blanks and comments", "\n # a\n\tsegment\t0 0  1\x0B2 # b\r\n\r\n#", "segment 0 0 1 2"),
    row("byte order mark", "\u{FEFF}point 1 2", "point 1 2"),
    row("capitals", "Segment 0 0 1 2\nPOINT 1 2\n", "segment 0 0 1 2\npoint 1 2"),
    row(
        "numbers",
        "segment .1 -5. 1e-3 +2/4\npoint 0.10 -0\npoint 123456789012345678901234567890 1E2",
        "segment 1/10 -5 1/1000 1/2\npoint 1/10 0\npoint 123456789012345678901234567890 100",
    ),
    noted("repeated points", "polyline 0 0 0/7 0 1 1.0", "polyline 0 0 1 1", &[REPEATED_1]),
    row("a point again, but not in a row", "polyline 0 0 1 1 0 0", "polyline 0 0 1 1 0 0"),
    noted("collapsed", "polyline 1 2 1 2 1 2", "point 1 2", &[COLLAPSED]),
    noted("nothing", "", "", &[NO_CURVES]),
    noted("comments only", "\u{FEFF}# nothing\n\n", "", &[NO_CURVES]),
];

const WKT: &[Row] = &[
    row("point", "POINT (1 2)\npoint(3 4)\nPoint(5 6)", "point 1 2\npoint 3 4\npoint 5 6"),
    row("line string", "LINESTRING(0 0,1 0.5 , 1/3 1)", "polyline 0 0 1 1/2 1/3 1"),
    row("linear ring", "LinearRing (0 0, 1 0, 1 1, 0 0)", "polyline 0 0 1 0 1 1 0 0"),
    row(
        "polygon with a hole",
        "POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1.0 1))",
        "polyline 0 0 9 0 0 9 0 0\npolyline 1 1 2 1 1 2 1 1",
    ),
    row("triangle", "TRIANGLE((0 0,1 0,0 1,0 0))", "polyline 0 0 1 0 0 1 0 0"),
    row("points", "MULTIPOINT (1 2, (3 4), 5 6)", "point 1 2\npoint 3 4\npoint 5 6"),
    row("line strings", "multilinestring((0 0,1 1),(2 2,3 3))", "polyline 0 0 1 1\npolyline 2 2 3 3"),
    row(
        "polygons",
        "MULTIPOLYGON(((0 0,1 0,0 1,0 0)),((5 5,6 5,5 6,5 5),(5 5,6 5,5 6,5 5)))",
        "polyline 0 0 1 0 0 1 0 0\npolyline 5 5 6 5 5 6 5 5\npolyline 5 5 6 5 5 6 5 5",
    ),
    row(
        "collection on several lines",
        "GEOMETRYCOLLECTION(POINT(1 2), # a\nGEOMETRYCOLLECTION\n(LINESTRING(0 0,\n1 1))\n) # b\npoint 0 0",
        "point 1 2\npolyline 0 0 1 1\npoint 0 0",
    ),
    row("SRID", "SRID=4326;POINT(1 2)\nsrid=0 ; point (3 4)", "point 1 2\npoint 3 4"),
    noted("Z", "POINT Z (1 2 3)\nPOINTZ(1 2 nan)", "point 1 2\npoint 1 2", &[DROPPED_2]),
    noted("M, ZM", "linestringM(1 2 3, 2 2 3)", "polyline 1 2 2 2", &[DROPPED_2]),
    noted("ZM", "point zm(1 2 3 4)", "point 1 2", &[DROPPED_1]),
    noted(
        "Z that is not said",
        "MULTIPOINT((1 2 3), 4 5, 6 7 8 9)",
        "point 1 2\npoint 4 5\npoint 6 7",
        &[DROPPED_2],
    ),
    noted("empty", "POINT EMPTY\nLINESTRING Z EMPTY", "", &[EMPTY_2, NO_CURVES]),
    noted("empty part", "MULTIPOLYGON(EMPTY,((0 0,1 0,0 1,0 0)))", "polyline 0 0 1 0 0 1 0 0", &[EMPTY_1]),
    noted("empty member", "GEOMETRYCOLLECTION(POINT EMPTY,POINT(1 2))", "point 1 2", &[EMPTY_1]),
    noted("empty point", "MULTIPOINT(EMPTY,(1 2))", "point 1 2", &[EMPTY_1]),
    noted("collapsed", "LINESTRING (1 1, 1 1)", "point 1 1", &[COLLAPSED]),
    noted("collapsed ring", "POLYGON ((1 1, 1 1, 1 1, 1 1))", "point 1 1", &[COLLAPSED]),
];

const GEOJSON: &[Row] = &[
    row("point", r#"{"type":"Point","coordinates":[0.1,1e2]}"#, "point 1/10 100"),
    row("coordinates first", r#"{"coordinates":[0.1,2],"type":"Point"} # a"#, "point 1/10 2"),
    row("points", r#"{"type":"MultiPoint","coordinates":[[1,2],[3,4]]}"#, "point 1 2\npoint 3 4"),
    row("line", r#"{"type":"LineString","coordinates":[[0,0],[1,1],[2,0]]}"#, "polyline 0 0 1 1 2 0"),
    row(
        "lines",
        r#"{"coordinates":[[[0,0],[1,1]],[[2,2],[3,3]]],"type":"MultiLineString"}"#,
        "polyline 0 0 1 1\npolyline 2 2 3 3",
    ),
    row(
        "polygons",
        r#"{"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[0,1],[0,0]]],[[[5,5],[6,5],[5,6],[5,5]]]]}"#,
        "polyline 0 0 1 0 0 1 0 0\npolyline 5 5 6 5 5 6 5 5",
    ),
    row(
        "feature",
        r#"{"type":"Feature","id":7,"bbox":[0,0,1,1],"geometry":{"type":"Point","coordinates":[1,2]},
            "properties":{"a":[{},[],null,true,-1.5e3,"} # \" {"],"type":"x","features":3},"foreign":null}"#,
        "point 1 2",
    ),
    row(
        "collection of features, names sorted",
        r#"{"crs":{"type":"name","properties":{"name":"urn"}},"features":[
            {"geometry":{"geometries":[{"coordinates":[1,2],"type":"Point"},
                {"type":"LineString","coordinates":[[0,0],[1,1]]}],"type":"GeometryCollection"},
             "properties":null,"type":"Feature"},
            {"geometry":{"coordinates":[[[0,0],[1,0],[0,1],[0,0]]],"type":"Polygon"},"type":"Feature"}],
            "type":"FeatureCollection"}"#,
        "point 1 2\npolyline 0 0 1 1\npolyline 0 0 1 0 0 1 0 0",
    ),
    row(
        "one a line, among others",
        "point 0 0\n{\"type\":\"Point\",\"coordinates\":[1,2]}\n\n{\"type\":\"Point\",\"coordinates\":[3,4]} # a\n\
         POINT(5 6)",
        "point 0 0\npoint 1 2\npoint 3 4\npoint 5 6",
    ),
    noted(
        "altitudes",
        r#"{"type":"LineString","coordinates":[[0,0,5],[1,1,6,7,8]]}"#,
        "polyline 0 0 1 1",
        &[DROPPED_2],
    ),
    noted(
        "repeated",
        r#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[1.0,0],[0,1],[0,0]]]}"#,
        "polyline 0 0 1 0 0 1 0 0",
        &[REPEATED_1],
    ),
    noted(
        "no geometry",
        r#"{"type":"Feature","geometry":null,"properties":null}"#,
        "",
        &[EMPTY_1, NO_CURVES],
    ),
    noted("no coordinates", r#"{"type":"Point","coordinates":[]}"#, "", &[EMPTY_1, NO_CURVES]),
    noted("no ring", r#"{"type":"Polygon","coordinates":[]}"#, "", &[EMPTY_1, NO_CURVES]),
    noted("no feature", r#"{"type":"FeatureCollection","features":[]}"#, "", &[EMPTY_1, NO_CURVES]),
    noted(
        "one line of two",
        r#"{"type":"MultiLineString","coordinates":[[],[[2,2],[3,3]]]}"#,
        "polyline 2 2 3 3",
        &[EMPTY_1],
    ),
];

#[test]
fn every_grammar_is_read_and_comes_back() {
    for row in [LINES, WKT, GEOJSON].into_iter().flatten() {
        let name = row.name;
        let file = read(row.text);
        assert_eq!(shown(&file), row.curves, "{name}");
        assert_eq!(notes(&file), row.notes, "{name}");
        assert_eq!(lines(&file).len(), file.curves.len(), "{name}");
        assert_eq!(file.period, None, "{name}");
        assert_eq!(read(&shown(&file)).curves, file.curves, "{name}");
    }
}

#[test]
fn curves_are_what_they_say() {
    let at = |x: i64, y: i64| CurvePoint::from_i64([x, y]);
    let file = read("segment 0 1 2 3\nray 0 1 2 3\nline 0 1 2 3\npolyline 0 1 2 3\npoint 0 1");
    let ends = || [at(0, 1), at(2, 3)];
    let curves = [
        InputCurve::Segment(ends()),
        InputCurve::Ray(ends()),
        InputCurve::Line(ends()),
        InputCurve::Polyline(ends().into()),
        InputCurve::Point(at(0, 1)),
    ];
    assert_eq!(file.curves, curves);
}

#[test]
fn curves_know_their_lines() {
    let text = "# a\nsegment 0 0 1 1\n\nMULTIPOINT (1 2, 3 4,\n5 6\n)\r\n\
        {\"type\": \"MultiLineString\", \"coordinates\": [\n  [\n    [0, 0],\r    [1, 1]], [[2, 2], [3, 3]]\n]}\npoint 0 0";
    let file = read(text);
    assert_eq!(lines(&file), [2, 4, 4, 5, 9, 10, 12]);
    assert_eq!(file.places.get(1), Some(Place::Line(4)));
}

#[test]
fn periods_make_a_torus() {
    let file = read("# a torus\nperiod 3 5/2\nsegment 0 0 3 0\nPOINT (1 1)\n");
    assert_eq!(file.period, Some(["3".parse().unwrap(), "5/2".parse().unwrap()]));
    assert_eq!(shown(&file), "segment 0 0 3 0\npoint 1 1");
    let text = write_periodic_curves(file.period.as_ref().unwrap(), &file.curves);
    assert_eq!(String::from_utf8(text).unwrap(), "period 3 5/2\nsegment 0 0 3 0\npoint 1 1\n");
}
