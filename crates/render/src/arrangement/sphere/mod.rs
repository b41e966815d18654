//! Pictures of arrangements on a sphere.
//!
//! | module | role |
//! |---|---|
//! | `outline` | edges as chains of points in the parameter space |
//! | `rim` | what is shown of a face, closed along the rim of what is shown |
//! | `unfolded` | the parameter space, a rectangle |
//! | `view` | where points of the sphere are seen |
//! | `disc` | a hemisphere, and what is seen of it |
//! | `globe` | two hemispheres |
//!
//! Both pictures cut CCBs at the rim of a rectangle or of a disc. Every CCB has its face on the left, so the parts that are left are
//! closed along the rim, counterclockwise; whether a CCB is an outer one does not matter. If no edge meets the rim, it belongs to
//! one face: that on whose CCBs the area to the left is the least, because it is negative for this face, and positive for others.

mod disc;
mod globe;
mod outline;
mod rim;
mod unfolded;
mod view;

pub(super) use unfolded::scene as unfolded_scene;
pub use view::GlobeOptions;

use ::arrangement::Arrangement;
use ::arrangement::topology::Topology;
use ::arrangement::traits::{Along, ApproxTraits, SideKind, Sides};
use dcel::FaceId;
use outline::SIDES;
use rim::Boundary;

/// Whether these are the sides of the parameter space of a sphere.
pub(super) fn is_sphere(sides: &Sides) -> bool {
    sides.is_u_identified() && sides.v == [SideKind::Contracted; 2]
}

/// Whether a vertex that is no pole has the latitude of one, as far as doubles can tell.
fn is_collapsed<G: ApproxTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>) -> bool {
    let [_, [bottom, top]] = SIDES;
    arrangement.vertices().filter_map(|v| arrangement.point(v)).any(|point| {
        let [_, height] = arrangement.traits().approx_point(point);
        let location = arrangement.topology().point_location(arrangement.traits(), point);
        location.v == Along::Inside && !(bottom < height && height < top)
    })
}

/// The face to which the rim belongs; `None` if edges meet it.
fn rim_face<'a>(boundaries: impl Iterator<Item = (FaceId, &'a [Boundary])>) -> Option<FaceId> {
    let mut least: Option<(f64, FaceId)> = None;
    for (f, boundaries) in boundaries {
        if boundaries.iter().any(|boundary| !boundary.chains.is_empty()) {
            return None;
        }
        let area = boundaries.iter().map(Boundary::loop_area).sum();
        if least.is_none_or(|(least, _)| area < least) {
            least = Some((area, f));
        }
    }
    least.map(|(_, f)| f)
}
