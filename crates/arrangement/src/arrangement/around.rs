//! The order of halfedges around a vertex, as the geometry has it.

use super::Arrangement;
use crate::topology::{Site, SiteAt, Topology};
use crate::traits::{Along, BasicTraits, CurveEnd, Location, UMonotoneTraits};
use dcel::{HalfedgeId, VertexId};
use std::borrow::Cow;
use std::cmp::Ordering;

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// The end of the edge of a halfedge at which the halfedge begins.
    pub(crate) fn end_of(h: HalfedgeId) -> CurveEnd {
        if h.is_even() { CurveEnd::Min } else { CurveEnd::Max }
    }

    /// The place in the parameter space where a halfedge begins.
    ///
    /// On an identification that is where its support ends, if it ends there, and else the low side, because only a curve along a side
    /// has interior points on it.
    pub(crate) fn start_site(&self, h: HalfedgeId) -> Site<'_, G> {
        let (curve, end) = (self.curve_of(h.edge_id()), Self::end_of(h));
        let end_location = || self.topology.end_location(&self.traits, curve, end);
        let Some(point) = self.inner_point(self.dcel.source(h)) else {
            return Site { location: end_location(), at: SiteAt::End(curve, end) };
        };
        let low = self.topology.point_location(&self.traits, point);
        let ends_here = || {
            let end_point = self.traits.end_point(curve, end);
            end_point.is_some_and(|end_point| self.traits.is_same_point(end_point, point))
        };
        let location = if low.is_interior() || !ends_here() { low } else { end_location() };
        Site { location, at: SiteAt::Point(point) }
    }

    /// Compares two halfedges that leave a vertex in counterclockwise order.
    ///
    /// The order begins after the direction straight down, at a vertex that stands for sides of the parameter space at the lower
    /// right corner. `Equal` means that the halfedges overlap.
    pub(crate) fn compare_around(&self, a: HalfedgeId, b: HalfedgeId) -> Ordering {
        self.compare_rays(&self.ray(a), &self.ray(b))
    }

    /// How a halfedge leaves its source.
    pub(crate) fn ray(&self, h: HalfedgeId) -> Ray<'_, G> {
        let curve = if h.is_even() || G::MEET_ONCE {
            Cow::Borrowed(self.curve_of(h.edge_id()))
        } else {
            // Supports may meet to the left of here; edges do not.
            Cow::Owned(self.make_edge_curve(h.edge_id()))
        };
        Ray { site: self.start_site(h), curve, is_even: h.is_even() }
    }

    /// Compares how two halfedges leave one vertex: see [`Arrangement::compare_around`].
    pub(crate) fn compare_rays(&self, a: &Ray<'_, G>, b: &Ray<'_, G>) -> Ordering {
        let Some(point) = a.site.point() else { return self.compare_ends(&a.site, &b.site) };
        a.sector().cmp(&b.sector()).then_with(|| {
            if a.is_even {
                self.traits.compare_v_at_u_right(&a.curve, &b.curve, point)
            } else {
                self.traits.compare_v_at_u_left(&b.curve, &a.curve, point)
            }
        })
    }
}

impl<G: BasicTraits, T: Topology<G>> Arrangement<G, T> {
    /// Compares two ends at one vertex without a point, counterclockwise around it: along the sides clockwise.
    pub(crate) fn compare_ends(&self, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
        let sector = |site: &Site<'_, G>| match site.location {
            Location { u: Along::High, .. } => 3,
            Location { u: Along::Low, .. } => 1,
            Location { v: Along::High, .. } => 2,
            _ => 0,
        };
        sector(a).cmp(&sector(b)).then_with(|| {
            let order = self.topology.compare_sites(&self.traits, a, b);
            if matches!(sector(a), 0 | 3) { order.reverse() } else { order }
        })
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// The halfedges that leave a vertex, in the order of [`Arrangement::compare_around`].
    pub(super) fn sorted_around(&self, v: VertexId) -> Vec<HalfedgeId> {
        let mut around: Vec<HalfedgeId> = self.dcel.around(v).collect();
        around.sort_by(|&a, &b| self.compare_around(a, b));
        around
    }
}

/// How a halfedge leaves its source.
#[derive(Debug)]
pub(crate) struct Ray<'a, G: UMonotoneTraits> {
    /// Where that is.
    pub(crate) site: Site<'a, G>,
    /// The curve. If curves may meet more than once, one that leaves to the left ends where the halfedge does.
    pub(crate) curve: Cow<'a, G::UMonotoneCurve>,
    /// Whether it leaves to the right.
    pub(crate) is_even: bool,
}

impl<G: UMonotoneTraits> Ray<'_, G> {
    /// The directions of one kind at a point, counterclockwise.
    fn sector(&self) -> u32 {
        match (self.is_even, self.site.location) {
            (true, Location { v: Along::High, .. }) => 0,
            (true, _) => 1,
            (false, Location { u: Along::Low, .. }) => 4,
            (false, Location { v: Along::High, .. }) => 3,
            (false, _) => 2,
        }
    }
}
