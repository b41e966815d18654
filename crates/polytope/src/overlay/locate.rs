//! Finding one direction in a Gaussian map: where a walk starts.

use super::map::{GaussianMap, Normal};
use super::record::Place;
use dcel::VertexId;
use exact::{Sign, predicate};

/// The place of the direction `normal` in the map.
///
/// # Complexity
/// Linear in the number of vertices of the polytope.
pub(super) fn locate(map: &GaussianMap<'_>, normal: Normal<'_>) -> Place {
    let mut extreme = 0;
    for v in 1..map.points.len() {
        if predicate::plane_side(normal.exact, &map.points[extreme], &map.points[v]) == Sign::Positive {
            extreme = v;
        }
    }
    let face = VertexId::new(extreme);
    for &arc in map.ring(face) {
        if map.side(normal, arc) != Sign::Zero {
            continue;
        }
        // On the circle of the arc, and in the closed face: on the arc, or on another arc of the same
        // circle (where digons cut it).
        let (start, end) = (map.mesh.facet(arc), map.end(arc));
        match (map.order_on(arc, map.normal(start), normal), map.order_on(arc, normal, map.normal(end))) {
            (Sign::Positive, Sign::Positive) => return Place::Arc(arc),
            (Sign::Zero, Sign::Positive) => return Place::Vertex(start),
            (Sign::Positive, Sign::Zero) => return Place::Vertex(end),
            _ => {}
        }
    }
    Place::Face(face, None)
}
