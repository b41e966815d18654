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
