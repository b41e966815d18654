//! Edits that add an edge.

use super::{CcbKind, Dcel, Halfedge, VertexCell, VertexState};
use crate::{CcbId, EdgeId, FaceId, HalfedgeId, VertexId};

/// A side of an edge, named by the halfedge that has it on its left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// The left side of the edge as it runs from the min to the max vertex.
    Even,
    /// The right side.
    Odd,
}

impl EdgeId {
    /// The halfedge of `side`.
    #[inline]
    pub fn half(self, side: Side) -> HalfedgeId {
        match side {
            Side::Even => self.halfedge(),
            Side::Odd => self.halfedge().twin(),
        }
    }
}

/// What becomes of the two CCBs, one on each side, that a new edge makes of one or of none.
///
/// Whether the face falls apart is not a matter of connectivity: a closed curve around the handle of a
/// torus leaves its face in one piece. So the caller says it. Holes and isolated vertices stay in the
/// old face; [`Dcel::move_ccb`] and [`Dcel::move_isolated_vertex`] bring them to the new one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CcbSplit {
    /// The kinds of the CCBs of the even and of the odd halfedge.
    pub kinds: [CcbKind; 2],
    /// The side on which a new face lies; none if the face stays in one piece.
    pub new_face: Option<Side>,
}

/// Insertion of an edge. The even halfedge of the new edge runs from the vertex named first to the one
/// named second.
impl Dcel {
    /// Inserts an edge from `v1` to `v2`, which have no edges, in the interior of `face`: a new CCB of
    /// the given kind.
    ///
    /// # Panics
    /// If the vertices are the same (see [`insert_loop`](Self::insert_loop)), attached, removed, or
    /// isolated in another face.
    ///
    /// # Complexity
    /// Constant, amortized.
    pub fn insert_edge_in_face(&mut self, v1: VertexId, v2: VertexId, face: FaceId, kind: CcbKind) -> EdgeId {
        assert!(v1 != v2, "a loop has two CCBs");
        self.take_from(v1, face);
        self.take_from(v2, face);
        let e = self.link_edge([v1, v2], [None, None]);
        let ccb = self.add_ccb(e.halfedge(), face, kind);
        self.label(e, ccb);
        e
    }

    /// Inserts an edge from `v`, which has no edges, to itself in the interior of `face`. Each side is a
    /// CCB of one halfedge.
    ///
    /// # Panics
    /// If `v` is attached, removed, or isolated in another face.
    ///
    /// # Complexity
    /// Constant, amortized.
    ///
    /// # Examples
    /// ```
    /// use splitstar_dcel::{CcbKind::{Inner, Outer}, CcbSplit, Dcel, FaceId, Side};
    /// // A circle in the plane: its interior, on the left, is a new face.
    /// let mut plane = Dcel::new();
    /// let v = plane.add_vertex();
    /// let split = CcbSplit { kinds: [Outer, Inner], new_face: Some(Side::Even) };
    /// let e = plane.insert_loop(v, FaceId(0), split);
    /// assert_eq!(plane.face(e.half(Side::Odd)), FaceId(0));
    /// assert_eq!(plane.face_count(), 2);
    ///
    /// // A closed curve around the handle of a torus: one face on both sides.
    /// let mut torus = Dcel::new();
    /// let v = torus.add_vertex();
    /// torus.insert_loop(v, FaceId(0), CcbSplit { kinds: [Outer, Outer], new_face: None });
    /// assert_eq!(torus.face_count(), 1);
    /// assert_eq!(torus.outer_ccbs(FaceId(0)).count(), 2);
    /// ```
    pub fn insert_loop(&mut self, v: VertexId, face: FaceId, split: CcbSplit) -> EdgeId {
        self.take_from(v, face);
        let e = self.link_edge([v, v], [None, None]);
        for (side, kind) in [Side::Even, Side::Odd].into_iter().zip(split.kinds) {
            let h = e.half(side);
            self.halfedges[h.index()].ccb = self.add_ccb(h, face, kind);
        }
        self.split_face_at(e, split);
        e
    }

    /// Inserts an edge from the target of `prev` to `v`, which has no edges. It follows `prev`: around
    /// the target, it is the first after the twin of `prev` clockwise.
    ///
    /// # Panics
    /// If there is no such halfedge, or `v` is attached, removed, or isolated in another face.
    ///
    /// # Complexity
    /// Constant, amortized.
    pub fn insert_edge_from(&mut self, prev: HalfedgeId, v: VertexId) -> EdgeId {
        let ends = [self.target(prev), v];
        self.insert_antenna(prev, v, ends, [Some(prev), None])
    }

    /// Inserts an edge from `v`, which has no edges, to the target of `prev`, whose next halfedge is the
    /// odd one of the new edge then.
    ///
    /// # Panics
    /// As [`insert_edge_from`](Self::insert_edge_from).
    ///
    /// # Complexity
    /// Constant, amortized.
    pub fn insert_edge_to(&mut self, v: VertexId, prev: HalfedgeId) -> EdgeId {
        let ends = [v, self.target(prev)];
        self.insert_antenna(prev, v, ends, [None, Some(prev)])
    }

    fn insert_antenna(
        &mut self,
        prev: HalfedgeId,
        v: VertexId,
        ends: [VertexId; 2],
        at: [Option<HalfedgeId>; 2],
    ) -> EdgeId {
        assert!(self.has_halfedge(prev), "the new edge is attached to an edge");
        self.take_from(v, self.face(prev));
        let e = self.link_edge(ends, at);
        self.label(e, self.ccb(prev));
        e
    }

    /// Inserts an edge from the target of `prev1` to the target of `prev2`, which lie on one CCB: it
    /// becomes two. The even halfedge follows `prev1` and the odd one `prev2`.
    ///
    /// Degenerate: if `prev1` is `prev2`, the edge is a loop in one corner, and its even halfedge is
    /// alone on its CCB. [`reverse_edge`](Self::reverse_edge) afterwards exchanges the two (the kinds and
    /// the new face of `split` are those before it).
    ///
    /// # Panics
    /// If there are no such halfedges, or they lie on two CCBs.
    ///
    /// # Complexity
    /// Linear in the length of the shorter of the two new CCBs.
    pub fn insert_edge_between(&mut self, prev1: HalfedgeId, prev2: HalfedgeId, split: CcbSplit) -> EdgeId {
        assert!(self.has_halfedge(prev1) && self.has_halfedge(prev2), "the new edge is attached to edges");
        let old = self.ccb(prev1);
        assert!(old == self.ccb(prev2), "an edge between two CCBs joins them");
        let e = self.link_edge([self.target(prev1), self.target(prev2)], [Some(prev1), Some(prev2)]);
        self.label(e, old);
        self.split_ccb([e.halfedge(), e.halfedge().twin()], old);
        for (side, kind) in [Side::Even, Side::Odd].into_iter().zip(split.kinds) {
            self.set_ccb_kind(self.ccb(e.half(side)), kind);
        }
        self.split_face_at(e, split);
        e
    }

    /// Inserts an edge from the target of `prev1` to the target of `prev2`, which lie on two CCBs of one
    /// face: they become one of the given kind. The even halfedge follows `prev1` and the odd one
    /// `prev2`.
    ///
    /// # Panics
    /// If there are no such halfedges, or they lie on one CCB or on CCBs of two faces.
    ///
    /// # Complexity
    /// Linear in the length of the shorter of the two CCBs.
    pub fn insert_edge_joining(&mut self, prev1: HalfedgeId, prev2: HalfedgeId, kind: CcbKind) -> EdgeId {
        assert!(self.has_halfedge(prev1) && self.has_halfedge(prev2), "the new edge is attached to edges");
        assert!(self.ccb(prev1) != self.ccb(prev2), "an edge between two places of a CCB splits it");
        assert!(self.face(prev1) == self.face(prev2), "the ends of the new edge are on one face");
        let ccb = self.join_ccbs([prev1, prev2]);
        let e = self.link_edge([self.target(prev1), self.target(prev2)], [Some(prev1), Some(prev2)]);
        self.label(e, ccb);
        self.set_ccb_kind(ccb, kind);
        e
    }

    fn split_face_at(&mut self, e: EdgeId, split: CcbSplit) {
        if let Some(side) = split.new_face {
            self.split_face(self.ccb(e.half(side)));
        }
    }

    /// Makes a vertex without edges bare.
    fn take_from(&mut self, v: VertexId, face: FaceId) {
        let lies_in = self.isolated_face(v);
        assert!(lies_in.is_none_or(|f| f == face), "an isolated vertex is reached from its face only");
        self.make_bare(v);
    }

    /// Makes an edge and links it in at each end, after the halfedge given or alone.
    fn link_edge(&mut self, ends: [VertexId; 2], at: [Option<HalfedgeId>; 2]) -> EdgeId {
        let e = self.new_edge(ends);
        let (h, twin) = (e.halfedge(), e.halfedge().twin());
        self.link(h, twin);
        self.link(twin, h);
        for (out, prev) in [(h, at[0]), (twin, at[1])] {
            let v = self.source(out);
            // The second end of a loop meets the first one.
            let met = matches!(self.vertices[v.index()].state(), VertexState::Attached(_));
            let Some(prev) = prev.or(met.then_some(out)) else {
                self.vertices[v.index()] = VertexCell(out.0);
                continue;
            };
            let next = self.next(prev);
            self.link(prev, out);
            self.link(out.twin(), next);
        }
        e
    }

    /// Makes an edge that is linked to nothing yet.
    pub(super) fn new_edge(&mut self, ends: [VertexId; 2]) -> EdgeId {
        let records = ends.map(|source| Halfedge { source, ..Halfedge::FREE });
        if let Some(e) = self.free_edges.pop() {
            let h = EdgeId(e).halfedge().index();
            self.halfedges[h..h + 2].copy_from_slice(&records);
            return EdgeId(e);
        }
        assert!(self.halfedges.len() < (1 << 31), "there are fewer than 2^31 halfedges");
        self.halfedges.extend(records);
        EdgeId::new(self.halfedges.len() / 2 - 1)
    }

    pub(super) fn free_edge(&mut self, e: EdgeId) {
        let h = e.halfedge().index();
        self.halfedges[h..h + 2].fill(Halfedge::FREE);
        self.free_edges.push(e.0);
    }

    /// Makes `b` the halfedge after `a`.
    #[inline]
    pub(super) fn link(&mut self, a: HalfedgeId, b: HalfedgeId) {
        self.halfedges[a.index()].next = b;
        self.halfedges[b.index()].prev = a;
    }

    fn label(&mut self, e: EdgeId, ccb: CcbId) {
        for side in [Side::Even, Side::Odd] {
            self.halfedges[e.half(side).index()].ccb = ccb;
        }
    }

    /// The cycles of `ends` are two, and are labelled as one: the shorter one becomes a new CCB of the
    /// same face and kind.
    pub(super) fn split_ccb(&mut self, ends: [HalfedgeId; 2], old: CcbId) {
        let (short, long) = self.by_length(ends);
        let new = self.add_ccb(short, self.ccb_face(old), self.ccb_kind(old));
        self.ccbs[old.index()].first = long;
        self.relabel(short, new);
    }

    /// The cycles of `ends` are to be labelled as one: gives all halfedges the CCB of the longer one,
    /// and removes the other.
    pub(super) fn join_ccbs(&mut self, ends: [HalfedgeId; 2]) -> CcbId {
        let (short, long) = self.by_length(ends);
        let (gone, kept) = (self.ccb(short), self.ccb(long));
        self.relabel(short, kept);
        self.remove_ccb(gone);
        kept
    }

    /// The halfedge of the shorter cycle, of the second one if they are as long, and the other one. Both
    /// are walked in step, so that the longer one costs no more than the shorter one.
    fn by_length(&self, [a, b]: [HalfedgeId; 2]) -> (HalfedgeId, HalfedgeId) {
        let (mut on_a, mut on_b) = (a, b);
        loop {
            (on_a, on_b) = (self.next(on_a), self.next(on_b));
            if on_b == b {
                return (b, a);
            }
            if on_a == a {
                return (a, b);
            }
        }
    }

    fn relabel(&mut self, first: HalfedgeId, ccb: CcbId) {
        let mut h = first;
        loop {
            self.halfedges[h.index()].ccb = ccb;
            h = self.next(h);
            if h == first {
                return;
            }
        }
    }
}
