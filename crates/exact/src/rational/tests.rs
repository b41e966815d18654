use super::*;
use crate::testing::{Random, assert_nearest};

fn number(text: &str) -> Rational {
    text.parse().unwrap()
}

#[test]
fn lowest_terms_and_positive_denominators() {
    for (p, q, shown) in [(6, -4, "-3/2"), (-6, -3, "2"), (0, -7, "0"), (5, 5, "1"), (-1, 3, "-1/3")] {
        let value = Rational::new(p.into(), q.into()).unwrap();
        assert_eq!(value.to_string(), shown);
        assert_eq!(value.denominator().sign(), Sign::Positive);
        assert_eq!(Rational::new(value.numerator(), value.denominator()), Some(value));
    }
    assert_eq!(Rational::new(1.into(), 0.into()), None);
}

#[test]
fn field_laws_hold() {
    let values = ["0", "1", "-1", "2/3", "-7/5", "1e-30", "123456789123456789123/1000000007"].map(number);
    for a in &values {
        assert_eq!(a - a, Rational::ZERO);
        assert_eq!(a.abs().sign(), a.sign() * a.sign());
        match a.recip() {
            Some(inverse) => assert_eq!(a * &inverse, Rational::ONE),
            None => assert!(a.is_zero()),
        }
        for b in &values {
            assert_eq!(a + b, b + a);
            assert_eq!(&(a - b) + b, *a);
            assert_eq!((a - b).sign(), Sign::from(a.cmp(b)));
            match a.checked_div(b) {
                Some(quotient) => assert_eq!(&quotient * b, *a),
                None => assert!(b.is_zero()),
            }
        }
    }
    assert_eq!(
        [number("-7/2").floor(), number("7/2").floor(), number("-3").floor()],
        [-4, 3, -3].map(Integer::from)
    );
}

#[test]
fn floats_are_read_as_they_are() {
    for (value, shown) in
        [(0.5, "1/2"), (-0.0, "0"), (3.0, "3"), (-1.25, "-5/4"), (1e23, "99999999999999991611392")]
    {
        assert_eq!(Rational::try_from(value).unwrap().to_string(), shown);
    }
    assert_ne!(Rational::try_from(0.1).unwrap(), number("0.1"));
    for value in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        assert_eq!(Rational::try_from(value), Err(NotFinite));
    }
    let mut random = Random::new(3);
    for _ in 0..2000 {
        let value = f64::from_bits(random.next());
        if value.is_finite() {
            assert_eq!(
                Rational::try_from(value).unwrap().approx_f64().to_bits(),
                value.to_bits(),
                "{value:e}"
            );
        }
    }
    for value in [5e-324, f64::MIN_POSITIVE, f64::MAX, -f64::MIN_POSITIVE / 2.0] {
        assert_eq!(Rational::try_from(value).unwrap().approx_f64(), value);
    }
}

#[test]
fn rounding_is_to_nearest_and_ties_to_even() {
    let mut random = Random::new(4);
    for _ in 0..3000 {
        let bits = [3, 40, 53, 54, 64, 65, 128, 300, 1100][random.below(9) as usize];
        let other = [1, 10, 53, 64, 90, 200, 1080, 1200][random.below(8) as usize];
        let value = Rational::new(random.integer(bits), random.integer(other));
        if let Some(value) = value {
            assert_nearest(&value, value.approx_f64());
        }
    }
    // Midpoints of neighbouring floats, and points just beside them.
    for _ in 0..1000 {
        let low = f64::from_bits(random.next() >> 1);
        if !low.is_finite() || !low.next_up().is_finite() {
            continue;
        }
        let sum = Rational::try_from(low).unwrap() + Rational::try_from(low.next_up()).unwrap();
        let middle = sum * number("1/2");
        let little = number("1e-400");
        for value in [&middle + &little, &middle - &little, middle] {
            assert_nearest(&value, value.approx_f64());
            assert_nearest(&-&value, -value.approx_f64());
        }
    }
}

#[test]
fn rounding_at_the_ends_of_the_range() {
    // Half of the least subnormal number is a tie with zero.
    let least = Rational::try_from(5e-324).unwrap();
    let half = &least * &number("1/2");
    assert_eq!(half.approx_f64(), 0.0);
    assert_eq!((&half + &number("1e-400")).approx_f64(), 5e-324);
    assert_eq!((&half * &number("3")).approx_f64(), 1e-323);
    assert_eq!(number("-1e-400").approx_f64(), 0.0);
    // The midpoint between the greatest float and 2^1024 rounds to infinity.
    let beyond = Rational::from((Integer::ONE << 1024) - (Integer::ONE << 970));
    assert_eq!((&beyond + &number("1/3")).approx_f64(), f64::INFINITY);
    assert_eq!((&beyond - &number("1/3")).approx_f64(), f64::MAX);
    assert_eq!((&number("1/3") - &beyond).approx_f64(), -f64::MAX);
    assert_eq!(number("1/3").approx_f64(), 1.0 / 3.0);
    assert_eq!(number("0.1").approx_f64(), 0.1);
}
