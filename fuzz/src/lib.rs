//! What every fuzz target checks: of a reader, and of edits.

// The tests have the same scripts, from random bytes, and the same two modules beside them.
#[path = "../../crates/arrangement/tests/common/family.rs"]
#[allow(dead_code)]
mod family;
#[path = "../../crates/arrangement/tests/scripts/script/mod.rs"]
#[allow(dead_code)]
mod script;
#[path = "../../crates/arrangement/tests/common/swept_again.rs"]
mod swept_again;

use exact::Rational;
use exact::spherical::Direction;
use splitstar_arrangement::models::GeodesicTraits;
use splitstar_formats::{CurveFile, CurvePoint, Format, InputCurve, Model, Shape, WriteOptions, read, read_curves, write, write_curves};
use splitstar_formats::{SphereCurve, read_sphere_curves, read_sphere_points, write_sphere_curves};
use splitstar_formats::{StarArrangement, read_arrangement, read_points, write_arrangement};
use splitstar_formats::{FilePlacement, read_placements};
use splitstar_formats::{read_gaussian_map, write_gaussian_map};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::LazyLock;

/// Reads bytes as a file of that name. A message must be one short line; a model must come back from the native
/// format as it was, and every other format must take it or say why not.
pub fn check(bytes: &[u8], file_name: &str) {
    let model = match read(bytes, Some(file_name)) {
        Ok(read) => read.model,
        Err(error) => {
            let message = error.to_string();
            assert!(message.len() < 600 && !message.contains(char::is_control), "{message:?}");
            return;
        }
    };
    let text = write(&model, &WriteOptions::new(Format::Star)).expect("the native format holds every model").bytes;
    let again = read(&text, None).expect("what was written can be read").model;
    let twice = write(&again, &WriteOptions::new(Format::Star)).expect("the native format holds every model").bytes;
    assert_eq!(String::from_utf8_lossy(&text), String::from_utf8_lossy(&twice));
    for format in Format::ALL {
        check_written(&model, format);
    }
}

fn check_written(model: &Model, format: Format) {
    let mut options = WriteOptions::new(format);
    options.lossy = true;
    let Ok(written) = write(model, &options) else { return };
    if format == Format::Glb {
        return;
    }
    let again = match read(&written.bytes, None) {
        Ok(again) => again.model,
        // Rounding may have made corners equal; and digits may be too many to be read again.
        Err(_) if !written.largest_rounding.is_zero() || has_long_numbers(model) => return,
        Err(error) => panic!("{format:?} cannot be read again: {error}"),
    };
    let exact = matches!(format, Format::Off | Format::Vrml);
    if let (true, Shape::Mesh(before), Shape::Mesh(after)) = (exact, &model.shape, &again.shape) {
        assert_eq!(before.facets.len(), after.facets.len(), "{format:?}");
        if format == Format::Off {
            assert_eq!(before.points, after.points);
            assert_eq!(before.facets, after.facets);
        }
    }
}

/// A number read with an exponent may have more digits, written out, than may be read.
fn has_long_numbers(model: &Model) -> bool {
    model.shape.points().any(|point| point.bits() > 1_000)
}

/// Reads bytes as a file of curves. A message must be one short line; curves must come back as they were, and the text of their
/// arrangement must not depend on their order. What is a file of points too has the same points.
pub fn check_curves(bytes: &[u8]) {
    check_points(bytes);
    let file = match read_curves(bytes, None) {
        Ok(file) => file,
        Err(error) => {
            let message = error.to_string();
            assert!(message.len() < 600 && !message.contains(char::is_control), "{message:?}");
            return;
        }
    };
    match read_curves(&write_curves(&file.curves), None) {
        Ok(again) => assert_eq!(again.curves, file.curves),
        Err(error) => assert!(file.curves.iter().any(is_long), "what was written cannot be read: {error}"),
    }
    if file.curves.len() <= 12 && bytes.len() <= 500 && !file.curves.iter().any(is_long) {
        check_arrangement_of(file);
    }
}

/// Reads bytes as a file of placements. A message must be one short line; placements must come back as they were.
pub fn check_placements(bytes: &[u8]) {
    let placements = match read_placements(bytes, None) {
        Ok(placements) => placements,
        Err(error) => {
            let message = error.to_string();
            assert!(message.len() < 600 && !message.contains(char::is_control), "{message:?}");
            return;
        }
    };
    let mut text = String::new();
    for FilePlacement { translation, rotation } in &placements {
        let numbers: Vec<String> = translation.coordinates().iter().map(ToString::to_string).collect();
        let turned = rotation.iter().flat_map(|q| q.components().each_ref().map(ToString::to_string));
        text += &numbers.into_iter().chain(turned).collect::<Vec<_>>().join(" ");
        text.push('\n');
    }
    match read_placements(text.as_bytes(), None) {
        Ok(again) => assert_eq!(again, placements),
        Err(error) => {
            let is_long = |placement: &FilePlacement| {
                placement.translation.bits() > 1_000 || placement.rotation.as_ref().is_some_and(|q| q.bits() > 1_000)
            };
            assert!(placements.iter().any(is_long), "what was written cannot be read: {error}");
        }
    }
}

/// Reads bytes as a file of points, which may say more than a file of curves that are points, and must not say another thing.
fn check_points(bytes: &[u8]) {
    match read_points(bytes, None) {
        Ok(file) => {
            if let Ok(curves) = read_curves(bytes, None) {
                let points: Vec<InputCurve> = file.points.into_iter().map(InputCurve::Point).collect();
                assert_eq!(points, curves.curves);
            }
        }
        Err(error) => {
            let message = error.to_string();
            assert!(message.len() < 600 && !message.contains(char::is_control), "{message:?}");
        }
    }
}

fn check_arrangement_of(CurveFile { mut curves, period, .. }: CurveFile) {
    if period.as_ref().is_some_and(|period| curves.iter().any(|curve| is_far(period, curve))) {
        return;
    }
    let make = |curves: Vec<InputCurve>| {
        let mut calls = 0;
        let few = |_| {
            calls += 1;
            if calls < 4 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        StarArrangement::of_curves_with(curves, period.clone(), few).ok().flatten()
    };
    let Some(arrangement) = make(curves.clone()) else { return };
    let text = write_arrangement(&arrangement);
    check_arrangement(&text);
    curves.reverse();
    let again = make(curves).expect("the curves are the same");
    assert_eq!(String::from_utf8_lossy(&write_arrangement(&again)), String::from_utf8_lossy(&text));
}

/// As for models: a number may have more digits, written out, than may be read.
fn is_long(curve: &InputCurve) -> bool {
    points_of(curve).iter().flat_map(|point| point.coordinates()).any(|number| number.to_string().len() > 1_000)
}

fn points_of(curve: &InputCurve) -> &[CurvePoint] {
    match curve {
        InputCurve::Segment(points) | InputCurve::Ray(points) | InputCurve::Line(points) => points,
        InputCurve::Polyline(points) => points,
        InputCurve::Point(point) => std::slice::from_ref(point),
        _ => &[],
    }
}

/// Whether a curve may go around the torus very often, and so be cut into very many pieces.
fn is_far([p, q]: &[Rational; 2], curve: &InputCurve) -> bool {
    let far = |x: &Rational, period: &Rational| x.abs() > Rational::from(100) * period;
    points_of(curve).iter().map(|point| point.coordinates()).any(|[x, y]| far(&x, p) || far(&y, q))
}

/// Reads bytes as a file of curves on the sphere, as [`check_curves`] does with those of the plane; the cells must not depend on the
/// identification either.
pub fn check_sphere_curves(bytes: &[u8]) {
    check_sphere_points(bytes);
    let file = match read_sphere_curves(bytes, None) {
        Ok(file) => file,
        Err(error) => {
            check_message(&error.to_string());
            return;
        }
    };
    let are_long = file.curves.iter().any(is_long_on_sphere);
    match read_sphere_curves(&write_sphere_curves(&file.curves), None) {
        Ok(again) => assert_eq!(again.curves, file.curves),
        Err(error) => assert!(are_long, "what was written cannot be read: {error}"),
    }
    if file.curves.len() <= 12 && bytes.len() <= 500 && !are_long {
        check_sphere_arrangement_of(file.curves);
    }
}

/// Reads bytes as a file of points, which may say more than a file of curves that are points, and must not say another thing.
fn check_sphere_points(bytes: &[u8]) {
    match read_sphere_points(bytes, None) {
        Ok(file) => {
            if let Ok(curves) = read_sphere_curves(bytes, None) {
                let points: Vec<SphereCurve> = file.points.into_iter().map(SphereCurve::Point).collect();
                assert_eq!(points, curves.curves);
            }
        }
        Err(error) => check_message(&error.to_string()),
    }
}

fn check_message(message: &str) {
    assert!(message.len() < 600 && !message.contains(char::is_control), "{message:?}");
}

/// Whatever a reader gives has an arrangement.
fn check_sphere_arrangement_of(mut curves: Vec<SphereCurve>) {
    let make = |curves: &[SphereCurve], identification: [i64; 2]| {
        let traits = GeodesicTraits::with_identification(identification.map(Into::into));
        let made = StarArrangement::of_sphere_curves(curves.to_vec(), traits.expect("a direction is not zero"));
        made.unwrap_or_else(|error| panic!("curves that were read have an arrangement: {error}"))
    };
    let [first, turned] = [[-1, 0], [2, 1]].map(|identification| make(&curves, identification));
    assert_eq!(first.counts(), turned.counts(), "with another identification");
    let texts = [first, turned].map(|arrangement| write_arrangement(&arrangement));
    texts.iter().for_each(|text| check_arrangement(text));
    curves.reverse();
    for (text, identification) in texts.iter().zip([[-1, 0], [2, 1]]) {
        let again = write_arrangement(&make(&curves, identification));
        assert_eq!(String::from_utf8_lossy(&again), String::from_utf8_lossy(text));
    }
}

fn is_long_on_sphere(curve: &SphereCurve) -> bool {
    let is_long = |p: &Direction| p.coordinates().iter().any(|number| number.bit_len() > 1_000);
    match curve {
        SphereCurve::Point(p) => is_long(p),
        SphereCurve::Arc(points) => points.iter().any(is_long),
        SphereCurve::ArcVia(points) => points.iter().any(is_long),
        SphereCurve::Polyline(points) => points.iter().any(is_long),
        SphereCurve::Circle(circle) => is_long(&circle.pole()),
        _ => false,
    }
}

/// Reads bytes as a Gaussian map. A message must be one short line; a map must come back with the text that it is given, and be a model, as far
/// as memory is allowed for it.
pub fn check_gaussian_map(bytes: &[u8]) {
    let map = match read_gaussian_map(bytes, None) {
        Ok(map) => map,
        Err(error) => {
            let message = error.to_string();
            assert!(message.len() < 600 && !message.contains(char::is_control), "{message:?}");
            return;
        }
    };
    let text = write_gaussian_map(&map);
    match read_gaussian_map(&text, None) {
        Ok(again) => {
            assert_eq!(String::from_utf8_lossy(&write_gaussian_map(&again)), String::from_utf8_lossy(&text));
        }
        // Comments and blanks give a file memory that its own text does not have.
        Err(error) => {
            let message = error.to_string();
            assert!(text.len() < bytes.len() && message.contains("would take more than"), "{message}");
        }
    }
    if let Err(error) = read(&text, None) {
        let message = error.to_string();
        assert!(message.contains("would take more than"), "{message}");
    }
}

/// Reads bytes as an arrangement. A message must be one short line; an arrangement must come back with the text that it is given.
pub fn check_arrangement(bytes: &[u8]) {
    let arrangement = match read_arrangement(bytes, None) {
        Ok(arrangement) => arrangement,
        Err(error) => {
            let message = error.to_string();
            assert!(message.len() < 600 && !message.contains(char::is_control), "{message:?}");
            return;
        }
    };
    let text = write_arrangement(&arrangement);
    match read_arrangement(&text, None) {
        Ok(again) => {
            assert_eq!(again.counts_with_splits(), arrangement.counts_with_splits());
            assert_eq!(String::from_utf8_lossy(&write_arrangement(&again)), String::from_utf8_lossy(&text));
        }
        // A number may have more digits, written out, than may be read.
        Err(error) => {
            let is_long = text.split(|byte| b" /\n".contains(byte)).any(|word| word.len() > 1_000);
            assert!(is_long, "what was written cannot be read: {error}");
        }
    }
}

/// Whether a file is run again: then the steps are printed.
static PRINTS: LazyLock<bool> = LazyLock::new(|| std::env::args().skip(1).any(|word| Path::new(&word).is_file()));

/// Runs bytes as a script of edits, after each of which everything is checked.
pub fn check_edits(bytes: &[u8]) {
    // Steps that are many take long, and find no more.
    if bytes.len() <= script::HEADER + 64 * script::STEP {
        let prints = *PRINTS;
        script::run(bytes, &mut |step| {
            if prints {
                eprintln!("{step}");
            }
        });
    }
}
