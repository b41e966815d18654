//! The plane with curves that do not leave a bounded part of it.

use super::{Site, Topology};
use crate::traits::{BoundedTraits, CurveEnd, Location, Sides};
use std::cmp::Ordering;

/// The plane, for curves that have two end points. There is one unbounded face.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct BoundedPlane;

impl<G: BoundedTraits> Topology<G> for BoundedPlane {
    #[inline]
    fn sides(&self) -> Sides {
        Sides::CLOSED
    }

    #[inline]
    fn genus(&self) -> u32 {
        0
    }

    #[inline]
    fn end_location(&self, _: &G, _: &G::UMonotoneCurve, _: CurveEnd) -> Location {
        Location::INTERIOR
    }

    #[inline]
    fn point_location(&self, _: &G, _: &G::Point) -> Location {
        Location::INTERIOR
    }

    #[inline]
    fn compare_sites(&self, traits: &G, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
        let (Some(p), Some(q)) = (a.point(), b.point()) else {
            unreachable!("a curve in the bounded plane has two end points")
        };
        traits.compare_uv(p, q)
    }
}
