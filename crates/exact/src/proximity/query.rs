//! The point of a query, and planes as floats.

use crate::filter::Filtered;
use crate::rational::approx_quotient;
use crate::stage::{Stage, count};
use crate::tier::Ring;
use crate::{Integer, Point3, Sign, Vector3};
use std::sync::OnceLock;

/// A point about which is asked, with the floats that a filter reads. Its exact form is made when it is needed.
///
/// ```
/// use exact::proximity::{PlaneFloats, QueryPoint};
/// use exact::{Point3, Sign, Vector3};
/// let plane = PlaneFloats::new(&Vector3::from_i64([0, 0, 3]), &Point3::from_i64([5, 5, 1]));
/// let point = QueryPoint::from_f64([0.1, 0.2, 0.75]).expect("the numbers are finite");
/// assert_eq!(plane.side(&point), Some(Sign::Negative));
/// assert_eq!(point.point().coordinate(2).to_string(), "3/4");
/// ```
#[derive(Clone, Debug)]
pub struct QueryPoint {
    /// x, y, z, w, each the float nearest to an integer, all times the same power of two.
    floats: [f64; 4],
    exact: OnceLock<Point3>,
}

/// Bounds of the magnitude of a float coordinate that is used as it stands: the last bit of the least of them weighs 2^-352, so
/// that no product of it with an integer underflows. The filter needs no more: multiplied by 2^352 everything is an integer.
const LEAST: f64 = f64::from_bits((1023 - 300) << 52);
const GREATEST: f64 = f64::from_bits((1023 + 300) << 52);

impl QueryPoint {
    /// Takes a point.
    pub fn new(point: Point3) -> Self {
        let floats = point.approx_homogeneous();
        let floats = if floats.iter().all(|value| value.is_finite()) { floats } else { reduced(&point) };
        Self { floats, exact: OnceLock::from(point) }
    }

    /// Takes the point whose coordinates are these floats, each the dyadic rational that it is; `None` if one is not finite.
    #[inline]
    // tidy: pub f64, because a float comes in through an exact conversion
    pub fn from_f64(coordinates: [f64; 3]) -> Option<Self> {
        // Exactly zero is meant.
        let is_usual = |value: f64| value == 0.0 || (LEAST..GREATEST).contains(&value.abs());
        let [x, y, z] = coordinates;
        if is_usual(x) && is_usual(y) && is_usual(z) {
            return Some(Self { floats: [x, y, z, 1.0], exact: OnceLock::new() });
        }
        Point3::from_f64s(coordinates).map(Self::new)
    }

    /// Gives the exact point.
    pub fn point(&self) -> &Point3 {
        self.exact.get_or_init(|| {
            let [x, y, z, _] = self.floats;
            // What is made later has been given as floats, with weight one.
            Point3::from_f64s([x, y, z]).expect("the floats are finite")
        })
    }

    /// The floats x, y, z, w that a filter reads.
    #[inline(always)]
    pub(crate) fn floats(&self) -> &[f64; 4] {
        &self.floats
    }

    /// Gives coordinates near those of the point; infinite or not numbers beyond the range of `f64`.
    #[inline]
    pub fn approx_f64(&self) -> [f64; 3] {
        let [x, y, z, w] = self.floats;
        [x / w, y / w, z / w]
    }
}

/// The floats nearest to the homogeneous coordinates of a point, times 2^-300: for weights beyond the range of floats. No coordinate
/// but zero is less than [`LEAST`].
#[cold]
fn reduced(point: &Point3) -> [f64; 4] {
    let divisor = Integer::ONE << 300_u32;
    point.homogeneous().map(|value| {
        let magnitude = approx_quotient(&value.abs(), &divisor);
        if value.sign() == Sign::Negative { -magnitude } else { magnitude }
    })
}

/// A plane as four floats: the filter alone.
///
/// ```
/// use exact::proximity::{PlaneFloats, QueryPoint};
/// use exact::{Point3, Sign, Vector3};
/// let plane = PlaneFloats::new(&Vector3::from_i64([1, 1, 1]), &Point3::from_i64([1, 0, 0]));
/// assert_eq!(plane.side(&QueryPoint::new(Point3::from_i64([1, 1, 0]))), Some(Sign::Positive));
/// // A point of the plane is left to the exact predicate, unless the floats have no error.
/// let near = QueryPoint::from_f64([1.0, 1e-30, 0.0]).expect("the numbers are finite");
/// assert_eq!(plane.side(&near), None);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PlaneFloats([f64; 4]);

impl PlaneFloats {
    /// Takes the plane through a point with a given normal.
    ///
    /// # Complexity
    /// Constant, but for products of numbers that are wide.
    pub fn new(normal: &Vector3, on: &Point3) -> Self {
        if let (Some([a, b, c]), Some([x, y, z, w])) = (normal.to_i128(), on.as_narrow())
            && normal.bits() + on.bits() + 2 < 127
        {
            let [x, y, z, w] = [*x, *y, *z, *w].map(i128::from);
            return Self([a * w, b * w, c * w, -(a * x + b * y + c * z)].map(|value| value as f64));
        }
        let [a, b, c] = normal.coordinates();
        let [x, y, z, w] = on.homogeneous();
        let offset: Integer = &a * &x + &b * &y + &c * &z;
        Self([a * &w, b * &w, c * &w, -offset].map(|value| value.approx_f64()))
    }

    /// Tells on which side of the plane a point lies, as [`plane_side`](crate::predicate::plane_side) does with the exact plane;
    /// `None` where the floats cannot tell.
    ///
    /// # Complexity
    /// Constant: degree 3 in normal, offset and point.
    #[inline]
    pub fn side(&self, point: &QueryPoint) -> Option<Sign> {
        if crate::stage::are_boxes_skipped() {
            return None;
        }
        let [a, b, c, d] = self.0.map(Filtered::of_nearest);
        let [x, y, z, w] = point.floats().map(Filtered::of_nearest);
        let verdict = ((a * x + b * y) + (c * z + d * w)).verdict();
        if verdict.is_some() {
            count(Stage::Float);
        }
        verdict
    }
}
