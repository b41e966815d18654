//! Whether a facet is planar, asked for one facet alone.

use super::shape::Shape;
use exact::{Point3, Rational};

/// A corner of a facet that is off the plane of its first three consecutive corners that are not collinear, with the
/// square of its distance from that plane; `None` if the facet is planar.
///
/// Degenerate: a facet whose corners are collinear is planar, and so is one of three corners.
///
/// # Panics
/// If the cycle has fewer than two corners, or one that is the index of no point.
///
/// # Complexity
/// Linear.
pub fn corner_off_plane(points: &[Point3], cycle: &[u32]) -> Option<(u32, Rational)> {
    match Shape::of(points, cycle) {
        Shape::Bent { vertex, squared_distance } => Some((vertex, squared_distance)),
        Shape::Plane(_) | Shape::Line | Shape::Edge => None,
    }
}
