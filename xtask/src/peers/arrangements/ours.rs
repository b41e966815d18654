//! Where arrangements of the library are made and asked; `edits` is where they are edited.
//!
//! Every function prepares its operands, does the operation once, and times that alone.

use arrangement::models::polycurve::{Polycurve, PolycurveTraits};
use arrangement::models::{Linear, LinearTraits, Segment, SegmentTraits};
use arrangement::overlay::{Cell, overlay};
use arrangement::topology::{BoundedPlane, Topology, UnboundedPlane};
use arrangement::traits::BasicTraits;
use arrangement::{Arrangement, locate_all};
use exact::planar::Point2;

use super::once::{Counts, Found, Located, timed};
use super::task::Curves;
use crate::Failure;

pub(super) type Segments = Arrangement<SegmentTraits, BoundedPlane>;

/// Aggregated insertion of all curves into an empty arrangement.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn build(curves: &Curves) -> Result<Found, Failure> {
    match curves {
        Curves::Segments(ends) => {
            let curves = segments(ends)?;
            Ok(found(&timed(|| Arrangement::of_curves(SegmentTraits, BoundedPlane, &curves))))
        }
        Curves::Lines(points) => {
            let line = |&[a, b, c, d]: &[i64; 4]| {
                Linear::line(&Point2::from_i64([a, b]), &Point2::from_i64([c, d])).ok_or(DEGENERATE)
            };
            let curves: Vec<Linear> = points.iter().map(line).collect::<Result<_, _>>()?;
            Ok(found(&timed(|| Arrangement::of_curves(LinearTraits, UnboundedPlane, &curves))))
        }
        Curves::Polylines(chains) => {
            let traits = PolycurveTraits::new(SegmentTraits);
            let polyline = |chain: &Vec<[i64; 2]>| {
                traits.make_polyline(chain.iter().map(|&point| Point2::from_i64(point)).collect::<Vec<_>>())
            };
            let curves: Vec<Polycurve<_, _>> = chains.iter().map(polyline).collect::<Result<_, _>>()?;
            Ok(found(&timed(|| Arrangement::of_curves(traits, BoundedPlane, &curves))))
        }
        Curves::Points(_) => Err(NO_CURVES.into()),
    }
}

/// Overlay of the arrangements of both, which are made before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn overlay_of(red: &Curves, blue: &Curves) -> Result<Found, Failure> {
    let (red, blue) = (of_segments(red)?, of_segments(blue)?);
    Ok(found(&timed(|| overlay(&red, &blue, &mut ()))))
}

/// Batched location of points in the arrangement of the curves, which is made before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn locate(curves: &Curves, points: &[[i64; 2]]) -> Result<Found, Failure> {
    let arrangement = of_segments(curves)?;
    let points: Vec<Point2> = points.iter().map(|&point| Point2::from_i64(point)).collect();
    let (cells, seconds) = timed(|| locate_all(&arrangement, &points));
    let located = located(&arrangement, &cells);
    Ok(Found { located: Some(located), seconds, ..found(&(arrangement, seconds)) })
}

/// Counts cells, each as often as it is given.
pub(super) fn located(arrangement: &Segments, cells: &[Cell]) -> Located {
    let mut located = Located::default();
    for &cell in cells {
        match cell {
            Cell::Vertex(_) => located.vertices += 1,
            Cell::Edge(_) => located.edges += 1,
            Cell::Face(face) => {
                located.faces += 1;
                let dcel = arrangement.dcel();
                located.around += dcel.outer_ccbs(face).map(|ccb| dcel.ccb_cycle(ccb).count()).sum::<usize>();
            }
        }
    }
    located
}

/// The arrangement of segments.
///
/// # Errors
/// If the library refuses the curves, or they are others.
pub(super) fn of_segments(curves: &Curves) -> Result<Segments, Failure> {
    match curves {
        Curves::Segments(ends) => Ok(Arrangement::of_curves(SegmentTraits, BoundedPlane, &segments(ends)?)),
        _ => Err(NO_CURVES.into()),
    }
}

pub(super) fn segments(ends: &[[i64; 4]]) -> Result<Vec<Segment>, Failure> {
    let segment = |&[a, b, c, d]: &[i64; 4]| Segment::from_i64([[a, b], [c, d]]).ok_or(DEGENERATE);
    Ok(ends.iter().map(segment).collect::<Result<_, _>>()?)
}

pub(super) fn found<G: BasicTraits, T: Topology<G>>(
    (arrangement, seconds): &(Arrangement<G, T>, f64),
) -> Found {
    let counts = arrangement.counts_with_splits();
    let counts = Counts { vertices: counts.vertices, edges: counts.edges, faces: counts.faces };
    Found { counts, located: None, seconds: *seconds }
}

const DEGENERATE: &str = "a curve has equal ends";
pub(super) const NO_CURVES: &str = "the operation is not for these curves";
