//! After which halfedges a new one comes, around its vertices.

use super::Editor;
use crate::arrangement::around::Ray;
use crate::edit::Observer;
use crate::topology::Topology;
use crate::traits::{CurveEnd, UMonotoneTraits};
use crate::trapezoids::{NewRail, RailId, SiteId};
use dcel::{HalfedgeId, VertexId};
use std::borrow::Cow;

/// After which halfedges the two halves of a new edge come.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corners {
    pub(super) prevs: [Option<HalfedgeId>; 2],
    /// If both are one corner: whether the even half comes before the odd one, clockwise.
    pub(super) is_reversed: bool,
}

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Finds the corners in which a new edge, whose rail is there, begins and ends.
    ///
    /// # Complexity
    /// Constant at a vertex in the interior of the parameter space, logarithmic in its degree at one that stands for sides, linear at one
    /// on an identified side.
    pub(super) fn corners(&self, new: &NewRail, vertices: [VertexId; 2]) -> Corners {
        let sites = self.trapezoids.rail(new.rail).ends;
        let mut is_reversed = false;
        let prevs = [0, 1].map(|i| {
            if self.arrangement.stands_for_side(vertices[i]) {
                let corner = self.trapezoids.corner_at_end(&self.arrangement, new.rail, sites[i])?;
                is_reversed |= i == 0 && !corner.is_other_between;
                return Some(corner.next.twin());
            }
            match (self.trapezoids.location(sites[i]).is_interior(), i) {
                (true, 0) => self.corner_at_start(new),
                (true, _) => self.corner_at_end(new),
                (false, _) => self.corner_around(new.rail, vertices[i], i),
            }
        });
        let is_one_corner = vertices[0] == vertices[1] && prevs[0].is_some() && prevs[0] == prevs[1];
        if is_one_corner && !self.arrangement.stands_for_side(vertices[0]) {
            is_reversed = self.is_reversed_loop(new.rail, vertices[0]);
        }
        Corners { prevs, is_reversed: is_one_corner && is_reversed }
    }

    /// A halfedge of a rail.
    fn halfedge(&self, rail: RailId) -> HalfedgeId {
        self.trapezoids.rail(rail).edge.halfedge()
    }

    /// The rail, if it has the end given at a site.
    fn if_at(&self, rail: RailId, end: CurveEnd, site: SiteId) -> Option<RailId> {
        (!rail.is_none() && self.trapezoids.rail(rail).ends[end as usize] == site).then_some(rail)
    }

    /// The corner counterclockwise before the even half: the next halfedge above it, or the highest one to the left, or the lowest one
    /// to the right.
    fn corner_at_start(&self, new: &NewRail) -> Option<HalfedgeId> {
        let trapezoids = &self.trapezoids;
        let site = trapezoids.rail(new.rail).ends[0];
        let above = trapezoids.trapezoid(new.first[1]).above;
        if let Some(rail) = self.if_at(above, CurveEnd::Min, site) {
            return Some(self.halfedge(rail).twin());
        }
        let highest_left = trapezoids.trapezoid(trapezoids.left_of(site)[1]).below;
        if let Some(rail) = self.if_at(highest_left, CurveEnd::Max, site) {
            return Some(self.halfedge(rail));
        }
        let lowest_right = trapezoids.trapezoid(trapezoids.right_of(site)[0]).above;
        (lowest_right != new.rail).then(|| self.halfedge(lowest_right).twin())
    }

    /// The corner counterclockwise before the odd half: the next halfedge below it, or the lowest one to the right, or the highest one
    /// to the left.
    fn corner_at_end(&self, new: &NewRail) -> Option<HalfedgeId> {
        let trapezoids = &self.trapezoids;
        let site = trapezoids.rail(new.rail).ends[1];
        let below = trapezoids.trapezoid(new.last[0]).below;
        if let Some(rail) = self.if_at(below, CurveEnd::Max, site) {
            return Some(self.halfedge(rail));
        }
        let lowest_right = trapezoids.trapezoid(trapezoids.right_of(site)[0]).above;
        if let Some(rail) = self.if_at(lowest_right, CurveEnd::Min, site) {
            return Some(self.halfedge(rail).twin());
        }
        let highest_left = trapezoids.trapezoid(trapezoids.left_of(site)[1]).below;
        (highest_left != new.rail).then(|| self.halfedge(highest_left))
    }

    /// How a half of a new edge leaves its vertex: the even one (0) or the odd one.
    fn new_ray(&self, rail: RailId, half: usize) -> Ray<'_, G> {
        let rail = self.trapezoids.rail(rail);
        let curve = &self.arrangement.curves()[rail.curve as usize];
        let sites = rail.ends.map(|site| self.trapezoids.place(&self.arrangement, site));
        let curve = if half == 0 || G::MEET_ONCE {
            Cow::Borrowed(curve)
        } else {
            let [min, max] = sites.map(|site| site.point());
            Cow::Owned(self.arrangement.traits().trim(curve, min, max))
        };
        Ray { site: sites[half], curve, is_even: half == 0 }
    }

    /// The corner in which a half of a new edge lies, found by comparing all directions.
    fn corner_around(&self, rail: RailId, v: VertexId, half: usize) -> Option<HalfedgeId> {
        let (arrangement, dcel) = (&self.arrangement, self.arrangement.dcel());
        let new = self.new_ray(rail, half);
        let is_greater = |h: HalfedgeId| arrangement.compare_rays(&arrangement.ray(h), &new).is_gt();
        let mut was_greater = is_greater(dcel.next(dcel.outgoing(v)?.twin()));
        let first = dcel.around(v).find(|&h| {
            let is = is_greater(h);
            !std::mem::replace(&mut was_greater, is) && is
        });
        // If the new one is less or greater than all, the least comes next.
        let next = first.or_else(|| dcel.around(v).min_by(|&g, &h| arrangement.compare_around(g, h)));
        next.map(HalfedgeId::twin)
    }

    /// Of a loop in one corner: whether the even half comes before the odd one, clockwise.
    fn is_reversed_loop(&self, rail: RailId, v: VertexId) -> bool {
        let arrangement = &self.arrangement;
        let halves = [0, 1].map(|half| self.new_ray(rail, half));
        let is_greatest = |new: &Ray<'_, G>| {
            arrangement.dcel().around(v).all(|h| arrangement.compare_rays(&arrangement.ray(h), new).is_lt())
        };
        let is_even_first = match halves.each_ref().map(is_greatest) {
            // The order begins anew between the two.
            [true, false] => true,
            [false, true] => false,
            _ => arrangement.compare_rays(&halves[0], &halves[1]).is_lt(),
        };
        !is_even_first
    }
}
