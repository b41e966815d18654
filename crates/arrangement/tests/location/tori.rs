//! Curves that go round a flat torus.

use crate::agree::assert_agree;
use crate::curves::{P, at, fraction, rational};
use crate::rays::Rays;
use crate::torus_oracle::TorusCurve;
use crate::torus_rows::{period, rows};
use exact::planar::Point2;
use splitstar_arrangement::models::polycurve::PolycurveTraits;
use splitstar_arrangement::models::{TorusPath, TorusSegment, TorusSegmentTraits};
use splitstar_arrangement::topology::FlatTorus;
use splitstar_arrangement::traits::CurveEnd;
use splitstar_arrangement::{Arrangement, Pieces};
use testkit::Rng;

type Torus = Arrangement<TorusSegmentTraits, FlatTorus>;

/// Checks an arrangement; tells how many answers a scan knew.
pub(crate) fn check(arrangement: &Torus, rng: &mut Rng, most: usize, context: &str) -> usize {
    let traits = arrangement.traits();
    let ends = |curve: &TorusSegment| CurveEnd::BOTH.map(|end| curve.place(end).coordinates());
    let rays = Rays::new(arrangement, traits.period().clone(), ends);
    let point = |p: &P| traits.point(&Point2::from_rationals(p));
    let points: Vec<Point2> = rays.points(rng, most).iter().map(point).collect();
    let answers = assert_agree(arrangement, &points, context);
    rays.check(&points, &answers, context)
}

fn make(curves: &[TorusCurve], period: &P) -> Torus {
    let traits = TorusSegmentTraits::new(period.clone()).unwrap();
    let mut points = Vec::new();
    let mut paths: Vec<TorusPath> = Vec::new();
    let place = |p: &P| Point2::from_rationals(p);
    for curve in curves {
        match curve {
            TorusCurve::Point(p) => points.push(traits.point(&place(p))),
            TorusCurve::Path(p, step) => paths.push(traits.path(&place(p), step).unwrap()),
            TorusCurve::Closed(p, winding) => paths.push(traits.closed_path(&place(p), *winding).unwrap()),
        }
    }
    let mut pieces = Pieces::of_curves(&traits, &paths);
    points.into_iter().for_each(|point| pieces.push_point(point));
    Arrangement::of_pieces(traits, FlatTorus, pieces)
}

#[test]
fn rows_of_tori() {
    let mut rng = Rng::new(2);
    let mut known = 0;
    for row in rows() {
        known +=
            check(&make(&row.curves, &period()), &mut rng, 20, &format!("{}: {:?}", row.name, row.curves));
    }
    assert!(known > 10_000, "{known}");
}

fn random_curves(rng: &mut Rng, size: [i64; 2], most: usize) -> Vec<TorusCurve> {
    let denominator = if rng.one_in(4) { 2 } else { 1 };
    let count = rng.index(most + 1);
    let mut curve = || {
        let start = size.map(|length| fraction(rng.below(2 * length as u64) as i64, denominator));
        match rng.below(8) {
            0 | 1 => TorusCurve::Point(start),
            2 => TorusCurve::Closed(start, [0; 2].map(|_| rng.within(2))),
            3 => TorusCurve::Path(start, at(rng.within(7), 0)),
            4 => TorusCurve::Path(start, at(0, rng.within(7))),
            _ => TorusCurve::Path(start, [0; 2].map(|_| fraction(rng.within(7), 2 * denominator))),
        }
    };
    (0..count).map(|_| curve()).collect()
}

const SIZES: [[i64; 2]; 5] = [[1, 1], [2, 3], [4, 3], [5, 5], [12, 9]];

#[test]
fn random_paths_on_tori() {
    let mut rng = Rng::new(20_261_122);
    let mut known = 0;
    for case in 0..400 {
        let seed = rng.state();
        let size = *rng.choose(&SIZES);
        let curves = random_curves(&mut rng, size, 1 + case % 6);
        let arrangement = make(&curves, &size.map(rational));
        let context = format!("seed {seed}, periods {size:?}: {curves:?}");
        known += check(&arrangement, &mut rng, 30, &context);
    }
    assert!(known > 20_000, "{known}");
}

/// Polylines: an edge may have both ends on the bottom and be above it in between.
#[test]
fn random_polylines_on_tori() {
    let mut rng = Rng::new(7);
    for case in 0..200 {
        let seed = rng.state();
        let size = *rng.choose(&SIZES);
        let pieces = TorusSegmentTraits::new(size.map(rational)).unwrap();
        let traits = PolycurveTraits::new(pieces.clone());
        let mut any = |length: i64| rng.below(2 * length as u64 + 1) as i64;
        let mut polyline = || {
            let corners: Vec<[i64; 2]> = (0..2 + any(2)).map(|_| size.map(&mut any)).collect();
            let made = traits.make_cover_polyline(corners.iter().map(|&p| Point2::from_i64(p)));
            made.ok().map(|polyline| (corners, polyline))
        };
        let (corners, curves): (Vec<_>, Vec<_>) = (0..1 + case % 4).filter_map(|_| polyline()).unzip();
        let arrangement = Arrangement::of_curves(traits, FlatTorus, &curves);
        let context = format!("seed {seed}, periods {size:?}: {corners:?}");
        let mut points: Vec<Point2> =
            arrangement.vertices().filter_map(|v| arrangement.point(v).cloned()).collect();
        for _ in 0..40 {
            let [u, v] = [0; 2].map(|_| fraction(rng.below(49) as i64, *rng.choose(&[1, 2, 4])));
            let vertical = points.first().map(|_| rng.choose(&points).coordinates()[0].clone());
            let u = vertical.filter(|_| rng.one_in(3)).unwrap_or(u);
            points.push(pieces.point(&Point2::from_rationals(&[u, v])));
        }
        assert_agree(&arrangement, &points, &context);
    }
}
