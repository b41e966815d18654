//! Curves and points on the sphere: what is read, what is refused, and that curves come back.

use crate::{COLLAPSED, DROPPED_1, NO_CURVES, REPEATED_1};
use exact::spherical::geographic::{exact_length, from_degrees};
use exact::spherical::{Direction, GreatCircle};
use exact::{Integer, Rational, Vector3};
use splitstar_formats::{CurveNote, PlaceList, SphereCurve, SphereCurveFile, pack_gzip};
use splitstar_formats::{Place, read_sphere_curves, read_sphere_points, write_sphere_curves};
use testkit::{Rng, mutate};

fn read(text: &str) -> SphereCurveFile {
    read_sphere_curves(text.as_bytes(), None).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn shown(curves: &[SphereCurve]) -> String {
    String::from_utf8(write_sphere_curves(curves)).unwrap().trim_end().to_string()
}

fn at(x: i64, y: i64, z: i64) -> Direction {
    Direction::from_i64([x, y, z]).unwrap()
}

fn place(longitude: &str, latitude: &str) -> Direction {
    from_degrees(&longitude.parse().unwrap(), &latitude.parse().unwrap()).unwrap()
}

/// A text, the curves as they are written, and the notes.
type Row = (&'static str, &'static str, &'static [&'static str]);

const ROWS: &[Row] = &[
    ("arc 1 0 0  0 1 0", "arc 1 0 0 0 1 0", &[]),
    ("Arc 2 0 0  0 -3/2 0.5 # a\r\n", "arc 1 0 0 0 -3 1", &[]),
    ("arc 1 0 0  -2 0 0  via 0 0 5", "arc 1 0 0 -1 0 0 via 0 0 1", &[]),
    ("arc 1 0 0  0 1 0  VIA -1 -1 0", "arc 1 0 0 0 1 0 via -1 -1 0", &[]),
    ("circle 0 0 -1e3", "circle 0 0 -1", &[]),
    ("point 1/2 1/3 0\nPoint -1e-2 0 0.02", "point 3 2 0\npoint -1 0 2", &[]),
    ("polyline 1 0 0  0 1 0  0 0 1  1 0 0", "polyline 1 0 0 0 1 0 0 0 1 1 0 0", &[]),
    ("polyline 1 0 0  3 0 0  0 1 0", "polyline 1 0 0 0 1 0", &[REPEATED_1]),
    ("polyline 1 2 3  2 4 6", "point 1 2 3", &[COLLAPSED]),
    (
        "point 123456789012345678901234567890 0 1\npoint 1e30 1e30 2e30",
        "point 123456789012345678901234567890 0 1\npoint 1 1 2",
        &[],
    ),
    ("# nothing\n", "", &[NO_CURVES]),
    ("POINT (90 0)", "point 0 1 0", &[]),
    ("SRID=4326;LINESTRING (0 0, 90 0, 180 0)", "polyline 1 0 0 0 1 0 -1 0 0", &[]),
    (r#"{"type":"Point","coordinates":[12.5,90.0,8848]}"#, "point 0 0 1", &[DROPPED_1]),
    // The south pole by two names, and back to the beginning by another one.
    (
        r#"{"type":"Polygon","coordinates":[[[0,0],[7,-90],[123.4,-90],[90,0],[360,0]]]}"#,
        "polyline 1 0 0 0 0 -1 0 1 0 1 0 0",
        &[REPEATED_1],
    ),
    // Across the antimeridian: both names of it are one place.
    (
        r#"{"type":"MultiLineString","coordinates":[[[180,0],[-90,0]],[[90,0],[-180,0],[270,0]]]}"#,
        "polyline -1 0 0 0 -1 0\npolyline 0 1 0 -1 0 0 0 -1 0",
        &[],
    ),
    (
        r#"{"type":"FeatureCollection","features":[{"type":"Feature","properties":{"name":"x"},"geometry":
            {"type":"GeometryCollection","geometries":[{"type":"MultiPoint","coordinates":[[0,0],[-90,0]]},
            {"type":"MultiPolygon","coordinates":[[[[0,0],[90,0],[0,90],[0,0]]]]}]}},
            {"type":"Feature","properties":null,"geometry":null}]}"#,
        "point 1 0 0\npoint 0 -1 0\npolyline 1 0 0 0 1 0 0 0 1 1 0 0",
        &["1 geometry is empty: it has no curve (in feature 1, counted from 0)"],
    ),
];

#[test]
fn every_grammar_is_read_and_comes_back() {
    for (text, curves, notes) in ROWS {
        for bytes in [text.as_bytes(), &pack_gzip(text.as_bytes())] {
            let file = read_sphere_curves(bytes, None).unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert_eq!(shown(&file.curves), *curves, "{text}");
            assert_eq!(file.notes.iter().map(CurveNote::to_string).collect::<Vec<_>>(), *notes, "{text}");
            assert_eq!(read(&shown(&file.curves)).curves, file.curves, "{text}");
            let PlaceList::Lines(lines) = &file.places else { panic!("curves are in a text") };
            assert_eq!(lines.len(), file.curves.len(), "{text}");
        }
    }
}

#[test]
fn curves_are_what_they_say() {
    let file =
        read("arc 1 0 0 0 1 0\narc 1 0 0 0 1 0 via 1 1 0\ncircle 1 2 2\npolyline 1 0 0 0 1 0\npoint 4 4 2");
    let ends = || [at(1, 0, 0), at(0, 1, 0)];
    let curves = [
        SphereCurve::Arc(ends()),
        SphereCurve::ArcVia(Box::new([at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)])),
        SphereCurve::Circle(GreatCircle::new(&Vector3::from_i64([1, 2, 2])).unwrap()),
        SphereCurve::Polyline(ends().into()),
        SphereCurve::Point(at(2, 2, 1)),
    ];
    assert_eq!(file.curves, curves);
}

#[test]
fn places_become_points_of_the_unit_sphere() {
    let text = r#"{"type":"LineString","coordinates":[[2.3522,48.8566],[-0.1276,51.5072],[-182.5,-0.0001]]}"#;
    let [SphereCurve::Polyline(points)] = &read(text).curves[..] else { panic!("one polyline") };
    let places = [("2.3522", "48.8566"), ("-0.1276", "51.5072"), ("177.5", "-0.0001")];
    for (point, (longitude, latitude)) in points.iter().zip(places) {
        assert_eq!(*point, place(longitude, latitude));
        assert!(exact_length(point).is_some());
    }
}

/// A text, the line at fault, and what is said.
type Bad = (&'static str, u32, &'static str);

const BAD: &[Bad] = &[
    (
        "arc 1 0 0",
        1,
        "the line ends where an arc of two points (`arc x1 y1 z1 x2 y2 z2`) was expected; complete it",
    ),
    (
        "\narc 1 0 0 0 1",
        2,
        "the line ends where an arc of two points (`arc x1 y1 z1 x2 y2 z2`) was expected; complete it",
    ),
    ("arc 1 0 0 0 1 0 0", 1, "`0` where `via` or the end of the line was expected; correct it"),
    (
        "arc 1 0 0 0 1 0 via 1 1",
        1,
        "the line ends where a point of three coordinates (`via x y z`) was expected; complete it",
    ),
    ("arc 1 0 0 0 1 0 via 1 1 0 0", 1, "`0` where the end of the line was expected; correct it"),
    (
        "arc 0 0 0 0 1 0",
        1,
        "the vector is zero, and so it has no direction; give one coordinate that is not 0",
    ),
    (
        "point 0 0 1\npoint 0 0.0 0/3",
        2,
        "the vector is zero, and so it has no direction; give one coordinate that is not 0",
    ),
    ("circle 0 0 0", 1, "the vector is zero, and so it has no direction; give one coordinate that is not 0"),
    (
        "circle 0 1",
        1,
        "the line ends where a circle of one normal (`circle nx ny nz`) was expected; complete it",
    ),
    ("circle 0 1 0 0", 1, "`0` where the end of the line was expected; correct it"),
    (
        "point 0 1",
        1,
        "the line ends where a point of three coordinates (`point x y z`) was expected; complete it",
    ),
    ("point 0,0,1", 1, "`,` between coordinates; write a blank instead"),
    ("polyline 1 0 0, 0 1 0", 1, "`,` between coordinates; write a blank instead"),
    ("point 0 nan 1", 1, "`nan` is not finite; write a finite number"),
    (
        "arc 1 2 3  2 4 6",
        1,
        "both ends of the arc are the same point; move one of them, or write `point x y z` or `circle nx ny nz`",
    ),
    (
        "arc 1 2 3  2 4 6  via 0 0 1",
        1,
        "both ends of the arc are the same point; move one of them, or write `point x y z` or `circle nx ny nz`",
    ),
    (
        "arc 1 2 3  -2 -4 -6",
        1,
        "the ends of the arc are antipodal, and every arc between them is as short; say through which point it goes: \
         `via x y z`",
    ),
    (
        "arc 1 0 0  0 1 0  via 2 0 0",
        1,
        "the point behind `via` is an end of the arc; give one between the ends",
    ),
    (
        "arc 1 0 0  -1 0 0  via -1 0 0",
        1,
        "the point behind `via` is an end of the arc; give one between the ends",
    ),
    (
        "arc 1 0 0  0 1 0  via 1 1 1/1000000",
        1,
        "the point behind `via` does not lie on the great circle through the ends of the arc; move it there, or leave it out",
    ),
    (
        "polyline 1 0 0",
        1,
        "the line ends where a polyline of two points or more (`polyline x1 y1 z1 x2 y2 z2 ...`) was expected; complete it",
    ),
    (
        "polyline 1 0 0 0 1 0 0 0",
        1,
        "the line ends where all three coordinates of the last point was expected; complete it",
    ),
    (
        "polyline 1 0 0 0 1 0 0 -1 0",
        1,
        "the point is antipodal to the one before it, and every arc between them is as short; give a point between",
    ),
    (
        "segment 0 0 1 1",
        1,
        "`segment` in a file of the sphere cannot be read; give `arc`, `circle`, `polyline` or `point`, or arrange it \
         without `--surface sphere`",
    ),
    (
        "arc 1 0 0 0 1 0\nline 0 0 1 1",
        2,
        "`line` in a file of the sphere cannot be read; give `arc`, `circle`, `polyline` or `point`, or arrange it \
         without `--surface sphere`",
    ),
    (
        "ray 0 0 1 1",
        1,
        "`ray` in a file of the sphere cannot be read; give `arc`, `circle`, `polyline` or `point`, or arrange it \
         without `--surface sphere`",
    ),
    (
        "period 1 1",
        1,
        "`period` in a file of the sphere cannot be read; give `arc`, `circle`, `polyline` or `point`, or arrange it \
         without `--surface sphere`",
    ),
    (
        "CIRCLE (0 0, 1 1)",
        1,
        "a geometry `CIRCLE` cannot be read; give `arc`, `circle`, `polyline` or `point`, or a POINT, LINESTRING or \
         POLYGON of WKT",
    ),
    (
        "8 1 2",
        1,
        "`8` where `arc`, `circle`, `polyline`, `point`, a geometry of WKT or a GeoJSON object was expected; correct it",
    ),
    ("OFF\n", 1, "this is a model (OFF), not a file of curves; give curves as text, WKT or GeoJSON"),
    (
        "POINT (0 -90.5)",
        1,
        "`-90.5` where a latitude from -90 to 90 degrees behind the longitude was expected; correct it",
    ),
    (
        "{\"type\":\"Point\",\n\"coordinates\":[45,91]}",
        2,
        "`91` where a latitude from -90 to 90 degrees behind the longitude was expected; correct it",
    ),
    (
        "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\
         \"coordinates\":[1,2]}},{\"type\":\"Feature\",\"geometry\":{\"type\":\"MultiPoint\",\
         \"coordinates\":[[1,2],[2,91]]}}]}",
        1,
        "`91` where a latitude from -90 to 90 degrees behind the longitude was expected; correct it (in feature 1, \
         counted from 0)",
    ),
    (
        "{\"type\":\"LineString\",\"coordinates\":[[10,20],\n[-170,-20]]}",
        2,
        "the point is antipodal to the one before it, and every arc between them is as short; give a point between",
    ),
    (
        "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"geometry\":{\"type\":\"LineString\",\
         \"coordinates\":[[0,90],[55,-90]]}}]}",
        1,
        "the point is antipodal to the one before it, and every arc between them is as short; give a point between \
         (in feature 0, counted from 0)",
    ),
    (
        "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[9,0],[0,9]]]}",
        1,
        "the ring of a polygon is not closed; repeat its first point at its end",
    ),
];

#[test]
fn every_error_has_its_line_and_says_what_to_do() {
    for &(text, line, expected) in BAD {
        let error = match read_sphere_curves(text.as_bytes(), None) {
            Ok(file) => panic!("{text} gives {:?}", file.curves),
            Err(error) => error,
        };
        assert_eq!((error.place, error.sentence()), (Some(Place::Line(line)), expected.into()), "{text}");
    }
}

#[test]
fn points_are_read() {
    let text = "0 0 2 # a pole\n\n-1 0.5 1/3\npoint 1 1 1\nPOINT (90 0)\n\
        {\"type\":\"MultiPoint\",\"coordinates\":[[-180,0],\n[33,90]]}\n";
    let file = read_sphere_points(text.as_bytes(), None).unwrap();
    let shown: Vec<String> = file.points.iter().map(ToString::to_string).collect();
    assert_eq!(shown, ["(0, 0, 1)", "(-6, 3, 2)", "(1, 1, 1)", "(0, 1, 0)", "(-1, 0, 0)", "(0, 0, 1)"]);
    assert_eq!(file.places, PlaceList::Lines(vec![1, 3, 4, 5, 6, 7]));
    assert_eq!(read_sphere_points(b"", None).unwrap().notes, [CurveNote::NoPoints]);
}

#[test]
fn what_is_no_point_is_refused() {
    let rows: &[(&str, u32, &str)] = &[
        ("0 0 1\narc 1 0 0 0 1 0\n", 2, "an arc in a file of points; remove it"),
        ("circle 1 0 0\n", 1, "a circle in a file of points"),
        ("LINESTRING (0 0, 1 1)\n", 1, "a polyline in a file of points"),
        ("1 2\n", 1, "the line ends where a point of three coordinates (`x y z`) was expected"),
        ("1 2 3 4\n", 1, "`4` where the end of the line was expected"),
        ("0 0 0\n", 1, "the vector is zero"),
        (
            "segment 0 0 1 1\n",
            1,
            "`segment` in a file of points of the sphere cannot be read; give points as `x y z` or `point x y z`, or in WKT or GeoJSON",
        ),
        (
            "0 0 1\nperiod 4 3\n",
            2,
            "`period` in a file of points of the sphere cannot be read; give points as `x y z`",
        ),
        ("0,0,1\n", 1, "`,` between coordinates; write a blank instead"),
        ("POINT (0 100)\n", 1, "`100` where a latitude from -90 to 90 degrees"),
        ("x 1\n", 1, "`x` where a point as `x y z` or `point x y z`, a POINT of WKT or a GeoJSON object"),
        ("OFF\n", 1, "this is a model (OFF), not a file of points; give points as text, WKT or GeoJSON"),
    ];
    for (text, line, why) in rows {
        let error = read_sphere_points(text.as_bytes(), None).expect_err(text);
        assert_eq!(error.place, Some(Place::Line(*line)), "{text}: {error}");
        assert!(error.sentence().contains(why), "{text}: {error}");
    }
}

#[test]
fn the_example_of_the_page_is_read() {
    let page = include_str!("../../../../docs/curves.md");
    let (_, example) = page.split_once("```sphere\n").unwrap();
    let file = read(example.split("```").next().unwrap());
    assert_eq!((file.curves.len(), file.notes.len()), (7, 0));
}

#[test]
fn memory_is_bounded_by_the_file() {
    let zeros = "0 0,".repeat(8 << 20);
    let text = pack_gzip(format!("MULTIPOINT({zeros}0 0)\n").as_bytes());
    let error = read_sphere_curves(&text, None).unwrap_err();
    assert!(error.to_string().contains("too much for a file of this size"), "{error}");
    let digits = format!("point {}1e400 1e-400 1\n", "0".repeat(100)).repeat(100_000);
    let error = read_sphere_curves(&pack_gzip(digits.as_bytes()), None).unwrap_err();
    assert!(error.to_string().contains("too much for a file of this size"), "{error}");
    // What is short is within the budget.
    let points = "1 2 3\n".repeat(1_000_000);
    assert_eq!(read_sphere_points(points.as_bytes(), None).unwrap().points.len(), 1_000_000);
    for line in ["point 1 2 3\n", "arc 1 0 0 0 1 0\n", "arc 1 0 0 0 1 0 via 1 1 0\n", "circle 1 2 3\n"] {
        assert_eq!(read(&line.repeat(200_000)).curves.len(), 200_000, "{line}");
    }
}

const SEED: u64 = 0x5F_4E6E;

fn direction(random: &mut Rng) -> Direction {
    let mut coordinate = || -> Rational {
        match random.below(4) {
            0 => Rational::from(random.below(5) as i64 - 2),
            1 => format!("-{}/{}", random.bits(), random.bits() | 1).parse().unwrap(),
            2 => format!("{}.{}", random.below(100), random.bits()).parse().unwrap(),
            _ => format!("{}e-{}", random.bits(), random.below(90)).parse().unwrap(),
        }
    };
    loop {
        let vector = [coordinate(), coordinate(), coordinate()];
        let weight = vector.iter().fold(Integer::ONE, |weight, c| weight.lcm(&c.denominator()));
        let vector = vector.map(|c| c.numerator() * weight.div_exact(&c.denominator()));
        if let Some(direction) = Direction::new(vector) {
            return direction;
        }
    }
}

fn curve(random: &mut Rng) -> SphereCurve {
    let [p, q] = loop {
        let ends = [direction(random), direction(random)];
        if ends[0] != ends[1] && ends[0] != ends[1].opposite() {
            break ends;
        }
    };
    match random.below(5) {
        0 => SphereCurve::Arc([p, q]),
        1 => {
            let [[a, b, c], [d, e, f]] = [p.coordinates(), q.coordinates()];
            let via = Direction::new([a + d, b + e, c + f]).unwrap();
            let via = if random.one_in(2) { via.opposite() } else { via };
            SphereCurve::ArcVia(Box::new([p, via, q]))
        }
        2 => SphereCurve::Circle(GreatCircle::through(&p, &q).unwrap()),
        3 => SphereCurve::Point(p),
        _ => SphereCurve::Polyline(vec![p, q]),
    }
}

#[test]
fn curves_come_back() {
    println!("seed {SEED:#x}");
    let mut random = Rng::new(SEED);
    for case in 0..500 {
        let curves: Vec<SphereCurve> = (0..random.below(8)).map(|_| curve(&mut random)).collect();
        let text = write_sphere_curves(&curves);
        let again = read_sphere_curves(&text, None).unwrap_or_else(|error| panic!("case {case}: {error}"));
        assert_eq!(again.curves, curves, "case {case}");
        assert_eq!(write_sphere_curves(&again.curves), text, "case {case}");
    }
}

/// Places as WKT and GeoJSON write them, in decimals of random length.
#[test]
fn both_grammars_give_the_same_places() {
    println!("seed {SEED:#x}");
    let mut random = Rng::new(SEED);
    for _ in 0..500 {
        let mut number = |bound: u64| {
            let sign = if random.one_in(2) { "-" } else { "" };
            format!("{sign}{}.{}", random.below(bound), random.bits() >> random.below(64))
        };
        let [a, b, c, d] = [number(1000), number(90), number(1000), number(90)];
        let wkt = read(&format!("MULTIPOINT(({a} {b}),({c} {d}))"));
        let json = read(&format!("{{\"type\":\"MultiPoint\",\"coordinates\":[[{a},{b}],[{c},{d}]]}}"));
        assert_eq!(wkt.curves, json.curves);
        assert_eq!(wkt.curves, [(&a, &b), (&c, &d)].map(|(l, b)| SphereCurve::Point(place(l, b))));
    }
}

#[test]
fn changed_files_never_break_the_reader() {
    println!("seed {SEED:#x}");
    let mut random = Rng::new(SEED);
    for case in 0..4_000 {
        let (text, ..) = ROWS[case % ROWS.len()];
        let mut changed = text.as_bytes().to_vec();
        for _ in 0..=random.below(3) {
            mutate(&mut changed, &[b"arc 1 0 0 0 1 0", b"via", b"0", b"-90", b"polyline"], &mut random);
        }
        if let Ok(file) = read_sphere_curves(&changed, None) {
            let again = read_sphere_curves(&write_sphere_curves(&file.curves), None).unwrap();
            assert_eq!(again.curves, file.curves, "case {case}");
        }
        let _ = read_sphere_points(&changed, None);
    }
}
