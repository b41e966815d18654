//! Errors and notes in collections of features: which one they are about.

use splitstar_formats::{Fault, Place, ReadError, pack_gzip};
use splitstar_formats::{read_curves, read_points, read_sphere_curves, read_sphere_points};

/// A feature with the geometry of this type and these coordinates.
fn feature(kind: &str, coordinates: &str) -> String {
    format!(
        "{{\"type\":\"Feature\",\"properties\":{{\"a\":[1,{{}}]}},\"geometry\":{{\"type\":\"{kind}\",\"coordinates\":{coordinates}}}}}"
    )
}

fn collection(features: &[String]) -> String {
    format!("{{\"type\":\"FeatureCollection\",\"features\":[\n{}\n]}}\n", features.join(",\n"))
}

/// A third feature, and what is said of it.
fn rows() -> Vec<(String, &'static str)> {
    let point = |coordinates: &str| feature("Point", coordinates);
    vec![
        (point("[1]"), "`]` where `,` and a second coordinate was expected; correct it"),
        (point("[1,x]"), "`x` is no number; write an integer, a decimal or a fraction p/q"),
        (point("[1,\"2\"]"), "`\"2\"` is no number; write an integer, a decimal or a fraction p/q"),
        (point("[1,1e999]"), "the exponent of `1e999` is too large in magnitude; the largest allowed is 400"),
        (point("[1,2,3/0]"), "`3/0` has the denominator zero; write a fraction p/q with q not zero"),
        (point("[1 2]"), "`2` where `,` and a second coordinate was expected; correct it"),
        (point("{}"), "`{` where `[` with coordinates was expected; correct it"),
        (
            feature("Polygon", "[[[0,0],[1,0],[0,1]]]"),
            "the ring of a polygon is not closed; repeat its first point at its end",
        ),
        (
            feature("LineString", "[[0,0]]"),
            "a polyline of one point; give it a second one, or make it a point",
        ),
        (feature("MultiPoint", "[[0,0],[]]"), "`]` where a coordinate was expected; correct it"),
        (
            feature("Curve", "[[0,0]]"),
            "an object of type `Curve` cannot be read; give GeoJSON: a geometry, a feature or a collection of features",
        ),
        (feature("Feature", "[[0,0]]"), "`\"Feature\"` where a geometry was expected; correct it"),
        ("{\"type\":\"Feature\"}".into(), "a feature without the member `geometry`; add it"),
        ("{\"geometry\":null}".into(), "a feature without the member `type`; add it"),
        (
            "{\"type\":\"Feature\",\"geometry\":null,\"geometry\":null}".into(),
            "`\"geometry\"` where a member that fits to the others was expected; correct it",
        ),
        ("7".into(), "`7` where a feature, which begins with `{`, was expected; correct it"),
        ("{\"a\":'b'}".into(), "a feature without the member `type`; add it"),
        (
            format!("{{\"a\":{}", "[".repeat(99)),
            "brackets nested more than 64 deep cannot be read; nest them less",
        ),
    ]
}

fn error<F: std::fmt::Debug>(read: Result<F, ReadError>) -> (Option<Place>, String) {
    let error = read.unwrap_err();
    (error.place, error.sentence())
}

#[test]
fn every_error_names_its_feature() {
    for (bad, expected) in rows() {
        let text = collection(&[feature("Point", "[1,2]"), feature("MultiPoint", "[]"), bad]);
        let expected = (Some(Place::Line(4)), format!("{expected} (in feature 2, counted from 0)"));
        assert_eq!(error(read_curves(text.as_bytes(), None)), expected, "{text}");
        assert_eq!(error(read_sphere_curves(text.as_bytes(), None)), expected, "{text}");
        assert_eq!(error(read_curves(&pack_gzip(text.as_bytes()), None)), expected, "{text}");
    }
    // Coordinates that come before their type, and what is wrong on the sphere only.
    let early =
        "{\"geometry\":{\"coordinates\":[[0,0],\n[180,0]],\"type\":\"LineString\"},\"type\":\"Feature\"}";
    let text = collection(&[early.into()]);
    let (place, said) = error(read_sphere_curves(text.as_bytes(), None));
    assert_eq!(place, Some(Place::Line(3)));
    assert!(
        said.starts_with("the point is antipodal") && said.ends_with("(in feature 0, counted from 0)"),
        "{said}"
    );
    let fault = read_curves(collection(&["{".into()]).as_bytes(), None).unwrap_err().fault;
    assert!(matches!(fault, Fault::InFeature { feature: 0, .. }), "{fault:?}");
}

#[test]
fn what_is_no_point_names_its_feature() {
    let text = collection(&[feature("Point", "[1,2]"), feature("LineString", "[[0,0],\n[1,1]]")]);
    let expected = "a polyline in a file of points; remove it, or give the points that are asked about \
                    (in feature 1, counted from 0)";
    for found in [error(read_points(text.as_bytes(), None)), error(read_sphere_points(text.as_bytes(), None))]
    {
        assert_eq!(found, (Some(Place::Line(3)), expected.into()));
    }
}

#[test]
fn what_is_outside_of_features_names_none() {
    let point = feature("Point", "[1,2]");
    for (text, expected) in [
        (
            format!("{point}\n{}", feature("Point", "[1]")),
            "`]` where `,` and a second coordinate was expected; correct it",
        ),
        (collection(&[format!("{point} {point}")]), "`{` where `,` or `]` was expected; correct it"),
        (
            format!("{} {point}", collection(std::slice::from_ref(&point)).trim_end()),
            "`{` where the end of the line was expected; correct it",
        ),
        (
            format!("{}point 1", collection(&[point])),
            "the line ends where a point of two coordinates (`point x y`) was expected; complete it",
        ),
    ] {
        assert_eq!(error(read_curves(text.as_bytes(), None)).1, expected, "{text}");
    }
}

#[test]
fn too_little_memory_is_a_fault_of_the_file() {
    let points = "[0,0],".repeat(8 << 20);
    let text = collection(&[feature("MultiPoint", &format!("[{points}[0,0]]"))]);
    let fault = read_curves(&pack_gzip(text.as_bytes()), None).unwrap_err().fault;
    assert!(matches!(fault, Fault::TooMuchMemory { .. }), "{fault:?}");
}

#[test]
fn notes_name_the_first_feature() {
    let fine = || feature("Point", "[1,2]");
    let high = || feature("Point", "[1,2,3]");
    let twice = || feature("LineString", "[[0,0],[0,0],[1,1]]");
    let still = || feature("LineString", "[[0,0],[0,0]]");
    let empty = || "{\"type\":\"Feature\",\"geometry\":null}".to_string();
    let rows: [(Vec<String>, &[&str]); 6] = [
        (vec![fine()], &[]),
        (
            vec![fine(), high()],
            &[
                "1 point has more than two coordinates: the others are left out (in feature 1, counted from 0)",
            ],
        ),
        (
            vec![fine(), high(), fine(), high()],
            &[
                "2 points have more than two coordinates: the others are left out (the first in feature 1, counted from 0)",
            ],
        ),
        (
            vec![twice(), fine(), twice()],
            &[
                "2 points of polylines are the same as the ones before them: left out (the first in feature 0, counted from 0)",
            ],
        ),
        (
            vec![fine(), fine(), still(), empty()],
            &[
                "1 polyline has only one point, several times: it is read as a point (in feature 2, counted from 0)",
                "1 geometry is empty: it has no curve (in feature 3, counted from 0)",
            ],
        ),
        (
            vec![fine(), empty(), empty()],
            &["2 geometries are empty: they have no curve (the first in feature 1, counted from 0)"],
        ),
    ];
    for (features, expected) in rows {
        let text = collection(&features);
        let [flat, round] = [
            read_curves(text.as_bytes(), None).unwrap().notes,
            read_sphere_curves(text.as_bytes(), None).unwrap().notes,
        ]
        .map(|notes| notes.iter().map(ToString::to_string).collect::<Vec<_>>());
        assert_eq!(flat, expected, "{text}");
        assert_eq!(round, expected, "{text}");
    }
    // The first one is not in a collection.
    let text = format!("POINT Z (1 2 3)\n{}", collection(&[high()]));
    let notes = read_curves(text.as_bytes(), None).unwrap().notes;
    assert_eq!(notes[0].to_string(), "2 points have more than two coordinates: the others are left out");
    let text = collection(&[fine(), empty(), feature("MultiPoint", "[]")]);
    let notes = read_points(text.as_bytes(), None).unwrap().notes;
    let expected = "2 geometries are empty: they have no point, and get no answer (the first in feature 1, counted from 0)";
    assert_eq!(notes[0].to_string(), expected);
}
