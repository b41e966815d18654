//! Checking a mesh against what it promises.

use crate::{FacetId, HalfedgeId, Mesh, VertexId};
use std::fmt;

/// Something that a mesh promises and does not keep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Violation {
    /// `next` and `prev` are not inverse at this halfedge.
    NextPrev(HalfedgeId),
    /// The next halfedge does not start where this one ends.
    Chain(HalfedgeId),
    /// The next halfedge has another facet.
    FacetOfNext(HalfedgeId),
    /// The halfedge starts and ends at the same vertex.
    Loop(HalfedgeId),
    /// The stored halfedge of the vertex does not start there.
    Outgoing(VertexId),
    /// The stored halfedge of the facet has another facet.
    Boundary(FacetId),
    /// Not every halfedge that starts at the vertex is in its cycle.
    VertexCycle(VertexId),
    /// Not every halfedge of the facet is in its cycle.
    FacetCycle(FacetId),
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NextPrev(h) => write!(f, "next and prev are not inverse at halfedge {}", h.0),
            Self::Chain(h) => write!(f, "the halfedge after {} does not start where that one ends", h.0),
            Self::FacetOfNext(h) => write!(f, "the halfedge after {} has another facet", h.0),
            Self::Loop(h) => write!(f, "halfedge {} is a loop", h.0),
            Self::Outgoing(v) => write!(f, "the stored halfedge of vertex {} does not start there", v.0),
            Self::Boundary(g) => write!(f, "the stored halfedge of facet {} has another facet", g.0),
            Self::VertexCycle(v) => write!(f, "vertex {} has more than one cycle of halfedges", v.0),
            Self::FacetCycle(g) => write!(f, "facet {} has more than one cycle of halfedges", g.0),
        }
    }
}

impl Mesh {
    /// Lists every violation of what a mesh promises; none for a valid one.
    ///
    /// # Complexity
    /// Linear.
    pub fn check_valid(&self) -> Vec<Violation> {
        let mut found = Vec::new();
        let n = self.halfedge_count();
        let in_range = |h: HalfedgeId| h.index() < n;
        for h in self.halfedges() {
            let (next, prev) = (self.next(h), self.prev(h));
            if !in_range(next) || !in_range(prev) || self.prev(next) != h || self.next(prev) != h {
                found.push(Violation::NextPrev(h));
                continue;
            }
            if self.source(next) != self.target(h) {
                found.push(Violation::Chain(h));
            }
            if self.facet(next) != self.facet(h) {
                found.push(Violation::FacetOfNext(h));
            }
            if self.source(h) == self.target(h) {
                found.push(Violation::Loop(h));
            }
        }
        if !found.is_empty() {
            return found; // The cycles below would not be cycles.
        }
        let (mut around_vertex, mut around_facet) =
            (vec![0usize; self.vertex_count()], vec![0; self.facet_count()]);
        for h in self.halfedges() {
            around_vertex[self.source(h).index()] += 1;
            around_facet[self.facet(h).index()] += 1;
        }
        for v in self.vertices() {
            let h = self.outgoing(v);
            if !in_range(h) || self.source(h) != v {
                found.push(Violation::Outgoing(v));
            } else if self.vertex_cycle(v).count() != around_vertex[v.index()] {
                found.push(Violation::VertexCycle(v));
            }
        }
        for f in self.facets() {
            let h = self.boundary(f);
            if !in_range(h) || self.facet(h) != f {
                found.push(Violation::Boundary(f));
            } else if self.facet_cycle(f).count() != around_facet[f.index()] {
                found.push(Violation::FacetCycle(f));
            }
        }
        found
    }
}
