//! Exact numbers as text: fractions, decimals, or the decimals of floats.

use exact::{Integer, Point3, Rational, Sign};
use std::fmt;
use std::io::Write;

/// How coordinates are written in a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Numerals {
    /// An integer, or `p/q` in lowest terms: always exact.
    Fractions,
    /// A decimal that is exact where there is one of at most [`DIGITS`] digits, else that of the nearest double.
    Decimals,
    /// The shortest decimal that reads back as the nearest double.
    Floats,
}

/// The digits of the longest decimal that is written out. A 32-bit float between a millionth and a million has one
/// that is shorter.
const DIGITS: u32 = 40;

/// A coordinate is beyond the largest float.
#[derive(Debug)]
pub(crate) struct TooLarge;

/// What a text that is being written has lost.
#[derive(Debug)]
pub(crate) struct Rounding(pub(crate) Rational);

impl Rounding {
    pub(crate) fn none() -> Self {
        Self(Rational::from(0))
    }

    /// Keeps the larger one.
    pub(crate) fn raise(&mut self, rounding: Rational) {
        if rounding > self.0 {
            self.0 = rounding;
        }
    }
}

pub(crate) fn put(text: &mut Vec<u8>, arguments: fmt::Arguments<'_>) {
    text.write_fmt(arguments).expect("writing to memory does not fail");
}

/// Writes three coordinates with blanks between them.
pub(crate) fn put_point(
    text: &mut Vec<u8>,
    point: &Point3,
    numerals: Numerals,
    rounding: &mut Rounding,
) -> Result<(), TooLarge> {
    if numerals != Numerals::Floats
        && let Some([x, y, z, 1]) = point.as_narrow()
    {
        put(text, format_args!("{x} {y} {z}"));
        return Ok(());
    }
    for axis in 0..3 {
        if axis > 0 {
            text.push(b' ');
        }
        if numerals == Numerals::Decimals
            && let Some(homogeneous) = point.as_narrow()
            && let Some((digits, places)) = small_decimal(homogeneous[axis], homogeneous[3])
        {
            put_decimal(text, homogeneous[axis] < 0, digits, places);
            continue;
        }
        put_number(text, &point.coordinate(axis), numerals, rounding)?;
    }
    Ok(())
}

/// Writes one number.
pub(crate) fn put_number(
    text: &mut Vec<u8>,
    number: &Rational,
    numerals: Numerals,
    rounding: &mut Rounding,
) -> Result<(), TooLarge> {
    match numerals {
        Numerals::Fractions => put(text, format_args!("{number}")),
        Numerals::Decimals => match exact_decimal(number) {
            Some(decimal) => text.extend_from_slice(decimal.as_bytes()),
            None => put_float(text, number, rounding)?,
        },
        Numerals::Floats => put_float(text, number, rounding)?,
    }
    Ok(())
}

/// Writes the nearest double. What is lost is the difference to the decimal, which is what reading gives back.
fn put_float(text: &mut Vec<u8>, number: &Rational, rounding: &mut Rounding) -> Result<(), TooLarge> {
    let float = number.approx_f64();
    if !float.is_finite() {
        return Err(TooLarge);
    }
    // Both forms have the fewest digits that read back as the same double. Plain zeros are kept few; a negative
    // number that rounds to zero is written without its sign.
    let magnitude = float.abs();
    let decimal = if number.sign() == Sign::Zero || magnitude == 0.0 {
        "0".to_string()
    } else if (1e-5..1e16).contains(&magnitude) {
        float.to_string()
    } else {
        format!("{float:e}")
    };
    text.extend_from_slice(decimal.as_bytes());
    let written: Rational = decimal.parse().expect("a float is written as a decimal");
    rounding.raise((&written - number).abs());
    Ok(())
}

/// The digits of the magnitude of a fraction of machine integers, and how many of them stand behind the point: the
/// common case of [`exact_decimal`]. The denominator is positive.
fn small_decimal(numerator: i64, denominator: i64) -> Option<(u128, u32)> {
    let (mut digits, mut rest) = (u128::from(numerator.unsigned_abs()), denominator.unsigned_abs());
    if digits == 0 {
        return Some((0, 0));
    }
    let twos = rest.trailing_zeros().min(digits.trailing_zeros());
    (digits, rest) = (digits >> twos, rest >> twos);
    while rest.is_multiple_of(5) && digits.is_multiple_of(5) {
        (digits, rest) = (digits / 5, rest / 5);
    }
    let twos = rest.trailing_zeros();
    rest >>= twos;
    let mut fives = 0;
    while rest.is_multiple_of(5) {
        (rest, fives) = (rest / 5, fives + 1);
    }
    let places = twos.max(fives);
    if rest != 1 || places > DIGITS {
        return None;
    }
    let factor = 5_u128.checked_pow(places - fives)?.checked_mul(1_u128.checked_shl(places - twos)?)?;
    digits = digits.checked_mul(factor)?;
    (digits < 10_u128.pow(38)).then_some((digits, places))
}

fn put_decimal(text: &mut Vec<u8>, negative: bool, digits: u128, places: u32) {
    let sign = if negative { "-" } else { "" };
    if places == 0 {
        return put(text, format_args!("{sign}{digits}"));
    }
    let power = 10_u128.pow(places.min(38));
    if places > 38 {
        return put(text, format_args!("{sign}0.{digits:0>width$}", width = places as usize));
    }
    let (whole, fraction) = (digits / power, digits % power);
    put(text, format_args!("{sign}{whole}.{fraction:0>width$}", width = places as usize));
}

/// The decimal of a number, if it ends after few digits.
pub(crate) fn exact_decimal(number: &Rational) -> Option<String> {
    if number.is_integer() {
        let text = number.to_string();
        return (text.len() <= DIGITS as usize + 1).then_some(text);
    }
    let denominator = number.denominator();
    // 10^40 has 133 bits.
    if denominator.bit_len() > 134 {
        return None;
    }
    let places = decimal_places(denominator)?;
    if places > DIGITS {
        return None;
    }
    let power = Integer::from(10).pow(places);
    let digits = (number.numerator() * power.div_exact(&number.denominator())).to_string();
    let (sign, digits) = match digits.strip_prefix('-') {
        Some(digits) => ("-", digits),
        None => ("", digits.as_str()),
    };
    let digits = format!("{digits:0>width$}", width = places as usize + 1);
    if digits.len() > DIGITS as usize + 1 {
        return None;
    }
    let (whole, fraction) = digits.split_at(digits.len() - places as usize);
    Some(format!("{sign}{whole}.{fraction}"))
}

/// The digits behind the point of a fraction with this denominator; `None` if there is no end.
fn decimal_places(denominator: Integer) -> Option<u32> {
    let mut rest = denominator;
    let mut exponents = [0_u32; 2];
    for (exponent, prime) in exponents.iter_mut().zip([2_i64, 5]) {
        let prime = Integer::from(prime);
        loop {
            let (quotient, remainder) = rest.div_rem(&prime);
            if !remainder.is_zero() {
                break;
            }
            rest = quotient;
            *exponent += 1;
        }
    }
    (rest == Integer::from(1)).then(|| exponents[0].max(exponents[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(number: &str, numerals: Numerals) -> (String, String) {
        let mut text = Vec::new();
        let mut rounding = Rounding::none();
        put_number(&mut text, &number.parse().unwrap(), numerals, &mut rounding).unwrap();
        (String::from_utf8(text).unwrap(), rounding.0.to_string())
    }

    #[test]
    fn decimals_are_exact_where_they_end() {
        let rows = [
            ("0", "0"),
            ("-7", "-7"),
            ("1/2", "0.5"),
            ("-1/8", "-0.125"),
            ("12345/100", "123.45"),
            ("1/1024", "0.0009765625"),
            ("13421773/134217728", "0.100000001490116119384765625"),
            ("1e-40", "0.0000000000000000000000000000000000000001"),
        ];
        for (number, decimal) in rows {
            assert_eq!(written(number, Numerals::Decimals), (decimal.into(), "0".into()), "{number}");
        }
    }

    #[test]
    fn the_decimals_of_small_fractions_are_those_of_all() {
        let mut state = 1_u64;
        let mut compared = 0;
        for case in 0..20_000_u32 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let twos = (state >> 40) % 58;
            let fives = (state >> 50) % 26;
            let denominator = match case % 3 {
                0 => 1_i64 << twos,
                1 => 5_i64.pow(fives as u32),
                _ => 10_i64.pow((fives % 18) as u32) << (twos % 3),
            };
            let numerator = (state as i64 >> 4) >> (twos % 40);
            let number = Rational::new(numerator.into(), denominator.into()).unwrap();
            let mut text = Vec::new();
            if let Some((digits, places)) = small_decimal(numerator, denominator) {
                put_decimal(&mut text, numerator < 0, digits, places);
                assert_eq!(Some(String::from_utf8(text).unwrap()), exact_decimal(&number), "{number}");
                compared += 1;
            }
        }
        assert!(compared > 10_000, "{compared}");
    }

    #[test]
    fn other_decimals_are_those_of_doubles() {
        assert_eq!(
            written("1/3", Numerals::Decimals),
            ("0.3333333333333333".into(), "1/30000000000000000".into())
        );
        assert_eq!(written("1e-41", Numerals::Decimals), ("1e-41".into(), "0".into()));
        assert_eq!(written("2e300", Numerals::Decimals), ("2e300".into(), "0".into()));
        let mut text = Vec::new();
        let too_large = "1e309".parse().unwrap();
        assert!(put_number(&mut text, &too_large, Numerals::Decimals, &mut Rounding::none()).is_err());
    }
}
