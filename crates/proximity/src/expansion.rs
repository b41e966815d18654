//! A hull of vertices of M that grows where it must: the relation, and the depths, of a point s in M, without building M.
//!
//! The hull lies in M. A facet of it is *final* if no point of M lies beyond its plane; then it lies in the boundary of M. A facet
//! that is asked about and is not final makes the hull grow by a vertex of M beyond it, until one that answers is final. M has
//! finitely many vertices, so that happens.
//!
//! The facets are triangles, some of which may be coplanar. A new vertex replaces the triangles that it sees strictly: so no
//! new triangle is degenerate.

use crate::Relation;
use crate::bodies::{Bodies, Corner};
use crate::contact::{Coordinates, cross, dot, minus, plus, quotient, rationals, times};
use exact::proximity::{DepthBounds, DepthPlane, DepthPoint, QueryPoint, compare_depths, side_of_ray};
use exact::{Point3, Rational, Sign, Vector3, predicate};
use std::cmp::Ordering;

/// The hull, around a point that is asked about.
#[derive(Clone, Debug)]
pub(crate) struct Expansion<'b> {
    bodies: &'b Bodies<'b>,
    s: &'b QueryPoint,
    corners: Vec<Corner>,
    facets: Vec<Facet>,
}

/// A triangle of the hull, counterclockwise seen from outside.
#[derive(Clone, Debug)]
struct Facet {
    corners: [usize; 3],
    normal: Vector3,
    /// Where s lies.
    side: Sign,
    is_final: bool,
    /// How deep s lies below its plane, once that has been asked for.
    depth: Option<DepthBounds>,
}

/// A facet of M with its plane.
#[derive(Clone, Debug)]
pub(crate) struct Exit {
    pub(crate) normal: Vector3,
    /// The depth that was asked for.
    pub(crate) depth: Rational,
    /// A vertex of the facet.
    pub(crate) of: [u32; 2],
}

impl<'b> Expansion<'b> {
    /// Begins with a tetrahedron; `None` if M lies in a plane.
    pub(crate) fn new(bodies: &'b Bodies<'b>, s: &'b QueryPoint, start: [u32; 2]) -> Option<Self> {
        let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Vector3::from_i64);
        let extreme = |direction: &Vector3| bodies.corner(bodies.extreme(direction, start));
        let both = |directions: &[Vector3], is_good: &dyn Fn(&Corner) -> bool| {
            directions.iter().flat_map(|d| [extreme(d), extreme(&-d)]).find(|corner| is_good(corner))
        };
        let a = extreme(&axes[0]);
        let b = both(&axes, &|corner| corner.at != a.at)?;
        let edge = a.at.direction_to(&b.at);
        let axis = axes
            .iter()
            .find(|axis| !edge.cross(axis).is_zero())
            .expect("a vector is parallel to one axis at most");
        let across = edge.cross(axis);
        let around = [edge.cross(&across), across];
        let c = both(&around, &|corner| !edge.cross(&a.at.direction_to(&corner.at)).is_zero())?;
        let normal = edge.cross(&a.at.direction_to(&c.at));
        let side = |corner: &Corner| predicate::plane_side(&normal, &a.at, &corner.at);
        let d = both(std::slice::from_ref(&normal), &|corner| side(corner) != Sign::Zero)?;
        let is_above = side(&d) == Sign::Positive;
        let mut hull = Self { bodies, s, corners: vec![a, b, c, d], facets: Vec::new() };
        for [i, j, k] in [[0, 1, 2], [1, 0, 3], [2, 1, 3], [0, 2, 3]] {
            hull.add(if is_above { [j, i, k] } else { [i, j, k] });
        }
        Some(hull)
    }

    fn add(&mut self, corners: [usize; 3]) {
        let [a, b, c] = corners.map(|i| &self.corners[i].at);
        let normal = a.direction_to(b).cross(&a.direction_to(c));
        let side = predicate::plane_side(&normal, a, self.s.point());
        self.facets.push(Facet { corners, normal, side, is_final: false, depth: None });
    }

    fn point(&self, facet: &Facet) -> &Point3 {
        &self.corners[facet.corners[0]].at
    }

    /// Whether a point lies strictly above a facet.
    fn sees(&self, corner: &Corner, facet: &Facet) -> bool {
        predicate::plane_side(&facet.normal, self.point(facet), &corner.at) == Sign::Positive
    }

    /// Tells whether a facet is final; else the hull grows, and facets have other numbers.
    fn settle(&mut self, index: usize) -> bool {
        let facet = &self.facets[index];
        if facet.is_final {
            return true;
        }
        let from = self.corners[facet.corners[0]].of;
        let corner = self.bodies.corner(self.bodies.extreme(&facet.normal, from));
        if !self.sees(&corner, facet) {
            self.facets[index].is_final = true;
            return true;
        }
        let facets = std::mem::take(&mut self.facets);
        let (seen, kept): (Vec<Facet>, Vec<Facet>) =
            facets.into_iter().partition(|facet| self.sees(&corner, facet));
        let apex = self.corners.len();
        self.corners.push(corner);
        self.facets = kept;
        let edges: Vec<[usize; 2]> = seen.iter().flat_map(|f| edges(f.corners)).collect();
        for &[i, j] in edges.iter().filter(|[i, j]| !edges.contains(&[*j, *i])) {
            self.add([i, j, apex]);
        }
        false
    }

    /// How s lies to M; and a vertex near the place that tells.
    pub(crate) fn relation(&mut self) -> (Relation, [u32; 2]) {
        loop {
            let Some(index) = self.facets.iter().position(|facet| facet.side != Sign::Negative) else {
                return (Relation::Overlapping, self.corners[self.facets[0].corners[0]].of);
            };
            if self.settle(index) {
                let facet = &self.facets[index];
                let relation = if facet.side == Sign::Zero { Relation::Touching } else { Relation::Disjoint };
                return (relation, self.corners[facet.corners[0]].of);
            }
        }
    }

    /// The outer normal of a facet, after `relation`: of M, with s on it, if s touches M; of the hull if s lies inside.
    pub(crate) fn normal_at(&self, relation: Relation) -> Vector3 {
        let touches = |facet: &&Facet| facet.side != Sign::Negative && facet.is_final;
        let facet = match relation {
            Relation::Overlapping => &self.facets[0],
            _ => self.facets.iter().find(touches).expect("a final facet has told the relation"),
        };
        facet.normal.clone()
    }

    /// The facet that a ray from s stabs, for s inside the hull.
    fn stabbed(&self, ray: &Vector3) -> usize {
        let is_stabbed = |facet: &Facet| {
            edges(facet.corners).into_iter().all(|[i, j]| {
                let (a, b) = (&self.corners[i].at, &self.corners[j].at);
                side_of_ray(self.s.point(), ray, &a.direction_to(b), a) != Sign::Negative
            })
        };
        self.facets.iter().position(is_stabbed).expect("a ray from the interior of a hull stabs a facet")
    }

    /// Where a ray from s, which lies inside the hull, leaves M: the depth is in units of the ray.
    pub(crate) fn exit(&mut self, ray: &Vector3) -> Exit {
        loop {
            let index = self.stabbed(ray);
            if self.settle(index) {
                let facet = &self.facets[index];
                let n = rationals(&facet.normal);
                let depth = quotient(&self.height(facet), &dot(&n, &rationals(ray)));
                return Exit { normal: facet.normal.clone(), depth, of: self.corners[facet.corners[0]].of };
            }
        }
    }

    /// How far below a facet s lies, times the length of its normal.
    fn height(&self, facet: &Facet) -> Rational {
        let away = minus(&self.point(facet).coordinates(), &self.s.point().coordinates());
        dot(&rationals(&facet.normal), &away)
    }

    /// The facet plane of M nearest to s, which lies inside the hull; the depth is squared. `None` if the hull would have more
    /// than so many vertices.
    pub(crate) fn nearest_plane(&mut self, limit: usize) -> Option<Exit> {
        let point = DepthPoint::new(self.s);
        loop {
            let corners = &self.corners;
            for facet in self.facets.iter_mut().filter(|facet| facet.depth.is_none()) {
                let plane = DepthPlane::new(&facet.normal, &corners[facet.corners[0]].at);
                facet.depth = Some(plane.depth(&point));
            }
            let index = self.least_deep();
            if self.settle(index) {
                let facet = &self.facets[index];
                let (height, n) = (self.height(facet), rationals(&facet.normal));
                let depth = quotient(&(&height * &height), &dot(&n, &n));
                let of = self.corners[facet.corners[0]].of;
                return Some(Exit { normal: facet.normal.clone(), depth, of });
            }
            if self.corners.len() > limit {
                return None;
            }
        }
    }

    /// The facet below which s lies the least deep, for known depths.
    fn least_deep(&self) -> usize {
        let depth = |facet: &Facet| facet.depth.expect("all depths are known");
        let plane = |i: usize| (&self.facets[i].normal, self.point(&self.facets[i]));
        (1..self.facets.len()).fold(0, |best, i| {
            let (least, other) = (depth(&self.facets[best]), depth(&self.facets[i]));
            let is_less = !least.is_below(&other)
                && (other.is_below(&least)
                    || compare_depths(self.s.point(), plane(i), plane(best)) == Ordering::Less);
            if is_less { i } else { best }
        })
    }

    /// A point that P and Q, moved by s, have in common, for s inside the hull.
    pub(crate) fn common_point(&self) -> Coordinates {
        // s lies in the tetrahedron of one vertex and the facet that the ray from that vertex through s stabs.
        let first = &self.corners[self.facets[0].corners[0]];
        let facet = &self.facets[self.stabbed(&first.at.direction_to(self.s.point()))];
        let [a, b, c] = facet.corners.map(|i| &self.corners[i]);
        let corners = [first, a, b, c];
        let at = corners.map(|corner| minus(&corner.at.coordinates(), &self.s.point().coordinates()));
        // Barycentric coordinates of the origin: minors of the matrix of the corners, with alternating signs.
        let minor = |[i, j, k]: [usize; 3]| dot(&at[i], &cross(&at[j], &at[k]));
        let weights = [minor([1, 2, 3]), -minor([0, 2, 3]), minor([0, 1, 3]), -minor([0, 1, 2])];
        let total: Rational = weights.iter().cloned().sum();
        let zero = [Rational::ZERO, Rational::ZERO, Rational::ZERO];
        corners.iter().zip(&weights).fold(zero, |sum, (corner, weight)| {
            let p = self.bodies.p.points()[corner.of[0] as usize].coordinates();
            plus(&sum, &times(&p, &quotient(weight, &total)))
        })
    }
}

fn edges([i, j, k]: [usize; 3]) -> [[usize; 2]; 3] {
    [[i, j], [j, k], [k, i]]
}
