//! The squared distance by all pairs of features: the least over those whose nearest points are inside of both.

use crate::number::{Fraction, Number, Triple, cross, dot, is_zero, keep_least, minus, plus};
use crate::planes::Brute;
use crate::solid::Solid;
use std::cmp::Ordering;

impl<N: Number> Brute<N> {
    /// The squared distance of disjoint polytopes, and of touching ones in parallel planes, not yet divided by the square of the scale.
    /// Where the interiors meet it means nothing.
    pub(crate) fn squared_distance(&self, s: &Triple<N>) -> Fraction<N> {
        let moved: Vec<Triple<N>> = self.q.vertices.iter().map(|vertex| plus(vertex, s)).collect();
        let q = Solid { vertices: moved, edges: self.q.edges.clone(), facets: self.q.facets.clone() };
        squared_distance(&self.p, &q)
    }
}

/// The least over all pairs of features of two solids.
pub(crate) fn squared_distance<N: Number>(p: &Solid<N>, q: &Solid<N>) -> Fraction<N> {
    let mut least = None;
    for a in &p.vertices {
        for b in &q.vertices {
            let w = minus(a, b);
            let one = N::of(&exact::Integer::from(1));
            keep_least(&mut least, Fraction(dot(&w, &w), one));
        }
    }
    for (points, solid) in [(p, q), (q, p)] {
        for x in &points.vertices {
            for &[a, b] in &solid.edges {
                vertex_edge(x, &solid.vertices[a], &solid.vertices[b], &mut least);
            }
            for (cycle, normal) in &solid.facets {
                vertex_facet(x, solid, cycle, normal, &mut least);
            }
        }
    }
    let edges = |solid: &Solid<N>| -> Vec<(Triple<N>, Triple<N>)> {
        solid.edges.iter().map(|&edge| (solid.vertices[edge[0]].clone(), solid.edge_vector(edge))).collect()
    };
    let (of_p, of_q) = (edges(p), edges(q));
    for e in &of_p {
        for f in &of_q {
            edge_edge(e, f, &mut least);
        }
    }
    least.expect("there are vertices")
}

/// A vertex, and a point inside of an edge.
fn vertex_edge<N: Number>(x: &Triple<N>, a: &Triple<N>, b: &Triple<N>, least: &mut Option<Fraction<N>>) {
    let (u, w) = (minus(b, a), minus(x, a));
    let (length, along) = (dot(&u, &u), dot(&u, &w));
    if along.sign() == Ordering::Greater && length.sub(&along).sign() == Ordering::Greater {
        let n = cross(&u, &w);
        keep_least(least, Fraction(dot(&n, &n), length));
    }
}

/// A vertex, and a point of a facet.
fn vertex_facet<N: Number>(
    x: &Triple<N>,
    solid: &Solid<N>,
    cycle: &[usize],
    normal: &Triple<N>,
    least: &mut Option<Fraction<N>>,
) {
    let at = |i: usize| &solid.vertices[cycle[i % cycle.len()]];
    let is_above = (0..cycle.len()).all(|i| {
        let inwards = cross(normal, &minus(at(i + 1), at(i)));
        dot(&inwards, &minus(x, at(i))).sign() != Ordering::Less
    });
    if is_above {
        let height = dot(normal, &minus(x, at(0)));
        keep_least(least, Fraction(height.mul(&height), dot(normal, normal)));
    }
}

/// Points of two edges that are not parallel: a point and a vector each.
fn edge_edge<N: Number>(
    (a, u): &(Triple<N>, Triple<N>),
    (b, v): &(Triple<N>, Triple<N>),
    least: &mut Option<Fraction<N>>,
) {
    let n = cross(u, v);
    if is_zero(&n) {
        return;
    }
    let w = minus(b, a);
    let squared_length = dot(&n, &n);
    // The nearest points of both lines are a + i u / |n|^2 and b + j v / |n|^2.
    let (i, j) = (dot(&cross(&w, v), &n), dot(&cross(&w, u), &n));
    let is_inside =
        |t: &N| t.sign() != Ordering::Less && squared_length.sub(t).sign() != Ordering::Less;
    if is_inside(&i) && is_inside(&j) {
        let height = dot(&n, &w);
        keep_least(least, Fraction(height.mul(&height), squared_length));
    }
}
