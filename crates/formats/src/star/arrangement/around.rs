//! What is around a vertex, before anything of it is known to be right.

use super::cells::Cells;
use super::family::Base;
use dcel::{FaceId, HalfedgeId, VertexId};

/// Points, cells and curves that may contradict each other, although every halfedge is in a boundary.
pub(super) struct Around<'a, B: Base> {
    pub(super) points: &'a [Option<B::Point>],
    pub(super) cells: &'a Cells,
    /// The pieces of the curve of an edge.
    pub(super) pieces: &'a dyn Fn(usize) -> &'a [B::UMonotoneCurve],
}

impl<B: Base> Around<'_, B> {
    /// The halfedges that leave a vertex.
    pub(super) fn leaving(&self, v: VertexId) -> impl Iterator<Item = HalfedgeId> + '_ {
        let halfedges = self.cells.halfedges.iter().enumerate();
        halfedges.filter(move |(_, record)| record.source == v).map(|(h, _)| HalfedgeId::new(h))
    }

    /// The face left of a halfedge.
    pub(super) fn face_of(&self, h: HalfedgeId) -> FaceId {
        self.cells.ccb_face(self.cells.halfedges[h.index()].ccb)
    }

    /// The face in which a vertex is said to be isolated.
    pub(super) fn face_of_isolated(&self, v: VertexId) -> Option<FaceId> {
        self.cells.isolated.iter().find(|(isolated, _)| *isolated == v).map(|&(_, face)| face)
    }
}
