//! Rays and lines, and how they are ordered near the sides.

use super::{Linear, LinearTraits};
use crate::models::straight::tests::show;
use crate::traits::{
    Along, ApproxTraits, BasicTraits, BoundaryTraits, CurveEnd, Location, Meeting, Multiplicity,
    NearBottomTopTraits, NearLeftRightTraits, UMonotoneTraits, Window,
};
use exact::planar::Point2;
use std::cmp::Ordering::Equal;

type Ends = [[i64; 2]; 2];

fn point(p: [i64; 2]) -> Point2 {
    Point2::from_i64(p)
}

fn segment(ends: Ends) -> Linear {
    Linear::segment(point(ends[0]), point(ends[1])).unwrap()
}

fn ray([from, through]: Ends) -> Linear {
    Linear::ray(point(from), &point(through)).unwrap()
}

fn line([p, q]: Ends) -> Linear {
    Linear::line(&point(p), &point(q)).unwrap()
}

#[test]
fn unbounded_curves_in_common() {
    let rows = [
        (line([[0, 0], [1, 0]]), line([[0, 0], [0, 1]]), "(0, 0) Odd"),
        (line([[0, 0], [1, 0]]), line([[0, 1], [1, 1]]), ""),
        (line([[0, 0], [1, 1]]), line([[2, 2], [0, 0]]), "..-.."),
        (ray([[0, 0], [1, 1]]), ray([[3, 3], [2, 2]]), "(0, 0)-(3, 3)"),
        (ray([[0, 0], [-1, -1]]), ray([[0, 0], [2, 2]]), "(0, 0) Unknown"),
        (ray([[0, 0], [-1, -1]]), ray([[1, 1], [2, 2]]), ""),
        (ray([[0, 0], [1, 1]]), line([[5, 5], [2, 2]]), "(0, 0)-.."),
        (ray([[0, 0], [0, -1]]), ray([[0, 2], [0, 3]]), ""),
        (ray([[0, 0], [0, 1]]), line([[-1, 4], [1, 4]]), "(0, 4) Odd"),
        (ray([[0, 0], [0, -1]]), line([[-1, 4], [1, 4]]), ""),
        (ray([[0, 4], [0, -1]]), line([[-1, 4], [1, 4]]), "(0, 4) Unknown"),
        (ray([[1, 0], [2, 0]]), segment([[0, -1], [0, 1]]), ""),
        (ray([[1, 0], [-2, 0]]), segment([[0, -1], [0, 1]]), "(0, 0) Odd"),
        (ray([[0, 0], [1, 5]]), ray([[4, 0], [3, 5]]), "(2, 10) Odd"),
        (ray([[0, 0], [-1, 5]]), ray([[4, 0], [5, 5]]), ""),
    ];
    for (a, b, expected) in rows {
        for [a, b] in [[&a, &b], [&b, &a]] {
            let mut common = Vec::new();
            LinearTraits.intersect(a, b, &mut common);
            assert_eq!(show(&LinearTraits, &common), expected, "{a:?} {b:?}");
        }
    }
}

#[test]
fn unbounded_neighbours() {
    let none = Window { after: None, until: None, first_to_end: 0 };
    let meet = |below: Linear, above: Linear| LinearTraits.next_meeting(&below, &above, none);
    assert_eq!(meet(line([[0, 0], [1, 0]]), line([[0, 1], [1, 1]])), Meeting::Never);
    assert_eq!(meet(line([[0, 0], [1, 0]]), line([[0, 1], [1, 2]])), Meeting::Never);
    assert_eq!(
        meet(line([[0, 0], [1, 2]]), line([[0, 1], [1, 1]])),
        Meeting::At(
            Point2::crossing(
                line([[0, 0], [1, 2]]).supporting_line(),
                line([[0, 1], [1, 1]]).supporting_line()
            )
            .unwrap(),
            Multiplicity::Odd
        )
    );
    assert_eq!(
        meet(ray([[0, 0], [0, 1]]), line([[0, 3], [1, 1]])),
        Meeting::At(point([0, 3]), Multiplicity::Odd)
    );
    assert_eq!(meet(line([[0, 0], [1, 1]]), ray([[0, 0], [0, 1]])), Meeting::Never);
}

#[test]
fn ends_at_infinity() {
    let at = |u, v| Location { u, v };
    let rows = [
        (segment([[0, 0], [1, 1]]), [Location::INTERIOR; 2]),
        (line([[0, 0], [1, 1]]), [at(Along::Low, Along::Inside), at(Along::High, Along::Inside)]),
        (line([[0, 1], [0, 0]]), [at(Along::Inside, Along::Low), at(Along::Inside, Along::High)]),
        (ray([[0, 1], [0, 0]]), [at(Along::Inside, Along::Low), Location::INTERIOR]),
        (ray([[0, 1], [-1, 5]]), [at(Along::Low, Along::Inside), Location::INTERIOR]),
        (ray([[0, 1], [1, 1]]), [Location::INTERIOR, at(Along::High, Along::Inside)]),
    ];
    for (curve, expected) in rows {
        let found = CurveEnd::BOTH.map(|end| LinearTraits.end_location(&curve, end));
        assert_eq!(found, expected, "{curve:?}");
        for end in CurveEnd::BOTH {
            let is_interior = LinearTraits.end_location(&curve, end).is_interior();
            assert_eq!(LinearTraits.end_point(&curve, end).is_some(), is_interior);
        }
    }
}

#[test]
fn order_near_the_sides() {
    // From bottom to top on the right; the last two are one line.
    let lines = [
        [[0, 0], [1, -9]],
        [[0, 0], [2, -1]],
        [[0, -1], [3, -1]],
        [[0, 0], [2, 0]],
        [[0, 0], [2, 1]],
        [[0, 1], [4, 3]],
        [[0, 0], [1, 1]],
        [[7, 7], [3, 3]],
    ];
    let on_right = |i: usize, j: usize| if i.min(j) >= 6 { Equal } else { i.cmp(&j) };
    for (i, a) in lines.into_iter().enumerate() {
        for (j, b) in lines.into_iter().enumerate() {
            let (a, b) = (line(a), line(b));
            assert_eq!(
                LinearTraits.compare_v_near_side(&a, &b, CurveEnd::Max),
                on_right(i, j),
                "{a:?} {b:?}"
            );
            // On the left, steep lines are below; parallel ones keep their order.
            let on_left = match a.supporting_line().compare_slope(b.supporting_line()) {
                Equal => on_right(i, j),
                by_slope => by_slope.reverse(),
            };
            assert_eq!(LinearTraits.compare_v_near_side(&a, &b, CurveEnd::Min), on_left, "{a:?} {b:?}");
        }
    }
    let [low, high] = CurveEnd::BOTH;
    let verticals = [[[-1, 0], [-1, 1]], [[0, 0], [0, 1]], [[2, 4], [2, 1]], [[2, 9], [2, 5]]].map(line);
    for (i, a) in verticals.iter().enumerate() {
        for (j, b) in verticals.iter().enumerate() {
            let expected = i.min(2).cmp(&j.min(2));
            assert_eq!(LinearTraits.compare_u_of_ends((a, low), (b, high)), expected);
        }
        for (x, expected) in [(-2, 0), (-1, 1), (0, 3), (1, 4), (2, 5), (3, 7)] {
            let place = [1, 3, 5, 5][i];
            assert_eq!(
                LinearTraits.compare_u_near_end(&point([x, 0]), a, high),
                expected.cmp(&place),
                "{x} {a:?}"
            );
        }
    }
}

#[test]
fn points_beside_unbounded_curves() {
    let vertical = ray([[0, 0], [0, 1]]);
    assert!(LinearTraits.is_on_curve(&point([0, 5]), &vertical));
    assert!(!LinearTraits.is_on_curve(&point([0, -1]), &vertical));
    assert!(!LinearTraits.is_on_curve(&point([1, 5]), &vertical));
    let ray = ray([[0, 0], [2, 1]]);
    assert!(LinearTraits.is_on_curve(&point([1000, 500]), &ray));
    assert!(!LinearTraits.is_on_curve(&point([-2, -1]), &ray));
    assert!(!LinearTraits.is_in_u_range(&point([-2, -1]), &ray));
    let parts = LinearTraits.split(&line([[0, 0], [2, 1]]), &point([4, 2]));
    assert_eq!(
        [parts[0].ends(), parts[1].ends()],
        [&[None, Some(point([4, 2]))], &[Some(point([4, 2])), None]]
    );
    assert_eq!(LinearTraits.merge(&parts[1], &parts[0]), Some(line([[0, 0], [2, 1]])));
}

#[test]
fn unbounded_curves_are_cut_off_at_the_window() {
    let window = [-1.0, -1.0, 3.0, 2.0];
    let rows: [(Linear, &[[f64; 2]]); 9] = [
        (line([[0, 0], [1, 0]]), &[[-1.0, 0.0], [3.0, 0.0]]),
        (line([[0, 0], [1, 1]]), &[[-1.0, -1.0], [2.0, 2.0]]),
        (line([[0, 0], [1, -2]]), &[[-1.0, 2.0], [0.5, -1.0]]),
        (line([[0, 9], [1, 9]]), &[]),
        (line([[1, 9], [1, 3]]), &[[1.0, -1.0], [1.0, 2.0]]),
        (line([[7, 9], [7, 3]]), &[]),
        (ray([[1, 1], [1, 0]]), &[[1.0, -1.0], [1.0, 1.0]]),
        (ray([[1, 1], [-1, 1]]), &[[-1.0, 1.0], [1.0, 1.0]]),
        (ray([[9, 0], [10, 0]]), &[]),
    ];
    for (curve, expected) in rows {
        let mut floats = Vec::new();
        LinearTraits.approx_curve(&curve, None, None, window, &mut floats);
        assert_eq!(floats, expected, "{curve:?}");
    }
    let mut floats = Vec::new();
    LinearTraits.approx_curve(&line([[0, 0], [1, 0]]), Some(&point([1, 0])), None, window, &mut floats);
    assert_eq!(floats, [[1.0, 0.0], [3.0, 0.0]]);
}
