//! Edges are split and merged: a number of a rail stays with the longer part.

use super::{Found, Rail, RailId, Side, SiteId, Toward, TrapezoidId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;

/// How many trapezoids are looked at before a search begins.
const NEAR: usize = 6;

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

    /// The trapezoids along one side of a rail, from left to right.
    pub(crate) fn along(&self, rail: RailId, side: Side) -> impl Iterator<Item = TrapezoidId> + '_ {
        let Rail { ends: [_, end], first, .. } = *self.rail(rail);
        std::iter::successors(Some(first[side as usize]), move |&t| self.next_along(t, side, Way::Right, end))
    }

    /// The trapezoid on one side of a rail at a site on it that has no walls yet.
    ///
    /// # Complexity
    /// Constant if it is one of the first few along the rail; else that of a search.
    pub(super) fn beside<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        rail: RailId,
        side: Side,
        site: SiteId,
    ) -> TrapezoidId {
        let place = self.place(arrangement, site);
        let is_behind = |t: &TrapezoidId| {
            let right = self.place(arrangement, self.trapezoid(*t).right);
            arrangement.topology().compare_sites(arrangement.traits(), &place, &right).is_lt()
        };
        let near = self.along(rail, side).take(NEAR).find(is_behind);
        near.unwrap_or_else(|| match self.search(arrangement, &place, &Toward::Straight(side)).0 {
            Found::Within(t) => t,
            Found::Site(_) => unreachable!("only the place itself is looked for at a site"),
        })
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
        let first = self.right_of(site);
        let right = &mut self.rails[rails[1].index()];
        (right.ends[0], right.first) = (site, first);
        self.rails[rails[0].index()].first = old.first;
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
        let first = self.rail(rails[0]).first;
        let [gone, kept] = [rails[short], rails[1 - short]];
        self.relabel(&visited, kept);
        let rail = &mut self.rails[kept.index()];
        (rail.ends, rail.first) = (ends, first);
        self.free_rail(gone);
        kept
    }
}
