use super::*;
use crate::Rational;
use crate::testing::{Random, WIDTHS, assert_nearest};

fn number(text: &str) -> Integer {
    text.parse().unwrap()
}

#[test]
fn arithmetic_agrees_with_machine_integers() {
    let values = [0, 1, -1, 2, 7, -12, 18, 1 << 40, -(1 << 62), i64::MAX, i64::MIN].map(i128::from);
    for a in values {
        for b in values {
            let (x, y) = (Integer::from(a), Integer::from(b));
            assert_eq!(&x + &y, Integer::from(a + b));
            assert_eq!(x.clone() - &y, Integer::from(a - b));
            assert_eq!(&x * y.clone(), Integer::from(a * b));
            assert_eq!(x.cmp(&y), a.cmp(&b));
            assert_eq!((-&x).to_i128(), Some(-a));
            assert_eq!(x.sign(), Sign::of_i128(a));
            if b != 0 {
                assert_eq!(x.div_rem(&y), (Integer::from(a / b), Integer::from(a % b)));
                let floor = a.div_euclid(b) - i128::from(b < 0 && a.rem_euclid(b) != 0);
                assert_eq!(x.div_floor(&y), Integer::from(floor), "{a} / {b}");
                let (twice, rounded) = ((2 * a).abs(), x.div_round(&y).to_i128().unwrap());
                assert!((twice - (2 * rounded * b).abs()).abs() <= b.abs(), "{a} / {b} is near {rounded}");
                assert!(rounded == 0 || rounded.signum() == a.signum() * b.signum());
            }
        }
    }
    assert_eq!(Integer::from(-5).div_round(&Integer::from(2)), Integer::from(-3));
    assert_eq!([1, 2, 3].map(Integer::from).into_iter().sum::<Integer>(), Integer::from(6));
}

#[test]
fn divisors_and_multiples_take_magnitudes() {
    for (a, b, gcd, lcm) in [(0, 0, 0, 0), (0, -5, 5, 0), (12, -18, 6, 36), (-7, 1, 1, 7), (-4, -6, 2, 12)] {
        let (a, b) = (Integer::from(a), Integer::from(b));
        assert_eq!((a.gcd(&b), a.lcm(&b)), (Integer::from(gcd), Integer::from(lcm)));
        assert_eq!((b.gcd(&a), b.lcm(&a)), (Integer::from(gcd), Integer::from(lcm)));
    }
    let (a, b) = (Integer::from(6).pow(90), Integer::from(-10).pow(71));
    assert_eq!(a.gcd(&b), Integer::from(2).pow(71));
    assert_eq!((&a * &b).div_exact(&b), a);
}

#[test]
fn lengths_roots_and_conversions() {
    for (text, bits) in [("0", 0), ("1", 1), ("-1", 1), ("3", 2), ("-4", 3), ("18446744073709551616", 65)] {
        assert_eq!(number(text).bit_len(), bits, "{text}");
        assert_eq!(number(text).to_string(), text);
    }
    assert_eq!(Integer::from(i64::MIN).to_i64(), Some(i64::MIN));
    assert_eq!((Integer::from(i64::MIN) - Integer::ONE).to_i64(), None);
    assert_eq!(Integer::from(i128::MIN).to_i128(), Some(i128::MIN));
    assert_eq!((Integer::from(i128::MAX) + Integer::ONE).to_i128(), None);
    assert_eq!(Integer::from(99).sqrt_floor(), Some(Integer::from(9)));
    assert_eq!(Integer::from(-1).sqrt_floor(), None);
    assert_eq!(Integer::from(-2).pow(0), Integer::ONE);
    assert_eq!(Integer::from(-3) << 2, Integer::from(-12));
    assert_eq!(Integer::from(-13) >> 2, Integer::from(-4));
}

#[test]
fn floats_are_nearest() {
    let mut random = Random::new(2);
    for bits in WIDTHS.into_iter().chain([54, 55, 65, 129, 190, 191, 192, 193, 1023, 1024, 1025]) {
        for _ in 0..200 {
            let value = random.integer(bits);
            assert_nearest(&Rational::from(&value), value.approx_f64());
        }
    }
    // Ties, and sums just off a tie far below the rounding bit.
    for shift in [0, 1, 11, 12, 64, 75, 76, 77, 140, 900] {
        for tie in [(1_i64 << 54) + 2, (1 << 54) + 6, (1 << 54) - 1] {
            for off in [-1, 0, 1] {
                let value = (Integer::from(tie) << shift) + Integer::from(off);
                assert_nearest(&Rational::from(&value), value.approx_f64());
                assert_nearest(&Rational::from(-&value), -value.approx_f64());
            }
        }
    }
    assert_eq!((Integer::ONE << 1024).approx_f64(), f64::INFINITY);
    assert_eq!((-(Integer::ONE << 5000)).approx_f64(), f64::NEG_INFINITY);
    let last = (Integer::ONE << 1024) - (Integer::ONE << 970);
    assert_eq!(last.approx_f64(), f64::INFINITY);
    assert_eq!((last - Integer::ONE).approx_f64(), f64::MAX);
}
