//! Halfedge connectivity with typed ids. It knows no point and no number: what lies where is the
//! business of the crates above.
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
//! # Ok::<(), splitstar_dcel::Defect>(())
//! ```

mod build;
mod dcel;
mod ids;
mod mesh;
#[cfg(test)]
mod tests;
mod validity;

pub use build::{Defect, Edge};
pub use dcel::{CcbKind, Dcel, Halfedge, RawCcb, RawDcel};
pub use ids::{CcbId, EdgeId, FaceId, FacetId, HalfedgeId, VertexId};
pub use mesh::Mesh;
pub use validity::Violation;
