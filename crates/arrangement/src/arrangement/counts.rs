//! How many cells there are, with and without the vertices at which curves were cut.

use super::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;
use dcel::VertexId;

/// Numbers of cells.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Counts {
    /// Vertices that are points, isolated ones included.
    pub vertices: usize,
    /// Edges.
    pub edges: usize,
    /// Faces, the unbounded ones included.
    pub faces: usize,
    /// Isolated vertices.
    pub isolated: usize,
    /// Connected components of the union of vertices and edges.
    pub components: usize,
}

impl<G: BasicTraits, T: Topology<G>> Arrangement<G, T> {
    /// Counts the cells as a user sees them: edges that meet in an artificial vertex are one.
    ///
    /// A closed curve without any other vertex keeps one of its artificial ones: see [`Arrangement::user_view`].
    ///
    /// # Complexity
    /// Linear.
    pub fn counts(&self) -> Counts {
        let (counts, view) = (self.counts_with_splits(), self.user_view());
        Counts { vertices: view.vertex_count(), edges: view.edge_count(), ..counts }
    }

    /// Counts the cells as they are stored, artificial vertices included. CGAL and the tables of the papers count so.
    ///
    /// # Complexity
    /// Linear.
    pub fn counts_with_splits(&self) -> Counts {
        let isolated = self.vertices().filter(|&v| self.dcel.outgoing(v).is_none());
        Counts {
            vertices: self.vertices().count(),
            edges: self.dcel.edge_count(),
            faces: self.dcel.face_count(),
            isolated: isolated.count(),
            components: self.component_count(),
        }
    }

    /// The number of curve ends at infinity.
    ///
    /// All of them meet in one vertex, or in one for each open side that is a point of its own.
    pub fn ends_at_infinity(&self) -> usize {
        self.dcel.vertices().filter(|&v| self.is_at_infinity(v)).map(|v| self.dcel.degree(v)).sum()
    }

    /// Components of what is drawn: curves that only meet at infinity are not connected.
    fn component_count(&self) -> usize {
        let mut parents: Vec<u32> = (0..self.dcel.vertex_bound() as u32).collect();
        let mut components = self.vertices().count();
        for e in self.dcel.edges() {
            let [min, max] = self.dcel.ends(e);
            match (self.is_at_infinity(min), self.is_at_infinity(max)) {
                (true, true) => components += 1,
                (false, false) => {
                    let (a, b) = (find(&mut parents, min), find(&mut parents, max));
                    if a != b {
                        parents[a as usize] = b;
                        components -= 1;
                    }
                }
                _ => {}
            }
        }
        components
    }
}

fn find(parents: &mut [u32], vertex: VertexId) -> u32 {
    let mut v = vertex.0;
    while parents[v as usize] != v {
        parents[v as usize] = parents[parents[v as usize] as usize];
        v = parents[v as usize];
    }
    v
}
