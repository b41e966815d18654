//! The user's view: cells without the vertices at which curves were cut.

use super::Arrangement;
use crate::topology::{Site, Topology};
use crate::traits::BasicTraits;
use dcel::{EdgeId, HalfedgeId, VertexId};
use std::cmp::Ordering;

/// Names an edge of the user's view.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct UserEdgeId(pub u32);

impl UserEdgeId {
    /// The position of the edge.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// An arrangement as a user sees it: edges that meet in an artificial vertex are one.
///
/// A closed curve without any other vertex keeps one of its artificial ones, the least. Faces are those of the arrangement. Edges are
/// numbered in the order of the least of their stored edges.
#[derive(Clone, Debug)]
pub struct UserView<'a, G: BasicTraits, T> {
    arrangement: &'a Arrangement<G, T>,
    is_hidden: Vec<bool>,
    hidden_count: usize,
    /// For each edge the halfedges that leave its ends.
    edges: Vec<[HalfedgeId; 2]>,
    /// For each stored edge, the edge of which it is a part.
    edge_of: Vec<UserEdgeId>,
}

impl<G: BasicTraits, T: Topology<G>> Arrangement<G, T> {
    /// The cells as a user sees them.
    ///
    /// # Complexity
    /// Linear.
    pub fn user_view(&self) -> UserView<'_, G, T> {
        let is_hidden = self.hidden_vertices();
        let none = UserEdgeId(u32::MAX);
        let mut edge_of = vec![none; self.dcel.edge_bound()];
        let mut edges = Vec::new();
        for e in self.dcel.edges() {
            if edge_of[e.index()] != none {
                continue;
            }
            let id = UserEdgeId(edges.len() as u32);
            let mut last = [HalfedgeId::NONE; 2];
            for (way, start) in [e.halfedge(), e.halfedge().twin()].into_iter().enumerate() {
                let mut h = start;
                edge_of[h.edge()] = id;
                while is_hidden[self.dcel.target(h).index()] {
                    h = self.dcel.next(h);
                    edge_of[h.edge()] = id;
                }
                last[way] = h;
            }
            edges.push([last[1].twin(), last[0].twin()]);
        }
        let hidden_count = is_hidden.iter().filter(|&&is| is).count();
        UserView { arrangement: self, is_hidden, hidden_count, edges, edge_of }
    }

    /// For each vertex, whether the user's view does without it.
    fn hidden_vertices(&self) -> Vec<bool> {
        let mut is_hidden = vec![false; self.dcel.vertex_bound()];
        for v in self.dcel.vertices() {
            is_hidden[v.index()] = self.is_artificial(v);
        }
        let mut is_seen = vec![false; self.dcel.vertex_bound()];
        for v in self.dcel.vertices() {
            if !is_hidden[v.index()] || is_seen[v.index()] {
                continue;
            }
            let first = self.dcel.outgoing(v).expect("an artificial vertex has two edges");
            if let Some(least) = self.walk_hidden(first, &is_hidden, &mut is_seen) {
                is_hidden[least.index()] = false;
            } else {
                // The other way, so that every vertex is walked along once or twice.
                let back = self.dcel.prev(first).twin();
                self.walk_hidden(back, &is_hidden, &mut is_seen);
            }
        }
        is_hidden
    }

    /// Walks along hidden vertices from the source of a halfedge, and gives the least of all if the walk comes back to it.
    fn walk_hidden(&self, first: HalfedgeId, is_hidden: &[bool], is_seen: &mut [bool]) -> Option<VertexId> {
        let mut h = first;
        let mut least = self.dcel.source(first);
        loop {
            let (v, target) = (self.dcel.source(h), self.dcel.target(h));
            is_seen[v.index()] = true;
            if self.compare_vertices(v, least).is_lt() {
                least = v;
            }
            if !is_hidden[target.index()] {
                return None;
            }
            h = self.dcel.next(h);
            if h == first {
                return Some(least);
            }
        }
    }

    /// Compares two vertices in the order in which a sweep meets them; those without points are less than all others.
    pub(super) fn compare_vertices(&self, v: VertexId, w: VertexId) -> Ordering {
        self.compare_places(self.point(v), self.point(w)).then_with(|| match self.point(v) {
            None => v.cmp(&w),
            Some(_) => Ordering::Equal,
        })
    }

    pub(super) fn compare_places(&self, p: Option<&G::Point>, q: Option<&G::Point>) -> Ordering {
        match (p, q) {
            (Some(p), Some(q)) => {
                let [p, q] = [p, q].map(|point| Site::of_point(&self.topology, &self.traits, point));
                self.topology.compare_sites(&self.traits, &p, &q)
            }
            (p, q) => p.is_some().cmp(&q.is_some()),
        }
    }
}

impl<'a, G: BasicTraits, T: Topology<G>> UserView<'a, G, T> {
    /// The arrangement that is seen.
    pub fn arrangement(&self) -> &'a Arrangement<G, T> {
        self.arrangement
    }

    /// The vertices that are points, isolated ones included.
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        self.arrangement.vertices().filter(|&v| !self.is_hidden(v))
    }

    /// The number of vertices that are points.
    pub fn vertex_count(&self) -> usize {
        self.arrangement.vertices().count() - self.hidden_count
    }

    /// The edges.
    pub fn edges(&self) -> impl Iterator<Item = UserEdgeId> + use<G, T> {
        (0..self.edges.len() as u32).map(UserEdgeId)
    }

    /// The number of edges.
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// Tells whether the view does without a vertex.
    pub fn is_hidden(&self, v: VertexId) -> bool {
        self.is_hidden[v.index()]
    }

    /// The edge of which a stored one is a part.
    pub fn edge_of(&self, e: EdgeId) -> UserEdgeId {
        self.edge_of[e.index()]
    }

    /// The halfedges that leave the two ends of an edge along it. For a closed curve both leave the one vertex that it has.
    pub fn end_halfedges(&self, edge: UserEdgeId) -> [HalfedgeId; 2] {
        self.edges[edge.index()]
    }

    /// The vertices of an edge, in the order of [`UserView::end_halfedges`].
    pub fn ends(&self, edge: UserEdgeId) -> [VertexId; 2] {
        self.edges[edge.index()].map(|h| self.arrangement.dcel.source(h))
    }

    /// The halfedges along an edge, from the first of its ends to the second.
    pub fn halfedges(&self, edge: UserEdgeId) -> impl Iterator<Item = HalfedgeId> + '_ {
        self.chain(self.edges[edge.index()][0])
    }

    /// The halfedges from `first` on, up to the first vertex of the view.
    pub fn chain(&self, first: HalfedgeId) -> impl Iterator<Item = HalfedgeId> + '_ {
        let dcel = &self.arrangement.dcel;
        std::iter::successors(Some(first), |&h| self.is_hidden(dcel.target(h)).then(|| dcel.next(h)))
    }
}
