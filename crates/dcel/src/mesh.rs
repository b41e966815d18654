//! The halfedge mesh.

use crate::{FacetId, HalfedgeId, VertexId};

/// The connectivity of a closed, orientable polyhedral surface.
///
/// Every edge is two halfedges, numbered `2 i` and `2 i + 1`, in opposite directions; a halfedge has
/// its facet on its left, seen from outside. The halfedges of a facet form one cycle.
///
/// A facet may have two halfedges only (a *digon*), and a vertex two edges only: the maps of
/// polytopes of lower dimension need that. Loops (an edge from a vertex to itself) do not occur.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mesh {
    pub(crate) source: Vec<VertexId>,
    pub(crate) facet: Vec<FacetId>,
    pub(crate) next: Vec<HalfedgeId>,
    pub(crate) prev: Vec<HalfedgeId>,
    /// One halfedge that leaves each vertex.
    pub(crate) outgoing: Vec<HalfedgeId>,
    /// One halfedge of each facet.
    pub(crate) boundary: Vec<HalfedgeId>,
}

impl Mesh {
    /// The number of vertices.
    #[inline]
    pub fn vertex_count(&self) -> usize {
        self.outgoing.len()
    }

    /// The number of edges: half the number of halfedges.
    #[inline]
    pub fn edge_count(&self) -> usize {
        self.source.len() / 2
    }

    /// The number of halfedges.
    #[inline]
    pub fn halfedge_count(&self) -> usize {
        self.source.len()
    }

    /// The number of facets.
    #[inline]
    pub fn facet_count(&self) -> usize {
        self.boundary.len()
    }

    /// All vertices.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = VertexId> + use<> {
        (0..self.vertex_count()).map(VertexId::new)
    }

    /// All halfedges.
    pub fn halfedges(&self) -> impl ExactSizeIterator<Item = HalfedgeId> + use<> {
        (0..self.halfedge_count()).map(HalfedgeId::new)
    }

    /// One halfedge of every edge: the even ones.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = HalfedgeId> + use<> {
        (0..self.edge_count()).map(|e| HalfedgeId::new(2 * e))
    }

    /// All facets.
    pub fn facets(&self) -> impl ExactSizeIterator<Item = FacetId> + use<> {
        (0..self.facet_count()).map(FacetId::new)
    }

    /// The vertex where `h` starts.
    #[inline]
    pub fn source(&self, h: HalfedgeId) -> VertexId {
        self.source[h.index()]
    }

    /// The vertex where `h` ends.
    #[inline]
    pub fn target(&self, h: HalfedgeId) -> VertexId {
        self.source[h.twin().index()]
    }

    /// The facet on the left of `h`.
    #[inline]
    pub fn facet(&self, h: HalfedgeId) -> FacetId {
        self.facet[h.index()]
    }

    /// The halfedge after `h` around its facet.
    #[inline]
    pub fn next(&self, h: HalfedgeId) -> HalfedgeId {
        self.next[h.index()]
    }

    /// The halfedge before `h` around its facet.
    #[inline]
    pub fn prev(&self, h: HalfedgeId) -> HalfedgeId {
        self.prev[h.index()]
    }

    /// A halfedge that starts at `v`.
    #[inline]
    pub fn outgoing(&self, v: VertexId) -> HalfedgeId {
        self.outgoing[v.index()]
    }

    /// A halfedge of `f`.
    #[inline]
    pub fn boundary(&self, f: FacetId) -> HalfedgeId {
        self.boundary[f.index()]
    }

    /// The halfedges of `f` in order.
    #[inline]
    pub fn facet_cycle(&self, f: FacetId) -> impl Iterator<Item = HalfedgeId> + '_ {
        cycle(self.boundary(f), |h| self.next(h))
    }

    /// The halfedges that start at `v`, clockwise seen from outside.
    #[inline]
    pub fn vertex_cycle(&self, v: VertexId) -> impl Iterator<Item = HalfedgeId> + '_ {
        cycle(self.outgoing(v), |h| self.next(h.twin()))
    }

    /// Numbers the connected components: a label for each facet, and how many there are.
    ///
    /// # Complexity
    /// Linear.
    pub fn components(&self) -> (Vec<u32>, u32) {
        let mut label = vec![u32::MAX; self.facet_count()];
        let mut count = 0;
        let mut stack = Vec::new();
        for seed in self.facets() {
            if label[seed.index()] != u32::MAX {
                continue;
            }
            label[seed.index()] = count;
            stack.push(seed);
            while let Some(f) = stack.pop() {
                for h in self.facet_cycle(f) {
                    let g = self.facet(h.twin());
                    if label[g.index()] == u32::MAX {
                        label[g.index()] = count;
                        stack.push(g);
                    }
                }
            }
            count += 1;
        }
        (label, count)
    }

    /// The Euler characteristic `V - E + F`: two for every sphere.
    pub fn euler_characteristic(&self) -> i64 {
        self.vertex_count() as i64 - self.edge_count() as i64 + self.facet_count() as i64
    }
}

/// `first` and what follows it, until it comes again.
#[inline]
pub(crate) fn cycle(
    first: HalfedgeId,
    step: impl Fn(HalfedgeId) -> HalfedgeId,
) -> impl Iterator<Item = HalfedgeId> {
    let mut at = Some(first);
    std::iter::from_fn(move || {
        let h = at?;
        let next = step(h);
        at = (next != first).then_some(next);
        Some(h)
    })
}
