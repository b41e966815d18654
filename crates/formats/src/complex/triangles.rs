//! The facets of a complex, cut into triangles.

use super::edges::sorted;
use super::{Complex, Edge, Facet};
use polytope::{HoleError, triangulate_with_holes};
use std::collections::BTreeSet;

impl Complex {
    /// The same set with every bounded facet cut into triangles, which take its place; and for each facet of the result
    /// the one it was made from.
    ///
    /// No vertex is added. A hole of one or two vertices becomes a vertex or an edge between triangles. The edges inside a
    /// facet that does not belong to the set do not either, and are said by themselves. Unbounded facets stay.
    ///
    /// # Errors
    /// The first facet that cannot be cut, by its index: it is not planar, or its boundary crosses itself.
    ///
    /// # Panics
    /// If a vertex does not exist; see [`check`](Self::check).
    ///
    /// # Complexity
    /// O(n log n) for n edges and corners of facets.
    pub fn triangulated(&self) -> Result<(Self, Vec<u32>), (usize, HoleError)> {
        let points = self.points_by_vertex();
        let mut result = Self { facets: Vec::new(), ..self.clone() };
        let mut origin = Vec::new();
        // Repeated facets have the same edges inside.
        let mut said: BTreeSet<[u32; 2]> = BTreeSet::new();
        if self.facets.iter().any(|facet| !facet.marked) {
            said.extend(self.edges.iter().map(|edge| sorted(edge.ends)));
        }
        for (index, facet) in self.facets.iter().enumerate() {
            let is_unbounded = facet.cycles().any(|cycle| self.is_unbounded(cycle));
            if is_unbounded || (facet.outer.len() == 3 && facet.holes.is_empty()) {
                result.facets.push(facet.clone());
            } else {
                let holes: Vec<&[u32]> = facet.holes.iter().map(Vec::as_slice).collect();
                let triangles = triangulate_with_holes(&points, &facet.outer, &holes);
                let triangles = triangles.map_err(|error| (index, error))?;
                if !facet.marked {
                    let inner = self.inner_edges(facet, &triangles);
                    result.edges.extend(inner.into_iter().filter(|edge| said.insert(sorted(edge.ends))));
                }
                let piece = |cycle: [u32; 3]| Facet {
                    marked: facet.marked,
                    ..Facet::of_cycle(cycle.into(), facet.sides)
                };
                result.facets.extend(triangles.into_iter().map(piece));
            }
            origin.resize(result.facets.len(), index as u32);
        }
        Ok((result, origin))
    }

    /// The edges between the triangles of a facet, as unmarked cells.
    fn inner_edges(&self, facet: &Facet, triangles: &[[u32; 3]]) -> Vec<Edge> {
        let around: BTreeSet<[u32; 2]> = self.edges_of(facet).map(sorted).collect();
        let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let inner: BTreeSet<[u32; 2]> = sides.map(sorted).filter(|side| !around.contains(side)).collect();
        inner.into_iter().map(|ends| Edge { marked: false, ..Edge::segment(ends) }).collect()
    }
}
