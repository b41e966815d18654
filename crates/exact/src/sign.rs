//! The three-valued answer of every predicate.

use std::cmp::Ordering;
use std::ops::{Mul, Neg};

/// The sign of an exact number: the answer of a predicate.
///
/// Ordered as the numbers -1, 0, 1; multiplied as they are.
///
/// ```
/// use exact::Sign;
/// assert_eq!(-Sign::Positive * Sign::Negative, Sign::Positive);
/// assert!(Sign::Negative < Sign::Zero);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[repr(i8)]
pub enum Sign {
    /// Below zero.
    Negative = -1,
    /// Exactly zero.
    Zero = 0,
    /// Above zero.
    Positive = 1,
}

impl Sign {
    /// Gives the sign of a machine integer.
    #[inline]
    pub const fn of_i64(value: i64) -> Self {
        if value > 0 {
            Self::Positive
        } else if value < 0 {
            Self::Negative
        } else {
            Self::Zero
        }
    }

    /// Gives the sign of a double-width machine integer.
    #[inline]
    pub const fn of_i128(value: i128) -> Self {
        if value > 0 {
            Self::Positive
        } else if value < 0 {
            Self::Negative
        } else {
            Self::Zero
        }
    }

    /// Tells whether the number is zero.
    #[inline]
    pub const fn is_zero(self) -> bool {
        matches!(self, Self::Zero)
    }

    /// Tells whether the number is above zero.
    #[inline]
    pub const fn is_positive(self) -> bool {
        matches!(self, Self::Positive)
    }

    /// Tells whether the number is below zero.
    #[inline]
    pub const fn is_negative(self) -> bool {
        matches!(self, Self::Negative)
    }

    /// Gives the comparison of the number with zero.
    #[inline]
    pub const fn ordering(self) -> Ordering {
        match self {
            Self::Negative => Ordering::Less,
            Self::Zero => Ordering::Equal,
            Self::Positive => Ordering::Greater,
        }
    }
}

impl From<Ordering> for Sign {
    #[inline]
    fn from(ordering: Ordering) -> Self {
        match ordering {
            Ordering::Less => Self::Negative,
            Ordering::Equal => Self::Zero,
            Ordering::Greater => Self::Positive,
        }
    }
}

impl Neg for Sign {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        match self {
            Self::Negative => Self::Positive,
            Self::Zero => Self::Zero,
            Self::Positive => Self::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        match self {
            Self::Negative => -other,
            Self::Zero => Self::Zero,
            Self::Positive => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_multiply_and_order_as_numbers() {
        let all = [Sign::Negative, Sign::Zero, Sign::Positive];
        for a in all {
            assert_eq!(Sign::of_i64(a as i64), a);
            assert_eq!(Sign::of_i128(-(a as i128)), -a);
            assert_eq!(Sign::from(a.ordering()), a);
            for b in all {
                assert_eq!(a * b, Sign::of_i64(a as i64 * b as i64));
                assert_eq!(a.cmp(&b), (a as i64).cmp(&(b as i64)));
            }
        }
        assert_eq!(Sign::of_i64(i64::MIN), Sign::Negative);
        assert_eq!(Sign::of_i128(i128::MIN), Sign::Negative);
    }
}
