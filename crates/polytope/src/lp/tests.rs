//! The program against certificates: a solution for each that is feasible, constraints that exclude each
//! other for each that is not.

#![allow(clippy::print_stderr, reason = "tests print their seeds")]

use super::program::{Program, solve};
use exact::{Integer, Vector3};

type V = [i64; 3];

fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: V, b: V) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn det(a: V, b: V, c: V) -> i64 {
    dot(cross(a, b), c)
}

fn run(axis: V, constraints: &[V]) -> Program {
    let vectors: Vec<_> = constraints.iter().copied().map(Vector3::from_i64).collect();
    solve(&Vector3::from_i64(axis), vectors.iter().enumerate())
}

/// The answer by brute force: `right` and `left` are those from which all others lie to one side, the
/// farthest from the axis and the first of them.
fn brute(axis: V, constraints: &[V]) -> Program {
    if constraints.is_empty() {
        return Program::Free;
    }
    // In the plane perpendicular to the axis: the projection of d, turned by a right angle.
    let flat: Vec<V> = constraints.iter().map(|&d| cross(axis, d)).collect();
    let bound = |side: i64| {
        let bounds = |&i: &usize| {
            (0..flat.len()).all(|j| {
                let turn = side * det(axis, flat[i], flat[j]);
                turn > 0 || turn == 0 && dot(flat[i], flat[j]) > 0
            })
        };
        let farther = |best: usize, i: usize| {
            if dot(flat[best], cross(constraints[best], constraints[i])) > 0 { i } else { best }
        };
        (0..flat.len()).filter(bounds).reduce(farther)
    };
    match (bound(1), bound(-1)) {
        (Some(right), Some(left)) => Program::Feasible { right, left },
        _ => Program::Infeasible,
    }
}

/// A solution made of the two constraints that bind: half-way between the planes that they span with
/// the axis.
fn witness(axis: V, right: V, left: V) -> V {
    let (r, l) = (cross(right, axis), cross(axis, left));
    let sum = [r[0] + l[0], r[1] + l[1], r[2] + l[2]];
    // One half-plane: both normals cancel, and the perpendicular on the other side solves.
    if sum == [0; 3] || det(axis, right, left) == 0 { cross(axis, cross(axis, right)) } else { sum }
}

/// Whether some constraints exclude each other: one that projects to zero, two opposite ones, or three
/// that have the origin in their midst.
fn is_refuted(axis: V, constraints: &[V]) -> bool {
    let flat: Vec<V> = constraints.iter().map(|&d| cross(axis, d)).collect();
    let turn = |a: V, b: V| det(axis, a, b).signum();
    flat.contains(&[0; 3])
        || flat.iter().any(|&a| flat.iter().any(|&b| turn(a, b) == 0 && dot(a, b) < 0))
        || flat.iter().any(|&a| {
            flat.iter().any(|&b| turn(a, b) > 0 && flat.iter().any(|&c| turn(b, c) > 0 && turn(c, a) > 0))
        })
}

fn check(axis: V, constraints: &[V]) -> Program {
    let answer = run(axis, constraints);
    let context = format!("axis {axis:?}, constraints {constraints:?}");
    match (answer, brute(axis, constraints)) {
        (Program::Feasible { right, left }, Program::Feasible { right: r, left: l }) => {
            let c = witness(axis, constraints[right], constraints[left]);
            assert_eq!(dot(c, axis), 0, "{context}");
            assert!(constraints.iter().all(|&d| dot(c, d) < 0), "{c:?} does not solve {context}");
            assert!(!is_refuted(axis, constraints), "{context}");
            for (found, expected) in [(right, r), (left, l)] {
                let (found, expected) = (constraints[found], constraints[expected]);
                assert_eq!(cross(found, expected), [0; 3], "{context}");
                assert!(dot(found, expected) > 0, "{context}");
            }
        }
        (Program::Infeasible, Program::Infeasible) => assert!(is_refuted(axis, constraints), "{context}"),
        (found, expected) => assert_eq!(found, expected, "{context}"),
    }
    answer
}

/// Splitmix64: `testkit` would bring another copy of this crate.
struct Rng(u64);

impl Rng {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn vector(&mut self, range: i64) -> V {
        loop {
            let vector = [0; 3].map(|_: i64| (self.bits() % (2 * range as u64 + 1)) as i64 - range);
            if vector != [0; 3] {
                return vector;
            }
        }
    }
}

#[test]
fn programs_by_hand() {
    use Program::{Feasible, Free, Infeasible};
    let z = [0, 0, 1];
    let rows: [(&str, &[V], Program); 15] = [
        ("nothing", &[], Free),
        ("one", &[[1, 0, 5]], Feasible { right: 0, left: 0 }),
        ("along the axis", &[[0, 0, 2]], Infeasible),
        ("against the axis", &[[0, 0, -3]], Infeasible),
        ("along the axis, late", &[[1, 0, 0], [0, 1, 0], [0, 0, 1]], Infeasible),
        ("a right angle", &[[0, 1, 3], [1, 0, -7]], Feasible { right: 1, left: 0 }),
        ("one between", &[[0, 1, 0], [1, 0, 0], [1, 1, 0]], Feasible { right: 1, left: 0 }),
        ("opposite", &[[1, 2, 0], [-2, -4, 9]], Infeasible),
        ("opposite to the right side", &[[1, 0, 0], [0, 1, 0], [-1, 0, 0]], Infeasible),
        ("opposite to the left side", &[[1, 0, 0], [0, 1, 0], [0, -1, 0]], Infeasible),
        ("all around", &[[1, 0, 0], [0, 1, 0], [-1, -1, 0]], Infeasible),
        ("one half-plane, the farthest", &[[1, 0, 0], [1, 0, -2], [2, 0, 1]], Feasible { right: 1, left: 1 }),
        ("ties on the right", &[[1, 0, 0], [0, 1, 0], [1, 0, -1]], Feasible { right: 2, left: 1 }),
        ("ties on the left", &[[1, 0, 0], [0, 1, 0], [0, 3, -1]], Feasible { right: 0, left: 2 }),
        ("equal ones, the first", &[[1, 0, 1], [2, 0, 2]], Feasible { right: 0, left: 0 }),
    ];
    for (name, constraints, expected) in rows {
        assert_eq!(check(z, constraints), expected, "{name}");
    }
}

#[test]
fn random_programs_have_certificates() {
    let seed = 0x1b_0001;
    eprintln!("seed {seed:#x}");
    let mut rng = Rng(seed);
    let mut met = [0; 2];
    for i in 0..60_000 {
        let range = [1, 2, 5, 40][i % 4];
        let axis = rng.vector(range);
        // Half of them on one side, or hardly any would be feasible.
        let half = (i / 4 % 2 == 0).then(|| rng.vector(range));
        let count = rng.bits() % 8;
        let mut constraints: Vec<V> = (0..count).map(|_| rng.vector(range)).collect();
        if let Some(half) = half {
            constraints.retain(|&d| dot(half, d) < 0);
        }
        met[usize::from(check(axis, &constraints) == Program::Infeasible)] += 1;
    }
    assert!(met.iter().all(|&times| times > 10_000), "{met:?}");
}

/// Multiples, shears along the axis, the order, prefixes.
#[test]
fn laws_of_the_program() {
    let seed = 0x1b_0002;
    eprintln!("seed {seed:#x}");
    let mut rng = Rng(seed);
    for _ in 0..10_000 {
        let axis = rng.vector(3);
        let count = 1 + rng.bits() % 6;
        let constraints: Vec<V> = (0..count).map(|_| rng.vector(3)).collect();
        let answer = run(axis, &constraints);
        let feasible = answer != Program::Infeasible;

        let scaled: Vec<V> = constraints.iter().map(|d| d.map(|c| 3 * c)).collect();
        assert_eq!(run(axis.map(|c| 5 * c), &scaled), answer, "{axis:?} {constraints:?}");

        let sheared: Vec<V> = constraints
            .iter()
            .map(|d| {
                let times = rng.bits() as i64 % 5;
                [0, 1, 2].map(|i: usize| d[i] + times * axis[i])
            })
            .collect();
        let changed = run(axis, &sheared);
        assert_eq!(changed != Program::Infeasible, feasible, "{axis:?} {constraints:?}");
        if let (Program::Feasible { right, left }, Program::Feasible { right: r, left: l }) =
            (answer, changed)
        {
            for (one, other) in [(right, r), (left, l)] {
                assert_eq!(det(axis, constraints[one], constraints[other]), 0);
            }
        }

        let mut reversed = constraints.clone();
        reversed.reverse();
        assert_eq!(run(axis, &reversed) != Program::Infeasible, feasible, "{axis:?} {constraints:?}");
        if feasible {
            for n in 0..constraints.len() {
                assert_ne!(run(axis, &constraints[..n]), Program::Infeasible, "{axis:?} {constraints:?}");
            }
        }
    }
}

/// The same with coordinates beyond machine integers: an integer map of determinant one on all vectors.
#[test]
fn wide_programs() {
    let seed = 0x1b_0003;
    eprintln!("seed {seed:#x}");
    let mut rng = Rng(seed);
    for bits in [20, 58, 64, 120, 200] {
        let p = Integer::ONE << bits;
        let map = |v: &V| {
            let [x, y, z] = v.map(Integer::from);
            // Two shears, one after the other.
            let y = y + &p * &x;
            let z = z + &p * &y;
            Vector3::new([x, y, z])
        };
        for _ in 0..400 {
            let axis = rng.vector(3);
            let count = rng.bits() % 6;
            let constraints: Vec<V> = (0..count).map(|_| rng.vector(3)).collect();
            let mapped: Vec<Vector3> = constraints.iter().map(map).collect();
            // The map keeps the signs of determinants, and which of two vectors in a half-plane is farther
            // from the axis: the answer is the same.
            let wide = solve(&map(&axis), mapped.iter().enumerate());
            assert_eq!(wide, run(axis, &constraints), "{axis:?} {constraints:?}, {bits} bits");
        }
    }
}
