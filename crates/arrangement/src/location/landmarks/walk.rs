//! From a trapezoid to the place that is looked for.

use super::index::Start;
use crate::arrangement::Arrangement;
use crate::decomposition::{SiteId, TrapezoidId, VerticalDecomposition};
use crate::topology::{Site, SiteAt, Topology};
use crate::traits::{Along, ApproxTraits, BasicTraits, CurveEnd, UMonotoneTraits};
use crate::trapezoids::side;
use dcel::EdgeId;
use std::cmp::Ordering;

/// Where a place is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Spot {
    /// At a site.
    Site(SiteId),
    /// On an edge, in its interior, behind as many sites.
    Edge(EdgeId, u32),
    /// Within a trapezoid, or on one of its walls.
    Inside(TrapezoidId),
}

/// A vertical decomposition in which one walks.
///
/// A walk has three steps.
///
/// 1. The *rank* of the place, which is the number of sites before it, is found by bisection, since sites are numbered in their order. If a
///    site is there, that is all.
/// 2. *Along u*: as long as the right site of the trapezoid is before the place, the walk goes on to a trapezoid that begins at it,
///    below or above; likewise to the left. That compares numbers, and ends: the right site of a trapezoid is behind its left one,
///    so each step has a greater one than the last, or to the left a lesser one. Now the place is between the walls of the trapezoid.
/// 3. *Along v*: as long as the place is above the upper edge, the walk goes on to the trapezoid over it that has the rank between its
///    walls, which bisection finds along the edge; or likewise down. That ends too: trapezoids with the rank between their
///    walls lie one above the other, and the walk meets none twice.
///
/// Only steps 1 and 3 ask predicates: O(log n) comparisons of places, at most one for each site whose key does not decide; and one with each
/// edge that is crossed along v, and the next. Whether a step along u goes below or above is guessed by floats, and what was
/// guessed badly, step 3 crosses back.
///
/// Where the walk starts, and what floats say, is of no importance for the answer: the place is in one trapezoid only, or on
/// its boundary.
#[derive(Clone, Debug)]
pub(super) struct Ground {
    pub(super) decomposition: VerticalDecomposition,
    /// The [order key](BasicTraits::order_key) of each site that is a point in the interior of the parameter space; 0 for others.
    keys: Vec<u64>,
    /// About which v each site has: for guesses.
    heights: Vec<f64>,
}

impl Ground {
    pub(super) fn new<G: UMonotoneTraits + ApproxTraits, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
    ) -> Self {
        let traits = arrangement.traits();
        let decomposition = VerticalDecomposition::new(arrangement);
        let (mut keys, mut heights) = (Vec::new(), Vec::new());
        for site in decomposition.sites() {
            let location = decomposition.location(site);
            let point = arrangement.inner_point(decomposition.vertex(site));
            keys.push(point.filter(|_| location.is_interior()).map_or(0, |point| traits.order_key(point)));
            heights.push(match (location.v, point) {
                (Along::Low, _) => f64::NEG_INFINITY,
                (Along::High, _) => f64::INFINITY,
                (Along::Inside, Some(point)) => traits.approx_point(point)[1],
                (Along::Inside, None) => 0.0,
            });
        }
        Self { decomposition, keys, heights }
    }

    /// Where a site is.
    pub(super) fn place<'a, G: BasicTraits, T: Topology<G>>(
        &self,
        arrangement: &'a Arrangement<G, T>,
        site: SiteId,
    ) -> Site<'a, G> {
        let location = self.decomposition.location(site);
        let at = arrangement.inner_point(self.decomposition.vertex(site)).map_or_else(
            || {
                let (e, end) = self.edge_at_end(site);
                SiteAt::End(arrangement.curve_of(e), end)
            },
            SiteAt::Point,
        );
        Site { location, at }
    }

    /// The edge of which a site is an end, where there is no point.
    fn edge_at_end(&self, site: SiteId) -> (EdgeId, CurveEnd) {
        let [below, above] = self.decomposition.left_of(site);
        let (t, end) = if below == above {
            (self.decomposition.right_of(site)[1], CurveEnd::Min)
        } else {
            (above, CurveEnd::Max)
        };
        let e = self.decomposition.trapezoid(t).below;
        (e.expect("a site without a point is the end of an edge, which is below the upper one of its trapezoids"), end)
    }

    /// The number of sites before a place, or the site there; `order` compares the place with a site.
    pub(super) fn rank_by(&self, mut order: impl FnMut(SiteId) -> Ordering) -> Result<u32, SiteId> {
        let (mut low, mut high) = (0, self.keys.len() as u32);
        while low < high {
            let middle = SiteId(low + (high - low) / 2);
            match order(middle) {
                Ordering::Less => high = middle.0,
                Ordering::Greater => low = middle.0 + 1,
                Ordering::Equal => return Err(middle),
            }
        }
        Ok(low)
    }

    /// The number of sites before a place, or the site there.
    fn rank<G: BasicTraits, T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        place: &Site<'_, G>,
    ) -> Result<u32, SiteId> {
        let (traits, topology) = (arrangement.traits(), arrangement.topology());
        let key = place.point().filter(|_| place.location.is_interior());
        let key = key.map_or(0, |point| traits.order_key(point));
        self.rank_by(|site| {
            // Keys order as the places do, where they are different and there are any.
            let other = self.keys[site.index()];
            if key != other && key != 0 && other != 0 {
                return key.cmp(&other);
            }
            topology.compare_sites(traits, place, &self.place(arrangement, site))
        })
    }

    /// Finds a place; `start` says from where, which costs time at most, as does `height`, about which v the place has.
    pub(super) fn find<G: BasicTraits, T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        place: &Site<'_, G>,
        height: f64,
        start: Option<Start>,
    ) -> Spot {
        match self.rank(arrangement, place) {
            Err(site) => Spot::Site(site),
            Ok(rank) => {
                let t = self.walk_along_u(self.start(start, rank, height), rank, height);
                self.walk_along_v(arrangement, place, rank, t)
            }
        }
    }

    /// One of two trapezoids at a wall of a site, the lower or the upper one: where a place of about this v is.
    #[inline]
    fn guess(&self, site: SiteId, height: f64, walls: [TrapezoidId; 2]) -> TrapezoidId {
        walls[usize::from(height > self.heights[site.index()])]
    }

    fn start(&self, start: Option<Start>, rank: u32, height: f64) -> TrapezoidId {
        match start {
            None => TrapezoidId(0),
            Some(Start::Trapezoid(t)) => t,
            Some(Start::Site(site)) if site.0 < rank => {
                self.guess(site, height, self.decomposition.right_of(site))
            }
            Some(Start::Site(site)) => self.guess(site, height, self.decomposition.left_of(site)),
        }
    }

    /// A trapezoid with a rank between its walls.
    fn walk_along_u(&self, mut t: TrapezoidId, rank: u32, height: f64) -> TrapezoidId {
        let decomposition = &self.decomposition;
        while let Some(right) = decomposition.trapezoid(t).right.filter(|right| right.0 < rank) {
            t = self.guess(right, height, decomposition.right_of(right));
        }
        while let Some(left) = decomposition.trapezoid(t).left.filter(|left| left.0 >= rank) {
            t = self.guess(left, height, decomposition.left_of(left));
        }
        t
    }

    /// The trapezoid of a place, from one above or below.
    fn walk_along_v<G: BasicTraits, T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        place: &Site<'_, G>,
        rank: u32,
        mut t: TrapezoidId,
    ) -> Spot {
        let compare = |e: EdgeId| side(arrangement, place, arrangement.curve_of(e));
        let mut is_below_known = false;
        while let Some(above) = self.decomposition.trapezoid(t).above {
            match compare(above) {
                Ordering::Less => break,
                Ordering::Equal => return Spot::Edge(above, rank),
                Ordering::Greater => t = self.over(Some(above), rank),
            }
            is_below_known = true;
        }
        if is_below_known {
            return Spot::Inside(t);
        }
        while let Some(below) = self.decomposition.trapezoid(t).below {
            match compare(below) {
                Ordering::Greater => break,
                Ordering::Equal => return Spot::Edge(below, rank),
                Ordering::Less => t = self.under(Some(below), rank),
            }
        }
        Spot::Inside(t)
    }

    /// The trapezoid over an edge that has a rank between its walls; over the bottom, if there is no edge.
    pub(super) fn over(&self, e: Option<EdgeId>, rank: u32) -> TrapezoidId {
        let row = self.decomposition.above(e);
        let (mut low, mut high) = (row.start, row.end);
        // The first begins before the rank, and what begins behind it is at or behind `high`.
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if self.begins_before(TrapezoidId(middle), rank) {
                low = middle;
            } else {
                high = middle;
            }
        }
        TrapezoidId(low)
    }

    /// The trapezoid under an edge that has a rank between its walls; under the top, if there is no edge.
    pub(super) fn under(&self, e: Option<EdgeId>, rank: u32) -> TrapezoidId {
        let row = self.decomposition.below(e);
        let behind = row.partition_point(|&t| self.begins_before(t, rank));
        row[behind.saturating_sub(1)]
    }

    #[inline]
    fn begins_before(&self, t: TrapezoidId, rank: u32) -> bool {
        self.decomposition.trapezoid(t).left.is_none_or(|left| left.0 < rank)
    }
}
