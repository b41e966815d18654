//! Checking a polytope against what it promises.

use crate::Polytope;
use crate::polytope::side;
use crate::vectors::Vectors;
use dcel::{FacetId, HalfedgeId, VertexId};
use exact::{Sign, predicate};
use std::fmt;

/// Something that a polytope promises and does not keep.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Violation {
    /// The numbers of points, edges, normals or facets do not fit the dimension.
    Sizes,
    /// The connectivity is broken.
    Mesh(dcel::Violation),
    /// `V - E + F` is not two.
    Euler(i64),
    /// The stored vector of the edge is not a positive multiple of target minus source.
    EdgeVector(HalfedgeId),
    /// The halfedge does not lie in the plane of its facet.
    NonPlanar(FacetId, HalfedgeId),
    /// The corner after the halfedge is straight or reflex.
    Corner(FacetId, HalfedgeId),
    /// The facets of the edge are coplanar or the edge is reflex.
    Edge(HalfedgeId),
    /// The vertex is not below the plane of the facet.
    Above(FacetId, VertexId),
    /// Two vertices have the same position.
    SamePosition(VertexId, VertexId),
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sizes => write!(f, "the numbers of cells do not fit the dimension"),
            Self::Mesh(violation) => violation.fmt(f),
            Self::Euler(number) => write!(f, "V - E + F is {number}, not 2"),
            Self::EdgeVector(h) => write!(f, "the vector of halfedge {} does not run along it", h.0),
            Self::NonPlanar(g, h) => write!(f, "halfedge {} leaves the plane of facet {}", h.0, g.0),
            Self::Corner(g, h) => write!(f, "facet {} does not turn left after halfedge {}", g.0, h.0),
            Self::Edge(h) => write!(f, "the edge of halfedge {} is flat or reflex", h.0),
            Self::Above(g, v) => write!(f, "vertex {} is not below facet {}", v.0, g.0),
            Self::SamePosition(v, w) => write!(f, "vertices {} and {} have the same position", v.0, w.0),
        }
    }
}

impl Polytope {
    /// Lists every violation of what a polytope promises; none for a valid one.
    ///
    /// ```
    /// use exact::Point3;
    /// let segment = splitstar_polytope::Polytope::segment(Point3::ORIGIN, Point3::from_i64([1, 2, 3]));
    /// assert!(segment.check_valid().is_empty());
    /// ```
    ///
    /// That every vertex lies below every facet is checked by brute force up to a million pairs; local
    /// convexity (corners and edges) and Euler's relation are always checked.
    ///
    /// # Complexity
    /// `n log n`, and up to a million tests of pairs.
    pub fn check_valid(&self) -> Vec<Violation> {
        let mut found: Vec<Violation> = self.mesh.check_valid().into_iter().map(Violation::Mesh).collect();
        if !self.sizes_fit() {
            found.push(Violation::Sizes);
        }
        if !found.is_empty() {
            return found;
        }
        let mut order: Vec<usize> = (0..self.points.len()).collect();
        order.sort_by(|&v, &w| self.points[v].cmp(&self.points[w]));
        found.extend(
            order
                .windows(2)
                .filter(|p| self.points[p[0]] == self.points[p[1]])
                .map(|p| Violation::SamePosition(VertexId::new(p[0]), VertexId::new(p[1]))),
        );
        for h in self.mesh.edges() {
            let [source, target] =
                [self.mesh.source(h), self.mesh.target(h)].map(|v| &self.points[v.index()]);
            let along = source.direction_to(target);
            let vector = &self.vectors().edges.get(h.edge());
            if vector.is_zero()
                || !vector.cross(&along).is_zero()
                || predicate::same_direction(vector, &along) != Sign::Positive
            {
                found.push(Violation::EdgeVector(h));
            }
        }
        if self.dimension >= 2 {
            if self.mesh.euler_characteristic() != 2 {
                found.push(Violation::Euler(self.mesh.euler_characteristic()));
            }
            self.check_facets(&mut found);
        }
        found
    }

    fn sizes_fit(&self) -> bool {
        let (v, e, f) = (self.mesh.vertex_count(), self.mesh.edge_count(), self.mesh.facet_count());
        let cells = match self.dimension {
            0 => (v, e, f) == (0, 0, 0) && self.points.len() == 1,
            1 => (v, e, f) == (2, 1, 1) && self.points.len() == 2,
            2 => v == self.points.len() && v >= 3 && f == 2,
            _ => v == self.points.len() && v >= 4 && f >= 4,
        };
        let normals = if self.dimension < 2 { 0 } else { f };
        cells && self.vectors().edges.len() == e && self.vectors().normals.len() == normals
    }

    fn check_facets(&self, found: &mut Vec<Violation>) {
        let Vectors { edges, normals } = self.vectors();
        for f in self.mesh.facets() {
            let normal = &normals[f.index()];
            for h in self.mesh.facet_cycle(f) {
                if side(edges, normal, h) != Sign::Zero {
                    found.push(Violation::NonPlanar(f, h));
                }
                let corner = crate::polytope::corner_normal(&self.mesh, edges, h);
                if corner.is_zero() || predicate::same_direction(&corner, normal) != Sign::Positive {
                    found.push(Violation::Corner(f, h));
                }
            }
        }
        if self.dimension == 3 {
            for h in self.mesh.edges() {
                let normal = &normals[self.mesh.facet(h).index()];
                if side(edges, normal, self.mesh.next(h.twin())) != Sign::Negative {
                    found.push(Violation::Edge(h));
                }
            }
        }
        if self.points.len() * self.mesh.facet_count() > 1_000_000 {
            return;
        }
        let mut on_facet = vec![FacetId(u32::MAX); self.points.len()];
        for f in self.mesh.facets() {
            self.facet_cycle(f).for_each(|v| on_facet[v.index()] = f);
            let on = &self.points[self.mesh.source(self.mesh.boundary(f)).index()];
            for v in self.mesh.vertices() {
                let side = predicate::plane_side(&normals[f.index()], on, &self.points[v.index()]);
                let expected =
                    if on_facet[v.index()] == f || self.dimension == 2 { Sign::Zero } else { Sign::Negative };
                if side != expected {
                    found.push(Violation::Above(f, v));
                }
            }
        }
    }
}
