//! Queries that one sweep answers, against brute force: all pairs for meetings, a scan over all cells for location.

use crate::curves::{Curve, P, parse, rational};
use crate::family::Family;
use crate::models::{Linears, MinimalSegments, Model, Numbered, Polylinears, Polylines, Segments, WideTorus};
use crate::oracle::{Cells, EdgeKey, brute_force, ends, has_point, line_of};
use crate::random::random_curves;
use crate::rows::rows;
use crate::scan::Scan;
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::{BasicTraits, CurveEnd, Intersection, UMonotoneTraits};
use splitstar_arrangement::{
    Arrangement, CommonEnds, do_any_meet, intersections, locate_by_sweep, subcurves,
};
use testkit::Rng;

const BOTH: [CommonEnds; 2] = [CommonEnds::Count, CommonEnds::Ignore];

/// The curves through a point that share it, and whether it is given as an intersection.
fn is_given(curves: &[Curve], p: &P, mode: CommonEnds) -> bool {
    let through: Vec<&Curve> = curves.iter().filter(|curve| has_point(curve, p)).collect();
    let ending = through.iter().filter(|curve| ends(curve).contains(p)).count();
    let line = |curve: &Curve| line_of(curve).expect("a curve that does not end here is no point");
    let do_coincide = ending == 0 && through.iter().all(|curve| line(curve) == line(through[0]));
    through.len() > 1 && !do_coincide && (mode == CommonEnds::Count || ending < through.len())
}

/// A point of an edge, not an end of it.
pub(crate) fn sample(([min, max], (slope, offset)): &EdgeKey) -> P {
    let step = match slope {
        Some(slope) => [Rational::ONE, slope.clone()],
        None => [Rational::ZERO, Rational::ONE],
    };
    match (min, max) {
        (Some(min), Some(max)) => {
            let half = rational(2).recip().expect("2 is not zero");
            [0, 1].map(|i| (&min[i] + &max[i]) * &half)
        }
        (Some(min), None) => [0, 1].map(|i| &min[i] + &step[i]),
        (None, Some(max)) => [0, 1].map(|i| &max[i] - &step[i]),
        (None, None) => match slope {
            Some(_) => [Rational::ZERO, offset.clone()],
            None => [offset.clone(), Rational::ZERO],
        },
    }
}

fn do_meet(curves: &[Curve], cells: &Cells, mode: CommonEnds) -> bool {
    let on_edge = |edge: &EdgeKey| {
        let p = sample(edge);
        curves.iter().filter(|curve| line_of(curve).as_ref() == Some(&edge.1) && has_point(curve, &p)).count()
    };
    let at_point = |p: &P| {
        let through = curves.iter().filter(|curve| has_point(curve, p)).count();
        let ending = curves.iter().filter(|curve| ends(curve).contains(p)).count();
        through > 1 && (mode == CommonEnds::Count || ending < through)
    };
    cells.vertices.iter().any(at_point) || cells.edges.iter().any(|edge| on_edge(edge) > 1)
}

fn check_meetings<M: Model>(model: &M, curves: &[Curve], cells: &Cells, context: &str) -> usize {
    let Some((own, points)) = model.own(curves) else { return 0 };
    let (traits, surface) = (model.traits(), model.surface());
    let mut found_points = 0;
    for mode in BOTH {
        let given = cells.vertices.iter().filter(|p| is_given(curves, p, mode));
        let mut expected: Vec<P> = given.map(|p| model.place(p)).collect();
        expected.sort();
        let found: Vec<P> =
            intersections(&traits, &surface, &own, &points, mode).iter().map(Point2::coordinates).collect();
        assert_eq!(found, expected, "{mode:?}, {context}: {curves:?}");
        let found = do_any_meet(&traits, &surface, &own, &points, mode);
        assert_eq!(found, do_meet(curves, cells, mode), "{mode:?}, {context}: {curves:?}");
        found_points += expected.len();
    }
    found_points
}

/// The pieces are the edges that brute force finds, and make the same arrangement. Pieces on a torus are cut at seams besides.
fn check_subcurves<M: Model>(model: &M, curves: &[Curve], cells: &Cells, context: &str) {
    let Some((own, points)) = model.own(curves) else { return };
    let (traits, surface) = (model.traits(), model.surface());
    let parts = subcurves(&traits, &surface, &own, &points);
    check_disjoint(&traits, &parts, context);
    let whole =
        Arrangement::of_pieces(model.traits(), model.surface(), model.pieces(curves).expect("as before"));
    assert_eq!(parts.len(), whole.dcel().edges().count(), "{context}: {curves:?}");
    if surface.sides().is_u_identified() {
        return;
    }
    let ends_of = |part| CurveEnd::BOTH.map(|end| traits.end_point(part, end).map(Point2::coordinates));
    let mut found: Vec<[Option<P>; 2]> = parts.iter().map(ends_of).collect();
    let mut expected: Vec<[Option<P>; 2]> = cells.edges.iter().map(|(ends, _)| ends.clone()).collect();
    found.sort();
    expected.sort();
    assert_eq!(found, expected, "{context}: {curves:?}");
}

/// Two pieces have nothing in common but ends of both.
pub(crate) fn check_disjoint<G: UMonotoneTraits<Point = Point2>>(
    traits: &G,
    parts: &[G::UMonotoneCurve],
    context: &str,
) {
    let is_end =
        |curve, p: &Point2| CurveEnd::BOTH.iter().any(|&end| traits.end_point(curve, end) == Some(p));
    let mut common = Vec::new();
    for (i, a) in parts.iter().enumerate() {
        for b in &parts[..i] {
            traits.intersect(a, b, &mut common);
            for meeting in common.drain(..) {
                match meeting {
                    Intersection::Point(p, _) => {
                        assert!(is_end(a, &p) && is_end(b, &p), "{context}: pieces meet in {p:?}");
                    }
                    Intersection::Overlap(_) => panic!("{context}: pieces overlap"),
                }
            }
        }
    }
}

/// Points of all kinds of cells: vertices, points of edges, points between two of them, and points of a grid.
pub(crate) fn points_of_cells(cells: &Cells, rng: &mut Rng, model: &impl Model) -> Vec<Point2> {
    let mut all: Vec<P> = cells.vertices.iter().cloned().chain(cells.edges.iter().map(sample)).collect();
    let third = rational(3).recip().expect("3 is not zero");
    if !all.is_empty() {
        for _ in 0..60 {
            let [p, q] = [0; 2].map(|_| all[rng.index(all.len())].clone());
            all.push([0, 1].map(|i| &p[i] + (&q[i] - &p[i]) * &third));
        }
    }
    for _ in 0..20 {
        all.push([0; 2].map(|_| Rational::from(rng.within(30)) * &third));
    }
    all.iter().map(|p| Point2::from_rationals(&model.place(p))).collect()
}

fn check_locations<M: Model>(
    model: &M,
    curves: &[Curve],
    cells: &Cells,
    rng: &mut Rng,
    context: &str,
) -> usize {
    let Some(pieces) = model.pieces(curves) else { return 0 };
    let arrangement = Arrangement::of_pieces(model.traits(), model.surface(), pieces);
    let scan = Scan::new(&arrangement, cells, model.period().as_ref());
    let points = points_of_cells(cells, rng, model);
    let mut known = 0;
    for (p, cell) in points.iter().zip(locate_by_sweep(&arrangement, &points)) {
        if let Some(expected) = scan.locate(&p.coordinates()) {
            assert_eq!(cell, expected, "{p:?}, {context}: {curves:?}");
            known += 1;
        }
    }
    known
}

fn run(model: &impl Model, cases: u32, are_bounded: bool) {
    let mut rng = Rng::new(4);
    let (mut meetings, mut located) = (0, 0);
    let mut check = |curves: &[Curve], rng: &mut Rng, context: &str| {
        let cells = brute_force(curves);
        meetings += check_meetings(model, curves, &cells, context);
        check_subcurves(model, curves, &cells, context);
        located += check_locations(model, curves, &cells, rng, context);
    };
    for row in rows() {
        if row.curves.len() < 12 {
            check(&row.curves, &mut rng, &row.name);
        }
    }
    for _ in 0..cases {
        let seed = rng.state();
        let range = rng.between(1, 6);
        let curves = random_curves(&mut rng, 7, range, are_bounded);
        check(&curves, &mut rng, &format!("{model:?}, seed {seed}"));
    }
    assert!(meetings > 300 && located > 5_000, "{meetings}, {located}");
}

test_models! {
    segments: Segments, 300, true;
    minimal_segments: MinimalSegments, 100, true;
    linear_curves: Linears, 300, false;
    polylines: Polylines, 100, true;
    polycurves_of_linear_curves: Polylinears, 100, false;
    segments_with_data: Numbered, 100, true;
}

#[test]
fn torus_with_seams_anywhere() {
    run(&WideTorus::new([61, 57], [rational(-3), rational(-2)]), 150, true);
    run(&WideTorus::new([100, 90], [rational(0), rational(0)]), 100, true);
}

/// Points where curves run together or points are given twice.
#[test]
fn common_ends_are_decided_by_whole_curves() {
    let find = |text: &str| {
        let (own, points) = Linears.own(&parse(text)).expect("all are linear");
        let found = intersections(&Linears.traits(), &Linears.surface(), &own, &points, CommonEnds::Ignore);
        found.iter().map(Point2::coordinates).collect::<Vec<_>>()
    };
    let at = crate::curves::at;
    assert!(find("segment 0 0 1 0, segment 0 0 1 0").is_empty());
    assert_eq!(find("line 4 2 4 4, ray 4 4 4 1, segment 4 3 4 4"), [at(4, 3), at(4, 4)]);
    assert_eq!(find("point 0 0, point 0 0, ray 0 2 0 1"), [at(0, 0)]);
    assert!(find("point 0 0, point 0 0").is_empty());
    assert!(find("line 0 0 1 1, line 2 2 3 3").is_empty());
}
