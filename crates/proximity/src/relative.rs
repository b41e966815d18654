//! Two polytopes whose sum is kept.

use crate::answer::{Cell, Kind, Place};
use crate::cells::Cells;
use crate::contact::{dot, minus, rationals};
use crate::grid::Grid;
use crate::hierarchy::Hierarchy;
use crate::{DirectionalPenetration, Pair, Penetration, Relation, Separation, Translation, Witness, voronoi};
use dcel::FacetId;
use exact::proximity::{DepthPlane, QueryPoint};
use exact::{Rational, Sign, Vector3};
use polytope::{Polytope, minkowski_sum};
use std::sync::OnceLock;

/// Two polytopes P and Q of any dimension, and the Minkowski sum M of P and the reflection of Q.
///
/// Q moved by s meets P exactly if s lies in M. M does not depend on s, so it is built once, and all queries are about one point
/// and one convex polytope. They are decided exactly; a query that is given the witness of the last one begins
/// where that one has ended.
///
/// ```
/// use exact::Point3;
/// use polytope::convex_hull;
/// use splitstar_proximity::{Relation, RelativePlacement, Translation};
/// let corners: Vec<_> = (0..8).map(|i| Point3::from_i64([i >> 2, i >> 1 & 1, i & 1])).collect();
/// let cube = convex_hull(&corners).expect("there are points");
/// let cubes = RelativePlacement::new(&cube, &cube);
///
/// let apart = Translation::from_i64([3, 2, 0]);
/// let separation = cubes.separation(&apart, None);
/// assert_eq!(separation.squared_distance(), 5.into());
/// let near = Translation::from_f64([0.5, 0.25, 0.0]).expect("the numbers are finite");
/// let (relation, witness) = cubes.relation(&near, Some(separation.witness()));
/// assert_eq!(relation, Relation::Overlapping);
/// let penetration = cubes.minimum_penetration(&near, Some(witness)).expect("they overlap");
/// assert_eq!(penetration.squared_depth().to_string(), "1/4");
/// ```
///
/// # References
/// Thesis, section 3.4.
#[derive(Clone, Debug)]
pub struct RelativePlacement {
    p: Polytope,
    q: Polytope,
    sum: Polytope,
    /// `None` if M lies in a plane: then its points are found without it.
    solid: Option<Solid>,
}

/// M as the queries read it.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    pub(crate) cells: Cells,
    grid: Grid,
    /// Made by the first query that needs it.
    hierarchy: OnceLock<Hierarchy>,
}

impl Solid {
    fn new(sum: &Polytope) -> Self {
        let cells = Cells::new(sum);
        let center = cells.center().approx_f64();
        let bounds = sum.bounds();
        let radius = (0..3).map(|i| (&bounds.max[i] - &bounds.min[i]).approx_f64()).fold(0.0, f64::max);
        let grid = Grid::new(center, radius, sum.mesh().facet_count(), |point, last| {
            // Beyond the range of floats there is no guess.
            QueryPoint::from_f64(point).map_or(last, |point| cells.stab(sum, &point, last))
        });
        Self { cells, grid, hierarchy: OnceLock::new() }
    }

    /// A facet where a location may begin, and a cell of M that may be near.
    #[inline]
    fn start(&self, s: &QueryPoint, hint: Option<Witness>) -> (u32, Cell) {
        if let Some(Witness(Kind::Cell { located, cell })) = hint
            && located < self.cells.facet_count()
        {
            let is_known = match cell {
                Cell::Facet(f) => f < self.cells.facet_count(),
                Cell::Edge(k) | Cell::Vertex(k) => k < self.cells.halfedge_count(),
            };
            if is_known {
                return (located, cell);
            }
        }
        let guess = self.grid.guess(s.approx_f64());
        (guess, Cell::Facet(guess))
    }

    fn facet_of(&self, cell: Cell) -> u32 {
        match cell {
            Cell::Facet(f) => f,
            Cell::Edge(k) | Cell::Vertex(k) => self.cells.facet(k),
        }
    }

    /// The normal of a facet, and how far below the facet a point lies, times its length.
    pub(crate) fn height<'s>(
        &self,
        sum: &'s Polytope,
        cell: Cell,
        s: &Translation,
    ) -> (&'s Vector3, Rational) {
        let facet = self.facet_of(cell);
        let normal = sum.facet_normal(FacetId(facet));
        let away = minus(&self.cells.corner(sum, facet).coordinates(), &s.coordinates());
        (normal, dot(&rationals(normal), &away))
    }
}

fn relation_of(side: Sign) -> Relation {
    match side {
        Sign::Positive => Relation::Disjoint,
        Sign::Zero => Relation::Touching,
        Sign::Negative => Relation::Overlapping,
    }
}

impl RelativePlacement {
    /// Builds M.
    ///
    /// # Panics
    /// If M would have 2^30 facets or more, as the Minkowski sum does.
    ///
    /// # Complexity
    /// That of the Minkowski sum, and linear in the number of its cells.
    pub fn new(p: &Polytope, q: &Polytope) -> Self {
        let sum = minkowski_sum(&[p, &q.reflected()]);
        let solid = (sum.dimension() == 3).then(|| Solid::new(&sum));
        Self { p: p.clone(), q: q.clone(), sum, solid }
    }

    /// Gives M.
    pub fn sum(&self) -> &Polytope {
        &self.sum
    }

    pub(crate) fn p(&self) -> &Polytope {
        &self.p
    }

    pub(crate) fn q(&self) -> &Polytope {
        &self.q
    }

    fn pair(&self) -> Pair<'_> {
        Pair::new(&self.p, &self.q)
    }

    /// Tells how P and Q, moved by s, lie to each other.
    ///
    /// Disjoint polytopes are told by any facet of M that has s above it, the one of the witness if it still has. Else s lies in M, or
    /// above another facet: the facet is looked for that the ray from the center of M through s stabs.
    ///
    /// # Complexity
    /// One side of a plane if the facet of the witness separates; some more for each facet on the way to the one that is
    /// stabbed. Degree 3 in the edges of P and Q, but for weights.
    #[inline]
    pub fn relation(&self, s: &Translation, hint: Option<Witness>) -> (Relation, Witness) {
        let Some(solid) = &self.solid else { return self.pair().relation(s, None, hint) };
        let (start, _) = solid.start(&s.0, hint);
        let (facet, side) = solid.cells.locate(&self.sum, &s.0, start);
        (relation_of(side), Witness::of_cell(facet, Cell::Facet(facet)))
    }

    /// Finds the distance of P and Q moved by s.
    ///
    /// # Complexity
    /// That of the relation, and three to some more sides of planes for each feature of M on the way to the closest one. Degree 4.
    #[inline]
    pub fn separation<'a>(&'a self, s: &'a Translation, hint: Option<Witness>) -> Separation<'a> {
        let Some(solid) = &self.solid else { return self.pair().separation_of(s, None, hint) };
        let (located, cell) = solid.start(&s.0, hint);
        let facet = solid.facet_of(cell);
        let (located, cell, side) = if solid.cells.side_of_facet(&self.sum, facet, &s.0) == Sign::Positive {
            (facet, cell, Sign::Positive)
        } else {
            let (facet, side) = solid.cells.locate(&self.sum, &s.0, located);
            (facet, Cell::Facet(facet), side)
        };
        let cell = match side {
            Sign::Positive => voronoi::closest(&self.sum, &solid.cells, &s.0, cell),
            _ => cell,
        };
        Separation {
            relation: relation_of(side),
            witness: Witness::of_cell(located, cell),
            place: Place::Sum(self, solid),
            s,
            near: None,
        }
    }

    /// Finds how far Q, moved by s, has to go on in a direction until the interiors no longer meet; `None` if there
    /// is no such number: they overlap and the direction is the zero vector.
    ///
    /// # Complexity
    /// That of the relation, and for each facet of M on the way to the one where Q leaves some determinants of degree 4.
    pub fn directional_penetration<'a>(
        &'a self,
        s: &'a Translation,
        direction: &'a Vector3,
        hint: Option<Witness>,
    ) -> Option<DirectionalPenetration<'a>> {
        let Some(solid) = &self.solid else {
            return self.pair().directional_penetration_of(s, None, direction, hint);
        };
        let (start, cell) = solid.start(&s.0, hint);
        let (located, side) = solid.cells.locate(&self.sum, &s.0, start);
        let relation = relation_of(side);
        let mut cell_found = Cell::Facet(located);
        if relation == Relation::Overlapping {
            if direction.is_zero() {
                return None;
            }
            let start = match hint {
                Some(_) => solid.facet_of(cell),
                None => solid.grid.guess_direction(direction.approx_f64()),
            };
            cell_found = Cell::Facet(solid.cells.exit(&self.sum, s.point(), direction, start));
        }
        let witness = Witness::of_cell(located, cell_found);
        Some(DirectionalPenetration {
            relation,
            witness,
            place: Place::Sum(self, solid),
            s,
            direction,
            exit: None,
        })
    }

    /// Finds the shortest move after which the interiors of P and Q, moved by s, no longer meet; `None` unless they overlap.
    ///
    /// # Complexity
    /// A search through the hierarchy of the facets of M, where all have to be looked at only if all are nearly as far from s. The first
    /// query builds the hierarchy, in `n log n`.
    pub fn minimum_penetration<'a>(
        &'a self,
        s: &'a Translation,
        hint: Option<Witness>,
    ) -> Option<Penetration<'a>> {
        let solid = self.solid.as_ref()?;
        let (located, cell) = solid.start(&s.0, hint);
        let exact = |f: u32| (self.sum.facet_normal(FacetId(f)), solid.cells.corner(&self.sum, f));
        let hierarchy = solid.hierarchy.get_or_init(|| {
            let plane = |f: u32| {
                let (normal, on) = exact(f);
                DepthPlane::new(normal, on)
            };
            Hierarchy::new((0..solid.cells.facet_count()).map(plane).collect())
        });
        let side = |f: u32| solid.cells.side_of_facet(&self.sum, f, &s.0);
        let facet = hierarchy.nearest(&s.0, solid.facet_of(cell), exact, side)?;
        let witness = Witness::of_cell(located, Cell::Facet(facet));
        Some(Penetration { witness, place: Place::Sum(self, solid), s, exit: None })
    }
}
