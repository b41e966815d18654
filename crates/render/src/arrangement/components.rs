//! Which cells hang together: components of vertices and edges. Curves that meet only at infinity do not.

use ::arrangement::Arrangement;
use ::arrangement::topology::Topology;
use ::arrangement::traits::ApproxTraits;
use dcel::VertexId;

/// The component of each vertex that is a point.
pub(super) struct Components {
    /// Numbered from 0 in the order of their first vertices; isolated vertices have no number.
    of_vertex: Vec<u32>,
}

impl Components {
    /// With all vertices that are points, in some order.
    pub(super) fn new<G: ApproxTraits, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        vertices: &[VertexId],
    ) -> Self {
        const NONE: u32 = u32::MAX;
        let dcel = arrangement.dcel();
        let mut of_vertex = vec![NONE; dcel.vertex_bound()];
        let mut count = 0;
        let mut stack = Vec::new();
        for &first in vertices {
            if of_vertex[first.index()] != NONE || dcel.outgoing(first).is_none() {
                continue;
            }
            of_vertex[first.index()] = count;
            stack.push(first);
            while let Some(v) = stack.pop() {
                for h in dcel.around(v) {
                    for next in [dcel.source(h), dcel.target(h)] {
                        if of_vertex[next.index()] == NONE && !arrangement.is_at_infinity(next) {
                            of_vertex[next.index()] = count;
                            stack.push(next);
                        }
                    }
                }
            }
            count += 1;
        }
        Self { of_vertex }
    }

    /// The component of a vertex that is a point and has an edge.
    pub(super) fn of(&self, v: VertexId) -> u32 {
        self.of_vertex[v.index()]
    }
}
