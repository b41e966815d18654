//! Integers of any size: a newtype over `dashu_int::IBig`, the only module besides `rational` that names dashu.

use crate::Sign;
use crate::parse::{self, ParseNumberError};
use crate::tier::Ring;
use dashu_int::ops::{DivRem, Gcd, SquareRoot, UnsignedAbs};
use dashu_int::{IBig, UBig, Word};
use std::fmt;
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Shl, Shr, Sub, SubAssign};
use std::str::FromStr;

/// An integer of any size. Values below 128 bits need no heap.
///
/// ```
/// use exact::{Integer, Sign};
/// let a: Integer = "-123456789012345678901234567890".parse()?;
/// assert_eq!((&a + &Integer::from(1)).to_string(), "-123456789012345678901234567889");
/// assert_eq!(a.sign(), Sign::Negative);
/// assert_eq!(Integer::from(12).gcd(&Integer::from(-18)), Integer::from(6));
/// # Ok::<(), exact::ParseNumberError>(())
/// ```
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Integer(pub(crate) IBig);

impl Integer {
    /// Zero.
    pub const ZERO: Self = Self(IBig::ZERO);
    /// One.
    pub const ONE: Self = Self(IBig::ONE);

    /// Gives the sign.
    #[inline]
    pub fn sign(&self) -> Sign {
        if self.0.is_zero() {
            Sign::Zero
        } else if self.0.as_sign_words().0 == dashu_int::Sign::Negative {
            Sign::Negative
        } else {
            Sign::Positive
        }
    }

    /// Tells whether this is zero.
    #[inline]
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// Gives the number of bits of the magnitude: 0 for 0, 1 for 1 and -1, 2 for 3, 3 for -4.
    pub fn bit_len(&self) -> u32 {
        let words = self.0.as_sign_words().1;
        words.last().map_or(0, |top| words.len() as u32 * Word::BITS - top.leading_zeros())
    }

    /// Gives the magnitude.
    pub fn abs(&self) -> Self {
        Self(self.magnitude().into())
    }

    /// Gives the greatest common divisor of the magnitudes; `gcd(0, n)` is the magnitude of n, `gcd(0, 0)` is 0.
    pub fn gcd(&self, other: &Self) -> Self {
        if self.is_zero() {
            return other.abs();
        }
        if other.is_zero() {
            return self.abs();
        }
        Self((&self.0).gcd(&other.0).into())
    }

    /// Gives the least common multiple of the magnitudes; 0 if one of them is 0.
    pub fn lcm(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        (self.div_exact(&self.gcd(other)) * other).abs()
    }

    /// Divides by a divisor.
    ///
    /// # Panics
    /// If `divisor` is zero; in debug builds if the division leaves a remainder.
    pub fn div_exact(&self, divisor: &Self) -> Self {
        let (quotient, remainder) = self.div_rem(divisor);
        debug_assert!(remainder.is_zero(), "div_exact by a number that does not divide");
        quotient
    }

    /// Divides with remainder: the quotient is rounded towards zero, the remainder has the sign of `self`.
    ///
    /// # Panics
    /// If `divisor` is zero.
    pub fn div_rem(&self, divisor: &Self) -> (Self, Self) {
        let (quotient, remainder) = (&self.0).div_rem(&divisor.0);
        (Self(quotient), Self(remainder))
    }

    /// Gives the greatest integer that is not above `self / divisor`.
    ///
    /// # Panics
    /// If `divisor` is zero.
    pub fn div_floor(&self, divisor: &Self) -> Self {
        let (quotient, remainder) = self.div_rem(divisor);
        if remainder.sign() * divisor.sign() == Sign::Negative { quotient - Self::ONE } else { quotient }
    }

    /// Gives the integer nearest to `self / divisor`; of two equally near, the one with the greater magnitude.
    ///
    /// # Panics
    /// If `divisor` is zero.
    pub fn div_round(&self, divisor: &Self) -> Self {
        let twice = Self::from(2) * divisor.abs();
        let quotient = (Self::from(2) * self.abs() + divisor.abs()).div_rem(&twice).0;
        if self.sign() * divisor.sign() == Sign::Negative { -quotient } else { quotient }
    }

    /// Raises to a power; anything to the power 0 is 1.
    pub fn pow(&self, exponent: u32) -> Self {
        Self(self.0.pow(exponent as usize))
    }

    /// Gives the greatest integer whose square is not above `self`; `None` for a negative number.
    pub fn sqrt_floor(&self) -> Option<Self> {
        (self.sign() >= Sign::Zero).then(|| Self(self.magnitude().sqrt().into()))
    }

    /// Gives the value if it fits.
    #[inline]
    pub fn to_i64(&self) -> Option<i64> {
        i64::try_from(&self.0).ok()
    }

    /// Gives the value if it fits.
    #[inline]
    pub fn to_i128(&self) -> Option<i128> {
        i128::try_from(&self.0).ok()
    }

    /// Rounds to the nearest `f64`, ties to even; infinite beyond the range of `f64`.
    pub fn approx_f64(&self) -> f64 {
        let (sign, words) = self.0.as_sign_words();
        let per_chunk = (128 / Word::BITS) as usize;
        let rest = words.len().saturating_sub(per_chunk);
        let mut top = 0_u128;
        for &word in words[rest..].iter().rev() {
            top = (top << Word::BITS) | u128::from(word);
        }
        // The top chunk has more than 64 bits when there is a rest, so its lowest bit only breaks ties.
        top |= u128::from(words[..rest].iter().any(|&word| word != 0));
        let scale = rest as u32 * Word::BITS;
        let value = if scale > 1023 {
            f64::INFINITY
        } else {
            top as f64 * f64::from_bits(u64::from(scale + 1023) << 52)
        };
        if sign == dashu_int::Sign::Negative { -value } else { value }
    }

    pub(crate) fn magnitude(&self) -> UBig {
        (&self.0).unsigned_abs()
    }
}

impl Ring for Integer {
    #[inline]
    fn verdict(&self) -> Option<Sign> {
        Some(self.sign())
    }
}

macro_rules! from_machine {
    ($($t:ty),*) => { $(
        impl From<$t> for Integer {
            #[inline]
            fn from(value: $t) -> Self {
                Self(IBig::from(value))
            }
        }
    )* };
}
from_machine!(i8, i16, i32, i64, i128, isize, u8, u16, u32, u64, u128, usize);

/// Writes the operators of a newtype for all four ways of owning the operands.
macro_rules! operators {
    ($ty:ident: $($trait:ident $method:ident),*) => { $(
        impl $trait<$ty> for $ty {
            type Output = $ty;
            #[inline]
            fn $method(self, other: $ty) -> $ty { $ty(self.0.$method(other.0)) }
        }
        impl $trait<&$ty> for $ty {
            type Output = $ty;
            #[inline]
            fn $method(self, other: &$ty) -> $ty { $ty(self.0.$method(&other.0)) }
        }
        impl $trait<$ty> for &$ty {
            type Output = $ty;
            #[inline]
            fn $method(self, other: $ty) -> $ty { $ty((&self.0).$method(other.0)) }
        }
        impl $trait<&$ty> for &$ty {
            type Output = $ty;
            #[inline]
            fn $method(self, other: &$ty) -> $ty { $ty((&self.0).$method(&other.0)) }
        }
    )* };
}
/// The assigning operators and the negation of a newtype.
macro_rules! assigning {
    ($ty:ident: $($trait:ident $method:ident),*) => {
        $(
            impl $trait<$ty> for $ty {
                #[inline]
                fn $method(&mut self, other: $ty) { self.0.$method(other.0); }
            }
            impl $trait<&$ty> for $ty {
                #[inline]
                fn $method(&mut self, other: &$ty) { self.0.$method(&other.0); }
            }
        )*
        impl Neg for $ty {
            type Output = $ty;
            #[inline]
            fn neg(self) -> $ty { $ty(-self.0) }
        }
        impl Neg for &$ty {
            type Output = $ty;
            #[inline]
            fn neg(self) -> $ty { $ty(-&self.0) }
        }
        impl std::iter::Sum for $ty {
            fn sum<I: Iterator<Item = $ty>>(items: I) -> $ty {
                items.fold($ty::ZERO, |sum, item| sum + item)
            }
        }
    };
}
pub(crate) use {assigning, operators};

operators!(Integer: Add add, Sub sub, Mul mul);
assigning!(Integer: AddAssign add_assign, SubAssign sub_assign, MulAssign mul_assign);

impl Shl<u32> for Integer {
    type Output = Integer;
    /// Multiplies by a power of two.
    fn shl(self, bits: u32) -> Integer {
        Integer(self.0 << bits as usize)
    }
}

impl Shr<u32> for Integer {
    type Output = Integer;
    /// Divides by a power of two, rounded down.
    fn shr(self, bits: u32) -> Integer {
        Integer(self.0 >> bits as usize)
    }
}

impl fmt::Display for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl fmt::Debug for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl FromStr for Integer {
    type Err = ParseNumberError;

    /// Reads an optional sign and decimal digits, nothing else.
    ///
    /// # Errors
    /// [`ParseNumberError`] with the token.
    fn from_str(token: &str) -> Result<Self, ParseNumberError> {
        parse::integer(token)
    }
}

#[cfg(test)]
mod tests;
