//! The pieces of paths: segments in the closed rectangle.

use crate::models::straight::Straight;
use crate::traits::{Along, CurveEnd, Location};
use exact::Rational;
use exact::planar::{Line2, Point2, compare_x, compare_xy, compare_y};
use std::borrow::Borrow;
use std::cmp::Ordering;
use std::sync::Arc;

/// The rectangle whose opposite sides are glued.
#[derive(Debug)]
pub(super) struct Torus {
    /// Positive.
    pub(super) period: [Rational; 2],
    /// The lower left corner, the origin, and the upper right one.
    pub(super) corners: [Point2; 2],
}

impl Torus {
    pub(super) fn new(period: [Rational; 2]) -> Self {
        let corners = [Point2::from_i64([0, 0]), Point2::from_rationals(&period)];
        Self { period, corners }
    }

    /// Takes multiples of the periods off, so that coordinates are at least zero and below the periods.
    pub(super) fn reduce(&self, coordinates: [Rational; 2]) -> [Rational; 2] {
        let mut reduced = coordinates;
        for (value, period) in reduced.iter_mut().zip(&self.period) {
            let turns = value.checked_div(period).expect("a period is positive").floor();
            *value -= Rational::from(turns) * period;
        }
        reduced
    }

    /// Where a place in the closed rectangle is.
    fn location(&self, place: &Point2) -> Location {
        let [origin, corner] = &self.corners;
        let along = |compare: fn(&Point2, &Point2) -> Ordering| {
            if compare(place, origin).is_eq() {
                Along::Low
            } else if compare(place, corner).is_eq() {
                Along::High
            } else {
                Along::Inside
            }
        };
        Location { u: along(compare_x), v: along(compare_y) }
    }

    /// The point of the torus that is at a place on the right or top side; `None` for other places, which are their points.
    pub(super) fn point_of_place(&self, place: &Point2) -> Option<Point2> {
        let Location { u, v } = self.location(place);
        let back = [(u, &self.period[0]), (v, &self.period[1])].map(|(along, period)| match along {
            Along::High => -period,
            Along::Low | Along::Inside => Rational::ZERO,
        });
        (u == Along::High || v == Along::High).then(|| place.translated(&back))
    }
}

/// A segment in the closed rectangle, with a direction. Only its ends are on sides, unless it lies along the left or the bottom one.
#[derive(Clone, Debug)]
pub struct TorusSegment {
    torus: Arc<Torus>,
    line: Line2,
    /// The ends in the rectangle, in lexicographic order.
    places: [Point2; 2],
    locations: [Location; 2],
    /// The points of ends on the right or top side.
    points: [Option<Box<Point2>>; 2],
    is_directed_right: bool,
}

impl TorusSegment {
    /// The segment on a line between two places in the closed rectangle, directed from the first to the second.
    pub(super) fn new(torus: &Arc<Torus>, line: Line2, source: Point2, target: Point2) -> Self {
        let is_directed_right = compare_xy(&source, &target).is_lt();
        let places = if is_directed_right { [source, target] } else { [target, source] };
        Self::between(Arc::clone(torus), line, places, is_directed_right)
    }

    fn between(torus: Arc<Torus>, line: Line2, places: [Point2; 2], is_directed_right: bool) -> Self {
        let locations = places.each_ref().map(|place| torus.location(place));
        let points = places.each_ref().map(|place| torus.point_of_place(place).map(Box::new));
        Self { torus, line, places, locations, points, is_directed_right }
    }

    /// Tells whether it is a segment on that torus.
    pub(super) fn is_on(&self, torus: &Arc<Torus>) -> bool {
        Arc::ptr_eq(&self.torus, torus) || self.torus.period == torus.period
    }

    /// An end in the closed rectangle: on the right and top side, with the period as coordinate.
    #[inline]
    pub fn place(&self, end: CurveEnd) -> &Point2 {
        &self.places[end as usize]
    }

    /// An end as a point of the torus, with coordinates below the periods.
    #[inline]
    pub fn point(&self, end: CurveEnd) -> &Point2 {
        self.points[end as usize].as_deref().unwrap_or(&self.places[end as usize])
    }

    /// On which sides an end is.
    #[inline]
    pub fn location(&self, end: CurveEnd) -> Location {
        self.locations[end as usize]
    }

    /// Tells whether the segment lies on the left or the bottom side.
    #[inline]
    pub fn is_along_side(&self) -> bool {
        let [min, max] = self.locations;
        (min.u == Along::Low && max.u == Along::Low) || (min.v == Along::Low && max.v == Along::Low)
    }

    /// The line in the coordinates of the rectangle.
    #[inline]
    pub fn supporting_line(&self) -> &Line2 {
        &self.line
    }
}

impl Straight for TorusSegment {
    #[inline]
    fn line(&self) -> impl Borrow<Line2> {
        &self.line
    }

    /// The places: predicates compute in the rectangle.
    #[inline]
    fn end(&self, end: CurveEnd) -> Option<&Point2> {
        Some(self.place(end))
    }

    #[inline]
    fn is_directed_right(&self) -> bool {
        self.is_directed_right
    }

    fn with_ends(&self, ends: [Option<Point2>; 2]) -> Self {
        let places = ends.map(|end| end.expect("a piece of a segment is bounded"));
        Self::between(Arc::clone(&self.torus), self.line.clone(), places, self.is_directed_right)
    }

    fn opposite(&self) -> Self {
        Self { is_directed_right: !self.is_directed_right, ..self.clone() }
    }
}
