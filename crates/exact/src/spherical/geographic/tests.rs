//! Places on the globe and their directions.

use super::*;
use crate::testing::Random;

fn number(text: &str) -> Rational {
    text.parse().unwrap()
}

fn place(longitude: &str, latitude: &str) -> [i64; 3] {
    coordinates(&number(longitude), &number(latitude)).unwrap()
}

/// The primitive coordinates as text.
fn shown(longitude: &str, latitude: &str) -> String {
    from_degrees(&number(longitude), &number(latitude)).unwrap().to_string()
}

#[test]
fn quarters_and_poles_are_exact() {
    for longitude in ["0", "17.3", "-180", "1e30", "1/7"] {
        assert_eq!(shown(longitude, "90"), "(0, 0, 1)");
        assert_eq!(shown(longitude, "-90"), "(0, 0, -1)");
    }
    for (longitude, direction) in [
        ("0", "(1, 0, 0)"),
        ("90", "(0, 1, 0)"),
        ("180", "(-1, 0, 0)"),
        ("-180.0", "(-1, 0, 0)"),
        ("-90", "(0, -1, 0)"),
        ("360", "(1, 0, 0)"),
        ("810", "(0, 1, 0)"),
        ("-36000000000000000000090", "(0, -1, 0)"),
    ] {
        assert_eq!(shown(longitude, "0"), direction, "{longitude}");
        // On the meridian, north and south.
        for latitude in ["30", "-1e-3", "89.999999", "-45", "1e-300"] {
            let ([x, y, z], [u, v, _]) = (place(longitude, latitude), place(longitude, "0"));
            assert_eq!((x.signum(), y.signum()), (u.signum(), v.signum()), "{longitude} {latitude}");
            assert!(z.signum() == i64::from(number(latitude).sign() as i8) || latitude == "1e-300");
        }
    }
}

#[test]
fn latitude_zero_stays_on_the_equator() {
    for longitude in ["45", "0.1", "1e-20", "30", "60", "-179.999999999", "200", "44.999999999999", "1/3"] {
        let [_, _, z] = place(longitude, "0");
        assert_eq!(z, 0, "{longitude}");
    }
    assert_eq!(shown("1e-20", "0"), "(1, 0, 0)");
}

#[test]
fn other_latitudes_are_none() {
    for latitude in ["90.0000000000000000001", "-91", "1e300", "-181/2"] {
        assert!(from_degrees(&Rational::ZERO, &number(latitude)).is_none(), "{latitude}");
    }
}

#[test]
fn symmetries_are_exact() {
    let mut random = Random::new(0x6E0);
    for _ in 0..500 {
        let (longitude, latitude) = (degrees(&mut random, 180), degrees(&mut random, 90));
        let [x, y, z] = coordinates(&longitude, &latitude).unwrap();
        let at = |longitude: Rational, latitude: Rational| coordinates(&longitude, &latitude).unwrap();
        assert_eq!(at(-longitude.clone(), latitude.clone()), [x, -y, z], "{longitude} {latitude}");
        assert_eq!(at(longitude.clone(), -latitude.clone()), [x, y, -z], "{longitude} {latitude}");
        assert_eq!(at(Rational::from(180) - &longitude, latitude.clone()), [-x, y, z]);
        if longitude != Rational::from(45) || !latitude.is_zero() {
            assert_eq!(at(Rational::from(90) - &longitude, latitude.clone()), [y, x, z]);
        }
        assert_eq!(at(Rational::from(-720) + &longitude, latitude.clone()), [x, y, z]);
        assert_eq!(at(Rational::from(180) + &longitude, -latitude.clone()), [-x, -y, -z]);
    }
}

/// A decimal, or a fraction, or one near a special value; at most the bound in magnitude.
fn degrees(random: &mut Random, bound: i64) -> Rational {
    let ratio = |p: i64, q: i64| Rational::new(Integer::from(p), Integer::from(q)).unwrap();
    match random.below(4) {
        0 => ratio(random.around_zero(bound), 1),
        1 => ratio(random.around_zero(bound * 10_000_000), 10_000_000),
        2 => ratio(random.around_zero(bound * 1_000), 1 + random.below(1_000) as i64) * ratio(1, 1_000),
        _ => {
            let near = ratio(random.around_zero(bound / 15 - 1) * 15, 1);
            near + ratio(random.around_zero(9), 10_i64.pow(random.below(17) as u32))
        }
    }
}

#[test]
fn directions_are_near_and_on_the_unit_sphere() {
    let mut random = Random::new(0x6E1);
    let mut worst = 0.0_f64;
    for _ in 0..5_000 {
        let (longitude, latitude) = (degrees(&mut random, 180), degrees(&mut random, 90));
        let exact = coordinates(&longitude, &latitude).unwrap();
        assert!(exact.iter().all(|value| value.unsigned_abs() < 1 << 61), "{longitude} {latitude}");
        let square: i128 = exact.iter().map(|&value| i128::from(value).pow(2)).sum();
        let length = Integer::from(square).sqrt_floor().unwrap();
        assert_eq!(&length * &length, Integer::from(square), "{longitude} {latitude}");
        let [l, b] = [&longitude, &latitude].map(|angle| angle.approx_f64().to_radians());
        let truth = [b.cos() * l.cos(), b.cos() * l.sin(), b.sin()];
        let length = length.approx_f64();
        let square: f64 = exact.iter().zip(truth).map(|(&v, t)| (v as f64 / length - t).powi(2)).sum();
        worst = worst.max(square.sqrt());
    }
    // The doubles have an error of some 1e-15 themselves.
    assert!(worst < 1.5e-9, "{worst}");
    assert!(worst > 0.8e-9, "{worst}: the bound is attained nearly");
}

#[test]
fn machine_words_agree_with_wide_numbers() {
    let mut random = Random::new(0x6E2);
    let mut certain = 0;
    for _ in 0..2_000 {
        let [radial, around] = [(); 2].map(|()| degrees(&mut random, 45).abs());
        let wide = wide_place(&radial, &around);
        if let Some(short) = certain_place(&radial, &around) {
            certain += 1;
            assert_eq!(short, wide, "{radial} {around}");
        }
    }
    assert!(certain > 1_990, "{certain}");
}

#[test]
fn machine_words_keep_their_error_bound() {
    let mut random = Random::new(0x6E3);
    let pi = pi();
    for _ in 0..500 {
        let angle = degrees(&mut random, 45).abs();
        let (sine, cosine) = short_sine_cosine(short_radians(&angle).unwrap());
        let half_turns = Rational::new(angle.numerator(), angle.denominator() * Integer::from(180)).unwrap();
        let (wide_sine, wide_cosine) = sine_cosine(&times(&half_turns, &pi));
        for (short, wide) in [(sine, wide_sine), (cosine, wide_cosine)] {
            let error = Integer::from(short) - (wide >> (BITS - SHORT_BITS));
            assert!(error.abs() <= Integer::from(120), "{angle}: {error}");
        }
    }
}

/// A place in the middle between two points of the grid, to more digits than machine words have.
#[test]
fn places_between_two_points_of_the_grid_are_decided() {
    // The angle whose tangent is 1/2 of a step, by bisection.
    let [mut low, mut high] = [Rational::ZERO, number("1e-6")];
    for _ in 0..120 {
        let middle = (&low + &high) * half();
        if wide_place(&middle, &Rational::ZERO) == [0, 0] { low = middle } else { high = middle }
    }
    assert_eq!(wide_place(&low, &Rational::ZERO), [0, 0]);
    assert_eq!(wide_place(&high, &Rational::ZERO), [1, 0]);
    for angle in [&low, &high] {
        assert_eq!(certain_place(angle, &Rational::ZERO), None);
        assert_eq!(grid_place(angle, &Rational::ZERO), wide_place(angle, &Rational::ZERO));
    }
}

#[test]
fn lengths_are_told() {
    let paris = from_degrees(&number("2.3522"), &number("48.8566")).unwrap();
    assert!(exact_length(&paris).is_some());
    assert_eq!(exact_length(&paris), exact_length(&paris.opposite()));
    let diagonal = Direction::from_i64([1, 1, 1]).unwrap();
    assert_eq!(exact_length(&diagonal), None);
}

/// Rounding each coordinate for itself would take some of these to the other side.
#[test]
fn no_place_crosses_the_equator() {
    for exponent in [7, 8, 9, 10, 12, 30] {
        let latitude = Rational::new(Integer::ONE, Integer::from(10_i64).pow(exponent)).unwrap();
        let mut random = Random::new(0x6E3);
        let some = (0..300).map(|_| degrees(&mut random, 180));
        for longitude in some.chain([1, 30, 45, 89, 135].map(Rational::from)) {
            let [x, y, z] = coordinates(&longitude, &latitude).unwrap();
            assert!(z >= 0, "{longitude} {latitude}: {z}");
            let [l, length] =
                [longitude.approx_f64().to_radians(), ((x as f64).powi(2) + (y as f64).powi(2)).sqrt()];
            let error =
                ((x as f64 / length - l.cos()).powi(2) + (y as f64 / length - l.sin()).powi(2)).sqrt();
            assert!(error < 1.5e-9, "{longitude} {latitude}: {error}");
        }
    }
}
