//! Where a point lies to the planes of a convex polytope: the decisions of proximity queries.
//!
//! A query asks for the sides of one point to many planes that are made once. So the planes are kept as four floats each, and the
//! filter reads nothing else; the exact plane is asked only where the floats cannot tell.

mod depth;
mod query;
mod ray;

pub use depth::{DepthBounds, DepthCap, DepthPlane, DepthPoint, compare_depths};
pub use query::{PlaneFloats, QueryPoint};
pub use ray::side_of_ray;

#[cfg(test)]
mod tests;
