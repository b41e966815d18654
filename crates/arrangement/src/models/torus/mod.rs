//! Straight paths on a flat torus.
//!
//! | traits | point | u-monotone curve | curve | refinements |
//! |---|---|---|---|---|
//! | [`TorusSegmentTraits`] | [`Point2`] in [0, P) x [0, Q) | [`TorusSegment`] | [`TorusPath`] | identified left to right, and bottom to top |
//!
//! | file | role |
//! |---|---|
//! | `path` | paths in the universal cover, and how they are cut where they leave the rectangle |
//! | `segment` | the pieces: segments in the closed rectangle |
//! | this one | the traits |
//!
//! A point of the torus that lies on a side of the rectangle has two *places* there, one in a corner four. Predicates compute with
//! places; ends are given to the outside as points with coordinates below the periods.

mod path;
mod segment;
#[cfg(test)]
mod tests;

pub use path::TorusPath;
pub use segment::TorusSegment;

use super::straight::{self, Straight};
use crate::traits::{
    Along, ApproxTraits, ArrangementTraits, BasicTraits, BoundaryTraits, CurveEnd, DirectionalTraits,
    IdentifiedBottomTopTraits, IdentifiedLeftRightTraits, Intersection, LandmarkTraits, Location, Meeting,
    Multiplicity, Piece, UMonotoneTraits, Window,
};
use exact::planar::{Point2, compare_x, compare_xy, compare_y, side_of_key};
use exact::{Rational, Sign};
use segment::Torus;
use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

/// Why a torus or a path on it cannot be made.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum TorusError {
    /// A period is zero or negative: 0 for that of u, 1 for that of v.
    PeriodNotPositive(usize),
    /// A path winds round the torus so often that it would be cut into more than [`TorusPath::MAX_PIECES`] pieces.
    TooManyPieces,
}

impl fmt::Display for TorusError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::PeriodNotPositive(axis) => {
                write!(f, "the period along {} is not positive", ["u", "v"][axis & 1])
            }
            Self::TooManyPieces => {
                write!(
                    f,
                    "the path winds round the torus so often that it has more than {} pieces",
                    TorusPath::MAX_PIECES
                )
            }
        }
    }
}

impl std::error::Error for TorusError {}

/// Traits of straight paths on a flat torus: the plane, in which two points are one if they differ by multiples of the periods.
///
/// The parameter space is the rectangle [0, P] x [0, Q]. Curves along a side belong to the left and to the bottom one. The values make
/// points and paths, and are good for those of their own torus only.
///
/// ```
/// use splitstar_arrangement::models::TorusSegmentTraits;
/// use splitstar_arrangement::traits::ArrangementTraits;
/// use exact::planar::Point2;
/// let traits = TorusSegmentTraits::new([4.into(), 4.into()])?;
/// // Once round along u and twice along v: cut at the left side, and at the bottom when half way.
/// let path = traits.closed_path(&Point2::from_i64([0, 1]), [1, 2])?;
/// let mut pieces = Vec::new();
/// traits.make_u_monotone(&path, &mut pieces);
/// assert_eq!(pieces.len(), 3);
/// # Ok::<(), splitstar_arrangement::models::TorusError>(())
/// ```
#[derive(Clone, Debug)]
pub struct TorusSegmentTraits {
    torus: Arc<Torus>,
}

impl TorusSegmentTraits {
    /// Makes the traits of a torus with given periods along u and v.
    ///
    /// # Errors
    /// [`TorusError::PeriodNotPositive`].
    pub fn new(period: [Rational; 2]) -> Result<Self, TorusError> {
        match period.iter().position(|period| period.sign() != Sign::Positive) {
            Some(axis) => Err(TorusError::PeriodNotPositive(axis)),
            None => Ok(Self { torus: Arc::new(Torus::new(period)) }),
        }
    }

    /// The periods along u and v.
    pub fn period(&self) -> &[Rational; 2] {
        &self.torus.period
    }

    /// Gives the point with coordinates below the periods that differs from `p` by multiples of them.
    pub fn point(&self, p: &Point2) -> Point2 {
        Point2::from_rationals(&self.torus.reduce(p.coordinates()))
    }

    /// Makes the straight path that begins at a point and moves by a vector, perhaps round the torus many times.
    ///
    /// Both of its ends are real: where it comes back to its beginning, that is a vertex. A path that does not move is a point.
    ///
    /// # Errors
    /// [`TorusError::TooManyPieces`].
    pub fn path(&self, start: &Point2, displacement: &[Rational; 2]) -> Result<TorusPath, TorusError> {
        TorusPath::new(&self.torus, start, displacement.clone(), false)
    }

    /// Makes the closed geodesic through a point that winds round the torus as often as given along u and v.
    ///
    /// It has no end: where it begins is of no importance. One that winds zero times is the point.
    ///
    /// # Errors
    /// [`TorusError::TooManyPieces`].
    pub fn closed_path(&self, through: &Point2, winding: [i64; 2]) -> Result<TorusPath, TorusError> {
        let [p, q] = &self.torus.period;
        let displacement = [Rational::from(winding[0]) * p, Rational::from(winding[1]) * q];
        TorusPath::new(&self.torus, through, displacement, true)
    }

    /// The places of a point in the closed rectangle.
    fn places(&self, p: &Point2) -> Vec<Point2> {
        let [width, height] = &self.torus.period;
        let mut places = vec![p.clone()];
        if self.is_on_left_right(p) {
            places.push(p.translated(&[width.clone(), Rational::ZERO]));
        }
        if self.is_on_bottom_top(p) {
            let above = |place: &Point2| place.translated(&[Rational::ZERO, height.clone()]);
            places.extend(places.iter().map(above).collect::<Vec<_>>());
        }
        places
    }

    /// The place of a point of a curve that is meant by `p` as its end, or as an inner point.
    fn place_of<'a>(curve: &'a TorusSegment, end: CurveEnd, p: Option<&'a Point2>) -> &'a Point2 {
        match p {
            Some(p) if curve.location(end).is_interior() || p != curve.point(end) => p,
            _ => curve.place(end),
        }
    }

    /// Tells whether a curve reaches the right side, but not the left one.
    fn is_only_on_right(curve: &TorusSegment) -> bool {
        curve.location(CurveEnd::Max).u == Along::High && curve.location(CurveEnd::Min).u != Along::Low
    }
}

impl BasicTraits for TorusSegmentTraits {
    type Point = Point2;
    type UMonotoneCurve = TorusSegment;

    // In the rectangle, where sweeps take place. Two curves may besides have ends in the same point of the torus.
    const MEET_ONCE: bool = true;
    const OVERLAPS_ARE_PLAIN: bool = true;

    #[inline]
    fn order_key(&self, p: &Point2) -> u64 {
        p.order_key()
    }

    #[inline]
    fn order_range(&self, p: &Point2) -> (u64, u32) {
        p.order_range()
    }

    #[inline]
    fn compare_u(&self, p: &Point2, q: &Point2) -> Ordering {
        compare_x(p, q)
    }

    #[inline]
    fn compare_uv(&self, p: &Point2, q: &Point2) -> Ordering {
        compare_xy(p, q)
    }

    /// Coordinates are at least zero and below the periods.
    fn is_canonical(&self, p: &Point2) -> bool {
        let [origin, corner] = &self.torus.corners;
        [compare_x, compare_y].iter().all(|compare| compare(p, origin).is_ge() && compare(p, corner).is_lt())
    }

    /// The periods are the same.
    fn is_own_curve(&self, curve: &TorusSegment) -> bool {
        curve.is_on(&self.torus)
    }

    #[inline]
    fn end_point<'a>(&self, curve: &'a TorusSegment, end: CurveEnd) -> Option<&'a Point2> {
        Some(curve.point(end))
    }

    #[inline]
    fn is_vertical(&self, curve: &TorusSegment) -> bool {
        straight::is_vertical(curve)
    }

    /// Takes a point on the bottom as it is. One on the left is taken as on the right side if the curve reaches that side only.
    ///
    /// So an end on the top side does not give `Equal`: its point is below.
    #[inline]
    fn compare_v_at_u(&self, p: &Point2, curve: &TorusSegment) -> Ordering {
        if Self::is_only_on_right(curve) && self.is_on_left_right(p) {
            return compare_y(p, curve.place(CurveEnd::Max));
        }
        straight::compare_v_at_u(p, curve)
    }

    #[inline]
    fn side_key(&self, curve: &TorusSegment) -> [u32; 3] {
        straight::side_key(curve)
    }

    #[inline]
    fn compare_v_at_u_by_key(&self, p: &Point2, key: &[u32; 3]) -> Option<Ordering> {
        side_of_key(p, key).map(Sign::ordering)
    }

    #[inline]
    fn compare_v_at_u_right(&self, a: &TorusSegment, b: &TorusSegment, _: &Point2) -> Ordering {
        straight::compare_v_at_u_right(a, b)
    }

    #[inline]
    fn compare_v_at_u_left(&self, a: &TorusSegment, b: &TorusSegment, _: &Point2) -> Ordering {
        straight::compare_v_at_u_right(b, a)
    }

    fn is_in_u_range(&self, p: &Point2, curve: &TorusSegment) -> bool {
        straight::is_in_u_range(p, curve)
            || (curve.location(CurveEnd::Max).u == Along::High && self.is_on_left_right(p))
    }

    fn is_on_curve(&self, p: &Point2, curve: &TorusSegment) -> bool {
        self.places(p).iter().any(|place| {
            straight::is_in_u_range(place, curve) && straight::compare_v_at_u(place, curve).is_eq()
        })
    }
}

impl UMonotoneTraits for TorusSegmentTraits {
    /// Besides what the pieces have in common in the rectangle, ends on sides are common points if the other piece comes to the same
    /// point of the torus, from whichever side.
    fn intersect(
        &self,
        a: &TorusSegment,
        b: &TorusSegment,
        out: &mut Vec<Intersection<Point2, TorusSegment>>,
    ) {
        let first = out.len();
        out.extend(straight::intersection(a, b).map(|common| match common {
            Intersection::Point(place, multiplicity) => {
                Intersection::Point(self.torus.point_of_place(&place).unwrap_or(place), multiplicity)
            }
            overlap @ Intersection::Overlap(_) => overlap,
        }));
        for (curve, other) in [(a, b), (b, a)] {
            for end in CurveEnd::BOTH {
                let point = curve.point(end);
                let is_known = |common: &Intersection<Point2, TorusSegment>| match common {
                    Intersection::Point(p, _) => p == point,
                    Intersection::Overlap(piece) => self.is_on_curve(point, piece),
                };
                let is_new = !curve.location(end).is_interior()
                    && self.is_on_curve(point, other)
                    && !out[first..].iter().any(is_known);
                if is_new {
                    out.push(Intersection::Point(point.clone(), Multiplicity::Unknown));
                }
            }
        }
        let start = |common: &Intersection<Point2, TorusSegment>| match common {
            Intersection::Point(point, _) => point.clone(),
            Intersection::Overlap(piece) => piece.point(CurveEnd::Min).clone(),
        };
        out[first..].sort_by_cached_key(start);
    }

    fn split(&self, curve: &TorusSegment, p: &Point2) -> [TorusSegment; 2] {
        straight::split(curve, p)
    }

    /// The result is directed as `a`. Pieces that touch across a side of the rectangle are not merged.
    fn merge(&self, a: &TorusSegment, b: &TorusSegment) -> Option<TorusSegment> {
        straight::merge(a, b)
    }

    fn is_mergeable(&self, a: &TorusSegment, b: &TorusSegment) -> bool {
        straight::left_of_mergeable(a, b).is_some()
    }

    fn next_meeting(
        &self,
        below: &TorusSegment,
        above: &TorusSegment,
        window: Window<'_, Point2>,
    ) -> Meeting<Point2> {
        let first = [below, above][window.first_to_end & 1];
        if window.until.is_none() && first.is_along_side() {
            // Its part may end before its own end; but what comes to the side ends there.
            return Meeting::Never;
        }
        // Only curves along a side touch one elsewhere than in an end, so an end on a side is that of the support.
        let until = window.until.unwrap_or(first.place(CurveEnd::Max));
        straight::next_meeting(below, above, Some(until), window.first_to_end)
    }

    fn trim(&self, curve: &TorusSegment, min: Option<&Point2>, max: Option<&Point2>) -> TorusSegment {
        let [min, max] =
            [(CurveEnd::Min, min), (CurveEnd::Max, max)].map(|(end, p)| Some(Self::place_of(curve, end, p)));
        straight::trim(curve, min, max)
    }
}

impl ArrangementTraits for TorusSegmentTraits {
    type Curve = TorusPath;

    fn make_u_monotone(&self, curve: &TorusPath, out: &mut Vec<Piece<Point2, TorusSegment>>) {
        curve.cut(out);
    }
}

impl DirectionalTraits for TorusSegmentTraits {
    #[inline]
    fn is_directed_right(&self, curve: &TorusSegment) -> bool {
        Straight::is_directed_right(curve)
    }

    fn opposite(&self, curve: &TorusSegment) -> TorusSegment {
        Straight::opposite(curve)
    }
}

impl ApproxTraits for TorusSegmentTraits {
    #[inline]
    fn approx_point(&self, p: &Point2) -> [f64; 2] {
        p.approx_f64()
    }

    /// In the closed rectangle: an end on the right or top side is drawn there.
    fn approx_curve(
        &self,
        curve: &TorusSegment,
        min: Option<&Point2>,
        max: Option<&Point2>,
        _: [f64; 4],
        out: &mut Vec<[f64; 2]>,
    ) {
        let ends = [(CurveEnd::Min, min), (CurveEnd::Max, max)];
        out.extend(ends.map(|(end, p)| Self::place_of(curve, end, p).approx_f64()));
    }
}

impl LandmarkTraits for TorusSegmentTraits {
    fn approx_to_point(&self, parameters: [f64; 2]) -> Option<Point2> {
        Point2::from_f64s(parameters).map(|point| self.point(&point))
    }
}

impl BoundaryTraits for TorusSegmentTraits {
    #[inline]
    fn end_location(&self, curve: &TorusSegment, end: CurveEnd) -> Location {
        curve.location(end)
    }
}

impl IdentifiedLeftRightTraits for TorusSegmentTraits {
    #[inline]
    fn is_on_left_right(&self, p: &Point2) -> bool {
        compare_x(p, &self.torus.corners[0]).is_eq()
    }

    #[inline]
    fn compare_v_on_left_right(&self, p: &Point2, q: &Point2) -> Ordering {
        compare_y(p, q)
    }
}

impl IdentifiedBottomTopTraits for TorusSegmentTraits {
    #[inline]
    fn is_on_bottom_top(&self, p: &Point2) -> bool {
        compare_y(p, &self.torus.corners[0]).is_eq()
    }

    #[inline]
    fn compare_u_on_bottom_top(&self, p: &Point2, q: &Point2) -> Ordering {
        compare_x(p, q)
    }
}
