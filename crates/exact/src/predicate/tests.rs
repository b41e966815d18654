use super::*;
use crate::Integer;
use crate::stage::{Start, force, thread_counts};
use crate::testing::{KINDS, Kind, Random, WIDTHS, triple};

fn integer_det([a, b, c]: [&Vector3; 3]) -> Sign {
    let [a, b, c] = [a, b, c].map(Vector3::coordinates);
    dot(cross(a, b), c).sign()
}

fn integer_dot(a: &Vector3, b: &Vector3) -> Sign {
    dot(a.coordinates(), b.coordinates()).sign()
}

/// A vector that is (nearly) perpendicular to `a`, made of its coordinates.
fn perpendicular(random: &mut Random, a: &Vector3, kind: Kind) -> Vector3 {
    let [x, y, z] = a.coordinates();
    let v = match random.below(3) {
        0 => Vector3::new([-y, x, Integer::ZERO]),
        1 => Vector3::new([-z, Integer::ZERO, x]),
        _ => Vector3::new([Integer::ZERO, z, -y]),
    };
    if kind == Kind::Near { &v + &Vector3::from_i64([(); 3].map(|()| random.around_zero(1))) } else { v }
}

/// Everything that the cascades decide, against the same polynomial in big integers.
fn compare_all(random: &mut Random, bits: u32, other_bits: u32, kind: Kind) {
    let [a, b, c] = triple(random, bits, kind);
    assert_eq!(orientation(&a, &b, &c), integer_det([&a, &b, &c]), "det {a} {b} {c}");
    assert_eq!(orientation(&b, &a, &c), -integer_det([&a, &b, &c]), "det {b} {a} {c}");
    let normal = a.cross(&b);
    assert_eq!(side_of_circle(&normal, &c), integer_dot(&normal, &c), "side {normal} {c}");
    if let Some(sign) = side_of_floats(&Floats3::of(&normal), &Floats3::of(&c)) {
        assert_eq!(sign, integer_dot(&normal, &c), "floats {normal} {c}");
    }
    let other = random.vector(other_bits);
    assert_eq!(side_of_circle(&normal, &other), integer_dot(&normal, &other), "side {normal} {other}");
    assert_eq!(same_direction(&a, &other), integer_dot(&a, &other), "dot {a} {other}");
    let across = if kind == Kind::Random { random.vector(bits) } else { perpendicular(random, &a, kind) };
    assert_eq!(same_direction(&a, &across), integer_dot(&a, &across), "dot {a} {across}");
    // Normals of a pencil: both perpendicular to b.
    let (m, n) = (b.cross(&a), b.cross(&c));
    for axis in [&a, &b, &other] {
        assert_eq!(circle_order(axis, &m, &n), integer_det([axis, &m, &n]), "order {axis} {m} {n}");
    }
    let weights = [1 + random.below(9), 1 + random.below(9)].map(Integer::from);
    let on = Point3::new(c.coordinates(), weights[0].clone()).unwrap();
    let moved = &c + &a.scaled(&Integer::from(random.around_zero(2)));
    let p = Point3::new(moved.scaled(&weights[1]).coordinates(), &weights[0] * &weights[1]).unwrap();
    let difference =
        Vector3::new([0, 1, 2].map(|i| p.numerator(i) * on.weight() - on.numerator(i) * p.weight()));
    for v in [&normal, &other] {
        assert_eq!(plane_side(v, &on, &p), integer_dot(v, &difference), "plane {v} {on} {p}");
    }
}

fn compare_everything(seed: u64, rounds: u32) {
    let mut random = Random::new(seed);
    for bits in WIDTHS {
        for other_bits in WIDTHS {
            for kind in KINDS {
                for _ in 0..rounds {
                    compare_all(&mut random, bits, other_bits, kind);
                }
            }
        }
    }
}

#[test]
fn every_predicate_agrees_with_big_integers() {
    compare_everything(1, 12);
}

#[test]
fn every_tier_agrees_when_it_is_forced() {
    for start in Start::FORCED {
        let _guard = force(start);
        let before = thread_counts();
        compare_everything(2, 2);
        let counts = thread_counts() - before;
        assert_eq!(counts.narrow, 0, "{start:?}");
        match start {
            Start::Float => assert!(counts.float > counts.fixed && counts.fixed > 0 && counts.big > 0),
            Start::Fixed => {
                assert!(counts.fixed > 0 && counts.float + counts.interval == 0 && counts.big > 0)
            }
            Start::Interval => assert!(counts.interval > counts.big && counts.float + counts.fixed == 0),
            Start::Big | Start::Usual => assert!(counts.big == counts.total() && counts.big > 0),
        }
    }
}

fn cube(bits: u32, [x, y, z]: [i64; 3]) -> Vector3 {
    // Digits that are no multiples of each other, so that rounding is felt.
    let unit = (Integer::ONE << (bits - 3)) + Integer::from(0x0dd5);
    Vector3::new([x, y, z].map(|value| Integer::from(value) * &unit + Integer::from(7 * value * value)))
}

#[test]
fn given_input_is_decided_at_a_given_stage() {
    let triple = |bits: u32| [[3, 1, 0], [1, -2, 3], [1, 1, 2]].map(|coordinates| cube(bits, coordinates));
    // The third vector is the sum of the others.
    let flat = |bits: u32| {
        let [a, b, _] = triple(bits - 1);
        let c = &a + &b;
        [a, b, c]
    };
    let det = |[a, b, c]: [Vector3; 3]| orientation(&a, &b, &c);
    let side = |[a, b, c]: [Vector3; 3]| side_of_circle(&a.cross(&b), &c);
    let order = |[a, b, c]: [Vector3; 3]| circle_order(&b, &b.cross(&a), &b.cross(&c));
    let dot = |[a, _, c]: [Vector3; 3]| same_direction(&a, &c);
    let normals = |[a, b, c]: [Vector3; 3]| {
        let normal = a.cross(&b);
        same_direction(&normal, &normal.cross(&c).primitive())
    };
    let plane = |weights: [i64; 2]| {
        move |[a, b, c]: [Vector3; 3]| {
            let [v, w] = weights.map(Integer::from);
            let on = Point3::new(a.coordinates(), v).unwrap();
            let p = Point3::new(c.scaled(&w).coordinates(), w).unwrap();
            plane_side(&a.cross(&b), &on, &p)
        }
    };
    type Call = Box<dyn Fn([Vector3; 3]) -> Sign>;
    let rows: Vec<(&str, Call, [Vector3; 3], Stage)> = vec![
        ("det, 41 bits suffice", Box::new(det), triple(41), Stage::Narrow),
        ("det, 41 bits, flat", Box::new(det), flat(41), Stage::Narrow),
        ("det, 50 bits", Box::new(det), triple(50), Stage::Float),
        ("det, 50 bits, flat", Box::new(det), flat(50), Stage::Fixed),
        ("det, 62 bits, flat", Box::new(det), flat(62), Stage::Fixed),
        ("det, 100 bits", Box::new(det), triple(100), Stage::Float),
        ("det, 100 bits, flat", Box::new(det), flat(100), Stage::Fixed),
        ("det, 200 bits", Box::new(det), triple(200), Stage::Float),
        ("det, 200 bits, flat", Box::new(det), flat(200), Stage::Big),
        ("det, 1100 bits", Box::new(det), triple(1100), Stage::Big),
        ("side, 20 bits", Box::new(side), triple(20), Stage::Narrow),
        ("side, 20 bits, flat", Box::new(side), flat(20), Stage::Narrow),
        ("side, 53 bits", Box::new(side), triple(53), Stage::Float),
        ("side, 53 bits, flat", Box::new(side), flat(53), Stage::Fixed),
        ("side, 62 bits, flat", Box::new(side), flat(62), Stage::Fixed),
        ("side, 100 bits", Box::new(side), triple(100), Stage::Float),
        ("side, 100 bits, flat", Box::new(side), flat(100), Stage::Big),
        ("order, 20 bits", Box::new(order), triple(20), Stage::Narrow),
        ("order, 53 bits", Box::new(order), triple(53), Stage::Float),
        ("order, 53 bits, flat", Box::new(order), flat(53), Stage::Fixed),
        ("order, 62 bits, flat", Box::new(order), flat(62), Stage::Fixed),
        ("order, 100 bits", Box::new(order), triple(100), Stage::Float),
        ("order, 100 bits, flat", Box::new(order), flat(100), Stage::Big),
        ("dot, 62 bits", Box::new(dot), triple(62), Stage::Narrow),
        ("dot, 100 bits", Box::new(dot), triple(100), Stage::Float),
        ("dot, 200 bits", Box::new(dot), triple(200), Stage::Float),
        ("normals, perpendicular", Box::new(normals), triple(40), Stage::Fixed),
        ("plane, one weight, 20 bits", Box::new(plane([1, 1])), triple(20), Stage::Narrow),
        ("plane, one weight, 20 bits, flat", Box::new(plane([1, 1])), flat(20), Stage::Narrow),
        ("plane, one weight, 50 bits", Box::new(plane([1, 1])), triple(50), Stage::Float),
        ("plane, one weight, 50 bits, flat", Box::new(plane([1, 1])), flat(50), Stage::Fixed),
        ("plane, two weights, 40 bits", Box::new(plane([1, 3])), triple(40), Stage::Float),
        ("plane, two weights, 40 bits, flat", Box::new(plane([1, 3])), flat(40), Stage::Fixed),
        ("plane, 70 bits", Box::new(plane([1, 1])), triple(70), Stage::Float),
        ("plane, 70 bits, flat", Box::new(plane([1, 3])), flat(70), Stage::Big),
    ];
    let _guard = force(Start::Usual);
    for (name, call, input, stage) in rows {
        let before = thread_counts();
        let sign = call(input);
        let counts = thread_counts() - before;
        assert_eq!((counts.of(stage), counts.total()), (1, 1), "{name}: {sign:?} by {counts:?}");
    }
    // Intervals: an overflow beside zeros, which the filter cannot see through.
    let huge = Vector3::new([Integer::ONE << 1100, Integer::ZERO, Integer::ZERO]);
    let [y, z] = [[0, -1, 0], [0, 5, 1]].map(Vector3::from_i64);
    let before = thread_counts();
    assert_eq!(orientation(&huge, &y, &z), Sign::Negative);
    assert_eq!(same_direction(&huge, &z), Sign::Zero);
    assert_eq!((thread_counts() - before).interval, 2);
}

/// The bounds of the fixed tier: greatest magnitudes with all signs. The debug assertions of `Fixed` look for overflow.
#[test]
fn extreme_coordinates_do_not_overflow() {
    let narrow = (Integer::ONE << 62) - Integer::ONE;
    let double = (Integer::ONE << 126) - Integer::ONE;
    let vector = |mask: u32, limit: &Integer| {
        Vector3::new([0, 1, 2].map(|axis| if mask >> axis & 1 == 1 { -limit } else { limit.clone() }))
    };
    for mask in 0..512 {
        let masks = [mask & 7, mask >> 3 & 7, mask >> 6];
        let [a, b, c] = masks.map(|mask| vector(mask, &narrow));
        let [l, m, n] = masks.map(|mask| vector(mask, &double));
        assert_eq!(Det111(&a, &b, &c).eval::<Fixed>().sign(), integer_det([&a, &b, &c]));
        assert_eq!(Det122(&a, &m, &n).eval::<Fixed>().sign(), integer_det([&a, &m, &n]));
        assert_eq!(Det222(&l, &m, &n).eval::<Fixed>().sign(), integer_det([&l, &m, &n]));
        assert_eq!(Dot21(&l, &b).eval::<Fixed>().sign(), integer_dot(&l, &b));
        assert_eq!(Dot22(&l, &m).eval::<Fixed>().sign(), integer_dot(&l, &m));
        assert_eq!(Dot21(&a, &b).eval::<Narrow>().verdict(), Some(integer_dot(&a, &b)));
        let coordinate = (1_i64 << 61) - 1;
        let [p, q] = [masks[0], masks[1]].map(|mask| {
            let numerators =
                [0, 1, 2].map(|axis| if mask >> axis & 1 == 1 { -coordinate } else { coordinate });
            Point3::new(numerators.map(Integer::from), Integer::from(coordinate - i64::from(mask & 1)))
                .unwrap()
        });
        let difference = Vector3::new(
            [0, 1, 2].map(|axis| q.numerator(axis) * p.weight() - p.numerator(axis) * q.weight()),
        );
        assert_eq!(SideOfPoints(&l, &p, &q).eval::<Fixed>().sign(), integer_dot(&l, &difference));
        assert_eq!(plane_side(&a, &p, &q), integer_dot(&a, &difference));
    }
    // The greatest widths for which a determinant is narrow: 42 + 41 + 41 bits.
    for mask in 0..512 {
        let limit = |bits: u32| (Integer::ONE << bits) - Integer::ONE;
        let [a, b, c] = [(mask & 7, 42), (mask >> 3 & 7, 41), (mask >> 6, 41)]
            .map(|(mask, bits)| vector(mask, &limit(bits)));
        let predicate = Det111(&a, &b, &c);
        assert_eq!(predicate.class(), Class::Narrow);
        assert_eq!(predicate.eval::<Narrow>().verdict(), Some(integer_det([&a, &b, &c])));
    }
}
