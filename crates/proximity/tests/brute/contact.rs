//! Where two polytopes that only touch meet: the corners of what they have in common, and the faces that hold it.

use crate::number::{Triple, cross, dot, is_zero, minus, plus};
use crate::solid::Solid;
use exact::{Integer, Rational};
use polytope::{HalfedgeId, Polytope};
use splitstar_proximity::Feature;
use std::cmp::Ordering;

type Exact = Triple<Integer>;

/// A point with a common denominator that is positive.
type Weighted = (Exact, Integer);

/// A polytope, multiplied by a scale and then moved.
pub(crate) fn moved(polytope: &Polytope, scale: &Integer, by: &Exact) -> Solid<Integer> {
    let mut solid = Solid::<Integer>::new(polytope, scale);
    solid.vertices.iter_mut().for_each(|vertex| *vertex = plus(vertex, by));
    solid
}

/// The corners of the set that two solids have in common, if their interiors do not meet; some of them may be listed twice, or be no corners.
pub(crate) fn common_corners(p: &Solid<Integer>, q: &Solid<Integer>) -> Vec<Weighted> {
    let one = Integer::from(1);
    let mut corners = Vec::new();
    for (points, solid) in [(p, q), (q, p)] {
        let held = points.vertices.iter().filter(|vertex| holds(solid, vertex));
        corners.extend(held.map(|vertex| (vertex.clone(), one.clone())));
    }
    for &e in &p.edges {
        for &f in &q.edges {
            corners.extend(crossing(p, e, q, f));
        }
    }
    corners
}

/// Whether a point lies in a solid of any dimension.
pub(crate) fn holds(solid: &Solid<Integer>, x: &Exact) -> bool {
    holds_weighted(solid, &(x.clone(), Integer::from(1)))
}

/// Whether a point whose coordinates are rational, once multiplied by the scale of a solid, lies in it.
pub(crate) fn holds_rational(solid: &Solid<Integer>, scale: &Integer, x: &[Rational; 3]) -> bool {
    let weight = x.iter().fold(Integer::from(1), |weight, c| weight.lcm(&c.denominator()));
    let factor = Rational::from(scale * &weight);
    holds_weighted(solid, &(x.each_ref().map(|c| (c * &factor).numerator()), weight))
}

fn holds_weighted(solid: &Solid<Integer>, (x, weight): &Weighted) -> bool {
    let from = |v: usize| minus(x, &solid.vertices[v].each_ref().map(|c| c * weight));
    let is_beyond = |(cycle, normal): &(Vec<usize>, Exact)| dot(normal, &from(cycle[0])).gt_zero();
    match (&solid.edges[..], &solid.facets[..]) {
        ([], _) => is_zero(&from(0)),
        ([edge], _) => {
            let (u, w) = (solid.edge_vector(*edge), from(edge[0]));
            let along = dot(&u, &w);
            is_zero(&cross(&u, &w)) && !along.lt_zero() && along <= dot(&u, &u) * weight
        }
        (_, [front @ (cycle, normal), back]) => {
            let is_left = |i: usize| {
                let (a, b) = (cycle[i], cycle[(i + 1) % cycle.len()]);
                let inwards = cross(normal, &solid.edge_vector([a, b]));
                !dot(&inwards, &from(a)).lt_zero()
            };
            !is_beyond(front) && !is_beyond(back) && (0..cycle.len()).all(is_left)
        }
        (_, facets) => !facets.iter().any(is_beyond),
    }
}

/// Where two edges that are not parallel cross.
fn crossing(p: &Solid<Integer>, e: [usize; 2], q: &Solid<Integer>, f: [usize; 2]) -> Option<Weighted> {
    let (u, v) = (p.edge_vector(e), q.edge_vector(f));
    let n = cross(&u, &v);
    let a = &p.vertices[e[0]];
    let w = minus(&q.vertices[f[0]], a);
    if is_zero(&n) || !dot(&n, &w).is_zero() {
        return None;
    }
    let squared_length = dot(&n, &n);
    let [i, j] = [dot(&cross(&w, &v), &n), dot(&cross(&w, &u), &n)];
    let is_inside = |t: &Integer| !t.lt_zero() && *t <= squared_length;
    let point = [0, 1, 2].map(|axis: usize| &a[axis] * &squared_length + &i * &u[axis]);
    (is_inside(&i) && is_inside(&j)).then_some((point, squared_length))
}

/// The first of some points in lexicographic order, divided by a scale.
pub(crate) fn first(corners: &[Weighted], scale: &Integer) -> Option<[Rational; 3]> {
    let rational = |(point, weight): &Weighted| {
        point.each_ref().map(|c| Rational::new(c.clone(), weight * scale).expect("weights are not zero"))
    };
    corners.iter().map(rational).min()
}

/// Whether a feature is the smallest face of a solid that has all these points, which lie in it; a polygon has two sides.
pub(crate) fn is_smallest_face(feature: Feature, solid: &Solid<Integer>, corners: &[Weighted]) -> bool {
    let away = |(point, weight): &Weighted, vertex: usize| {
        minus(point, &solid.vertices[vertex].each_ref().map(|c| c * weight))
    };
    let at = |v: usize| corners.iter().all(|corner| is_zero(&away(corner, v)));
    let along = |&[a, b]: &[usize; 2]| {
        corners.iter().all(|corner| is_zero(&cross(&away(corner, a), &solid.edge_vector([a, b]))))
    };
    let on = |(cycle, normal): &(Vec<usize>, Exact)| {
        corners.iter().all(|corner| dot(normal, &away(corner, cycle[0])).is_zero())
    };
    let vertex = (0..solid.vertices.len()).find(|&v| at(v));
    let edge = solid.edges.iter().position(along);
    match feature {
        Feature::Vertex(v) => vertex == Some(v.index()),
        Feature::Edge(h) => vertex.is_none() && h == HalfedgeId::new(2 * h.edge()) && edge == Some(h.edge()),
        Feature::Facet(f) => vertex.is_none() && edge.is_none() && on(&solid.facets[f.index()]),
    }
}

/// The vertices of a feature, in order.
pub(crate) fn vertices_of<N: crate::number::Number>(feature: Feature, solid: &Solid<N>) -> Vec<usize> {
    let mut vertices = match feature {
        Feature::Vertex(v) => vec![v.index()],
        Feature::Edge(h) => solid.edges[h.edge()].to_vec(),
        Feature::Facet(f) => solid.facets[f.index()].0.clone(),
    };
    vertices.sort_unstable();
    vertices
}

/// Signs of integers by name.
trait Signed {
    fn gt_zero(&self) -> bool;
    fn lt_zero(&self) -> bool;
}

impl Signed for Integer {
    fn gt_zero(&self) -> bool {
        self.cmp(&Integer::from(0)) == Ordering::Greater
    }

    fn lt_zero(&self) -> bool {
        self.cmp(&Integer::from(0)) == Ordering::Less
    }
}
