//! The decomposition of an arrangement, edges in random order.

use super::insert::NewSite;
use super::{Found, SiteId, Toward, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::{Site, SiteAt, Topology};
use crate::traits::{CurveEnd, UMonotoneTraits};
use dcel::{EdgeId, HalfedgeId, VertexId};

/// Orders of edges that are tried, the first one always.
const SEEDS: [u64; 3] = [0x9e37_79b9_7f4a_7c15, 0xbf58_476d_1ce4_e5b9, 0x94d0_49bb_1331_11eb];

/// The longest path that a search structure may have with which one is content, for a number of trapezoids.
///
/// A random order has a longer one with a probability that falls as a power of that number; usual are 4 to 5 times the binary logarithm.
fn longest_path(trapezoids: usize) -> u32 {
    12 * (trapezoids.max(1).ilog2() + 2)
}

impl<G: UMonotoneTraits> Trapezoids<G> {
    /// The decomposition of an arrangement. Where the longest path of the search structure is longer than its bound, another order of edges
    /// is tried.
    ///
    /// # Complexity
    /// Expected O(n log n).
    pub(crate) fn of<T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Self {
        let mut best: Option<(u32, Self)> = None;
        for seed in SEEDS {
            let mut trapezoids = Self::in_order(arrangement, seed);
            trapezoids.tidy();
            let longest = trapezoids.longest_path();
            if longest <= longest_path(trapezoids.count()) {
                return trapezoids;
            }
            if best.as_ref().is_none_or(|(least, _)| longest < *least) {
                best = Some((longest, trapezoids));
            }
        }
        best.expect("there are seeds").1
    }

    /// The decomposition, edges in the order that a seed gives.
    fn in_order<T: Topology<G>>(arrangement: &Arrangement<G, T>, seed: u64) -> Self {
        let dcel = arrangement.dcel();
        let mut trapezoids = Self::empty();
        trapezoids.rail_of.resize(dcel.edge_bound(), super::RailId::NONE);
        trapezoids.first_site.resize(dcel.vertex_bound(), SiteId::NONE);
        for e in rounds(dcel.edges().collect(), seed) {
            trapezoids.add_edge(arrangement, e);
        }
        for v in rounds(arrangement.vertices().collect(), seed) {
            trapezoids.add_home(arrangement, v);
        }
        trapezoids
    }

    /// Adds an edge of the arrangement, and the sites of its ends.
    pub(super) fn add_edge<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, e: EdgeId) {
        let curve = arrangement.support(e).0;
        let ends = [e.halfedge(), e.halfedge().twin()].map(|h| self.site_of_start(arrangement, h));
        let first = self.first_of(arrangement, ends[0], arrangement.curve_of(e));
        let new = self.insert_rail(arrangement, curve, ends, first);
        self.set_edge(new.rail, e);
    }

    /// The site where a halfedge begins, added if it is not there.
    fn site_of_start<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, h: HalfedgeId) -> SiteId {
        let v = arrangement.dcel().source(h);
        let place = arrangement.start_site(h);
        match place.at {
            SiteAt::Point(_) => {
                self.add_home(arrangement, v);
                self.add_vertex_site(arrangement, v, &place)
            }
            SiteAt::End(..) => {
                let end = if h.is_even() { CurveEnd::Min } else { CurveEnd::Max };
                let curve = arrangement.support(h.edge_id()).0;
                match self.search(arrangement, &place, &Toward::Here).0 {
                    Found::Site(site) => site,
                    Found::Within(t) => {
                        self.add_site(arrangement, NewSite::End(v, curve, end), place.location, t)
                    }
                }
            }
        }
    }

    /// The site of a vertex at a place of it, added if it is not there and no edge passes through.
    fn add_vertex_site<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        v: VertexId,
        place: &Site<'_, G>,
    ) -> SiteId {
        if let Some(site) = self.site_at(v, place.location) {
            return site;
        }
        match self.search(arrangement, place, &Toward::Here).0 {
            Found::Site(site) => site,
            Found::Within(t) => self.add_site(arrangement, NewSite::Vertex(v), place.location, t),
        }
    }

    /// Adds the first site of a vertex, where its point is: on an identified side, the low one.
    pub(super) fn add_home<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, v: VertexId) {
        if let Some(point) = arrangement.inner_point(v) {
            let place = Site::of_point(arrangement.topology(), arrangement.traits(), point);
            self.add_vertex_site(arrangement, v, &place);
        }
    }
}

/// Puts cells into rounds, each about as many as all before together, chosen as if at random, the same way every time; within a round
/// they keep their order, in which they are usually near to one another.
///
/// # References
/// Amenta, Choi and Rote, Incremental constructions con BRIO, SoCG 2003: the expected cost is that of a random order.
fn rounds<I>(mut cells: Vec<I>, seed: u64) -> Vec<I> {
    let mut state = seed;
    let last = cells.len().checked_ilog2().unwrap_or(0);
    cells.sort_by_cached_key(|_| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        last.saturating_sub(state.leading_zeros())
    });
    cells
}
