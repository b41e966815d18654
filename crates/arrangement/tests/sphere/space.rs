//! Directions in space, as integer vectors, and linear maps: plain arithmetic that shares nothing with the predicates of the library.

use exact::{Integer, Sign};
use std::cmp::Ordering;
use testkit::Rng;

/// A direction: no positive multiple is another one. Those that are compared have no common factor.
pub(crate) type P = [Integer; 3];

/// The rows of a matrix.
pub(crate) type Matrix = [P; 3];

pub(crate) fn at([x, y, z]: [i64; 3]) -> P {
    [x.into(), y.into(), z.into()]
}

pub(crate) fn dot(a: &P, b: &P) -> Integer {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

pub(crate) fn cross(a: &P, b: &P) -> P {
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// The sign of a determinant.
pub(crate) fn turn(a: &P, b: &P, c: &P) -> Sign {
    dot(a, &cross(b, c)).sign()
}

pub(crate) fn is_zero(a: &P) -> bool {
    a.iter().all(Integer::is_zero)
}

pub(crate) fn opposite(a: &P) -> P {
    a.each_ref().map(|x| -x)
}

/// Without a common factor.
///
/// # Panics
/// If all coordinates are zero.
pub(crate) fn primitive(a: &P) -> P {
    let factor = a[0].gcd(&a[1]).gcd(&a[2]);
    a.each_ref().map(|x| x.div_exact(&factor))
}

/// The sum of two directions, with weights that make them about equally long: between them, if they are not opposite.
pub(crate) fn between(a: &P, b: &P) -> P {
    let length = |a: &P| a.iter().map(Integer::bit_len).max().unwrap_or(0);
    let (long_a, long_b) = (length(a), length(b));
    let most = long_a.max(long_b);
    primitive(&[0, 1, 2].map(|i| (a[i].clone() << (most - long_a)) + (b[i].clone() << (most - long_b))))
}

/// How far a direction is on its way counterclockwise round a normal from a start on the same circle: at the start, in the
/// first half, opposite, in the second half.
fn quarter(normal: &P, start: &P, a: &P) -> u8 {
    match turn(normal, start, a) {
        Sign::Positive => 1,
        Sign::Negative => 3,
        Sign::Zero if dot(start, a).sign() == Sign::Positive => 0,
        Sign::Zero => 2,
    }
}

/// Compares two directions on one circle: which of them comes first, counterclockwise round the normal from the start.
pub(crate) fn compare_way(normal: &P, start: &P, a: &P, b: &P) -> Ordering {
    let [of_a, of_b] = [a, b].map(|x| quarter(normal, start, x));
    of_a.cmp(&of_b).then_with(|| match turn(normal, a, b) {
        Sign::Positive => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Negative => Ordering::Greater,
    })
}

pub(crate) fn north() -> P {
    at([0, 0, 1])
}

pub(crate) fn is_pole(a: &P) -> bool {
    a[0].is_zero() && a[1].is_zero()
}

/// Some direction orthogonal to another.
pub(crate) fn orthogonal(a: &P) -> P {
    let axis = if a[0].is_zero() { at([1, 0, 0]) } else { at([0, 1, 0]) };
    primitive(&cross(a, &axis))
}

pub(crate) fn matrix(rows: [[i64; 3]; 3]) -> Matrix {
    rows.map(at)
}

pub(crate) fn image(matrix: &Matrix, a: &P) -> P {
    primitive(&matrix.each_ref().map(|row| dot(row, a)))
}

/// The image of a normal: that of a circle, in the same direction round it.
pub(crate) fn image_of_normal([a, b, c]: &Matrix, normal: &P) -> P {
    image(&[cross(b, c), cross(c, a), cross(a, b)], normal)
}

pub(crate) fn determinant([a, b, c]: &Matrix) -> Sign {
    turn(a, b, c)
}

/// The rotation of a quaternion, times the square of its length.
pub(crate) fn rotation(quaternion: [i64; 4]) -> Matrix {
    let [w, x, y, z] = quaternion.map(Integer::from);
    let two = Integer::from(2);
    let square = |a: &Integer| a * a;
    let mixed = |a: &Integer, b: &Integer, c: &Integer| &two * (a * b + &w * c);
    let diagonal = |a: &Integer, b: &Integer, c: &Integer| square(&w) + square(a) - square(b) - square(c);
    [
        [diagonal(&x, &y, &z), mixed(&x, &y, &-&z), mixed(&x, &z, &y)],
        [mixed(&x, &y, &z), diagonal(&y, &z, &x), mixed(&y, &z, &-&x)],
        [mixed(&x, &z, &-&y), mixed(&y, &z, &x), diagonal(&z, &x, &y)],
    ]
}

/// A random rotation with quaternion components from `-range` to `range`; once in four times one that maps axes to axes.
pub(crate) fn random_rotation(rng: &mut Rng, range: i64) -> Matrix {
    const TURNS: [[i64; 4]; 7] =
        [[1, 0, 0, 0], [1, 1, 0, 0], [1, 0, 1, 0], [1, 0, 0, 1], [0, 1, 0, 0], [1, 1, 1, 1], [0, 1, 1, 0]];
    if rng.one_in(4) {
        return rotation(*rng.choose(&TURNS));
    }
    loop {
        let components = [0; 4].map(|_: i64| rng.within(range));
        if components != [0; 4] {
            return rotation(components);
        }
    }
}

#[test]
fn rotations_rotate() {
    let mut rng = Rng::new(5);
    for _ in 0..100 {
        let map = random_rotation(&mut rng, 9);
        let [a, b, c] = &map;
        assert_eq!(determinant(&map), Sign::Positive);
        assert!([dot(a, b), dot(b, c), dot(c, a)].iter().all(Integer::is_zero));
        assert!(dot(a, a) == dot(b, b) && dot(b, b) == dot(c, c));
        let p = at([1, 2, 3]);
        assert_eq!(image_of_normal(&map, &p), image(&map, &p));
    }
}
