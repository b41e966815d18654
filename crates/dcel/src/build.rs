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
    /// The halfedges are numbered by the lower, then the higher end of their edges, the one from the
    /// lower end first: the same list of facets gives the same mesh.
    ///
    /// # Errors
    /// The first [`Defect`] found, where the facets do not form a closed, orientable surface on which
    /// every vertex has one cycle of facets. Vertices on no facet are a `NonManifoldVertex`.
    ///
    /// # Panics
    /// If a corner is not below `vertices`, or `starts` is not increasing up to the number of corners.
    ///
    /// # Complexity
    /// Linear: two counting sorts pair the halfedges.
    pub fn from_cycles(vertices: usize, starts: &[u32], corners: &[u32]) -> Result<Self, Defect> {
        let facets = starts.len().saturating_sub(1);
        // A corner c stands for the directed edge from it to the next corner of its cycle.
        let n = corners.len();
        let mut facet_of = vec![0u32; n];
        let mut target_of = vec![0u32; n];
        for f in 0..facets {
            let (begin, end) = (starts[f] as usize, starts[f + 1] as usize);
            if end - begin < 3 {
                return Err(Defect::DegenerateCycle { facet: f as u32 });
            }
            for c in begin..end {
                let target = corners[if c + 1 == end { begin } else { c + 1 }];
                if target == corners[c] {
                    return Err(Defect::DegenerateCycle { facet: f as u32 });
                }
                facet_of[c] = f as u32;
                target_of[c] = target;
            }
        }
        // Sort the corners by the higher and then, stably, by the lower end of their edges.
        let by_high =
            counting_sort(vertices, 0..n as u32, |c| corners[c as usize].max(target_of[c as usize]));
        let sorted =
            counting_sort(vertices, by_high.into_iter(), |c| corners[c as usize].min(target_of[c as usize]));
        let ends = |c: u32| {
            let (a, b) = (corners[c as usize], target_of[c as usize]);
            (a.min(b), a.max(b))
        };
        // Neighbours in that order are twins.
        let mut halfedge_of = vec![HalfedgeId(0); n];
        let mut i = 0;
        while i < n {
            let c = sorted[i];
            let same = sorted[i..].iter().take_while(|&&d| ends(d) == ends(c)).count();
            let edge = [corners[c as usize], target_of[c as usize]];
            match same {
                2 => {
                    let d = sorted[i + 1];
                    if corners[c as usize] == corners[d as usize] {
                        let facets = [facet_of[c as usize], facet_of[d as usize]];
                        return Err(Defect::Orientation { edge, facets });
                    }
                    let (low, high) = if edge[0] < edge[1] { (c, d) } else { (d, c) };
                    halfedge_of[low as usize] = HalfedgeId::new(i);
                    halfedge_of[high as usize] = HalfedgeId::new(i + 1);
                }
                1 => return Err(Defect::Border { edge, facet: facet_of[c as usize] }),
                _ => return Err(Defect::NonManifoldEdge { edge, facets: same as u32 }),
            }
            i += 2;
        }
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
    /// The edges of a facet must form one cycle through distinct vertices; this is checked in debug
    /// builds only.
    ///
    /// # Panics
    /// If a vertex or facet is out of range or on no edge.
    ///
    /// # Complexity
    /// Linear: a counting sort by facet, and a table by vertex that links each facet's cycle.
    pub fn from_edges(vertices: usize, facets: usize, edges: &[Edge]) -> Self {
        let n = 2 * edges.len();
        let mut mesh = Self {
            source: Vec::with_capacity(n),
            facet: Vec::with_capacity(n),
            next: vec![HalfedgeId(u32::MAX); n],
            prev: vec![HalfedgeId(u32::MAX); n],
            outgoing: vec![HalfedgeId(u32::MAX); vertices],
            boundary: vec![HalfedgeId(u32::MAX); facets],
        };
        for edge in edges {
            mesh.source.extend([VertexId(edge.source), VertexId(edge.target)]);
            mesh.facet.extend([FacetId(edge.left), FacetId(edge.right)]);
        }
        let by_facet = counting_sort(facets, 0..n as u32, |h| mesh.facet[h as usize].0);
        // leaving[v]: the halfedge of the facet at hand that starts at v.
        let mut leaving = vec![HalfedgeId(u32::MAX); vertices];
        let mut i = 0;
        while i < n {
            let f = mesh.facet[by_facet[i] as usize];
            let mut end = i;
            while end < n && mesh.facet[by_facet[end] as usize] == f {
                let h = HalfedgeId(by_facet[end]);
                leaving[mesh.source(h).index()] = h;
                end += 1;
            }
            for &h in &by_facet[i..end] {
                let h = HalfedgeId(h);
                let next = leaving[mesh.target(h).index()];
                debug_assert!(mesh.facet(next) == f && mesh.source(next) == mesh.target(h));
                mesh.next[h.index()] = next;
                mesh.prev[next.index()] = h;
                let source = mesh.source(h);
                mesh.outgoing[source.index()] = h;
            }
            mesh.boundary[f.index()] = HalfedgeId(by_facet[i]);
            i = end;
        }
        mesh
    }
}

/// The items in the order of their keys; equal keys keep their order.
fn counting_sort(
    keys: usize,
    items: impl Iterator<Item = u32> + Clone,
    key: impl Fn(u32) -> u32,
) -> Vec<u32> {
    let mut starts = vec![0u32; keys + 1];
    let mut n = 0;
    for item in items.clone() {
        starts[key(item) as usize + 1] += 1;
        n += 1;
    }
    for k in 0..keys {
        starts[k + 1] += starts[k];
    }
    let mut sorted = vec![0; n];
    for item in items {
        let slot = &mut starts[key(item) as usize];
        sorted[*slot as usize] = item;
        *slot += 1;
    }
    sorted
}
