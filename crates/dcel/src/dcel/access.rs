//! Reading the structure.

use super::lists::{self, NONE};
use super::{CcbKind, Dcel, Face, VertexCell, VertexState};
use crate::mesh::cycle;
use crate::{CcbId, EdgeId, FaceId, HalfedgeId, VertexId};

/// Counts and ids. An id is that of a cell if it is below the bound of its kind and not free.
impl Dcel {
    /// The number of vertices, isolated ones included.
    #[inline]
    pub fn vertex_count(&self) -> usize {
        self.vertices.len() - self.free_vertices.len()
    }

    /// The number of edges: half the number of halfedges.
    #[inline]
    pub fn edge_count(&self) -> usize {
        self.edge_bound() - self.free_edges.len()
    }

    /// The number of halfedges.
    #[inline]
    pub fn halfedge_count(&self) -> usize {
        2 * self.edge_count()
    }

    /// The number of faces.
    #[inline]
    pub fn face_count(&self) -> usize {
        self.faces.len() - self.free_faces.len()
    }

    /// The number of CCBs.
    #[inline]
    pub fn ccb_count(&self) -> usize {
        self.ccbs.len() - self.free_ccbs.len()
    }

    /// The number of isolated vertices.
    #[inline]
    pub fn isolated_vertex_count(&self) -> usize {
        self.isolated.len() - self.free_isolated.len()
    }

    /// A number above those of all vertices.
    #[inline]
    pub fn vertex_bound(&self) -> usize {
        self.vertices.len()
    }

    /// A number above those of all edges.
    #[inline]
    pub fn edge_bound(&self) -> usize {
        self.halfedges.len() / 2
    }

    /// A number above those of all halfedges.
    #[inline]
    pub fn halfedge_bound(&self) -> usize {
        self.halfedges.len()
    }

    /// A number above those of all faces.
    #[inline]
    pub fn face_bound(&self) -> usize {
        self.faces.len()
    }

    /// A number above those of all CCBs.
    #[inline]
    pub fn ccb_bound(&self) -> usize {
        self.ccbs.len()
    }

    /// Whether there is such a vertex.
    #[inline]
    pub fn has_vertex(&self, v: VertexId) -> bool {
        self.vertices.get(v.index()).is_some_and(|&cell| cell != VertexCell::FREE)
    }

    /// Whether there is such an edge.
    #[inline]
    pub fn has_edge(&self, e: EdgeId) -> bool {
        self.halfedges.get(2 * e.index()).is_some_and(|h| h.source != VertexId::NONE)
    }

    /// Whether there is such a halfedge.
    #[inline]
    pub fn has_halfedge(&self, h: HalfedgeId) -> bool {
        self.has_edge(h.edge_id())
    }

    /// Whether there is such a face.
    #[inline]
    pub fn has_face(&self, f: FaceId) -> bool {
        self.faces.get(f.index()).is_some_and(|&face| face != Face::FREE)
    }

    /// Whether there is such a CCB.
    #[inline]
    pub fn has_ccb(&self, c: CcbId) -> bool {
        self.ccbs.get(c.index()).is_some_and(|ccb| ccb.first != HalfedgeId::NONE)
    }

    /// All vertices, in the order of their ids.
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        (0..self.vertex_bound()).map(VertexId::new).filter(|&v| self.has_vertex(v))
    }

    /// All edges, in the order of their ids.
    pub fn edges(&self) -> impl Iterator<Item = EdgeId> + '_ {
        (0..self.edge_bound()).map(EdgeId::new).filter(|&e| self.has_edge(e))
    }

    /// All halfedges, in the order of their ids.
    pub fn halfedges(&self) -> impl Iterator<Item = HalfedgeId> + '_ {
        (0..self.halfedge_bound()).map(HalfedgeId::new).filter(|&h| self.has_halfedge(h))
    }

    /// All faces, in the order of their ids.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        (0..self.face_bound()).map(FaceId::new).filter(|&f| self.has_face(f))
    }

    /// All CCBs, in the order of their ids.
    pub fn ccbs(&self) -> impl Iterator<Item = CcbId> + '_ {
        (0..self.ccb_bound()).map(CcbId::new).filter(|&c| self.has_ccb(c))
    }
}

/// Neighbours. All panic for ids at or above the bound of their kind, and promise nothing for those of
/// removed cells, except where they say otherwise.
impl Dcel {
    /// The halfedge after `h` along its CCB.
    #[inline]
    pub fn next(&self, h: HalfedgeId) -> HalfedgeId {
        self.halfedges[h.index()].next
    }

    /// The halfedge before `h` along its CCB.
    #[inline]
    pub fn prev(&self, h: HalfedgeId) -> HalfedgeId {
        self.halfedges[h.index()].prev
    }

    /// The same edge in the other direction.
    #[inline]
    pub fn twin(&self, h: HalfedgeId) -> HalfedgeId {
        h.twin()
    }

    /// The vertex where `h` starts.
    #[inline]
    pub fn source(&self, h: HalfedgeId) -> VertexId {
        self.halfedges[h.index()].source
    }

    /// The vertex where `h` ends.
    #[inline]
    pub fn target(&self, h: HalfedgeId) -> VertexId {
        self.halfedges[h.twin().index()].source
    }

    /// The vertices of `e`: the min and the max vertex.
    #[inline]
    pub fn ends(&self, e: EdgeId) -> [VertexId; 2] {
        [self.source(e.halfedge()), self.target(e.halfedge())]
    }

    /// The CCB on which `h` lies.
    #[inline]
    pub fn ccb(&self, h: HalfedgeId) -> CcbId {
        self.halfedges[h.index()].ccb
    }

    /// The face on the left of `h`.
    #[inline]
    pub fn face(&self, h: HalfedgeId) -> FaceId {
        self.ccb_face(self.ccb(h))
    }

    /// A halfedge that leaves `v`; none if `v` has no edge.
    #[inline]
    pub fn outgoing(&self, v: VertexId) -> Option<HalfedgeId> {
        match self.vertices[v.index()].state() {
            VertexState::Attached(h) => Some(h),
            _ => None,
        }
    }

    /// The number of halfedges that leave `v`. A loop counts twice.
    ///
    /// # Complexity
    /// Linear in the result.
    pub fn degree(&self, v: VertexId) -> usize {
        self.around(v).count()
    }

    /// The halfedges that leave `v`, counterclockwise, [`outgoing`](Self::outgoing) first: after `h`
    /// comes the twin of the one before `h`.
    pub fn around(&self, v: VertexId) -> impl Iterator<Item = HalfedgeId> + '_ {
        let first = self.outgoing(v);
        let mut at = first;
        std::iter::from_fn(move || {
            let h = at?;
            at = Some(self.prev(h).twin()).filter(|&next| Some(next) != first);
            Some(h)
        })
    }

    /// The face in which the isolated vertex `v` lies; none if `v` is not isolated.
    #[inline]
    pub fn isolated_face(&self, v: VertexId) -> Option<FaceId> {
        match self.vertices[v.index()].state() {
            VertexState::Isolated(place) => Some(self.isolated[place as usize].face),
            _ => None,
        }
    }

    /// The halfedges of the CCB of `h`, from `h` on.
    pub fn cycle(&self, h: HalfedgeId) -> impl Iterator<Item = HalfedgeId> + '_ {
        cycle(h, |h| self.next(h))
    }

    /// The halfedges of `c`, [`ccb_halfedge`](Self::ccb_halfedge) first.
    pub fn ccb_cycle(&self, c: CcbId) -> impl Iterator<Item = HalfedgeId> + '_ {
        self.cycle(self.ccb_halfedge(c))
    }

    /// The kind of `c`.
    #[inline]
    pub fn ccb_kind(&self, c: CcbId) -> CcbKind {
        self.ccbs[c.index()].kind()
    }

    /// The face on whose boundary `c` lies.
    #[inline]
    pub fn ccb_face(&self, c: CcbId) -> FaceId {
        self.ccbs[c.index()].face()
    }

    /// A halfedge of `c`.
    #[inline]
    pub fn ccb_halfedge(&self, c: CcbId) -> HalfedgeId {
        self.ccbs[c.index()].first
    }

    /// The outer CCBs of `f`; none for an id of a removed face.
    pub fn outer_ccbs(&self, f: FaceId) -> impl Iterator<Item = CcbId> + '_ {
        let face = self.faces[f.index()];
        let head = if face == Face::FREE { NONE } else { face.outer };
        lists::iter(&self.ccbs, head).map(CcbId)
    }

    /// The inner CCBs of `f`; none for an id of a removed face.
    pub fn inner_ccbs(&self, f: FaceId) -> impl Iterator<Item = CcbId> + '_ {
        lists::iter(&self.ccbs, self.faces[f.index()].inner).map(CcbId)
    }

    /// All CCBs of `f`, the outer ones first.
    pub fn face_ccbs(&self, f: FaceId) -> impl Iterator<Item = CcbId> + '_ {
        self.outer_ccbs(f).chain(self.inner_ccbs(f))
    }

    /// The first of all CCBs of `f`, in the order of [`face_ccbs`](Self::face_ccbs); none for an id of a removed face.
    ///
    /// With [`next_ccb`](Self::next_ccb) it is a walk that borrows nothing between its steps.
    pub fn first_ccb(&self, f: FaceId) -> Option<CcbId> {
        let face = self.faces[f.index()];
        let heads = if face == Face::FREE { [NONE; 2] } else { [face.outer, face.inner] };
        heads.into_iter().find(|&head| head != NONE).map(CcbId)
    }

    /// The CCB after `c` among all CCBs of its face, in the order of [`face_ccbs`](Self::face_ccbs); none after the last one.
    ///
    /// # Panics
    /// If there is no CCB `c`.
    ///
    /// # Examples
    /// ```
    /// use splitstar_dcel::{CcbKind, Dcel, FaceId};
    ///
    /// // Two edges that do not touch each other: two holes.
    /// let mut dcel = Dcel::new();
    /// let face = FaceId(0);
    /// let [a, b, c, d] = [(); 4].map(|()| dcel.add_vertex());
    /// dcel.insert_edge_in_face(a, b, face, CcbKind::Inner);
    /// dcel.insert_edge_in_face(c, d, face, CcbKind::Inner);
    /// let first = dcel.first_ccb(face);
    /// let second = first.and_then(|ccb| dcel.next_ccb(ccb));
    /// assert!(second.is_some() && second != first);
    /// assert_eq!(second.and_then(|ccb| dcel.next_ccb(ccb)), None);
    /// ```
    pub fn next_ccb(&self, c: CcbId) -> Option<CcbId> {
        let ccb = self.ccbs[c.index()];
        let face = self.faces[ccb.face().index()];
        let next = ccb.links.next;
        let of_next = match ccb.kind() {
            CcbKind::Outer if next == face.outer => face.inner,
            CcbKind::Inner if next == face.inner => NONE,
            _ => next,
        };
        (of_next != NONE).then_some(CcbId(of_next))
    }

    /// The isolated vertices in `f`; none for an id of a removed face.
    pub fn isolated_vertices(&self, f: FaceId) -> impl Iterator<Item = VertexId> + '_ {
        lists::iter(&self.isolated, self.faces[f.index()].isolated).map(|i| self.isolated[i as usize].vertex)
    }
}
