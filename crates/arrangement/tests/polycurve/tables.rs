//! Cases with known answers.

use super::{Curve, TRAITS, chain, polyline, text};
use crate::rational_segments::{Point, Segment, point, segment};
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::models::polycurve::{Chain, PolycurveError};
use splitstar_arrangement::topology::BoundedPlane;
use splitstar_arrangement::traits::{
    BasicTraits, CurveEnd, DirectionalTraits, Intersection, Meeting, Multiplicity, Piece, UMonotoneTraits,
    Window,
};
use std::cmp::Ordering;

/// The parts of a curve as text: direction, points, and an asterisk at artificial ends.
fn parts(curve: &Curve) -> Vec<String> {
    let star = |is| if is { "*" } else { "" };
    let part = |part: &Piece<Point, Chain<Segment>>| match part {
        Piece::Point(p) => format!("{p:?}"),
        Piece::Curve { curve, is_artificial: [min, max] } => {
            let arrow = if curve.is_directed_right() { ">" } else { "<" };
            format!("{arrow} {}{}{}", star(*min), text(curve), star(*max))
        }
    };
    curve.parts().iter().map(part).collect()
}

#[test]
fn polylines_are_cut_where_they_must_be() {
    let rows: &[(&str, &str, &[&str])] = &[
        ("one segment", "0 0 2 1", &["> (0, 0) (2, 1)"]),
        ("runs to the right", "0 0 2 1 3 0", &["> (0, 0) (2, 1) (3, 0)"]),
        ("runs to the left", "3 0 2 1 0 0", &["< (0, 0) (2, 1) (3, 0)"]),
        ("turns back", "0 0 2 1 1 3", &["> (0, 0) (2, 1)*", "< (1, 3) (2, 1)*"]),
        ("turns twice", "0 0 4 0 1 1 4 2", &["> (0, 0) (4, 0)*", "< *(1, 1) (4, 0)*", "> *(1, 1) (4, 2)"]),
        (
            "a vertical piece",
            "0 0 1 0 1 2 2 2",
            &["> (0, 0) (1, 0)*", "> *(1, 0) (1, 2)*", "> *(1, 2) (2, 2)"],
        ),
        ("a vertical piece down", "0 2 1 2 1 0", &["> (0, 2) (1, 2)*", "< (1, 0) (1, 2)*"]),
        ("vertical pieces in a row", "1 0 1 2 1 3", &["> (1, 0) (1, 2) (1, 3)"]),
        ("a foldback", "0 0 4 0 2 0", &["> (0, 0) (4, 0)", "< (2, 0) (4, 0)"]),
        ("a foldback to the left", "4 0 0 0 6 0", &["< (0, 0) (4, 0)", "> (0, 0) (6, 0)"]),
        ("a vertical foldback", "0 0 0 4 0 1", &["> (0, 0) (0, 4)", "< (0, 1) (0, 4)"]),
        ("there and back", "0 0 1 1 2 0 1 1 0 0", &["> (0, 0) (1, 1) (2, 0)", "< (0, 0) (1, 1) (2, 0)"]),
        ("a triangle", "0 0 4 0 2 2 0 0", &["> *(0, 0) (4, 0)*", "< *(0, 0) (2, 2) (4, 0)*"]),
        (
            "a triangle from a vertex that is not extremal",
            "2 2 0 0 4 0 2 2",
            &["> *(0, 0) (4, 0)*", "< *(0, 0) (2, 2) (4, 0)*"],
        ),
        (
            "a square",
            "0 0 1 0 1 1 0 1 0 0",
            &["> *(0, 0) (1, 0)*", "> *(1, 0) (1, 1)*", "< *(0, 1) (1, 1)*", "< *(0, 0) (0, 1)*"],
        ),
        ("equal vertices", "0 0 0 0 2 1 2 1 3 0 3 0", &["> (0, 0) (2, 1) (3, 0)"]),
        ("a point", "1 2 1 2 1 2", &["(1, 2)"]),
        ("one vertex", "1 2", &["(1, 2)"]),
        ("straight on", "0 0 1 0 2 0", &["> (0, 0) (1, 0) (2, 0)"]),
    ];
    for (name, curve, expected) in rows {
        assert_eq!(&parts(&polyline(curve)), expected, "{name}");
    }
}

#[test]
fn curves_are_put_in_a_row_whatever_way_they_were_given() {
    let a = segment([0, 0], [2, 2]);
    let b = segment([2, 2], [0, 1]);
    let c = segment([0, 1], [5, 1]);
    let traits = TRAITS();
    let made = |curves: &[_]| traits.make_polycurve(curves.to_vec()).map(|curve| parts(&curve));
    let expected = ["> (0, 0) (2, 2)*", "< *(0, 1) (2, 2)*", "> *(0, 1) (5, 1)"].map(String::from).to_vec();
    assert_eq!(made(&[a.clone(), b.clone(), c.clone()]), Ok(expected.clone()));
    assert_eq!(traits.make_polycurve_of(&[a.clone(), b.clone(), c.clone()]).map(|c| parts(&c)), Ok(expected));
    assert_eq!(made(&[]), Err(PolycurveError::Empty));
    assert_eq!(made(&[a.clone(), c.clone()]), Err(PolycurveError::NotConnected { curve: 1 }));
    let far = segment([9, 9], [8, 8]);
    assert_eq!(made(&[a, b, c, far]), Err(PolycurveError::NotConnected { curve: 3 }));
    // The first two have both ends in common: the third tells which way they run.
    let (d, e, f) = (segment([0, 0], [2, 0]), segment([0, 0], [2, 0]), segment([2, 0], [3, 3]));
    let expected = ["< (0, 0) (2, 0)", "> (0, 0) (2, 0) (3, 3)"].map(String::from).to_vec();
    assert_eq!(made(&[d, e, f]), Ok(expected));
    assert_eq!(traits.make_polyline([]).unwrap_err(), PolycurveError::Empty);
    assert_eq!(
        PolycurveError::NotConnected { curve: 3 }.to_string(),
        "curve 3 of the polycurve does not begin where the one before it ends"
    );
}

/// What two chains have in common, as text: `?` marks an unknown multiplicity, `x` a crossing.
fn common(a: &str, b: &str) -> Vec<String> {
    let mut out = Vec::new();
    TRAITS().intersect(&chain(a), &chain(b), &mut out);
    let text = |intersection: &Intersection<Point, Chain<Segment>>| match intersection {
        Intersection::Point(p, Multiplicity::Unknown) => format!("{p:?}?"),
        Intersection::Point(p, Multiplicity::Odd) => format!("{p:?}x"),
        Intersection::Point(p, Multiplicity::Even) => format!("{p:?}="),
        Intersection::Overlap(curve) => text(curve),
    };
    out.iter().map(text).collect()
}

#[test]
fn chains_meet_where_their_pieces_do() {
    let rows: &[(&str, &str, &str, &[&str])] = &[
        ("apart", "0 0 2 1 4 0", "0 5 4 5", &[]),
        ("two crossings", "0 0 2 2 4 0", "0 1 4 1", &["(1, 1)x", "(3, 1)x"]),
        ("touching at a joint", "0 0 2 2 4 0", "0 2 4 2", &["(2, 2)?"]),
        ("touching at joints of both", "0 0 2 2 4 0", "0 4 2 2 4 4", &["(2, 2)?"]),
        ("crossing at joints of both", "0 0 2 2 4 5", "0 4 2 2 4 1", &["(2, 2)?"]),
        ("a joint in common and a crossing", "0 0 2 2 4 0 6 3", "0 4 2 2 6 2", &["(2, 2)?", "(16/3, 2)x"]),
        ("end to end", "0 0 1 1 2 0", "2 0 3 1 4 0", &["(2, 0)?"]),
        ("an end on a joint", "0 0 1 1 2 0", "1 1 2 5", &["(1, 1)?"]),
        ("an end under a joint", "0 0 1 1 2 0", "1 0 2 -5", &[]),
        ("an end inside", "0 0 2 2 4 0", "1 1 1 5", &["(1, 1)?"]),
        ("a vertical through a joint", "0 0 2 2 4 0", "2 0 2 2 2 5", &["(2, 2)?"]),
        ("a vertical through a piece", "0 0 4 4 8 0", "2 0 2 1 2 3 2 5", &["(2, 2)x"]),
        ("a vertical above", "0 0 4 4 8 0", "2 3 2 4", &[]),
        ("verticals that overlap", "2 0 2 3 2 5", "2 1 2 2 2 9", &["(2, 1) (2, 2) (2, 3) (2, 5)"]),
        ("verticals end to end", "2 0 2 3", "2 3 2 4 2 5", &["(2, 3)?"]),
        ("equal", "0 0 2 1 4 0", "0 0 2 1 4 0", &["(0, 0) (2, 1) (4, 0)"]),
        ("equal but for joints", "0 0 2 0 4 0", "0 0 1 0 3 0 4 0", &["(0, 0) (1, 0) (2, 0) (3, 0) (4, 0)"]),
        (
            "an overlap across joints, then apart",
            "0 0 2 2 4 0 6 0",
            "1 1 2 2 3 1 6 9",
            &["(1, 1) (2, 2) (3, 1)"],
        ),
        ("an overlap from joint to joint", "0 5 2 2 4 0 6 3", "0 0 2 2 4 0 6 1", &["(2, 2) (4, 0)"]),
        ("two overlaps", "0 0 2 0 3 2 4 0 6 0", "0 0 2 0 3 -2 4 0 6 0", &["(0, 0) (2, 0)", "(4, 0) (6, 0)"]),
        (
            "crossing, overlap, touching",
            "0 0 2 2 4 2 5 0 6 0 7 1",
            "0 1 1 1 2 0 3 2 4 2 5 3 6 0 7 -1",
            &["(1, 1)?", "(3, 2) (4, 2)", "(6, 0)?"],
        ),
        ("the second begins in the middle", "0 0 1 0 2 0 3 1 4 0 5 0", "3 0 4 1", &["(7/2, 1/2)x"]),
    ];
    for (name, a, b, expected) in rows {
        assert_eq!(&common(a, b), expected, "{name}");
        assert_eq!(&common(b, a), expected, "{name}, exchanged");
    }
}

#[test]
fn predicates_ask_the_piece_at_the_point() {
    let traits = TRAITS();
    let hill = chain("0 0 2 2 4 0 6 0");
    let at = |p| traits.compare_v_at_u(&point(p), &hill);
    assert_eq!([[0, 0], [2, 2], [3, 1], [4, 0], [5, 0], [6, 0]].map(at), [Ordering::Equal; 6]);
    assert_eq!([[0, -1], [2, 1], [3, 0], [4, -1], [6, -5]].map(at), [Ordering::Less; 5]);
    assert_eq!([[0, 1], [2, 3], [3, 2], [4, 1], [6, 5]].map(at), [Ordering::Greater; 5]);
    let pole = chain("1 0 1 2 1 3");
    let at = |p| traits.compare_v_at_u(&point(p), &pole);
    assert_eq!(
        [[1, -1], [1, 0], [1, 1], [1, 2], [1, 3], [1, 4]].map(at).map(|o| o as i8),
        [-1, 0, 0, 0, 0, 1]
    );
    let flat = chain("0 2 2 2 4 0 6 -1");
    assert_eq!(traits.compare_v_at_u_right(&hill, &flat, &point([2, 2])), Ordering::Equal);
    assert_eq!(traits.compare_v_at_u_left(&hill, &flat, &point([2, 2])), Ordering::Less);
    assert_eq!(traits.compare_v_at_u_right(&hill, &flat, &point([4, 0])), Ordering::Greater);
    assert_eq!(traits.compare_v_at_u_left(&hill, &flat, &point([4, 0])), Ordering::Equal);
    assert_eq!(traits.compare_v_at_u_right(&pole, &hill, &point([1, 1])), Ordering::Greater);
    assert_eq!(traits.compare_v_at_u_left(&pole, &hill, &point([1, 1])), Ordering::Less);
    assert!(traits.is_in_u_range(&point([6, 9]), &hill) && !traits.is_in_u_range(&point([7, 0]), &hill));
    assert!(traits.is_on_curve(&point([3, 1]), &hill) && !traits.is_on_curve(&point([3, 2]), &hill));
    assert!(!traits.is_on_curve(&point([-1, 0]), &hill));
}

#[test]
fn the_next_meeting_is_found_across_joints() {
    let traits = TRAITS();
    let (low, high) = (chain("0 0 1 0 2 2 3 0 4 0 5 3 6 0"), chain("0 5 2 2 5 2 7 9"));
    let next = |after: [i64; 2], until: [i64; 2]| {
        let (after, until) = (point(after), point(until));
        traits.next_meeting(&low, &high, Window { after: Some(&after), until: Some(&until), first_to_end: 0 })
    };
    assert_eq!(next([0, 5], [6, 0]), Meeting::At(point([2, 2]), Multiplicity::Unknown));
    let Meeting::At(crossing, Multiplicity::Odd) = next([2, 2], [6, 0]) else { panic!("they cross") };
    assert_eq!(format!("{crossing:?}"), "(14/3, 2)");
    assert_eq!(next([2, 2], [3, 0]), Meeting::Never);
    assert_eq!(next([0, 5], [2, 2]), Meeting::AtEnd);
    assert_eq!(next([0, 5], [1, 0]), Meeting::Never);
}

#[test]
fn splitting_merging_and_trimming() {
    let traits = TRAITS();
    let hill = chain("0 0 2 2 4 0 6 0");
    let halves = |p| traits.split(&hill, &point(p)).map(|half| text(&half));
    assert_eq!(halves([2, 2]), ["(0, 0) (2, 2)", "(2, 2) (4, 0) (6, 0)"]);
    assert_eq!(halves([3, 1]), ["(0, 0) (2, 2) (3, 1)", "(3, 1) (4, 0) (6, 0)"]);
    for p in [[1, 1], [2, 2], [3, 1], [4, 0], [5, 0]] {
        let [lower, upper] = traits.split(&hill, &point(p));
        assert_eq!(traits.end_point(&lower, CurveEnd::Max), Some(&point(p)));
        for (a, b) in [(&lower, &upper), (&upper, &lower)] {
            assert!(traits.is_mergeable(a, b));
            assert_eq!(traits.merge(a, b), Some(hill.clone()), "at {p:?}");
        }
        assert_eq!(traits.merge(&traits.opposite(&lower), &upper), Some(traits.opposite(&hill)));
    }
    assert!(!traits.is_mergeable(&hill, &chain("6 0 6 3")), "a vertical chain follows");
    assert!(!traits.is_mergeable(&hill, &chain("7 0 8 3")), "they do not touch");
    let part = |min: Option<[i64; 2]>, max: Option<[i64; 2]>| {
        text(&traits.trim(&hill, min.map(point).as_ref(), max.map(point).as_ref()))
    };
    assert_eq!(part(None, None), "(0, 0) (2, 2) (4, 0) (6, 0)");
    assert_eq!(part(Some([0, 0]), Some([6, 0])), "(0, 0) (2, 2) (4, 0) (6, 0)");
    assert_eq!(part(Some([2, 2]), Some([4, 0])), "(2, 2) (4, 0)");
    assert_eq!(part(Some([1, 1]), Some([5, 0])), "(1, 1) (2, 2) (4, 0) (5, 0)");
    assert_eq!(part(None, Some([1, 1])), "(0, 0) (1, 1)");
    assert_eq!(part(Some([5, 0]), None), "(5, 0) (6, 0)");
    let back = chain("6 0 4 0 2 2 0 0");
    assert_eq!((traits.source(&back), traits.target(&back)), (Some(&point([6, 0])), Some(&point([0, 0]))));
    assert_eq!(traits.opposite(&back), hill);
    assert!(traits.split(&back, &point([3, 1])).iter().all(|half| !half.is_directed_right()));
}

#[test]
fn arrangements_of_polylines() {
    type Row = (&'static str, &'static [&'static str], [usize; 3], [usize; 3]);
    let rows: &[Row] = &[
        ("open", &["0 0 1 1 2 0"], [2, 1, 1], [2, 1, 1]),
        ("turning", &["0 0 2 0 1 3"], [2, 1, 1], [3, 2, 1]),
        ("triangle", &["0 0 4 0 2 2 0 0"], [1, 1, 2], [2, 2, 2]),
        ("square", &["0 0 1 0 1 1 0 1 0 0"], [1, 1, 2], [4, 4, 2]),
        ("two that cross", &["0 0 2 2 4 0", "0 1 4 1"], [6, 6, 2], [6, 6, 2]),
        ("touching at joints", &["0 0 2 2 4 0", "0 4 2 2 4 4"], [5, 4, 1], [5, 4, 1]),
        ("overlap across joints", &["0 0 2 2 4 0", "1 1 2 2 3 1 5 5"], [5, 4, 1], [5, 4, 1]),
        ("equal", &["0 0 2 2 4 0", "4 0 2 2 0 0"], [2, 1, 1], [2, 1, 1]),
        ("there and back", &["0 0 1 1 2 0 1 1 0 0"], [2, 1, 1], [2, 1, 1]),
        ("a foldback", &["0 0 4 0 2 0 2 5"], [4, 3, 1], [4, 3, 1]),
        ("a point on a joint", &["0 0 2 2 4 0", "2 2"], [3, 2, 1], [3, 2, 1]),
    ];
    for &(name, curves, counts, with_splits) in rows {
        let curves: Vec<Curve> = curves.iter().map(|text| polyline(text)).collect();
        let arrangement = Arrangement::of_curves(TRAITS(), BoundedPlane, &curves);
        assert!(arrangement.check_valid().is_empty(), "{name}");
        let stored = arrangement.counts_with_splits();
        assert_eq!([stored.vertices, stored.edges, stored.faces], with_splits, "{name}, as stored");
        let seen = arrangement.counts();
        assert_eq!([seen.vertices, seen.edges, seen.faces], counts, "{name}");
    }
}
