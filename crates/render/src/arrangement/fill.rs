//! The rings that enclose a face.

use ::arrangement::Arrangement;
use ::arrangement::topology::Topology;
use ::arrangement::traits::ApproxTraits;
use dcel::{CcbId, FaceId};

use super::outline::Outlines;
use crate::frame::{Frame, Point};

/// At most so many copies of one CCB are made on a torus, along each axis.
const MANY_COPIES: f64 = 100.0;

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
    for ccb in dcel.face_ccbs(f) {
        if is_torus {
            rings.extend(copies(unrolled(arrangement, outlines, ccb)?, &outlines.window));
        } else {
            rings.push(closed_ring(arrangement, outlines, ccb));
        }
    }
    Some(rings)
}

/// A CCB in the plane; where it runs through infinity, it goes on along the window.
fn closed_ring<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    outlines: &Outlines,
    ccb: CcbId,
) -> Vec<Point> {
    let (dcel, window) = (arrangement.dcel(), &outlines.window);
    let mut ring: Vec<Point> = Vec::new();
    let mut is_from_infinity = false;
    for h in dcel.ccb_cycle(ccb) {
        let chain = outlines.along(h);
        let Some(&first) = chain.first() else { continue };
        if arrangement.is_at_infinity(dcel.source(h)) {
            match ring.last() {
                Some(&last) => ring.extend(window.walk_boundary(last, first)),
                None => is_from_infinity = true,
            }
        }
        ring.extend(chain);
    }
    if let (true, Some(&first), Some(&last)) = (is_from_infinity, ring.first(), ring.last()) {
        ring.extend(window.walk_boundary(last, first));
    }
    ring
}

/// A CCB of a torus, unrolled into the plane, so that it does not jump at seams; `None` if it runs around the torus.
fn unrolled<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    outlines: &Outlines,
    ccb: CcbId,
) -> Option<Vec<Point>> {
    let (min, max) = (outlines.window.min(), outlines.window.max());
    let periods = [max[0] - min[0], max[1] - min[1]];
    let mut shift = [0.0; 2];
    let mut ring: Vec<Point> = Vec::new();
    let unroll = |shift: &mut [f64; 2], from: Point, to: Point| {
        for axis in 0..2 {
            if periods[axis] > 0.0 {
                shift[axis] +=
                    ((from[axis] - to[axis] - shift[axis]) / periods[axis]).round() * periods[axis];
            }
        }
    };
    for h in arrangement.dcel().ccb_cycle(ccb) {
        let chain = outlines.along(h);
        if let (Some(&last), Some(&first)) = (ring.last(), chain.first()) {
            unroll(&mut shift, last, first);
        }
        ring.extend(chain.into_iter().map(|point| [point[0] + shift[0], point[1] + shift[1]]));
    }
    let is_closed = match (ring.first(), ring.last()) {
        (Some(first), Some(last)) => {
            (0..2).all(|axis| (first[axis] - last[axis]).abs() <= periods[axis] / 2.0)
        }
        _ => true,
    };
    is_closed.then_some(ring)
}

/// The copies of a ring that meet the rectangle.
fn copies(ring: Vec<Point>, rectangle: &Frame) -> Vec<Vec<Point>> {
    let Some(bounds) = Frame::around(ring.iter().copied()) else { return Vec::new() };
    let range = |axis: usize| {
        let (low, high) = (rectangle.min()[axis], rectangle.max()[axis]);
        let period = high - low;
        if period <= 0.0 {
            return vec![0.0];
        }
        let first = ((low - bounds.max()[axis]) / period).ceil().max(-MANY_COPIES);
        let last = ((high - bounds.min()[axis]) / period).floor().min(MANY_COPIES);
        let mut steps = Vec::new();
        let mut step = first;
        while step <= last {
            steps.push(step * period);
            step += 1.0;
        }
        steps
    };
    let (us, vs) = (range(0), range(1));
    us.iter()
        .flat_map(|&u| vs.iter().map(move |&v| [u, v]))
        .map(|[u, v]| ring.iter().map(|point| [point[0] + u, point[1] + v]).collect())
        .collect()
}
