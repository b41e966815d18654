//! What a query answers.

use crate::bodies::Bodies;
use crate::contact::{Foot, contact, dot, minus, plus, quotient};
use crate::expansion::{Exit, Expansion};
use crate::relative::Solid;
use crate::simplex::Nearest;
use crate::{Pair, RelativePlacement, Translation};
use dcel::{FacetId, HalfedgeId, VertexId};
use exact::{Quaternion, Rational, Vector3};
use polytope::Polytope;
use std::fmt;

/// How P and the moved Q lie to each other.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Relation {
    /// They have no point in common.
    Disjoint,
    /// They have common points, and a move as short as one likes makes them disjoint.
    Touching,
    /// They have common points, and still have after any move that is short enough. If both have interiors, these meet.
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

/// Where a query has ended: given to the next one, it begins there. It changes the time that an answer takes, never the answer; but
/// where a ray leaves M through several facets at once, it may decide which of them is named.
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

/// Who has answered.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Place<'a> {
    /// A solid M.
    Sum(&'a RelativePlacement, &'a Solid),
    /// P and the turned Q.
    Pair(&'a Polytope, &'a Polytope, Option<&'a Quaternion>),
}

impl<'a> Place<'a> {
    pub(crate) fn bodies(self) -> Bodies<'a> {
        match self {
            Self::Sum(of, _) => Bodies::new(of.p(), of.q(), None),
            Self::Pair(p, q, rotation) => Bodies::new(p, q, rotation),
        }
    }
}

impl Witness {
    pub(crate) fn of_cell(located: u32, cell: Cell) -> Self {
        Self(Kind::Cell { located, cell })
    }

    pub(crate) fn of_vertices(vertices: [u32; 2]) -> Self {
        Self(Kind::Vertices(vertices))
    }

    /// The cell of M found.
    fn cell(self) -> Cell {
        match self.0 {
            Kind::Cell { cell, .. } => cell,
            Kind::Vertices(_) => unreachable!("the sum answers with a cell"),
        }
    }
}

/// The answer of `separation`. Numbers and features are made when they are asked for.
#[derive(Clone, Debug)]
pub struct Separation<'a> {
    pub(crate) relation: Relation,
    pub(crate) witness: Witness,
    pub(crate) place: Place<'a>,
    pub(crate) s: &'a Translation,
    /// Known if M has not been built.
    pub(crate) near: Option<Box<Nearest>>,
}

impl Separation<'_> {
    /// Gives how the polytopes lie to each other.
    pub fn relation(&self) -> Relation {
        self.relation
    }

    /// Gives the square of their distance: zero unless they are disjoint.
    pub fn squared_distance(&self) -> Rational {
        if self.relation != Relation::Disjoint {
            return Rational::ZERO;
        }
        let away = minus(&self.foot().point, &self.s.coordinates());
        dot(&away, &away)
    }

    /// Gives a point of P and one of the moved Q that are as near to each other as any.
    ///
    /// There may be more such pairs. If the polytopes are disjoint or touch, it is the pair whose point on P is
    /// lexicographically the least; if they overlap, it is some common point, twice.
    pub fn closest_points(&self) -> [[Rational; 3]; 2] {
        let bodies = self.place.bodies();
        if self.relation == Relation::Overlapping {
            let mut hull = Expansion::new(&bodies, &self.s.0, bodies.start(None))
                .expect("polytopes whose sum has no interior do not overlap");
            hull.relation();
            let point = hull.common_point();
            return [point.clone(), point];
        }
        let foot = self.foot();
        let on_p = contact(&bodies, &foot).on_p;
        let on_q = plus(&minus(&on_p, &foot.point), &self.s.coordinates());
        [on_p, on_q]
    }

    /// Gives the least faces of P and Q that contain all closest points; for overlapping polytopes, those in contact after a
    /// shortest move that ends the overlap.
    pub fn features(&self) -> [Feature; 2] {
        if self.relation == Relation::Overlapping {
            // Begun anew, so that the answer does not depend on where this query has begun.
            return match self.place {
                Place::Sum(of, _) => of.minimum_penetration(self.s, None).map(|found| found.features()),
                Place::Pair(p, q, rotation) => {
                    let pair = Pair::new(p, q);
                    let found = pair.minimum_penetration(self.s, rotation, None);
                    found.map(|found| found.features())
                }
            }
            .expect("polytopes that overlap have a depth");
        }
        contact(&self.place.bodies(), &self.foot()).features
    }

    fn foot(&self) -> Foot {
        match (&self.near, self.place) {
            (Some(near), _) => near.foot(self.s.point()),
            (None, Place::Sum(of, solid)) => match (self.relation, self.witness.cell()) {
                (Relation::Disjoint, cell) => solid.cells.foot(of.sum(), cell, self.s.point()),
                (_, Cell::Facet(f)) => {
                    Foot { point: self.s.coordinates(), normal: of.sum().facet_normal(FacetId(f)).clone() }
                }
                _ => unreachable!("a point of M has been located in a facet"),
            },
            (None, Place::Pair(..)) => unreachable!("without M the closest point is known"),
        }
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
    pub(crate) place: Place<'a>,
    pub(crate) s: &'a Translation,
    pub(crate) direction: &'a Vector3,
    /// Known if M has not been built.
    pub(crate) exit: Option<Box<Exit>>,
}

impl DirectionalPenetration<'_> {
    /// Gives how the polytopes lie to each other before the move.
    pub fn relation(&self) -> Relation {
        self.relation
    }

    /// Gives the least number alpha, not negative, such that the interiors no longer meet when Q moves on by alpha
    /// times the direction: zero unless they overlap.
    pub fn depth(&self) -> Rational {
        if self.relation != Relation::Overlapping {
            return Rational::ZERO;
        }
        match (&self.exit, self.place) {
            (Some(exit), _) => exit.depth.clone(),
            (None, Place::Sum(of, solid)) => {
                let (normal, height) = solid.height(of.sum(), self.witness.cell(), self.s);
                quotient(&height, &Rational::from(normal.dot(self.direction)))
            }
            (None, Place::Pair(..)) => unreachable!("without M the depth is known"),
        }
    }

    /// Gives the facet of M through which Q leaves, one of them if the move ends at a vertex or an edge of M; `None` if
    /// they do not overlap, or without M.
    pub fn facet(&self) -> Option<FacetId> {
        match (self.place, self.relation, self.witness.0) {
            (Place::Sum(..), Relation::Overlapping, Kind::Cell { cell: Cell::Facet(f), .. }) => {
                Some(FacetId(f))
            }
            _ => None,
        }
    }

    /// Gives the features of P and Q that make the facet; `None` if they do not overlap.
    pub fn features(&self) -> Option<[Feature; 2]> {
        let bodies = self.place.bodies();
        match (&self.exit, self.place, self.facet()) {
            (Some(exit), ..) => Some(bodies.faces(&exit.normal)),
            (None, Place::Sum(of, _), Some(facet)) => Some(bodies.faces(of.sum().facet_normal(facet))),
            _ => None,
        }
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
    pub(crate) place: Place<'a>,
    pub(crate) s: &'a Translation,
    /// Known if M has not been built.
    pub(crate) exit: Option<Box<Exit>>,
}

impl Penetration<'_> {
    /// Gives the square of the length of the shortest move that ends the overlap.
    pub fn squared_depth(&self) -> Rational {
        match (&self.exit, self.place) {
            (Some(exit), _) => exit.depth.clone(),
            (None, Place::Sum(of, solid)) => {
                let (normal, height) = solid.height(of.sum(), self.witness.cell(), self.s);
                quotient(&(&height * &height), &Rational::from(normal.dot(normal)))
            }
            (None, Place::Pair(..)) => unreachable!("without M the depth is known"),
        }
    }

    /// Gives the facet of M nearest to s, the first one of several; `None` without M.
    pub fn facet(&self) -> Option<FacetId> {
        match (self.place, self.witness.0) {
            (Place::Sum(..), Kind::Cell { cell: Cell::Facet(f), .. }) => Some(FacetId(f)),
            _ => None,
        }
    }

    /// Gives a direction of the shortest move of Q: the outer normal of the facet, primitive.
    pub fn direction(&self) -> Vector3 {
        match (&self.exit, self.place, self.facet()) {
            (Some(exit), ..) => exit.normal.primitive(),
            (None, Place::Sum(of, _), Some(facet)) => of.sum().facet_normal(facet).primitive(),
            _ => unreachable!("with M the facet is known, and without it the direction"),
        }
    }

    /// Gives the features of P and Q that make the facet: those in contact after the move.
    pub fn features(&self) -> [Feature; 2] {
        self.place.bodies().faces(&self.direction())
    }

    /// Gives where the query has ended.
    pub fn witness(&self) -> Witness {
        self.witness
    }
}
