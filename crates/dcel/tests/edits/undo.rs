//! The inverse of removing an edge, and what tells whether two structures are the same.

use splitstar_dcel::{
    CcbId, CcbKind, CcbSplit, Dcel, EdgeId, EndFate, FaceId, HalfedgeId, Removed, Side, VertexId,
};
use std::collections::BTreeMap;

/// A structure up to the numbers of its CCBs and faces, and the order of lists.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Signature {
    halfedges: Vec<(HalfedgeId, HalfedgeId, VertexId, usize, CcbKind, usize)>,
    isolated: Vec<(VertexId, usize)>,
    counts: [usize; 4],
}

impl Signature {
    pub(crate) fn of(dcel: &Dcel) -> Self {
        let (mut ccbs, mut faces) = (BTreeMap::new(), BTreeMap::new());
        let mut number = |f: FaceId| {
            let n = faces.len();
            *faces.entry(f).or_insert(n)
        };
        let halfedges = dcel.halfedges().map(|h| {
            let n = ccbs.len();
            let c = dcel.ccb(h);
            let ccb = *ccbs.entry(c).or_insert(n);
            (h, dcel.next(h), dcel.source(h), ccb, dcel.ccb_kind(c), number(dcel.face(h)))
        });
        let halfedges = halfedges.collect();
        let isolated = dcel.vertices().filter_map(|v| Some((v, number(dcel.isolated_face(v)?)))).collect();
        let counts = [dcel.vertex_count(), dcel.edge_count(), dcel.ccb_count(), dcel.face_count()];
        Self { halfedges, isolated, counts }
    }
}

/// An edge that was removed, with all that is needed to put it back.
pub(crate) struct Gone {
    edge: EdgeId,
    ends: [VertexId; 2],
    /// The halfedges that the two halves followed.
    prevs: [HalfedgeId; 2],
    kinds: [CcbKind; 2],
    removed: Removed,
    /// What the face that is no more had besides.
    ccbs: Vec<CcbId>,
    isolated: Vec<VertexId>,
    survivor: Side,
    kept: FaceId,
}

impl Gone {
    pub(crate) fn remove(dcel: &mut Dcel, edge: EdgeId, fates: [EndFate; 2], survivor: Side) -> Self {
        let halves = [edge.halfedge(), edge.halfedge().twin()];
        let own = halves.map(|h| dcel.ccb(h));
        let faces = halves.map(|h| dcel.face(h));
        let (kept, gone) = match survivor {
            Side::Even => (faces[0], faces[1]),
            Side::Odd => (faces[1], faces[0]),
        };
        Self {
            edge,
            ends: dcel.ends(edge),
            prevs: halves.map(|h| dcel.prev(h)),
            kinds: own.map(|c| dcel.ccb_kind(c)),
            ccbs: dcel.face_ccbs(gone).filter(|c| !own.contains(c)).collect(),
            isolated: dcel.isolated_vertices(gone).collect(),
            survivor,
            kept,
            removed: dcel.remove_edge(edge, fates, survivor),
        }
    }

    /// The ends that were removed are the ones that were freed last.
    fn revive(&self, dcel: &mut Dcel) {
        let [v, w] = self.ends;
        for end in if v == w { vec![v] } else { vec![w, v] } {
            if !dcel.has_vertex(end) {
                assert_eq!(dcel.add_vertex(), end);
            }
        }
    }

    pub(crate) fn put_back(self, dcel: &mut Dcel) {
        self.revive(dcel);
        let [v, w] = self.ends;
        let [near, far] = self.prevs;
        let [is_near_alone, is_far_alone] = [near, far].map(|h| h.edge_id() == self.edge);
        let faces = match self.removed {
            Removed::Joined { faces, .. } | Removed::Vanished { faces } => faces,
            _ => None,
        };
        let other = match self.survivor {
            Side::Even => Side::Odd,
            Side::Odd => Side::Even,
        };
        let split = CcbSplit { kinds: self.kinds, new_face: faces.map(|_| other) };
        let back = match self.removed {
            Removed::Antenna { .. } if is_near_alone => dcel.insert_edge_to(v, far),
            Removed::Antenna { .. } => dcel.insert_edge_from(near, w),
            Removed::Split { .. } => dcel.insert_edge_joining(near, far, self.kinds[0]),
            Removed::Vanished { .. } if v == w => dcel.insert_loop(v, self.kept, split),
            Removed::Vanished { .. } => dcel.insert_edge_in_face(v, w, self.kept, self.kinds[0]),
            Removed::Joined { .. } if is_near_alone => dcel.insert_edge_between(far, far, split),
            Removed::Joined { .. } if is_far_alone => {
                // The loop is alone on its other side.
                let kinds = [self.kinds[1], self.kinds[0]];
                let new_face = faces.map(|_| self.survivor);
                let e = dcel.insert_edge_between(near, near, CcbSplit { kinds, new_face });
                dcel.reverse_edge(e);
                e
            }
            Removed::Joined { .. } => dcel.insert_edge_between(near, far, split),
        };
        assert_eq!(back, self.edge);
        if let Some(faces) = faces {
            assert_eq!(dcel.face(back.half(other)), faces.gone);
            self.ccbs.iter().for_each(|&c| dcel.move_ccb(c, faces.gone));
            self.isolated.iter().for_each(|&v| dcel.move_isolated_vertex(v, faces.gone));
        }
    }
}
