//! The Gaussian map of a polytope, in flat arrays.
//!
//! The map cuts the sphere of directions into faces, one for each vertex (the directions in which
//! that vertex is extreme); its arcs belong to edges and its vertices to facets. Everything is read
//! off the halfedge mesh:
//!
//! | mesh | map |
//! |---|---|
//! | facet `f` | vertex, the outer normal of `f` |
//! | halfedge `h` from `s` to `t`, facets `L` left and `R` right | arc from the normal of `L` to that of `R`, on the great circle whose axis is the *edge vector*, turning counterclockwise about it; the face of `t` is on its left, that of `s` on its right |
//! | vertex `v` | face, bounded counterclockwise by the arcs of the halfedges into `v` in the order `h`, `prev(twin(h))` |
//! | facet cycle | the arcs that leave the map vertex, counterclockwise |
//!
//! Arcs are shorter than a half circle. A polygon or a segment has longer ones; they are cut by
//! *digons*, facets of two halfedges that stand for an edge with its normals on one great circle. The
//! sum takes them out again.

use crate::Polytope;
use crate::vectors::{VectorList, Vectors};
use dcel::{Edge, FacetId, HalfedgeId, Mesh, VertexId};
use exact::predicate::{self, Floats3};
use exact::{Integer, Point3, Sign, Vector3};
use std::borrow::Cow;
use std::sync::Arc;

/// What a Gaussian map is read off: the boundary of a polytope, with digons if its dimension is lower.
pub(super) struct Boundary<'p> {
    pub(super) points: &'p [Point3],
    pub(super) mesh: Cow<'p, Mesh>,
    pub(super) vectors: Arc<Vectors>,
}

impl<'p> Boundary<'p> {
    /// That of a polytope of dimension 1 to 3.
    pub(super) fn of(polytope: &'p Polytope) -> Self {
        let (mesh, vectors) = match polytope.dimension {
            3 => (Cow::Borrowed(&polytope.mesh), polytope.vectors.get().clone()),
            2 => of_polygon(polytope),
            1 => of_segment(polytope),
            _ => unreachable!("a point is added by a translation, without its map"),
        };
        Self { points: &polytope.points, mesh, vectors }
    }
}

/// A normal as the walk uses it.
#[derive(Clone, Copy)]
pub(super) struct Normal<'b> {
    floats: Floats3,
    pub(super) exact: &'b Vector3,
}

/// A Gaussian map whose arcs are all shorter than a half circle.
pub(super) struct GaussianMap<'b> {
    pub(super) points: &'b [Point3],
    pub(super) mesh: &'b Mesh,
    pub(super) edges: &'b VectorList,
    pub(super) normals: &'b [Vector3],
    /// Their floats, close together: nearly all that the walk reads of them.
    edge_floats: Vec<Floats3>,
    normal_floats: Vec<Floats3>,
    /// The halfedges into each vertex, counterclockwise around its face of the map.
    ring: Vec<HalfedgeId>,
    ring_starts: Vec<u32>,
    /// Where each halfedge stands in the ring of its target.
    ring_position: Vec<u32>,
}

impl<'b> GaussianMap<'b> {
    /// Arranges the arcs around the faces.
    ///
    /// # Complexity
    /// Linear.
    pub(super) fn new(boundary: &'b Boundary<'_>) -> Self {
        let mesh = &*boundary.mesh;
        let mut map = Self {
            points: boundary.points,
            mesh,
            edges: &boundary.vectors.edges,
            normals: &boundary.vectors.normals,
            edge_floats: boundary.vectors.edges.iter().map(|vector| Floats3::of(&vector)).collect(),
            normal_floats: boundary.vectors.normals.iter().map(Floats3::of).collect(),
            ring: Vec::with_capacity(mesh.halfedge_count()),
            ring_starts: Vec::with_capacity(mesh.vertex_count() + 1),
            ring_position: vec![0; mesh.halfedge_count()],
        };
        map.ring_starts.push(0);
        for v in map.mesh.vertices() {
            let first = map.mesh.outgoing(v).twin();
            let start = map.ring.len();
            let mut h = first;
            loop {
                map.ring_position[h.index()] = (map.ring.len() - start) as u32;
                map.ring.push(h);
                h = map.mesh.prev(h.twin());
                if h == first {
                    break;
                }
            }
            map.ring_starts.push(map.ring.len() as u32);
        }
        map
    }

    /// The arcs around the face of `v`, counterclockwise. Corner `i` of the face is where arc `i`
    /// starts.
    #[inline]
    pub(super) fn ring(&self, v: VertexId) -> &[HalfedgeId] {
        &self.ring[self.ring_starts[v.index()] as usize..self.ring_starts[v.index() + 1] as usize]
    }

    /// The index of the arc of `h` in the ring of its target.
    #[inline]
    pub(super) fn ring_position(&self, h: HalfedgeId) -> usize {
        self.ring_position[h.index()] as usize
    }

    #[inline]
    pub(super) fn normal(&self, f: FacetId) -> Normal<'b> {
        Normal { floats: self.normal_floats[f.index()], exact: &self.normals[f.index()] }
    }

    /// The side of the great circle of `arc` on which `normal` lies: positive on its left.
    #[inline]
    pub(super) fn side(&self, normal: Normal<'_>, arc: HalfedgeId) -> Sign {
        let edge = arc.edge();
        let sign = predicate::side_of_floats(&normal.floats, &self.edge_floats[edge])
            .unwrap_or_else(|| self.exact_side(normal, edge));
        if arc.0 & 1 == 0 { sign } else { -sign }
    }

    /// Rare, and kept out of the walk's code.
    #[cold]
    #[inline(never)]
    fn exact_side(&self, normal: Normal<'_>, edge: usize) -> Sign {
        predicate::side_of_circle(normal.exact, &self.edges.get(edge))
    }

    /// Where the arc of `h` ends.
    #[inline]
    pub(super) fn end(&self, h: HalfedgeId) -> FacetId {
        self.mesh.facet(h.twin())
    }

    /// For two directions `a` and `b` on the great circle of `arc`: positive if `b` comes after `a`
    /// by less than a half circle, zero if they are the same or opposite.
    pub(super) fn order_on(&self, arc: HalfedgeId, a: Normal<'_>, b: Normal<'_>) -> Sign {
        let sign = predicate::circle_order(&self.edges.get(arc.edge()), a.exact, b.exact);
        if arc.0 & 1 == 0 { sign } else { -sign }
    }
}

/// The axes of two arcs of two maps: positive if they turn the same way about parallel axes.
#[inline]
pub(super) fn same_turn(red: &GaussianMap<'_>, r: HalfedgeId, blue: &GaussianMap<'_>, b: HalfedgeId) -> Sign {
    let sign = predicate::same_direction(&red.edges.get(r.edge()), &blue.edges.get(b.edge()));
    if (r.0 ^ b.0) & 1 == 0 { sign } else { -sign }
}

type Parts<'p> = (Cow<'p, Mesh>, Arc<Vectors>);

/// Front and back normals joined by half circles, each cut in the middle, at the normal of the edge
/// within the plane of the polygon.
fn of_polygon(polytope: &Polytope) -> Parts<'_> {
    let n = polytope.points.len() as u32;
    let mut edges = Vec::with_capacity(2 * n as usize);
    let mut vectors = Vec::with_capacity(2 * n as usize);
    let given = polytope.vectors();
    let mut normals = given.normals.clone();
    for i in 0..n {
        // The halfedge on the front: the even one in a hull, either one in a sum.
        let even = HalfedgeId(2 * i);
        let h = if polytope.mesh.facet(even) == FacetId(0) { even } else { even.twin() };
        let (source, target) = (polytope.mesh.source(h).0, polytope.mesh.target(h).0);
        let digon = 2 + i;
        edges.push(Edge { source, target, left: 0, right: digon });
        edges.push(Edge { source, target, left: digon, right: 1 });
        let vector = &polytope.edge_vector(h);
        vectors.extend([vector.clone(), vector.clone()]);
        normals.push(vector.cross(&given.normals[0]).primitive());
    }
    let mesh = Mesh::from_edges(n as usize, 2 + n as usize, &edges);
    (Cow::Owned(mesh), Arc::new(Vectors { edges: vectors.into_iter().collect(), normals }))
}

/// One great circle, cut at four normals a quarter turn apart.
fn of_segment(polytope: &Polytope) -> Parts<'_> {
    let vector = &polytope.vectors().edges.get(0);
    let axes: [Vector3; 3] = std::array::from_fn(|axis| {
        Vector3::new(std::array::from_fn(|i| Integer::from(i64::from(i == axis))))
    });
    let across = axes.iter().map(|axis| vector.cross(axis)).find(|v| !v.is_zero());
    let a = across.expect("a nonzero vector is parallel to at most one axis").primitive();
    let b = vector.cross(&a).primitive();
    let normals = vec![a.clone(), b.clone(), -a, -b];
    let edges: Vec<Edge> =
        (0..4).map(|i| Edge { source: 0, target: 1, left: i, right: (i + 1) % 4 }).collect();
    let vectors = Vectors { edges: std::iter::repeat_n(vector.clone(), 4).collect(), normals };
    (Cow::Owned(Mesh::from_edges(2, 4, &edges)), Arc::new(vectors))
}
