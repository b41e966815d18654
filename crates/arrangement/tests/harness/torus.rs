//! Curves that go round a flat torus.

use crate::curves::{P, at, fraction, rational};
use crate::torus_oracle::{TorusCells, TorusCurve, brute_force, reduce};
use crate::torus_rows::{period, rows};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::models::{TorusPath, TorusSegmentTraits};
use splitstar_arrangement::overlay::overlay_all;
use splitstar_arrangement::topology::FlatTorus;
use splitstar_arrangement::{Arrangement, Counts, Pieces};
use testkit::Rng;

pub(crate) type Torus = Arrangement<TorusSegmentTraits, FlatTorus>;

/// The curves as paths, and the points.
pub(crate) fn own(traits: &TorusSegmentTraits, curves: &[TorusCurve]) -> (Vec<TorusPath>, Vec<Point2>) {
    let mut points = Vec::new();
    let mut paths: Vec<TorusPath> = Vec::new();
    let place = |p: &P| Point2::from_rationals(p);
    for curve in curves {
        match curve {
            TorusCurve::Point(p) => points.push(traits.point(&place(p))),
            TorusCurve::Path(p, step) => paths.push(traits.path(&place(p), step).expect("the path is short")),
            TorusCurve::Closed(p, winding) => {
                paths.push(traits.closed_path(&place(p), *winding).expect("the path is short"));
            }
        }
    }
    (paths, points)
}

pub(crate) fn pieces(traits: &TorusSegmentTraits, curves: &[TorusCurve]) -> Pieces<TorusSegmentTraits> {
    let (paths, points) = own(traits, curves);
    let mut pieces = Pieces::of_curves(traits, &paths);
    points.into_iter().for_each(|point| pieces.push_point(point));
    pieces
}

pub(crate) fn sweep(curves: &[TorusCurve], period: &P) -> Torus {
    let traits = TorusSegmentTraits::new(period.clone()).expect("the periods are positive");
    let pieces = pieces(&traits, curves);
    Arrangement::of_pieces(traits, FlatTorus, pieces)
}

/// By every route: in one sweep, in two halves, one by one, as an overlay of two and of three.
fn routes(curves: &[TorusCurve], period: &P, rng: &mut Rng) -> Vec<(&'static str, Torus)> {
    let traits = TorusSegmentTraits::new(period.clone()).expect("the periods are positive");
    let mut parts = [const { Vec::new() }; 3];
    for curve in curves {
        parts[rng.index(3)].push(curve.clone());
    }
    let rest: Vec<TorusCurve> = parts[1..].concat();
    let [a, b, c, bc] = [&parts[0], &parts[1], &parts[2], &rest].map(|part| sweep(part, period));
    let mut halves = a.clone();
    halves.insert_pieces(pieces(&traits, &rest));
    let mut one_by_one = Arrangement::new(traits.clone(), FlatTorus);
    for curve in curves {
        one_by_one.insert_pieces(pieces(&traits, std::slice::from_ref(curve)));
    }
    vec![
        ("a sweep", sweep(curves, period)),
        ("halves", halves),
        ("one by one", one_by_one),
        ("an overlay of two", overlay_all(&[&a, &bc]).0),
        ("an overlay of three", overlay_all(&[&a, &b, &c]).0),
    ]
}

fn check(curves: &[TorusCurve], period: &P, cells: &TorusCells, context: &str, rng: &mut Rng) {
    let seed = rng.state();
    let made = routes(curves, period, rng);
    for (route, arrangement) in &made {
        let context = || format!("{route}, {context}, seed {seed}: {curves:?}");
        let violations = arrangement.check_valid();
        assert!(violations.is_empty(), "{violations:?}, {}", context());
        assert_eq!(arrangement.counts(), cells.counts, "{}", context());
        let view = arrangement.user_view();
        let real = view.vertices().filter(|&v| !arrangement.is_artificial(v));
        let vertices = real.filter_map(|v| arrangement.point(v).map(Point2::coordinates)).collect();
        assert_eq!(cells.vertices, vertices, "{}", context());
        let difference = made[0].1.difference(arrangement);
        assert!(difference.is_none(), "{difference:?}, {}", context());
    }
}

#[test]
fn rows_by_every_route() {
    let rows = rows();
    assert!(rows.len() > 300, "there are rows");
    let mut rng = Rng::new(2);
    for row in rows {
        let [vertices, edges, faces, isolated, components] = row.counts;
        let counts = Counts { vertices, edges, faces, isolated, components };
        let cells = brute_force(&row.curves, &period());
        assert_eq!(cells.counts, counts, "brute force: {} {:?}", row.name, row.curves);
        check(&row.curves, &period(), &cells, row.name, &mut rng);
    }
}

pub(crate) fn random_curves(rng: &mut Rng, period: [i64; 2], most: usize) -> Vec<TorusCurve> {
    let denominator = if rng.one_in(4) { 2 } else { 1 };
    let count = rng.index(most + 1);
    let mut curve = || {
        let [x, y] = period.map(|length| fraction(rng.below(2 * length as u64) as i64, denominator));
        let start = [x, y];
        match rng.below(8) {
            0 => TorusCurve::Point(start),
            1..3 => TorusCurve::Closed(start, [0; 2].map(|_| rng.within(2))),
            3 => TorusCurve::Path(start, at(rng.within(7), 0)),
            4 => TorusCurve::Path(start, at(0, rng.within(7))),
            _ => TorusCurve::Path(start, [0; 2].map(|_| fraction(rng.within(7), denominator))),
        }
    };
    (0..count).map(|_| curve()).collect()
}

#[test]
fn random_curves_by_every_route() {
    let mut rng = Rng::new(20_261_122);
    let mut faces = 0;
    for case in 0..1500 {
        let size = [[1, 1], [2, 3], [4, 3], [5, 5]][rng.index(4)];
        let period = size.map(rational);
        let curves = random_curves(&mut rng, size, 1 + case % 5);
        let cells = brute_force(&curves, &period);
        faces += cells.counts.faces;
        check(&curves, &period, &cells, &format!("case {case}, periods {size:?}"), &mut rng);
    }
    assert!(faces > 3_000, "{faces}");
}

/// The seam is nowhere: a translation of all that is drawn, and a rotation of the torus, change nothing.
#[test]
fn seams_do_not_matter() {
    let mut rng = Rng::new(8);
    for _ in 0..400 {
        let seed = rng.state();
        let size = [[2, 3], [4, 3]][rng.index(2)];
        let period = size.map(rational);
        let curves = random_curves(&mut rng, size, 4);
        let arrangement = sweep(&curves, &period);
        let by: P = [0; 2].map(|_| fraction(rng.within(12), [1, 2, 3, 7][rng.index(4)]));
        let translate = |[x, y]: &P| [x + &by[0], y + &by[1]];
        let rotate = |[x, y]: &P| [-y, x.clone()];
        let moved: Vec<TorusCurve> =
            curves.iter().map(|curve| map(curve, translate, P::clone, |w| w)).collect();
        let turned: Vec<TorusCurve> =
            curves.iter().map(|curve| map(curve, rotate, rotate, |[p, q]| [-q, p])).collect();
        let swapped: P = [period[1].clone(), period[0].clone()];
        let image = sweep(&moved, &period);
        let of_point = |p: &Point2| Point2::from_rationals(&reduce(&translate(&p.coordinates()), &period).0);
        assert!(
            arrangement.is_isomorphic_under(&image, of_point, false),
            "seed {seed}, by {by:?}: {curves:?}"
        );
        let image = sweep(&turned, &swapped);
        let of_point = |p: &Point2| Point2::from_rationals(&reduce(&rotate(&p.coordinates()), &swapped).0);
        assert!(arrangement.is_isomorphic_under(&image, of_point, false), "seed {seed}, turned: {curves:?}");
    }
}

fn map(
    curve: &TorusCurve,
    point: impl Fn(&P) -> P,
    vector: impl Fn(&P) -> P,
    winding: impl Fn([i64; 2]) -> [i64; 2],
) -> TorusCurve {
    match curve {
        TorusCurve::Point(p) => TorusCurve::Point(point(p)),
        TorusCurve::Path(p, step) => TorusCurve::Path(point(p), vector(step)),
        TorusCurve::Closed(p, w) => TorusCurve::Closed(point(p), winding(*w)),
    }
}

#[test]
fn zero_is_zero() {
    assert_eq!(reduce(&at(-1, 25), &period()).0, at(11, 5));
    assert_eq!(reduce(&at(0, 10), &period()).1, [Rational::ZERO, Rational::ONE]);
}
