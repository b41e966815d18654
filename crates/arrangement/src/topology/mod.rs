//! The topology traits: what depends on the surface, and on nothing else.
//!
//! | topology | sides | curves it can carry | genus |
//! |---|---|---|---|
//! | [`BoundedPlane`] | closed | all that have two end points | 0 |
//! | [`UnboundedPlane`] | open | those that are open left, right, below and above | 0 |
//! | [`Sphere`] | left and right identified, bottom and top contracted | those that are identified left to right and contracted below and above | 0 |
//! | [`FlatTorus`] | both pairs identified | those that are identified left to right and bottom to top | 1 |

mod bounded_plane;
mod flat_torus;
mod site;
mod sphere;
mod unbounded_plane;

pub use bounded_plane::BoundedPlane;
pub use flat_torus::FlatTorus;
pub(crate) use site::ends_on_side;
pub use site::{Site, SiteAt};
pub use sphere::Sphere;
pub use unbounded_plane::UnboundedPlane;

use crate::traits::{BasicTraits, CurveEnd, Location, SideKind, Sides};
use dcel::CcbKind;
use std::cmp::Ordering;
use std::fmt::Debug;

/// A surface, as far as an arrangement on it has to know it.
///
/// The bounds on `G` stand on the implementations, so that a surface does not compile with curves that it cannot serve:
///
/// ```compile_fail,E0277
/// use splitstar_arrangement::{Arrangement, models::SegmentTraits, topology::FlatTorus};
/// let wrong = Arrangement::new(SegmentTraits, FlatTorus::default());
/// ```
///
/// # References
/// Thesis, section 2.3.1, "topology traits".
pub trait Topology<G: BasicTraits>: Clone + Debug + Send + Sync {
    /// Tells what the sides of the parameter space are.
    fn sides(&self) -> Sides;

    /// Gives the genus of the surface, which is closed once its open sides are closed by points.
    fn genus(&self) -> u32;

    /// Tells where an end of a curve lies.
    fn end_location(&self, traits: &G, curve: &G::UMonotoneCurve, end: CurveEnd) -> Location;

    /// Tells where a point lies; one on an identification counts as left, or as bottom.
    fn point_location(&self, traits: &G, point: &G::Point) -> Location;

    /// Compares two sites in the order in which a sweep meets them.
    ///
    /// That is the left side, from bottom to top; then by u, and for one u the bottom side, the interior by v, and the top side;
    /// then the right side, from bottom to top. Ends without points are placed by the curves near them, and are equal if these
    /// have a piece in common.
    ///
    /// Law: between the left and the right side, a site may be said to be on the bottom or on the top although it is not. Then the place
    /// there that has the same u is meant, and compared with the other site, wherever that is or is said to be:
    /// 1. On every surface, a point or end of the bottom may be said to be on the top, and one of the top on the bottom.
    /// 2. Where bottom and top are identified, a point of the interior may be said to be on either.
    fn compare_sites(&self, traits: &G, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering;

    /// Tells which vertex without a point stands for each side, left, right, bottom and top; `None` for a side whose points are
    /// ordinary or identified. Such vertices are numbered from 0 in this order.
    ///
    /// A contracted side is a vertex; no predicate is asked of its point, even if the traits give one for ends there. Open sides that meet in corners are
    /// closed by one vertex together; where left and right are identified, or bottom and top, each open side is closed by its own.
    fn side_vertices(&self) -> [Option<u32>; 4] {
        let sides = self.sides();
        let is_one_infinity = !sides.is_u_identified() && !sides.is_v_identified();
        let (mut next, mut infinity) = (0, None);
        let mut fresh = || {
            next += 1;
            next - 1
        };
        [sides.u[0], sides.u[1], sides.v[0], sides.v[1]].map(|kind| match kind {
            SideKind::Closed | SideKind::Identified => None,
            SideKind::Open if is_one_infinity => Some(*infinity.get_or_insert_with(&mut fresh)),
            SideKind::Open | SideKind::Contracted => Some(fresh()),
        })
    }

    /// Gives the point to which a side is contracted, of left, right, bottom and top by their numbers; `None` if it is not. Only bottom and top
    /// may have one.
    ///
    /// With it, the vertex of the side is a vertex like others: it is counted if a curve comes to it or a point is given there, and can
    /// be located. Such a point lies in the left corner of its side, by [`Topology::point_location`], where [`Topology::compare_sites`]
    /// has it below all ends of curves in the lower corner, and above all in the upper one. The provided version knows no such points:
    /// then the vertex is only the place where curves end, as one at infinity is.
    fn contraction(&self, traits: &G, side: usize) -> Option<G::Point> {
        let _ = (traits, side);
        None
    }

    /// Tells the kind of a CCB, given how often it turns around: 1 to the left, -1 to the right, 0 not at all.
    ///
    /// One that turns to the right is the boundary of a hole. One that does not turn at all runs around the surface, and is an outer
    /// one, as are those through vertices that stand for open sides.
    fn ccb_kind(&self, turns: i64) -> CcbKind {
        if turns < 0 { CcbKind::Inner } else { CcbKind::Outer }
    }

    /// Tells whether a new edge that cuts one CCB of a face in two cuts the face in two. `has_outer_ccb` is of the face before, `turns`
    /// of one of the new CCBs.
    ///
    /// On a surface of genus 0 it always does. A face of a torus without an outer CCB is the whole torus but for its holes: it is cut
    /// only by a loop that can be contracted.
    fn splits_face(&self, has_outer_ccb: bool, turns: i64) -> bool {
        self.genus() == 0 || has_outer_ccb || turns != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::{LinearTraits, SegmentTraits, TorusSegmentTraits};

    #[test]
    fn sides_have_the_vertices_of_their_kinds() {
        let bounded = Topology::<SegmentTraits>::side_vertices(&BoundedPlane);
        assert_eq!(bounded, [None; 4]);
        let unbounded = Topology::<LinearTraits>::side_vertices(&UnboundedPlane);
        assert_eq!(unbounded, [Some(0); 4], "one vertex at infinity");
        assert_eq!(Topology::<TorusSegmentTraits>::side_vertices(&FlatTorus), [None; 4]);
    }

    #[test]
    fn the_first_loop_around_a_torus_splits_nothing() {
        let splits =
            |has_outer, turns| Topology::<TorusSegmentTraits>::splits_face(&FlatTorus, has_outer, turns);
        assert!(!splits(false, 0), "the first loop around");
        assert!(splits(false, 1) && splits(false, -1), "a small loop");
        assert!(splits(true, 0), "a second loop around, beside the first");
        assert!(Topology::<SegmentTraits>::splits_face(&BoundedPlane, false, 1));
    }
}
