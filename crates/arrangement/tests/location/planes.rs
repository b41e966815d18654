//! The bounded and the unbounded plane, and wide tori, in which all that is bounded looks alike.

use crate::agree::assert_agree;
use crate::curves::{Curve, P, Shape, fraction, rational};
use crate::family::Family;
use crate::models::{Linears, MinimalSegments, Model, Numbered, Polylinears, Polylines, Segments, WideTorus};
use crate::oracle::brute_force;
use crate::rays::Rays;
use crate::rows::rows;
use exact::planar::Point2;
use splitstar_arrangement::Arrangement;
use testkit::Rng;

/// Checks an arrangement, if the model can carry the curves; tells how many answers a scan knew.
fn check(model: &impl Model, curves: &[Curve], rng: &mut Rng, most: usize, context: &str) -> usize {
    let Some(pieces) = model.pieces(curves) else { return 0 };
    let arrangement = Arrangement::of_pieces(model.traits(), model.surface(), pieces);
    let rays = Rays::in_plane(&arrangement, &brute_force(curves));
    let points: Vec<Point2> = rays.points(rng, most).iter().map(Point2::from_rationals).collect();
    let context = format!("{model:?}, {context}: {curves:?}");
    let answers = assert_agree(&arrangement, &points, &context);
    rays.check(&points, &answers, &context)
}

fn run(model: &impl Model, cases: u32, are_bounded: bool) {
    let mut rng = Rng::new(20_261_122);
    let mut known = 0;
    for row in rows() {
        known += check(model, &row.curves, &mut rng, 25, &row.name);
    }
    for _ in 0..cases {
        let seed = rng.state();
        let curves = random_curves(&mut rng, are_bounded);
        known += check(model, &curves, &mut rng, 40, &format!("seed {seed}"));
    }
    assert!(known > 5_000, "{known}");
}

/// Curves of small coordinates, so that everything degenerate happens.
pub(crate) fn random_curves(rng: &mut Rng, are_bounded: bool) -> Vec<Curve> {
    let (range, denominator) = (rng.between(1, 6), if rng.one_in(4) { 2 } else { 1 });
    let shapes: &[Shape] =
        if are_bounded { &[Shape::Segment] } else { &[Shape::Segment, Shape::Ray, Shape::Line] };
    let mut curve = || {
        let [p, q]: [P; 2] =
            [0; 2].map(|_| [0; 2].map(|_| fraction(rng.below(range + 1) as i64, denominator)));
        if p == q || rng.one_in(8) { Curve::Point(p) } else { Curve::Straight(*rng.choose(shapes), [p, q]) }
    };
    (0..10).map(|_| curve()).collect()
}

#[test]
fn segments() {
    run(&Segments, 150, true);
}

#[test]
fn minimal_segments() {
    run(&MinimalSegments, 40, true);
}

#[test]
fn linear_curves() {
    run(&Linears, 150, false);
}

#[test]
fn polylines() {
    run(&Polylines, 60, true);
}

#[test]
fn polycurves_of_linear_curves() {
    run(&Polylinears, 60, false);
}

#[test]
fn segments_with_data() {
    run(&Numbered, 30, true);
}

#[test]
fn empty_planes() {
    let mut rng = Rng::new(1);
    assert!(check(&Segments, &[], &mut rng, 20, "nothing") > 0);
    assert!(check(&Linears, &[], &mut rng, 20, "nothing") > 0);
}

#[test]
fn wide_tori() {
    for (period, shift) in [([100, 90], [0, 0]), ([61, 57], [-3, -2])] {
        let model = WideTorus::new(period, shift.map(rational));
        let mut rng = Rng::new(5);
        for row in rows() {
            let Some(pieces) = model.pieces(&row.curves) else { continue };
            let arrangement = Arrangement::of_pieces(model.traits(), model.surface(), pieces);
            crate::tori::check(&arrangement, &mut rng, 25, &format!("{model:?}, {}", row.name));
        }
    }
}
