use super::*;
use crate::Integer;
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
