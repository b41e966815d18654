//! Which stage decides, and that none is asked beyond its width or its error.

use super::super::{boxes, decide};
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
    let mut random = Random::new(78);
    for bits in [20, 31, 53, 60] {
        let points: Vec<_> =
            (0..40).map(|_| direction([(); 3].map(|()| random.around_zero((1 << bits) - 1)))).collect();
        let circles: Vec<_> =
            points.chunks(2).filter_map(|pair| GreatCircle::through(&pair[0], &pair[1])).collect();
        let crossings: Vec<_> = circles
            .iter()
            .enumerate()
            .flat_map(|(i, m)| circles[..i].iter().filter_map(|n| Direction::crossing(m, n)))
            .collect();
        let counts = counted(|| {
            for (i, p) in crossings.iter().enumerate() {
                for q in &crossings[..i] {
                    turn(p, q);
                }
            }
        });
        let total = crossings.len() as u64 * (crossings.len() as u64 - 1) / 2;
        assert_eq!(counts.iter().sum::<u64>(), total);
        assert!(counts[1] + 2 >= total, "{bits} bits: {counts:?}");
        let counts = counted(|| {
            for p in &crossings {
                for circle in &circles {
                    side_of_circle(p, circle);
                }
            }
        });
        // Each crossing lies on two circles.
        let rest = (crossings.len() * (circles.len() - 2)) as u64;
        assert!(counts[1] + 2 >= rest, "{bits} bits: {counts:?}");
    }
}

#[test]
fn crossings_of_one_circle_are_compared_by_a_determinant() {
    let _guard = force(Start::Usual);
    // Wide enough to be kept, all through one point.
    let on = direction([(1 << 20) - 3, (1 << 20) - 7, 5]);
    let others = [
        [987_654, 3_333, 55_555],
        [-77_777, 1_000_003, 11],
        [5_432, -999_999, 765_432],
        [524_287, -600_011, 77],
    ];
    let [a, b, c, d] = others.map(|other| GreatCircle::through(&on, &direction(other)).unwrap());
    let crossing = |m: &GreatCircle, n: &GreatCircle| {
        let p = Direction::crossing(m, n).unwrap();
        assert!(!p.is_explicit());
        if p == on { p } else { p.opposite() }
    };
    for (p, q, most) in [
        (crossing(&a, &b), crossing(&a, &c), Stage::Narrow),
        (crossing(&a, &b), crossing(&c, &b.opposite()), Stage::Narrow),
        (crossing(&a, &b), crossing(&b, &a).opposite().opposite(), Stage::Narrow),
        (crossing(&a, &b), crossing(&c, &d), Stage::Fixed),
    ] {
        let counts = counted(|| assert_eq!(turn(&p, &q), Sign::Zero));
        assert_eq!(counts[most as usize], 1, "{most:?}: {counts:?}");
        assert_eq!(counts.iter().sum::<u64>(), 1);
    }
}

#[test]
fn exact_stages_at_the_limits_of_their_widths() {
    let _guard = force(Start::Usual);
    let mut random = Random::new(79);
    for bits in (28..=33).chain([39, 40, 41, 42, 43, 60, 61, 62]) {
        // The greatest coordinates of this width, or a little below, with any signs.
        let mut greatest = |bits: u32| {
            let value = ((1_i128 << bits) - 1 - i128::from(random.below(3))) as i64;
            let value = value.max(1);
            if random.below(2) == 0 { -value } else { value }
        };
        let circles: Vec<_> = (0..24).map(|_| circle([(); 3].map(|()| greatest(bits)))).collect();
        let mut points: Vec<_> =
            circles.windows(2).filter_map(|pair| Direction::crossing(&pair[0], &pair[1])).collect();
        for bits in [1, 2, 20, 30, 42, 43, 60, 61, 62] {
            points.push(direction([(); 3].map(|()| greatest(bits))));
        }
        let exact: Vec<Vector> = points.iter().map(Direction::multiple).collect();
        for (p, x) in points.iter().zip(&exact) {
            for (q, y) in points.iter().zip(&exact) {
                for axis in 0..3 {
                    assert_eq!(decide::cross_sign(p, q, axis), cross(x, y)[axis].sign(), "{p}, {q}");
                }
            }
            for circle in &circles {
                assert_eq!(decide::side(p, circle), dot(x, &circle.coordinates()).sign(), "{p}, {circle}");
            }
            for (axis, value) in x.iter().enumerate() {
                assert_eq!(decide::coordinate_sign(p, axis), value.sign());
            }
        }
    }
}

#[test]
fn boxes_decide_nothing_that_their_error_leaves_open() {
    let _guard = force(Start::Usual);
    // Boxes as coarse as the promise allows, around directions and circles about as near to one another as they are large.
    let mut random = Random::new(80);
    let mut decided = 0;
    for _ in 0..20_000 {
        let scale = 1 << random.below(12);
        let step = |random: &mut Random, base: i64| base + random.around_zero(2 * scale);
        let base = [(); 3].map(|()| random.around_zero(1 << 13));
        let [p, q] = [(); 2].map(|()| base.map(|value| step(&mut random, value)));
        let blurred = |random: &mut Random, exact: [i64; 3]| {
            let most = (4 * scale) as f64 / 5.0;
            (exact.map(|value| value as f64 + if random.below(2) == 0 { most } else { -most }), scale as f64)
        };
        let (((p_box, e), (q_box, f)), exact) =
            ((blurred(&mut random, p), blurred(&mut random, q)), [p, q].map(|p| p.map(Integer::from)));
        let sign = boxes::cross_of_boxes(([p_box[0], p_box[1]], e), ([q_box[0], q_box[1]], f));
        assert!(sign.is_none_or(|sign| sign == cross(&exact[0], &exact[1])[2].sign()), "{p:?}, {q:?}");
        decided += u32::from(sign.is_some());
        // A normal about at right angles.
        let normal = [q[1], -q[0], random.around_zero(scale)];
        let sign = boxes::dot_of_boxes((p_box, e), blurred(&mut random, normal));
        let side = dot(&exact[0], &normal.map(Integer::from)).sign();
        assert!(sign.is_none_or(|sign| sign == side), "{p:?}, {normal:?}");
        decided += u32::from(sign.is_some());
        // The longitude, with the same boxes.
        let mut point = Direction::from_i64(p).unwrap_or(Direction::NORTH);
        if point.pole_sign().is_zero() {
            let factor = Rational::new(point.coordinates()[0].clone(), p[0].into());
            if factor == Some(Rational::ONE) {
                (point.approx, point.error) = (p_box, e);
                let meridian = &meridians(&[[q[0], q[1] + 1], [-1, 0]])[usize::from(q[1] == -1 && q[0] == 0)];
                let (low, spread) = meridian.order_range(&point);
                let (sharp, sharp_spread) = meridian.order_range(&direction(p));
                if spread != u32::MAX && sharp_spread != u32::MAX {
                    assert!(
                        low <= sharp && sharp + u64::from(sharp_spread) <= low + u64::from(spread),
                        "{p:?}"
                    );
                }
            }
        }
    }
    assert!(decided > 1_000, "{decided}");
}
