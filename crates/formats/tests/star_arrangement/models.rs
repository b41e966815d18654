//! Arrangements made of rows of curves, on all surfaces.

use super::comes_back;
use arrangement::Arrangement;
use arrangement::models::polycurve::PolycurveTraits;
use arrangement::models::{Linear, LinearTraits, TorusSegmentTraits};
use arrangement::topology::{FlatTorus, UnboundedPlane};
use exact::Rational;
use exact::planar::Point2;
use splitstar_formats::{StarArrangement, read_arrangement, write_arrangement};

/// A curve of a test: coordinates in quarters.
#[derive(Clone, Debug)]
pub(crate) enum Row {
    Segment([i64; 4]),
    Ray([i64; 4]),
    Line([i64; 4]),
    Polyline(Vec<[i64; 2]>),
    Point([i64; 2]),
    /// A start and displacements.
    Path([i64; 2], [i64; 2]),
    /// A closed geodesic: a point and windings.
    Closed([i64; 2], [i64; 2]),
}

fn quarter(value: i64) -> Rational {
    Rational::new(value.into(), 4.into()).unwrap()
}

pub(crate) fn point([x, y]: [i64; 2]) -> Point2 {
    Point2::from_rationals(&[quarter(x), quarter(y)])
}

/// A straight curve; `None` if it is a point, or another curve.
pub(crate) fn linear(row: &Row) -> Option<Linear> {
    let ends = |[a, b, c, d]: [i64; 4]| [point([a, b]), point([c, d])];
    match row {
        Row::Segment(row) => {
            let [p, q] = ends(*row);
            Linear::segment(p, q)
        }
        Row::Ray(row) => {
            let [p, q] = ends(*row);
            Linear::ray(p, &q)
        }
        Row::Line(row) => {
            let [p, q] = ends(*row);
            Linear::line(&p, &q)
        }
        _ => None,
    }
}

/// Straight curves and points of the plane.
pub(crate) fn linear_arrangement(rows: &[Row]) -> StarArrangement {
    let curves: Vec<Linear> = rows.iter().filter_map(linear).collect();
    Arrangement::of_curves_and_points(LinearTraits, UnboundedPlane, &curves, points(rows)).into()
}

fn points(rows: &[Row]) -> impl Iterator<Item = Point2> + '_ {
    rows.iter().filter_map(|row| match row {
        Row::Point(p) => Some(point(*p)),
        _ => None,
    })
}

/// Straight curves, polylines and points of the plane.
pub(crate) fn polycurve_arrangement(rows: &[Row]) -> StarArrangement {
    let traits = PolycurveTraits::new(LinearTraits);
    let polycurve = |row: &Row| match row {
        Row::Polyline(points) => Some(traits.make_polyline(points.iter().map(|&p| point(p))).unwrap()),
        row => linear(row).map(|curve| traits.make_polycurve([curve]).unwrap()),
    };
    let curves: Vec<_> = rows.iter().filter_map(polycurve).collect();
    Arrangement::of_curves_and_points(traits, UnboundedPlane, &curves, points(rows)).into()
}

/// Paths and points of a torus, whose periods are integers.
pub(crate) fn torus_arrangement(period: [i64; 2], rows: &[Row]) -> StarArrangement {
    let traits = TorusSegmentTraits::new(period.map(Rational::from)).unwrap();
    let paths = rows.iter().filter_map(|row| match row {
        Row::Path(start, by) => Some(traits.path(&point(*start), &by.map(quarter)).unwrap()),
        Row::Closed(through, winding) => Some(traits.closed_path(&point(*through), *winding).unwrap()),
        Row::Point(p) => Some(traits.path(&point(*p), &[Rational::ZERO, Rational::ZERO]).unwrap()),
        _ => None,
    });
    let paths: Vec<_> = paths.collect();
    Arrangement::of_curves(traits, FlatTorus, &paths).into()
}

/// Paths, polylines and points of a torus.
pub(crate) fn torus_polycurve_arrangement(period: [i64; 2], rows: &[Row]) -> StarArrangement {
    let pieces = TorusSegmentTraits::new(period.map(Rational::from)).unwrap();
    let traits = PolycurveTraits::new(pieces.clone());
    let mut polycurves = Vec::new();
    for row in rows {
        let paths = match row {
            Row::Path(start, by) => vec![pieces.path(&point(*start), &by.map(quarter)).unwrap()],
            Row::Closed(through, winding) => vec![pieces.closed_path(&point(*through), *winding).unwrap()],
            Row::Point(p) => vec![pieces.path(&point(*p), &[Rational::ZERO, Rational::ZERO]).unwrap()],
            Row::Polyline(points) if points.len() > 1 => {
                let path = |pair: &[[i64; 2]]| {
                    let by = [0, 1].map(|i| quarter(pair[1][i] - pair[0][i]));
                    pieces.path(&point(pair[0]), &by).unwrap()
                };
                points.windows(2).map(path).collect()
            }
            _ => continue,
        };
        polycurves.push(traits.make_polycurve_of(&paths).unwrap());
    }
    Arrangement::of_curves(traits, FlatTorus, &polycurves).into()
}

#[test]
fn chains_on_a_torus_come_back() {
    let rows = [
        vec![],
        vec![Row::Polyline(vec![[1, 1], [2, 3], [3, 2], [2, 1], [1, 1]])],
        // Through both seams, and the corner.
        vec![Row::Polyline(vec![[6, 2], [9, 3], [10, 6], [8, 4], [7, 5]])],
        vec![Row::Polyline(vec![[7, 3], [8, 4], [9, 6]]), Row::Polyline(vec![[7, 5], [9, 3]])],
        // Overlaps, from both directions, and a point on them.
        vec![
            Row::Polyline(vec![[1, 1], [3, 1], [5, 3]]),
            Row::Polyline(vec![[6, 2], [4, 2], [3, 1], [2, 1], [1, 2]]),
            Row::Point([2, 1]),
        ],
        vec![Row::Polyline(vec![[5, 0], [5, 3], [6, 3]]), Row::Path([4, 2], [2, 0]), Row::Point([7, 3])],
    ];
    let mut paths = 0;
    for rows in rows {
        let text = comes_back(&torus_polycurve_arrangement([2, 1], &rows));
        paths += text.lines().filter(|line| line.starts_with("curve") && line.split(' ').count() > 7).count();
    }
    assert!(paths > 3, "{paths}");
}

/// Points that are read are ends of curves, or crossings of two, where they can be.
#[test]
fn crossings_are_crossings_again() {
    let rows = [Row::Segment([0, 0, 12, 4]), Row::Segment([0, 4, 12, 1]), Row::Line([4, 0, 5, 7])];
    let StarArrangement::Linear(made) = linear_arrangement(&rows) else { panic!("straight curves") };
    let text = write_arrangement(&made);
    let StarArrangement::Linear(again) = read_arrangement(&text, None).unwrap() else {
        panic!("straight curves")
    };
    let explicit = [&made, &again].map(|arrangement| {
        let points = arrangement.vertices().filter_map(|v| arrangement.point(v));
        points.filter(|point| point.is_explicit()).count()
    });
    assert_eq!((made.counts().vertices, explicit), (7, [4, 4]));
}
