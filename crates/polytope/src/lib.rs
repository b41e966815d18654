//! Exact convex polytopes of dimension 0 to 3: convex hulls, Gaussian maps, Minkowski sums.

mod facets;
mod polygon_mesh;

pub use facets::Facets;
pub use polygon_mesh::PolygonMesh;
