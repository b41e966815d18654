//! Points of the sphere, and the boxes of floats around them.

use super::circle::{approx_scaled, bits_of, product, reduced};
use super::decide;
use super::{GreatCircle, NARROW_BITS, predicates};
use crate::stage::{Stage, are_boxes_skipped, count, is_forced};
use crate::{Integer, Quaternion, Rational, Sign, Vector3};
use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

/// A point of the sphere: the direction of an integer vector, or one of the two points where two great circles cross.
///
/// It holds what defines it and floats near to it; coordinates of a crossing are made when somebody asks. Two directions are equal if one
/// vector is a positive multiple of the other, however they are defined.
///
/// ```
/// use exact::spherical::{Direction, GreatCircle};
/// let [m, n] = [[1, 0, -1], [0, 1, -1]].map(|n| GreatCircle::from_i64(n).expect("not zero"));
/// let p = Direction::crossing(&m, &n).expect("two circles");
/// assert_eq!(p, Direction::from_i64([7, 7, 7]).expect("not zero"));
/// assert_eq!(Direction::crossing(&n, &m), Some(p.opposite()));
/// assert_eq!(Direction::crossing(&n, &n.opposite()), None);
/// ```
#[derive(Clone)]
pub struct Direction {
    /// Near to a positive multiple of the vector: see [`super::boxes`].
    pub(super) approx: [f64; 3],
    pub(super) error: f64,
    pub(super) repr: Repr,
}

#[derive(Clone)]
pub(super) enum Repr {
    /// Coordinates below 2^62 in magnitude, perhaps with a common divisor.
    Explicit([i64; 3]),
    /// Two normals, whose vector product this is, with coordinates below 2^`bits`. Both are *upper* ones, so that every circle has one normal here.
    Crossing { bits: u8, normals: [[i64; 3]; 2] },
    /// Coprime coordinates.
    Wide(Arc<[Integer; 3]>),
}

const _: () = assert!(size_of::<Direction>() <= 96);

/// Half the distance from 1 to the next `f64`.
const UNIT: f64 = f64::EPSILON / 2.0;

/// Tells whether the last coordinate that is not zero is positive.
#[inline(always)]
fn is_upper([x, y, z]: &[i64; 3]) -> bool {
    *z > 0 || (*z == 0 && (*y > 0 || (*y == 0 && *x > 0)))
}

impl Direction {
    /// The pole (0, 0, -1).
    pub const SOUTH: Self = Self { approx: [0.0, 0.0, -1.0], error: 0.0, repr: Repr::Explicit([0, 0, -1]) };

    /// The pole (0, 0, 1).
    pub const NORTH: Self = Self { approx: [0.0, 0.0, 1.0], error: 0.0, repr: Repr::Explicit([0, 0, 1]) };

    /// Makes the direction of a vector; `None` if that is zero.
    pub fn new(coordinates: [Integer; 3]) -> Option<Self> {
        if let [Some(x), Some(y), Some(z)] = coordinates.each_ref().map(Integer::to_i64) {
            return Self::from_i64([x, y, z]);
        }
        let [x, y, z] = coordinates;
        let divisor = x.gcd(&y).gcd(&z);
        let coordinates = [x, y, z].map(|value| value.div_exact(&divisor));
        if let [Some(x), Some(y), Some(z)] = coordinates.each_ref().map(Integer::to_i64)
            && bits_of(&[x, y, z]) <= NARROW_BITS
        {
            return Some(Self::explicit([x, y, z]));
        }
        Some(Self::wide(coordinates))
    }

    /// Makes the direction of a vector of machine integers; `None` if that is zero.
    pub fn from_i64(coordinates: [i64; 3]) -> Option<Self> {
        let coordinates = reduced(coordinates)?;
        Some(if bits_of(&coordinates) <= NARROW_BITS {
            Self::explicit(coordinates)
        } else {
            Self::wide(coordinates.map(Integer::from))
        })
    }

    /// Makes the direction of a vector of rationals; `None` if that is zero.
    ///
    /// ```
    /// use exact::spherical::Direction;
    /// let vector = [1, 0, -2].map(|n| exact::Rational::new(n.into(), 6.into()).expect("not divided by zero"));
    /// assert_eq!(Direction::from_rationals(&vector).expect("not zero").to_string(), "(1, 0, -2)");
    /// ```
    pub fn from_rationals(coordinates: &[Rational; 3]) -> Option<Self> {
        let weight = coordinates.iter().fold(Integer::ONE, |weight, value| weight.lcm(&value.denominator()));
        Self::new(
            coordinates.each_ref().map(|value| value.numerator() * weight.div_exact(&value.denominator())),
        )
    }

    /// Narrow coordinates, not all zero.
    #[inline]
    fn explicit(coordinates: [i64; 3]) -> Self {
        let bits = bits_of(&coordinates);
        let is_exact = bits <= f64::MANTISSA_DIGITS;
        // Each is off by u 2^bits at most.
        let error = if is_exact { 0.0 } else { 2.0 * UNIT * (1_u64 << bits) as f64 };
        Self { approx: coordinates.map(|value| value as f64), error, repr: Repr::Explicit(coordinates) }
    }

    /// Coprime coordinates that are not all narrow.
    #[cold]
    fn wide(coordinates: [Integer; 3]) -> Self {
        let (approx, error) = approx_scaled(&coordinates);
        Self { approx, error, repr: Repr::Wide(Arc::new(coordinates)) }
    }

    /// Makes the point in the direction of m x n, where circle m, seen from outside, goes over to the right side of n; `None` if the circles have the
    /// same points.
    ///
    /// If both are narrow nothing is allocated: they are kept, or the coordinates if these are narrow. So two meridians cross in an explicit pole.
    #[inline]
    pub fn crossing(m: &GreatCircle, n: &GreatCircle) -> Option<Self> {
        let (Some((m, j)), Some((n, k))) = (m.as_narrow(), n.as_narrow()) else {
            return Self::wide_crossing(m, n);
        };
        let vector = decide::cross_i128(m, n);
        let bits = vector.iter().fold(0, |all, value| all | value.unsigned_abs());
        if bits == 0 {
            return None;
        }
        if bits >> NARROW_BITS == 0 && (!is_forced() || (vector[0] == 0 && vector[1] == 0)) {
            return Some(Self::explicit(vector.map(|value| value as i64)));
        }
        let approx = vector.map(nearest);
        // Each is off by u of itself.
        let error = 2.0 * UNIT * approx[0].abs().max(approx[1].abs()).max(approx[2].abs());
        let upper = |normal: &[i64; 3]| match is_upper(normal) {
            true => *normal,
            false => normal.map(|value| -value),
        };
        let turns = is_upper(m) != is_upper(n);
        let normals = if turns { [upper(n), upper(m)] } else { [upper(m), upper(n)] };
        Some(Self { approx, error, repr: Repr::Crossing { bits: j.max(k) as u8, normals } })
    }

    #[cold]
    fn wide_crossing(m: &GreatCircle, n: &GreatCircle) -> Option<Self> {
        Self::new(crate::predicate::cross(m.coordinates(), n.coordinates()))
    }

    /// The coordinates of a narrow explicit direction.
    #[inline(always)]
    pub(crate) fn as_narrow(&self) -> Option<&[i64; 3]> {
        match &self.repr {
            Repr::Explicit(coordinates) => Some(coordinates),
            _ => None,
        }
    }

    /// The normals whose vector product this is, if it is held so.
    #[inline]
    pub(crate) fn crossing_normals(&self) -> Option<&[[i64; 3]; 2]> {
        match &self.repr {
            Repr::Crossing { normals, .. } => Some(normals),
            _ => None,
        }
    }

    /// A positive multiple of the primitive vector.
    pub(super) fn multiple(&self) -> [Integer; 3] {
        match &self.repr {
            Repr::Explicit(coordinates) => coordinates.map(Integer::from),
            Repr::Crossing { normals: [m, n], .. } => decide::cross_i128(m, n).map(Integer::from),
            Repr::Wide(coordinates) => <[Integer; 3]>::clone(coordinates),
        }
    }

    /// Gives the coprime coordinates of the direction.
    pub fn coordinates(&self) -> [Integer; 3] {
        let [x, y, z] = self.multiple();
        let divisor = x.gcd(&y).gcd(&z);
        [x, y, z].map(|value| value.div_exact(&divisor))
    }

    /// Gives the coprime coordinates as a vector.
    pub fn vector(&self) -> Vector3 {
        Vector3::new(self.coordinates())
    }

    /// Tells whether the direction is held by its coordinates and not by two circles.
    ///
    /// Crossings of wide circles are, and those that have small coordinates.
    #[inline]
    pub fn is_explicit(&self) -> bool {
        !matches!(self.repr, Repr::Crossing { .. })
    }

    /// Tells whether this is the south or the north pole, and which: the sign of z; zero for all others.
    #[inline]
    pub fn pole_sign(&self) -> Sign {
        // A float beyond the error tells that it is no pole.
        let [x, y, _] = self.approx;
        if x.abs() > self.error || y.abs() > self.error {
            return Sign::Zero;
        }
        let [x, y, z] = [0, 1, 2].map(|axis| predicates::coordinate_sign(self, axis));
        if x.is_zero() && y.is_zero() { z } else { Sign::Zero }
    }

    /// Compares the magnitudes of two coordinates; axes are counted 0, 1, 2.
    ///
    /// # Panics
    /// If an axis is not below 3.
    ///
    /// # Complexity
    /// Degree 2 for a crossing, after the filter on its box.
    ///
    /// ```
    /// use exact::spherical::Direction;
    /// let p = Direction::from_i64([2, -3, 3]).expect("not zero");
    /// assert!(p.compare_magnitudes(0, 1).is_lt() && p.compare_magnitudes(1, 2).is_eq());
    /// ```
    #[inline]
    pub fn compare_magnitudes(&self, axis: usize, other: usize) -> Ordering {
        if !are_boxes_skipped() {
            // The magnitudes of the floats are as near to those of the coordinates: each within 4/5 of the error.
            let difference = self.approx[axis].abs() - self.approx[other].abs();
            if difference.abs() > 2.0 * self.error || self.error == 0.0 {
                count(Stage::Float);
                return if difference == 0.0 {
                    Ordering::Equal
                } else if difference > 0.0 {
                    Ordering::Greater
                } else {
                    Ordering::Less
                };
            }
        }
        match &self.repr {
            Repr::Explicit(coordinates) => {
                count(Stage::Narrow);
                coordinates[axis].unsigned_abs().cmp(&coordinates[other].unsigned_abs())
            }
            Repr::Crossing { normals: [m, n], .. } => {
                count(Stage::Narrow);
                let coordinates = decide::cross_i128(m, n);
                coordinates[axis].unsigned_abs().cmp(&coordinates[other].unsigned_abs())
            }
            Repr::Wide(coordinates) => {
                count(Stage::Big);
                coordinates[axis].abs().cmp(&coordinates[other].abs())
            }
        }
    }

    /// Gives the antipodal point.
    #[inline]
    pub fn opposite(&self) -> Self {
        let repr = match &self.repr {
            Repr::Explicit(coordinates) => Repr::Explicit(coordinates.map(|value| -value)),
            Repr::Crossing { bits, normals: [m, n] } => Repr::Crossing { bits: *bits, normals: [*n, *m] },
            Repr::Wide(coordinates) => Repr::Wide(Arc::new(coordinates.each_ref().map(|value| -value))),
        };
        // 0 - x keeps zeros positive.
        Self { approx: self.approx.map(|value| 0.0 - value), error: self.error, repr }
    }

    /// Gives the point turned by a rotation.
    ///
    /// A crossing of circles becomes the crossing of the turned ones.
    ///
    /// ```
    /// use exact::{Quaternion, spherical::Direction};
    /// let third = Quaternion::new([1, 1, 1, 1].map(Into::into)).expect("not zero");
    /// let p = Direction::from_i64([3, 5, 7]).expect("not zero");
    /// assert_eq!(p.turned(&third).to_string(), "(7, 3, 5)");
    /// ```
    pub fn turned(&self, rotation: &Quaternion) -> Self {
        if let Repr::Crossing { normals, .. } = &self.repr {
            let turned = |normal: &[i64; 3]| {
                GreatCircle::from_i64(*normal).expect("a normal is not zero").turned(rotation)
            };
            let [m, n] = normals.each_ref().map(turned);
            return Self::crossing(&m, &n).expect("a rotation keeps circles different");
        }
        let (rows, _) = rotation.matrix();
        Self::new(product(&rows, &self.multiple())).expect("a rotation keeps lengths")
    }

    /// Gives floats near to the unit vector in this direction.
    pub fn approx_f64(&self) -> [f64; 3] {
        let [x, y, z] = self.approx;
        // Squares of what is below 1 do not overflow.
        let greatest = x.abs().max(y.abs()).max(z.abs());
        let scaled = self.approx.map(|value| value / greatest);
        let length = scaled.iter().map(|value| value * value).sum::<f64>().sqrt();
        scaled.map(|value| value / length)
    }
}

/// The `f64` nearest to an integer; the branch spares the wide conversion.
#[inline(always)]
fn nearest(value: i128) -> f64 {
    match i64::try_from(value) {
        Ok(value) => value as f64,
        Err(_) => value as f64,
    }
}

impl PartialEq for Direction {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        predicates::is_parallel(self, other, Sign::Positive)
    }
}

impl Eq for Direction {}

impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.coordinates();
        write!(f, "({x}, {y}, {z})")
    }
}

impl fmt::Debug for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
