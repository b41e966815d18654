//! Numbers as text. Nothing is rounded, and a short token cannot ask for a huge number.

use crate::{Integer, Rational, Sign};
use dashu_int::IBig;
use std::fmt;

/// The greatest magnitude of a decimal exponent that is read; beyond it a number is refused before it is built.
///
/// Every `f64` written in decimal lies within it (the extremes are about 1.8e308 and 4.9e-324).
pub const MAX_EXPONENT: u32 = 400;

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
                write!(f, "`{token}` has an exponent beyond {MAX_EXPONENT}")
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

fn signed_integer(token: &str) -> Option<Integer> {
    let (sign, digits) = split_sign(token);
    is_digits(digits).then(|| from_digits(digits, sign))
}

pub(crate) fn integer(token: &str) -> Result<Integer, ParseNumberError> {
    signed_integer(token).ok_or_else(|| not_a_number(token))
}

pub(crate) fn rational(token: &str) -> Result<Rational, ParseNumberError> {
    if let Some((numerator, denominator)) = token.split_once('/') {
        let parts = signed_integer(numerator).zip(signed_integer(denominator));
        let (numerator, denominator) = parts.ok_or_else(|| not_a_number(token))?;
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
    let digits = if fraction.is_empty() {
        from_digits(whole, sign)
    } else {
        from_digits(&[whole, fraction].concat(), sign)
    };
    let exponent = exponent - fraction.len() as i64;
    let power = |exponent: i64| {
        Integer::from(10).pow(u32::try_from(exponent).expect("shorter than the token plus MAX_EXPONENT"))
    };
    Ok(if exponent >= 0 {
        Rational::from(if exponent == 0 { digits } else { digits * power(exponent) })
    } else {
        Rational::new(digits, power(-exponent)).expect("a power of ten is not zero")
    })
}

#[cfg(test)]
mod tests;
