//! Cycles of halfedges become CCBs.

use super::WRAP;
use dcel::{CcbId, CcbKind, Dcel, FaceId, Halfedge, HalfedgeId, RawCcb, RawDcel, VertexId};

/// What the cells are made of.
pub(super) struct Raw<'f> {
    /// With labels in place of CCBs.
    pub(super) halfedges: Vec<Halfedge>,
    pub(super) outgoing: Vec<HalfedgeId>,
    pub(super) isolated: Vec<(VertexId, FaceId)>,
    /// The face of each label.
    pub(super) faces: &'f [u32],
    pub(super) face_count: usize,
    /// How many vertices stand for sides of the parameter space; they come first.
    pub(super) special: usize,
}

/// Traces the cycles, and makes the structure. `kind` gives the kind of a CCB that turns so often.
pub(super) fn assemble(raw: Raw<'_>, kind: impl Fn(i64) -> CcbKind) -> Dcel {
    let Raw { mut halfedges, outgoing, isolated, faces, face_count, special } = raw;
    let mut ccbs: Vec<RawCcb> = Vec::with_capacity(face_count);
    let mut is_traced = vec![0_u64; halfedges.len().div_ceil(64)];
    for start in 0..halfedges.len() {
        if is_traced[start / 64] >> (start % 64) & 1 == 1 {
            continue;
        }
        let first = HalfedgeId::new(start);
        let ccb = CcbId::new(ccbs.len());
        let face = FaceId(faces[(halfedges[start].ccb.0 & !WRAP) as usize]);
        let (mut h, mut half_turns, mut is_special) = (first, 0_i64, false);
        loop {
            let i = h.index();
            is_traced[i / 64] |= 1 << (i % 64);
            let halfedge = &mut halfedges[i];
            let is_wrap = halfedge.ccb.0 & WRAP != 0;
            debug_assert_eq!(face.0, faces[(halfedge.ccb.0 & !WRAP) as usize], "a cycle bounds one face");
            halfedge.ccb = ccb;
            is_special |= halfedge.source.index() < special;
            let next = halfedge.next;
            // The turn between the halfedge before h and h is noted at h, but the direction of the one before is known only
            // at the step before: so half turns are counted there, and wraps here.
            if next.is_even() != h.is_even() {
                half_turns += 1;
            }
            if is_wrap {
                half_turns -= 2;
            }
            h = next;
            if h == first {
                break;
            }
        }
        debug_assert!(is_special || matches!(half_turns, -2 | 0 | 2), "a CCB turns once or not at all");
        // How a cycle turns at a vertex without a point is not known, and does not matter.
        let kind = if is_special { CcbKind::Outer } else { kind(half_turns / 2) };
        ccbs.push(RawCcb { first, face, kind });
    }
    Dcel::from_parts(RawDcel { halfedges, outgoing, ccbs, face_count, isolated })
}
