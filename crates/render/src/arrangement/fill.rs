//! The rings that enclose a face.

use ::arrangement::Arrangement;
use ::arrangement::topology::Topology;
use ::arrangement::traits::ApproxTraits;
use dcel::{CcbId, FaceId, HalfedgeId};

use super::outline::Outlines;
use super::torus::{self, unroll};
use crate::frame::Point;

/// The rings that enclose a face by the even-odd rule; `None` if it cannot be filled.
pub(super) fn rings<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    outlines: &Outlines,
    f: FaceId,
    is_torus: bool,
) -> Option<Vec<Vec<Point>>> {
    let dcel = arrangement.dcel();
    let mut rings = Vec::new();
    if dcel.outer_ccbs(f).next().is_none() {
        rings.push(outlines.window.corners().to_vec());
    }
    if is_torus {
        let chains = |ccb| dcel.ccb_cycle(ccb).map(|h| outlines.along(h));
        let ccbs = dcel.face_ccbs(f).map(|ccb| unroll(chains(ccb), &outlines.window)).collect();
        rings.extend(torus::rings(ccbs, &outlines.window)?);
    } else {
        rings.extend(dcel.face_ccbs(f).map(|ccb| closed_ring(arrangement, outlines, ccb)));
    }
    Some(rings)
}

/// A CCB in the plane; where it runs through infinity, it goes on along the window: once around, if it comes back by the edge
/// by which it came.
fn closed_ring<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    outlines: &Outlines,
    ccb: CcbId,
) -> Vec<Point> {
    let (dcel, window) = (arrangement.dcel(), &outlines.window);
    let mut ring: Vec<Point> = Vec::new();
    let corners_between = |last: Point, first: Point, h: HalfedgeId| {
        if dcel.prev(h) == h.twin() { window.walk_around(first) } else { window.walk_boundary(last, first) }
    };
    let mut from_infinity = None;
    for h in dcel.ccb_cycle(ccb) {
        let chain = outlines.along(h);
        let Some(&first) = chain.first() else { continue };
        if arrangement.is_at_infinity(dcel.source(h)) {
            match ring.last() {
                Some(&last) => ring.extend(corners_between(last, first, h)),
                None => from_infinity = Some(h),
            }
        }
        ring.extend(chain);
    }
    if let (Some(h), Some(&first), Some(&last)) = (from_infinity, ring.first(), ring.last()) {
        ring.extend(corners_between(last, first, h));
    }
    ring
}
