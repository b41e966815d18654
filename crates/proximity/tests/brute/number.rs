//! The arithmetic of brute force: the same code over machine integers, where all fits, and over integers of any size.

use exact::{Integer, Rational};
use std::cmp::Ordering;

/// An exact integer.
pub(crate) trait Number: Clone + std::fmt::Debug {
    fn of(value: &Integer) -> Self;
    fn integer(&self) -> Integer;
    fn add(&self, other: &Self) -> Self;
    fn sub(&self, other: &Self) -> Self;
    fn mul(&self, other: &Self) -> Self;
    /// How it compares with zero.
    fn sign(&self) -> Ordering;
    /// The greatest common divisor, not negative.
    fn gcd(&self, other: &Self) -> Self;
    fn div_exact(&self, divisor: &Self) -> Self;
    fn approx(&self) -> f64;
    /// Compares `a / b` with `c / d`; `b` and `d` are positive, `a` and `c` are not negative.
    fn compare_fractions(a: &Self, b: &Self, c: &Self, d: &Self) -> Ordering;

    fn is_zero(&self) -> bool {
        self.sign().is_eq()
    }
}

const FITS: &str = "the numbers of this pair are small";

/// Overflow is a panic in every build.
impl Number for i128 {
    fn of(value: &Integer) -> Self {
        value.to_i128().expect("the coordinates of this pair are small")
    }

    fn integer(&self) -> Integer {
        Integer::from(*self)
    }

    fn add(&self, other: &Self) -> Self {
        self.checked_add(*other).expect(FITS)
    }

    fn sub(&self, other: &Self) -> Self {
        self.checked_sub(*other).expect(FITS)
    }

    fn mul(&self, other: &Self) -> Self {
        self.checked_mul(*other).expect(FITS)
    }

    fn sign(&self) -> Ordering {
        self.cmp(&0)
    }

    fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.abs(), other.abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a
    }

    fn div_exact(&self, divisor: &Self) -> Self {
        self / divisor
    }

    fn approx(&self) -> f64 {
        *self as f64
    }

    /// By the continued fractions of both, so that no product is made.
    fn compare_fractions(a: &Self, b: &Self, c: &Self, d: &Self) -> Ordering {
        let (mut a, mut b, mut c, mut d) = (*a, *b, *c, *d);
        loop {
            let order = (a / b).cmp(&(c / d));
            if order.is_ne() {
                return order;
            }
            (a, c) = (a % b, c % d);
            if a == 0 || c == 0 {
                return a.cmp(&c);
            }
            // The rests a/b and c/d compare as d/c and b/a.
            (a, b, c, d) = (d, c, b, a);
        }
    }
}

impl Number for Integer {
    fn of(value: &Integer) -> Self {
        value.clone()
    }

    fn integer(&self) -> Integer {
        self.clone()
    }

    fn add(&self, other: &Self) -> Self {
        self + other
    }

    fn sub(&self, other: &Self) -> Self {
        self - other
    }

    fn mul(&self, other: &Self) -> Self {
        self * other
    }

    fn sign(&self) -> Ordering {
        self.cmp(&Integer::from(0))
    }

    fn gcd(&self, other: &Self) -> Self {
        Integer::gcd(self, other)
    }

    fn div_exact(&self, divisor: &Self) -> Self {
        Integer::div_exact(self, divisor)
    }

    fn approx(&self) -> f64 {
        self.approx_f64()
    }

    fn compare_fractions(a: &Self, b: &Self, c: &Self, d: &Self) -> Ordering {
        (a * d).cmp(&(c * b))
    }
}

pub(crate) type Triple<N> = [N; 3];

pub(crate) fn plus<N: Number>(a: &Triple<N>, b: &Triple<N>) -> Triple<N> {
    [0, 1, 2].map(|i| a[i].add(&b[i]))
}

pub(crate) fn minus<N: Number>(a: &Triple<N>, b: &Triple<N>) -> Triple<N> {
    [0, 1, 2].map(|i| a[i].sub(&b[i]))
}

pub(crate) fn dot<N: Number>(a: &Triple<N>, b: &Triple<N>) -> N {
    a[0].mul(&b[0]).add(&a[1].mul(&b[1])).add(&a[2].mul(&b[2]))
}

pub(crate) fn cross<N: Number>(a: &Triple<N>, b: &Triple<N>) -> Triple<N> {
    let minor = |i: usize, j: usize| a[i].mul(&b[j]).sub(&a[j].mul(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

pub(crate) fn negated<N: Number>(a: &Triple<N>) -> Triple<N> {
    minus(&minus(a, a), a)
}

pub(crate) fn is_zero<N: Number>(a: &Triple<N>) -> bool {
    a.iter().all(Number::is_zero)
}

/// A fraction that is not negative, with a positive denominator; not in lowest terms.
#[derive(Clone, Debug)]
pub(crate) struct Fraction<N>(pub(crate) N, pub(crate) N);

impl<N: Number> Fraction<N> {
    pub(crate) fn is_less(&self, other: &Self) -> bool {
        N::compare_fractions(&self.0, &self.1, &other.0, &other.1).is_lt()
    }

    /// The number, divided by `scale`.
    pub(crate) fn rational(&self, scale: &Integer) -> Rational {
        Rational::new(self.0.integer(), self.1.integer() * scale).expect("no denominator is zero")
    }
}

/// The smaller of two, where there may be none yet.
pub(crate) fn keep_least<N: Number>(least: &mut Option<Fraction<N>>, candidate: Fraction<N>) {
    if least.as_ref().is_none_or(|least| candidate.is_less(least)) {
        *least = Some(candidate);
    }
}

#[test]
fn fractions_compare_without_products() {
    let huge = i128::MAX / 3;
    let rows = [
        (1, 2, 1, 2, Ordering::Equal),
        (0, 5, 0, 7, Ordering::Equal),
        (0, 5, 1, huge, Ordering::Less),
        (huge, huge - 1, huge + 1, huge, Ordering::Greater),
        (7, 3, 14, 6, Ordering::Equal),
        (22, 7, 355, 113, Ordering::Greater),
        (huge - 1, huge, huge, huge, Ordering::Less),
    ];
    for (a, b, c, d, order) in rows {
        assert_eq!(i128::compare_fractions(&a, &b, &c, &d), order, "{a}/{b} {c}/{d}");
        assert_eq!(i128::compare_fractions(&c, &d, &a, &b), order.reverse(), "{c}/{d} {a}/{b}");
        let [a, b, c, d] = [a, b, c, d].map(Integer::from);
        assert_eq!(Integer::compare_fractions(&a, &b, &c, &d), order, "{a}/{b} {c}/{d}");
    }
}
