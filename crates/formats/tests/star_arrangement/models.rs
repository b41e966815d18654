//! Arrangements made of rows of curves, on all surfaces.

use arrangement::models::polycurve::PolycurveTraits;
use arrangement::models::{Linear, LinearTraits, TorusSegmentTraits};
use arrangement::topology::{FlatTorus, UnboundedPlane};
use arrangement::traits::{ArrangementTraits, Piece};
use arrangement::{Arrangement, Pieces};
use exact::Rational;
use exact::planar::Point2;
use splitstar_formats::StarArrangement;

/// A curve of a test: coordinates in quarters.
#[derive(Clone, Debug)]
pub enum Row {
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

pub fn point([x, y]: [i64; 2]) -> Point2 {
    Point2::from_rationals(&[quarter(x), quarter(y)])
}

/// A straight curve; `None` if it is a point, or another curve.
pub fn linear(row: &Row) -> Option<Linear> {
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
pub fn linear_arrangement(rows: &[Row]) -> StarArrangement {
    let curves: Vec<Linear> = rows.iter().filter_map(linear).collect();
    let mut pieces = Pieces::of_curves(&LinearTraits, &curves);
    pieces.points.extend(points(rows));
    Arrangement::of_pieces(LinearTraits, UnboundedPlane, pieces).into()
}

fn points(rows: &[Row]) -> impl Iterator<Item = Point2> + '_ {
    rows.iter().filter_map(|row| match row {
        Row::Point(p) => Some(point(*p)),
        _ => None,
    })
}

/// Straight curves, polylines and points of the plane.
pub fn polycurve_arrangement(rows: &[Row]) -> StarArrangement {
    let traits = PolycurveTraits::new(LinearTraits);
    let polycurve = |row: &Row| match row {
        Row::Polyline(points) => Some(traits.make_polyline(points.iter().map(|&p| point(p))).unwrap()),
        row => linear(row).map(|curve| traits.make_polycurve([curve]).unwrap()),
    };
    let curves: Vec<_> = rows.iter().filter_map(polycurve).collect();
    let mut pieces = Pieces::of_curves(&traits, &curves);
    pieces.points.extend(points(rows));
    Arrangement::of_pieces(traits, UnboundedPlane, pieces).into()
}

/// Paths and points of a torus, whose periods are integers.
pub fn torus_arrangement(period: [i64; 2], rows: &[Row]) -> StarArrangement {
    let traits = TorusSegmentTraits::new(period.map(Rational::from)).unwrap();
    let mut pieces = Pieces::default();
    let mut buffer = Vec::new();
    for row in rows {
        let path = match row {
            Row::Path(start, by) => traits.path(&point(*start), &by.map(quarter)),
            Row::Closed(through, winding) => traits.closed_path(&point(*through), *winding),
            Row::Point(p) => traits.path(&point(*p), &[Rational::ZERO, Rational::ZERO]),
            _ => continue,
        };
        traits.make_u_monotone(&path.unwrap(), &mut buffer);
    }
    for piece in buffer {
        match piece {
            Piece::Curve { curve, is_artificial } => {
                pieces.curves.push(curve);
                pieces.is_artificial.push(is_artificial);
            }
            Piece::Point(point) => pieces.points.push(point),
        }
    }
    Arrangement::of_pieces(traits, FlatTorus, pieces).into()
}
