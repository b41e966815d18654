use super::*;
use crate::testing::{Random, WIDTHS, assert_nearest};
use std::collections::HashSet;

fn point(text: [&str; 3]) -> Point3 {
    Point3::from_rationals(&text.map(|text| text.parse().unwrap()))
}

fn random_point(random: &mut Random, bits: u32, weight_bits: u32) -> Point3 {
    let weight = random.integer(weight_bits).abs() + Integer::ONE;
    Point3::new(random.vector(bits).coordinates(), weight).unwrap()
}

#[test]
fn only_positive_weights_make_points() {
    for weight in [0, -1, i64::MIN] {
        assert!(Point3::new([1, 2, 3].map(Integer::from), weight.into()).is_none());
    }
    assert_eq!(Point3::new([2, 4, 6].map(Integer::from), 2.into()), Some(Point3::from_i64([1, 2, 3])));
    assert_eq!(Point3::ORIGIN, Point3::from_i64([0, 0, 0]));
}

#[test]
fn narrow_points_end_at_61_bits() {
    let limit = 1_i64 << 61;
    for (value, narrow) in
        [(limit - 1, true), (1 - limit, true), (limit, false), (-limit, false), (i64::MIN, false)]
    {
        let point = Point3::from_i64([0, value, 0]);
        assert_eq!(point.as_narrow().is_some(), narrow, "{value}");
        assert_eq!(point.numerator(1), Integer::from(value));
        assert_eq!(point.bits(), Integer::from(value).bit_len());
    }
    let heavy = Point3::new([1, 1, 1].map(Integer::from), limit.into()).unwrap();
    assert!(heavy.as_narrow().is_none());
    // The difference of the extremes is a narrow vector.
    let [a, b] = [limit - 1, 1 - limit].map(|x| Point3::from_i64([x, x, x]));
    assert_eq!(a.direction_to(&b), Vector3::from_i64([2 * (1 - limit); 3]));
    assert_eq!(a.direction_to(&b).width(), Width::Narrow);
}

#[test]
fn equality_and_order_are_by_value() {
    let sorted = [
        point(["-1/2", "5", "5"]),
        point(["0", "-1", "0"]),
        point(["0", "0", "-1/3"]),
        point(["0", "0", "0"]),
        point(["1/3", "1/2", "0.1"]),
        point(["1/3", "1/2", "1e-1"]),
        point(["1/3", "2/3", "-7"]),
        point(["1e30", "0", "0"]),
    ];
    let factors = [Integer::ONE, Integer::from(6), Integer::ONE << 70];
    for (i, a) in sorted.iter().enumerate() {
        for (j, b) in sorted.iter().enumerate() {
            let expected = if i.abs_diff(j) == 1 && i.min(j) == 4 { Ordering::Equal } else { i.cmp(&j) };
            for (f, g) in factors.iter().flat_map(|f| factors.iter().map(move |g| (f, g))) {
                let scaled = |p: &Point3, factor: &Integer| {
                    Point3::of_homogeneous(p.homogeneous().map(|value| value * factor))
                };
                let (p, q) = (scaled(a, f), scaled(b, g));
                assert_eq!(p.cmp(&q), expected, "{p} {q}");
                assert_eq!(p == q, expected == Ordering::Equal);
                assert_eq!(p.canonical_key() == q.canonical_key(), p == q);
                assert_eq!(p.canonical().homogeneous() == q.canonical().homogeneous(), p == q);
            }
        }
    }
    let keys: HashSet<PointKey> = sorted.iter().map(Point3::canonical_key).collect();
    assert_eq!(keys.len(), sorted.len() - 1);
}

#[test]
fn arithmetic_agrees_with_rationals() {
    let mut random = Random::new(13);
    for bits in WIDTHS {
        for weight_bits in [1, 3, 30, 61, 62, 128] {
            for _ in 0..6 {
                let p = random_point(&mut random, bits, weight_bits);
                let same = random_point(&mut random, bits, 1);
                let q =
                    Point3::new(same.homogeneous()[..3].to_vec().try_into().unwrap(), p.weight()).unwrap();
                let r = random_point(&mut random, 40, 20);
                for other in [&q, &r, &p] {
                    check_pair(&p, other);
                    check_pair(other, &p);
                }
                let canonical = p.canonical();
                assert_eq!(canonical, p);
                assert_eq!(Point3::from_rationals(&p.coordinates()).homogeneous(), canonical.homogeneous());
                for axis in 0..3 {
                    assert_nearest(&p.coordinate(axis), p.approx_f64()[axis]);
                }
            }
        }
    }
}

fn check_pair(p: &Point3, q: &Point3) {
    let (x, y) = (p.coordinates(), q.coordinates());
    let sum = p.plus(q);
    assert_eq!(sum, Point3::from_rationals(&[0, 1, 2].map(|axis: usize| &x[axis] + &y[axis])));
    assert_eq!(sum.weight(), p.weight().lcm(&q.weight()));
    let direction = p.direction_to(q);
    let difference = [0, 1, 2].map(|axis: usize| &y[axis] - &x[axis]);
    // A positive multiple: all cross products vanish, and the signs agree.
    for (axis, part) in difference.iter().enumerate() {
        assert_eq!(direction.sign(axis), part.sign());
        let next = (axis + 1) % 3;
        let (a, b) = (Rational::from(direction.coordinate(axis)), Rational::from(direction.coordinate(next)));
        assert_eq!(a * &difference[next], b * part);
    }
    assert_eq!(direction.is_zero(), p == q);
    assert!(direction.width() == Width::Narrow || direction == direction.primitive());
    assert_eq!(q.direction_to(p), -&direction);
    assert_eq!(p.cmp(q), x.cmp(&y));
}

#[test]
fn points_share_a_weight_if_all_stay_narrow() {
    let scaled = |homogeneous: [i128; 4], factor| Point3::of_i128(homogeneous.map(|value| value * factor));
    let rows: [(&str, Vec<Point3>, Option<i64>); 8] = [
        ("none", vec![], None),
        ("equal already", vec![Point3::from_i64([1, 2, 3]), Point3::from_i64([4, 5, 6])], Some(1)),
        (
            "multiple",
            vec![point(["1/2", "0", "0"]), point(["1/3", "0", "0"]), point(["1/4", "5", "0"])],
            Some(12),
        ),
        ("multiple as given", vec![Point3::of_i128([2, 4, 6, 8]), Point3::of_i128([3, 3, 3, 6])], Some(24)),
        (
            "canonical where needed",
            vec![scaled([1, 1, 1, 1], 1 << 58), scaled([1, 1, 1, 2], 3_i128.pow(36))],
            Some(2),
        ),
        ("wide weight", vec![point(["1e-10", "0", "0"]), point(["0", "1/1000000007", "0"])], None),
        ("wide numerator", vec![point(["1000000000000000000", "0", "0"]), point(["1/7", "0", "0"])], None),
        ("wide point", vec![point(["1e30", "0", "0"]), point(["1/7", "0", "0"])], None),
    ];
    for (name, points, weight) in rows {
        let mut shared = points.clone();
        share_weight(&mut shared);
        assert_eq!(shared, points, "{name}");
        for (now, before) in shared.iter().zip(&points) {
            match weight {
                Some(weight) => assert_eq!(now.weight(), Integer::from(weight), "{name}"),
                None => assert_eq!(now.homogeneous(), before.canonical().homogeneous(), "{name}"),
            }
        }
    }
}

#[test]
fn wide_points_of_equal_weight_become_narrow_where_they_can() {
    let factor = Integer::ONE << 80;
    let wide = |x: i64| Point3::of_homogeneous([x, 1, 0, 2].map(|value| Integer::from(value) * &factor));
    let mut points = vec![wide(3), wide(4), wide(5)];
    share_weight(&mut points);
    assert!(points.iter().all(|point| point.as_narrow().is_some_and(|homogeneous| homogeneous[3] == 2)));
    assert_eq!(points[1].to_string(), "(2, 1/2, 0)");
}

#[test]
fn an_adder_adds_whatever_came_before() {
    let mut random = Random::new(77);
    let mut adder = Adder::default();
    for _ in 0..4_000 {
        let bits = [3, 30, 60, 61, 62, 90][random.below(6) as usize];
        let [p, q] = [(); 2].map(|()| {
            let weight_bits = [1, 3, 40][random.below(3) as usize];
            random_point(&mut random, bits, weight_bits)
        });
        let sum = adder.sum(&p, &q);
        let expected = [0, 1, 2].map(|axis| p.coordinate(axis) + q.coordinate(axis));
        assert_eq!(sum.coordinates(), expected, "{p} {q}");
        assert_eq!(p.plus(&q), sum);
    }
}

#[test]
fn points_of_floats_are_exact_and_canonical() {
    let tiny = f64::from_bits(1);
    let (large, limit) = ((1_u64 << 53) as f64, (1_u64 << 60) as f64);
    // Whether the point is narrow.
    let rows = [
        ([0.0, 0.0, -0.0], true),
        ([1.0, -2.0, 3.0], true),
        ([2.0, 4.0, -8.0], true),
        ([0.1, -0.25, 1e3], false),
        ([0.1, 0.1, -0.2], true),
        ([f64::from(0.1_f32), f64::from(-1e3_f32), f64::from(1.0e-3_f32)], true),
        ([large - 1.0, 1.0 / 128.0, -0.0], true),
        ([large - 1.0, 1.0 / 256.0, 0.0], true),
        ([large - 1.0, 1.0 / 512.0, 0.0], false),
        ([limit, -limit, 1.0], true),
        ([2.0 * limit - 256.0, 0.0, 1.0], true),
        ([2.0 * limit, 0.0, 0.0], false),
        ([-2.0 * limit, 0.0, 0.0], false),
        ([1.0 / limit, -1.0, 0.0], true),
        ([1.0 / limit, 2.0, 0.0], false),
        ([0.5 / limit, 0.0, 0.0], false),
        ([tiny, -tiny, 0.0], false),
        ([f64::MIN_POSITIVE, 1.0, 0.0], false),
        ([f64::MAX, f64::MIN, tiny], false),
        ([1e300, 1e300, 1e300], false),
    ];
    for (floats, narrow) in rows {
        let point = Point3::from_f64s(floats).unwrap();
        let expected = Point3::from_rationals(&floats.map(|value| Rational::try_from(value).unwrap()));
        assert_eq!(point.homogeneous(), expected.homogeneous(), "{floats:?}");
        assert_eq!(point.homogeneous(), point.canonical().homogeneous(), "{floats:?}");
        assert_eq!(point.as_narrow().is_some(), narrow, "{floats:?}");
    }
    for not_finite in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..3 {
            let mut floats = [0.0, 1.5, tiny];
            floats[axis] = not_finite;
            assert!(Point3::from_f64s(floats).is_none());
        }
    }
}

#[test]
fn points_of_generated_floats_agree_with_rationals() {
    let mut random = Random::new(17);
    let mut narrow = 0;
    for round in 0..3_000_u64 {
        // Exponents around zero, and all of them.
        let floats = [(); 3].map(|()| {
            let exponent = if round % 4 == 0 { random.below(2047) } else { 1023 - 30 + random.below(60) };
            let digits = (random.next() >> 12) & (u64::MAX << random.below(53));
            f64::from_bits(random.below(2) << 63 | exponent << 52 | digits)
        });
        let point = Point3::from_f64s(floats).unwrap();
        let expected = Point3::from_rationals(&floats.map(|value| Rational::try_from(value).unwrap()));
        assert_eq!(point.homogeneous(), expected.homogeneous(), "{floats:?}");
        assert_eq!(point.approx_f64(), floats.map(|value| value + 0.0), "{floats:?}");
        narrow += u32::from(point.as_narrow().is_some());
    }
    assert!((100..2_900).contains(&narrow), "{narrow}");
}
