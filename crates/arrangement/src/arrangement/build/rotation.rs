//! Linking halfedges around a vertex.

use super::WRAP;
use dcel::{Halfedge, HalfedgeId};

/// Links the halfedges that leave a vertex, given counterclockwise, those to the right before those to the left.
///
/// If all are on one side, the corner that passes through the other side is marked, so that the turns of cycles can be counted.
#[inline]
pub(super) fn link(halfedges: &mut [Halfedge], around: &[HalfedgeId]) {
    let (Some(&first), Some(&last)) = (around.first(), around.last()) else { return };
    let mut before = last;
    for &h in around {
        halfedges[h.twin().index()].next = before;
        before = h;
    }
    if first.is_even() == last.is_even() {
        halfedges[last.index()].ccb.0 |= WRAP;
    }
}
