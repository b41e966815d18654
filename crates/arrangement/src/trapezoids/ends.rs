//! The ends of curves at vertices without a point, in their order around these.

use super::{RailId, SiteId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;
use dcel::{HalfedgeId, VertexId};

/// The corner in which a new edge ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EndCorner {
    /// The halfedge that comes counterclockwise next, but those of the new edge.
    pub(crate) next: HalfedgeId,
    /// Whether the other half of the new edge comes in between.
    pub(crate) is_other_between: bool,
}

impl<G: BasicTraits> Trapezoids<G> {
    /// Where an end belongs among those of its vertex.
    fn rank_of_end<T: Topology<G>>(&self, arrangement: &Arrangement<G, T>, site: SiteId) -> usize {
        let place = self.place(arrangement, site);
        let ends = &self.ends[self.vertex(site).index()];
        ends.partition_point(|&other| {
            arrangement.compare_ends(&self.place(arrangement, other), &place).is_lt()
        })
    }

    pub(super) fn add_end<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, site: SiteId) {
        let VertexId(v) = self.vertex(site);
        if self.ends.len() <= v as usize {
            self.ends.resize_with(v as usize + 1, Vec::new);
        }
        let rank = self.rank_of_end(arrangement, site);
        self.ends[v as usize].insert(rank, site);
    }

    pub(super) fn remove_end<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, site: SiteId) {
        let rank = self.rank_of_end(arrangement, site);
        let v = self.vertex(site);
        let gone = self.ends[v.index()].remove(rank);
        debug_assert_eq!(gone, site, "an end is where it belongs");
    }

    /// Finds the corner of a new edge at one of its ends, which is on a side. `None` if no other edge ends there.
    ///
    /// # Complexity
    /// Logarithmic in the number of ends; but to add an end moves those behind it.
    pub(crate) fn corner_at_end<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        new: RailId,
        site: SiteId,
    ) -> Option<EndCorner> {
        let rank = self.rank_of_end(arrangement, site);
        let own = self.rail(new).ends;
        let ends = &self.ends[self.vertex(site).index()];
        let is_own = |rank: usize| own.contains(&ends[rank % ends.len()]);
        let is_other_between = is_own(rank + 1);
        // There are two own ends at most.
        let next = (rank + 1..rank + 3).find(|&rank| !is_own(rank))?;
        Some(EndCorner { next: self.halfedge_at(ends[next % ends.len()]), is_other_between })
    }

    /// The halfedge that begins at an end.
    fn halfedge_at(&self, site: SiteId) -> HalfedgeId {
        let [left, right] = [self.left_of(site)[1], self.right_of(site)[1]].map(|t| self.trapezoid(t).below);
        if !left.is_none() && self.rail(left).ends[1] == site {
            return self.rail(left).edge.halfedge().twin();
        }
        debug_assert!(self.rail(right).ends[0] == site, "an end is one of an edge");
        self.rail(right).edge.halfedge()
    }
}
