use super::*;
use crate::testing::{Random, WIDTHS};
use crate::{Integer, Rational};

fn assert_contains(interval: Interval, value: &Integer) {
    let value = Rational::from(value);
    if interval.low.is_finite() {
        assert!(Rational::try_from(interval.low).unwrap() <= value, "{interval:?} {value}");
    }
    if interval.high.is_finite() {
        assert!(Rational::try_from(interval.high).unwrap() >= value, "{interval:?} {value}");
    }
    assert!(interval.low != f64::INFINITY && interval.high != f64::NEG_INFINITY);
    if let Some(sign) = interval.verdict() {
        assert_eq!(sign, value.sign(), "{interval:?} {value}");
    }
}

#[test]
fn every_operation_contains_the_exact_value() {
    let mut random = Random::new(7);
    for bits in WIDTHS {
        for _ in 0..500 {
            let mut stack = [(); 4].map(|()| {
                let value = random.integer(bits);
                (Interval::of_nearest(value.approx_f64()), value)
            });
            for _ in 0..6 {
                let (i, j) = (random.below(4) as usize, random.below(4) as usize);
                let ((a, x), (b, y)) = (stack[i].clone(), stack[j].clone());
                let result = match random.below(4) {
                    0 => (a + b, x + y),
                    1 => (a - b, x - y),
                    2 => (-a, -x),
                    _ => (a * b, x * y),
                };
                assert_contains(result.0, &result.1);
                stack[i] = result;
            }
        }
    }
}

#[test]
fn zeros_stay_exact_and_nan_decides_nothing() {
    let [zero, three, huge] = [0.0, 3.0, f64::INFINITY].map(Interval::of_nearest);
    assert_eq!((zero * huge).verdict(), Some(Sign::Zero));
    assert_eq!((zero * three + zero * huge).verdict(), Some(Sign::Zero));
    assert_eq!((zero - three * zero + three).approx_bounds(), [3.0, 3.0]);
    assert_eq!(huge.approx_bounds(), [f64::MAX, f64::INFINITY]);
    assert_eq!(huge.verdict(), Some(Sign::Positive));
    assert_eq!((huge - huge).verdict(), None);
    assert_eq!(((huge - huge) * three + huge).verdict(), None);
    assert_eq!((Interval::UNKNOWN * three).verdict(), None);
    assert_eq!((Interval::UNKNOWN + three).verdict(), None);
    assert_eq!((-huge * three).verdict(), Some(Sign::Negative));
}
