//! What floats tell of directions and circles.
//!
//! A *box* is an array of floats P and an error e of a vector p, a positive multiple of the one that is meant, such that |p_i - P_i| is at
//! most 4/5 e; zero if P is p. All floats are near to integers below 2^126 in magnitude, so that no product here overflows. Other than
//! zero they are at least 1/2, and errors are zero or at least 2^-52: so none underflows.

use super::Direction;
use crate::Sign;
use crate::stage::{Stage, are_boxes_skipped, count};

/// Half the distance from 1 to the next `f64`.
const UNIT: f64 = f64::EPSILON / 2.0;

#[inline(always)]
fn decided(value: f64, bound: f64) -> Option<Sign> {
    // The branch is on being decided, which is predictable; a branch on the sign is not.
    if value.abs() > bound {
        count(Stage::Float);
        Some(if value > 0.0 { Sign::Positive } else { Sign::Negative })
    } else {
        None
    }
}

/// The sign of one coordinate, given the error of its box.
#[inline(always)]
pub(super) fn sign_of_coordinate(value: f64, error: f64) -> Option<Sign> {
    decided(value, error).or_else(|| (error == 0.0).then_some(Sign::Zero))
}

/// The sign of p0 q1 - p1 q0 by parts of two boxes, if they tell.
///
/// # Proof
/// u = 2^-53, M = |P0 Q1| + |P1 Q0|. With P, Q in place of p, q the value changes by at most 4/5 e (|Q0| + |Q1|) + 4/5 f (|P0| + |P1|) + 2 (4/5)^2 e f,
/// where e, f are the errors. Evaluation adds at most ((1 + u)^2 - 1) M. The bound has e (|Q0| + |Q1| + 2 f) + f (|P0| + |P1|) + 4 u M instead, which
/// is greater by a factor of 5/4 at least, and loses less than seven roundings.
#[inline(always)]
pub(super) fn cross_of_boxes(([p0, p1], e): ([f64; 2], f64), ([q0, q1], f): ([f64; 2], f64)) -> Option<Sign> {
    let (left, right) = (p0 * q1, p1 * q0);
    let magnitude = left.abs() + right.abs();
    let spread = e * (q0.abs() + q1.abs() + 2.0 * f) + f * (p0.abs() + p1.abs());
    decided(left - right, spread + 4.0 * UNIT * magnitude)
}

/// The sign of n . p by two boxes, if they tell.
///
/// # Proof
/// As above, with S = |N0| + |N1| + |N2|, T = |P0| + |P1| + |P2|, and M the sum of the magnitudes of the three products: 4/5 e S + 4/5 f T + 3 (4/5)^2 e f, and
/// ((1 + u)^3 - 1) M of evaluation. The bound is e (S + 3 f) + f T + 6 u M.
#[inline(always)]
pub(super) fn dot_of_boxes((p, e): ([f64; 3], f64), (n, f): ([f64; 3], f64)) -> Option<Sign> {
    let [x, y, z] = [n[0] * p[0], n[1] * p[1], n[2] * p[2]];
    let magnitude = x.abs() + y.abs() + z.abs();
    let spread = e * (sum_of_magnitudes(n) + 3.0 * f) + f * sum_of_magnitudes(p);
    decided(x + y + z, spread + 6.0 * UNIT * magnitude)
}

#[inline(always)]
fn sum_of_magnitudes([x, y, z]: [f64; 3]) -> f64 {
    x.abs() + y.abs() + z.abs()
}

/// Half the distance from 1 to the next `f32`.
const UNIT_32: f64 = (f32::EPSILON / 2.0) as f64;

/// Tells on which side of a circle a point lies by the [side key](super::GreatCircle::side_key) of the circle; `None` if it cannot tell, as it never
/// can for a point on the circle.
///
/// # Proof
/// As for a dot product of boxes, but N are `f32`s, rounded from the box of the normal, whose error is at most 2^-51 of its greatest coordinate, hence at
/// most 2^-50 S. Rounding to an `f32` adds at most v = 2^-24 of the coordinate: below 2^63, it has no overflow. What is subnormal as an `f32`, in a wide
/// normal, where S is at least 2^60, is off by 2^-149 at most, below 2^-200 S. So n differs from N by at most v (1 + 2 v) |N| and 2^-50 S (1 + 2^-150), and the
/// value by at most v (1 + 2 v) M and 2^-50 S T (1 + 2^-150). The bound has 2 v M and 2^-49 S T, and e S as before.
///
/// ```
/// use exact::spherical::{Direction, GreatCircle, side_of_key};
/// let key = GreatCircle::from_i64([1, -2, 3]).expect("not zero").side_key();
/// let [p, on] = [[0, 0, 1], [2, 1, 0]].map(|p| Direction::from_i64(p).expect("not zero"));
/// assert_eq!(side_of_key(&p, &key), Some(exact::Sign::Positive));
/// assert_eq!(side_of_key(&on, &key), None);
/// assert_eq!(side_of_key(&p, &[0; 3]), None);
/// ```
#[inline]
pub fn side_of_key(p: &Direction, key: &[u32; 3]) -> Option<Sign> {
    let n = key.map(|bits| f64::from(f32::from_bits(bits)));
    let p_error = p.error;
    let p = p.approx;
    let [x, y, z] = [n[0] * p[0], n[1] * p[1], n[2] * p[2]];
    let magnitude = x.abs() + y.abs() + z.abs();
    let spread = sum_of_magnitudes(n) * (p_error + 16.0 * UNIT * sum_of_magnitudes(p));
    if are_boxes_skipped() {
        return None;
    }
    decided(x + y + z, spread + 2.0 * UNIT_32 * magnitude)
}
