//! Exact convex polytopes of dimension 0 to 3: convex hulls, Gaussian maps, Minkowski sums.

mod facets;
#[cfg_attr(not(test), expect(dead_code, reason = "its callers come with the polytope"))]
mod hull;
mod polygon_mesh;

pub use facets::Facets;
pub use polygon_mesh::PolygonMesh;
