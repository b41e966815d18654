//! The whole plane, with curves that may be unbounded.

use super::{Site, SiteAt, Topology};
use crate::traits::{Along, CurveEnd, Location, OpenBottomTopTraits, OpenLeftRightTraits, Sides};
use std::cmp::Ordering;

/// The whole plane. All unbounded curve ends meet in one vertex at infinity, which closes the plane to a sphere, so that there
/// may be many unbounded faces and no edge is invented.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct UnboundedPlane;

impl<G: OpenLeftRightTraits + OpenBottomTopTraits> Topology<G> for UnboundedPlane {
    #[inline]
    fn sides(&self) -> Sides {
        Sides::OPEN
    }

    #[inline]
    fn genus(&self) -> u32 {
        0
    }

    #[inline]
    fn end_location(&self, traits: &G, curve: &G::UMonotoneCurve, end: CurveEnd) -> Location {
        traits.end_location(curve, end)
    }

    #[inline]
    fn point_location(&self, _: &G, _: &G::Point) -> Location {
        Location::INTERIOR
    }

    #[inline]
    fn compare_sites(&self, traits: &G, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
        if let (SiteAt::Point(p), SiteAt::Point(q)) = (a.at, b.at) {
            return traits.compare_uv(p, q);
        }
        a.location.u.cmp(&b.location.u).then_with(|| compare_ends(traits, a, b))
    }
}

/// Two sites of one location along u, of which at least one has no point.
fn compare_ends<G: OpenLeftRightTraits + OpenBottomTopTraits>(
    traits: &G,
    a: &Site<'_, G>,
    b: &Site<'_, G>,
) -> Ordering {
    let by_u = match (a.at, b.at) {
        (SiteAt::End(curve_a, end), SiteAt::End(curve_b, _)) if a.location.u != Along::Inside => {
            return traits.compare_v_near_side(curve_a, curve_b, end);
        }
        (SiteAt::End(curve_a, end_a), SiteAt::End(curve_b, end_b)) => {
            traits.compare_u_of_ends((curve_a, end_a), (curve_b, end_b))
        }
        (SiteAt::Point(p), SiteAt::End(curve, end)) => traits.compare_u_near_end(p, curve, end),
        (SiteAt::End(curve, end), SiteAt::Point(p)) => traits.compare_u_near_end(p, curve, end).reverse(),
        (SiteAt::Point(p), SiteAt::Point(q)) => traits.compare_u(p, q),
    };
    by_u.then_with(|| a.location.v.cmp(&b.location.v))
}
