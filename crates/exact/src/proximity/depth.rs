//! How deep a point lies below planes: bounds for a search, and the exact comparison.

use super::QueryPoint;
use crate::predicate::dot;
use crate::{Integer, Point3, Rational, Vector3};
use std::cmp::Ordering;

/// An upper bound of the relative errors below: a depth is a sum of four terms, whose factors have a few roundings each.
/// u = 2^-53 is the unit of rounding. A coordinate of a normal is nearest to an integer (u); its squares, their sum, the root and
/// the quotient add at most 5u; the offset has as many; a coordinate of the point is a quotient of two rounded numbers (3u); products
/// and sums add 5u. Altogether at most 16u, to first order; 2^-48 is 32u.
const ERROR: f64 = f64::from_bits((1023 - 48) << 52);
/// More than what underflow may add to a few such terms.
const TINY: f64 = f64::MIN_POSITIVE;

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
        let offset =
            Rational::new(dot(normal.coordinates(), [0, 1, 2].map(|axis| on.numerator(axis))), on.weight())
                .expect("a weight is positive");
        let offset = offset.approx_f64() / greatest / length;
        Self { values: [unit[0], unit[1], unit[2], offset] }
    }

    /// Gives the unit normal and the distance from the origin, rounded: for an order of work.
    pub fn approx_f64(&self) -> [f64; 4] {
        self.values
    }

    /// Bounds how far below the plane a point lies.
    #[inline]
    pub fn depth(&self, point: &DepthPoint) -> DepthBounds {
        let ([a, b, c, d], [x, y, z]) = (self.values, point.values);
        let depth = d - ((a * x + b * y) + c * z);
        // Coordinates of a unit vector are at most one.
        let error = (d.abs() + point.sum) * ERROR + TINY;
        // Not a number compares as neither below nor above.
        DepthBounds { low: depth - error, high: depth + error }
    }
}

/// A point as the bounds read it.
#[derive(Clone, Copy, Debug)]
pub struct DepthPoint {
    values: [f64; 3],
    /// The sum of their magnitudes.
    sum: f64,
}

impl DepthPoint {
    /// Takes a point.
    #[inline]
    pub fn new(point: &QueryPoint) -> Self {
        // A finite number over an infinite weight would look like zero.
        let values =
            if point.floats()[3].is_finite() { point.approx_f64() } else { [f64::NAN, f64::NAN, f64::NAN] };
        let [x, y, z] = values;
        Self { values, sum: x.abs() + y.abs() + z.abs() }
    }
}

/// A box that contains some planes, as unit normals with offsets.
#[derive(Clone, Copy, Debug)]
pub struct DepthBox {
    low: [f64; 4],
    high: [f64; 4],
}

impl DepthBox {
    /// Gives the smallest box that contains the planes.
    pub fn of<'a>(planes: impl IntoIterator<Item = &'a DepthPlane>) -> Self {
        let empty = Self { low: [f64::INFINITY; 4], high: [f64::NEG_INFINITY; 4] };
        planes.into_iter().fold(empty, |all, plane| {
            let value = |i: usize| plane.values[i];
            // A value that is no number makes the box unbounded.
            let low = |i: usize| if value(i).is_nan() { f64::NEG_INFINITY } else { all.low[i].min(value(i)) };
            let high = |i: usize| if value(i).is_nan() { f64::INFINITY } else { all.high[i].max(value(i)) };
            Self { low: [0, 1, 2, 3].map(low), high: [0, 1, 2, 3].map(high) }
        })
    }

    /// Gives the sizes of the box: for an order of work.
    pub fn approx_sizes(&self) -> [f64; 4] {
        [0, 1, 2, 3].map(|i: usize| self.high[i] - self.low[i])
    }

    /// Bounds the depths of a point below the planes from below: a bound that is not a number says nothing.
    #[inline]
    pub fn least_depth(&self, point: &DepthPoint) -> DepthBounds {
        let term = |i: usize| {
            let s = point.values[i];
            let (a, b) = (self.low[i] * s, self.high[i] * s);
            if a > b { a } else { b }
        };
        let (p, q, r) = (term(0), term(1), term(2));
        let d = self.low[3];
        let depth = d - ((p + q) + r);
        let greatest = self.low[3].abs().max(self.high[3].abs());
        let error = (greatest + point.sum) * ERROR + TINY;
        DepthBounds { low: depth - error, high: f64::INFINITY }
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
