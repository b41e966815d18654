//! What a curve does next, from a place on it.

use crate::arrangement::Arrangement;
use crate::topology::{Site, Topology, ends_on_side};
use crate::traits::{Along, BasicTraits, CurveEnd, Location, UMonotoneTraits};
use crate::trapezoids::{RailId, SiteId, TrapezoidId, Trapezoids, compare_right};
use dcel::VertexId;

/// On what a curve is at a place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum On {
    /// A site.
    Site(SiteId),
    /// The interior of a rail.
    Rail(RailId),
    /// Neither: it goes on through a face.
    Face,
}

/// What a curve does next.
#[derive(Clone, Debug)]
pub(crate) enum Next<P> {
    /// It runs along a rail to its end, or to a point of its interior.
    Along(RailId, Option<P>),
    /// It runs through a face.
    Through,
}

/// Looks what a curve does from a place on it, which it leaves in the trapezoid `first`: in the one above, if it runs along a rail.
pub(crate) fn next<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    trapezoids: &Trapezoids<G>,
    curve: &G::UMonotoneCurve,
    (place, on): (&Site<'_, G>, On),
    first: TrapezoidId,
) -> Next<G::Point> {
    let below = trapezoids.trapezoid(first).below;
    let may_be_along = !below.is_none()
        && match on {
            On::Site(site) => trapezoids.rail(below).ends[0] == site,
            On::Rail(rail) => below == rail,
            On::Face => false,
        };
    let support = || &arrangement.curves()[trapezoids.rail(below).curve as usize];
    if may_be_along && compare_right(arrangement, curve, support(), place).is_eq() {
        return Next::Along(below, parting(arrangement, trapezoids, curve, below, place));
    }
    Next::Through
}

/// Where in the interior of a rail a curve that runs along it from a place on parts from it or ends; `None` if it runs to the end of the
/// rail.
fn parting<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    trapezoids: &Trapezoids<G>,
    curve: &G::UMonotoneCurve,
    rail: RailId,
    start: &Site<'_, G>,
) -> Option<G::Point> {
    let (traits, topology) = (arrangement.traits(), arrangement.topology());
    let rail = trapezoids.rail(rail);
    let max = trapezoids.place(arrangement, rail.ends[1]);
    let end = Site::of_end(topology, traits, curve, CurveEnd::Max);
    let is_before = |place: &Site<'_, G>| topology.compare_sites(traits, place, &max).is_lt();
    let end = end.point().filter(|_| is_before(&end)).cloned();
    if G::MEET_ONCE {
        return end;
    }
    let other = &arrangement.curves()[rail.curve as usize];
    let is_ahead = |point: &G::Point| {
        // On a side curves end, and what ends is asked above. The point of a contracted side is not told apart by where it is.
        let parting = Site::of_point(topology, traits, point);
        parting.location.is_interior()
            && ![curve, other].into_iter().any(|curve| ends_on_side(topology, traits, curve, point))
            && topology.compare_sites(traits, start, &parting).is_lt()
            && is_before(&parting)
    };
    let parting = traits.end_of_overlap(curve, other, start.point());
    parting.filter(is_ahead).or(end)
}

/// The vertex that stands for the side on which a place lies, if one does.
pub(crate) fn side_vertex<G: BasicTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    location: Location,
) -> Option<VertexId> {
    let [left, right, bottom, top] = arrangement.topology().side_vertices();
    let of = |along, low, high| match along {
        Along::Low => low,
        Along::Inside => None,
        Along::High => high,
    };
    of(location.v, bottom, top).or(of(location.u, left, right)).map(VertexId)
}
