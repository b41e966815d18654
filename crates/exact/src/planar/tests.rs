use super::*;
use crate::testing::Random;
use crate::tier::{Start, force};
use crate::{Integer, Rational, Sign};
use std::cmp::Ordering;
use std::collections::HashSet;

mod keys;
mod stages;

const ALL_STARTS: [Start; 5] = [Start::Usual, Start::Float, Start::Fixed, Start::Interval, Start::Big];

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

fn line(a: i64, b: i64, c: i64) -> Line2 {
    Line2::from_coefficients(&a.into(), &b.into(), &c.into()).unwrap()
}

fn through(p: [i64; 2], q: [i64; 2]) -> Line2 {
    Line2::through(&Point2::from_i64(p), &Point2::from_i64(q)).unwrap()
}

/// a x + b y - c in plain rationals.
fn value(line: &Line2, [x, y]: &[Rational; 2]) -> Rational {
    let [a, b, c] = line.coefficients().map(Rational::from);
    a * x + b * y - c
}

/// The crossing in plain rationals.
fn oracle_crossing(l: &Line2, m: &Line2) -> Option<[Rational; 2]> {
    let ([a, b, c], [d, e, f]) = (l.coefficients(), m.coefficients());
    let w = &a * &e - &d * &b;
    Some([Rational::new(&c * &e - &f * &b, w.clone())?, Rational::new(&a * &f - &d * &c, w)?])
}

fn slope(line: &Line2) -> Option<Rational> {
    let [a, b, _] = line.coefficients();
    Rational::new(-a, b)
}

/// What `Point2::new` promises.
fn assert_box(p: &Point2, exact: &[Rational; 2]) {
    if p.error.is_infinite() {
        return;
    }
    let bound = Rational::try_from(p.error).unwrap() * rational("4/5");
    for (approx, exact) in p.approx.iter().zip(exact) {
        let error = (Rational::try_from(*approx).unwrap() - exact).abs();
        assert!(error <= bound, "{p}: {approx:e} +- {:e}", p.error);
    }
    assert_eq!(p.approx_f64(), p.approx);
}

fn assert_normal(line: &Line2) {
    let [a, b, c] = line.coefficients();
    assert!(b.sign() > Sign::Zero || (b.is_zero() && a.sign() < Sign::Zero), "{line}");
    assert_eq!(a.gcd(&b).gcd(&c), Integer::ONE, "{line}");
    assert_eq!((line.is_vertical(), line.is_horizontal()), (b.is_zero(), a.is_zero()));
    for (exact, approx) in [a, b, c].iter().zip(line.approx_coefficients()) {
        assert_eq!(exact.approx_f64(), approx, "{line}");
    }
    if let Some((_, bits)) = line.as_narrow() {
        let [a, b, c] = line.coefficients().map(|value| value.bit_len());
        assert_eq!(bits, a.max(b).max(c.div_ceil(2)), "{line}");
    }
}

/// How often keys were asked, and told something: that of which they tell nothing passes every check.
#[derive(Default, Debug)]
struct Told {
    points: u32,
    known_ranges: u32,
    /// Points that are not on lines, where boxes are asked at all.
    sides: u32,
    known_sides: u32,
}

/// Checks every predicate on every pair, from every stage, against rationals.
fn check(points: &[(Point2, [Rational; 2])], lines: &[Line2]) -> Told {
    let mut told = Told::default();
    for (p, exact) in points {
        assert_eq!(&p.coordinates(), exact);
        assert_box(p, exact);
        told.points += 1;
        told.known_ranges += u32::from(p.order_range().1 != u32::MAX);
    }
    lines.iter().for_each(assert_normal);
    for start in ALL_STARTS {
        let _guard = force(start);
        for l in lines {
            for m in lines {
                // None, a vertical line, is the greatest.
                let expected = match (slope(l), slope(m)) {
                    (Some(s), Some(t)) => s.cmp(&t),
                    (s, t) => s.is_none().cmp(&t.is_none()),
                };
                assert_eq!(l.compare_slope(m), expected, "{l}, {m}");
                assert_eq!(l.is_same(m), l.coefficients() == m.coefficients());
            }
        }
        for (p, exact) in points {
            for (q, other) in points {
                let [x, y] = [0, 1].map(|axis: usize| exact[axis].cmp(&other[axis]));
                assert_eq!(compare_x(p, q), x, "x of {p}, {q}, {start:?}");
                assert_eq!(compare_y(p, q), y, "y of {p}, {q}, {start:?}");
                assert_eq!(compare_xy(p, q), x.then(y), "{p}, {q}, {start:?}");
                assert_eq!(p == q, exact == other);
                let [(low, spread), (other_low, other_spread)] = [p, q].map(|p| p.order_range());
                if spread != u32::MAX && other_spread != u32::MAX && other_low > low + u64::from(spread) {
                    assert_eq!(x, Ordering::Less, "ranges of {p}, {q}");
                }
            }
            for line in lines {
                let sign = value(line, exact).sign();
                assert_eq!(side_of_line(p, line), sign, "{p}, {line}, {start:?}");
                let by_key = side_of_key(p, &line.side_key());
                assert!(by_key.is_none_or(|by_key| by_key == sign), "{p} by the key of {line}, {start:?}");
                if !sign.is_zero() && matches!(start, Start::Usual | Start::Float) {
                    told.sides += 1;
                    told.known_sides += u32::from(by_key.is_some());
                }
            }
        }
    }
    told
}

/// Adds the crossings of all pairs of lines to the points, then checks all.
fn check_with_crossings(points: &[Point2], lines: &[Line2]) -> Told {
    let mut all: Vec<_> = points.iter().map(|p| (p.clone(), p.coordinates())).collect();
    for (i, l) in lines.iter().enumerate() {
        for m in &lines[i..] {
            let (crossing, expected) = (Point2::crossing(l, m), oracle_crossing(l, m));
            assert_eq!(crossing.is_some(), expected.is_some(), "{l}, {m}");
            all.extend(crossing.zip(expected));
        }
    }
    check(&all, lines)
}

fn random_coordinate(random: &mut Random, bits: u32) -> Rational {
    let numerator = random.integer(bits);
    let denominator = match random.below(4) {
        0 => Integer::from(1 + random.below(9)),
        1 => random.integer(bits),
        _ => Integer::ONE,
    };
    Rational::new(numerator, denominator).unwrap_or_default()
}

#[test]
fn random_points_and_lines_agree_with_rationals_at_every_width() {
    let mut random = Random::new(31);
    for bits in [3, 8, 20, 23, 24, 30, 31, 32, 42, 53, 60, 61, 62, 64, 200, 1100] {
        for is_integer in [true, false] {
            let points: Vec<_> = (0..7)
                .map(|_| {
                    Point2::from_rationals(&[(); 2].map(|()| match is_integer {
                        true => random.integer(bits).into(),
                        false => random_coordinate(&mut random, bits),
                    }))
                })
                .collect();
            let lines: Vec<_> =
                points.windows(2).filter_map(|pair| Line2::through(&pair[0], &pair[1])).collect();
            let told = check_with_crossings(&points, &lines);
            // Wider lines have no finite key; crossings with x = 0 have no range.
            if bits <= 30 || (is_integer && bits <= 61) {
                assert!(told.known_sides > 0 && told.known_ranges > told.points / 2, "{bits} bits: {told:?}");
            }
        }
    }
}

/// Lines through one point (x/q, y/q), and lines that miss it by 1/miss of a unit of c.
fn pencil(random: &mut Random, bits: u32, q: i64, miss: Option<&Integer>) -> (Point2, Vec<Line2>) {
    let center = [(); 2].map(|()| Rational::new(random.integer(bits), q.into()).unwrap());
    let mut lines = Vec::new();
    for i in 0..5_i64 {
        let a = Rational::from(random.around_zero(1 << (bits / 2).min(30)));
        let b = Rational::from(i);
        let mut c = &a * &center[0] + &b * &center[1];
        if let Some(miss) = miss {
            c += Rational::new(Integer::from(random.around_zero(1)), miss.clone()).unwrap();
        }
        lines.extend(Line2::from_coefficients(&a, &b, &c));
    }
    (Point2::from_rationals(&center), lines)
}

#[test]
fn lines_through_a_point_and_near_it() {
    let mut random = Random::new(32);
    for bits in [8, 20, 30, 50, 60, 120] {
        for q in [1, 3, 1009] {
            for miss in [None, Some(Integer::ONE), Some(Integer::ONE << 40), Some(Integer::ONE << 90)] {
                let (center, lines) = pencil(&mut random, bits, q, miss.as_ref());
                check_with_crossings(&[center], &lines);
            }
        }
    }
}

#[test]
fn crossings_that_differ_in_the_last_place() {
    // Crossings of y = x with flat lines, whose x differ by 1e-15 of themselves and less.
    let diagonal = line(-1, 1, 0);
    let mut random = Random::new(33);
    for base in [1 << 26, (1 << 30) - 1, 1 << 45, (1 << 61) - 5] {
        let lines: Vec<_> = (0..4)
            .map(|i| line(1, base - i, random.around_zero(2) + 7))
            .chain([diagonal.clone(), line(base, -base - 1, 1), line(base - 1, -base, 1)])
            .collect();
        check_with_crossings(&[Point2::from_i64([1, 1])], &lines);
    }
}

#[test]
fn extreme_coordinates() {
    let two_53 = 1_i64 << 53;
    let values = [0, 1, -1, i64::MIN, i64::MAX, 1 << 61, (1 << 61) - 1, two_53 - 1, two_53, two_53 + 1];
    let points: Vec<_> = values
        .iter()
        .flat_map(|&x| values[..5].iter().chain(&values[7..]).map(move |&y| Point2::from_i64([x, y])))
        .step_by(7)
        .collect();
    let lines: Vec<_> =
        points.windows(2).step_by(2).filter_map(|pair| Line2::through(&pair[0], &pair[1])).collect();
    check_with_crossings(&points, &lines);
}

#[test]
fn huge_denominators_and_floats() {
    let texts =
        ["1/340282366920938463463374607431768211457", "-1/3", "1e-400", "1e300", "1e-310", "0", "1e400", "7"];
    let mut points: Vec<_> = texts
        .windows(2)
        .map(|pair| Point2::from_rationals(&[rational(pair[0]), rational(pair[1])]))
        .collect();
    for floats in
        [[f64::MIN_POSITIVE, -0.0], [5e-324, 1e-310], [f64::MAX, -f64::MAX], [0.1, 0.3], [1e-20, 5.0]]
    {
        let point = Point2::from_f64s(floats).unwrap();
        assert_eq!((point.error, point.approx_f64()), (0.0, floats));
        points.push(point);
    }
    for bad in [[f64::NAN, 0.0], [0.0, f64::INFINITY]] {
        assert!(Point2::from_f64s(bad).is_none());
    }
    let lines: Vec<_> = points.windows(2).filter_map(|pair| Line2::through(&pair[0], &pair[1])).collect();
    check_with_crossings(&points, &lines);
}

#[test]
fn normal_forms_and_slopes() {
    // Slopes ascending; every line turns the right way whichever point comes first.
    let rows = [[1, -3], [2, -1], [5, 0], [3, 1], [1, 1], [1, 9], [0, 4]];
    let lines = rows.map(|[x, y]| {
        let line = through([2, 3], [2 + x, 3 + y]);
        assert_eq!(through([2 + x, 3 + y], [2, 3]), line);
        line
    });
    assert!(lines.is_sorted_by(|l, m| l.compare_slope(m) == Ordering::Less));
    assert!(lines[6].is_vertical() && lines[2].is_horizontal());
    assert_eq!(side_of_line(&Point2::from_i64([0, 0]), &lines[6]), Sign::Positive);
    assert_eq!(side_of_line(&Point2::from_i64([0, 0]), &lines[2]), Sign::Negative);
    // Equal sets of points are equal and hash alike.
    let same = [line(2, 4, 6), line(-1, -2, -3), through([1, 1], [3, 0]), through([3, 0], [-1, 2])];
    assert_eq!(same.iter().collect::<HashSet<_>>().len(), 1);
    let parallel = [line(2, 2, 1), line(1, 1, 1)];
    assert_eq!(parallel[0].compare_slope(&parallel[1]), Ordering::Equal);
    assert!(parallel[0] != parallel[1] && Point2::crossing(&parallel[0], &parallel[1]).is_none());
    assert!(Point2::crossing(&parallel[0], &parallel[0]).is_none());
    let zero = Rational::ZERO;
    assert!(Line2::from_coefficients(&zero, &zero, &rational("1")).is_none());
    // The same point from different definitions has no line.
    let p = Point2::crossing(&line(1, 1, 1), &line(1, -1, 0)).unwrap();
    assert!(Line2::through(&p, &Point2::from_rationals(&[rational("1/2"), rational("1/2")])).is_none());
}

#[test]
fn translations_move_points_and_lines() {
    let mut random = Random::new(34);
    for bits in [8, 20, 53, 61, 100] {
        for _ in 0..20 {
            let points: Vec<_> = (0..4)
                .map(|_| Point2::from_rationals(&[(); 2].map(|()| random_coordinate(&mut random, bits))))
                .collect();
            let lines: Vec<_> =
                points.windows(2).filter_map(|pair| Line2::through(&pair[0], &pair[1])).collect();
            let crossing = lines.windows(2).filter_map(|pair| Point2::crossing(&pair[0], &pair[1]));
            let all: Vec<_> = points.iter().cloned().chain(crossing).collect();
            let whole = random.below(2) == 0;
            let by = [(); 2].map(|()| match whole {
                true => random.integer(bits).into(),
                false => random_coordinate(&mut random, bits),
            });
            for p in &all {
                let moved = p.translated(&by);
                let expected = p.coordinates().iter().zip(&by).map(|(x, t)| x + t).collect::<Vec<_>>();
                assert_eq!(moved.coordinates().to_vec(), expected);
                assert_box(&moved, &moved.coordinates());
                for line in &lines {
                    let other = line.translated(&by);
                    assert_normal(&other);
                    assert_eq!(side_of_line(&moved, &other), side_of_line(p, line), "{p}, {line}, {by:?}");
                }
            }
        }
    }
}

#[test]
fn crossings_in_integers_are_explicit_and_stay_small() {
    for (l, m, p) in [
        (line(1, 1, 4), line(1, -1, 0), [2, 2]),
        (line(1, 0, -7), line(0, 1, 9), [-7, 9]),
        (line((1 << 50) + 1, 1, 0), line(1, 1, 0), [0, 0]),
        (line((1 << 40) + 1, 1, (1 << 40) + 1), line(1, 1, 1), [1, 0]),
    ] {
        let crossing = Point2::crossing(&l, &m).unwrap();
        assert!(crossing.is_explicit() && crossing.error == 0.0);
        assert_eq!(crossing, Point2::from_i64(p));
    }
    let half = Point2::crossing(&line(1, 1, 1), &line(1, -1, 0)).unwrap();
    assert!(!half.is_explicit() && half.error > 0.0);
}

#[test]
fn points_and_lines_are_small_and_can_be_sent() {
    fn sent<T: Clone + Send + Sync + std::fmt::Debug>() {}
    sent::<Point2>();
    sent::<Line2>();
    assert_eq!((size_of::<Point2>(), size_of::<Line2>()), (96, 48));
}
