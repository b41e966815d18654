//! The circles and the normals of a polytope, of which both maps are made.

use dcel::{HalfedgeId, Mesh};
use exact::spherical::{Direction, GreatCircle};
use polytope::Polytope;

/// The circle around the vector of an edge.
pub(crate) fn circle_of(polytope: &Polytope, h: HalfedgeId) -> GreatCircle {
    GreatCircle::new(&polytope.edge_vector(h)).expect("the ends of an edge are different")
}

/// The outer normal of a facet, where the circles of two consecutive edges cross: so it is as narrow as these.
pub(crate) fn normal_of(mesh: &Mesh, circles: &[GreatCircle], h: HalfedgeId) -> Direction {
    let next = mesh.next(h);
    let [first, second] = [h, next].map(|h| &circles[h.edge()]);
    // Opposite circles cross in the opposite direction.
    let normal = match h.is_even() == next.is_even() {
        true => Direction::crossing(first, second),
        false => Direction::crossing(second, first),
    };
    normal.expect("consecutive edges of a facet are not parallel")
}
