//! Where arrangements of the library are made and asked; `edits` is where they are edited.
//!
//! Every function prepares its operands, does the operation once, and times that alone.

use arrangement::models::polycurve::{Polycurve, PolycurveTraits};
use arrangement::models::{Geodesic, GeodesicTraits, Linear, LinearTraits, Segment, SegmentTraits};
use arrangement::overlay::{Cell, overlay};
use arrangement::topology::{BoundedPlane, Sphere, Topology, UnboundedPlane};
use arrangement::traits::{BasicTraits, UMonotoneTraits};
use arrangement::{Arrangement, locate_all};
use exact::planar::Point2;
use exact::spherical::Direction;

use super::once::{Counts, Found, Located, timed};
use super::task::Curves;
use crate::Failure;

pub(super) type Segments = Arrangement<SegmentTraits, BoundedPlane>;
pub(super) type Arcs = Arrangement<GeodesicTraits, Sphere>;

/// How cells of a surface are counted, so that other programs count the same.
pub(super) trait Surface {
    /// Whether other programs cut curves elsewhere, so that what is cut counts as one.
    const IS_CUT: bool = false;
}

impl Surface for BoundedPlane {}
impl Surface for UnboundedPlane {}
impl Surface for Sphere {
    const IS_CUT: bool = true;
}

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
        Curves::Arcs(ends) => {
            let curves = arcs(ends)?;
            Ok(found(&timed(|| Arrangement::of_curves(GeodesicTraits::new(), Sphere, &curves))))
        }
        Curves::Points(_) | Curves::Directions(_) => Err(NO_CURVES.into()),
    }
}

/// Overlay of the arrangements of both, which are made before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn overlay_of(red: &Curves, blue: &Curves) -> Result<Found, Failure> {
    if let Curves::Arcs(_) = red {
        let (red, blue) = (of_arcs(red)?, of_arcs(blue)?);
        Ok(found(&timed(|| overlay(&red, &blue, &mut ()))))
    } else {
        let (red, blue) = (of_segments(red)?, of_segments(blue)?);
        Ok(found(&timed(|| overlay(&red, &blue, &mut ()))))
    }
}

/// Batched location of points in the arrangement of the curves, which is made before the clock starts.
///
/// # Errors
/// If the library refuses the curves.
pub(super) fn locate(curves: &Curves, points: &Curves) -> Result<Found, Failure> {
    if let Curves::Arcs(_) = curves {
        Ok(locate_in(of_arcs(curves)?, &directions(points)?))
    } else {
        Ok(locate_in(of_segments(curves)?, &planar_points(points)?))
    }
}

fn locate_in<G: UMonotoneTraits, T: Topology<G> + Surface>(
    arrangement: Arrangement<G, T>,
    points: &[G::Point],
) -> Found {
    let (cells, seconds) = timed(|| locate_all(&arrangement, points));
    let located = located(&arrangement, &cells);
    Found { located: Some(located), seconds, ..found(&(arrangement, seconds)) }
}

/// Counts cells, each as often as it is given.
pub(super) fn located<G: BasicTraits, T: Topology<G> + Surface>(
    arrangement: &Arrangement<G, T>,
    cells: &[Cell],
) -> Located {
    let dcel = arrangement.dcel();
    let around = |face| -> usize {
        if T::IS_CUT {
            let halfedges = dcel.face_ccbs(face).flat_map(|ccb| dcel.ccb_cycle(ccb));
            halfedges.filter(|&h| dcel.degree(dcel.target(h)) != 2).count()
        } else {
            dcel.outer_ccbs(face).map(|ccb| dcel.ccb_cycle(ccb).count()).sum()
        }
    };
    let mut located = Located::default();
    for &cell in cells {
        match cell {
            Cell::Vertex(_) => located.vertices += 1,
            Cell::Edge(_) => located.edges += 1,
            Cell::Face(face) => {
                located.faces += 1;
                located.around += around(face);
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

/// The arrangement of arcs.
///
/// # Errors
/// If the library refuses the curves, or they are others.
pub(super) fn of_arcs(curves: &Curves) -> Result<Arcs, Failure> {
    match curves {
        Curves::Arcs(ends) => Ok(Arrangement::of_curves(GeodesicTraits::new(), Sphere, &arcs(ends)?)),
        _ => Err(NO_CURVES.into()),
    }
}

/// The shorter arcs between two directions each.
///
/// # Errors
/// If there are several, or none.
pub(crate) fn arcs(ends: &[[i64; 6]]) -> Result<Vec<Geodesic>, Failure> {
    let arc = |&[a, b, c, d, e, f]: &[i64; 6]| -> Result<Geodesic, Failure> {
        Ok(Geodesic::arc(direction([a, b, c])?, direction([d, e, f])?)?)
    };
    ends.iter().map(arc).collect()
}

/// Points of the sphere.
///
/// # Errors
/// If they are others, or one is zero.
pub(super) fn directions(points: &Curves) -> Result<Vec<Direction>, Failure> {
    let Curves::Directions(points) = points else { return Err(NO_CURVES.into()) };
    points.iter().map(|&point| direction(point)).collect()
}

fn direction(coordinates: [i64; 3]) -> Result<Direction, Failure> {
    Ok(Direction::from_i64(coordinates).ok_or("a direction is zero")?)
}

/// Points of the plane.
///
/// # Errors
/// If they are others.
pub(super) fn planar_points(points: &Curves) -> Result<Vec<Point2>, Failure> {
    let Curves::Points(points) = points else { return Err(NO_CURVES.into()) };
    Ok(points.iter().map(|&point| Point2::from_i64(point)).collect())
}

pub(super) fn segments(ends: &[[i64; 4]]) -> Result<Vec<Segment>, Failure> {
    let segment = |&[a, b, c, d]: &[i64; 4]| Segment::from_i64([[a, b], [c, d]]).ok_or(DEGENERATE);
    Ok(ends.iter().map(segment).collect::<Result<_, _>>()?)
}

pub(super) fn found<G: BasicTraits, T: Topology<G> + Surface>(
    (arrangement, seconds): &(Arrangement<G, T>, f64),
) -> Found {
    let counts = if T::IS_CUT { arrangement.counts() } else { arrangement.counts_with_splits() };
    let counts = Counts { vertices: counts.vertices, edges: counts.edges, faces: counts.faces };
    Found { counts, located: None, seconds: *seconds }
}

const DEGENERATE: &str = "a curve has equal ends";
pub(super) const NO_CURVES: &str = "the operation is not for these curves";
