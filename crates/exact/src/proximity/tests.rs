//! The filters against exact arithmetic, for coordinates of all sizes.

use super::*;
use crate::testing::{Random, WIDTHS};
use crate::tier::{Start, force};
use crate::{Point3, Rational, Sign, Vector3, predicate};
use std::cmp::Ordering;

fn point(random: &mut Random, bits: u32) -> Point3 {
    let weight = random.integer(bits).abs() + crate::Integer::ONE;
    Point3::new([(); 3].map(|()| random.integer(bits)), weight).expect("the weight is positive")
}

/// A normal that is not zero, and points of about this size; one of three times the second point lies in the plane.
fn plane(random: &mut Random, bits: u32) -> (Vector3, Point3, Point3) {
    let normal = random.vector(bits);
    let normal = if normal.is_zero() { Vector3::from_i64([0, 0, 1]) } else { normal };
    let on = point(random, bits);
    let other = if random.below(3) == 0 {
        // Along a vector in the plane.
        let across = normal.cross(&random.vector(bits)).coordinates();
        let part = Rational::new(random.integer(20), 7.into()).expect("seven is not zero");
        let move_by = across.map(|c| Rational::from(c) * &part);
        on.plus(&Point3::from_rationals(&move_by))
    } else {
        point(random, bits)
    };
    (normal, on, other)
}

#[test]
fn planes_of_floats_tell_the_exact_side_or_nothing() {
    let _guard = force(Start::Usual);
    let random = &mut Random::new(31);
    let mut told = 0;
    for bits in WIDTHS {
        for _ in 0..300 {
            let (normal, on, other) = plane(random, bits);
            let floats = PlaneFloats::new(&normal, &on);
            let exact = predicate::plane_side(&normal, &on, &other);
            if let Some(side) = floats.side(&QueryPoint::new(other.clone())) {
                assert_eq!(side, exact, "{normal} {on} {other}");
                told += 1;
            }
        }
    }
    assert!(told > 2000, "{told}");
}

#[test]
fn float_points_of_all_magnitudes_are_exact() {
    let random = &mut Random::new(32);
    for _ in 0..20_000 {
        let mut float = || {
            let exponent = random.below(2100) as i32 - 1070;
            let digits = random.around_zero(1 << 52) as f64;
            match random.below(8) {
                0 => 0.0,
                1 => digits * 2f64.powi(exponent.min(900)),
                _ => digits * 2f64.powi(exponent % 60 - 50),
            }
        };
        let floats = [float(), float(), float()];
        let bits = if floats[0].to_bits() & 1 == 0 { 20 } else { 90 };
        let query = QueryPoint::from_f64(floats).expect("the numbers are finite");
        assert_eq!(*query.point(), Point3::from_f64s(floats).expect("the numbers are finite"));
        let (normal, on, _) = plane(random, bits);
        if let Some(side) = PlaneFloats::new(&normal, &on).side(&query) {
            assert_eq!(side, predicate::plane_side(&normal, &on, query.point()), "{normal} {on} {floats:?}");
        }
    }
    assert!(QueryPoint::from_f64([0.0, f64::INFINITY, 0.0]).is_none());
}

/// The signed depth below a plane, squared with its sign.
fn signed_square(normal: &Vector3, on: &Point3, p: &Point3) -> Rational {
    let n = normal.coordinates().map(Rational::from);
    let (a, b) = (on.coordinates(), p.coordinates());
    let height: Rational = (0..3).map(|i| &n[i] * &(&a[i] - &b[i])).sum();
    let length: Rational = n.iter().map(|c| c * c).sum();
    (&height * &height.abs()).checked_div(&length).expect("the normal is not zero")
}

#[test]
fn bounds_of_depths_hold_and_exact_depths_compare() {
    let _guard = force(Start::Usual);
    let random = &mut Random::new(33);
    let mut told = 0;
    for bits in WIDTHS {
        for _ in 0..200 {
            let (normal, on, other) = plane(random, bits);
            let (second, beside, _) = plane(random, bits);
            let query = QueryPoint::new(other.clone());
            let at = DepthPoint::new(&query);
            let planes = [DepthPlane::new(&normal, &on), DepthPlane::new(&second, &beside)];
            let exact = [signed_square(&normal, &on, &other), signed_square(&second, &beside, &other)];
            let depths = planes.map(|plane| plane.depth(&at));
            for (depth, exact) in depths.iter().zip(&exact) {
                assert!(!depth.is_positive() || exact.sign() == Sign::Positive, "{normal} {on} {other}");
                assert!(!depth.is_negative() || exact.sign() == Sign::Negative, "{normal} {on} {other}");
            }
            if depths[0].is_below(&depths[1]) {
                assert!(exact[0] < exact[1], "{normal} {on} {second} {beside} {other}");
                told += 1;
            }
            let bounds = DepthCap::of(planes.iter()).least_depth(&at);
            for depth in &depths {
                assert!(!depth.is_below(&bounds), "{normal} {on} {second} {beside} {other}");
            }
            if exact.iter().all(|depth| depth.sign() == Sign::Positive) {
                let order = compare_depths(&other, (&normal, &on), (&second, &beside));
                assert_eq!(order, exact[0].cmp(&exact[1]));
            }
        }
    }
    assert!(told > 500, "{told}");
}

#[test]
fn parallel_planes_are_told_apart_exactly() {
    let (first, second) = (Vector3::from_i64([2, 4, 4]), Vector3::from_i64([-3, -6, -6]));
    let [on, other] = [[1, 1, 1], [-1, -1, -1]].map(Point3::from_i64);
    let order = compare_depths(&Point3::ORIGIN, (&first, &on), (&second, &other));
    assert_eq!(order, Ordering::Equal);
    let nearer = Point3::from_rationals(&["1e-30", "0", "0"].map(|c| c.parse().expect("a number")));
    assert_eq!(compare_depths(&nearer, (&first, &on), (&second, &other)), Ordering::Less);
}

#[test]
fn every_tier_tells_the_same_side_of_a_ray() {
    let random = &mut Random::new(34);
    for bits in [5, 30, 55, 61, 64, 130, 1100] {
        for _ in 0..60 {
            let (apex, on) = (point(random, bits), point(random, bits));
            let ray = random.vector(bits);
            // Sometimes in the plane of the apex and the ray.
            let edge = match random.below(3) {
                0 => &ray.scaled(&3.into()) + &apex.direction_to(&on),
                _ => random.vector(bits),
            };
            let away = apex.direction_to(&on);
            let exact = away.cross(&edge).dot(&ray).sign();
            for start in [Start::Usual, Start::Float, Start::Fixed, Start::Interval, Start::Big] {
                let _guard = force(start);
                assert_eq!(side_of_ray(&apex, &ray, &edge, &on), exact, "{start:?} {apex} {ray} {edge} {on}");
            }
        }
    }
}
