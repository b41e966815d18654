//! Location in the vertical decomposition, by its search structure.

use super::over::Column;
use super::{PointLocation, VerticalRay};
use crate::arrangement::Arrangement;
use crate::edit::{Done, EditOf, Observer, Operation, Stale, Stamp};
use crate::overlay::Cell;
use crate::topology::{Site, Topology};
use crate::traits::{Along, Location, UMonotoneTraits};
use crate::trapezoids::{Follower, Found, Side, SiteId, Toward, TrapezoidId, Trapezoids};
use dcel::EdgeId;

/// The trapezoidal map of an arrangement, with a search structure.
///
/// Edges come in random order, always the same; the structure is the history of how the map grew. As an observer it follows edits of
/// the arrangement, and is built anew where searches of edits have become too long, or all cells were replaced.
///
/// An [`Editor`](crate::Editor) has one already: ask [`Editor::locate`](crate::Editor::locate).
///
/// # Complexity
/// Built in expected O(n log n), for n cells; a query takes expected O(log n) predicates. To name the face of a point on identified sides may take a
/// step for each vertex there from which no edge goes to the right. Linear space.
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
    /// Whether it was up to date before the edit that is being made.
    follows: bool,
}

impl<G: UMonotoneTraits> TrapezoidalMap<G> {
    /// Makes the map of an arrangement.
    ///
    /// # Complexity
    /// Expected O(n log n).
    pub fn new<T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Self {
        Self { trapezoids: Trapezoids::of(arrangement), stamp: arrangement.stamp(), follows: true }
    }

    /// The number of comparisons on the longest path of the search structure, as it was built. It is at most 12 times the binary logarithm of the number of
    /// trapezoids, and a little more, unless three orders of the edges all gave a longer one.
    pub fn longest_path(&self) -> u32 {
        self.trapezoids.longest_path()
    }

    /// Tells whether it should be built anew.
    #[cfg(test)]
    pub(super) fn is_worn(&self) -> bool {
        self.trapezoids.is_worn()
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> PointLocation<G, T> for TrapezoidalMap<G> {
    fn locate(&self, arrangement: &Arrangement<G, T>, point: &G::Point) -> Result<Cell, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        Ok(self.trapezoids.locate(arrangement, point))
    }

    /// A few searches go on at the same time, so that they share the time in which memory is waited for.
    fn locate_all(&self, arrangement: &Arrangement<G, T>, points: &[G::Point]) -> Result<Vec<Cell>, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        Ok(self.trapezoids.locate_all(arrangement, points))
    }

    fn shoot(
        &self,
        arrangement: &Arrangement<G, T>,
        point: &G::Point,
        ray: VerticalRay,
    ) -> Result<Cell, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        Ok(shoot(arrangement, &self.trapezoids, point, ray))
    }
}

/// What a vertical ray meets first: at most two searches.
fn shoot<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    trapezoids: &Trapezoids<G>,
    point: &G::Point,
    ray: VerticalRay,
) -> Cell {
    let column = Column::new(arrangement, point);
    let side = match ray {
        VerticalRay::Up => Side::Above,
        VerticalRay::Down => Side::Below,
    };
    let cell = trapezoids.locate(arrangement, point);
    if column.at_contraction().is_some() {
        return cell;
    }
    let t = match cell {
        Cell::Edge(e) if arrangement.traits().is_vertical(arrangement.curve_of(e)) => return cell,
        Cell::Vertex(v) => {
            let site = trapezoids.site_at(v, column.place.location);
            match leave(arrangement, trapezoids, site.expect("a vertex has a site where its point is"), ray) {
                Ok(t) => t,
                Err(e) => return Cell::Edge(e),
            }
        }
        _ => beside(arrangement, trapezoids, &column.place, side),
    };
    if let Some(met) = end_of(arrangement, trapezoids, &column, t, side) {
        return met;
    }
    if !column.is_round() {
        return column.beyond(ray).unwrap_or_else(|| Cell::Face(trapezoids.face_of(arrangement, t)));
    }
    let v = if ray == VerticalRay::Up { Along::Low } else { Along::High };
    let across = Site { location: Location { v, ..column.place.location }, at: column.place.at };
    let t = match trapezoids.search_along_side(arrangement, &across, side.opposite()) {
        Found::Within(t) => t,
        Found::Site(site) if ray == VerticalRay::Up => return Cell::Vertex(trapezoids.vertex(site)),
        // The ray began there: on the bottom, as which the vertex would have been met before.
        Found::Site(site) => match leave(arrangement, trapezoids, site, ray) {
            Ok(t) => t,
            Err(e) => return Cell::Edge(e),
        },
    };
    end_of(arrangement, trapezoids, &column, t, side).unwrap_or(cell)
}

/// The trapezoid into which a vertical ray leaves a site, or the vertical edge along which it does.
fn leave<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    trapezoids: &Trapezoids<G>,
    site: SiteId,
    ray: VerticalRay,
) -> Result<TrapezoidId, EdgeId> {
    // What is straight above is behind the wall, in the order of places; what is straight below, before it. A vertical edge is the last one
    // before the wall.
    let (t, beside, end) = match ray {
        VerticalRay::Up => (trapezoids.right_of(site)[1], Side::Below, 0),
        VerticalRay::Down => (trapezoids.left_of(site)[0], Side::Above, 1),
    };
    let rail = trapezoids.trapezoid(t).rail(beside);
    if rail.is_none() || trapezoids.rail(rail).ends[end] != site {
        return Ok(t);
    }
    let rail = trapezoids.rail(rail);
    let is_vertical = arrangement.traits().is_vertical(&arrangement.curves()[rail.curve as usize]);
    if is_vertical { Err(rail.edge) } else { Ok(t) }
}

/// The trapezoid straight above or below a place.
fn beside<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    trapezoids: &Trapezoids<G>,
    place: &Site<'_, G>,
    side: Side,
) -> TrapezoidId {
    match trapezoids.search(arrangement, place, &Toward::Straight(side)).0 {
        Found::Within(t) => t,
        Found::Site(_) => unreachable!("only the place itself is looked for at a site"),
    }
}

/// What ends a vertical line through a trapezoid: the vertex of its wall if that is on the line, else the edge; `None` at a side of the
/// parameter space.
fn end_of<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    trapezoids: &Trapezoids<G>,
    column: &Column<'_, G, T>,
    t: TrapezoidId,
    side: Side,
) -> Option<Cell> {
    let trapezoid = trapezoids.trapezoid(t);
    // Of two places with one u, the upper one is behind the other.
    let site = if side == Side::Above { trapezoid.right } else { trapezoid.left };
    if !site.is_none() {
        let place = trapezoids.place(arrangement, site);
        if column.beside(&place).is_eq() {
            // Where a curve ends without a point, it ends on a side; and the line is beside it.
            return place.point().map(|_| Cell::Vertex(trapezoids.vertex(site)));
        }
    }
    let rail = trapezoid.rail(side);
    (!rail.is_none()).then(|| Cell::Edge(trapezoids.rail(rail).edge))
}

/// A map that has missed edits, because it was put in place of another observer later, does not follow: it stays stale, and is made anew
/// at the end of the next operation.
impl<G: UMonotoneTraits, T: Topology<G>> Observer<G, T> for TrapezoidalMap<G> {
    fn before(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>) {
        self.follows = self.stamp == arrangement.stamp();
        if self.follows {
            Follower(&mut self.trapezoids).before(arrangement, edit);
        }
    }

    fn after(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
        if self.follows {
            Follower(&mut self.trapezoids).after(arrangement, edit, done);
            self.stamp = arrangement.stamp();
        }
    }

    fn end_operation(&mut self, arrangement: &Arrangement<G, T>, _: Operation) {
        if self.stamp != arrangement.stamp() || self.trapezoids.is_worn() {
            *self = Self::new(arrangement);
        }
    }

    fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
        *self = Self::new(arrangement);
    }

    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        Stale::check(self.stamp, stamp)
    }
}
