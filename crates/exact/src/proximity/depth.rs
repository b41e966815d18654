//! How deep a point lies below planes: bounds for a search, and the exact comparison.

use super::QueryPoint;
use crate::predicate::dot;
use crate::rational::approx_quotient;
use crate::{Integer, Point3, Sign, Vector3};
use std::cmp::Ordering;

/// An upper bound of the relative errors below: a depth is a sum of four terms, whose factors have a few roundings each.
/// u = 2^-53 is the unit of rounding. A coordinate of a normal is nearest to an integer (u); its squares, their sum, the root and
/// the quotient add at most 5u; the offset has as many; a coordinate of the point is a quotient of two rounded numbers (3u); products
/// and sums add 5u. Altogether at most 20u, to first order; 2^-48 is 32u.
const ERROR: f64 = f64::from_bits((1023 - 48) << 52);
/// More than what underflow may add to a few such terms.
const TINY: f64 = f64::MIN_POSITIVE;

/// A distance whose square does not underflow.
const LEAST_LENGTH: f64 = f64::from_bits((1023 - 400) << 52);

/// A plane with a unit normal, rounded.
#[derive(Clone, Copy, Debug)]
pub struct DepthPlane {
    /// The unit normal and the distance from the origin, of either sign.
    values: [f64; 4],
}

/// An interval that contains a depth; unbounded where the floats say nothing.
#[derive(Clone, Copy, Debug)]
pub struct DepthBounds {
    low: f64,
    high: f64,
}

impl DepthBounds {
    const UNKNOWN: Self = Self { low: f64::NAN, high: f64::NAN };

    /// Tells whether the depth is certainly less than the other one.
    #[inline]
    pub fn is_below(&self, other: &Self) -> bool {
        self.high < other.low
    }

    /// Tells whether the depth is certainly positive.
    #[inline]
    pub fn is_positive(&self) -> bool {
        self.low > 0.0
    }

    /// Tells whether the depth is certainly negative.
    #[inline]
    pub fn is_negative(&self) -> bool {
        self.high < 0.0
    }
}

impl DepthPlane {
    /// Takes the plane through a point with a given normal.
    pub fn new(normal: &Vector3, on: &Point3) -> Self {
        // Powers of two keep squares in range; the normal has a coordinate of magnitude at least one.
        let [x, y, z] = normal.approx_f64();
        let greatest = x.abs().max(y.abs()).max(z.abs());
        let [x, y, z] = [x, y, z].map(|value| value / greatest);
        let length = (x * x + y * y + z * z).sqrt();
        let unit = [x, y, z].map(|value| value / length);
        let offset = approx_offset(normal, on) / greatest / length;
        Self { values: [unit[0], unit[1], unit[2], offset] }
    }

    /// Gives the unit normal and the distance from the origin, rounded: for an order of work.
    pub fn approx_f64(&self) -> [f64; 4] {
        self.values
    }

    /// Bounds how far below the plane a point lies.
    #[inline]
    pub fn depth(&self, point: &DepthPoint) -> DepthBounds {
        if crate::stage::are_boxes_skipped() {
            return DepthBounds::UNKNOWN;
        }
        let ([a, b, c, d], [x, y, z]) = (self.values, point.values);
        let depth = d - ((a * x + b * y) + c * z);
        // Coordinates of a unit vector are at most one.
        let error = (d.abs() + point.sum) * ERROR + TINY;
        // Not a number compares as neither below nor above.
        DepthBounds { low: depth - error, high: depth + error }
    }
}

/// normal . on, with at most three roundings.
fn approx_offset(normal: &Vector3, on: &Point3) -> f64 {
    if let (Some([a, b, c]), Some([x, y, z, w])) = (normal.to_i128(), on.as_narrow())
        && normal.bits() + on.bits() + 2 < 127
    {
        let [x, y, z] = [*x, *y, *z].map(i128::from);
        return (a * x + b * y + c * z) as f64 / *w as f64;
    }
    let numerator: Integer = dot(normal.coordinates(), [0, 1, 2].map(|axis| on.numerator(axis)));
    let magnitude = approx_quotient(&numerator.abs(), &on.weight());
    if numerator.sign() == Sign::Negative { -magnitude } else { magnitude }
}

/// A point as the bounds read it.
#[derive(Clone, Copy, Debug)]
pub struct DepthPoint {
    values: [f64; 3],
    /// The sum of their magnitudes.
    sum: f64,
    /// At least the distance from the origin, and its square rounded up; large enough not to underflow.
    length: f64,
    square: f64,
}

impl DepthPoint {
    /// Takes a point.
    #[inline]
    pub fn new(point: &QueryPoint) -> Self {
        // A finite number over an infinite weight would look like zero.
        let values =
            if point.floats()[3].is_finite() { point.approx_f64() } else { [f64::NAN, f64::NAN, f64::NAN] };
        let [x, y, z] = values;
        let length = (x * x + y * y + z * z).sqrt() * (1.0 + ROUNDING);
        let length = if length < LEAST_LENGTH { LEAST_LENGTH } else { length };
        let square = length * length * (1.0 + ROUNDING);
        Self { values, sum: x.abs() + y.abs() + z.abs(), length, square }
    }
}

/// A cap of the sphere that contains the unit normals of some planes, and the least of their offsets.
#[derive(Clone, Copy, Debug)]
pub struct DepthCap {
    axis: [f64; 3],
    /// Cosine and sine of the greatest angle between the axis and a normal; the angle is rounded up.
    cosine: f64,
    sine: f64,
    /// The least offset, and the greatest magnitude of one.
    offset: f64,
    greatest: f64,
}

/// By this the cosines are less than computed.
const SLACK: f64 = f64::from_bits((1023 - 45) << 52);
/// More than the errors of a few sums of squares of coordinates of unit vectors.
const ROUNDING: f64 = f64::from_bits((1023 - 49) << 52);

impl DepthCap {
    /// Gives a small cap that contains the planes, around the mean of their normals.
    pub fn of<'a>(planes: impl Iterator<Item = &'a DepthPlane> + Clone) -> Self {
        let mut axis = [0.0; 3];
        for plane in planes.clone() {
            axis.iter_mut().zip(plane.values).for_each(|(sum, value)| *sum += value);
        }
        let [x, y, z] = axis;
        let length = (x * x + y * y + z * z).sqrt();
        // Normals that cancel, or are not known, have no mean.
        let axis = if length > ROUNDING { axis.map(|sum| sum / length) } else { [1.0, 0.0, 0.0] };
        let (mut cosine, mut offset, mut greatest) = (1.0_f64, f64::INFINITY, 0.0_f64);
        for plane in planes {
            let [a, b, c, d] = plane.values;
            let cosine_of_plane = axis[0] * a + axis[1] * b + axis[2] * c;
            if cosine_of_plane.is_nan() || d.is_nan() {
                return Self {
                    axis: [1.0, 0.0, 0.0],
                    cosine: -1.0,
                    sine: 0.0,
                    offset: f64::NAN,
                    greatest: 0.0,
                };
            }
            cosine = cosine.min(cosine_of_plane);
            offset = offset.min(d);
            greatest = greatest.max(d.abs());
        }
        let cosine = (cosine - SLACK).max(-1.0);
        let sine = (1.0 - cosine * cosine + ROUNDING).sqrt();
        Self { axis, cosine, sine, offset, greatest }
    }

    /// Bounds the depths of a point below the planes from below.
    ///
    /// With the angle f between the axis and the point s, and t the angle of the cap, no normal u of the cap has a greater u . s
    /// than |s| cos(f - t), or |s| if f <= t. Near f = t both are the same to second order, so it does not matter how
    /// rounding decides; and the sine of f, which is not well conditioned where it is small, is rounded up.
    #[inline]
    pub fn least_depth(&self, point: &DepthPoint) -> DepthBounds {
        if crate::stage::are_boxes_skipped() {
            return DepthBounds::UNKNOWN;
        }
        let ([a, b, c], [x, y, z]) = (self.axis, point.values);
        let along = (a * x + b * y) + c * z;
        let reach = if along < self.cosine * point.length {
            // What is not a number, where squares overflow, has to stay.
            let square = point.square - along * along;
            let across = if square < 0.0 { 0.0 } else { square.sqrt() };
            along * self.cosine + across * self.sine
        } else {
            point.length
        };
        let error = (self.greatest + point.sum) * ERROR + TINY;
        DepthBounds { low: self.offset - reach - error, high: f64::INFINITY }
    }
}

impl DepthBounds {
    /// The lower bound: for an order of work.
    #[inline]
    pub fn approx_low(&self) -> f64 {
        self.low
    }
}

/// Compares how deep a point lies below two planes, given by normals and points on them.
///
/// Law: the point must not be above either of them.
///
/// # Complexity
/// Integers of any size, of degree 10 in the edges of which the normals are products.
///
/// ```
/// use exact::proximity::compare_depths;
/// use exact::{Point3, Vector3};
/// use std::cmp::Ordering;
/// let (x, y) = (Vector3::from_i64([1, 0, 0]), Vector3::from_i64([0, 7, 0]));
/// let corner = Point3::from_i64([3, 3, 0]);
/// assert_eq!(compare_depths(&Point3::ORIGIN, (&x, &corner), (&y, &corner)), Ordering::Equal);
/// ```
pub fn compare_depths(point: &Point3, first: (&Vector3, &Point3), second: (&Vector3, &Point3)) -> Ordering {
    // (n . (on w - p v))^2 / (|n| v w)^2, cross-multiplied; w is common to both.
    let height = |(normal, on): (&Vector3, &Point3)| {
        let (v, w) = (on.weight(), point.weight());
        let difference = [0, 1, 2].map(|axis: usize| on.numerator(axis) * &w - point.numerator(axis) * &v);
        (dot(normal.coordinates(), difference), normal.dot(normal) * &v * &v)
    };
    let ((a, m), (b, n)): ((Integer, Integer), (Integer, Integer)) = (height(first), height(second));
    (&a * &a * n).cmp(&(&b * &b * m))
}
