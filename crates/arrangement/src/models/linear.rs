//! Segments, rays and lines, mixed.
//!
//! | traits | point | u-monotone curve | curve | refinements |
//! |---|---|---|---|---|
//! | [`LinearTraits`] | [`Point2`] | [`Linear`] | [`Linear`] | open left, right, bottom and top |

#[cfg(test)]
mod tests;

use super::Segment;
use super::straight::{Straight, straight_traits};
use crate::traits::{
    Along, BoundaryTraits, CurveEnd, Location, NearBottomTopTraits, NearLeftRightTraits, OpenBottomTopTraits,
    OpenLeftRightTraits,
};
use exact::planar::{Line2, Point2, compare_xy, side_of_line};
use std::borrow::Borrow;
use std::cmp::Ordering;

/// A segment, a ray or a line, with a direction.
///
/// ```
/// use splitstar_arrangement::models::Linear;
/// use exact::planar::Point2;
/// let [p, q] = [[3, 1], [0, 0]].map(Point2::from_i64);
/// let ray = Linear::ray(p.clone(), &q).expect("the points are different");
/// assert_eq!(ray.ends(), &[None, Some(p)]);
/// assert!(!ray.is_directed_right());
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Linear {
    line: Line2,
    /// In lexicographic order; `None` where there is no end.
    ends: [Option<Point2>; 2],
    is_directed_right: bool,
}

impl Linear {
    /// Makes the segment from a source to a target; `None` if they are equal.
    pub fn segment(source: Point2, target: Point2) -> Option<Self> {
        Segment::new(source, target).map(Self::from)
    }

    /// Makes the ray that begins at a source and goes through another point; `None` if they are equal.
    pub fn ray(source: Point2, through: &Point2) -> Option<Self> {
        let line = Line2::through(&source, through)?;
        let is_directed_right = compare_xy(&source, through) == Ordering::Less;
        let ends = if is_directed_right { [Some(source), None] } else { [None, Some(source)] };
        Some(Self { line, ends, is_directed_right })
    }

    /// Makes the line through two points, directed from the first to the second; `None` if they are equal.
    pub fn line(p: &Point2, q: &Point2) -> Option<Self> {
        let is_directed_right = compare_xy(p, q) == Ordering::Less;
        Some(Self { line: Line2::through(p, q)?, ends: [None, None], is_directed_right })
    }

    /// Makes a whole line, directed to the right, or upwards if it is vertical.
    pub fn of_line(line: Line2) -> Self {
        Self { line, ends: [None, None], is_directed_right: true }
    }

    /// The line that the curve lies on.
    #[inline]
    pub fn supporting_line(&self) -> &Line2 {
        &self.line
    }

    /// The ends in lexicographic order; `None` where the curve is unbounded.
    #[inline]
    pub fn ends(&self) -> &[Option<Point2>; 2] {
        &self.ends
    }

    /// Tells whether the curve runs from its lexicographically smaller end to the greater one.
    #[inline]
    pub fn is_directed_right(&self) -> bool {
        self.is_directed_right
    }
}

impl From<Segment> for Linear {
    fn from(segment: Segment) -> Self {
        let (line, ends, is_directed_right) = segment.into_parts();
        Self { line, ends: ends.map(Some), is_directed_right }
    }
}

impl Straight for Linear {
    #[inline]
    fn line(&self) -> impl Borrow<Line2> {
        &self.line
    }

    #[inline]
    fn end(&self, end: CurveEnd) -> Option<&Point2> {
        self.ends[end as usize].as_ref()
    }

    #[inline]
    fn is_directed_right(&self) -> bool {
        self.is_directed_right
    }

    fn with_ends(&self, ends: [Option<Point2>; 2]) -> Self {
        Self { line: self.line.clone(), ends, is_directed_right: self.is_directed_right }
    }

    fn opposite(&self) -> Self {
        Self { is_directed_right: !self.is_directed_right, ..self.clone() }
    }
}

/// Traits of segments, rays and lines in the whole plane.
///
/// Vertical curves are unbounded downwards and upwards, all others to the left and right.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LinearTraits;

straight_traits!(LinearTraits, Linear);

impl BoundaryTraits for LinearTraits {
    #[inline]
    fn end_location(&self, curve: &Linear, end: CurveEnd) -> Location {
        if curve.ends[end as usize].is_some() {
            return Location::INTERIOR;
        }
        let along = match end {
            CurveEnd::Min => Along::Low,
            CurveEnd::Max => Along::High,
        };
        if curve.line.is_vertical() {
            Location { u: Along::Inside, v: along }
        } else {
            Location { u: along, v: Along::Inside }
        }
    }
}

impl NearLeftRightTraits for LinearTraits {
    #[inline]
    fn compare_v_near_side(&self, a: &Linear, b: &Linear, end: CurveEnd) -> Ordering {
        let by_slope = a.line.compare_slope(&b.line);
        match end {
            CurveEnd::Min => by_slope.reverse(),
            CurveEnd::Max => by_slope,
        }
        .then_with(|| compare_parallel(&a.line, &b.line))
    }
}

impl NearBottomTopTraits for LinearTraits {
    #[inline]
    fn compare_u_near_end(&self, p: &Point2, curve: &Linear, _: CurveEnd) -> Ordering {
        // The positive side of a vertical line is the left one.
        side_of_line(p, &curve.line).ordering().reverse()
    }

    #[inline]
    fn compare_u_of_ends(&self, (a, _): (&Linear, CurveEnd), (b, _): (&Linear, CurveEnd)) -> Ordering {
        compare_parallel(&a.line, &b.line).reverse()
    }
}

impl OpenLeftRightTraits for LinearTraits {}
impl OpenBottomTopTraits for LinearTraits {}

/// Compares two parallel lines along their common normal: `Less` means that `l` is below `m`, or right of it if they are vertical.
fn compare_parallel(l: &Line2, m: &Line2) -> Ordering {
    if l.is_same(m) {
        return Ordering::Equal;
    }
    let ([a, b, c], [d, e, f]) = (l.coefficients(), m.coefficients());
    // c/b against f/e with positive b and e, or -c/a against -f/d with negative a and d.
    if l.is_vertical() { (c * -d).cmp(&(f * -a)) } else { (c * e).cmp(&(f * b)) }
}
