//! What a complex has, in numbers.

use super::edges::{EdgeIndex, sorted};
use super::{Complex, Facet};
use std::collections::BTreeSet;

/// What a complex has, in numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct ComplexSummary {
    /// The dimension of the set: the highest of a cell that belongs to it; `None` for the empty set. A volume counts
    /// if some facet has it on a side, volume 0 always.
    pub dimension: Option<u8>,
    /// Whether the set is bounded: what is outside does not belong to it, nor does any cell with a direction, nor a
    /// volume beside an unbounded facet.
    pub bounded: bool,
    /// Vertices that are points.
    pub vertices: usize,
    /// Vertices at infinity.
    pub directions: usize,
    /// Edges: the sides of the facets, and those that are said by themselves. Lines between the same two directions
    /// count once, unless they are said by themselves.
    pub edges: usize,
    /// Facets.
    pub facets: usize,
    /// Holes of facets, those of one vertex and of two too.
    pub holes: usize,
    /// Volume 0, and all others that some facet has on a side.
    pub volumes: usize,
    /// The cells that do not belong to the set.
    pub unmarked: UnmarkedCells,
}

/// Numbers of cells that do not belong to a set.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct UnmarkedCells {
    /// Vertices that are points.
    pub vertices: usize,
    /// Edges.
    pub edges: usize,
    /// Facets.
    pub facets: usize,
    /// Volumes, volume 0 among them.
    pub volumes: usize,
}

impl Complex {
    /// Counts the cells.
    ///
    /// # Panics
    /// If a vertex does not exist; see [`check`](Self::check).
    ///
    /// # Complexity
    /// O(n log n) for n edges and corners of facets.
    pub fn summary(&self) -> ComplexSummary {
        let directions = self.vertices.iter().filter(|vertex| vertex.is_direction()).count();
        let mut sides: Vec<[u32; 2]> =
            self.facets.iter().flat_map(|facet| self.edges_of(facet)).map(sorted).collect();
        sides.sort_unstable();
        sides.dedup();
        let own_edges = self.are_sides().iter().filter(|&&is_side| !is_side).count();
        let mut volumes: BTreeSet<u32> = self.facets.iter().flat_map(|facet| facet.sides).collect();
        volumes.insert(0);
        let unmarked = UnmarkedCells {
            vertices: self.vertices.iter().filter(|v| !v.marked && !v.is_direction()).count(),
            edges: self.edges.iter().filter(|edge| !edge.marked).count(),
            facets: self.facets.iter().filter(|facet| !facet.marked).count(),
            volumes: volumes.iter().filter(|&&volume| !self.is_marked(volume)).count(),
        };
        let (vertices, edges) = (self.vertices.len() - directions, sides.len() + own_edges);
        let marked = [
            vertices > unmarked.vertices,
            edges > unmarked.edges,
            self.facets.len() > unmarked.facets,
            volumes.len() > unmarked.volumes,
        ];
        ComplexSummary {
            dimension: (0..4).rev().find(|&dimension| marked[usize::from(dimension)]),
            bounded: self.is_bounded(),
            vertices,
            directions,
            edges,
            facets: self.facets.len(),
            holes: self.facets.iter().map(|facet| facet.holes.len()).sum(),
            volumes: volumes.len(),
            unmarked,
        }
    }

    fn is_bounded(&self) -> bool {
        let ray = self.edges.iter().any(|edge| edge.marked && self.is_unbounded(&edge.ends));
        let left_out = EdgeIndex::new(self, |edge| !edge.marked);
        let reaches = |facet: &Facet| {
            let ray_around =
                |side: [u32; 2]| self.is_unbounded(&side) && left_out.find(facet, side).is_none();
            facet.cycles().any(|cycle| self.is_unbounded(cycle))
                && (facet.marked
                    || facet.sides.iter().any(|&volume| self.is_marked(volume))
                    || self.edges_of(facet).any(ray_around))
        };
        !self.is_marked(0) && !ray && !self.facets.iter().any(reaches)
    }
}
