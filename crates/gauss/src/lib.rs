//! Gaussian maps on the engine of arrangements: polytopes, their reflections and their Minkowski sums.
//!
//! The Gaussian map of a polytope cuts the sphere of directions: a facet becomes a vertex (its outer normal), an edge an arc of a great circle (the
//! normals between those of its two facets), a vertex a face (the directions in which it is extreme). Each face knows its vertex, and so the map
//! knows the polytope. The map of a Minkowski sum is the overlay of the maps of the summands.
//!
//! | module | what |
//! |---|---|
//! | `spherical` | [`SphericalGaussianMap`]: geodesic arcs on the sphere |
//! | `cubical` | [`CubicalGaussianMap`]: the same on the six sides of a cube |
//!
//! # References
//! Thesis, sections 3.1 to 3.3.

mod cubical;
mod normals;
mod spherical;

pub use crate::cubical::{CubicalGaussianMap, CubicalGaussianViolation};
pub use spherical::{GaussianViolation, SphericalGaussianMap};
