//! From the two walks to the mesh of the sum.
//!
//! A vertex of the sum is a face of the overlay: a pair of a red and a blue vertex. A facet is a vertex
//! of the overlay: a red normal, a blue one, both at once, or a crossing. An edge is an edge of the
//! overlay, and each piece of a walk knows all four neighbours of one: so the mesh follows from the
//! list of pieces by counting sorts, without looking for anything.

use super::Cells;
use super::map::GaussianMap;
use super::trace::{Kind, Node, Place, Trace};
use crate::Polytope;
use crate::fault::{Fault, injected};
use crate::vectors::{EdgeOrigin, FacetOrigin, LazyVectors, Origins, Vectors};
use dcel::{Edge, HalfedgeId, Mesh};
use exact::{Point3, share_weight};
use std::sync::Arc;

/// Joins the walk of red through blue with that of blue through red.
pub(super) fn assemble(
    [red, blue]: [&GaussianMap<'_>; 2],
    [in_blue, in_red]: [&Trace; 2],
    summands: [Arc<Vectors>; 2],
) -> Polytope {
    // Facets: the red ones, the blue ones that are not red too, the crossings.
    let mut blue_facet = vec![u32::MAX; blue.mesh.facet_count()];
    for (f, place) in in_blue.places.iter().enumerate() {
        if let Place::Vertex(m) = place {
            blue_facet[m.index()] = f as u32;
        }
    }
    let red_facets = red.mesh.facet_count();
    let count = red_facets + blue_facet.len() - in_blue.counts.common_normals + in_blue.crossings.len();
    let mut facets: Vec<FacetOrigin> = Vec::with_capacity(count);
    facets.extend((0..red_facets as u32).map(FacetOrigin::First));
    for (m, facet) in blue_facet.iter_mut().enumerate() {
        if *facet == u32::MAX {
            *facet = facets.len() as u32;
            facets.push(FacetOrigin::Second(m as u32));
        }
    }
    // Red runs from the left to the right of blue: of the two places where the great circles meet, the
    // crossing is the one in the direction of the cross product.
    let first_crossing = facets.len() as u32;
    facets.extend(in_blue.crossings.iter().map(|c| FacetOrigin::Edges([c.red, c.blue])));
    debug_assert_eq!(facets.len(), count);
    if injected(Fault::FlippedNormal)
        && let Some(FacetOrigin::Edges([_, b])) = facets.last_mut()
    {
        *b = b.twin();
    }
    let same_crossing = match_crossings(red.mesh.edge_count(), blue.mesh.edge_count(), in_blue, in_red);

    // The pairs of vertices on the left and on the right of each piece, and the facets at its ends.
    let pieces = in_blue.pieces.len() + in_red.pieces.len();
    let mut pairs: Vec<[u32; 2]> = Vec::with_capacity(2 * pieces);
    let mut cells = Cells { edges: Vec::with_capacity(pieces), origins: Vec::with_capacity(pieces), facets };
    for piece in &in_blue.pieces {
        let facet = |node: Node| match node.kind() {
            Kind::Red(f) => f,
            Kind::Blue(m) => blue_facet[m as usize],
            Kind::Crossing(c) => first_crossing + c,
        };
        let (target, source) = (red.mesh.target(piece.arc).0, red.mesh.source(piece.arc).0);
        pairs.extend([[target, piece.blue[0].0], [source, piece.blue[1].0]]);
        cells.push(facet(piece.from), facet(piece.to), 0, piece.arc);
    }
    for piece in &in_red.pieces {
        if piece.blue[0] != piece.blue[1] {
            continue; // along a red arc: the other walk has it
        }
        let facet = |node: Node| match node.kind() {
            Kind::Red(m) => blue_facet[m as usize],
            Kind::Blue(f) => f,
            Kind::Crossing(c) => first_crossing + same_crossing[c as usize],
        };
        let (target, source) = (blue.mesh.target(piece.arc).0, blue.mesh.source(piece.arc).0);
        let v = piece.blue[0].0;
        pairs.extend([[v, target], [v, source]]);
        cells.push(facet(piece.from), facet(piece.to), 1, piece.arc);
    }

    if injected(Fault::DroppedEdge) {
        cells.edges.pop();
        cells.origins.pop();
        pairs.truncate(2 * cells.edges.len());
    }
    let points = number_pairs(red, blue, &pairs, &mut cells.edges);
    finish(points, cells, summands)
}

impl Cells {
    /// Adds the edge between two facets; its ends are numbered later.
    #[inline]
    fn push(&mut self, left: u32, right: u32, summand: u8, halfedge: HalfedgeId) {
        self.edges.push(Edge { source: 0, target: 0, left, right });
        self.origins.push(EdgeOrigin { summand, halfedge });
    }
}

/// For each crossing of the second walk its index in the first: two arcs cross at most once.
fn match_crossings(red_edges: usize, blue_edges: usize, in_blue: &Trace, in_red: &Trace) -> Vec<u32> {
    assert_eq!(in_blue.crossings.len(), in_red.crossings.len(), "both walks meet the same crossings");
    // The second walk's crossings by red edge. There, "red" is the map that walks: our blue one.
    let mut starts = vec![0u32; red_edges + 1];
    for crossing in &in_red.crossings {
        starts[crossing.blue.edge() + 1] += 1;
    }
    for e in 0..red_edges {
        starts[e + 1] += starts[e];
    }
    let mut by_red = vec![0u32; in_red.crossings.len()];
    let mut fill = starts.clone();
    for (c, crossing) in in_red.crossings.iter().enumerate() {
        let slot = &mut fill[crossing.blue.edge()];
        by_red[*slot as usize] = c as u32;
        *slot += 1;
    }
    // The first walk has the crossings of one red edge together.
    let mut same = vec![u32::MAX; in_red.crossings.len()];
    let mut index_at = vec![u32::MAX; blue_edges];
    let mut c = 0;
    while c < in_blue.crossings.len() {
        let e = in_blue.crossings[c].red.edge();
        while c < in_blue.crossings.len() && in_blue.crossings[c].red.edge() == e {
            index_at[in_blue.crossings[c].blue.edge()] = c as u32;
            c += 1;
        }
        for &d in &by_red[starts[e] as usize..starts[e + 1] as usize] {
            same[d as usize] = index_at[in_red.crossings[d as usize].red.edge()];
        }
    }
    same
}

/// Numbers the distinct pairs, in the order of their red and then the first use of their blue vertex,
/// sets the ends of the edges (the pair on the left of an overlay edge is the target of the edge), and
/// gives the points.
fn number_pairs(
    red: &GaussianMap<'_>,
    blue: &GaussianMap<'_>,
    pairs: &[[u32; 2]],
    edges: &mut [Edge],
) -> Vec<Point3> {
    let vertices = red.mesh.vertex_count();
    let mut starts = vec![0u32; vertices + 1];
    for [v, _] in pairs {
        starts[*v as usize + 1] += 1;
    }
    for v in 0..vertices {
        starts[v + 1] += starts[v];
    }
    let mut by_red = vec![[0u32; 2]; pairs.len()];
    let mut fill = starts.clone();
    for (i, [v, w]) in pairs.iter().enumerate() {
        let slot = &mut fill[*v as usize];
        by_red[*slot as usize] = [i as u32, *w];
        *slot += 1;
    }
    // Over one weight, if it stays narrow, a sum of points is a sum of integers.
    let mut summands = [red.points, blue.points].concat();
    share_weight(&mut summands);
    let (red_points, blue_points) = summands.split_at(red.points.len());
    let mut points: Vec<Point3> = Vec::with_capacity(pairs.len() / 4);
    let mut number = vec![(u32::MAX, 0); blue.mesh.vertex_count()];
    for v in 0..vertices {
        for &[i, w] in &by_red[starts[v] as usize..starts[v + 1] as usize] {
            let slot = &mut number[w as usize];
            if slot.0 != v as u32 {
                *slot = (v as u32, points.len() as u32);
                let w = if injected(Fault::WrongVertex) && v == 0 { 0 } else { w };
                points.push(red_points[v].plus(&blue_points[w as usize]));
            }
            let edge = &mut edges[i as usize / 2];
            *(if i % 2 == 0 { &mut edge.target } else { &mut edge.source }) = slot.1;
        }
    }
    points
}

/// Takes out the digons and makes the polytope.
fn finish(points: Vec<Point3>, mut cells: Cells, summands: [Arc<Vectors>; 2]) -> Polytope {
    let mut facets = cells.facets.len();
    debug_assert_eq!(points.len() + facets, cells.edges.len() + 2, "the overlay subdivides a sphere");
    let mut degree = vec![0u32; facets];
    for edge in &cells.edges {
        degree[edge.left as usize] += 1;
        degree[edge.right as usize] += 1;
    }
    if degree.contains(&2) && !injected(Fault::SkippedDigons) {
        facets = merge_digons(&mut cells, &degree);
    }
    let mesh = Mesh::from_edges(points.len(), facets, &cells.edges);
    let dimension = if facets == 2 { 2 } else { 3 };
    let origins = Origins { summands, edges: cells.origins, facets: cells.facets };
    Polytope { dimension, points, mesh, vectors: LazyVectors::inherited(origins) }
}

/// Replaces every chain of edges separated by digons by one edge, drops the digons, and returns the
/// number of facets left.
fn merge_digons(cells: &mut Cells, degree: &[u32]) -> usize {
    let digon = |f: u32| degree[f as usize] == 2;
    let mut number = Vec::with_capacity(degree.len());
    let mut kept = 0;
    for f in 0..degree.len() {
        number.push(kept);
        kept += u32::from(!digon(f as u32));
    }
    // The two edges of each digon.
    let mut of_digon = vec![[u32::MAX; 2]; degree.len()];
    for (e, edge) in cells.edges.iter().enumerate() {
        for f in [edge.left, edge.right] {
            if digon(f) {
                let slots = &mut of_digon[f as usize];
                slots[usize::from(slots[0] != u32::MAX)] = e as u32;
            }
        }
    }
    let mut seen = vec![false; cells.edges.len()];
    let mut edges = Vec::with_capacity(cells.edges.len());
    let mut origins = Vec::with_capacity(cells.edges.len());
    for (e, edge) in cells.edges.iter().enumerate() {
        // A chain starts at a facet that stays; it is seen so that it lies on the left.
        let reversed = Edge { source: edge.target, target: edge.source, left: edge.right, right: edge.left };
        let (first, origin) = match (digon(edge.left), digon(edge.right)) {
            (false, _) => (*edge, cells.origins[e]),
            (true, false) => {
                let EdgeOrigin { summand, halfedge } = cells.origins[e];
                (reversed, EdgeOrigin { summand, halfedge: halfedge.twin() })
            }
            (true, true) => continue,
        };
        if std::mem::replace(&mut seen[e], true) {
            continue;
        }
        let (mut right, mut last) = (first.right, e);
        while digon(right) {
            let [a, b] = of_digon[right as usize];
            last = if a as usize == last { b } else { a } as usize;
            seen[last] = true;
            let next = &cells.edges[last];
            right = if next.left == right { next.right } else { next.left };
        }
        edges.push(Edge { left: number[first.left as usize], right: number[right as usize], ..first });
        origins.push(origin);
    }
    let mut f = 0;
    cells.facets.retain(|_| {
        f += 1;
        !digon(f as u32 - 1)
    });
    cells.edges = edges;
    cells.origins = origins;
    kept as usize
}
