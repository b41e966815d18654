//! Closed `f64` intervals that contain the exact value: every operation rounds its bounds outward by one step.
//!
//! A result rounded to nearest lies within half a step of the exact one, so its neighbour (`next_down`, `next_up`) is a
//! bound, also where it underflows to zero, and where it overflows: the neighbour of infinity is the greatest finite
//! number. No rounding mode is touched. A zero operand is not rounded: 0 * x and 0 + x stay exact, so that sparse
//! determinants are decided here. A NaN bound (infinity minus infinity, zero times infinity) means *undecided*.

use crate::Sign;
use crate::tier::Ring;
use std::ops::{Add, Mul, Neg, Sub};

/// An interval that contains an exact value.
///
/// ```
/// use exact::interval::Interval;
/// use exact::{Sign, tier::Ring};
/// let three = Interval::of_nearest(3.0);
/// assert_eq!((three - Interval::of_nearest(2.0)).verdict(), Some(Sign::Positive));
/// assert_eq!((three - three).verdict(), None);
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Interval {
    low: f64,
    high: f64,
}

/// Integers below this bound are exact in `f64`.
const EXACT: f64 = 9_007_199_254_740_992.0;

impl Interval {
    const ZERO: Self = Self { low: 0.0, high: 0.0 };
    const UNKNOWN: Self = Self { low: f64::NAN, high: f64::NAN };

    /// Encloses the integer that was rounded to the nearest `f64`, which may be infinite.
    #[inline]
    // tidy: pub f64, because the tiers start from the cached nearest float
    pub fn of_nearest(value: f64) -> Self {
        if value.abs() < EXACT {
            // An integer of 2^53 or more rounds to 2^53 or more, so this one is the integer itself.
            Self { low: value, high: value }
        } else {
            Self { low: value.next_down(), high: value.next_up() }
        }
    }

    /// Gives the bounds; a NaN says nothing.
    pub fn approx_bounds(&self) -> [f64; 2] {
        [self.low, self.high]
    }

    #[inline]
    fn is_zero(&self) -> bool {
        // Exactly zero is the one value that the sign test needs; no tolerance is meant.
        self.low == 0.0 && self.high == 0.0
    }

    /// Takes bounds that were rounded to nearest one step outward.
    #[inline]
    fn outward(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::UNKNOWN;
        }
        Self { low: low.next_down(), high: high.next_up() }
    }
}

impl Add for Interval {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        Self::outward(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Mul for Interval {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        let corners =
            [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        // min and max drop a NaN, so it is looked for first.
        if corners.iter().any(|corner| corner.is_nan()) {
            return Self::UNKNOWN;
        }
        let low = corners[0].min(corners[1]).min(corners[2].min(corners[3]));
        let high = corners[0].max(corners[1]).max(corners[2].max(corners[3]));
        Self::outward(low, high)
    }
}

impl Ring for Interval {
    #[inline]
    fn verdict(&self) -> Option<Sign> {
        if self.low > 0.0 {
            Some(Sign::Positive)
        } else if self.high < 0.0 {
            Some(Sign::Negative)
        } else if self.is_zero() {
            Some(Sign::Zero)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests;
