use super::*;
use crate::predicate::{cross, dot};
use crate::testing::Random;

/// Coordinates of degree 1 and 2 for the filter, and the same in machine integers.
type Row = [i64; 3];

fn filtered(row: Row) -> [Filtered; 3] {
    row.map(|value| Filtered::of_nearest(value as f64))
}

/// The cross product, exact and then rounded.
fn normal(a: Row, b: Row) -> [Filtered; 3] {
    let minor = |i: usize, j: usize| {
        Filtered::of_nearest(
            (i128::from(a[i]) * i128::from(b[j]) - i128::from(a[j]) * i128::from(b[i])) as f64,
        )
    };
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// A determinant of three rows below 2^62, exactly, as a sign.
fn exact_sign([a, b, c]: [Row; 3]) -> Sign {
    use crate::fixed::Fixed;
    let [a, b, c] = [a, b, c].map(|row| row.map(Fixed::<1>::from));
    let minors: [Fixed<2>; 3] = cross(a, b);
    let sum: Fixed<3> = dot(minors, c);
    sum.sign()
}

struct Tally {
    cases: u32,
    decided: u32,
    zeros: u32,
}

/// Determinants whose third row is a combination of the others and a noise of 2^noise.
fn near_degenerate(seed: u64, bits: u32, noise: Option<u32>, cases: u32) -> Tally {
    let mut random = Random::new(seed);
    let mut tally = Tally { cases, decided: 0, zeros: 0 };
    for _ in 0..cases {
        let mut row = || [(); 3].map(|()| random.next() as i64 >> (64 - bits + 3));
        let (a, b) = (row(), row());
        let (k, l) = (random.around_zero(3), random.around_zero(3));
        let c = [0, 1, 2].map(|i: usize| {
            let noise = noise.map_or(0, |noise| random.around_zero(1 << noise));
            k * a[i] + l * b[i] + noise
        });
        let exact = exact_sign([a, b, c]);
        tally.zeros += u32::from(exact.is_zero());
        if let Some(sign) = dot(cross(filtered(a), filtered(b)), filtered(c)).verdict() {
            assert_eq!(sign, exact, "det {a:?} {b:?} {c:?}");
            tally.decided += 1;
        }
        // The same determinant with leaves of degree 2, and a . ((a x b) x (a x c)) = |a|^2 det(a, b, c), of degree 5.
        let (normal, other) = (normal(a, b), normal(a, c));
        for sign in
            [dot(normal, filtered(c)), dot(cross(normal, other), filtered(a))].map(|sum| sum.verdict())
        {
            assert!(sign.is_none_or(|sign| sign == exact), "normals of {a:?} {b:?} {c:?}");
        }
    }
    tally
}

#[test]
fn a_decided_sign_is_never_wrong_and_giving_up_is_bounded() {
    // bits, noise, the least share of those that are not zero that the filter must decide (percent)
    let rows = [
        (20, Some(0), 99),
        (32, Some(0), 99),
        (53, Some(0), 20),
        (53, Some(10), 98),
        (53, Some(17), 99),
        (62, Some(0), 1),
        (62, Some(10), 30),
        (62, Some(21), 99),
        // Exactly degenerate.
        (62, None, 0),
        (53, None, 0),
    ];
    let mut cases = 0;
    for (seed, (bits, noise, least)) in rows.into_iter().enumerate() {
        let tally = near_degenerate(100 + seed as u64, bits, noise, 150_000);
        cases += tally.cases;
        if noise.is_none() {
            assert_eq!(tally.zeros, tally.cases);
            continue;
        }
        let nonzero = u64::from(tally.cases - tally.zeros);
        let percent = 100 * u64::from(tally.decided) / nonzero;
        eprintln!("{bits} bits, noise {noise:?}: {percent} % decided, {} zeros", tally.zeros);
        assert!(percent >= least, "{bits} bits, noise {noise:?}: only {percent} % decided");
    }
    assert!(cases >= 1_000_000);
}

/// The rule for the rounds, with the bound made visible: a value just above the bound decides, one just below does not.
#[test]
fn the_bound_follows_the_rounds() {
    let number = |value: f64| Filtered::of_nearest(value);
    let (a, b) = (number(3.0), number(5.0));
    assert_eq!((a.rounds, (a * b).rounds, (a + b).rounds, (-a).rounds), (1, 3, 2, 1));
    let dot_product = dot([a, a, b], [b, a, b]);
    assert_eq!((dot_product.rounds, dot_product.value, dot_product.magnitude), (5, 49.0, 49.0));
    assert_eq!(dot(cross([a, a, b], [b, a, a]), [a, b, a]).rounds, 8);
    let large = number(2.0_f64.powi(60));
    // rounds + 1 = 3, magnitude 2^61: the bound is 3 * 2^8.
    for (small, verdict) in [(768.0, None), (1024.0, Some(Sign::Positive))] {
        let sum = Filtered { value: small, ..large + -large };
        assert_eq!((sum.rounds, sum.verdict()), (2, verdict));
        assert_eq!((-sum).verdict(), verdict.map(|sign| -sign));
    }
}

#[test]
fn zero_terms_are_exact_and_overflow_decides_nothing() {
    let [zero, one, huge, infinite] = [0.0, 1.0, 1e300, f64::INFINITY].map(Filtered::of_nearest);
    assert_eq!((zero * one - zero).verdict(), Some(Sign::Zero));
    assert_eq!((zero * huge + one).verdict(), Some(Sign::Positive));
    assert_eq!((huge * huge).verdict(), None);
    assert_eq!((huge * huge - huge * huge).verdict(), None);
    assert_eq!((zero * infinite).verdict(), None);
    assert_eq!((one - infinite).verdict(), None);
    assert_eq!((huge + one - huge).verdict(), None);
}
