//! Curves, written: the same curves give the same bytes.

use super::model::{CurvePoint, InputCurve, SphereCurve};
use crate::base::numerals::put;
use exact::spherical::Direction;
use exact::{Integer, Rational};

/// Writes curves, one a line, with exact coordinates: integers, or fractions in lowest terms.
///
/// [`read_curves`](crate::read_curves) gives the same curves back, if it may read them: no segment, ray or line with
/// two equal points, no polyline of less than two points or with points that repeat the ones before them, and no number
/// of more than [`exact::MAX_DIGITS`] digits.
///
/// ```
/// use splitstar_formats::{read_curves, write_curves};
///
/// let file = read_curves(b"LINESTRING (0 0, 0.5 1e1)\n", None)?;
/// let text = write_curves(&file.curves);
/// assert_eq!(text, b"polyline 0 0 1/2 10\n");
/// assert_eq!(read_curves(&text, None)?.curves, file.curves);
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn write_curves(curves: &[InputCurve]) -> Vec<u8> {
    let mut text = Vec::new();
    put_curves(&mut text, curves);
    text
}

/// Writes curves of a torus: the periods first, and then as [`write_curves`] does.
pub fn write_periodic_curves(period: &[Rational; 2], curves: &[InputCurve]) -> Vec<u8> {
    let mut text = Vec::new();
    put(&mut text, format_args!("period {} {}\n", period[0], period[1]));
    put_curves(&mut text, curves);
    text
}

/// Writes curves on the sphere, one a line, with exact coordinates: integers without a common factor.
///
/// [`read_sphere_curves`](crate::read_sphere_curves) gives the same curves back, if it may read them: see [`write_curves`].
///
/// ```
/// use splitstar_formats::{read_sphere_curves, write_sphere_curves};
///
/// let file = read_sphere_curves(b"arc 0.5 1 0  0 0 1/3\nLINESTRING (0 0, 90 0, 180 0)\n", None)?;
/// let text = write_sphere_curves(&file.curves);
/// assert_eq!(text, b"arc 1 2 0 0 0 1\npolyline 1 0 0 0 1 0 -1 0 0\n");
/// assert_eq!(read_sphere_curves(&text, None)?.curves, file.curves);
/// # Ok::<(), splitstar_formats::ReadError>(())
/// ```
pub fn write_sphere_curves(curves: &[SphereCurve]) -> Vec<u8> {
    let mut text = Vec::new();
    for curve in curves {
        match curve {
            SphereCurve::Arc(ends) => put_directions(&mut text, "arc", ends),
            SphereCurve::ArcVia(points) => {
                let [source, via, target] = &**points;
                put_directions(&mut text, "arc", [source, target]);
                put_directions(&mut text, " via", [via]);
            }
            SphereCurve::Circle(circle) => put_vectors(&mut text, "circle", [circle.normal().coordinates()]),
            SphereCurve::Polyline(points) => put_directions(&mut text, "polyline", points),
            SphereCurve::Point(point) => put_directions(&mut text, "point", [point]),
        }
        text.push(b'\n');
    }
    text
}

fn put_directions<'a>(
    text: &mut Vec<u8>,
    keyword: &str,
    directions: impl IntoIterator<Item = &'a Direction>,
) {
    put_vectors(text, keyword, directions.into_iter().map(Direction::coordinates));
}

fn put_vectors(text: &mut Vec<u8>, keyword: &str, vectors: impl IntoIterator<Item = [Integer; 3]>) {
    text.extend_from_slice(keyword.as_bytes());
    for [x, y, z] in vectors {
        put(text, format_args!(" {x} {y} {z}"));
    }
}

fn put_curves(text: &mut Vec<u8>, curves: &[InputCurve]) {
    for curve in curves {
        match curve {
            InputCurve::Segment(ends) => put_record(text, "segment", ends),
            InputCurve::Ray(points) => put_record(text, "ray", points),
            InputCurve::Line(points) => put_record(text, "line", points),
            InputCurve::Polyline(points) => put_record(text, "polyline", points),
            InputCurve::Point(point) => put_record(text, "point", std::slice::from_ref(point)),
        }
    }
}

fn put_record(text: &mut Vec<u8>, keyword: &str, points: &[CurvePoint]) {
    text.extend_from_slice(keyword.as_bytes());
    for [x, y] in points.iter().map(CurvePoint::coordinates) {
        put(text, format_args!(" {x} {y}"));
    }
    text.push(b'\n');
}
