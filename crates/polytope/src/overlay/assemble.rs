//! From the two walks to the mesh of the sum.
//!
//! A vertex of the sum is a face of the overlay: a pair of a red and a blue vertex. A facet is a vertex
//! of the overlay: a red normal, a blue one, both at once, or a crossing. An edge is an edge of the
//! overlay, and each piece of a walk knows all four neighbours of one: so the mesh follows from the
//! list of pieces by counting sorts, without looking for anything.

use super::map::Boundary;
use super::record::{Kind, Place, Trace};
use crate::Polytope;
use crate::fault::{Fault, injected};
use crate::vectors::{EdgeOrigin, FacetOrigin, LazyVectors, Origins, Vectors};
use dcel::{FacetId, HalfedgeId, Mesh, VertexId};
use exact::{Adder, Point3};
use std::sync::Arc;

/// The edges and facets of the sum while they are collected.
struct Cells {
    /// The facet on the left of each halfedge; two halfedges an edge.
    left: Vec<FacetId>,
    /// Where each edge comes from.
    edges: Vec<EdgeOrigin>,
    /// Where each facet comes from.
    facets: Vec<FacetOrigin>,
}

/// Joins the walk of red through blue with that of blue through red.
pub(super) fn assemble([red, blue]: [&Boundary<'_>; 2], [in_blue, in_red]: [Trace; 2]) -> Polytope {
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
    let same_crossing = match_crossings([red, blue], [&in_blue, &in_red]);

    // The facets at the ends of each piece are those on the left and on the right of an edge.
    let pieces = in_blue.pieces.len() + in_red.pieces.len();
    let mut cells = Cells { left: Vec::with_capacity(2 * pieces), edges: Vec::with_capacity(pieces), facets };
    let mut arc = None;
    let mut from = 0;
    for piece in &in_blue.pieces {
        if arc.replace(piece.arc) != Some(piece.arc) {
            from = red.mesh.facet(piece.arc).0;
        }
        let to = match piece.to.kind() {
            Kind::Red(f) => f,
            Kind::Blue(m) => blue_facet[m as usize],
            Kind::Crossing(c) => first_crossing + c,
        };
        cells.push([from, to], 0, piece.arc);
        from = to;
    }
    let mut arc = None;
    for piece in &in_red.pieces {
        if arc.replace(piece.arc) != Some(piece.arc) {
            from = blue_facet[blue.mesh.facet(piece.arc).index()];
        }
        let to = match piece.to.kind() {
            Kind::Red(m) => blue_facet[m as usize],
            Kind::Blue(f) => f,
            Kind::Crossing(c) => first_crossing + same_crossing[c as usize],
        };
        // What runs along a red arc is known from the other walk.
        if piece.on.face().is_some() {
            cells.push([from, to], 1, piece.arc);
        }
        from = to;
    }
    if injected(Fault::DroppedEdge) {
        cells.edges.pop();
        cells.left.truncate(2 * cells.edges.len());
    }
    let (points, sources) = number_vertices([red, blue], &[in_blue, in_red], cells.left.len());
    finish(points, sources, cells, [&red.vectors, &blue.vectors].map(Arc::clone))
}

impl Cells {
    /// Adds the edge with the two facets on its left and on its right.
    #[inline]
    fn push(&mut self, sides: [u32; 2], summand: u32, halfedge: HalfedgeId) {
        self.left.extend(sides.map(FacetId));
        self.edges.push(EdgeOrigin::new(summand, halfedge));
    }
}

/// For each crossing of the second walk its index in the first: two arcs cross at most once.
fn match_crossings([red, blue]: [&Boundary<'_>; 2], [in_blue, in_red]: [&Trace; 2]) -> Vec<u32> {
    let (red_edges, blue_edges) = (red.mesh.edge_count(), blue.mesh.edge_count());
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

/// Calls `corner` with the red and the blue vertex at each corner of the sum, in the order of the
/// halfedges that start there. Each piece has a vertex on its right (the source of its edge) and one on
/// its left (the target).
fn for_each_corner(
    [red, blue]: [&Boundary<'_>; 2],
    [in_blue, in_red]: &[Trace; 2],
    mut corner: impl FnMut(VertexId, VertexId),
) {
    for piece in &in_blue.pieces {
        let [left, right] = piece.on.sides(&blue.mesh);
        corner(red.mesh.source(piece.arc), right);
        corner(red.mesh.target(piece.arc), left);
    }
    for piece in &in_red.pieces {
        if let Some(v) = piece.on.face() {
            corner(v, blue.mesh.source(piece.arc));
            corner(v, blue.mesh.target(piece.arc));
        }
    }
}

/// Numbers the vertices of the sum, in the order of their red and then the first use of their blue
/// vertex; gives their points, and the vertex at each of the corners.
fn number_vertices(
    maps: [&Boundary<'_>; 2],
    traces: &[Trace; 2],
    corners: usize,
) -> (Vec<Point3>, Vec<VertexId>) {
    let [red, blue] = maps;
    // Counted two places up, so that filling moves each start to where it belongs.
    let mut starts = vec![0u32; red.mesh.vertex_count() + 2];
    for_each_corner(maps, traces, |v, _| starts[v.index() + 2] += 1);
    let mut sum = 0;
    for start in &mut starts {
        sum += *start;
        *start = sum;
    }
    let mut by_red = vec![[0u32; 2]; sum as usize];
    let mut i = 0;
    for_each_corner(maps, traces, |v, w| {
        let slot = &mut starts[v.index() + 1];
        by_red[*slot as usize] = [i, w.0];
        *slot += 1;
        i += 1;
    });
    starts.pop();
    let mut sources = vec![VertexId(u32::MAX); sum as usize];
    let mut adder = Adder::default();
    let mut points: Vec<Point3> = Vec::with_capacity(by_red.len() / 4);
    let mut number = vec![(u32::MAX, 0); blue.mesh.vertex_count()];
    for (v, group) in starts.windows(2).enumerate() {
        for &[i, w] in &by_red[group[0] as usize..group[1] as usize] {
            let slot = &mut number[w as usize];
            if slot.0 != v as u32 {
                *slot = (v as u32, points.len() as u32);
                let w = if injected(Fault::WrongVertex) && v == 0 { 0 } else { w };
                points.push(adder.sum(&red.points[v], &blue.points[w as usize]));
            }
            sources[i as usize] = VertexId(slot.1);
        }
    }
    sources.truncate(corners);
    (points, sources)
}

/// Takes out the digons and makes the polytope.
fn finish(
    points: Vec<Point3>,
    sources: Vec<VertexId>,
    cells: Cells,
    summands: [Arc<Vectors>; 2],
) -> Polytope {
    let facets = cells.facets.len();
    debug_assert_eq!(points.len() + facets, cells.edges.len() + 2, "the overlay subdivides a sphere");
    let mut degree = vec![0u32; facets];
    for f in &cells.left {
        degree[f.index()] += 1;
    }
    let digons = degree.contains(&2) && !injected(Fault::SkippedDigons);
    let (sources, cells) = if digons { merge_digons(&sources, &cells, &degree) } else { (sources, cells) };
    let facets = cells.facets.len();
    let mesh = Mesh::from_halfedges(points.len(), facets, sources, cells.left);
    let dimension = if facets == 2 { 2 } else { 3 };
    let origins = Origins { summands, edges: cells.edges, facets: cells.facets };
    Polytope { dimension, points, mesh, vectors: LazyVectors::inherited(origins) }
}

/// Replaces every chain of edges separated by digons by one edge, and drops the digons.
fn merge_digons(sources: &[VertexId], cells: &Cells, degree: &[u32]) -> (Vec<VertexId>, Cells) {
    let is_digon = |f: FacetId| degree[f.index()] == 2;
    let mut merged = Cells { left: Vec::new(), edges: Vec::new(), facets: Vec::new() };
    let mut number = vec![FacetId(u32::MAX); degree.len()];
    for (f, origin) in cells.facets.iter().enumerate().filter(|(f, _)| degree[*f] != 2) {
        number[f] = FacetId::new(merged.facets.len());
        merged.facets.push(*origin);
    }
    // The two halfedges of each digon.
    let mut of_digon = vec![[u32::MAX; 2]; degree.len()];
    for (h, f) in cells.left.iter().enumerate().filter(|(_, f)| is_digon(**f)) {
        let slots = &mut of_digon[f.index()];
        slots[usize::from(slots[0] != u32::MAX)] = h as u32;
    }
    let mut seen = vec![false; cells.edges.len()];
    let mut new_sources = Vec::new();
    for h in (0..cells.left.len()).map(HalfedgeId::new) {
        // A chain starts at a facet that stays, and is walked across its digons to the next such facet.
        if is_digon(cells.left[h.index()]) || seen[h.edge()] {
            continue;
        }
        let mut last = h;
        seen[h.edge()] = true;
        while is_digon(cells.left[last.twin().index()]) {
            let [a, b] = of_digon[cells.left[last.twin().index()].index()];
            last = HalfedgeId(if a == last.twin().0 { b } else { a });
            seen[last.edge()] = true;
        }
        let sides = [cells.left[h.index()], cells.left[last.twin().index()]];
        merged.left.extend(sides.map(|f| number[f.index()]));
        new_sources.extend([sources[h.index()], sources[h.twin().index()]]);
        let origin = cells.edges[h.edge()];
        merged.edges.push(if h.0 & 1 == 0 { origin } else { origin.reversed() });
    }
    (new_sources, merged)
}
