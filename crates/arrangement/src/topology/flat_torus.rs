//! A rectangle whose opposite sides are glued together.

use super::{Site, Topology};
use crate::traits::{Along, CurveEnd, IdentifiedBottomTopTraits, IdentifiedLeftRightTraits, Location, Sides};
use std::cmp::Ordering;

/// A flat torus: left and right, bottom and top of a rectangle are identified. How wide and how high the rectangle is, the
/// geometry traits know.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct FlatTorus;

impl<G: IdentifiedLeftRightTraits + IdentifiedBottomTopTraits> Topology<G> for FlatTorus {
    #[inline]
    fn sides(&self) -> Sides {
        Sides::TORUS
    }

    #[inline]
    fn genus(&self) -> u32 {
        1
    }

    #[inline]
    fn end_location(&self, traits: &G, curve: &G::UMonotoneCurve, end: CurveEnd) -> Location {
        traits.end_location(curve, end)
    }

    #[inline]
    fn point_location(&self, traits: &G, point: &G::Point) -> Location {
        let low = |is_low| if is_low { Along::Low } else { Along::Inside };
        Location { u: low(traits.is_on_left_right(point)), v: low(traits.is_on_bottom_top(point)) }
    }

    fn compare_sites(&self, traits: &G, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
        let (Some(p), Some(q)) = (a.point(), b.point()) else {
            unreachable!("a curve on a torus has two end points")
        };
        if a.location.is_interior() && b.location.is_interior() {
            return traits.compare_uv(p, q);
        }
        let by_side = a.location.u.cmp(&b.location.u);
        if by_side.is_ne() {
            return by_side;
        }
        let by_v_side = || a.location.v.cmp(&b.location.v);
        if a.location.u == Along::Inside {
            let by_u = if a.location.v == Along::Inside && b.location.v == Along::Inside {
                traits.compare_uv(p, q)
            } else {
                traits.compare_u_on_bottom_top(p, q)
            };
            return by_u.then_with(by_v_side);
        }
        by_v_side().then_with(|| match a.location.v {
            Along::Inside => traits.compare_v_on_left_right(p, q),
            Along::Low | Along::High => Ordering::Equal,
        })
    }
}
