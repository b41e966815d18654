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

/// Checks that the lower bound of a cap is not above the depth below any of its planes; tells whether there is one.
fn cap_holds(planes: &[(Vector3, Point3)], p: &Point3) -> bool {
    let rounded: Vec<DepthPlane> = planes.iter().map(|(normal, on)| DepthPlane::new(normal, on)).collect();
    let at = DepthPoint::new(&QueryPoint::new(p.clone()));
    let low = DepthCap::of(rounded.iter()).least_depth(&at).approx_low();
    assert!(low < f64::INFINITY || low.is_nan(), "{planes:?} {p}");
    let Ok(exact) = Rational::try_from(low) else { return false };
    let square = &exact * &exact.abs();
    for ((normal, on), plane) in planes.iter().zip(&rounded) {
        let depth = signed_square(normal, on, p);
        assert!(
            square <= depth,
            "{low} is above the depth below {normal} {on} in the cap of {planes:?}: {p}"
        );
        let bounds = plane.depth(&at);
        let held = Rational::try_from(bounds.approx_low()).is_ok_and(|low| &low * &low.abs() <= depth);
        assert!(held || !bounds.approx_low().is_finite(), "{normal} {on} {p}");
    }
    true
}

/// Normals of caps: one, several nearly parallel ones, wide ones, and such that cancel.
fn caps(k: i64) -> Vec<Vec<[i64; 3]>> {
    vec![
        vec![[k, 1, 0]],
        vec![[k + 3, k, 1 - k]],
        vec![[k, 1, 0], [k, 0, 1]],
        vec![[k, 1, 0], [k, -1, 0]],
        vec![[k, 3, 1], [k, -1, -1], [k, 0, 2], [k, 3, 1]],
        vec![[k, k, 1], [k, k + 1, 0]],
        vec![[k, k - 1, 0], [k, 1 - k, 0]],
        vec![[1, k, 0], [1, -k, 0]],
        vec![[3, 4, 0], [3, -4, 0], [5, 0, 0]],
        vec![[k, 1, 0], [-k, -1, 0]],
        vec![[k, 0, 0], [-k, 1, 0], [0, 0, k]],
    ]
}

/// Directions from which a cap is seen in every special way: along its axis or a normal, opposite, in a plane, and close to these.
fn views(normals: &[[i64; 3]], random: &mut Random) -> Vec<Vector3> {
    let [first, last] = [normals[0], normals[normals.len() - 1]].map(Vector3::from_i64);
    let axis = &first + &last;
    let across = first.cross(&last);
    let mut views = vec![first.clone(), last.clone(), axis.clone(), across.clone()];
    views.extend([
        first.cross(&across),
        last.cross(&across),
        Vector3::from_i64([0, 1, 0]),
        Vector3::from_i64([1, 0, 0]),
    ]);
    let far = |factor: i64| first.scaled(&factor.into());
    for _ in 0..4 {
        let factor = (1 << 30) + random.around_zero(1 << 20);
        let beside = Vector3::from_i64([0, 1 + random.below(3) as i64, random.around_zero(2)]);
        views.push(&far(factor) + &beside);
        views.push(&axis.scaled(&factor.into()) + &beside);
        views.push(&Vector3::from_i64([factor, 0, 0]) + &beside);
    }
    views.iter().flat_map(|view| [view.clone(), -view]).collect()
}

fn times_power_of_two(vector: &Vector3, exponent: i32) -> Point3 {
    let (up, down) = (exponent.max(0).unsigned_abs(), exponent.min(0).unsigned_abs());
    let one = crate::Integer::ONE;
    Point3::new(vector.coordinates().map(|c| c << up), one << down).expect("a power of two is not zero")
}

#[test]
fn bounds_of_caps_are_not_above_the_depth_seen_from_anywhere() {
    let _guard = force(Start::Usual);
    let random = &mut Random::new(35);
    let (mut told, mut count) = (0, 0);
    for k in [1 << 10, 1 << 20, (1 << 26) + 1, 1 << 30, 1 << 40] {
        for normals in caps(k) {
            for on in [[0, 0, 0], [1, 1, 1], [(1 << 50) + 1, 7, -3]].map(Point3::from_i64) {
                let planes: Vec<_> = normals.iter().map(|n| (Vector3::from_i64(*n), on.clone())).collect();
                for view in views(&normals, random) {
                    for exponent in [0, 500, -500, 1000, -1000] {
                        told += usize::from(cap_holds(&planes, &times_power_of_two(&view, exponent)));
                        count += 1;
                    }
                }
            }
        }
    }
    assert!(told > count * 3 / 5, "{told} of {count}");
}

#[test]
fn offsets_and_normals_beyond_the_range_of_floats_have_no_bounds() {
    let _guard = force(Start::Usual);
    let far = times_power_of_two(&Vector3::from_i64([1, 1, 1]), 1100);
    let (x, y) = (Vector3::from_i64([1, 0, 0]), Vector3::from_i64([1 << 30, 1, 0]));
    let wide = Vector3::new([1, 3, 5].map(|c| crate::Integer::from(c) << 1100_u32));
    let near = Point3::from_i64([1, 2, 3]);
    for planes in [
        vec![(x.clone(), far.clone())],
        vec![(x.clone(), near.clone()), (y.clone(), far.clone())],
        vec![(wide, near.clone()), (y, near.clone())],
    ] {
        for p in [&near, &Point3::ORIGIN, &far] {
            assert!(!cap_holds(&planes, p), "{planes:?} {p}");
        }
    }
    // The same below a plane that is near: no depth is told.
    let depth = DepthPlane::new(&x, &near).depth(&DepthPoint::new(&QueryPoint::new(far)));
    assert!(!depth.is_positive() && !depth.is_negative());
}

#[test]
fn dust_on_a_coordinate_does_not_spoil_the_filters() {
    let _guard = force(Start::Usual);
    let (normal, on) = (Vector3::from_i64([3, 4, -5]), Point3::from_i64([1, 2, 3]));
    for dust in [f64::from_bits(1), -1e-320, 1e-310, 1e-300, 1e-295] {
        for floats in [[0.25, dust, 0.5], [dust, 0.0, -7.5], [dust, dust, dust], [dust, 0.0, 1e20]] {
            let query = QueryPoint::from_f64(floats).expect("the numbers are finite");
            let side = PlaneFloats::new(&normal, &on).side(&query);
            assert_eq!(side, Some(predicate::plane_side(&normal, &on, query.point())), "{floats:?}");
            let depth = DepthPlane::new(&normal, &on).depth(&DepthPoint::new(&query));
            assert_eq!(depth.is_negative(), side == Some(Sign::Positive), "{floats:?}");
            assert_eq!(depth.is_positive(), side == Some(Sign::Negative), "{floats:?}");
            assert!(cap_holds(&[(normal.clone(), on.clone())], query.point()));
        }
    }
    // Too wide even for reduced floats: the depth is still bounded.
    let tiny = Rational::new(1.into(), crate::Integer::ONE << 3000_u32).expect("a power of two is not zero");
    let query = QueryPoint::new(Point3::from_rationals(&[tiny, Rational::ZERO, Rational::ONE]));
    let depth = DepthPlane::new(&normal, &on).depth(&DepthPoint::new(&query));
    assert!(depth.is_positive() && PlaneFloats::new(&normal, &on).side(&query).is_none());
}
