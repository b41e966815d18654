//! Exact convex polytopes of dimension 0 to 3: convex hulls, Gaussian maps, Minkowski sums.
//!
//! | module | what it does |
//! |---|---|
//! | `polytope`, `measure`, `validity` | the halfedge polytope, its volume, what it promises |
//! | `polygon_mesh`, `facets`, `mesh` | meshes as files have them: mended, and the way from them to polytopes |
//! | `triangulate` | facets cut into triangles, with holes or without |
//! | `hull` | the convex hull of any finite point set |
//! | `overlay`, `sum` | the Minkowski sum by the overlay of Gaussian maps |
//! | `lp` | the Minkowski sum by linear programming, all summands at once |
//! | `maximal` | polytopes whose sums have the greatest number of facets, and that number |

#[cfg(feature = "faults")]
pub mod fault;
#[cfg(not(feature = "faults"))]
mod fault;

mod facets;
mod hull;
mod lp;
mod maximal;
mod measure;
mod mesh;
mod overlay;
mod polygon_mesh;
mod polytope;
mod sum;
mod triangulate;
mod validity;
mod vectors;

pub use facets::Facets;
pub use lp::minkowski_sum_by_lp;
pub use maximal::{MaximalError, max_facets, maximal_polytope, maximal_summands};
pub use measure::Bounds;
pub use mesh::{Hole, Mended, Mending, MeshError, MeshSummary, Note, corner_off_plane, hull_depth};
pub use overlay::OverlayCounts;
pub use polygon_mesh::PolygonMesh;
pub use polytope::{Counts, Polytope, convex_hull};
pub use sum::{minkowski_sum, minkowski_sum_by_hull, overlay_counts};
pub use triangulate::{HoleError, TriangulateError, triangulate_with_holes};
pub use validity::Violation;

pub use dcel::{Defect, FacetId, HalfedgeId, Mesh, VertexId};
