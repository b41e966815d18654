//! Rational numbers in lowest terms: a newtype over `dashu_ratio::RBig`.

use crate::integer::{assigning, operators};
use crate::parse::{self, ParseNumberError};
use crate::{Integer, Sign};
use dashu_ratio::RBig;
use std::fmt;
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use std::str::FromStr;

/// A rational number in lowest terms, with a positive denominator.
///
/// ```
/// use exact::Rational;
/// let a: Rational = "-1.25".parse()?;
/// assert_eq!(a.to_string(), "-5/4");
/// assert_eq!(a, "-10/8".parse()?);
/// assert_eq!((a + Rational::from(1)).to_string(), "-1/4");
/// # Ok::<(), exact::ParseNumberError>(())
/// ```
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Rational(RBig);

/// A float that is no number: not a value to compute with exactly.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NotFinite;

impl fmt::Display for NotFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("infinity and NaN are not rational numbers")
    }
}

impl std::error::Error for NotFinite {}

impl Rational {
    /// Zero.
    pub const ZERO: Self = Self(RBig::ZERO);
    /// One.
    pub const ONE: Self = Self(RBig::ONE);

    /// Makes numerator / denominator, in lowest terms; `None` if the denominator is zero.
    pub fn new(numerator: Integer, denominator: Integer) -> Option<Self> {
        let numerator = match denominator.sign() {
            Sign::Zero => return None,
            Sign::Negative => -numerator,
            Sign::Positive => numerator,
        };
        Some(Self(RBig::from_parts(numerator.0, denominator.magnitude())))
    }

    /// Gives the numerator in lowest terms; it carries the sign.
    pub fn numerator(&self) -> Integer {
        Integer(self.0.numerator().clone())
    }

    /// Gives the denominator in lowest terms, a positive number.
    pub fn denominator(&self) -> Integer {
        Integer(self.0.denominator().clone().into())
    }

    /// Gives the sign.
    pub fn sign(&self) -> Sign {
        if self.0.is_zero() {
            Sign::Zero
        } else if self.0.numerator().as_sign_words().0 == dashu_int::Sign::Negative {
            Sign::Negative
        } else {
            Sign::Positive
        }
    }

    /// Tells whether this is zero.
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// Tells whether the denominator is 1.
    pub fn is_integer(&self) -> bool {
        self.0.is_int()
    }

    /// Gives the absolute value.
    pub fn abs(&self) -> Self {
        if self.sign() == Sign::Negative { -self } else { self.clone() }
    }

    /// Gives 1 / self; `None` for zero.
    pub fn recip(&self) -> Option<Self> {
        Self::new(self.denominator(), self.numerator())
    }

    /// Divides; `None` if `divisor` is zero.
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        (!divisor.is_zero()).then(|| Self(&self.0 / &divisor.0))
    }

    /// Gives the greatest integer that is not above this number.
    pub fn floor(&self) -> Integer {
        self.numerator().div_floor(&self.denominator())
    }

    /// Rounds to the nearest `f64`, ties to even, subnormal numbers included; infinite beyond the range of `f64`.
    pub fn approx_f64(&self) -> f64 {
        let (numerator, denominator) = (self.numerator(), self.denominator());
        if denominator == Integer::ONE {
            return numerator.approx_f64();
        }
        let magnitude = approx_quotient(&numerator.abs(), &denominator);
        if numerator.sign() == Sign::Negative { -magnitude } else { magnitude }
    }
}

/// The `f64` nearest to a quotient of positive integers.
pub(crate) fn approx_quotient(numerator: &Integer, denominator: &Integer) -> f64 {
    if numerator.is_zero() {
        return 0.0;
    }
    // quotient = floor(numerator * 2^shift / denominator) has 64 or 65 bits; one more bit says whether it is exact.
    let shift = 64 + i64::from(denominator.bit_len()) - i64::from(numerator.bit_len());
    let step = u32::try_from(shift.unsigned_abs()).expect("the bit lengths fit 32 bits");
    let (quotient, remainder) = if shift >= 0 {
        (numerator.clone() << step).div_rem(denominator)
    } else {
        numerator.div_rem(&(denominator.clone() << step))
    };
    let quotient = quotient.to_i128().expect("the quotient has at most 65 bits") as u128;
    let digits = quotient << 1 | u128::from(!remainder.is_zero());
    // The value lies in [2^exponent, 2^(exponent+1)).
    let lowest = -shift - 1;
    let exponent = lowest + i64::from(127 - digits.leading_zeros());
    if exponent > 1023 {
        return f64::INFINITY;
    }
    // The weight of the last bit that the result keeps; subnormal numbers keep fewer.
    let last = (exponent - 52).max(-1074);
    let drop = u32::try_from(last - lowest).expect("the digits are finer than the result");
    let mantissa = if drop > 127 {
        0
    } else {
        let kept = digits >> drop;
        let (rest, half) = (digits & ((1 << drop) - 1), 1_u128 << (drop - 1));
        kept + u128::from(rest > half || (rest == half && kept & 1 == 1))
    };
    // mantissa <= 2^53, so that both factors and (but for overflow to infinity) the product are exact.
    if last >= -1022 {
        mantissa as f64 * power_of_two(last)
    } else {
        mantissa as f64 * power_of_two(last + 200) * power_of_two(-200)
    }
}

/// 2^exponent, for -1022 <= exponent <= 1023.
pub(crate) fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

impl From<Integer> for Rational {
    fn from(value: Integer) -> Self {
        Self(RBig::from(value.0))
    }
}

impl From<&Integer> for Rational {
    fn from(value: &Integer) -> Self {
        Self(RBig::from(value.0.clone()))
    }
}

impl From<i64> for Rational {
    fn from(value: i64) -> Self {
        Self::from(Integer::from(value))
    }
}

impl TryFrom<f64> for Rational {
    type Error = NotFinite;

    /// Takes the float as the dyadic rational that it is.
    ///
    /// # Errors
    /// [`NotFinite`] for infinities and NaN.
    fn try_from(value: f64) -> Result<Self, NotFinite> {
        if !value.is_finite() {
            return Err(NotFinite);
        }
        let bits = value.to_bits();
        let exponent = ((bits >> 52) & 0x7ff) as i32;
        let fraction = bits & ((1 << 52) - 1);
        let (mantissa, exponent) =
            if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
        let mantissa = Integer::from(if value < 0.0 { -(mantissa as i64) } else { mantissa as i64 });
        let power = Integer::ONE << exponent.unsigned_abs();
        Ok(if exponent >= 0 {
            Self::from(mantissa * power)
        } else {
            Self::new(mantissa, power).expect("a power of two is not zero")
        })
    }
}

operators!(Rational: Add add, Sub sub, Mul mul);
assigning!(Rational: AddAssign add_assign, SubAssign sub_assign, MulAssign mul_assign);

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl FromStr for Rational {
    type Err = ParseNumberError;

    /// Reads an integer, a decimal ("-1.25", ".5", "5.", "3e-2", "+1") or p/q with integers p and q, exactly.
    ///
    /// # Errors
    /// [`ParseNumberError`] with the kind and the token.
    fn from_str(token: &str) -> Result<Self, ParseNumberError> {
        parse::rational(token)
    }
}

#[cfg(test)]
mod tests;
