//! The sphere, by longitude and latitude.

use super::{Site, SiteAt, Topology};
use crate::traits::{
    Along, ContractedBottomTopTraits, CurveEnd, IdentifiedLeftRightTraits, Location, NearLeftRightTraits,
    SideKind, Sides,
};
use std::cmp::Ordering;

/// A sphere: left and right of the parameter space are identified, bottom and top are contracted to its poles.
///
/// The vertices 0 and 1 of every arrangement are the south and the north pole, whether anything
/// [is there](crate::Arrangement::is_absent) or not.
///
/// # References
/// Thesis, section 2.6, `Arr_spherical_topology_traits_2`; surfaces paper, section 2.1.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Sphere;

/// Where each pole is said to be, south and north: in the left corner.
const POLES: [Location; 2] =
    [Location { u: Along::Low, v: Along::Low }, Location { u: Along::Low, v: Along::High }];

impl<G: IdentifiedLeftRightTraits + NearLeftRightTraits + ContractedBottomTopTraits> Topology<G> for Sphere {
    #[inline]
    fn sides(&self) -> Sides {
        Sides { u: [SideKind::Identified; 2], v: [SideKind::Contracted; 2] }
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
    fn point_location(&self, traits: &G, point: &G::Point) -> Location {
        match traits.contracted_bottom_top(point) {
            Some(CurveEnd::Min) => POLES[0],
            Some(CurveEnd::Max) => POLES[1],
            None if traits.is_on_left_right(point) => Location { u: Along::Low, v: Along::Inside },
            None => Location::INTERIOR,
        }
    }

    fn contraction(&self, traits: &G, side: usize) -> Option<G::Point> {
        [None, None, Some(CurveEnd::Min), Some(CurveEnd::Max)][side]
            .map(|end| traits.contraction_bottom_top(end))
    }

    #[inline]
    fn compare_sites(&self, traits: &G, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
        let (here, there) = (a.location, b.location);
        if let (true, true, SiteAt::Point(p), SiteAt::Point(q)) =
            (here.is_interior(), there.is_interior(), a.at, b.at)
        {
            return traits.compare_uv(p, q);
        }
        here.u.cmp(&there.u).then_with(|| {
            if here.u == Along::Inside { compare_inside(traits, a, b) } else { compare_on_side(traits, a, b) }
        })
    }
}

/// Two sites on the left side, or on the right one: in a corner is a pole, or the end of a curve along the side.
fn compare_on_side<G: IdentifiedLeftRightTraits + NearLeftRightTraits>(
    traits: &G,
    a: &Site<'_, G>,
    b: &Site<'_, G>,
) -> Ordering {
    a.location.v.cmp(&b.location.v).then_with(|| match (a.at, b.at) {
        (SiteAt::Point(p), SiteAt::Point(q)) if a.location.v == Along::Inside => {
            traits.compare_v_on_left_right(p, q)
        }
        (SiteAt::Point(_), SiteAt::Point(_)) => Ordering::Equal,
        (SiteAt::End(curve, end), SiteAt::End(other, _)) => traits.compare_v_near_side(curve, other, end),
        (SiteAt::Point(_), SiteAt::End(..)) => outward(a.location),
        (SiteAt::End(..), SiteAt::Point(_)) => outward(a.location).reverse(),
    })
}

/// How a pole in a corner is compared with ends there: it is further out.
fn outward(corner: Location) -> Ordering {
    if corner.v == Along::Low { Ordering::Less } else { Ordering::Greater }
}

/// Two sites between left and right, of which one may be on the bottom or top, or be said to be there.
fn compare_inside<G: ContractedBottomTopTraits>(traits: &G, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
    let by_u = match (a.at, b.at) {
        (SiteAt::Point(p), SiteAt::Point(q)) => traits.compare_u(p, q),
        (SiteAt::Point(p), SiteAt::End(curve, end)) => traits.compare_u_near_end(p, curve, end),
        (SiteAt::End(curve, end), SiteAt::Point(p)) => traits.compare_u_near_end(p, curve, end).reverse(),
        (SiteAt::End(curve, end), SiteAt::End(other, other_end)) => {
            traits.compare_u_of_ends((curve, end), (other, other_end))
        }
    };
    by_u.then_with(|| a.location.v.cmp(&b.location.v))
}
