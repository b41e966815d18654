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
    let is_inside = |t: &N| t.sign() != Ordering::Less && squared_length.sub(t).sign() != Ordering::Less;
    if is_inside(&i) && is_inside(&j) {
        let height = dot(&n, &w);
        keep_least(least, Fraction(height.mul(&height), squared_length));
    }
}

/// The same for solids with many features: floats tell which pairs are far from the nearest, and the others are compared exactly.
pub(crate) fn squared_distance_of_many<N: Number>(p: &Solid<N>, q: &Solid<N>) -> Fraction<N> {
    let floats = [p.floats(), q.floats()];
    let spans = |solid: &Solid<N>, floats: &[[f64; 3]]| -> Vec<[[f64; 3]; 2]> {
        solid.edges.iter().map(|&[a, b]| [floats[a], floats[b]]).collect()
    };
    let edges = [spans(p, &floats[0]), spans(q, &floats[1])];
    let mut of_edges = Vec::with_capacity(edges[0].len() * edges[1].len());
    for e in &edges[0] {
        of_edges.extend(edges[1].iter().map(|f| approx::edges(e, f)));
    }
    // A vertex of one, and a facet of the other: which solid has the vertex, the vertex, the facet.
    let mut of_facets: Vec<(f64, [usize; 3])> = Vec::new();
    for (side, (solid, points)) in [(q, &floats[0]), (p, &floats[1])].into_iter().enumerate() {
        for (facet, (cycle, normal)) in solid.facets.iter().enumerate() {
            let corners: Vec<[f64; 3]> = cycle.iter().map(|&v| floats[1 - side][v]).collect();
            let normal = normal.each_ref().map(Number::approx);
            let found = points
                .iter()
                .enumerate()
                .map(|(v, x)| (approx::facet(x, &corners, &normal), [side, v, facet]));
            of_facets.extend(found.filter(|(distance, _)| distance.is_finite()));
        }
    }
    let nearest =
        of_edges.iter().chain(of_facets.iter().map(|(d, _)| d)).fold(f64::INFINITY, |a, &b| a.min(b));
    let size = floats.iter().flatten().flatten().fold(0.0, |a: f64, b| a.max(b.abs()));
    let limit = 1.01 * nearest + 1e-6 * size;
    let mut least = None;
    for (number, _) in of_edges.iter().enumerate().filter(|(_, distance)| **distance <= limit) {
        let [e, f] = [p.edges[number / q.edges.len()], q.edges[number % q.edges.len()]];
        let of = |solid: &Solid<N>, ends: [usize; 2]| Solid {
            vertices: ends.iter().map(|&v| solid.vertices[v].clone()).collect(),
            edges: vec![[0, 1]],
            facets: Vec::new(),
        };
        keep_least(&mut least, squared_distance(&of(p, e), &of(q, f)));
    }
    for (_, [side, v, facet]) in of_facets.iter().filter(|(distance, _)| *distance <= limit) {
        let (x, solid) = if *side == 0 { (&p.vertices[*v], q) } else { (&q.vertices[*v], p) };
        let (cycle, normal) = &solid.facets[*facet];
        vertex_facet(x, solid, cycle, normal, &mut least);
    }
    least.expect("the nearest pair is within the limit")
}

/// Distances in floats, to leave out what is far.
mod approx {
    type Point = [f64; 3];

    fn minus(a: &Point, b: &Point) -> Point {
        [0, 1, 2].map(|i| a[i] - b[i])
    }

    fn dot(a: &Point, b: &Point) -> f64 {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    fn cross(a: &Point, b: &Point) -> Point {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    }

    /// Of two segments: the least distance of an end of one to the other, and of the lines if their nearest points are inside.
    pub(super) fn edges(e: &[Point; 2], f: &[Point; 2]) -> f64 {
        let ends = [point(&e[0], f), point(&e[1], f), point(&f[0], e), point(&f[1], e)];
        let least = ends.into_iter().fold(f64::INFINITY, f64::min);
        let (u, v, w) = (minus(&e[1], &e[0]), minus(&f[1], &f[0]), minus(&f[0], &e[0]));
        let n = cross(&u, &v);
        let squared_length = dot(&n, &n);
        let is_inside = |t: f64| (-0.01..=1.01).contains(&(t / squared_length));
        if is_inside(dot(&cross(&w, &v), &n)) && is_inside(dot(&cross(&w, &u), &n)) {
            return least.min(dot(&n, &w).abs() / squared_length.sqrt());
        }
        least
    }

    fn point(x: &Point, [a, b]: &[Point; 2]) -> f64 {
        let (u, w) = (minus(b, a), minus(x, a));
        let t = (dot(&u, &w) / dot(&u, &u)).clamp(0.0, 1.0);
        let off = [0, 1, 2].map(|i| w[i] - t * u[i]);
        dot(&off, &off).sqrt()
    }

    /// Of a point above a facet, or nearly so; infinite for other points.
    pub(super) fn facet(x: &Point, corners: &[Point], normal: &Point) -> f64 {
        let length = dot(normal, normal).sqrt();
        let is_above = (0..corners.len()).all(|i| {
            let (a, b) = (&corners[i], &corners[(i + 1) % corners.len()]);
            let edge = minus(b, a);
            let inwards = cross(normal, &edge);
            dot(&inwards, &minus(x, a)) >= -0.01 * length * dot(&edge, &edge)
        });
        if is_above { dot(normal, &minus(x, &corners[0])).abs() / length } else { f64::INFINITY }
    }
}
