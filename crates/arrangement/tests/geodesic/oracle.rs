//! What is true of directions and arcs, in plain integers; and longitudes and latitudes by floats, which are far from one another for
//! directions with small coordinates.

use exact::spherical::{Direction, GreatCircle};
use exact::{Integer, Sign};
use splitstar_arrangement::models::{Geodesic, GeodesicArc, GeodesicTraits};
use splitstar_arrangement::traits::CurveEnd;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

pub(crate) type Vector = [Integer; 3];

pub(crate) fn direction(coordinates: [i64; 3]) -> Direction {
    Direction::from_i64(coordinates).unwrap()
}

pub(crate) fn dot(a: &Vector, b: &Vector) -> Integer {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn cross([a, b, c]: &Vector, [d, e, f]: &Vector) -> Vector {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

pub(crate) fn is_pole(p: &Direction) -> bool {
    let [x, y, _] = p.coordinates();
    x.is_zero() && y.is_zero()
}

/// Whether, around a normal from s, x comes before y or is it. From s back to s is the whole way.
fn is_before([x, y, s]: [&Vector; 3], n: &Vector) -> bool {
    let half = |y: &Vector| match (dot(n, &cross(s, y)).sign(), dot(s, y).sign()) {
        (Sign::Zero, Sign::Positive) => 0,
        (Sign::Positive, _) => 1,
        (Sign::Zero, _) => 2,
        (Sign::Negative, _) => 3,
    };
    let (of_x, of_y) = (half(x), if half(y) == 0 { 4 } else { half(y) });
    of_x < of_y || (of_x == of_y && dot(n, &cross(x, y)).sign() != Sign::Negative)
}

/// Whether a point is on the way from one to another around a circle, ends included.
fn is_on_way(p: &Direction, [from, to]: [&Direction; 2], circle: &GreatCircle) -> bool {
    let [x, s, t, n] = [p.coordinates(), from.coordinates(), to.coordinates(), circle.coordinates()];
    dot(&x, &n).is_zero() && is_before([&x, &t, &s], &n)
}

pub(crate) fn is_on_arc(p: &Direction, arc: &GeodesicArc) -> bool {
    is_on_way(p, CurveEnd::BOTH.map(|end| arc.end(end)), arc.circle())
}

pub(crate) fn is_on_geodesic(p: &Direction, curve: &Geodesic) -> bool {
    match (curve.great_circle(), curve.source(), curve.target()) {
        (Some(circle), Some(source), Some(target)) => is_on_way(p, [source, target], circle),
        (Some(circle), ..) => dot(&p.coordinates(), &circle.coordinates()).is_zero(),
        _ => curve.as_point() == Some(p),
    }
}

/// Longitude from the identification, and latitude.
pub(crate) fn place(traits: &GeodesicTraits, p: &Direction) -> [f64; 2] {
    let [x, y, z] = p.coordinates().map(|value| value.approx_f64());
    let [a, b, _] = traits.identification().coordinates().map(|value| value.approx_f64());
    let u = (y.atan2(x) - b.atan2(a)).rem_euclid(TAU);
    [if u > TAU - 1e-9 { 0.0 } else { u }, z.atan2(x.hypot(y))]
}

/// The latitude of a circle that is no meridian.
pub(crate) fn height_at(traits: &GeodesicTraits, circle: &GreatCircle, u: f64) -> f64 {
    let [x, y, z] = circle.coordinates().map(|value| value.approx_f64());
    let [a, b, _] = traits.identification().coordinates().map(|value| value.approx_f64());
    let angle = u + b.atan2(a);
    (-(x * angle.cos() + y * angle.sin())).atan2(z)
}

/// The longitude of a half meridian.
pub(crate) fn longitude_of(traits: &GeodesicTraits, arc: &GeodesicArc) -> f64 {
    place(traits, &arc.circle().ascending_node().unwrap())[0]
}

/// Least and greatest longitude of an arc.
pub(crate) fn range_of(traits: &GeodesicTraits, arc: &GeodesicArc) -> [f64; 2] {
    if arc.is_meridian() {
        return [longitude_of(traits, arc); 2];
    }
    let [min, max] = CurveEnd::BOTH.map(|end| place(traits, arc.end(end))[0]);
    let is_right = traits.meridian().contains(arc.end(CurveEnd::Max));
    [min, if is_right { TAU } else { max }]
}

pub(crate) fn sign(value: f64) -> std::cmp::Ordering {
    if value.abs() < 1e-9 { std::cmp::Ordering::Equal } else { value.total_cmp(&0.0) }
}

pub(crate) const NEARLY: f64 = 1e-9;
pub(crate) const QUARTER: f64 = FRAC_PI_2;
pub(crate) const HALF: f64 = PI;
