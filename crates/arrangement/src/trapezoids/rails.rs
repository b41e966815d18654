//! Edges are split and merged: a number of a rail stays with the longer part.

use super::{RailId, Side, SiteId, TrapezoidId, Trapezoids};
use crate::traits::BasicTraits;

/// To the left or to the right.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Way {
    Left,
    Right,
}

/// The trapezoids along both sides of a part of a rail, from a site on it to its end.
#[derive(Clone, Copy, Debug)]
struct Part {
    way: Way,
    /// Below and above the rail.
    at: [Option<TrapezoidId>; 2],
    end: SiteId,
}

impl<G: BasicTraits> Trapezoids<G> {
    /// The trapezoid after another along a rail, which is on the side given of it; `None` at the end of the rail.
    fn next_along(&self, t: TrapezoidId, side: Side, way: Way, end: SiteId) -> Option<TrapezoidId> {
        let trapezoid = self.trapezoid(t);
        let site = match way {
            Way::Left => trapezoid.left,
            Way::Right => trapezoid.right,
        };
        if site == end {
            return None;
        }
        // The wall that comes down to the rail, or up.
        let wall = side.opposite() as usize;
        let record = &self.sites[site.index()];
        Some(match way {
            Way::Left => record.left[wall],
            Way::Right => record.right[wall],
        })
    }

    /// The trapezoids along one side of a rail, from left to right; `first` is the first of them.
    pub(crate) fn along(
        &self,
        rail: RailId,
        side: Side,
        first: TrapezoidId,
    ) -> impl Iterator<Item = TrapezoidId> + '_ {
        let end = self.rail(rail).ends[1];
        std::iter::successors(Some(first), move |&t| self.next_along(t, side, Way::Right, end))
    }

    /// Steps to the next trapezoid of a part, those below first; `None` if all were visited.
    fn step(&self, part: &mut Part) -> Option<(TrapezoidId, Side)> {
        for side in [Side::Below, Side::Above] {
            if let Some(t) = part.at[side as usize] {
                part.at[side as usize] = self.next_along(t, side, part.way, part.end);
                return Some((t, side));
            }
        }
        None
    }

    /// Visits two parts in step, until the shorter one is over; gives it, and says which it is.
    fn shorter(&self, mut parts: [Part; 2]) -> (usize, Vec<(TrapezoidId, Side)>) {
        let mut visited = [Vec::new(), Vec::new()];
        loop {
            for i in [0, 1] {
                match self.step(&mut parts[i]) {
                    Some(step) => visited[i].push(step),
                    None => return (i, std::mem::take(&mut visited[i])),
                }
            }
        }
    }

    fn relabel(&mut self, visited: &[(TrapezoidId, Side)], rail: RailId) {
        for &(t, side) in visited {
            *self.trapezoids[t.index()].rail_mut(side.opposite()) = rail;
        }
    }

    /// Cuts a rail at a site on it, and gives the left and the right part, of which the longer one has the old number.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids along the shorter part.
    pub(super) fn split_rail(&mut self, rail: RailId, site: SiteId) -> [RailId; 2] {
        let old = *self.rail(rail);
        let record = &self.sites[site.index()];
        let parts = [
            Part { way: Way::Left, at: record.left.map(Some), end: old.ends[0] },
            Part { way: Way::Right, at: record.right.map(Some), end: old.ends[1] },
        ];
        let (short, visited) = self.shorter(parts);
        let new = self.new_rail(old);
        self.relabel(&visited, new);
        let mut rails = [rail; 2];
        rails[short] = new;
        self.rails[rails[0].index()].ends[1] = site;
        self.rails[rails[1].index()].ends[0] = site;
        rails
    }

    /// Joins the two rails that meet at a site. The one that stays has the ends of both, and is to get its edge and curve.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids along the shorter one.
    pub(super) fn join_rails(&mut self, site: SiteId) -> RailId {
        let record = &self.sites[site.index()];
        let rails = [record.left, record.right].map(|[_, above]| self.trapezoid(above).below);
        let ends = [self.rail(rails[0]).ends[0], self.rail(rails[1]).ends[1]];
        let parts = [
            Part { way: Way::Left, at: record.left.map(Some), end: ends[0] },
            Part { way: Way::Right, at: record.right.map(Some), end: ends[1] },
        ];
        let (short, visited) = self.shorter(parts);
        let [gone, kept] = [rails[short], rails[1 - short]];
        self.relabel(&visited, kept);
        self.rails[kept.index()].ends = ends;
        self.free_rail(gone);
        kept
    }
}
