//! Segments that keep their line.
//!
//! | traits | point | u-monotone curve | curve | refinements |
//! |---|---|---|---|---|
//! | [`SegmentTraits`] | [`Point2`] | [`Segment`] | [`Segment`] | bounded; closed left, right, bottom, top |

use super::straight::{Straight, straight_traits};
use crate::traits::{BoundedTraits, ClosedBottomTopTraits, ClosedLeftRightTraits, CurveEnd};
use exact::planar::{Line2, Point2, compare_xy, side_of_line};
use std::borrow::Borrow;
use std::cmp::Ordering;

/// A bounded segment, directed from a source to a target, and the line through both.
///
/// ```
/// use splitstar_arrangement::models::Segment;
/// use exact::planar::Point2;
/// let segment = Segment::from_i64([[3, 1], [0, 0]]).expect("the ends are different");
/// assert_eq!(segment.target(), &Point2::from_i64([0, 0]));
/// assert_eq!(segment.min(), segment.target());
/// assert!(Segment::from_i64([[3, 1], [3, 1]]).is_none());
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Segment {
    line: Line2,
    /// In lexicographic order.
    ends: [Point2; 2],
    is_directed_right: bool,
}

impl Segment {
    /// Makes the segment from a source to a target; `None` if they are equal.
    pub fn new(source: Point2, target: Point2) -> Option<Self> {
        let line = Line2::through(&source, &target)?;
        let is_directed_right = compare_xy(&source, &target) == Ordering::Less;
        let ends = if is_directed_right { [source, target] } else { [target, source] };
        Some(Self { line, ends, is_directed_right })
    }

    /// Makes the segment from a source to a target with integer coordinates; `None` if they are equal.
    pub fn from_i64(ends: [[i64; 2]; 2]) -> Option<Self> {
        let [source, target] = ends.map(Point2::from_i64);
        Self::new(source, target)
    }

    /// Makes the segment from a source to a target on a line that is known; `None` if they are equal.
    ///
    /// So the line may be narrower than one through the points, and nothing is computed but their order.
    ///
    /// # Panics
    /// In debug builds, if a point is not on the line.
    ///
    /// ```
    /// use exact::planar::{Line2, Point2};
    /// use splitstar_arrangement::models::Segment;
    /// let line = Line2::from_integers([1, -2, 0].map(Into::into)).expect("not all are zero");
    /// let [p, q] = [[4, 2], [0, 0]].map(Point2::from_i64);
    /// assert_eq!(Segment::on_line(line.clone(), p.clone(), q.clone()), Segment::new(p.clone(), q));
    /// assert_eq!(Segment::on_line(line, p.clone(), p), None);
    /// ```
    pub fn on_line(line: Line2, source: Point2, target: Point2) -> Option<Self> {
        debug_assert!([&source, &target].iter().all(|p| side_of_line(p, &line).is_zero()), "on the line");
        let (ends, is_directed_right) = match compare_xy(&source, &target) {
            Ordering::Less => ([source, target], true),
            Ordering::Equal => return None,
            Ordering::Greater => ([target, source], false),
        };
        Some(Self { line, ends, is_directed_right })
    }

    /// Tells whether the segment is directed from the lesser to the greater end.
    #[inline]
    pub fn is_directed_right(&self) -> bool {
        self.is_directed_right
    }

    /// The line that the segment lies on.
    #[inline]
    pub fn line(&self) -> &Line2 {
        &self.line
    }

    /// The lexicographically smaller end.
    #[inline]
    pub fn min(&self) -> &Point2 {
        &self.ends[0]
    }

    /// The lexicographically greater end.
    #[inline]
    pub fn max(&self) -> &Point2 {
        &self.ends[1]
    }

    /// The end at which the segment begins.
    #[inline]
    pub fn source(&self) -> &Point2 {
        &self.ends[usize::from(!self.is_directed_right)]
    }

    /// The end at which the segment stops.
    #[inline]
    pub fn target(&self) -> &Point2 {
        &self.ends[usize::from(self.is_directed_right)]
    }

    /// The line, the ends in lexicographic order, and whether the segment is directed from the first to the second.
    pub(super) fn into_parts(self) -> (Line2, [Point2; 2], bool) {
        (self.line, self.ends, self.is_directed_right)
    }
}

impl Straight for Segment {
    #[inline]
    fn line(&self) -> impl Borrow<Line2> {
        &self.line
    }

    #[inline]
    fn end(&self, end: CurveEnd) -> Option<&Point2> {
        Some(&self.ends[end as usize])
    }

    #[inline]
    fn is_directed_right(&self) -> bool {
        self.is_directed_right
    }

    fn with_ends(&self, ends: [Option<Point2>; 2]) -> Self {
        let ends = ends.map(|end| end.expect("a piece of a segment is bounded"));
        Self { line: self.line.clone(), ends, is_directed_right: self.is_directed_right }
    }

    fn opposite(&self) -> Self {
        Self { is_directed_right: !self.is_directed_right, ..self.clone() }
    }
}

/// Traits of segments that keep their line, so that nothing is computed twice. The choice for speed.
///
/// ```
/// use splitstar_arrangement::models::{Segment, SegmentTraits};
/// use splitstar_arrangement::traits::{BasicTraits, Intersection, Multiplicity, UMonotoneTraits};
/// use std::cmp::Ordering;
/// let a = Segment::from_i64([[0, 0], [3, 1]]).expect("the ends are different");
/// let b = Segment::from_i64([[0, 1], [3, 0]]).expect("the ends are different");
/// let mut common = Vec::new();
/// SegmentTraits.intersect(&a, &b, &mut common);
/// let [Intersection::Point(p, Multiplicity::Odd)] = &common[..] else { panic!("they cross") };
/// assert_eq!(p.to_string(), "(3/2, 1/2)");
/// assert_eq!(SegmentTraits.compare_v_at_u_right(&a, &b, p), Ordering::Greater);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SegmentTraits;

straight_traits!(SegmentTraits, Segment);

impl BoundedTraits for SegmentTraits {}
impl ClosedLeftRightTraits for SegmentTraits {}
impl ClosedBottomTopTraits for SegmentTraits {}
