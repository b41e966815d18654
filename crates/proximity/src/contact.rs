//! The points and the features where two faces meet.

use crate::Feature;
use crate::bodies::Bodies;
use dcel::{HalfedgeId, VertexId};
use exact::{Point3, Rational, Sign, Vector3, predicate};
use polytope::Polytope;

/// Rational coordinates of a point or a vector.
pub(crate) type Coordinates = [Rational; 3];

/// The point of M closest to s.
#[derive(Clone, Debug)]
pub(crate) struct Foot {
    pub(crate) point: Coordinates,
    /// The face of M in this direction contains the point: an outer normal, or, for an M that lies in a plane, zero where s
    /// lies in M.
    pub(crate) normal: Vector3,
}

impl Foot {
    /// At a vertex.
    pub(crate) fn at(point: &Point3, s: &Point3) -> Self {
        Self { point: point.coordinates(), normal: point.direction_to(s) }
    }

    /// The projection to a line.
    pub(crate) fn on_line(edge: &Vector3, on: &Point3, s: &Point3) -> Self {
        let away = on.direction_to(s);
        let normal = edge.cross(&away).cross(edge);
        let (e, o) = (rationals(edge), on.coordinates());
        let part = quotient(&dot(&e, &minus(&s.coordinates(), &o)), &dot(&e, &e));
        Self { point: plus(&o, &times(&e, &part)), normal }
    }

    /// The projection to a plane.
    pub(crate) fn on_plane(normal: &Vector3, on: &Point3, s: &Point3) -> Self {
        let (n, x) = (rationals(normal), s.coordinates());
        let part = quotient(&dot(&n, &minus(&on.coordinates(), &x)), &dot(&n, &n));
        let side = predicate::plane_side(normal, on, s);
        let normal = if side == Sign::Negative { -normal } else { normal.clone() };
        Self { point: plus(&x, &times(&n, &part)), normal }
    }
}

/// The pairs of points of P and Q whose difference is one point of M.
#[derive(Clone, Debug)]
pub(crate) struct Contact {
    /// The lexicographically least point of P that belongs to a pair.
    pub(crate) on_p: Coordinates,
    /// The least faces of P and Q that contain all of these points.
    pub(crate) features: [Feature; 2],
}

/// Finds all p - q = foot with p in P and q in the turned Q.
pub(crate) fn contact(bodies: &Bodies<'_>, foot: &Foot) -> Contact {
    let [first, second] = bodies.faces(&foot.normal);
    let p =
        corners(bodies.p, first).into_iter().map(|v| bodies.p.points()[v.index()].coordinates()).collect();
    let q: Vec<Coordinates> = corners(bodies.q, second)
        .into_iter()
        .map(|v| plus(&bodies.turned(v).coordinates(), &foot.point))
        .collect();
    let common = clipped(p, &half_spaces(&q));
    let least = common.iter().min().expect("a point of the sum is a difference of points of both faces");
    let count = Rational::from(common.len() as i64);
    let mean = [0, 1, 2].map(|i: usize| quotient(&common.iter().map(|x| x[i].clone()).sum(), &count));
    let of_q = minus(&mean, &foot.point);
    let point_of_p = |v: VertexId| bodies.p.points()[v.index()].coordinates();
    let point_of_q = |v: VertexId| bodies.turned(v).coordinates();
    Contact {
        on_p: least.clone(),
        features: [
            least_face(bodies.p, first, &mean, point_of_p),
            least_face(bodies.q, second, &of_q, point_of_q),
        ],
    }
}

/// The face of a polytope that is extreme in a direction; a polygon or a segment as a whole for the zero vector.
pub(crate) fn extreme_face(body: &Polytope, extreme: VertexId, direction: &Vector3) -> Feature {
    let mesh = body.mesh();
    if mesh.edge_count() == 0 {
        return Feature::Vertex(extreme);
    }
    let level: Vec<HalfedgeId> = mesh
        .vertex_cycle(extreme)
        .filter(|&h| predicate::same_direction(direction, &body.edge_vector(h)) == Sign::Zero)
        .collect();
    match level[..] {
        [] => Feature::Vertex(extreme),
        [h] => Feature::Edge(even(h)),
        [h, g, ..] => {
            let facets = |h: HalfedgeId| [mesh.facet(h), mesh.facet(h.twin())];
            let other = facets(g);
            let mut common = facets(h).into_iter().filter(|f| other.contains(f));
            let first = common.next().expect("two edges of a facet at a vertex");
            // A polygon has a front and a back with the same edges.
            let is_first = predicate::same_direction(direction, body.facet_normal(first)) != Sign::Negative;
            Feature::Facet(if is_first { first } else { common.next().unwrap_or(first) })
        }
    }
}

fn even(h: HalfedgeId) -> HalfedgeId {
    HalfedgeId(h.0 & !1)
}

/// The vertices of a feature, in order.
fn corners(body: &Polytope, feature: Feature) -> Vec<VertexId> {
    match feature {
        Feature::Vertex(v) => vec![v],
        Feature::Edge(h) => vec![body.mesh().source(h), body.mesh().target(h)],
        Feature::Facet(f) => body.facet_cycle(f).collect(),
    }
}

/// The face of a feature in whose relative interior a point of it lies.
fn least_face(
    body: &Polytope,
    feature: Feature,
    x: &Coordinates,
    point: impl Fn(VertexId) -> Coordinates,
) -> Feature {
    let of_edge = |h: HalfedgeId| {
        let ends = [body.mesh().source(h), body.mesh().target(h)];
        match ends.into_iter().find(|&v| point(v) == *x) {
            Some(v) => Feature::Vertex(v),
            None => Feature::Edge(even(h)),
        }
    };
    match feature {
        Feature::Vertex(_) => feature,
        Feature::Edge(h) => of_edge(h),
        Feature::Facet(f) => {
            let holds = |h: &HalfedgeId| {
                let (a, b) = (point(body.mesh().source(*h)), point(body.mesh().target(*h)));
                cross(&minus(&b, &a), &minus(x, &a)).iter().all(Rational::is_zero)
            };
            body.mesh().facet_cycle(f).find(holds).map_or(feature, of_edge)
        }
    }
}

/// Normals and offsets: a point x belongs if normal . x <= offset for all.
type HalfSpaces = Vec<(Coordinates, Rational)>;

/// Half-spaces whose common part is a point, a segment, or a polygon within its plane, given by corners in order.
fn half_spaces(corners: &[Coordinates]) -> HalfSpaces {
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|axis: [i64; 3]| axis.map(Rational::from));
    let through = |normal: Coordinates, on: &Coordinates| {
        let offset = dot(&normal, on);
        (normal, offset)
    };
    let on_both_sides = |normal: Coordinates, on: &Coordinates| {
        let opposite = normal.each_ref().map(|c| -c);
        [through(normal, on), through(opposite, on)]
    };
    match corners {
        [a] => axes.into_iter().flat_map(|axis| on_both_sides(axis, a)).collect(),
        [a, b] => {
            let edge = minus(b, a);
            let across = axes.iter().map(|axis| cross(&edge, axis));
            let mut spaces: HalfSpaces = across.flat_map(|normal| on_both_sides(normal, a)).collect();
            spaces.push(through(minus(a, b), a));
            spaces.push(through(edge, b));
            spaces
        }
        _ => {
            let normal = cross(&minus(&corners[1], &corners[0]), &minus(&corners[2], &corners[1]));
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).map(|(a, b)| through(cross(&minus(b, a), &normal), a)).collect()
        }
    }
}

/// The part of a point, a segment or a convex polygon in all half-spaces: its corners, perhaps repeated.
///
/// # References
/// I. Sutherland, G. Hodgman, "Reentrant polygon clipping" (1974).
fn clipped(mut corners: Vec<Coordinates>, spaces: &HalfSpaces) -> Vec<Coordinates> {
    for (normal, offset) in spaces {
        let heights: Vec<Rational> = corners.iter().map(|x| dot(normal, x) - offset).collect();
        if heights.iter().all(|height| height.sign() != Sign::Positive) {
            continue;
        }
        let mut kept = Vec::with_capacity(corners.len() + 1);
        for i in 0..corners.len() {
            let j = (i + 1) % corners.len();
            if heights[i].sign() != Sign::Positive {
                kept.push(corners[i].clone());
            }
            if heights[i].sign() * heights[j].sign() == Sign::Negative {
                let part = quotient(&heights[i], &(&heights[i] - &heights[j]));
                kept.push(plus(&corners[i], &times(&minus(&corners[j], &corners[i]), &part)));
            }
        }
        kept.dedup();
        corners = kept;
    }
    corners
}

pub(crate) fn rationals(vector: &Vector3) -> Coordinates {
    vector.coordinates().map(Rational::from)
}

pub(crate) fn plus(a: &Coordinates, b: &Coordinates) -> Coordinates {
    [0, 1, 2].map(|i: usize| &a[i] + &b[i])
}

pub(crate) fn minus(a: &Coordinates, b: &Coordinates) -> Coordinates {
    [0, 1, 2].map(|i: usize| &a[i] - &b[i])
}

pub(crate) fn times(a: &Coordinates, factor: &Rational) -> Coordinates {
    a.each_ref().map(|c| c * factor)
}

pub(crate) fn dot(a: &Coordinates, b: &Coordinates) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

pub(crate) fn cross(a: &Coordinates, b: &Coordinates) -> Coordinates {
    [0, 1, 2].map(|i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

pub(crate) fn quotient(a: &Rational, b: &Rational) -> Rational {
    a.checked_div(b)
        .expect("the divisor is the square of a vector, or a difference of two numbers on both sides of zero")
}
