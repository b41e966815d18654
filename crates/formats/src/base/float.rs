//! Numbers rounded to 32-bit floats.

use super::numerals::{Rounding, TooLarge};
use exact::{Point3, Rational};
use std::cmp::Ordering;

/// The 32-bit float nearest to a number, ties to even, subnormal floats included; `None` beyond the largest one.
/// Zero, and what rounds to it, has no sign.
pub(crate) fn nearest_f32(number: &Rational) -> Option<f32> {
    let double = number.approx_f64();
    let nearest = match half_way(double) {
        // Only here can rounding twice go wrong: all other doubles lie on the same side of the middle as the number.
        Some([below, above]) => {
            let middle = Rational::try_from(double).expect("the middle of two floats is finite");
            match number.cmp(&middle) {
                Ordering::Less => below,
                Ordering::Equal => double as f32,
                Ordering::Greater => above,
            }
        }
        None => double as f32,
    };
    nearest.is_finite().then_some(nearest + 0.0)
}

/// The 32-bit floats below and above a double that is the middle of the two; the one above the largest is infinite.
fn half_way(double: f64) -> Option<[f32; 2]> {
    let single = double as f32;
    let nearest = wide(single);
    let [below, above] = match nearest.partial_cmp(&double)? {
        Ordering::Less => [single, single.next_up()],
        Ordering::Equal => return None,
        Ordering::Greater => [single.next_down(), single],
    };
    // Both differences are exact: each is less than the step of the floats, in bits that the double has.
    let (to_below, to_above) = (double - wide(below), wide(above) - double);
    (to_below.partial_cmp(&to_above) == Some(Ordering::Equal)).then_some([below, above])
}

/// The same number; infinity is what would follow the largest float if the exponents went on.
fn wide(single: f32) -> f64 {
    const BEYOND: f64 = 2.0 * (1_u128 << 127) as f64;
    if single.is_finite() { f64::from(single) } else { BEYOND.copysign(f64::from(single)) }
}

/// Rounds the coordinates of a point to the nearest 32-bit floats, and keeps the largest rounding.
pub(crate) fn nearest_f32s(point: &Point3, rounding: &mut Rounding) -> Result<[f32; 3], TooLarge> {
    if let Some(exact) = exact_f32s(point) {
        return Ok(exact);
    }
    let mut floats = [0.0; 3];
    for (axis, float) in floats.iter_mut().enumerate() {
        let coordinate = point.coordinate(axis);
        *float = nearest_f32(&coordinate).ok_or(TooLarge)?;
        let written = Rational::try_from(f64::from(*float)).expect("the nearest float is finite");
        if written != coordinate {
            rounding.raise((&written - &coordinate).abs());
        }
    }
    Ok(floats)
}

/// The coordinates of a narrow point over a power of two, if each numerator has at most 24 digits between its
/// first and its last binary one. All such numbers are floats: their exponents lie between -61 and 61.
fn exact_f32s(point: &Point3) -> Option<[f32; 3]> {
    let &[x, y, z, weight] = point.as_narrow()?;
    let fits = |value: i64| {
        let magnitude = value.unsigned_abs();
        value == 0 || magnitude >> magnitude.trailing_zeros() < 1 << 24
    };
    let exact = weight & (weight - 1) == 0 && fits(x) && fits(y) && fits(z);
    exact.then(|| [x, y, z].map(|value| value as f32 / weight as f32))
}

/// Whether two corners of a triangle are the same.
pub(crate) fn is_collapsed([a, b, c]: [[f32; 3]; 3]) -> bool {
    let bits = |corner: [f32; 3]| corner.map(|float| (float + 0.0).to_bits());
    let [a, b, c] = [bits(a), bits(b), bits(c)];
    a == b || b == c || c == a
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nearest(number: &str) -> Option<f32> {
        nearest_f32(&number.parse().unwrap())
    }

    /// The float of these bits; a fraction of its last bit is added to it.
    fn near(bits: u32, numerator: i64, denominator: i64) -> Rational {
        let float = |bits: u32| Rational::try_from(f64::from(f32::from_bits(bits))).unwrap();
        let step = float(bits + 1) - float(bits);
        let part = Rational::new(numerator.into(), denominator.into()).unwrap();
        float(bits) + step * part
    }

    #[test]
    fn numbers_round_to_the_nearest_float() {
        let rows = [
            ("0", 0.0),
            ("1/3", 1.0_f32 / 3.0),
            ("-0.1", -0.1),
            ("16777217", 16_777_216.0),
            ("16777219", 16_777_220.0),
            ("-16777219", -16_777_220.0),
            // Just above and just below the middle: their nearest double is the middle itself.
            ("16777217.0000000000000000000001", 16_777_218.0),
            ("16777218.9999999999999999999999", 16_777_218.0),
            ("-16777217.0000000000000000000001", -16_777_218.0),
            ("1e-45", f32::from_bits(1)),
            ("1e-46", 0.0),
            ("-1e-300", 0.0),
            ("-1e-400", 0.0),
            ("1e38", 1e38),
        ];
        for (number, float) in rows {
            let rounded = nearest(number).unwrap();
            assert_eq!(rounded.to_bits(), float.to_bits(), "{number}: {rounded:e}");
        }
    }

    #[test]
    fn ties_and_what_is_beside_them_are_told_apart() {
        // Normal, odd and even, next to a power of two, subnormal, zero, the last but one.
        for bits in
            [0x3f80_0000, 0x3f80_0001, 0x3fff_ffff, 0x0080_0000, 0x007f_ffff, 0x0000_0001, 0, 0x7f7f_fffe]
        {
            let even = bits + (bits & 1);
            let huge = i64::MAX / 2;
            for (numerator, denominator, expected) in [
                (1, 4, bits),
                (3, 4, bits + 1),
                (1, 2, even),
                (huge / 2, huge - 1, even),
                (huge / 2, huge, bits),
                (huge / 2 + 1, huge, bits + 1),
            ] {
                // huge is odd: huge / 2 is below its half, and exactly half of huge - 1.
                let number = near(bits, numerator, denominator);
                let expected = f32::from_bits(expected);
                assert_eq!(nearest_f32(&number), Some(expected), "{bits:#x} + {numerator}/{denominator}");
                assert_eq!(nearest_f32(&-number), Some(-expected + 0.0));
            }
        }
    }

    #[test]
    fn there_is_no_float_beyond_the_largest() {
        // The middle of the largest float and 2^128 is a tie, and its even side is beyond.
        let middle: Rational = "340282356779733661637539395458142568448".parse().unwrap();
        let little: Rational = "1/1000000".parse().unwrap();
        assert_eq!(nearest_f32(&(&middle - &little)), Some(f32::MAX));
        assert_eq!(nearest_f32(&(&little - &middle)), Some(f32::MIN));
        for beyond in ["340282356779733661637539395458142568448", "1e39", "-1e39", "1e400", "-1e400"] {
            assert_eq!(nearest(beyond), None, "{beyond}");
        }
    }

    #[test]
    fn floats_come_back_from_their_numbers() {
        let mut bits = 1_u32;
        for _ in 0..5_000 {
            bits = bits.wrapping_mul(0x915f_77f5).wrapping_add(0x6d2b_79f5);
            let float = f32::from_bits(bits);
            if float.is_finite() {
                let number = Rational::try_from(f64::from(float)).unwrap();
                assert_eq!(nearest_f32(&number), Some(float), "{bits:#x}");
            }
        }
    }

    #[test]
    fn points_know_what_they_lose() {
        let rounded = |coordinates: [&str; 3]| {
            let point = Point3::from_rationals(&coordinates.map(|text| text.parse().unwrap()));
            let mut rounding = Rounding::none();
            let floats = nearest_f32s(&point, &mut rounding).ok();
            (floats, rounding.0.to_string())
        };
        let exact = |floats: [f32; 3]| (Some(floats), "0".to_string());
        assert_eq!(rounded(["0", "-3", "16777215"]), exact([0.0, -3.0, 16_777_215.0]));
        assert_eq!(rounded(["0.5", "-0.125", "1099511627776"]), exact([0.5, -0.125, 1_099_511_627_776.0]));
        assert_eq!(rounded(["1e30", "0", "0"]).0, Some([1e30, 0.0, 0.0]));
        assert_eq!(
            rounded(["16777217", "-33554433", "0.5"]),
            (Some([16_777_216.0, -33_554_432.0, 0.5]), "1".into())
        );
        assert_eq!(rounded(["1/3", "0", "0"]), (Some([1.0 / 3.0, 0.0, 0.0]), "1/100663296".into()));
        assert_eq!(rounded(["0", "1e39", "0"]).0, None);
    }
}
