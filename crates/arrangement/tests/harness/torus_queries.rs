//! Queries about curves that go round a torus.

use crate::curves::{P, at, fraction, rational};
use crate::oracle::brute_force as plane_cells;
use crate::queries::check_disjoint;
use crate::scan::Scan;
use crate::torus::{own, random_curves, sweep};
use crate::torus_oracle::{TorusCurve, brute_force, meetings};
use crate::torus_rows::{period, rows};
use exact::planar::Point2;
use splitstar_arrangement::models::TorusSegmentTraits;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::FlatTorus;
use splitstar_arrangement::traits::{BasicTraits, CurveEnd};
use splitstar_arrangement::{CommonEnds, do_any_meet, intersections, locate_by_sweep, subcurves};
use testkit::Rng;

const BOTH: [CommonEnds; 2] = [CommonEnds::Count, CommonEnds::Ignore];

fn torus(period: &P) -> TorusSegmentTraits {
    TorusSegmentTraits::new(period.clone()).expect("the periods are positive")
}

fn find(curves: &[TorusCurve], period: &P, mode: CommonEnds) -> Vec<P> {
    let traits = torus(period);
    let (paths, points) = own(&traits, curves);
    let found = intersections(&traits, &FlatTorus, &paths, &points, mode);
    found.iter().map(Point2::coordinates).collect()
}

fn do_meet(curves: &[TorusCurve], period: &P, mode: CommonEnds) -> bool {
    let traits = torus(period);
    let (paths, points) = own(&traits, curves);
    do_any_meet(&traits, &FlatTorus, &paths, &points, mode)
}

fn check(curves: &[TorusCurve], period: &P, rng: &mut Rng, context: &str) -> [usize; 2] {
    let (mut met, mut known) = (0, 0);
    for mode in BOTH {
        let (given, meet) = meetings(curves, period, mode == CommonEnds::Count);
        assert_eq!(find(curves, period, mode), given, "{mode:?}, {context}: {curves:?}");
        assert_eq!(do_meet(curves, period, mode), meet, "{mode:?}, {context}: {curves:?}");
        met += given.len();
    }
    let traits = torus(period);
    let arrangement = sweep(curves, period);
    let (paths, points) = own(&traits, curves);
    let parts = subcurves(&traits, &FlatTorus, &paths, &points);
    check_disjoint(&traits, &parts, context);
    let ends = |curve: &_| CurveEnd::BOTH.map(|end| traits.end_point(curve, end).map(Point2::coordinates));
    let mut found: Vec<_> = parts.iter().map(ends).collect();
    let mut expected: Vec<_> =
        arrangement.dcel().edges().map(|e| ends(&arrangement.make_edge_curve(e))).collect();
    found.sort();
    expected.sort();
    assert_eq!(found, expected, "{context}: {curves:?}");
    let scan = Scan::new(&arrangement, &plane_cells(&[]), Some(period));
    let vertices = brute_force(curves, period).vertices;
    let mut places: Vec<P> = vertices.into_iter().chain(scan.edge_samples().map(|(_, p)| p)).collect();
    for parts in [4, 60].repeat(40) {
        places.push([0, 1].map(|i| &period[i] * fraction(rng.below(parts) as i64, parts as i64)));
    }
    let points: Vec<Point2> = places.iter().map(Point2::from_rationals).collect();
    for (place, cell) in places.iter().zip(locate_by_sweep(&arrangement, &points)) {
        if let Some(expected) = scan.locate(place) {
            assert_eq!(cell, expected, "{place:?}, {context}: {curves:?}");
            known += 1;
        }
    }
    [met, known]
}

#[test]
fn rows_and_random_curves() {
    let mut rng = Rng::new(41);
    let (mut met, mut known) = (0, 0);
    let mut count = |[m, k]: [usize; 2]| {
        met += m;
        known += k;
    };
    for row in rows() {
        count(check(&row.curves, &period(), &mut rng, row.name));
    }
    for case in 0..600 {
        let size = [[1, 1], [2, 3], [4, 3], [5, 5]][rng.index(4)];
        let context = format!("case {case}, periods {size:?}, seed {}", rng.state());
        let curves = random_curves(&mut rng, size, 4);
        count(check(&curves, &size.map(rational), &mut rng, &context));
    }
    assert!(met > 1_000 && known > 20_000, "{met}, {known}");
}

fn path(x: i64, y: i64, dx: i64, dy: i64) -> TorusCurve {
    TorusCurve::Path(at(x, y), at(dx, dy))
}

fn closed(x: i64, y: i64, winding: [i64; 2]) -> TorusCurve {
    TorusCurve::Closed(at(x, y), winding)
}

#[test]
fn vertices_to_which_edges_come_only_from_the_top_or_the_right() {
    for (size, curve, p) in [(3, path(2, 0, 0, -1), at(2, 0)), (4, path(0, 0, -1, -1), at(0, 0))] {
        let arrangement = sweep(&[curve], &at(size, size));
        let cells = locate_by_sweep(&arrangement, &[Point2::from_rationals(&p)]);
        let [Cell::Vertex(v)] = cells[..] else { panic!("{cells:?}") };
        assert_eq!(arrangement.point(v).map(Point2::coordinates), Some(p));
    }
}

#[test]
fn places_of_one_point_are_taken_together() {
    let rows = [
        (vec![path(1, 1, 3, 0), path(0, 1, 1, 1)], at(0, 1), true),
        (vec![path(1, 1, 0, 3), path(1, 0, 1, 1)], at(1, 0), true),
        (vec![path(3, 3, 2, 2), path(3, 1, 2, -2)], at(0, 0), false),
        (vec![path(0, 0, 0, 3), path(2, 1, 2, 0)], at(0, 1), false),
        (vec![path(3, 1, 2, 0), path(3, 0, 2, 2)], at(0, 1), false),
    ];
    for (curves, p, are_all_ends) in rows {
        let period = at(4, 4);
        let count = find(&curves, &period, CommonEnds::Count);
        assert_eq!(count.iter().filter(|q| **q == p).count(), 1, "{curves:?}: {count:?}");
        let ignore = find(&curves, &period, CommonEnds::Ignore);
        assert_eq!(ignore.contains(&p), !are_all_ends, "{curves:?}: {ignore:?}");
        assert!(do_meet(&curves, &period, CommonEnds::Count), "{curves:?}");
        assert_eq!(do_meet(&curves, &period, CommonEnds::Ignore), !ignore.is_empty(), "{curves:?}");
    }
}

#[test]
fn curves_along_a_seam_are_cut() {
    let traits = torus(&at(4, 4));
    let (paths, _) = own(&traits, &[closed(0, 0, [0, 1]), closed(0, 1, [1, 0])]);
    let parts = subcurves(&traits, &FlatTorus, &paths, &[]);
    let mut places: Vec<[P; 2]> =
        parts.iter().map(|part| CurveEnd::BOTH.map(|end| part.place(end).coordinates())).collect();
    places.sort();
    assert_eq!(places, [[at(0, 0), at(0, 1)], [at(0, 1), at(0, 4)], [at(0, 1), at(4, 1)]]);
}
