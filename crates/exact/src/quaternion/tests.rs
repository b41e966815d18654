use super::*;
use crate::testing::Random;

fn axis(text: &str) -> [Rational; 3] {
    let parts: Vec<Rational> = text.split(' ').map(|part| part.parse().unwrap()).collect();
    parts.try_into().unwrap()
}

fn nearest(axis_text: &str, degrees: &str) -> Quaternion {
    Quaternion::nearest(axis(axis_text), degrees.parse().unwrap()).unwrap()
}

/// Times 2^BITS.
fn scaled(value: &Rational) -> Scaled {
    times(value, &(Integer::ONE << BITS))
}

/// Measures the rotation of a quaternion against the asked one, in fixed point with an error far below the bounds: the angle
/// of the rotation between the two, and the angle between the axes, both in radians and bounded by `limit`.
fn assert_close(quaternion: &Quaternion, axis: &[Rational; 3], degrees: &Rational) {
    let half = times(&(degrees * &fraction(1, 360)), &pi());
    // The series is meant for small angles: an angle beyond half a turn is halved by the caller's choice of degrees.
    let (sine, cosine) = sine_cosine(&half);
    let numerators = Point3::from_rationals(axis).homogeneous();
    let exact = &numerators[..3];
    let square: Integer = exact.iter().map(|value| value * value).sum();
    let length = (square << (2 * BITS)).sqrt_floor().unwrap();
    // The asked unit quaternion.
    let asked =
        [cosine].into_iter().chain(exact.iter().map(|a| (a * (sine.clone() << BITS)).div_round(&length)));
    let components = quaternion.components();
    let product: Integer = components.iter().zip(asked).map(|(a, b)| a * b).sum();
    let norm: Integer = components.iter().map(|value| value * value).sum();
    // product^2 / norm = cos^2 of half of the angle between the rotations.
    let one = Rational::ONE;
    let cosine_square = Rational::new(&product * &product, norm << (2 * BITS)).unwrap();
    let limit: Rational = "5e-13".parse().unwrap();
    assert!(&one - &cosine_square <= &limit * &limit, "rotation {quaternion} about {axis:?} by {degrees}");
    let [_, x, y, z] = components;
    let [a, b, c] = [&exact[0], &exact[1], &exact[2]];
    let crossed = [y * c - z * b, z * a - x * c, x * b - y * a];
    let sine_square: Integer = crossed.iter().map(|value| value * value).sum();
    let lengths = (a * a + b * b + c * c) * (x * x + y * y + z * z);
    assert!(
        scaled(&Rational::from(sine_square)) <= times(&(&limit * &limit), &(lengths << BITS)),
        "axis of {quaternion} about {axis:?}"
    );
}

#[test]
fn simple_rotations_are_exact() {
    let rows = [
        ("0 0 1", "0", "1,0,0,0"),
        ("0 0 1", "90", "1,0,0,1"),
        ("0 0 -1", "90", "1,0,0,-1"),
        ("0 0.001 0", "90", "1,0,1,0"),
        ("0 0 1", "180", "0,0,0,1"),
        ("0 0 1", "-180", "0,0,0,1"),
        ("1 0 0", "270", "1,-1,0,0"),
        ("1 0 0", "-90", "1,-1,0,0"),
        ("1 0 0", "360", "1,0,0,0"),
        ("1 0 0", "3690", "1,1,0,0"),
        ("1 1 1", "120", "1,1,1,1"),
        ("1 1 1", "-120", "1,-1,-1,-1"),
        ("1/3 1/3 -1/3", "240", "1,-1,-1,1"),
        ("3 -4 12", "180", "0,3,-4,12"),
        ("1 1 0", "180", "0,1,1,0"),
        ("7 2 5", "1e-11", "1,0,0,0"),
        ("7 2 5", "179.99999999999", "0,7,2,5"),
    ];
    for (axis, degrees, shown) in rows {
        assert_eq!(nearest(axis, degrees).to_string(), shown, "{axis} by {degrees}");
    }
    assert_eq!(Quaternion::nearest(axis("0 0 0"), Rational::from(90)), Err(ZeroAxis));
}

#[test]
fn every_rotation_keeps_its_bound_and_is_small() {
    let mut random = Random::new(20);
    // The greatest number of bits of the components, per kind of axis; right beside a simple fraction it takes more.
    let kinds = ["0 0 1", "0 -1 0", "1 1 1", "1 2 3", "0.267261 0.534522 0.801784", "1e-300 2 1e300", "axis"];
    let limits = [26, 26, 28, 30, 44, 48, 70];
    for (kind, limit) in kinds.into_iter().zip(limits) {
        for _ in 0..60 {
            let axis = if kind == "axis" {
                // Long coordinates: here the axis is rounded.
                [(); 3].map(|()| {
                    Rational::new(random.integer(120), random.integer(90).abs() + Integer::ONE).unwrap()
                })
            } else {
                axis(kind)
            };
            let special = random.below(5);
            let degrees = match special {
                0 => random.around_zero(360).into(),
                1 => fraction(random.around_zero(360_000_000_000), 1_000_000_000),
                2 => fraction(random.around_zero(1_000_000), 1_000_000_000_000),
                3 => Rational::from(180) - fraction(random.around_zero(1_000_000), 1_000_000_000_000),
                _ => Rational::from(90) + fraction(random.around_zero(1_000_000), 1_000_000_000_000),
            };
            let Ok(quaternion) = Quaternion::nearest(axis.clone(), degrees.clone()) else { continue };
            assert_close(&quaternion, &axis, &within_half_turn(degrees));
            let limit = if special < 2 { limit } else { limit + 20 };
            assert!(quaternion.bits() <= limit, "{} bits about {axis:?}: {quaternion}", quaternion.bits());
        }
    }
}

#[test]
fn the_turn_is_counterclockwise() {
    // Against the formula of Rodrigues in floating point, an independent way.
    for (text, degrees) in [("0 0 1", "37"), ("1 2 -3", "-100.5"), ("-2 0.5 1", "233")] {
        let vector = axis(text).map(|value| value.approx_f64());
        let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [x, y, z] = vector.map(|value| value / length);
        let angle = degrees.parse::<f64>().unwrap().to_radians();
        let (s, c) = angle.sin_cos();
        let d = 1.0 - c;
        let expected = [
            [c + x * x * d, x * y * d - z * s, x * z * d + y * s],
            [y * x * d + z * s, c + y * y * d, y * z * d - x * s],
            [z * x * d - y * s, z * y * d + x * s, c + z * z * d],
        ];
        let (rows, denominator) = nearest(text, degrees).matrix();
        for (row, expected) in rows.iter().zip(expected) {
            for (entry, expected) in row.iter().zip(expected) {
                let entry = Rational::new(entry.clone(), denominator.clone()).unwrap().approx_f64();
                assert!((entry - expected).abs() < 3e-12, "{text} by {degrees}: {entry} {expected}");
            }
        }
    }
}

#[test]
fn multiples_are_one_quaternion() {
    let make = |components: [i64; 4]| Quaternion::new(components.map(Integer::from));
    assert_eq!(make([0, 0, 0, 0]), None);
    assert_eq!(make([-2, 4, 0, -6]), make([1, -2, 0, 3]));
    assert_eq!(make([0, 0, -5, 0]).unwrap().to_string(), "0,0,1,0");
    let rationals = ["1/2", "-1/3", "0", "0.25"].map(|text| text.parse().unwrap());
    assert_eq!(Quaternion::from_rationals(&rationals), make([6, -4, 0, 3]));
    assert_eq!(Quaternion::from_rationals(&[const { Rational::ZERO }; 4]), None);
    assert_eq!(Quaternion::identity().bits(), 1);
}

#[test]
fn the_simplest_fraction_is_found() {
    let number = |text: &str| text.parse::<Rational>().unwrap();
    let rows = [
        ("1/3", "1/3", "1/3"),
        ("1/3", "1/2", "1/2"),
        ("0.3", "0.4", "1/3"),
        ("3.14", "3.15", "22/7"),
        ("3.1415926", "3.1415927", "86953/27678"),
        ("2", "5", "2"),
        ("1.5", "5", "2"),
        ("7/3", "2.9", "5/2"),
        ("-1", "2", "0"),
        ("0", "0", "0"),
        ("1e-9", "2e-9", "1/500000000"),
    ];
    for (low, high, expected) in rows {
        let (p, q) = simplest_between(number(low), number(high));
        assert_eq!(Rational::new(p, q), Some(number(expected)), "{low} {high}");
    }
    // Against trying all denominators.
    let mut random = Random::new(21);
    for _ in 0..300 {
        let low = fraction(random.below(5000) as i64, 1 + random.below(1000) as i64);
        let high = &low + &fraction(1 + random.below(50) as i64, 1000 + random.below(10_000) as i64);
        let (p, q) = simplest_between(low.clone(), high.clone());
        let first = (1..).find_map(|q: i64| {
            let p = -(-&low * Rational::from(q)).floor();
            (Rational::from(&p) <= &high * &Rational::from(q)).then_some((p, Integer::from(q)))
        });
        assert_eq!(Some((p, q)), first, "{low} {high}");
    }
}
