//! The topology traits: what depends on the surface, and on nothing else.
//!
//! | topology | sides | curves it can carry | genus |
//! |---|---|---|---|
//! | [`BoundedPlane`] | closed | all that have two end points | 0 |
//! | [`UnboundedPlane`] | open | those that are open left, right, below and above | 0 |
//! | [`FlatTorus`] | both pairs identified | those that are identified left to right and bottom to top | 1 |

mod bounded_plane;
mod flat_torus;
mod site;
mod unbounded_plane;

pub use bounded_plane::BoundedPlane;
pub use flat_torus::FlatTorus;
pub use site::{Site, SiteAt};
pub use unbounded_plane::UnboundedPlane;

use crate::traits::{BasicTraits, CurveEnd, Location, Sides};
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
    fn compare_sites(&self, traits: &G, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering;
}
