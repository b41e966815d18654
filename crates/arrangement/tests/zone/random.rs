//! Random curves of small coordinates, so that everything degenerate happens.

use crate::drawn::{self, grid_point};
use crate::oracle::{Seen, check, meets_by_pairs};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::models::polycurve::{Polycurve, PolycurveTraits};
use splitstar_arrangement::models::{
    Linear, LinearTraits, MinimalSegment, MinimalSegmentTraits, Segment, SegmentTraits, TorusPath,
    TorusSegmentTraits,
};
use splitstar_arrangement::topology::{BoundedPlane, FlatTorus, Topology, UnboundedPlane};
use splitstar_arrangement::traits::ArrangementTraits;
use splitstar_arrangement::wrappers::{ConsolidatedTraits, DataSet, WithData};
use splitstar_arrangement::{Arrangement, Editor};
use std::fmt::Debug;
use testkit::Rng;

/// Makes arrangements, half of them by insertions one by one, and looks for the zones of other curves.
fn run<G: ArrangementTraits<Point = Point2, Curve: Debug> + Clone, T: Topology<G>>(
    (traits, topology): (&G, &T),
    cases: u32,
    is_plane: bool,
    mut draw: impl FnMut(&mut Rng, i64) -> Option<G::Curve>,
    mut point: impl FnMut(&mut Rng, i64) -> Point2,
) -> Seen {
    let mut rng = Rng::new(20_261_122);
    let mut seen = Seen::default();
    for case in 0..cases {
        let seed = rng.state();
        let range = rng.between(1, 6) as i64;
        let most = [4, 8, 12][rng.index(3)];
        let count = rng.index(most);
        let curves: Vec<G::Curve> = (0..count).filter_map(|_| draw(&mut rng, range)).collect();
        let points: Vec<Point2> = (0..rng.index(3)).map(|_| point(&mut rng, range)).collect();
        let (traits, topology) = (traits.clone(), topology.clone());
        let editor = if case % 2 == 0 {
            let points = points.iter().cloned();
            Editor::new(Arrangement::of_curves_and_points(traits, topology, &curves, points))
        } else {
            let mut editor = Editor::new(Arrangement::new(traits, topology));
            for point in &points {
                editor.insert_point(point);
            }
            for curve in &curves {
                editor.insert_curve(curve);
            }
            editor
        };
        for _ in 0..3 {
            let Some(curve) = draw(&mut rng, range) else { continue };
            let context = format!("seed {seed}, {curve:?} in {curves:?}, {points:?}");
            check(&editor, &curve, &mut seen, &context);
            if is_plane {
                let found = [editor.meets_anything(&curve), editor.interior_meets_anything(&curve)];
                assert_eq!(found, meets_by_pairs(&editor, &curve), "{context}");
            }
        }
    }
    let [least, many] = [cases as usize / 50, cases as usize / 5];
    assert!(seen.pieces > 2 * cases as usize && seen.vertices > many && seen.crossings > many, "{seen:?}");
    assert!(seen.overlaps > least && seen.partial > least, "{seen:?}");
    assert!(seen.meets.iter().chain(&seen.interior_meets).all(|&count| count > least), "{seen:?}");
    seen
}

fn at(rng: &mut Rng, range: i64) -> Point2 {
    grid_point(rng, range as u64 + 1)
}

fn segment(rng: &mut Rng, range: i64) -> Option<Segment> {
    Segment::new(at(rng, range), at(rng, range))
}

fn linear(rng: &mut Rng, range: i64) -> Option<Linear> {
    let ends = [at(rng, range), at(rng, range)];
    drawn::linear(rng, ends)
}

#[test]
fn segments() {
    run((&SegmentTraits, &BoundedPlane), 600, true, segment, at);
}

#[test]
fn minimal_segments() {
    let draw = |rng: &mut Rng, range| MinimalSegment::new(at(rng, range), at(rng, range));
    run((&MinimalSegmentTraits, &BoundedPlane), 200, true, draw, at);
}

#[test]
fn linear_curves() {
    run((&LinearTraits, &UnboundedPlane), 600, true, linear, at);
}

#[test]
fn segments_with_data() {
    let mut number = 0;
    let draw = |rng: &mut Rng, range| {
        number += 1;
        Some(WithData::new(segment(rng, range)?, DataSet::single(number)))
    };
    let traits = ConsolidatedTraits::<SegmentTraits, u32>::consolidated(SegmentTraits);
    run((&traits, &BoundedPlane), 200, true, draw, at);
}

#[test]
fn polylines() {
    let traits = PolycurveTraits::new(SegmentTraits);
    let draw = |rng: &mut Rng, range| -> Option<Polycurve<Point2, Segment>> {
        let count = rng.between(2, 6);
        let vertices: Vec<Point2> = (0..count).map(|_| at(rng, range)).collect();
        traits.make_polyline(vertices).ok()
    };
    let seen = run((&traits, &BoundedPlane), 600, true, draw, at);
    assert!(seen.touches > 20, "{seen:?}");
}

#[test]
fn polycurves_of_linear_curves() {
    let traits = PolycurveTraits::new(LinearTraits);
    let draw = |rng: &mut Rng, range| {
        let middle = at(rng, range);
        let mut piece = |is_ray: bool| {
            let other = at(rng, range);
            if is_ray { Linear::ray(middle.clone(), &other) } else { Linear::segment(middle.clone(), other) }
        };
        let pieces = [piece(true)?, piece(false)?];
        traits.make_polycurve(pieces).ok()
    };
    let seen = run((&traits, &UnboundedPlane), 400, true, draw, at);
    assert!(seen.touches > 5, "{seen:?}");
}

fn torus_path(traits: &TorusSegmentTraits, rng: &mut Rng, range: i64) -> Option<TorusPath> {
    let start = at(rng, range + 3);
    let third = Rational::from(3).recip().unwrap();
    let start = Point2::from_rationals(&start.coordinates().map(|x| x * &third));
    if rng.one_in(5) {
        return traits.closed_path(&start, [0; 2].map(|_| rng.within(2))).ok();
    }
    let mut way = [0; 2].map(|_| Rational::from(rng.within(2 * range + 1)) * &third);
    if rng.one_in(4) {
        way[rng.index(2)] = Rational::ZERO;
    }
    traits.path(&start, &way).ok()
}

#[test]
fn paths_on_tori() {
    for period in [[1, 1], [2, 3], [4, 4]] {
        let traits = TorusSegmentTraits::new(period.map(Rational::from)).unwrap();
        let draw = |rng: &mut Rng, range| torus_path(&traits, rng, range);
        let point = |rng: &mut Rng, range| traits.point(&at(rng, range));
        run((&traits, &FlatTorus), 200, false, draw, point);
    }
}
