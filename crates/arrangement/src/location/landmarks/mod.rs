//! Location by a walk that begins at a landmark near by.
//!
//! | file | role |
//! |---|---|
//! | `mod` | the strategy |
//! | `generator` | where landmarks are put |
//! | `index` | the landmark nearest to a point, by floats |
//! | `walk` | from there to the point, by exact predicates |
//! | `ray` | what a vertical ray from there meets |

mod generator;
mod index;
mod ray;
#[cfg(test)]
mod tests;
mod walk;

use super::{PointLocation, VerticalRay};
use crate::arrangement::Arrangement;
use crate::edit::{Observer, Operation, Stale, Stamp};
use crate::overlay::Cell;
use crate::topology::{Site, Topology};
use crate::traits::{ApproxTraits, LandmarkTraits, UMonotoneTraits};
pub use generator::LandmarkGenerator;
use index::{Index, Start};
use ray::Shot;
use walk::{Ground, Spot};

/// Landmarks whose place is known, and a walk from the nearest to the point that is looked for.
///
/// The walk goes through the trapezoids of the [vertical decomposition](crate::decomposition), not through faces: holes cost no more than
/// other edges. Which landmark is near, floats say; every step is exact, so a landmark that is badly chosen costs time, and never
/// changes an answer. Points whose floats are infinite are served from any landmark.
///
/// The landmarks are for one state of the arrangement. Passed to operations as an [`Observer`], they are made anew at the end of each one
/// that changes something: that is for few operations and many queries. What follows edits at little cost is
/// [`TrapezoidalMap`](super::TrapezoidalMap).
///
/// # Complexity
/// Made in O(n log n) for n cells, without a search structure: one sweep, and a k-d tree; with spread landmarks, a query for each. A query
/// is the search for the nearest landmark, O(log n) comparisons of places by their keys, a walk along u that asks no predicate, and two
/// predicates or one more for each edge between the landmark and the point. Where landmarks are as dense as vertices, those are expected
/// to be few. It is linear at worst: in an arrangement without vertices, or next to a vertex of very high degree.
///
/// # Examples
/// ```
/// use exact::planar::Point2;
/// use splitstar_arrangement::location::{LandmarkGenerator, Landmarks, PointLocation, VerticalRay};
/// use splitstar_arrangement::models::{Segment, SegmentTraits};
/// use splitstar_arrangement::overlay::Cell;
/// use splitstar_arrangement::{Arrangement, topology::BoundedPlane};
///
/// let sides = [[[0, 0], [4, 0]], [[4, 0], [2, 3]], [[2, 3], [0, 0]]];
/// let sides = sides.map(|ends| Segment::from_i64(ends).expect("the ends are different"));
/// let mut triangle = Arrangement::of_curves(SegmentTraits, BoundedPlane, &sides);
/// for landmarks in [
///     Landmarks::new(&triangle),
///     Landmarks::with_generator(&triangle, LandmarkGenerator::Halton { count: Some(100) }),
/// ] {
///     let [on_base, tip, inside] = [[1, 0], [2, 3], [2, 1]].map(Point2::from_i64);
///     assert!(matches!(landmarks.locate(&triangle, &on_base)?, Cell::Edge(_)));
///     assert!(matches!(landmarks.locate(&triangle, &tip)?, Cell::Vertex(_)));
///     assert!(landmarks.locate(&triangle, &inside)? != Cell::Face(triangle.corner_face()));
///     let below = landmarks.shoot(&triangle, &inside, VerticalRay::Down)?;
///     assert_eq!(below, landmarks.locate(&triangle, &on_base)?);
///     let above = landmarks.shoot(&triangle, &inside, VerticalRay::Up)?;
///     assert_eq!(above, landmarks.locate(&triangle, &tip)?);
/// }
///
/// let landmarks = Landmarks::new(&triangle);
/// triangle.insert_points([Point2::from_i64([2, 1])]);
/// assert!(landmarks.locate(&triangle, &Point2::from_i64([2, 1])).is_err(), "they are for the triangle without a point");
/// # Ok::<(), splitstar_arrangement::edit::Stale>(())
/// ```
///
/// # References
/// Haran and Halperin, An experimental study of point location in planar arrangements in CGAL, J. Exp. Algorithmics 13, 2008; thesis,
/// section 2.4.5. There the walk goes along a segment, from face to face.
#[derive(Clone, Debug)]
pub struct Landmarks {
    ground: Ground,
    index: Index,
    generator: LandmarkGenerator,
}

impl Landmarks {
    /// Makes all vertices landmarks.
    ///
    /// # Complexity
    /// O(n log n) for n cells.
    pub fn new<G: UMonotoneTraits + ApproxTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Self {
        let ground = Ground::new(arrangement);
        let index = vertices(&ground, arrangement);
        Self { ground, index, generator: LandmarkGenerator::Vertices }
    }

    /// Puts landmarks where a generator says.
    ///
    /// An arrangement without vertices whose floats are finite gets none.
    ///
    /// # Complexity
    /// O(n log n) for n cells, and a query for each landmark that is not a vertex.
    pub fn with_generator<G: UMonotoneTraits + LandmarkTraits, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        generator: LandmarkGenerator,
    ) -> Self {
        let mut landmarks = Self { generator, ..Self::new(arrangement) };
        if generator != LandmarkGenerator::Vertices {
            // Found from the vertices.
            landmarks.index = Index::new(landmarks.spread(arrangement).into_iter());
        }
        landmarks
    }

    /// What says where landmarks are.
    pub fn generator(&self) -> LandmarkGenerator {
        self.generator
    }

    /// The number of landmarks. Several with the same floats are one, and those whose floats are not finite do not count.
    pub fn count(&self) -> usize {
        self.index.len()
    }

    /// The state of the arrangement for which the landmarks are.
    pub fn stamp(&self) -> Stamp {
        self.ground.decomposition.stamp()
    }

    /// Makes landmarks as these ones for the present state of an arrangement, if they are not for it.
    ///
    /// # Complexity
    /// As [`with_generator`](Self::with_generator).
    pub fn renew<G: UMonotoneTraits + LandmarkTraits, T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
    ) {
        if self.stamp() != arrangement.stamp() {
            *self = Self::with_generator(arrangement, self.generator);
        }
    }

    /// Landmarks spread by the generator, and where they are.
    fn spread<G: LandmarkTraits, T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
    ) -> Vec<([f64; 2], Start)> {
        let traits = arrangement.traits();
        let points = arrangement.vertices().filter_map(|v| arrangement.inner_point(v));
        let places = points.map(|point| traits.approx_point(point));
        let finite = places.filter(|place| place.iter().all(|value| value.is_finite()));
        let Some([low, high]) = finite.map(|place| [place; 2]).reduce(|[low, high], [place, _]| {
            [[0, 1].map(|axis| low[axis].min(place[axis])), [0, 1].map(|axis| high[axis].max(place[axis]))]
        }) else {
            return Vec::new();
        };
        // A sum of products, because the difference of finite floats may be infinite.
        let within = |position: [f64; 2]| {
            [0, 1].map(|axis| low[axis] * (1.0 - position[axis]) + high[axis] * position[axis])
        };
        let positions = self.generator.positions(arrangement.dcel().vertex_count());
        let points = positions.into_iter().filter_map(|position| traits.approx_to_point(within(position)));
        points
            .map(|point| {
                let (_, at, spot) = self.find(arrangement, &point);
                let start = match spot {
                    Spot::Site(site) => Start::Site(site),
                    Spot::Edge(e, rank) => Start::Trapezoid(self.ground.over(Some(e), rank)),
                    Spot::Inside(t) => Start::Trapezoid(t),
                };
                (at, start)
            })
            .collect()
    }

    /// Where a point is in the parameter space, about which parameters it has, and what is there.
    fn find<'p, G: ApproxTraits, T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        point: &'p G::Point,
    ) -> (Site<'p, G>, [f64; 2], Spot) {
        let place = Site::of_point(arrangement.topology(), arrangement.traits(), point);
        let at = arrangement.traits().approx_point(point);
        let spot = self.ground.find(arrangement, &place, at[1], self.index.nearest(at));
        (place, at, spot)
    }
}

/// All vertices that are points, each at the first of its sites: where its point is.
fn vertices<G: ApproxTraits, T: Topology<G>>(ground: &Ground, arrangement: &Arrangement<G, T>) -> Index {
    Index::new(arrangement.vertices().filter_map(|v| {
        let point = arrangement.inner_point(v)?;
        let site = ground.decomposition.sites_of(v).next()?;
        Some((arrangement.traits().approx_point(point), Start::Site(site)))
    }))
}

impl<G: ApproxTraits, T: Topology<G>> PointLocation<G, T> for Landmarks {
    fn locate(&self, arrangement: &Arrangement<G, T>, point: &G::Point) -> Result<Cell, Stale> {
        Stale::check(self.stamp(), arrangement.stamp())?;
        let decomposition = &self.ground.decomposition;
        let place = Site::of_point(arrangement.topology(), arrangement.traits(), point);
        if let Some(cell) = arrangement.cell_at_contraction(place.location) {
            return Ok(cell);
        }
        match self.find(arrangement, point).2 {
            Spot::Site(site) => Ok(Cell::Vertex(decomposition.vertex(site))),
            Spot::Edge(e, _) => Ok(Cell::Edge(e)),
            Spot::Inside(t) => decomposition.face_of(arrangement, t).map(Cell::Face),
        }
    }

    fn shoot(
        &self,
        arrangement: &Arrangement<G, T>,
        point: &G::Point,
        ray: VerticalRay,
    ) -> Result<Cell, Stale> {
        Stale::check(self.stamp(), arrangement.stamp())?;
        let place = Site::of_point(arrangement.topology(), arrangement.traits(), point);
        if let Some(cell) = arrangement.cell_at_contraction(place.location) {
            return Ok(cell);
        }
        let (place, _, spot) = self.find(arrangement, point);
        Shot { ground: &self.ground, arrangement, place, ray }.meets(spot)
    }
}

/// Makes the landmarks anew at the end of each operation that changed something.
///
/// They need not be for the state from which an operation begins.
impl<G: UMonotoneTraits + LandmarkTraits, T: Topology<G>> Observer<G, T> for Landmarks {
    fn end_operation(&mut self, arrangement: &Arrangement<G, T>, _: Operation) {
        self.renew(arrangement);
    }

    fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
        self.renew(arrangement);
    }
}
