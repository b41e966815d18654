//! Numbers as text. Nothing is rounded, and a short token cannot ask for a huge number.

use crate::{Integer, Rational, Sign};
use dashu_int::IBig;
use std::fmt;

/// The greatest magnitude of a decimal exponent that is read; beyond it a number is refused before it is built.
///
/// Every `f64` written in decimal lies within it (the extremes are about 1.8e308 and 4.9e-324).
pub const MAX_EXPONENT: u32 = 400;

/// The most digits that are read in an integer, in each part of p/q, and in a decimal (both sides of the point together, without the exponent); beyond
/// it a number is refused before it is built.
///
/// Leading and trailing zeros count. The time that a number takes grows with the square of its length, so that a limit on the length keeps the time of
/// a text proportional to its length.
pub const MAX_DIGITS: u32 = 5_000;

/// Text that is no number.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ParseNumberError {
    /// What is wrong.
    pub kind: ParseNumberErrorKind,
    /// The text, cut after 40 characters.
    pub token: String,
}

/// The ways in which text is no number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ParseNumberErrorKind {
    /// There is no text.
    Empty,
    /// The text is not written as a number.
    Word,
    /// The text names a NaN or an infinity.
    NotFinite,
    /// The q of p/q is zero.
    ZeroDenominator,
    /// The decimal exponent exceeds [`MAX_EXPONENT`] in magnitude.
    ExponentTooLarge,
    /// An integer, a part of p/q or a decimal has more than [`MAX_DIGITS`] digits.
    TooManyDigits,
}

impl fmt::Display for ParseNumberError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let token = &self.token;
        match self.kind {
            ParseNumberErrorKind::Empty => f.write_str("a number is missing"),
            ParseNumberErrorKind::Word => write!(f, "`{token}` is not a number"),
            ParseNumberErrorKind::NotFinite => write!(f, "`{token}` is not a finite number"),
            ParseNumberErrorKind::ZeroDenominator => write!(f, "`{token}` has a zero denominator"),
            ParseNumberErrorKind::ExponentTooLarge => {
                write!(
                    f,
                    "the exponent of `{token}` is too large in magnitude; the largest allowed is {MAX_EXPONENT}"
                )
            }
            ParseNumberErrorKind::TooManyDigits => {
                write!(
                    f,
                    "`{token}` has too many digits; the largest number of digits allowed is {MAX_DIGITS}"
                )
            }
        }
    }
}

impl std::error::Error for ParseNumberError {}

fn error(kind: ParseNumberErrorKind, token: &str) -> ParseNumberError {
    let mut text: String = token.chars().take(40).collect();
    if text.len() < token.len() {
        text.push_str("...");
    }
    ParseNumberError { kind, token: text }
}

/// The kind of error of a token that is not written as a number.
fn not_a_number(token: &str) -> ParseNumberError {
    let word = token.strip_prefix(['+', '-']).unwrap_or(token).to_ascii_lowercase();
    let kind = if token.trim().is_empty() {
        ParseNumberErrorKind::Empty
    } else if word.starts_with("nan") || word == "inf" || word == "infinity" {
        ParseNumberErrorKind::NotFinite
    } else {
        ParseNumberErrorKind::Word
    };
    error(kind, token)
}

fn split_sign(token: &str) -> (Sign, &str) {
    match token.strip_prefix('-') {
        Some(rest) => (Sign::Negative, rest),
        None => (Sign::Positive, token.strip_prefix('+').unwrap_or(token)),
    }
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

fn from_digits(digits: &str, sign: Sign) -> Integer {
    // Most tokens are short; 18 digits fit a machine word.
    let value = if digits.len() <= 18 {
        Integer::from(digits.bytes().fold(0_i64, |value, digit| 10 * value + i64::from(digit - b'0')))
    } else {
        Integer(IBig::from_str_radix(digits, 10).expect("only decimal digits are passed"))
    };
    if sign == Sign::Negative { -value } else { value }
}

fn split_integer(token: &str) -> Option<(Sign, &str)> {
    let (sign, digits) = split_sign(token);
    is_digits(digits).then_some((sign, digits))
}

/// Refuses a token with too many digits in one of its parts.
fn check_length(digits: usize, token: &str) -> Result<(), ParseNumberError> {
    if digits > MAX_DIGITS as usize {
        return Err(error(ParseNumberErrorKind::TooManyDigits, token));
    }
    Ok(())
}

pub(crate) fn integer(token: &str) -> Result<Integer, ParseNumberError> {
    let (sign, digits) = split_integer(token).ok_or_else(|| not_a_number(token))?;
    check_length(digits.len(), token)?;
    Ok(from_digits(digits, sign))
}

pub(crate) fn rational(token: &str) -> Result<Rational, ParseNumberError> {
    if let Some((numerator, denominator)) = token.split_once('/') {
        let parts = split_integer(numerator).zip(split_integer(denominator));
        let (numerator, denominator) = parts.ok_or_else(|| not_a_number(token))?;
        check_length(numerator.1.len().max(denominator.1.len()), token)?;
        let [numerator, denominator] =
            [numerator, denominator].map(|(sign, digits)| from_digits(digits, sign));
        return Rational::new(numerator, denominator)
            .ok_or_else(|| error(ParseNumberErrorKind::ZeroDenominator, token));
    }
    decimal(token)
}

fn decimal(token: &str) -> Result<Rational, ParseNumberError> {
    let (sign, unsigned) = split_sign(token);
    let (mantissa, exponent) = match unsigned.find(['e', 'E']) {
        Some(at) => (&unsigned[..at], Some(&unsigned[at + 1..])),
        None => (unsigned, None),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let proper = |digits: &str| digits.is_empty() || is_digits(digits);
    if !proper(whole) || !proper(fraction) || whole.len() + fraction.len() == 0 {
        return Err(not_a_number(token));
    }
    let exponent = match exponent {
        None => 0,
        Some(text) => {
            let (sign, digits) = split_sign(text);
            if !is_digits(digits) {
                return Err(not_a_number(token));
            }
            let magnitude = digits
                .bytes()
                .fold(0_u32, |value, digit| value.saturating_mul(10).saturating_add(u32::from(digit - b'0')));
            if magnitude > MAX_EXPONENT {
                return Err(error(ParseNumberErrorKind::ExponentTooLarge, token));
            }
            if sign == Sign::Negative { -i64::from(magnitude) } else { i64::from(magnitude) }
        }
    };
    check_length(whole.len() + fraction.len(), token)?;
    let digits = if fraction.is_empty() {
        from_digits(whole, sign)
    } else {
        from_digits(&[whole, fraction].concat(), sign)
    };
    let exponent = exponent - fraction.len() as i64;
    let power = |exponent: i64| {
        Integer::from(10).pow(u32::try_from(exponent).expect("at most MAX_DIGITS plus MAX_EXPONENT"))
    };
    Ok(if exponent >= 0 {
        Rational::from(if exponent == 0 { digits } else { digits * power(exponent) })
    } else {
        Rational::new(digits, power(-exponent)).expect("a power of ten is not zero")
    })
}

#[cfg(test)]
mod tests;
