//! Which stage decides, and that none is asked beyond its width or its error.

use super::super::decide::{self, Order};
use super::super::predicates::side_of_box;
use super::*;
use crate::tier::{Stage, thread_counts};

fn counted(call: impl FnOnce()) -> [u64; 5] {
    let before = thread_counts();
    call();
    let counts = thread_counts() - before;
    Stage::ALL.map(|stage| counts.of(stage))
}

#[test]
fn the_cheap_stage_decides_ordinary_input() {
    let _guard = force(Start::Usual);
    let mut random = Random::new(35);
    for bits in [20, 31, 53, 60, 100] {
        let coordinate = |random: &mut Random| {
            // Not `integer`, which likes extremes and zeros.
            let value = Integer::from(random.next() >> 1) << bits;
            let value = value.div_rem(&(Integer::ONE << 63)).0 - (Integer::ONE << (bits - 1));
            Rational::from(value)
        };
        let points: Vec<_> = (0..60)
            .map(|_| Point2::from_rationals(&[coordinate(&mut random), coordinate(&mut random)]))
            .collect();
        let lines: Vec<_> = points.chunks(2).filter_map(|pair| Line2::through(&pair[0], &pair[1])).collect();
        let crossings: Vec<_> = lines
            .iter()
            .enumerate()
            .flat_map(|(i, l)| lines[..i].iter().filter_map(|m| Point2::crossing(l, m)))
            .collect();
        let counts = counted(|| {
            for (i, p) in crossings.iter().enumerate() {
                for q in &crossings[..i] {
                    compare_xy(p, q);
                }
            }
        });
        let total = crossings.len() as u64 * (crossings.len() as u64 - 1) / 2;
        assert_eq!(counts.iter().sum::<u64>(), total);
        assert!(counts[1] + 2 >= total, "{bits} bits: {counts:?}");
        let counts = counted(|| {
            for p in &crossings {
                for line in &lines {
                    side_of_line(p, line);
                }
            }
        });
        // Each crossing lies on two lines.
        let on_lines = 2 * crossings.len() as u64;
        let rest = (crossings.len() * lines.len()) as u64 - on_lines;
        assert!(counts[1] + 2 >= rest, "{bits} bits: {counts:?}");
        assert_eq!(counts[0] + counts[4], on_lines + rest - counts[1], "{bits} bits: {counts:?}");
    }
}

#[test]
fn each_exact_stage_decides_what_its_width_allows() {
    let _guard = force(Start::Usual);
    // Bits of the coordinates, and the stage that finds two crossings with four lines equal.
    for (bits, stage) in [(20, Stage::Narrow), (22, Stage::Narrow), (31, Stage::Fixed), (60, Stage::Fixed)] {
        let s = (1_i64 << bits) - 1;
        // All pass through (1/2, 1/2).
        let lines =
            [[s, s - 2], [s - 4, s], [s, -s + 6], [3, s]].map(|[x, y]| through([x, y], [1 - x, 1 - y]));
        let [p, q] = [0, 2].map(|i: usize| Point2::crossing(&lines[i], &lines[i + 1]).unwrap());
        let counts = counted(|| assert_eq!(compare_xy(&p, &q), Ordering::Equal));
        assert_eq!(counts[stage as usize], 2, "{bits} bits: {counts:?}");
        // A shared line needs one polynomial of lower degree.
        let r = Point2::crossing(&lines[0], &lines[2]).unwrap();
        assert_eq!(counted(|| assert_eq!(compare_xy(&p, &r), Ordering::Equal)).iter().sum::<u64>(), 1);
    }
}

#[test]
fn exact_stages_at_the_limits_of_their_widths() {
    let _guard = force(Start::Usual);
    let mut random = Random::new(36);
    for bits in (20..=34).chain([41, 42, 43, 60, 61, 62]) {
        // The greatest coefficients of this width, or a little below, with any signs.
        let mut greatest = |bits: u32| {
            let value = (Integer::ONE << bits) - Integer::from(1 + random.below(3));
            Rational::from(if random.below(2) == 0 { -value } else { value })
        };
        let lines: Vec<_> = (0..40)
            .filter_map(|_| Line2::from_coefficients(&greatest(bits), &greatest(bits), &greatest(2 * bits)))
            .collect();
        let pairs = lines.windows(2).filter_map(|pair| Point2::crossing(&pair[0], &pair[1]));
        let explicit = [1, 20, 26, 27, 30, 32, 35, 57, 58, 60, 61].map(|bits| {
            let weight = greatest(bits).numerator();
            Point2::from_rationals(
                &[(); 2]
                    .map(|()| Rational::new(greatest(bits).numerator(), weight.clone()).unwrap_or_default()),
            )
        });
        let whole = [20, 27, 60, 61].map(|bits| Point2::from_rationals(&[greatest(bits), greatest(bits)]));
        let points: Vec<_> =
            pairs.chain(explicit).chain(whole).map(|p| (p.clone(), p.coordinates())).collect();
        for (p, exact) in &points {
            for (q, other) in &points {
                for (order, axis) in [(Order::X, 0), (Order::Y, 1)] {
                    assert_eq!(decide::compare(p, q, order), exact[axis].cmp(&other[axis]), "{p}, {q}");
                }
                assert_eq!(decide::compare(p, q, Order::XThenY), exact.cmp(other), "{p}, {q}");
            }
            for line in &lines {
                assert_eq!(decide::side(p, line), value(line, exact).sign(), "{p}, {line}");
            }
        }
    }
}

#[test]
fn boxes_decide_nothing_that_their_error_leaves_open() {
    // Boxes as coarse as the promise allows, around points and lines about as near to one another as they are large.
    let mut random = Random::new(37);
    for _ in 0..3000 {
        let error = f64::from_bits((1023 - random.below(31)) << 52);
        let exact_error = Rational::try_from(error).unwrap();
        let step = |random: &mut Random| {
            &exact_error * Rational::new(random.around_zero(64).into(), 32.into()).unwrap()
        };
        let base = [(); 2].map(|()| Rational::from(random.around_zero(1 << 12)));
        let mut points = Vec::new();
        for _ in 0..3 {
            let exact = base.each_ref().map(|value| value + step(&mut random));
            let mut point = Point2::from_rationals(&exact);
            let outermost = &exact_error * rational("51/64");
            point.approx = exact.each_ref().map(|value| {
                (if random.below(2) == 0 { value + &outermost } else { value - &outermost }).approx_f64()
            });
            point.error = error;
            points.push((point, exact));
        }
        let slopes = [(); 4].map(|()| {
            let bits = random.below(12);
            random.around_zero(1 << bits)
        });
        let lines: Vec<_> = slopes
            .chunks(2)
            .filter_map(|slope| {
                let [a, b] = [slope[0], slope[1]].map(Rational::from);
                let c = &a * &(&base[0] + step(&mut random)) + &b * &(&base[1] + step(&mut random));
                Line2::from_coefficients(&a, &b, &c)
            })
            .collect();
        for (p, exact) in &points {
            assert_box(p, exact);
            for (q, other) in &points {
                assert_eq!(compare_x(p, q), exact[0].cmp(&other[0]), "{p}, {q}");
                assert_eq!(compare_y(p, q), exact[1].cmp(&other[1]), "{p}, {q}");
                assert_eq!(compare_xy(p, q), exact.cmp(other), "{p}, {q}");
            }
            for line in &lines {
                // The narrow explicit point would not look at its box.
                let side = side_of_box(p, line.approx_coefficients());
                assert!(side.is_none_or(|side| side == value(line, exact).sign()), "{p}, {line}");
            }
        }
    }
}
