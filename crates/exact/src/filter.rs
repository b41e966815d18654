//! The semi-static filter: a float value beside the magnitude that bounds its error.
//!
//! A predicate is evaluated once in `f64` (`value`) and once with every term made positive (`magnitude`). How often
//! rounding happened on the worst way through the expression (`rounds`) is a constant of the expression, which the compiler
//! computes; so each predicate gets its error constant by rule, not by hand.
//!
//! # Proof
//!
//! u = 2^-53 is the unit of rounding, fl rounds to nearest, A = 1/(1-u), and V is the exact value that v approximates.
//! The invariant of a filtered number (v, m, r) whose m is finite is
//!
//! 1. |v| <= m, and
//! 2. |v - V| <= (A^r - 1) m.
//!
//! From both: |V| <= A^r m. Every v and m is an integer: leaves are, and a sum or product of integers, rounded, is one
//! again. So nothing underflows, and a nonzero m is at least 1. If m is finite then every m inside it was finite
//! (infinity stays infinity or becomes NaN), hence, by 1, so was every v.
//!
//! * *Leaf* (x, |x|, 1), x nearest to the integer X: |x - X| <= u |x| <= (A - 1) |x|.
//! * *Product* v = fl(v1 v2), m = fl(m1 m2), r = r1 + r2 + 1. Monotony of rounding gives 1. Further
//!   |v1 v2 - V1 V2| <= |v1| |v2 - V2| + |V2| |v1 - V1| <= m1 (A^r2 - 1) m2 + A^r2 m2 (A^r1 - 1) m1 = (A^(r1+r2) - 1) m1 m2,
//!   and m1 m2 <= (1+u) m <= A m, and |v - v1 v2| <= u |v| <= u m. Together
//!   |v - V| <= (u + A^(r1+r2+1) - A) m <= (A^r - 1) m, because 1 + u <= A.
//! * *Sum* v = fl(v1 + v2), m = fl(m1 + m2), r = max(r1, r2) + 1: the same with
//!   |v1 + v2 - V1 - V2| <= (A^max - 1)(m1 + m2) and m1 + m2 <= A m.
//! * *Negation* changes nothing.
//!
//! 3. *Decision.* A^r - 1 <= r u / (1 - r u) (Bernoulli). The bound that is compared is t = fl((r+1) u m) >= (r+1) u m (1-u),
//!    where (r+1) u is exact; and (r+1)(1-u)(1-ru) >= (r+1)(1 - (r+1) u) >= r as long as (r+1)^2 u <= 1. So |v| > t
//!    implies |v| > |v - V|: v has the sign of V. If m = 0 then V = 0. A NaN or infinite m decides nothing.

use crate::Sign;
use crate::tier::Ring;
use std::ops::{Add, Mul, Neg, Sub};

/// Half the distance from 1 to the next `f64`.
const UNIT: f64 = f64::EPSILON / 2.0;

/// A float value with the magnitude and the number of roundings that bound its error.
///
/// ```
/// use exact::filter::Filtered;
/// use exact::{Sign, tier::Ring};
/// let (a, b) = (Filtered::of_nearest(1e20), Filtered::of_nearest(3.0));
/// assert_eq!((a * b - b).verdict(), Some(Sign::Positive));
/// assert_eq!((a * b - b * a).verdict(), None);
/// assert_eq!((a * Filtered::of_nearest(0.0)).verdict(), Some(Sign::Zero));
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Filtered {
    value: f64,
    magnitude: f64,
    rounds: u32,
}

impl Filtered {
    /// Takes the float nearest to an integer; it may be infinite.
    #[inline(always)]
    // tidy: pub f64, because the tiers start from the cached nearest float
    pub fn of_nearest(value: f64) -> Self {
        Self { value, magnitude: value.abs(), rounds: 1 }
    }
}

impl Add for Filtered {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            magnitude: self.magnitude + other.magnitude,
            rounds: self.rounds.max(other.rounds) + 1,
        }
    }
}

impl Sub for Filtered {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Filtered {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Mul for Filtered {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            magnitude: self.magnitude * other.magnitude,
            rounds: self.rounds + other.rounds + 1,
        }
    }
}

impl Ring for Filtered {
    #[inline(always)]
    fn verdict(&self) -> Option<Sign> {
        let bound = f64::from(self.rounds + 1) * UNIT * self.magnitude;
        // The branch is on being decided, which is predictable; a branch on the sign is not.
        if self.value.abs() > bound {
            Some(if self.value > 0.0 { Sign::Positive } else { Sign::Negative })
        } else if self.magnitude == 0.0 {
            Some(Sign::Zero)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests;
