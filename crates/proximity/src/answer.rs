//! What a query answers.

use crate::{RelativePlacement, Translation};
use dcel::{FacetId, HalfedgeId, VertexId};
use exact::{Rational, Vector3};
use std::fmt;

/// How P and the moved Q lie to each other.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Relation {
    /// They have no point in common.
    Disjoint,
    /// They have common points, but their interiors have none: so it is whenever M has no interior.
    Touching,
    /// Their interiors meet; if one of them has none, its relative interior meets the interior of the other, or a
    /// move in any direction leaves them in contact.
    Overlapping,
}

/// A feature of P or of Q.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Feature {
    /// A vertex.
    Vertex(VertexId),
    /// An edge, by its even halfedge.
    Edge(HalfedgeId),
    /// A facet.
    Facet(FacetId),
}

impl fmt::Display for Feature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vertex(v) => write!(f, "vertex {}", v.0),
            Self::Edge(h) => write!(f, "edge {}", h.edge()),
            Self::Facet(facet) => write!(f, "facet {}", facet.0),
        }
    }
}

/// Where a query has ended: given to the next one, it begins there. It changes the time that an answer takes, never the answer.
///
/// A witness of other polytopes does no harm.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Witness(pub(crate) Kind);

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Kind {
    /// A facet of M where the last location ended, and the cell of M found.
    Cell { located: u32, cell: Cell },
    /// A vertex of P and one of Q.
    Vertices([u32; 2]),
}

/// A cell of M: a facet, or an edge or a vertex by a halfedge (numbered by facets, see `cells`).
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Cell {
    Facet(u32),
    Edge(u32),
    /// The source of the halfedge.
    Vertex(u32),
}

impl fmt::Display for Witness {
    /// Writes a facet of M, or a vertex of P and one of Q.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Kind::Cell { located, .. } => write!(f, "facet {located}"),
            Kind::Vertices([p, q]) => write!(f, "vertices {p} {q}"),
        }
    }
}

/// The answer of `separation`.
#[derive(Clone, Debug)]
pub struct Separation<'a> {
    pub(crate) relation: Relation,
    pub(crate) witness: Witness,
    pub(crate) of: &'a RelativePlacement,
    pub(crate) s: &'a Translation,
}

impl Separation<'_> {
    /// Gives how the polytopes lie to each other.
    pub fn relation(&self) -> Relation {
        self.relation
    }

    /// Gives the square of their distance: zero unless they are disjoint.
    pub fn squared_distance(&self) -> Rational {
        panic!("not yet {:?}", (self.of, self.s))
    }

    /// Gives a point of P and one of the moved Q that are as near to each other as any.
    ///
    /// There may be more such pairs: disjoint or touching, it is the one whose point on P is lexicographically the
    /// least. Overlapping, it is some common point, twice.
    pub fn closest_points(&self) -> [[Rational; 3]; 2] {
        panic!("not yet")
    }

    /// Gives the features of P and Q in whose relative interiors the closest points lie, if these are chosen in
    /// general position; for overlapping ones, the features that make the facet of M in the direction of s.
    pub fn features(&self) -> [Feature; 2] {
        panic!("not yet")
    }

    /// Gives where the query has ended.
    pub fn witness(&self) -> Witness {
        self.witness
    }
}

/// The answer of `directional_penetration`.
#[derive(Clone, Debug)]
pub struct DirectionalPenetration<'a> {
    pub(crate) relation: Relation,
    pub(crate) witness: Witness,
    pub(crate) of: &'a RelativePlacement,
}

impl DirectionalPenetration<'_> {
    /// Gives how the polytopes lie to each other before the move.
    pub fn relation(&self) -> Relation {
        self.relation
    }

    /// Gives the least number alpha, not negative, such that the interiors no longer meet when Q moves on by alpha
    /// times the direction: zero unless they overlap.
    pub fn depth(&self) -> Rational {
        panic!("not yet {:?}", self.of)
    }

    /// Gives the facet of M through which Q leaves; `None` if they do not overlap, or without M.
    pub fn facet(&self) -> Option<FacetId> {
        panic!("not yet")
    }

    /// Gives where the query has ended.
    pub fn witness(&self) -> Witness {
        self.witness
    }
}

/// The answer of `minimum_penetration`.
#[derive(Clone, Debug)]
pub struct Penetration<'a> {
    pub(crate) witness: Witness,
    pub(crate) of: &'a RelativePlacement,
}

impl Penetration<'_> {
    /// Gives the square of the length of the shortest move that ends the overlap.
    pub fn squared_depth(&self) -> Rational {
        panic!("not yet {:?}", self.of)
    }

    /// Gives the facet of M nearest to s, the first one of several; `None` without M.
    pub fn facet(&self) -> Option<FacetId> {
        panic!("not yet")
    }

    /// Gives a direction of the shortest move of Q: the outer normal of the facet, primitive.
    pub fn direction(&self) -> Vector3 {
        panic!("not yet")
    }

    /// Gives the features of P and Q that make the facet: those in contact after the move.
    pub fn features(&self) -> [Feature; 2] {
        panic!("not yet")
    }

    /// Gives where the query has ended.
    pub fn witness(&self) -> Witness {
        self.witness
    }
}
