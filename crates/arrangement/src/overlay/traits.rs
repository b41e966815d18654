//! The ten cases of an overlay.

use super::{Cell, Provenance};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;
use dcel::{EdgeId, FaceId, VertexId};

/// What is to be done with the cells of an overlay of a red and a blue arrangement: one function for each of the ten ways in which
/// a cell can come about.
///
/// Every function does nothing unless it is implemented. Vertices come first, then edges, then faces, each in the order of their
/// ids. Vertices that stand for sides of the parameter space come as coinciding vertices.
///
/// # References
/// Thesis, section 2.4.2.
pub trait OverlayTraits {
    /// 1. A red and a blue vertex coincide.
    fn vertices_coincide(&mut self, v: VertexId, red: VertexId, blue: VertexId) {
        let _ = (v, red, blue);
    }
    /// 2. A red vertex lies on a blue edge.
    fn red_vertex_on_edge(&mut self, v: VertexId, red: VertexId, blue: EdgeId) {
        let _ = (v, red, blue);
    }
    /// 3. A blue vertex lies on a red edge.
    fn blue_vertex_on_edge(&mut self, v: VertexId, red: EdgeId, blue: VertexId) {
        let _ = (v, red, blue);
    }
    /// 4. A red vertex lies in a blue face.
    fn red_vertex_in_face(&mut self, v: VertexId, red: VertexId, blue: FaceId) {
        let _ = (v, red, blue);
    }
    /// 5. A blue vertex lies in a red face.
    fn blue_vertex_in_face(&mut self, v: VertexId, red: FaceId, blue: VertexId) {
        let _ = (v, red, blue);
    }
    /// 6. A red and a blue edge meet.
    fn edges_meet(&mut self, v: VertexId, red: EdgeId, blue: EdgeId) {
        let _ = (v, red, blue);
    }
    /// 7. A red and a blue edge overlap.
    fn edges_overlap(&mut self, e: EdgeId, red: EdgeId, blue: EdgeId) {
        let _ = (e, red, blue);
    }
    /// 8. A part of a red edge lies in a blue face.
    fn red_edge_in_face(&mut self, e: EdgeId, red: EdgeId, blue: FaceId) {
        let _ = (e, red, blue);
    }
    /// 9. A part of a blue edge lies in a red face.
    fn blue_edge_in_face(&mut self, e: EdgeId, red: FaceId, blue: EdgeId) {
        let _ = (e, red, blue);
    }
    /// 10. A red and a blue face overlap.
    fn faces_overlap(&mut self, f: FaceId, red: FaceId, blue: FaceId) {
        let _ = (f, red, blue);
    }
}

/// Does nothing in all ten cases.
impl OverlayTraits for () {}

/// Calls a function for every cell of an overlay of two arrangements.
pub(super) fn call<G: BasicTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    provenance: &Provenance,
    traits: &mut impl OverlayTraits,
) {
    let dcel = arrangement.dcel();
    for v in dcel.vertices().filter(|&v| !arrangement.is_absent(v)) {
        match *provenance.of_vertex(v) {
            [Cell::Vertex(red), Cell::Vertex(blue)] => traits.vertices_coincide(v, red, blue),
            [Cell::Vertex(red), Cell::Edge(blue)] => traits.red_vertex_on_edge(v, red, blue),
            [Cell::Edge(red), Cell::Vertex(blue)] => traits.blue_vertex_on_edge(v, red, blue),
            [Cell::Vertex(red), Cell::Face(blue)] => traits.red_vertex_in_face(v, red, blue),
            [Cell::Face(red), Cell::Vertex(blue)] => traits.blue_vertex_in_face(v, red, blue),
            [Cell::Edge(red), Cell::Edge(blue)] => traits.edges_meet(v, red, blue),
            ref cells => unreachable!("a vertex of an overlay does not come from {cells:?}"),
        }
    }
    for e in dcel.edges() {
        match *provenance.of_edge(e) {
            [Cell::Edge(red), Cell::Edge(blue)] => traits.edges_overlap(e, red, blue),
            [Cell::Edge(red), Cell::Face(blue)] => traits.red_edge_in_face(e, red, blue),
            [Cell::Face(red), Cell::Edge(blue)] => traits.blue_edge_in_face(e, red, blue),
            ref cells => unreachable!("an edge of an overlay does not come from {cells:?}"),
        }
    }
    for f in dcel.faces() {
        if let &[red, blue] = provenance.of_face(f) {
            traits.faces_overlap(f, red, blue);
        }
    }
}
