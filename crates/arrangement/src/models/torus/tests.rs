//! Cutting, and the predicates at the sides.

use super::{TorusError, TorusPath, TorusSegment, TorusSegmentTraits};
use crate::traits::{
    Along, ApproxTraits, ArrangementTraits, BasicTraits, BoundaryTraits, CurveEnd, DirectionalTraits,
    IdentifiedBottomTopTraits, IdentifiedLeftRightTraits, Intersection, Location, Meeting, Multiplicity,
    Piece, UMonotoneTraits, Window,
};
use exact::Rational;
use exact::planar::Point2;
use std::cmp::Ordering::{Equal, Greater, Less};

fn point(p: [i64; 2]) -> Point2 {
    Point2::from_i64(p)
}

/// Periods 4 and 3.
fn traits() -> TorusSegmentTraits {
    TorusSegmentTraits::new([4.into(), 3.into()]).unwrap()
}

fn path(start: [i64; 2], way: [i64; 2]) -> TorusPath {
    traits().path(&point(start), &way.map(Rational::from)).unwrap()
}

fn pieces(path: &TorusPath) -> Vec<Piece<Point2, TorusSegment>> {
    let mut pieces = Vec::new();
    traits().make_u_monotone(path, &mut pieces);
    pieces
}

/// The only piece of a path.
fn piece(start: [i64; 2], way: [i64; 2]) -> TorusSegment {
    match pieces(&path(start, way)).pop() {
        Some(Piece::Curve { curve, .. }) => curve,
        _ => panic!("the path has one piece"),
    }
}

/// Each piece from source to target in the rectangle, with a star at artificial ends.
fn show(pieces: &[Piece<Point2, TorusSegment>]) -> String {
    let one = |piece: &Piece<Point2, TorusSegment>| match piece {
        Piece::Point(p) => format!("point {p}"),
        Piece::Curve { curve, is_artificial } => {
            let mut ends = CurveEnd::BOTH.map(|end| {
                format!("{}{}", curve.place(end), if is_artificial[end as usize] { "*" } else { "" })
            });
            if !traits().is_directed_right(curve) {
                ends.reverse();
            }
            ends.join("-")
        }
    };
    pieces.iter().map(one).collect::<Vec<_>>().join(" ")
}

#[test]
fn paths_are_cut_at_the_sides() {
    let rows = [
        ([1, 1], [2, 1], "(1, 1)-(3, 2)"),
        ([1, 1], [0, 0], "point (1, 1)"),
        ([5, -2], [0, 0], "point (1, 1)"),
        ([1, 1], [3, 0], "(1, 1)-(4, 1)"),
        ([1, 1], [4, 0], "(1, 1)-(4, 1)* (0, 1)*-(1, 1)"),
        ([1, 1], [-2, 0], "(1, 1)-(0, 1)* (4, 1)*-(3, 1)"),
        ([0, 0], [4, 3], "(0, 0)-(4, 3)"),
        ([0, 0], [-4, -3], "(4, 3)-(0, 0)"),
        ([0, 0], [-4, 3], "(4, 0)-(0, 3)"),
        ([2, 0], [4, 6], "(2, 0)-(4, 3)* (0, 0)*-(2, 3)"),
        ([3, 2], [2, 2], "(3, 2)-(4, 3)* (0, 0)*-(1, 1)"),
        ([2, 2], [4, 2], "(2, 2)-(4, 3)* (0, 0)*-(2, 1)"),
        // Along the sides: on the left and the bottom.
        ([0, 1], [0, 1], "(0, 1)-(0, 2)"),
        ([4, 1], [0, -2], "(0, 1)-(0, 0)* (0, 3)*-(0, 2)"),
        ([1, 3], [-2, 0], "(1, 0)-(0, 0)* (4, 0)*-(3, 0)"),
        ([0, 0], [0, 7], "(0, 0)-(0, 3)* (0, 0)*-(0, 3)* (0, 0)*-(0, 1)"),
    ];
    for (start, way, expected) in rows {
        assert_eq!(show(&pieces(&path(start, way))), expected, "{start:?} {way:?}");
    }
}

#[test]
fn closed_paths_have_no_real_end() {
    let rows = [
        ([1, 1], [0, 0], "point (1, 1)"),
        ([1, 1], [1, 0], "(0, 1)*-(4, 1)*"),
        ([1, 1], [-1, 0], "(4, 1)*-(0, 1)*"),
        ([1, 1], [0, 1], "(1, 0)*-(1, 3)*"),
        ([4, 1], [0, 1], "(0, 0)*-(0, 3)*"),
        ([4, 6], [1, 1], "(0, 0)*-(4, 3)*"),
        ([2, 0], [1, 1], "(0, 3/2)*-(2, 3)* (2, 0)*-(4, 3/2)*"),
    ];
    for (through, winding, expected) in rows {
        let path = traits().closed_path(&point(through), winding).unwrap();
        assert!(path.is_closed());
        assert_eq!(show(&pieces(&path)), expected, "{through:?} {winding:?}");
    }
}

#[test]
fn what_cannot_be_made() {
    assert_eq!(TorusSegmentTraits::new([1.into(), 0.into()]).unwrap_err(), TorusError::PeriodNotPositive(1));
    assert_eq!(
        TorusSegmentTraits::new([Rational::from(-1), 1.into()]).unwrap_err().to_string(),
        "the period along u is not positive"
    );
    let most = i64::from(TorusPath::MAX_PIECES);
    for winding in [[most, 0], [0, -most], [i64::MIN, i64::MAX], [most / 2, most / 2]] {
        let made = traits().closed_path(&point([1, 1]), winding);
        assert_eq!(made.unwrap_err(), TorusError::TooManyPieces);
    }
    let huge = "1e300".parse::<Rational>().unwrap();
    assert_eq!(
        traits().path(&point([1, 1]), &[huge.clone(), 1.into()]).unwrap_err(),
        TorusError::TooManyPieces
    );
    let far = Point2::from_rationals(&[&huge + Rational::ONE, huge]);
    assert!(traits().path(&far, &[1.into(), 1.into()]).is_ok());
    assert_eq!(pieces(&traits().closed_path(&point([1, 1]), [1000, -1]).unwrap()).len(), 1001);
}

#[test]
fn ends_are_points_and_places() {
    let at = |u, v| Location { u, v };
    let (low, inside, high) = (Along::Low, Along::Inside, Along::High);
    let curve = piece([1, 0], [3, 3]);
    assert_eq!(
        CurveEnd::BOTH.map(|end| traits().end_location(&curve, end)),
        [at(inside, low), at(high, high)]
    );
    assert_eq!(curve.place(CurveEnd::Max), &point([4, 3]));
    assert_eq!(traits().end_point(&curve, CurveEnd::Max), Some(&point([0, 0])));
    let along = piece([0, 1], [0, 1]);
    assert!(along.is_along_side() && traits().is_vertical(&along));
    assert_eq!(CurveEnd::BOTH.map(|end| traits().end_location(&along, end)), [at(low, inside); 2]);
    assert!(!curve.is_along_side() && !piece([1, 1], [0, 1]).is_along_side());
    assert!(traits().is_on_left_right(&point([0, 2])) && !traits().is_on_left_right(&point([2, 0])));
    assert!(traits().is_on_bottom_top(&point([2, 0])) && !traits().is_on_bottom_top(&point([0, 2])));
    assert_eq!(traits().compare_v_on_left_right(&point([0, 2]), &point([0, 1])), Greater);
    assert_eq!(traits().compare_u_on_bottom_top(&point([1, 0]), &point([2, 2])), Less);
    assert_eq!(traits().point(&point([-1, 7])), point([3, 1]));
}

#[test]
fn points_of_sides_beside_curves() {
    let traits = traits();
    let to_right = piece([2, 1], [2, 1]);
    assert_eq!(traits.compare_v_at_u(&point([0, 1]), &to_right), Less);
    assert_eq!(traits.compare_v_at_u(&point([0, 2]), &to_right), Equal);
    assert!(traits.is_on_curve(&point([0, 2]), &to_right) && traits.is_in_u_range(&point([0, 0]), &to_right));
    let to_top = piece([2, 1], [1, 2]);
    assert_eq!(traits.compare_v_at_u(&point([3, 0]), &to_top), Less);
    assert!(traits.is_on_curve(&point([3, 0]), &to_top) && !traits.is_in_u_range(&point([0, 0]), &to_top));
    let whole = piece([0, 0], [4, 3]);
    assert_eq!(traits.compare_v_at_u(&point([0, 2]), &whole), Greater);
    assert!(traits.is_on_curve(&point([0, 0]), &whole) && !traits.is_on_curve(&point([0, 2]), &whole));
}

#[test]
fn what_pieces_have_in_common() {
    let rows = [
        (piece([1, 1], [2, 0]), piece([2, 0], [0, 3]), "(2, 1) Odd"),
        // One point of the torus in two places.
        (piece([2, 1], [2, 0]), piece([0, 1], [1, 1]), "(0, 1) Unknown"),
        (piece([2, 1], [2, 0]), piece([0, 2], [1, 0]), ""),
        // To the side, on which another lies.
        (piece([2, 1], [2, 0]), piece([0, 0], [0, 3]), "(0, 1) Unknown"),
        (piece([1, 2], [1, 1]), piece([1, 0], [2, 0]), "(2, 0) Unknown"),
        // Two and more common points.
        (piece([0, 0], [4, 3]), piece([4, 0], [-4, 3]), "(0, 0) Unknown (2, 3/2) Odd"),
        (piece([2, 0], [0, 3]), piece([2, 0], [2, 3]), "(2, 0) Unknown"),
        (piece([0, 0], [3, 0]), piece([2, 0], [2, 0]), "(0, 0) Unknown (2, 0)-(3, 0)"),
    ];
    for (a, b, expected) in rows {
        for [a, b] in [[&a, &b], [&b, &a]] {
            let mut common = Vec::new();
            traits().intersect(a, b, &mut common);
            let one = |common: &Intersection<Point2, TorusSegment>| match common {
                Intersection::Point(p, multiplicity) => format!("{p} {multiplicity:?}"),
                Intersection::Overlap(curve) => {
                    CurveEnd::BOTH.map(|end| curve.place(end).to_string()).join("-")
                }
            };
            let common = common.iter().map(one).collect::<Vec<_>>().join(" ");
            assert_eq!(common, expected, "{a:?} {b:?}");
        }
    }
}

#[test]
fn where_neighbours_meet() {
    let meet = |below: &TorusSegment, above: &TorusSegment, until: Option<&Point2>, first_to_end| {
        traits().next_meeting(below, above, Window { after: None, until, first_to_end })
    };
    let (rising, falling) = (piece([0, 0], [4, 3]), piece([0, 2], [4, -2]));
    let crossing = Point2::from_rationals(&["8/5".parse().unwrap(), "6/5".parse().unwrap()]);
    assert_eq!(meet(&rising, &falling, None, 0), Meeting::At(crossing.clone(), Multiplicity::Odd));
    assert_eq!(meet(&rising, &falling, Some(&crossing), 1), Meeting::AtEnd);
    assert_eq!(meet(&rising, &falling, Some(&point([1, 1])), 1), Meeting::Never);
    // What comes down to the bottom cuts what lies along it.
    let (bottom, down) = (piece([0, 0], [4, 0]), piece([1, 1], [1, -1]));
    assert_eq!(meet(&bottom, &down, None, 1), Meeting::AtEnd);
    // A part of the curve along the bottom may end before.
    assert_eq!(meet(&bottom, &piece([1, 2], [2, -2]), None, 0), Meeting::Never);
}

#[test]
fn parts_keep_their_ends_on_sides() {
    let traits = traits();
    let curve = piece([0, 0], [4, 3]);
    let middle = Point2::from_rationals(&[2.into(), "3/2".parse().unwrap()]);
    let [first, second] = traits.split(&curve, &middle);
    assert_eq!(first.location(CurveEnd::Max), Location::INTERIOR);
    assert_eq!(second.location(CurveEnd::Max), curve.location(CurveEnd::Max));
    assert_eq!(second.point(CurveEnd::Max), &point([0, 0]));
    let merged = traits.merge(&second, &first).unwrap();
    assert_eq!(CurveEnd::BOTH.map(|end| merged.place(end)), CurveEnd::BOTH.map(|end| curve.place(end)));
    // The same point of the torus is both ends.
    let whole = traits.trim(&curve, Some(&point([0, 0])), Some(&point([0, 0])));
    assert_eq!(whole.place(CurveEnd::Max), &point([4, 3]));
    let part = traits.trim(&curve, Some(&middle), Some(&point([0, 0])));
    assert_eq!(CurveEnd::BOTH.map(|end| part.place(end)), [&middle, &point([4, 3])]);
    let mut floats = Vec::new();
    traits.approx_curve(&curve, Some(&middle), Some(&point([0, 0])), [0.0; 4], &mut floats);
    assert_eq!(floats, [[2.0, 1.5], [4.0, 3.0]]);
    // Across a side nothing is merged.
    let (right, left) = (piece([2, 1], [2, 0]), piece([0, 1], [1, 0]));
    assert!(!traits.is_mergeable(&right, &left) && traits.merge(&left, &right).is_none());
}
