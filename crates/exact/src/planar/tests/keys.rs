//! What keys of lines and ranges of points must tell, and what they must not.

use super::*;

/// The distance from the line in the metric of which the coefficients tell: |a x + b y - c| is at least so often |a| + |b|.
fn is_away(l: &Line2, p: &Point2) -> bool {
    let [a, b, _] = l.coefficients().map(Rational::from);
    value(l, &p.coordinates()).abs() >= a.abs() + b.abs()
}

/// With coordinates below 2^20, |a x| + |b y| + |c| is at most 2^21 (|a| + |b|): the bound and the error are less than half of |a| + |b|.
#[test]
fn a_unit_decides_for_integers_of_twenty_bits() {
    // No other test forces a tier meanwhile.
    let _guard = force(Start::Usual);
    const MOST: i64 = (1 << 20) - 1;
    let mut random = Random::new(35);
    let mut is_decided = [0, 0];
    for _ in 0..3_000 {
        let p = [(); 2].map(|()| random.around_zero(MOST));
        // Short and long.
        let q = match random.below(2) {
            0 => p.map(|x| (x + random.around_zero(9)).clamp(-MOST, MOST)),
            _ => [(); 2].map(|()| random.around_zero(MOST)),
        };
        if p == q {
            continue;
        }
        let (l, key) = (through(p, q), through(p, q).side_key());
        let beside = [p, q].map(|end| end.map(|x| (x + random.around_zero(4)).clamp(-MOST, MOST)));
        let anywhere = [(); 2].map(|()| random.around_zero(MOST));
        for r in [beside[0], beside[1], anywhere].map(Point2::from_i64) {
            if is_away(&l, &r) {
                assert_eq!(side_of_key(&r, &key), Some(side_of_line(&r, &l)), "{r} by the key of {l}");
                is_decided[usize::from(r.coordinates() == Point2::from_i64(anywhere).coordinates())] += 1;
            }
        }
    }
    assert!(is_decided[0] > 2_000 && is_decided[1] > 2_500, "{is_decided:?}");
}

#[test]
fn a_point_on_the_line_is_never_decided() {
    let mut random = Random::new(36);
    for bits in [3, 10, 20, 31, 50, 59] {
        for _ in 0..200 {
            let [p, q] = [(); 2].map(|()| [(); 2].map(|()| random.around_zero(1 << bits)));
            let [p, q] = [p, q].map(Point2::from_i64);
            let Some(l) = Line2::through(&p, &q) else { continue };
            let other = line(random.around_zero(9), 10, random.around_zero(1 << bits));
            for r in [p, q].into_iter().chain(Point2::crossing(&l, &other)) {
                assert_eq!(side_of_key(&r, &l.side_key()), None, "{r} by the key of {l}");
            }
        }
    }
}

#[test]
fn coefficients_beyond_the_range_decide_nothing() {
    // No other test forces a tier meanwhile.
    let _guard = force(Start::Usual);
    let of = |a: &str, b: &str, c: &str| {
        Line2::from_coefficients(&rational(a), &rational(b), &rational(c)).expect("not all are zero")
    };
    let power = |exponent: u32| (Integer::ONE << exponent).to_string();
    let below = (&(Integer::ONE << 128) - &Integer::ONE).to_string();
    let points = [[0, 0], [1, 0], [0, 1], [-7, 9], [1 << 60, 1 - (1 << 60)], [i64::MAX, i64::MIN]]
        .map(Point2::from_i64);
    // 2^128 - 1 is rounded to 2^128.
    for far in [power(128), below, power(200), power(1100)] {
        for l in [of(&far, "1", "1"), of("1", &far, "1"), of("1", "1", &far)] {
            for p in &points {
                assert_eq!(side_of_key(p, &l.side_key()), None, "{p} by the key of {l}");
            }
        }
    }
    // What is just in range does.
    let l = of(&power(127), "1", "0");
    assert_eq!(side_of_key(&points[1], &l.side_key()), Some(Sign::Positive));
    assert_eq!(side_of_key(&points[0], &l.side_key()), None);
    // Three zeros are no line, and a point without a box is nowhere.
    let far = Point2::from_rationals(&[rational("1e400"), rational("0")]);
    for p in points.iter().chain([&far]) {
        assert_eq!(side_of_key(p, &[0; 3]), None, "{p}");
    }
    assert_eq!(side_of_key(&far, &line(1, 1, 0).side_key()), None);
}

/// What searches ask: short segments, and points anywhere and near them.
#[test]
fn short_segments_are_decided_nearly_always() {
    // No other test forces a tier meanwhile.
    let _guard = force(Start::Usual);
    let mut random = Random::new(37);
    for bits in [16, 20, 30, 40, 50] {
        let (size, length) = (1_i64 << bits, 1_i64 << (bits / 2));
        let (mut asked, mut decided, mut near) = (0, 0, [0, 0]);
        for _ in 0..4_000 {
            let p = [(); 2].map(|()| random.around_zero(size));
            let q = p.map(|x| x + random.around_zero(length));
            if p == q {
                continue;
            }
            let l = through(p, q);
            let anywhere = Point2::from_i64([(); 2].map(|()| random.around_zero(size)));
            let beside = Point2::from_i64(p.map(|x| x + random.around_zero(length)));
            asked += 1;
            decided += u32::from(side_of_key(&anywhere, &l.side_key()).is_some());
            near[0] += u32::from(!side_of_line(&beside, &l).is_zero());
            near[1] += u32::from(side_of_key(&beside, &l.side_key()).is_some());
        }
        assert!(asked > 3_900 && decided * 100 >= asked * 99, "{bits} bits: {decided} of {asked}");
        // Where a float of 24 bits still tells what is near from what is on the line.
        assert!(bits > 20 || near[1] * 100 >= near[0] * 99, "{bits} bits: {near:?} near the segment");
    }
}

#[test]
fn keys_are_not_asked_where_boxes_are_not() {
    let (l, p) = (line(1, 1, 0), Point2::from_i64([5, 5]));
    for start in ALL_STARTS {
        let _guard = force(start);
        let are_boxes_asked = matches!(start, Start::Usual | Start::Float);
        assert_eq!(side_of_key(&p, &l.side_key()).is_some(), are_boxes_asked, "{start:?}");
    }
}

#[test]
fn ranges_of_points() {
    for x in [0, 1, -1, 7, 1 << 40, -(1 << 53)] {
        assert_eq!(Point2::from_i64([x, 3]).order_range().1, 0, "an integer is a float");
    }
    let third = Point2::from_rationals(&["1/3", "1/7"].map(rational));
    assert!((1..100).contains(&third.order_range().1), "{:?}", third.order_range());
    // The box has floats of both signs in it.
    let on_axis = Point2::crossing(&line(1, 3, 1), &line(1, 0, 0)).expect("they are not parallel");
    let far = Point2::from_rationals(&["1e400", "0"].map(rational));
    for unknown in [on_axis, far] {
        assert_eq!(unknown.order_range().1, u32::MAX, "{unknown}");
        assert_eq!(unknown.order_key(), 0, "{unknown}");
    }
}
