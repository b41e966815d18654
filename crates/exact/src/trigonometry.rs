//! Sine and cosine in fixed point, from integers only: no rounding of a platform's library decides anything.

use crate::{Integer, Rational};

/// The number of fractional bits.
pub(crate) const BITS: u32 = 256;

/// A number times 2^[`BITS`], with an error of less than 2^-(`BITS` - 16).
pub(crate) type Scaled = Integer;

/// Pi, by Machin's formula.
pub(crate) fn pi() -> Scaled {
    Integer::from(16) * arctangent_of_inverse(5) - Integer::from(4) * arctangent_of_inverse(239)
}

/// arctan(1 / n) = 1/n - 1/(3 n^3) + 1/(5 n^5) - ...; less than 128 terms, each rounded down twice.
fn arctangent_of_inverse(n: i64) -> Scaled {
    let square = Integer::from(n * n);
    let mut power = (Integer::ONE << BITS).div_floor(&Integer::from(n));
    let mut sum = Integer::ZERO;
    let mut odd = 1_i64;
    while !power.is_zero() {
        let term = power.div_floor(&Integer::from(odd));
        sum = if odd % 4 == 1 { sum + term } else { sum - term };
        power = power.div_floor(&square);
        odd += 2;
    }
    sum
}

/// A rational multiple of a scaled number.
pub(crate) fn times(factor: &Rational, value: &Scaled) -> Scaled {
    (factor.numerator() * value).div_round(&factor.denominator())
}

/// Sine and cosine of an angle in radians, of magnitude below 2, by their Taylor series.
pub(crate) fn sine_cosine(angle: &Scaled) -> (Scaled, Scaled) {
    let mut sums = [Integer::ONE << BITS, Integer::ZERO];
    let mut term = Integer::ONE << BITS;
    let mut degree = 0_i64;
    while !term.is_zero() {
        degree += 1;
        term = ((term * angle) >> BITS).div_round(&Integer::from(degree));
        let sum = &mut sums[(degree % 2) as usize];
        if degree % 4 >= 2 {
            *sum -= &term;
        } else {
            *sum += &term;
        }
    }
    let [cosine, sine] = sums;
    (sine, cosine)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pi_has_its_known_digits() {
        let digits = (pi() * Integer::from(10).pow(70)) >> BITS;
        let known = "31415926535897932384626433832795028841971693993751058209749445923078164";
        assert_eq!(digits.to_string(), known);
    }

    #[test]
    fn sine_and_cosine_keep_their_error_bound() {
        let bound = Integer::ONE << 16;
        let pi = pi();
        // (degrees, cosine squared times 4)
        for (degrees, square) in [(0, 4), (30, 3), (45, 2), (60, 1), (90, 0), (-30, 3), (-45, 2), (-90, 0)] {
            let angle = times(&Rational::new(degrees.into(), 180.into()).unwrap(), &pi);
            let (sine, cosine) = sine_cosine(&angle);
            let root = (Integer::from(square) << (2 * BITS - 2)).sqrt_floor().unwrap();
            assert!((&cosine - &root).abs() < bound, "cosine of {degrees}");
            let root = (Integer::from(4 - square) << (2 * BITS - 2)).sqrt_floor().unwrap();
            assert!((sine.abs() - root).abs() < bound, "sine of {degrees}");
            assert_eq!(sine.sign(), Integer::from(degrees).sign());
        }
    }
}
