//! From a token to an exact number, and from three numbers to a point.
//!
//! Almost every coordinate of a real file is an integer or a decimal of at most 18 digits. These are
//! read into machine words; everything else goes the general way, which is also what the tests
//! compare the short way with.

use super::error::NumberFault;
use exact::{Integer, MAX_DIGITS, ParseNumberErrorKind, Point3, Rational};

/// A coordinate in lowest terms.
#[derive(Clone, Debug)]
pub(crate) enum Number {
    /// Numerator and positive denominator.
    Small(i64, u64),
    Large(Rational),
}

/// Digits that are sure to fit into 63 bits.
const DIGITS: u32 = 18;

const POWERS_OF_TEN: [u64; DIGITS as usize + 1] = {
    let mut powers = [1; DIGITS as usize + 1];
    let mut k = 1;
    while k < powers.len() {
        powers[k] = 10 * powers[k - 1];
        k += 1;
    }
    powers
};

/// Reads an integer, a decimal with or without exponent, or a fraction of two integers.
pub(crate) fn parse_number(token: &[u8]) -> Result<Number, NumberFault> {
    match parse_small(token) {
        Some(number) => Ok(number),
        None => parse_general(token).map(Number::Large),
    }
}

/// Puts three coordinates over their least common denominator, so that the four numbers of the point
/// have no common factor.
pub(crate) fn point(coordinates: [Number; 3]) -> Point3 {
    use Number::Small;
    match coordinates {
        [Small(x, 1), Small(y, 1), Small(z, 1)] => Point3::from_i64([x, y, z]),
        [Small(x, a), Small(y, b), Small(z, c)] => {
            small_point([(x, a), (y, b), (z, c)]).unwrap_or_else(|| {
                Point3::from_rationals(&[Small(x, a), Small(y, b), Small(z, c)].map(Number::into_rational))
            })
        }
        general => Point3::from_rationals(&general.map(Number::into_rational)),
    }
}

impl Number {
    pub(crate) fn into_rational(self) -> Rational {
        match self {
            Self::Small(numerator, denominator) => {
                Rational::new(Integer::from(numerator), Integer::from(denominator))
                    .expect("the denominator is positive")
            }
            Self::Large(number) => number,
        }
    }
}

/// The common case; `None` if the token has to go the general way.
fn parse_small(token: &[u8]) -> Option<Number> {
    // Leading zeros count as digits, and would pass below.
    if token.len() > MAX_DIGITS as usize {
        return None;
    }
    let (negative, body) = match token {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, token),
    };
    let mut mantissa = 0_u64;
    let mut significant = 0;
    let mut any_digit = false;
    let mut decimals: Option<i64> = None;
    let mut rest = body;
    while let [byte, tail @ ..] = rest {
        match byte {
            b'0'..=b'9' => {
                any_digit = true;
                significant += u32::from(mantissa != 0 || *byte != b'0');
                if significant > DIGITS {
                    return None;
                }
                mantissa = 10 * mantissa + u64::from(byte - b'0');
                if let Some(places) = &mut decimals {
                    *places += 1;
                }
            }
            b'.' if decimals.is_none() => decimals = Some(0),
            _ => break,
        }
        rest = tail;
    }
    if !any_digit {
        return None;
    }
    let (mantissa, denominator) = match rest {
        [] => scaled(mantissa, -decimals.unwrap_or(0))?,
        [b'e' | b'E', exponent @ ..] => scaled(mantissa, small_exponent(exponent)? - decimals.unwrap_or(0))?,
        [b'/', digits @ ..] if decimals.is_none() => {
            let denominator = digits_only(digits)?;
            if denominator == 0 {
                return None;
            }
            reduced(mantissa, denominator)
        }
        _ => return None,
    };
    let magnitude = i64::try_from(mantissa).ok()?;
    Some(Number::Small(if negative { -magnitude } else { magnitude }, denominator))
}

/// `mantissa * 10^shift` in lowest terms, if both parts are small.
fn scaled(mut mantissa: u64, mut shift: i64) -> Option<(u64, u64)> {
    if mantissa == 0 {
        return Some((0, 1));
    }
    while shift < 0 && mantissa.is_multiple_of(10) {
        mantissa /= 10;
        shift += 1;
    }
    let power = *POWERS_OF_TEN.get(usize::try_from(shift.unsigned_abs()).ok()?)?;
    if shift >= 0 { Some((mantissa.checked_mul(power)?, 1)) } else { Some(reduced(mantissa, power)) }
}

fn small_exponent(token: &[u8]) -> Option<i64> {
    match token {
        [b'-', digits @ ..] => Some(-i64::from(two_digits(digits)?)),
        [b'+', digits @ ..] | digits => Some(i64::from(two_digits(digits)?)),
    }
}

fn two_digits(digits: &[u8]) -> Option<u8> {
    if digits.len() > 2 {
        return None;
    }
    digits_only(digits)?.try_into().ok()
}

fn digits_only(digits: &[u8]) -> Option<u64> {
    if digits.is_empty() || digits.len() > DIGITS as usize || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    Some(digits.iter().fold(0, |value, digit| 10 * value + u64::from(digit - b'0')))
}

fn reduced(numerator: u64, denominator: u64) -> (u64, u64) {
    let divisor = gcd(numerator, denominator);
    (numerator / divisor, denominator / divisor)
}

fn gcd(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// `None` if the numbers do not fit into 127 bits.
fn small_point(coordinates: [(i64, u64); 3]) -> Option<Point3> {
    let weight = coordinates.iter().try_fold(1_u64, |weight, &(_, denominator)| {
        (weight / gcd(weight, denominator)).checked_mul(denominator)
    })?;
    let numerators =
        coordinates.map(|(numerator, denominator)| i128::from(numerator) * i128::from(weight / denominator));
    Some(Point3::new(numerators.map(Integer::from), Integer::from(weight)).expect("the weight is positive"))
}

fn parse_general(token: &[u8]) -> Result<Rational, NumberFault> {
    let text = std::str::from_utf8(token).map_err(|_| NumberFault::Word)?;
    text.parse::<Rational>().map_err(|error| match error.kind {
        ParseNumberErrorKind::NotFinite => NumberFault::NotFinite,
        ParseNumberErrorKind::ZeroDenominator => NumberFault::ZeroDenominator,
        ParseNumberErrorKind::ExponentTooLarge => NumberFault::ExponentTooLarge,
        ParseNumberErrorKind::TooManyDigits => NumberFault::TooManyDigits,
        _ => NumberFault::Word,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_short_way_agrees_with_the_general_way() {
        let tokens = [
            "0",
            "-0",
            "+0",
            "00012",
            "7",
            "-7",
            "+7",
            "1.5",
            "-1.50",
            ".5",
            "5.",
            "0.000",
            "1e3",
            "1E+3",
            "25e-2",
            "-2.5e-1",
            "0e77",
            "1e18",
            "1e-18",
            "999999999999999999",
            "-999999999999999999",
            "6/4",
            "-6/4",
            "0/5",
            "10/5",
            "123456789.125",
            "0.1",
            "100.0e-2",
            "12345678901234567e-17",
        ];
        for token in tokens {
            let general = parse_general(token.as_bytes()).unwrap();
            let short = parse_small(token.as_bytes()).unwrap_or_else(|| panic!("{token} is short"));
            assert_eq!(short.into_rational(), general, "{token}");
        }
    }

    #[test]
    fn the_short_way_leaves_what_it_does_not_know() {
        for token in [
            "",
            "-",
            ".",
            "e5",
            "1e",
            "1e+",
            "1e999",
            "1/0",
            "1/",
            "/2",
            "1.5/2",
            "1/2.5",
            "nan",
            "0x10",
            "1_000",
            "1e400",
            "--1",
            "+-1",
            "1234567890123456789",
            "1/-2",
            "1.2.3",
            "1f",
            "\u{661}",
        ] {
            assert!(parse_small(token.as_bytes()).is_none(), "{token}");
        }
    }

    #[test]
    fn a_point_takes_the_least_common_denominator() {
        let number = |token: &str| parse_number(token.as_bytes()).unwrap();
        let point = point(["1/4", "0.5", "-5/6"].map(number));
        assert_eq!(point.weight(), Integer::from(12_i64));
        assert_eq!(point.coordinates().map(|c| c.to_string()), ["1/4", "1/2", "-5/6"]);
    }

    #[test]
    fn wide_points_are_exact() {
        let tokens = ["1/999999999999999999", "1/999999999999999998", "1/999999999999999997"];
        let point = point(tokens.map(|token| parse_number(token.as_bytes()).unwrap()));
        assert_eq!(point.coordinates().map(|c| c.to_string()), tokens);
    }
}
