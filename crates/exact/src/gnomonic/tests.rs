//! The projection against the definitions.

use super::{CubeSide, Exit, SideSet};
use crate::planar::{compare_xy, side_of_line};
use crate::spherical::{Direction, GreatCircle, side_of_circle};
use crate::{Integer, Sign};
use std::cmp::Ordering;

fn direction(p: [i64; 3]) -> Direction {
    Direction::from_i64(p).expect("not zero")
}

fn circle(n: [i64; 3]) -> GreatCircle {
    GreatCircle::from_i64(n).expect("not zero")
}

/// All vectors with coordinates up to 2 in magnitude, but zero.
fn small_vectors() -> impl Iterator<Item = [i64; 3]> {
    (0..125).map(|i| [i / 25 - 2, i / 5 % 5 - 2, i % 5 - 2]).filter(|v| *v != [0; 3])
}

/// The same directions, held in all ways: explicit, as crossings of wide and narrow circles, wide.
fn representations(p: [i64; 3]) -> Vec<Direction> {
    let big = 1_i64 << 60;
    let mut all = vec![direction(p)];
    // Circles that pass through p, with normals far above the bits of p.
    let across: Vec<[i64; 3]> =
        small_vectors().filter(|n| (0..3).map(|i| n[i] * p[i]).sum::<i64>() == 0).collect();
    for (m, n) in across.iter().zip(across.iter().skip(3)) {
        let m = circle(std::array::from_fn(|i| m[i] * (big / 4) + n[i] * 3));
        let n = circle(std::array::from_fn(|i| n[i] * (big / 8)));
        if let Some(crossing) = Direction::crossing(&m, &n) {
            all.push(if crossing == direction(p) { crossing } else { crossing.opposite() });
        }
    }
    all
}

#[test]
fn axes_are_those_of_the_thesis() {
    let axes = CubeSide::ALL.map(CubeSide::axes);
    assert_eq!(axes, [[2, 1], [0, 2], [1, 0], [1, 2], [2, 0], [0, 1]]);
    for side in CubeSide::ALL {
        assert_eq!(CubeSide::new(side.axis(), side.is_positive()), side);
        assert_eq!(side.opposite().opposite(), side);
    }
}

#[test]
fn a_direction_lies_on_the_sides_whose_square_holds_it() {
    let mut seen = [0; 4];
    for p in small_vectors() {
        for direction in representations(p) {
            let sides = CubeSide::of(&direction);
            let expected: SideSet = CubeSide::ALL
                .into_iter()
                .filter(|side| {
                    let at = p[side.axis()] * if side.is_positive() { 1 } else { -1 };
                    at > 0 && p.iter().all(|c| c.abs() <= at)
                })
                .collect();
            assert_eq!(sides, expected, "{p:?}");
            seen[sides.count_sides()] += 1;
        }
    }
    assert!(seen[1..].iter().all(|&n| n > 0), "{seen:?}");
}

#[test]
fn projection_and_its_inverse() {
    for p in small_vectors() {
        for direction in representations(p) {
            for side in CubeSide::ALL {
                let at = p[side.axis()] * if side.is_positive() { 1 } else { -1 };
                let Some(point) = side.point_of(&direction) else {
                    assert!(at <= 0);
                    continue;
                };
                assert!(at > 0);
                assert_eq!(side.direction_of(&point), direction, "{p:?} on {side}");
                let antipodal = CubeSide::antipodal_point(&point);
                assert_eq!(side.opposite().direction_of(&antipodal), direction.opposite());
                assert_eq!(side.opposite().point_of(&direction.opposite()), Some(antipodal));
                let [u, v] = side
                    .axes()
                    .map(|axis| crate::Rational::new(p[axis].into(), at.into()).expect("not zero"));
                assert_eq!(point.coordinates(), [u, v]);
            }
        }
    }
}

#[test]
fn lines_and_circles_have_the_same_sides() {
    for n in small_vectors() {
        let circle = circle(n);
        for side in CubeSide::ALL {
            let Some(line) = side.line_of(&circle) else {
                assert_eq!(side.axes().map(|axis| n[axis]), [0, 0]);
                continue;
            };
            let lifted = side.circle_of(&line);
            assert!(lifted.is_same_set(&circle));
            assert_eq!(side.opposite().line_of(&circle), Some(CubeSide::antipodal_line(&line)));
            for p in small_vectors() {
                let p = direction(p);
                if let Some(point) = side.point_of(&p) {
                    assert_eq!(side_of_line(&point, &line), side_of_circle(&p, &lifted));
                }
            }
        }
    }
}

#[test]
fn wide_circles_and_directions() {
    let wide = |p: [i64; 3], by: u32| p.map(|c| Integer::from(c) << by);
    let normal = {
        let [x, y, z] = wide([3, -5, 4], 100);
        [x + Integer::ONE, y, z]
    };
    let wide_circle = GreatCircle::of_integers(normal.clone()).expect("not zero");
    let p = Direction::new(normal).expect("not zero");
    let side = CubeSide::of(&p).first();
    assert_eq!(side, CubeSide::new(1, false));
    let point = side.point_of(&p).expect("it is on the side");
    assert_eq!(side.direction_of(&point), p);
    assert_eq!(side.opposite().direction_of(&CubeSide::antipodal_point(&point)), p.opposite());
    for side in CubeSide::ALL {
        let line = side.line_of(&wide_circle).expect("not parallel");
        assert!(side.circle_of(&line).is_same_set(&wide_circle));
        assert_eq!(side.opposite().line_of(&wide_circle), Some(CubeSide::antipodal_line(&line)));
        if let Some(Exit::Edge { to, here, there }) = side.exit(&wide_circle) {
            assert_eq!(side.direction_of(&here), to.direction_of(&there));
        }
    }
}

#[test]
fn a_circle_leaves_where_it_meets_the_border_last() {
    let (mut corners, mut edges) = (0, 0);
    let bits = [1, 1 << 20, (1 << 60) / 2];
    for n in small_vectors()
        .flat_map(|n| bits.map(|by| [n[0] * by + 1, n[1] * by, n[2] * by - 1]))
        .chain(small_vectors())
    {
        let Some(circle) = GreatCircle::from_i64(n) else { continue };
        for side in CubeSide::ALL {
            // Only where it passes through the square: two corners are on different sides.
            let [u, v] = side.axes();
            let corner = |i: i64| {
                let mut corner = [0; 3];
                corner[side.axis()] = if side.is_positive() { 1 } else { -1 };
                (corner[u], corner[v]) = (i / 2 * 2 - 1, i % 2 * 2 - 1);
                direction(corner)
            };
            let signs: Vec<Sign> = (0..4).map(|i| side_of_circle(&corner(i), &circle)).collect();
            if !(signs.contains(&Sign::Positive) && signs.contains(&Sign::Negative)) {
                continue;
            }
            let line = side.line_of(&circle).expect("it passes through the square");
            let of_there = |exit: &Exit| match exit {
                Exit::Edge { here, .. } => here.clone(),
                Exit::Corner(corner) => side.point_of(corner).expect("a corner of the side"),
            };
            let out = side.exit(&circle).expect("it passes through the square");
            let back = side.exit(&circle.opposite()).expect("it passes through the square");
            let [target, source] = [&out, &back].map(of_there);
            for point in [&target, &source] {
                assert!(side_of_line(point, &line).is_zero(), "{n:?} on {side}");
                assert!(CubeSide::of(&side.direction_of(point)).count_sides() > 1, "{n:?} on {side}");
            }
            let is_to_right = match circle.sign(v) {
                Sign::Zero => circle.sign(u).is_negative(),
                sign => sign.is_positive(),
            };
            let order = if is_to_right { Ordering::Less } else { Ordering::Greater };
            assert_eq!(compare_xy(&source, &target), order, "{n:?} on {side}");
            match out {
                Exit::Corner(_) => corners += 1,
                Exit::Edge { to, here, there } => {
                    edges += 1;
                    assert_eq!(side.direction_of(&here), to.direction_of(&there));
                    let sides = CubeSide::of(&to.direction_of(&there));
                    assert!(sides.count_sides() == 2 && sides.contains(side) && sides.contains(to));
                }
            }
        }
    }
    assert!(corners > 0 && edges > 0);
}
