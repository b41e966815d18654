//! Halfedge connectivity with typed ids. It knows no point and no number: what lies where is the
//! business of the crates above.
//!
//! [`Mesh`] is the surface of a polyhedron, made in one go; [`Dcel`] is an arrangement on a surface of
//! any genus, with holes, isolated vertices and local edits.
//!
//! ```
//! use splitstar_dcel::Mesh;
//! // A tetrahedron: four facets, counterclockwise seen from outside.
//! let corners = [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2];
//! let mesh = Mesh::from_cycles(4, &[0, 3, 6, 9, 12], &corners)?;
//! assert_eq!((mesh.vertex_count(), mesh.edge_count(), mesh.facet_count()), (4, 6, 4));
//! let h = mesh.outgoing(splitstar_dcel::VertexId(0));
//! assert_eq!(mesh.target(h), mesh.source(h.twin()));
//! assert!(mesh.check_valid().is_empty());
//!
//! // An edge in the plane, closed to a triangle by two more.
//! use splitstar_dcel::{CcbKind::{Inner, Outer}, CcbSplit, Dcel, FaceId, Side};
//! let mut dcel = Dcel::new();
//! let [a, b, c] = [dcel.add_vertex(), dcel.add_vertex(), dcel.add_vertex()];
//! let ab = dcel.insert_edge_in_face(a, b, FaceId(0), Inner);
//! let bc = dcel.insert_edge_from(ab.halfedge(), c);
//! let split = CcbSplit { kinds: [Outer, Inner], new_face: Some(Side::Even) };
//! let ca = dcel.insert_edge_between(bc.halfedge(), ab.halfedge().twin(), split);
//! assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.face_count()), (3, 3, 2));
//! assert_eq!(dcel.cycle(ca.halfedge()).count(), 3);
//! assert!(dcel.check_euler(0).is_empty());
//! # Ok::<(), splitstar_dcel::Defect>(())
//! ```

mod build;
mod dcel;
mod ids;
mod maps;
mod mesh;
#[cfg(test)]
mod tests;
mod validity;

pub use build::{Defect, Edge};
pub use dcel::{
    CcbKind, CcbSplit, Compaction, Dcel, DcelViolation, EndFate, FaceList, Halfedge, MergedFaces, RawCcb,
    RawDcel, Removed, Side,
};
pub use ids::{CcbId, EdgeId, FaceId, FacetId, HalfedgeId, VertexId};
pub use maps::{EdgeMap, FaceMap, HalfedgeMap, VertexMap};
pub use mesh::Mesh;
pub use validity::Violation;
