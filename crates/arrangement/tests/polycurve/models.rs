//! Chains of curves of the models of the crate.

use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::models::polycurve::{ConnectTraits, PolycurveTraits};
use splitstar_arrangement::models::{
    Linear, LinearTraits, MinimalSegmentTraits, SegmentTraits, TorusSegmentTraits,
};
use splitstar_arrangement::topology::{BoundedPlane, FlatTorus, UnboundedPlane};
use splitstar_arrangement::traits::{
    ApproxTraits, BasicTraits, BoundedTraits, CurveEnd, Intersection, Piece, UMonotoneTraits,
};

fn p(u: i64, v: i64) -> Point2 {
    Point2::from_i64([u, v])
}

/// The published measurement of 1,000 such polylines begins with these.
fn counts_of_polylines<S>(pieces: S) -> [usize; 3]
where
    S: ConnectTraits<Point = Point2> + BoundedTraits,
{
    let traits = PolycurveTraits::new(pieces);
    let drawn = testkit::polylines(100, 1);
    let curves: Vec<_> = drawn
        .objects
        .iter()
        .map(|vertices| traits.make_polyline(vertices.iter().map(|&[u, v]| p(u, v))).unwrap())
        .collect();
    let counts = Arrangement::of_curves(traits, BoundedPlane, &curves).counts_with_splits();
    [counts.vertices, counts.edges, counts.faces]
}

#[test]
fn the_model_of_the_segments_does_not_matter() {
    let counts = counts_of_polylines(SegmentTraits);
    assert_eq!(counts_of_polylines(MinimalSegmentTraits), counts);
    let traits = PolycurveTraits::new(LinearTraits);
    let drawn = testkit::polylines(100, 1);
    let curves: Vec<_> = drawn
        .objects
        .iter()
        .map(|vertices| traits.make_polyline(vertices.iter().map(|&[u, v]| p(u, v))).unwrap())
        .collect();
    let linear = Arrangement::of_curves(traits, UnboundedPlane, &curves).counts_with_splits();
    assert_eq!([linear.vertices, linear.edges, linear.faces], counts);
}

#[test]
fn chains_may_be_unbounded() {
    let traits = PolycurveTraits::new(LinearTraits);
    let ray = |from, to: Point2| Linear::ray(from, &to).unwrap();
    let segment = |from, to| Linear::segment(from, to).unwrap();
    // From the upper left, along the axis, to the upper right.
    let bowl = [ray(p(-2, 0), p(-3, 1)), segment(p(-2, 0), p(2, 0)), ray(p(2, 0), p(3, 1))];
    let bowl = traits.make_polycurve(bowl).unwrap();
    let [Piece::Curve { curve: bowl_chain, is_artificial: [false, false] }] = bowl.parts() else {
        panic!("the bowl is one chain")
    };
    assert_eq!(bowl_chain.pieces().len(), 3);
    let hill = [ray(p(-1, 3), p(-2, 2)), segment(p(-1, 3), p(1, 3)), ray(p(1, 3), p(2, 2))];
    let hill = traits.make_polycurve(hill).unwrap();
    let spike = [ray(p(0, 3), p(0, 9)), segment(p(0, 3), p(5, 0))];
    let spike = traits.make_polycurve(spike).unwrap();
    assert_eq!(spike.parts().len(), 2, "the vertical ray is a part of its own");
    let arrangement = Arrangement::of_curves(traits, UnboundedPlane, [&bowl, &hill]);
    let counts = arrangement.counts_with_splits();
    assert_eq!([counts.vertices, counts.edges, counts.faces], [2, 6, 5]);
    let arrangement = Arrangement::of_curves(traits, UnboundedPlane, [&bowl, &hill, &spike]);
    let counts = arrangement.counts_with_splits();
    // The spike begins on the hill, and crosses hill and bowl.
    assert_eq!([counts.vertices, counts.edges, counts.faces], [6, 13, 8]);
    let mut common = Vec::new();
    traits.intersect(bowl_chain, bowl_chain, &mut common);
    let [Intersection::Overlap(whole)] = &common[..] else {
        panic!("a curve is its own overlap: {common:?}")
    };
    assert_eq!(whole.pieces().len(), 3);
    let mut drawn = Vec::new();
    traits.approx_curve(bowl_chain, None, Some(&p(1, 0)), [-10.0, -10.0, 10.0, 10.0], &mut drawn);
    let ends = drawn.iter().map(|[u, v]| [*u as i64, *v as i64]).collect::<Vec<_>>();
    assert_eq!(ends[ends.len() - 2..], [[-2, 0], [1, 0]], "{drawn:?}");
    assert_eq!(drawn.len(), 3, "joints are drawn once: {drawn:?}");
}

/// The line has no end with which the joint on its left could be compared.
#[test]
fn a_vertical_line_is_not_over_before_joints_on_its_left() {
    let traits = PolycurveTraits::new(LinearTraits);
    let upright = traits.make_polycurve([Linear::line(&p(5, 0), &p(5, 6)).unwrap()]).unwrap();
    let roof = traits.make_polyline([p(0, 3), p(2, 5), p(6, 1)]).unwrap();
    for curves in [[&upright, &roof], [&roof, &upright]] {
        let arrangement = Arrangement::of_curves(traits, UnboundedPlane, curves);
        assert_eq!(arrangement.check_valid(), []);
        assert!(arrangement.vertices().any(|v| arrangement.point(v) == Some(&p(5, 2))), "the crossing");
        // Both ends of the roof, and the crossing.
        let counts = arrangement.counts();
        assert_eq!([counts.vertices, counts.edges, counts.faces], [3, 4, 2]);
    }
}

/// A start in the middle of a side, or at a corner that would be none, was an artificial vertex more than other starts give.
#[test]
fn where_a_closed_polyline_begins_does_not_show() {
    let corners = [[0, 0], [4, 0], [8, 0], [9, 3], [8, 6], [4, 7], [0, 6], [0, 3]];
    let traits = PolycurveTraits::new(LinearTraits);
    let stored = (0..corners.len()).map(|start| {
        let mut corners = corners;
        corners.rotate_left(start);
        let polygon = traits.make_polygon(corners.map(|[x, y]| p(x, y))).unwrap();
        assert!(polygon.is_closed());
        let arrangement = Arrangement::of_curves(traits, UnboundedPlane, [&polygon]);
        assert_eq!(arrangement.check_valid(), []);
        arrangement.counts_with_splits()
    });
    // Both ends of the vertical side, and the turn at (9, 3).
    assert!(stored.into_iter().all(|counts| [counts.vertices, counts.edges, counts.faces] == [3, 3, 2]));
}

#[test]
fn chains_on_a_torus_are_cut_at_its_sides() {
    let pieces = TorusSegmentTraits::new([10.into(), 10.into()]).unwrap();
    let traits = PolycurveTraits::new(pieces.clone());
    let by = |u: i64, v: i64| [Rational::from(u), Rational::from(v)];
    // Once round along u, with joints inside and one on the left side.
    let paths = [(p(2, 5), by(3, 2)), (p(5, 7), by(5, -4)), (p(0, 3), by(2, 2))]
        .map(|(start, displacement)| pieces.path(&start, &displacement).unwrap());
    let zigzag = traits.make_polycurve_of(&paths).unwrap();
    assert!(zigzag.is_closed());
    let sizes: Vec<_> = zigzag
        .parts()
        .iter()
        .map(|part| match part {
            Piece::Curve { curve, is_artificial } => (curve.pieces().len(), *is_artificial),
            Piece::Point(_) => panic!("no point is on its own"),
        })
        .collect();
    assert_eq!(sizes, [(3, [true, true])]);
    let upright = pieces.closed_path(&p(7, 0), [0, 1]).unwrap();
    let upright = traits.make_polycurve_of([&upright]).unwrap();
    let level = pieces.closed_path(&p(0, 3), [1, 0]).unwrap();
    let level = traits.make_polycurve_of([&level]).unwrap();
    let counts = |curves: &[&_]| {
        let arrangement = Arrangement::of_curves(traits.clone(), FlatTorus, curves.iter().copied());
        let counts = arrangement.counts();
        [counts.vertices, counts.edges, counts.faces]
    };
    assert_eq!(counts(&[&zigzag]), [1, 1, 1]);
    assert_eq!(counts(&[&zigzag, &upright]), [1, 2, 1]);
    // It touches the zigzag on the left side.
    assert_eq!(counts(&[&zigzag, &level]), [1, 2, 2]);
    let halves = [&paths[..2], &paths[2..]].map(|half| traits.make_polycurve_of(half).unwrap());
    let [Piece::Curve { curve: first, .. }, Piece::Curve { curve: second, .. }] =
        halves.each_ref().map(|half| &half.parts()[0])
    else {
        panic!("two chains")
    };
    let Piece::Curve { curve: line, .. } = &level.parts()[0] else { panic!("a curve") };
    for (a, b) in [(first, second), (first, line), (line, second)] {
        let mut common = Vec::new();
        traits.intersect(a, b, &mut common);
        let has_side = common.iter().any(|c| matches!(c, Intersection::Point(q, _) if *q == p(0, 3)));
        assert!(has_side, "{common:?}");
    }
    // A point on the left is on the right, too.
    assert!(traits.is_on_curve(&p(0, 3), first) && traits.is_in_u_range(&p(0, 3), first));
    assert!(traits.compare_v_at_u(&p(0, 5), first).is_gt());
    assert_eq!(traits.end_point(first, CurveEnd::Max), Some(&p(0, 3)));
}
