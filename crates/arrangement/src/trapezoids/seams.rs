//! Trapezoids that are next to one another across identified sides.
//!
//! The walls that end on a side cut it into intervals, and so do those on the opposite side. Two trapezoids are next to one another
//! across the seam if their intervals meet, which may be so for many. But an interval ends only where a vertex is, and there the walk
//! goes on as it does within the parameter space:
//!
//! - Where a vertex has a site on one of the two sides only, the opposite trapezoid reaches past it. So the intervals before and behind
//!   the vertex are connected there: the wall that is not on the surface is no obstacle. That site is the one at home, on the bottom
//!   or left side.
//! - Where a vertex has sites on both sides, the intervals behind it meet.
//! - The first intervals of both sides meet.
//!
//! So each trapezoid has few neighbours, and a search has to be made for the first intervals only.

use super::structure::{Comparison, Step};
use super::{Side, SiteId, TrapezoidId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::{Along, BasicTraits, Location};

const LEFT: Location = Location { u: Along::Low, v: Along::Inside };
const RIGHT: Location = Location { u: Along::High, v: Along::Inside };
const BOTTOM: Location = Location { u: Along::Inside, v: Along::Low };
const TOP: Location = Location { u: Along::Inside, v: Along::High };

/// Whether one may step from left to right past a site within the parameter space: below and above it. On a side only one of the walls
/// is there.
#[inline]
pub(super) fn is_open(location: Location) -> [bool; 2] {
    match (location.u, location.v) {
        (Along::Low, _) => [true, false],
        (Along::High, _) => [false, true],
        (_, Along::Low) => [false, true],
        (_, Along::High) => [true, false],
        _ => [true, true],
    }
}

impl<G: BasicTraits> Trapezoids<G> {
    /// Whether one may step from left to right past a site, below and above it, on the surface.
    ///
    /// A site on an identified side is no obstacle to those who pass it on the far side, if its vertex has no site there.
    #[inline]
    pub(super) fn is_open_across<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        site: SiteId,
    ) -> [bool; 2] {
        let location = self.location(site);
        let mut is_open = is_open(location);
        if location == BOTTOM && arrangement.topology().sides().is_v_identified() {
            is_open[0] = self.opposite(site, TOP).is_none();
        } else if location == LEFT && arrangement.topology().sides().is_u_identified() {
            is_open[1] = self.opposite(site, RIGHT).is_none();
        }
        is_open
    }

    /// The site of the same vertex at another location.
    fn opposite(&self, site: SiteId, location: Location) -> Option<SiteId> {
        self.site_at(self.vertex(site), location)
    }

    /// Appends the trapezoids that are next to one across identified sides, and are not found past a wall.
    ///
    /// # Complexity
    /// Constant; that of a search for the first trapezoids along a seam.
    pub(super) fn across_seams<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        t: TrapezoidId,
        out: &mut Vec<TrapezoidId>,
    ) {
        let sides = arrangement.topology().sides();
        if !sides.is_u_identified() && !sides.is_v_identified() {
            return;
        }
        out.extend(self.behind_both_sites(t, sides.is_u_identified(), sides.is_v_identified()));
        if sides.is_u_identified() {
            if self.is_lowest_left(t) {
                out.push(self.descend(|place| place.u != Along::High || place.v == Along::Low, Side::Below));
            }
            if self.is_lowest_right(t) {
                out.push(self.descend(|place| place.u == Along::Low && place.v == Along::Low, Side::Above));
            }
        }
        if sides.is_v_identified() && self.is_behind_left_side(t) {
            let trapezoid = self.trapezoid(t);
            for side in [Side::Below, Side::Above] {
                if trapezoid.rail(side).is_none() {
                    out.push(self.descend(|place| place.u == Along::Low, side.opposite()));
                }
            }
        }
    }

    /// The trapezoid across a seam behind a vertex with sites on both sides, if the trapezoid given is the one on this side.
    fn behind_both_sites(&self, t: TrapezoidId, is_u: bool, is_v: bool) -> Option<TrapezoidId> {
        let left = self.trapezoid(t).left;
        if left.is_none() {
            return None;
        }
        let [below, above] = self.right_of(left);
        // Along the left and right side, what is behind a site is above what begins there.
        let (opposite, wall) = match self.location(left) {
            BOTTOM if is_v && t == below => (TOP, 1),
            TOP if is_v && t == above => (BOTTOM, 0),
            LEFT if is_u && t == above => (RIGHT, 1),
            RIGHT if is_u && t == above => (LEFT, 1),
            _ => return None,
        };
        Some(self.right_of(self.opposite(left, opposite)?)[wall])
    }

    /// Where a site is along both axes; `None` for the sides of the parameter space.
    fn place_along(&self, site: SiteId) -> Option<Location> {
        (!site.is_none()).then(|| self.location(site))
    }

    /// Whether a trapezoid touches the lowest interval of the left side.
    fn is_lowest_left(&self, t: TrapezoidId) -> bool {
        let trapezoid = self.trapezoid(t);
        let is_corner = |place: Location| place.u == Along::Low && place.v == Along::Low;
        // Where the bottom is not identified, there may be several ends in the corner: the interval is above the last.
        if self.place_along(trapezoid.right).is_some_and(is_corner) {
            return false;
        }
        self.place_along(trapezoid.left)
            .is_none_or(|place| is_corner(place) && self.right_of(trapezoid.left)[1] == t)
    }

    /// Whether a trapezoid touches the lowest interval of the right side.
    fn is_lowest_right(&self, t: TrapezoidId) -> bool {
        let trapezoid = self.trapezoid(t);
        let is_corner = |place: Location| place.u == Along::High && place.v == Along::Low;
        let right = self.place_along(trapezoid.right);
        if right.is_some_and(is_corner) {
            return false;
        }
        match self.place_along(trapezoid.left) {
            Some(place) if place.u == Along::High => is_corner(place),
            _ => right.is_none_or(|place| place.u == Along::High && self.left_of(trapezoid.right)[0] == t),
        }
    }

    /// Whether a trapezoid begins on the left side, and is more than a piece of it.
    fn is_behind_left_side(&self, t: TrapezoidId) -> bool {
        let trapezoid = self.trapezoid(t);
        let is_low = |site| self.place_along(site).is_some_and(|place| place.u == Along::Low);
        (trapezoid.left.is_none() || is_low(trapezoid.left)) && !is_low(trapezoid.right)
    }

    /// Finds the trapezoid of a place on a side, which is behind the sites told by their location, and on one side of all curves.
    fn descend(&self, is_behind: impl Fn(Location) -> bool, side: Side) -> TrapezoidId {
        let mut branch = self.structure.root();
        loop {
            let node = match self.structure.at(branch, &self.trapezoids) {
                Step::End(t) => return t,
                Step::Node(node) => node,
            };
            branch = node.branches()[match node.comparison() {
                Comparison::Site(site, _) => usize::from(is_behind(self.location(site))),
                Comparison::Curve(..) => side as usize,
            }];
        }
    }
}
