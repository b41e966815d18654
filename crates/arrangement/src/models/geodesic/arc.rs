//! u-monotone arcs.

use super::Geodesic;
use crate::traits::{Along, CurveEnd, Location};
use exact::Sign;
use exact::spherical::{Direction, GreatCircle, turn};

/// A u-monotone arc of a great circle, with a direction: made by [`GeodesicTraits`](super::GeodesicTraits) when it cuts a
/// [`Geodesic`](super::Geodesic).
///
/// Laws:
/// 1. Its circle is run through from `Min` to `Max` end: to the right, or upwards for a meridian.
/// 2. Only ends are on sides, unless the arc lies along the left one.
/// 3. The ends are the same point if the arc goes all around, from side to side.
#[derive(Clone, Debug)]
pub struct GeodesicArc {
    circle: GreatCircle,
    ends: [Direction; 2],
    locations: [Location; 2],
    /// Whether it goes round more than half of a circle.
    is_long: bool,
    is_directed_right: bool,
}

impl GeodesicArc {
    pub(super) fn new(
        circle: GreatCircle,
        [(min, at_min), (max, at_max)]: [(Direction, Location); 2],
        is_directed_right: bool,
    ) -> Self {
        debug_assert!(!circle.sign(2).is_negative(), "the circle goes to the right, or is a meridian");
        let is_long = !circle.is_meridian() && {
            let is_full = at_min.u == Along::Low && at_max.u == Along::High;
            is_full || turn(&min, &max) == Sign::Negative
        };
        Self { circle, ends: [min, max], locations: [at_min, at_max], is_long, is_directed_right }
    }

    /// The circle on which the arc lies, run through to the right, or upwards along the arc if it is a meridian.
    #[inline]
    pub fn circle(&self) -> &GreatCircle {
        &self.circle
    }

    /// An end. A point on the identification is the same for an end on the left and on the right side.
    #[inline]
    pub fn end(&self, end: CurveEnd) -> &Direction {
        &self.ends[end as usize]
    }

    /// On which sides an end is.
    #[inline]
    pub fn location(&self, end: CurveEnd) -> Location {
        self.locations[end as usize]
    }

    /// Tells whether the arc is a piece of a meridian: vertical.
    #[inline]
    pub fn is_meridian(&self) -> bool {
        self.circle.is_meridian()
    }

    /// Tells whether the arc lies on the identification.
    #[inline]
    pub fn is_along_side(&self) -> bool {
        self.is_meridian() && self.locations[0].u == Along::Low
    }

    /// Tells whether the arc goes all around the sphere, from the left to the right side.
    #[inline]
    pub fn is_full(&self) -> bool {
        self.ends_on_sides() == [true; 2]
    }

    /// Tells whether the arc runs from its `Min` to its `Max` end.
    #[inline]
    pub fn is_directed_right(&self) -> bool {
        self.is_directed_right
    }

    /// The end at which the arc begins.
    #[inline]
    pub fn source(&self) -> &Direction {
        &self.ends[usize::from(!self.is_directed_right)]
    }

    /// The end at which the arc stops.
    #[inline]
    pub fn target(&self) -> &Direction {
        &self.ends[usize::from(self.is_directed_right)]
    }

    /// The same arc as a user gives it, from its source to its target. Cut again at the same identification, it is one piece.
    pub fn make_geodesic(&self) -> Geodesic {
        let circle = if self.is_directed_right { self.circle.clone() } else { self.circle.opposite() };
        Geodesic::along(self.source().clone(), self.target().clone(), circle)
    }

    /// Whether it goes round more than half of a circle.
    #[inline]
    pub(super) fn is_long(&self) -> bool {
        self.is_long
    }

    /// For an arc that is not vertical, whether it begins on the left side, and whether it ends on the right one.
    #[inline]
    pub(super) fn ends_on_sides(&self) -> [bool; 2] {
        [self.locations[0].u == Along::Low, self.locations[1].u == Along::High]
    }

    /// An end and where it is.
    #[inline]
    pub(super) fn place(&self, end: CurveEnd) -> (&Direction, Location) {
        (self.end(end), self.location(end))
    }

    /// Tells whether a place of the circle, or half meridian, is where that reaches a side.
    #[inline]
    pub(super) fn is_at_side(&self, location: Location) -> bool {
        if self.is_meridian() { location.v != Along::Inside } else { location.u != Along::Inside }
    }

    /// Where points of the arc are that are not its ends.
    pub(super) fn inner_location(&self) -> Location {
        if self.is_along_side() {
            Location { u: Along::Low, ..Location::INTERIOR }
        } else {
            Location::INTERIOR
        }
    }

    /// A part of the arc; `None` keeps an end.
    pub(super) fn part(&self, ends: [Option<&Direction>; 2]) -> Self {
        let places = CurveEnd::BOTH.map(|end| match ends[end as usize] {
            Some(p) => (p.clone(), self.inner_location()),
            None => (self.end(end).clone(), self.location(end)),
        });
        Self::new(self.circle.clone(), places, self.is_directed_right)
    }

    /// The arc reflected through the center of the sphere, cut at the opposite identification: at the same places from left to right, and mirrored from
    /// bottom to top.
    pub(super) fn antipodal(&self) -> Self {
        let mirrored = |location: Location| match location.v {
            Along::Low => Location { v: Along::High, ..location },
            Along::Inside => location,
            Along::High => Location { v: Along::Low, ..location },
        };
        let ends = self.ends.each_ref().map(Direction::opposite);
        let locations = self.locations.map(mirrored);
        let reflected = Self { ends, locations, circle: self.circle.clone(), ..*self };
        if !self.is_meridian() {
            return reflected;
        }
        // What went up goes down, and is run through the other way.
        let Self { circle, ends: [min, max], locations: [at_min, at_max], is_directed_right, .. } = reflected;
        Self {
            circle: circle.opposite(),
            ends: [max, min],
            locations: [at_max, at_min],
            is_long: self.is_long,
            is_directed_right: !is_directed_right,
        }
    }

    /// The same arc in the other direction.
    pub(super) fn reversed(&self) -> Self {
        Self { is_directed_right: !self.is_directed_right, ..self.clone() }
    }
}
