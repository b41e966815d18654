//! How deep a point lies below planes: bounds for a search, and the exact comparison.

use super::QueryPoint;
use crate::predicate::dot;
use crate::rational::approx_quotient;
use crate::{Integer, Point3, Sign, Vector3};
use std::cmp::Ordering;

/// More than the error of a depth, relative to the magnitude of the offset and the sum of those of the coordinates of the point.
///
/// In units of rounding, u = 2^-53, to first order. A coordinate of a normal is nearest to an integer: 1. Its square has 3, a sum
/// of three squares, none negative, 5, the root 3.5, and the quotient, the coordinate of the unit normal, 5.5; the division by a power of
/// two is exact. An offset is a quotient of two rounded numbers, 3, and has 7.5 after the division by the length. A coordinate
/// of the point is such a quotient, too: 3. A product of coordinates and the three sums it takes part in add 4: so products have at most 12.5,
/// and the offset, with one subtraction, 8.5. The ends of the interval add 1. That is at most 14; 2^-48 is 32.
const ERROR: f64 = f64::from_bits((1023 - 48) << 52);
/// More than what underflow may add to a few such terms.
const TINY: f64 = f64::MIN_POSITIVE;

/// A distance whose square does not underflow.
const LEAST_LENGTH: f64 = f64::from_bits((1023 - 400) << 52);

/// A plane with a unit normal, rounded.
///
/// A plane whose normal has a coordinate beyond the range of `f64`, or is zero, bounds nothing.
///
/// ```
/// use exact::proximity::{DepthPlane, DepthPoint, QueryPoint};
/// use exact::{Point3, Vector3};
/// let plane = DepthPlane::new(&Vector3::from_i64([0, 0, 7]), &Point3::from_i64([4, 4, 2]));
/// assert_eq!(plane.approx_f64(), [0.0, 0.0, 1.0, 2.0]);
/// let above = QueryPoint::from_f64([0.5, 0.0, 2.25]).expect("the numbers are finite");
/// assert!(plane.depth(&DepthPoint::new(&above)).is_negative());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct DepthPlane {
    /// The unit normal and the distance from the origin, of either sign.
    values: [f64; 4],
}

/// An interval that contains a depth; unbounded where the floats say nothing.
///
/// ```
/// use exact::proximity::{DepthPlane, DepthPoint, QueryPoint};
/// use exact::{Point3, Vector3};
/// let [top, side] = [[0, 0, 1], [1, 0, 0]].map(|n| DepthPlane::new(&Vector3::from_i64(n), &Point3::from_i64([5, 0, 1])));
/// let point = DepthPoint::new(&QueryPoint::new(Point3::ORIGIN));
/// let (one, five) = (top.depth(&point), side.depth(&point));
/// assert!(one.is_positive() && one.is_below(&five));
/// // One depth is not certainly less than itself.
/// assert!(!one.is_below(&one));
/// ```
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

    /// The lower bound: for an order of work. It is not a number if there is none.
    #[inline]
    pub fn approx_low(&self) -> f64 {
        self.low
    }
}

impl DepthPlane {
    /// Takes the plane through a point with a given normal.
    ///
    /// # Complexity
    /// Constant, but for products of numbers that are wide.
    pub fn new(normal: &Vector3, on: &Point3) -> Self {
        // A power of two keeps squares in range, and the greatest of them at least one; of zero and of what is infinite, what is not a
        // number is left. What underflows is smaller than the other coordinates by far more than the error.
        let [x, y, z] = normal.approx_f64();
        let greatest = power_below(x.abs().max(y.abs()).max(z.abs()));
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
    ///
    /// # Complexity
    /// Constant.
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

/// The greatest power of two that is at most a positive integer: the exponent alone. Zero and infinity stay.
fn power_below(value: f64) -> f64 {
    f64::from_bits(value.to_bits() >> 52 << 52)
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
///
/// ```
/// use exact::proximity::{DepthPlane, DepthPoint, QueryPoint};
/// use exact::{Point3, Vector3};
/// // A coordinate may be as small as a float can be.
/// let point = QueryPoint::from_f64([1.0, 1e-320, 0.0]).expect("the numbers are finite");
/// let plane = DepthPlane::new(&Vector3::from_i64([1, 1, 0]), &Point3::from_i64([3, 0, 0]));
/// assert!(plane.depth(&DepthPoint::new(&point)).is_positive());
/// ```
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
    ///
    /// # Complexity
    /// Constant; three divisions of wide integers if the weight of the point is beyond the range of floats.
    #[inline]
    pub fn new(point: &QueryPoint) -> Self {
        // A finite number over an infinite weight would look like zero.
        let values =
            if point.floats()[3].is_finite() { point.approx_f64() } else { point.point().approx_f64() };
        let [x, y, z] = values;
        let length = (x * x + y * y + z * z).sqrt() * (1.0 + ROUNDING);
        let length = if length < LEAST_LENGTH { LEAST_LENGTH } else { length };
        let square = length * length * (1.0 + ROUNDING);
        Self { values, sum: x.abs() + y.abs() + z.abs(), length, square }
    }
}

/// A cap of the sphere that contains the unit normals of some planes, and the least of their offsets.
///
/// ```
/// use exact::proximity::{DepthCap, DepthPlane, DepthPoint, QueryPoint};
/// use exact::{Point3, Vector3};
/// let corner = Point3::from_i64([2, 2, 2]);
/// let planes = [[0, 0, 1], [1, 0, 9], [0, 1, 9]].map(|n| DepthPlane::new(&Vector3::from_i64(n), &corner));
/// let point = DepthPoint::new(&QueryPoint::new(Point3::from_i64([0, 0, -1])));
/// let bounds = DepthCap::of(planes.iter()).least_depth(&point);
/// assert!(bounds.approx_low() > 2.0);
/// assert!(planes.iter().all(|plane| !plane.depth(&point).is_below(&bounds)));
/// ```
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

/// By this the cosines are less than computed: 256 u. The axis and the unit normals have lengths of 1 up to 3.5 and 5.5 u, and the three products
/// with their sums add 3: a cosine is wrong by at most 12 u. So the angle t of the cap is greater than that of any of its normals, and at least
/// 2^-22, also if there is one normal only.
const SLACK: f64 = f64::from_bits((1023 - 45) << 52);
/// 16 u: more than the errors of a few sums of squares of coordinates of unit vectors, and of the root of one.
///
/// Three squares, their sums and the root have 2.5 u, so a length that is increased by it is at least |s| (1 + 12 u), and its square,
/// increased again, at least |s|^2 (1 + 38 u). The square of the sine of a cap has at most 3 u of rounding, and more of this is added.
const ROUNDING: f64 = f64::from_bits((1023 - 49) << 52);

impl DepthCap {
    /// Gives a small cap that contains the planes, around the mean of their normals.
    ///
    /// # Complexity
    /// Linear in the number of planes.
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
    /// With the angle f between the axis and the point s, and t the angle of the cap, no normal n of the cap has a greater n . s
    /// than |s| cos(f - t), or |s| if f <= t.
    ///
    /// # Complexity
    /// Constant.
    #[inline]
    // In units u of rounding, see `ROUNDING`. The product of axis and point, |s| cos f, is wrong by at most 6.5 u |s|, its square by
    // 13, and 2 more are added by rounding; the square of the point is too great by 38. So what is left is at least |s|^2 sin^2 f, and its root,
    // too, although the sine is not well conditioned where it is small. The cosine of the cap is that of t, and its sine is not less than
    // that of t. So the reach falls short of |s| cos(f - t) by 6.5 and by 4 for two products and their sum; the lengths
    // of unit normals add 5.5. A depth of the rounded plane and the rounded point is wrong by 8.5 (see `ERROR`: the coordinates of the normal are
    // counted already), and the two subtractions below by 2. In all 27.
    //
    // Where rounding takes an f less than t for a greater one, cos f is at most cos t + 28 u: so t - f is at most 2^-25, since t is
    // at least 2^-22, and cos(f - t) is at least 1 - 3 u: in all 30, and `ERROR` is 32. Near t = pi that does not happen, as the length is rounded up.
    // To take an f greater than t for a smaller one only makes the bound less.
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

/// Compares how deep a point lies below two planes, given by normals and points on them.
///
/// The point must not be above either of them: that is not checked, and of a point above a plane the height is compared.
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
