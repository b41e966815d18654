//! The two kinds of nodes: vertices and faces.

use dcel::{CcbId, Dcel, FaceId, HalfedgeId, VertexId};
use std::fmt::Debug;
use std::hash::Hash;

/// Which cells are the nodes of a graph: [`Vertices`] or [`Faces`].
///
/// Halfedge h is an arc from the cell of h to that of its twin: from its source to its target, or from the face on its left to
/// that on its right. So what is said once of arcs holds for an arrangement and its dual.
pub trait Cells: Copy + sealed::Sealed {
    /// Names a node.
    type Id: Copy + Eq + Ord + Hash + Debug;

    /// The halfedges that start at a node.
    #[doc(hidden)]
    type Star<'a>: Iterator<Item = HalfedgeId>;

    /// The position of a node.
    #[doc(hidden)]
    fn index(id: Self::Id) -> usize;

    /// The node at a position.
    #[doc(hidden)]
    fn from_index(i: usize) -> Self::Id;

    /// A number above the positions of all nodes.
    #[doc(hidden)]
    fn bound(self, dcel: &Dcel) -> usize;

    #[doc(hidden)]
    fn has(self, dcel: &Dcel, id: Self::Id) -> bool;

    #[doc(hidden)]
    fn count(self, dcel: &Dcel) -> usize;

    /// The cell from which an arc leaves.
    #[doc(hidden)]
    fn cell_of(dcel: &Dcel, h: HalfedgeId) -> Self::Id;

    /// The arcs that leave a node, those to cells that are no nodes included.
    #[doc(hidden)]
    fn star(dcel: &Dcel, id: Self::Id) -> Self::Star<'_>;

    /// Whether both cells of an edge are nodes.
    #[doc(hidden)]
    fn has_edge(self, dcel: &Dcel, h: HalfedgeId) -> bool;

    /// The number of edges of which both cells are nodes.
    #[doc(hidden)]
    fn edge_count(self, dcel: &Dcel) -> usize;
}

/// The vertices are the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vertices {
    /// Of the first vertices, which stand for sides of the parameter space, those at infinity, as bits: they are no nodes.
    pub(crate) at_infinity: u8,
    /// And those at poles where nothing is, which are no nodes either.
    pub(crate) absent: u8,
}

/// The faces are the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Faces;

impl Cells for Vertices {
    type Id = VertexId;
    type Star<'a> = VertexStar<'a>;

    fn index(v: VertexId) -> usize {
        v.index()
    }

    fn from_index(i: usize) -> VertexId {
        VertexId::new(i)
    }

    fn bound(self, dcel: &Dcel) -> usize {
        dcel.vertex_bound()
    }

    fn has(self, dcel: &Dcel, v: VertexId) -> bool {
        !self.leaves_out(v) && dcel.has_vertex(v)
    }

    fn count(self, dcel: &Dcel) -> usize {
        dcel.vertex_count() - self.left_out(dcel).count()
    }

    fn cell_of(dcel: &Dcel, h: HalfedgeId) -> VertexId {
        dcel.source(h)
    }

    fn star(dcel: &Dcel, v: VertexId) -> VertexStar<'_> {
        let first = dcel.outgoing(v);
        VertexStar { dcel, first, at: first }
    }

    fn has_edge(self, dcel: &Dcel, h: HalfedgeId) -> bool {
        !self.leaves_out(dcel.source(h)) && !self.leaves_out(dcel.target(h))
    }

    fn edge_count(self, dcel: &Dcel) -> usize {
        let ends = self.left_out(dcel).flat_map(|v| dcel.around(v));
        // An edge with both ends there is met from both.
        let is_counted = |h: &HalfedgeId| h.is_even() || !self.leaves_out(dcel.target(*h));
        dcel.edge_count() - ends.filter(is_counted).count()
    }
}

impl Vertices {
    fn leaves_out(self, v: VertexId) -> bool {
        v.0 < u8::BITS && (self.at_infinity | self.absent) >> v.0 & 1 == 1
    }

    /// The vertices that are no nodes.
    fn left_out(self, dcel: &Dcel) -> impl Iterator<Item = VertexId> + '_ {
        (0..u8::BITS).map(VertexId).filter(move |&v| self.leaves_out(v) && dcel.has_vertex(v))
    }
}

impl Cells for Faces {
    type Id = FaceId;
    type Star<'a> = FaceStar<'a>;

    fn index(f: FaceId) -> usize {
        f.index()
    }

    fn from_index(i: usize) -> FaceId {
        FaceId::new(i)
    }

    fn bound(self, dcel: &Dcel) -> usize {
        dcel.face_bound()
    }

    fn has(self, dcel: &Dcel, f: FaceId) -> bool {
        dcel.has_face(f)
    }

    fn count(self, dcel: &Dcel) -> usize {
        dcel.face_count()
    }

    fn cell_of(dcel: &Dcel, h: HalfedgeId) -> FaceId {
        dcel.face(h)
    }

    fn star(dcel: &Dcel, f: FaceId) -> FaceStar<'_> {
        let ccb = dcel.first_ccb(f);
        let first = ccb.map(|ccb| dcel.ccb_halfedge(ccb));
        FaceStar { dcel, ccb, first, at: first }
    }

    fn has_edge(self, _: &Dcel, _: HalfedgeId) -> bool {
        true
    }

    fn edge_count(self, dcel: &Dcel) -> usize {
        dcel.edge_count()
    }
}

/// The halfedges that leave a vertex, counterclockwise.
#[derive(Clone)]
pub struct VertexStar<'a> {
    dcel: &'a Dcel,
    first: Option<HalfedgeId>,
    at: Option<HalfedgeId>,
}

impl Iterator for VertexStar<'_> {
    type Item = HalfedgeId;

    fn next(&mut self) -> Option<HalfedgeId> {
        let h = self.at?;
        self.at = Some(self.dcel.prev(h).twin()).filter(|&next| Some(next) != self.first);
        Some(h)
    }
}

/// The halfedges along the CCBs of a face.
#[derive(Clone)]
pub struct FaceStar<'a> {
    dcel: &'a Dcel,
    /// The present CCB, and its first halfedge.
    ccb: Option<CcbId>,
    first: Option<HalfedgeId>,
    at: Option<HalfedgeId>,
}

impl Iterator for FaceStar<'_> {
    type Item = HalfedgeId;

    fn next(&mut self) -> Option<HalfedgeId> {
        if self.at.is_none() {
            self.ccb = self.dcel.next_ccb(self.ccb?);
            self.first = self.ccb.map(|ccb| self.dcel.ccb_halfedge(ccb));
            self.at = self.first;
        }
        let h = self.at?;
        self.at = Some(self.dcel.next(h)).filter(|&next| Some(next) != self.first);
        Some(h)
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Vertices {}
    impl Sealed for super::Faces {}
}
