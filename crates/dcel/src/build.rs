//! Making a mesh: from vertex cycles as a file has them, or from edges that know their four neighbours.

use crate::{FacetId, HalfedgeId, Mesh, VertexId};
use std::fmt;

/// Why a list of facets is not a closed, orientable surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Defect {
    /// The edge has a facet on one side only.
    Border {
        /// The ends of the edge, in the direction in which its one facet has it.
        edge: [u32; 2],
        /// The facet that has it.
        facet: u32,
    },
    /// Two facets run through the edge in the same direction: one of them is turned round.
    Orientation {
        /// The ends of the edge.
        edge: [u32; 2],
        /// The two facets.
        facets: [u32; 2],
    },
    /// More than two facets share the edge.
    NonManifoldEdge {
        /// The ends of the edge.
        edge: [u32; 2],
        /// How many facets share it.
        facets: u32,
    },
    /// The facets around the vertex form more than one cycle.
    NonManifoldVertex {
        /// The vertex.
        vertex: u32,
    },
    /// The cycle has fewer than three corners, or a corner twice in a row.
    DegenerateCycle {
        /// The facet.
        facet: u32,
    },
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Border { edge: [a, b], facet } => {
                write!(f, "the edge of vertices {a} and {b} has a facet on one side only (facet {facet})")
            }
            Self::Orientation { edge: [a, b], facets: [p, q] } => {
                write!(
                    f,
                    "facets {p} and {q} run through the edge of vertices {a} and {b} in the same direction"
                )
            }
            Self::NonManifoldEdge { edge: [a, b], facets } => {
                write!(f, "{facets} facets share the edge of vertices {a} and {b}")
            }
            Self::NonManifoldVertex { vertex } => {
                write!(f, "the facets around vertex {vertex} form more than one cycle")
            }
            Self::DegenerateCycle { facet } => {
                write!(f, "facet {facet} has fewer than three corners or a corner twice in a row")
            }
        }
    }
}

impl std::error::Error for Defect {}

/// An edge with its four neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Where the edge starts.
    pub source: u32,
    /// Where it ends.
    pub target: u32,
    /// The facet on its left.
    pub left: u32,
    /// The facet on its right.
    pub right: u32,
}

impl Mesh {
    /// Makes a mesh from facets given as vertex cycles: facet `i` is
    /// `corners[starts[i]..starts[i + 1]]`, counterclockwise seen from outside.
    ///
    /// Edges are numbered by their lower ends, the halfedge from the lower end first: the same list of
    /// facets gives the same mesh.
    ///
    /// # Errors
    /// The first [`Defect`] found, where the facets do not form a closed, orientable surface on which
    /// every vertex has one cycle of facets. Vertices on no facet are a `NonManifoldVertex`.
    ///
    /// # Panics
    /// If a corner is not below `vertices`, or `starts` is not increasing up to the number of corners.
    ///
    /// # Complexity
    /// Linear: a counting sort, and a table that finds the twins.
    pub fn from_cycles(vertices: usize, starts: &[u32], corners: &[u32]) -> Result<Self, Defect> {
        let facets = starts.len().saturating_sub(1);
        let halfedge_of = Pairing::new(vertices, starts, corners)?.halfedges;
        let n = corners.len();
        let mut mesh = Self {
            source: vec![VertexId(0); n],
            facet: vec![FacetId(0); n],
            next: vec![HalfedgeId(0); n],
            prev: vec![HalfedgeId(0); n],
            outgoing: vec![HalfedgeId(u32::MAX); vertices],
            boundary: Vec::with_capacity(facets),
        };
        for f in 0..facets {
            let (begin, end) = (starts[f] as usize, starts[f + 1] as usize);
            mesh.boundary.push(halfedge_of[begin]);
            let mut prev = halfedge_of[end - 1];
            for c in begin..end {
                let h = halfedge_of[c];
                mesh.source[h.index()] = VertexId(corners[c]);
                mesh.facet[h.index()] = FacetId::new(f);
                mesh.prev[h.index()] = prev;
                mesh.next[prev.index()] = h;
                mesh.outgoing[corners[c] as usize] = h;
                prev = h;
            }
        }
        mesh.check_vertex_cycles()?;
        Ok(mesh)
    }

    /// One cycle of halfedges per vertex must reach them all.
    fn check_vertex_cycles(&self) -> Result<(), Defect> {
        let mut reached = 0;
        for v in self.vertices() {
            if self.outgoing(v).0 == u32::MAX {
                return Err(Defect::NonManifoldVertex { vertex: v.0 });
            }
            reached += self.vertex_cycle(v).count();
        }
        if reached == self.halfedge_count() {
            return Ok(());
        }
        // Some vertex has another cycle: find one whose stored cycle misses a halfedge.
        let mut seen = vec![false; self.halfedge_count()];
        for v in self.vertices() {
            for h in self.vertex_cycle(v) {
                seen[h.index()] = true;
            }
        }
        let missed = seen.iter().position(|&s| !s).expect("fewer halfedges were reached than there are");
        Err(Defect::NonManifoldVertex { vertex: self.source[missed].0 })
    }

    /// Makes a mesh from edges that know their ends and the facets on both sides; edge `i` becomes
    /// the halfedges `2 i` (from its source, left facet) and `2 i + 1`.
    ///
    /// # Panics
    /// As [`from_halfedges`](Self::from_halfedges).
    ///
    /// # Complexity
    /// Linear.
    pub fn from_edges(vertices: usize, facets: usize, edges: &[Edge]) -> Self {
        let sources = edges.iter().flat_map(|e| [VertexId(e.source), VertexId(e.target)]).collect();
        let left = edges.iter().flat_map(|e| [FacetId(e.left), FacetId(e.right)]).collect();
        Self::from_halfedges(vertices, facets, sources, left)
    }

    /// Makes a mesh from the source of every halfedge and the facet on its left; halfedges `2 i` and
    /// `2 i + 1` are twins.
    ///
    /// The halfedges of a facet must form one cycle through distinct vertices; this is checked in
    /// debug builds only.
    ///
    /// # Panics
    /// If the lists differ in length, or a vertex or facet is out of range, or a facet has no halfedge.
    ///
    /// # Complexity
    /// Linear: a counting sort by facet, and a table by vertex that links each facet's cycle.
    pub fn from_halfedges(
        vertices: usize,
        facets: usize,
        source: Vec<VertexId>,
        facet: Vec<FacetId>,
    ) -> Self {
        let n = source.len();
        assert_eq!(n, facet.len(), "every halfedge has a source and a facet");
        let mut mesh = Self {
            source,
            facet,
            next: vec![HalfedgeId(u32::MAX); n],
            prev: vec![HalfedgeId(u32::MAX); n],
            outgoing: vec![HalfedgeId(u32::MAX); vertices],
            boundary: Vec::with_capacity(facets),
        };
        let (starts, by_facet) = counting_sort(facets, &mesh.facet, |f| f.0);
        // leaving[v]: the halfedge of the facet at hand that starts at v.
        let mut leaving = vec![HalfedgeId(u32::MAX); vertices];
        for ends in starts.windows(2) {
            let cycle = &by_facet[ends[0] as usize..ends[1] as usize];
            for &h in cycle {
                let h = HalfedgeId(h);
                leaving[mesh.source(h).index()] = h;
            }
            for &h in cycle {
                let h = HalfedgeId(h);
                let next = leaving[mesh.target(h).index()];
                debug_assert!(mesh.facet(next) == mesh.facet(h) && mesh.source(next) == mesh.target(h));
                mesh.next[h.index()] = next;
                mesh.prev[next.index()] = h;
            }
            mesh.boundary.push(HalfedgeId(cycle[0]));
        }
        for (h, v) in mesh.source.iter().enumerate() {
            mesh.outgoing[v.index()] = HalfedgeId(h as u32);
        }
        mesh
    }
}

/// The corners of all facets, each standing for the directed edge to the next corner of its cycle, put
/// together in pairs of twins.
struct Pairing {
    /// The halfedge of each corner.
    halfedges: Vec<HalfedgeId>,
}

impl Pairing {
    fn new(vertices: usize, starts: &[u32], corners: &[u32]) -> Result<Self, Defect> {
        let n = corners.len();
        let mut targets = Vec::with_capacity(n);
        for (f, ends) in starts.windows(2).enumerate() {
            let cycle = &corners[ends[0] as usize..ends[1] as usize];
            let degenerate = Defect::DegenerateCycle { facet: f as u32 };
            let [first, .., last] = cycle else { return Err(degenerate) };
            if cycle.len() < 3 || first == last || cycle.windows(2).any(|pair| pair[0] == pair[1]) {
                return Err(degenerate);
            }
            targets.extend_from_slice(&cycle[1..]);
            targets.push(*first);
        }
        // The corners by the lower end of their edges; within such a group a table by the higher end
        // finds the twin.
        let low: Vec<u32> = corners.iter().zip(&targets).map(|(a, b)| *a.min(b)).collect();
        let (groups, sorted) = counting_sort(vertices, &low, |v| *v);
        let mut halfedges = vec![HalfedgeId(0); n];
        let mut waiting = vec![NOBODY; vertices];
        let mut edges = 0;
        for (v, ends) in groups.windows(2).enumerate() {
            let group = &sorted[ends[0] as usize..ends[1] as usize];
            for &c in group {
                let (source, target) = (corners[c as usize], targets[c as usize]);
                let slot = &mut waiting[source.max(target) as usize];
                if slot.low != v as u32 {
                    *slot = Waiting { low: v as u32, corner: c };
                    continue;
                }
                let other = std::mem::replace(&mut slot.corner, u32::MAX);
                if other == u32::MAX || corners[other as usize] == source {
                    return Err(defect(group, corners, &targets, starts));
                }
                // The halfedge from the lower end is the even one.
                let (even, odd) = if source == v as u32 { (c, other) } else { (other, c) };
                halfedges[even as usize] = HalfedgeId(edges);
                halfedges[odd as usize] = HalfedgeId(edges + 1);
                edges += 2;
            }
            if edges != ends[1] {
                return Err(defect(group, corners, &targets, starts));
            }
        }
        Ok(Self { halfedges })
    }
}

#[derive(Clone, Copy)]
struct Waiting {
    /// The lower end for which the entry was made.
    low: u32,
    /// The corner that waits for its twin, `u32::MAX` if the two have met.
    corner: u32,
}

const NOBODY: Waiting = Waiting { low: u32::MAX, corner: u32::MAX };

/// What is wrong with the edges at their lower end, of which one at least does not have two opposite
/// halfedges.
fn defect(group: &[u32], corners: &[u32], targets: &[u32], starts: &[u32]) -> Defect {
    let facet = |c: u32| starts.partition_point(|&start| start <= c) as u32 - 1;
    let ends = |c: u32| [corners[c as usize], targets[c as usize]];
    let mut by_edge = std::collections::BTreeMap::<u32, Vec<u32>>::new();
    for &c in group {
        by_edge.entry(ends(c)[0].max(ends(c)[1])).or_default().push(c);
    }
    let found = by_edge.values().find_map(|sides| match sides[..] {
        [c] => Some(Defect::Border { edge: ends(c), facet: facet(c) }),
        [c, d] if ends(c) == ends(d) => {
            Some(Defect::Orientation { edge: ends(c), facets: [facet(c), facet(d)] })
        }
        [_, _] => None,
        _ => Some(Defect::NonManifoldEdge { edge: ends(sides[0]), facets: sides.len() as u32 }),
    });
    found.expect("an edge without two opposite halfedges is one of these")
}

/// The indices of the items in the order of their keys, those of equal keys in order, and where each
/// key starts.
fn counting_sort<T>(keys: usize, items: &[T], key: impl Fn(&T) -> u32) -> (Vec<u32>, Vec<u32>) {
    // Counted two places up, so that filling moves each start to where it belongs.
    let mut starts = vec![0u32; keys + 2];
    for item in items {
        starts[key(item) as usize + 2] += 1;
    }
    let mut sum = 0;
    for start in &mut starts {
        sum += *start;
        *start = sum;
    }
    let mut sorted = vec![0; items.len()];
    for (i, item) in items.iter().enumerate() {
        let slot = &mut starts[key(item) as usize + 1];
        sorted[*slot as usize] = i as u32;
        *slot += 1;
    }
    starts.pop();
    (starts, sorted)
}
