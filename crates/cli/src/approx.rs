//! Exact numbers as a reader likes them: a few digits, whatever the magnitude.

use splitstar::exact::{Integer, Rational, Sign};

/// A positive or zero number with six significant digits, for reading only; beyond the range of normal floats with two,
/// as in `about 1.2e-345`.
pub(crate) fn approx(value: &Rational) -> String {
    let (mantissa, exponent) = scaled(value);
    shown(mantissa, exponent)
}

/// The square root of a positive number or zero, shown like [`approx`].
///
/// The number may lie far outside of the range of floats, even where its root does not.
pub(crate) fn approx_root(squared: &Rational) -> String {
    let (mut mantissa, mut exponent) = scaled(squared);
    if exponent % 2 != 0 {
        mantissa *= 2.0;
        exponent -= 1;
    }
    shown(mantissa.sqrt(), exponent / 2)
}

/// Gives `m` and `e` so that the number is `m * 2^e` up to the rounding of `m`, which is zero or
/// between `2^-64` and `2^64`.
fn scaled(value: &Rational) -> (f64, i64) {
    debug_assert!(value.sign() >= Sign::Zero, "only magnitudes are shown");
    // The 64 leading bits and the number of bits behind them.
    let leading = |number: Integer| {
        let behind = number.bit_len().saturating_sub(64);
        ((number >> behind).approx_f64(), i64::from(behind))
    };
    let (numerator, above) = leading(value.numerator());
    let (denominator, below) = leading(value.denominator());
    (numerator / denominator, above - below)
}

fn shown(mantissa: f64, exponent: i64) -> String {
    // Beyond 4000 the float is infinite or zero anyway. In two steps, as one power may leave the range where the
    // value does not.
    let clamped = exponent.clamp(-4000, 4000) as i32;
    let half = clamped / 2;
    let value = mantissa * 2_f64.powi(half) * 2_f64.powi(clamped - half);
    if mantissa == 0.0 || value.is_normal() {
        return short(value);
    }
    let decimal = mantissa.log10() + exponent as f64 * std::f64::consts::LOG10_2;
    // The mantissa may round up to 10, so its own exponent counts too.
    let digits = format!("{:.1e}", 10_f64.powf(decimal - decimal.floor()));
    let (digits, carry) = digits.split_once('e').expect("the format writes an exponent");
    let exponent = decimal.floor() as i64 + i64::from(carry != "0");
    format!("about {digits}e{exponent}")
}

/// A float with six significant digits and no zeros at the end.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-4..1e7).contains(&rounded) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> Rational {
        text.parse().unwrap()
    }

    const ROWS: [(&str, &str); 16] = [
        ("0", "0"),
        ("1/3", "0.333333"),
        ("2.5", "2.5"),
        ("9999990", "9999990"),
        ("9999999.6", "1e7"),
        ("1e-4", "0.0001"),
        ("1/30000000000000000", "3.33333e-17"),
        ("1e-155", "1e-155"),
        ("1e155", "1e155"),
        ("1e-300", "1e-300"),
        ("123456789e292", "1.23457e300"),
        ("1.7e308", "1.7e308"),
        ("1.9e308", "about 1.9e308"),
        ("2e-308", "about 2.0e-308"),
        ("1.2e-345", "about 1.2e-345"),
        ("9.99e399", "about 1.0e400"),
    ];

    #[test]
    fn numbers_of_any_magnitude_are_short() {
        for (text, shown) in ROWS {
            assert_eq!(approx(&number(text)), shown, "{text}");
        }
    }

    #[test]
    fn roots_of_any_magnitude_are_short() {
        for (text, shown) in ROWS {
            let root = number(text);
            assert_eq!(approx_root(&(&root * &root)), shown, "{text}");
        }
        assert_eq!(approx_root(&number("2")), "1.41421");
        assert_eq!(approx_root(&number("2e301")), "4.47214e150");
        assert_eq!(approx_root(&number("1e-399")), "3.16228e-200");
    }

    #[test]
    fn the_longest_numbers_have_an_exponent() {
        let nines = number(&"9".repeat(5_000));
        assert_eq!(approx_root(&(&nines * &nines)), "about 1.0e5000");
        let squared = &number("25/4") * &(&nines * &nines).recip().unwrap();
        assert_eq!(approx_root(&squared), "about 2.5e-5000");
    }
}
