//! The one place where arrangements of the library are called.
//!
//! Every function prepares its operands, does the operation once, and times that alone.

use arrangement::models::polycurve::{Polycurve, PolycurveTraits};
use arrangement::models::{Linear, LinearTraits, Segment, SegmentTraits};
use arrangement::overlay::{Cell, overlay};
use arrangement::topology::{BoundedPlane, Topology, UnboundedPlane};
use arrangement::traits::BasicTraits;
use arrangement::{Arrangement, Editor, locate_all};
use exact::planar::Point2;

use super::once::{Counts, Found, Located, timed};
use super::task::Curves;
use crate::Failure;

type Segments = Arrangement<SegmentTraits, BoundedPlane>;

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

/// Insertion of all curves one by one into an empty arrangement.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn insert(curves: &Curves) -> Result<Found, Failure> {
    let Curves::Segments(ends) = curves else { return Err(NO_CURVES.into()) };
    let curves = segments(ends)?;
    let (editor, seconds) = timed(|| {
        let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
        for curve in &curves {
            editor.insert_curve(curve);
        }
        editor
    });
    Ok(found(&(editor.finish().0, seconds)))
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
    let mut located = Located::default();
    for cell in cells {
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
    Ok(Found { located: Some(located), seconds, ..found(&(arrangement, seconds)) })
}

fn of_segments(curves: &Curves) -> Result<Segments, Failure> {
    match curves {
        Curves::Segments(ends) => Ok(Arrangement::of_curves(SegmentTraits, BoundedPlane, &segments(ends)?)),
        _ => Err(NO_CURVES.into()),
    }
}

fn segments(ends: &[[i64; 4]]) -> Result<Vec<Segment>, Failure> {
    let segment = |&[a, b, c, d]: &[i64; 4]| Segment::from_i64([[a, b], [c, d]]).ok_or(DEGENERATE);
    Ok(ends.iter().map(segment).collect::<Result<_, _>>()?)
}

fn found<G: BasicTraits, T: Topology<G>>((arrangement, seconds): &(Arrangement<G, T>, f64)) -> Found {
    let counts = arrangement.counts_with_splits();
    let counts = Counts { vertices: counts.vertices, edges: counts.edges, faces: counts.faces };
    Found { counts, located: None, seconds: *seconds }
}

const DEGENERATE: &str = "a curve has equal ends";
const NO_CURVES: &str = "the operation is not for these curves";
