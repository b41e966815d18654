//! Location in the vertical decomposition, by its search structure.

use super::{PointLocation, VerticalRay};
use crate::arrangement::Arrangement;
use crate::edit::{Done, EditOf, Observer, Stale, Stamp};
use crate::overlay::Cell;
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use crate::trapezoids::{Follower, Trapezoids};

/// The trapezoidal map of an arrangement, with a search structure.
///
/// Edges come in random order, always the same; the structure is the history of how the map grew. As an observer it follows edits of
/// the arrangement, and is built anew where searches of edits have become too long, or all cells were replaced.
///
/// An [`Editor`](crate::Editor) has one already: ask [`Editor::locate`](crate::Editor::locate).
///
/// # Complexity
/// Built in expected O(n log n), for n cells; a query takes expected O(log n) predicates. Linear space.
///
/// # Examples
/// ```
/// use exact::planar::Point2;
/// use splitstar_arrangement::location::{PointLocation, TrapezoidalMap};
/// use splitstar_arrangement::models::{Segment, SegmentTraits};
/// use splitstar_arrangement::overlay::Cell;
/// use splitstar_arrangement::{Arrangement, topology::BoundedPlane};
///
/// let sides = [[[0, 0], [4, 0]], [[4, 0], [2, 3]], [[2, 3], [0, 0]]];
/// let sides = sides.map(|ends| Segment::from_i64(ends).expect("the ends are different"));
/// let triangle = Arrangement::of_curves(SegmentTraits, BoundedPlane, &sides);
/// let map = TrapezoidalMap::new(&triangle);
/// assert!(matches!(map.locate(&triangle, &Point2::from_i64([1, 0]))?, Cell::Edge(_)));
/// assert!(matches!(map.locate(&triangle, &Point2::from_i64([2, 3]))?, Cell::Vertex(_)));
/// let outside = map.locate(&triangle, &Point2::from_i64([0, 3]))?;
/// assert_eq!(outside, Cell::Face(triangle.corner_face()));
///
/// let other = triangle.clone().into_parts();
/// let other = Arrangement::from_parts(SegmentTraits, BoundedPlane, other).expect("nothing was changed");
/// assert!(map.locate(&other, &Point2::from_i64([1, 0])).is_err(), "the map is for another arrangement");
/// # Ok::<(), splitstar_arrangement::edit::Stale>(())
/// ```
///
/// # References
/// Thesis, section 2.4.5; de Berg, Cheong, van Kreveld and Overmars, Computational Geometry, chapter 6.
#[derive(Clone, Debug)]
pub struct TrapezoidalMap<G: UMonotoneTraits> {
    trapezoids: Trapezoids<G>,
    stamp: Stamp,
}

impl<G: UMonotoneTraits> TrapezoidalMap<G> {
    /// Makes the map of an arrangement.
    ///
    /// # Complexity
    /// Expected O(n log n).
    pub fn new<T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Self {
        Self { trapezoids: Trapezoids::of(arrangement), stamp: arrangement.stamp() }
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> PointLocation<G, T> for TrapezoidalMap<G> {
    fn locate(&self, arrangement: &Arrangement<G, T>, point: &G::Point) -> Result<Cell, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        Ok(self.trapezoids.locate(arrangement, point))
    }

    fn shoot(
        &self,
        arrangement: &Arrangement<G, T>,
        point: &G::Point,
        ray: VerticalRay,
    ) -> Result<Cell, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        Ok(self.trapezoids.shoot(arrangement, point, ray))
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> Observer<G, T> for TrapezoidalMap<G> {
    fn before(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>) {
        Follower(&mut self.trapezoids).before(arrangement, edit);
    }

    fn after(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
        Follower(&mut self.trapezoids).after(arrangement, edit, done);
        self.stamp = arrangement.stamp();
    }

    fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
        *self = Self::new(arrangement);
    }

    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        Stale::check(self.stamp, stamp)
    }
}
