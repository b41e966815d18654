//! A polytope as lists of points and cells, all coordinates integers over one scale that is kept elsewhere.

use crate::number::{Number, Triple, cross, dot, is_zero, minus};
use exact::{Affine3, Integer, Point3, Rational};
use polytope::Polytope;

/// Vertices, edges and facets by the numbers of vertices.
#[derive(Clone, Debug)]
pub(crate) struct Solid<N> {
    pub(crate) vertices: Vec<Triple<N>>,
    pub(crate) edges: Vec<[usize; 2]>,
    /// The cycle of each facet, and its normal outwards; a polygon has both of its sides.
    pub(crate) facets: Vec<(Vec<usize>, Triple<N>)>,
}

/// The least common multiple of the denominators of two polytopes.
pub(crate) fn common_scale(p: &Polytope, q: &Polytope) -> Integer {
    let weights = p.points().iter().chain(q.points()).map(|point| point.canonical().weight());
    weights.fold(Integer::from(1), |scale, weight| scale.lcm(&weight))
}

impl<N: Number> Solid<N> {
    /// The polytope times `scale`, which must make all coordinates integers.
    pub(crate) fn new(polytope: &Polytope, scale: &Integer) -> Self {
        let scaled = polytope.transformed(&Affine3::scaling(&Rational::from(scale)));
        let vertices: Vec<Triple<N>> = scaled.points().iter().map(coordinates).collect();
        let mesh = polytope.mesh();
        let edges = mesh.edges().map(|h| [mesh.source(h).index(), mesh.target(h).index()]).collect();
        let mut facets = Vec::new();
        if polytope.dimension() >= 2 {
            for facet in mesh.facets() {
                let cycle: Vec<usize> = polytope.facet_cycle(facet).map(|v| v.index()).collect();
                let at = |i: usize| &vertices[cycle[i]];
                // Corners of maximal facets are strictly convex.
                let normal = cross(&minus(at(1), at(0)), &minus(at(2), at(1)));
                facets.push((cycle, normal));
            }
        }
        Self { vertices, edges, facets }
    }

    pub(crate) fn edge_vector(&self, [a, b]: [usize; 2]) -> Triple<N> {
        minus(&self.vertices[b], &self.vertices[a])
    }

    pub(crate) fn floats(&self) -> Vec<[f64; 3]> {
        self.vertices.iter().map(|vertex| vertex.each_ref().map(Number::approx)).collect()
    }

    /// The vertices that lie farthest in a direction, and how far.
    pub(crate) fn extreme(&self, direction: &Triple<N>) -> (N, Vec<usize>) {
        let mut best = dot(direction, &self.vertices[0]);
        let mut found = vec![0];
        for (v, vertex) in self.vertices.iter().enumerate().skip(1) {
            let height = dot(direction, vertex);
            match height.sub(&best).sign() {
                std::cmp::Ordering::Greater => (best, found) = (height, vec![v]),
                std::cmp::Ordering::Equal => found.push(v),
                std::cmp::Ordering::Less => {}
            }
        }
        (best, found)
    }

    /// How many vectors from the first of these vertices to the others are independent.
    pub(crate) fn dimension_of(&self, vertices: &[usize]) -> usize {
        let first = &self.vertices[vertices[0]];
        rank(&vertices[1..].iter().map(|&v| minus(&self.vertices[v], first)).collect::<Vec<_>>())
    }
}

fn coordinates<N: Number>(point: &Point3) -> Triple<N> {
    point.coordinates().map(|c| {
        assert!(c.is_integer(), "the scale makes integers");
        N::of(&c.numerator())
    })
}

/// The dimension of what vectors span.
pub(crate) fn rank<N: Number>(vectors: &[Triple<N>]) -> usize {
    let Some(first) = vectors.iter().find(|v| !is_zero(v)) else { return 0 };
    let normals = vectors.iter().map(|v| cross(first, v));
    let Some(normal) = normals.into_iter().find(|n| !is_zero(n)) else { return 1 };
    if vectors.iter().any(|v| !dot(&normal, v).is_zero()) { 3 } else { 2 }
}
