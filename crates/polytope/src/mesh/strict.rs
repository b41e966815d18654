//! The fast check: is a mesh, as it stands, the boundary of a convex polytope?

use super::error::MeshError;
use super::shape::Shape;
use crate::polytope::{corner_normal, edge_vectors};
use crate::vectors::VectorList;
use dcel::{HalfedgeId, Mesh};
use exact::{Integer, Point3, Rational, Sign, Vector3, predicate};

/// A closed surface with the vectors of its edges and the normals of its facets.
pub(super) struct Surface<'m> {
    pub(super) points: &'m [Point3],
    pub(super) mesh: &'m Mesh,
    pub(super) edges: VectorList,
    /// Zero for a facet whose corners are collinear.
    pub(super) normals: Vec<Vector3>,
    /// Whether every corner of every facet turns left.
    corners_turn_left: bool,
}

/// How the edges of a surface turn.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Turns {
    pub(super) convex: usize,
    /// Between coplanar facets, or at a facet of collinear corners.
    pub(super) flat: usize,
    pub(super) reflex: usize,
    /// The first reflex and the first convex edge.
    pub(super) first_reflex: Option<HalfedgeId>,
    pub(super) first_convex: Option<HalfedgeId>,
}

impl<'m> Surface<'m> {
    /// Computes the vectors and normals.
    ///
    /// # Errors
    /// The first facet that is not planar.
    pub(super) fn new(points: &'m [Point3], mesh: &'m Mesh) -> Result<Self, MeshError> {
        let edges = edge_vectors(points, mesh);
        let mut surface = Self { points, mesh, edges, normals: Vec::new(), corners_turn_left: true };
        surface.normals.reserve(mesh.facet_count());
        for f in mesh.facets() {
            let first = mesh.boundary(f);
            let is_triangle = mesh.next(mesh.next(mesh.next(first))) == first;
            let normal = if is_triangle {
                corner_normal(mesh, &surface.edges, first)
            } else {
                surface.polygon_normal(first)?
            };
            surface.normals.push(normal);
        }
        Ok(surface)
    }

    /// The normal of a polygon; zero if its corners are collinear.
    fn polygon_normal(&mut self, first: HalfedgeId) -> Result<Vector3, MeshError> {
        let mesh = self.mesh;
        let f = mesh.facet(first);
        let cycle: Vec<u32> = mesh.facet_cycle(f).map(|h| mesh.source(h).0).collect();
        Ok(match Shape::of(self.points, &cycle) {
            Shape::Plane(plane) => {
                self.corners_turn_left &= plane.corners_turn_left;
                plane.normal
            }
            Shape::Line | Shape::Edge => Vector3::from_i64([0; 3]),
            Shape::Bent { vertex, squared_distance } => {
                return Err(MeshError::NonPlanar { facet: f.0, vertex, squared_distance });
            }
        })
    }

    /// Sorts the edges by the way they turn. An edge is convex if the next corner of the facet on its
    /// right lies below the plane of that on its left.
    pub(super) fn turns(&self) -> Turns {
        let mut turns = Turns::default();
        for h in self.mesh.edges() {
            match self.turn(h) {
                Sign::Negative => {
                    turns.convex += 1;
                    turns.first_convex = turns.first_convex.or(Some(h));
                }
                Sign::Zero => turns.flat += 1,
                Sign::Positive => {
                    turns.reflex += 1;
                    turns.first_reflex = turns.first_reflex.or(Some(h));
                }
            }
        }
        turns
    }

    /// Positive at a reflex edge. The corner after an edge may be straight or turn the other way in a
    /// non-convex facet, so the planes decide: the normal of the right facet against a vector within
    /// the left facet, pointing to its inside.
    fn turn(&self, h: HalfedgeId) -> Sign {
        let (left, right) = (self.mesh.facet(h), self.mesh.facet(h.twin()));
        let (l, r) = (&self.normals[left.index()], &self.normals[right.index()]);
        if l.is_zero() || r.is_zero() {
            return Sign::Zero;
        }
        let next = self.mesh.next(h.twin());
        if self.mesh.next(self.mesh.next(next)) == h.twin() {
            // A triangle: its third corner shows the turn.
            let [on, third] = [self.mesh.source(next), self.mesh.target(next)];
            return predicate::plane_side(l, &self.points[on.index()], &self.points[third.index()]);
        }
        // The turn of the normals about the edge, from the left to the right facet: counterclockwise
        // at a convex edge.
        let turn = predicate::circle_order(&self.edges.get(h.edge()), l, r);
        if h.0 & 1 == 0 { -turn } else { turn }
    }

    /// Whether every facet is a strictly convex polygon that winds once.
    pub(super) fn facets_are_convex(&self) -> bool {
        // A cycle that only turns left winds as often as it has highest corners.
        self.corners_turn_left
            && self.mesh.facets().all(|f| {
                !self.normals[f.index()].is_zero()
                    && (self.mesh.facet_cycle(f).nth(3).is_none() || self.highest_corners(f) == 1)
            })
    }

    fn highest_corners(&self, f: dcel::FacetId) -> usize {
        let point = |h| &self.points[self.mesh.source(h).index()];
        let is_highest =
            |&h: &HalfedgeId| point(self.mesh.prev(h)) < point(h) && point(self.mesh.next(h)) < point(h);
        self.mesh.facet_cycle(f).filter(is_highest).count()
    }

    /// Whether a surface of convex facets and convex edges is the boundary of a convex polytope, or
    /// winds around more than once, in one shell or several.
    ///
    /// From a point below all facets the surface is seen as a covering of the sphere of directions,
    /// branched at vertices at most; every shell covers all directions. The number of sheets is the
    /// number of facets met in a direction inside one of them. With one sheet the surface is embedded, and an embedded surface that is
    /// convex at every edge bounds a convex body (Tietze and Nakajima). Otherwise a facet is named
    /// that shows it: one with the point above it, or one on a second sheet.
    pub(super) fn winds_once(&self) -> Result<(), dcel::FacetId> {
        let (mesh, first) = (self.mesh, dcel::FacetId(0));
        let corner = |h: HalfedgeId| &self.points[mesh.source(h).index()];
        let base: Vec<&Point3> = mesh.facet_cycle(first).take(3).map(corner).collect();
        let below = self.points.iter().find(|p| self.above(first, p) == Sign::Negative);
        let Some(below) = below else { return Err(first) };
        let corners = [base[0], base[1], base[2], below];
        let above_centre = |o: &Point3| mesh.facets().find(|&f| self.above(f, o) != Sign::Negative);
        let mut centre = mean(&corners, true);
        if above_centre(&centre).is_some() {
            centre = mean(&corners, false); // the rounded one is not inside, or none is
            if let Some(f) = above_centre(&centre) {
                return Err(f);
            }
        }
        let seen = |h: HalfedgeId| centre.direction_to(corner(h));
        // A direction strictly inside the first facet.
        let inside = mesh
            .facet_cycle(first)
            .take(3)
            .map(seen)
            .reduce(|sum, direction| &sum + &direction)
            .expect("a facet has corners");
        let met = |f: dcel::FacetId| {
            predicate::side_of_circle(&self.normals[f.index()], &inside) == Sign::Positive
                && mesh
                    .facet_cycle(f)
                    .all(|h| predicate::orientation(&seen(h), &seen(mesh.next(h)), &inside) != Sign::Negative)
        };
        match mesh.facets().skip(1).find(|&f| met(f)) {
            Some(f) => Err(f),
            None => Ok(()),
        }
    }

    /// The side of the plane of `f` on which a point lies: positive above.
    fn above(&self, f: dcel::FacetId, point: &Point3) -> Sign {
        let on = &self.points[self.mesh.source(self.mesh.boundary(f)).index()];
        predicate::plane_side(&self.normals[f.index()], on, point)
    }
}

/// The mean of four points: exact, or rounded to the grid of the first one's weight, which keeps
/// differences narrow (used only after a check that it lies where it should).
fn mean(points: &[&Point3; 4], on_grid: bool) -> Point3 {
    let four = Integer::from(4);
    let weight = points[0].weight();
    let sum: [Rational; 3] =
        std::array::from_fn(|axis| points.iter().fold(Rational::from(0), |sum, p| sum + p.coordinate(axis)));
    if on_grid {
        let grid = sum.map(|s| {
            let scaled = s * Rational::from(weight.clone());
            scaled.numerator().div_rem(&(scaled.denominator() * &four)).0
        });
        Point3::new(grid, weight).expect("weights are positive")
    } else {
        let quarter = Rational::new(Integer::from(1), four).expect("four is not zero");
        Point3::from_rationals(&sum.map(|s| s * quarter.clone()))
    }
}
