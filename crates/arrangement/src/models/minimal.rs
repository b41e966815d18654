//! Segments that are two points and nothing else.
//!
//! | traits | point | u-monotone curve | curve | refinements |
//! |---|---|---|---|---|
//! | [`MinimalSegmentTraits`] | [`Point2`] | [`MinimalSegment`] | [`MinimalSegment`] | bounded; closed left, right, bottom, top |

use super::straight::{Straight, straight_traits};
use crate::traits::{BoundedTraits, ClosedBottomTopTraits, ClosedLeftRightTraits, CurveEnd};
use exact::planar::{Line2, Point2, compare_xy};
use std::borrow::Borrow;
use std::cmp::Ordering;

/// A bounded segment, directed from a source to a target. Its line is made whenever it is needed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MinimalSegment {
    /// In lexicographic order.
    ends: [Point2; 2],
    is_directed_right: bool,
}

impl MinimalSegment {
    /// Makes the segment from a source to a target; `None` if they are equal.
    pub fn new(source: Point2, target: Point2) -> Option<Self> {
        match compare_xy(&source, &target) {
            Ordering::Less => Some(Self { ends: [source, target], is_directed_right: true }),
            Ordering::Equal => None,
            Ordering::Greater => Some(Self { ends: [target, source], is_directed_right: false }),
        }
    }

    /// Makes the segment from a source to a target with integer coordinates; `None` if they are equal.
    pub fn from_i64(ends: [[i64; 2]; 2]) -> Option<Self> {
        let [source, target] = ends.map(Point2::from_i64);
        Self::new(source, target)
    }

    /// The ends in lexicographic order.
    #[inline]
    pub fn ends(&self) -> &[Point2; 2] {
        &self.ends
    }
}

impl Straight for MinimalSegment {
    #[inline]
    fn line(&self) -> impl Borrow<Line2> {
        let [min, max] = &self.ends;
        Line2::through(min, max).expect("the ends of a segment are different")
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
        Self { ends, is_directed_right: self.is_directed_right }
    }

    fn opposite(&self) -> Self {
        Self { is_directed_right: !self.is_directed_right, ..self.clone() }
    }
}

/// Traits of segments that keep their two ends only. The choice for memory.
///
/// It answers as [`SegmentTraits`](super::SegmentTraits) does. Every predicate makes the lines that it needs, at the cost of a
/// greatest common divisor; between constructed points, as the parts of a segment that was cut, the coordinates have to be made, too.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct MinimalSegmentTraits;

straight_traits!(MinimalSegmentTraits, MinimalSegment);

impl BoundedTraits for MinimalSegmentTraits {}
impl ClosedLeftRightTraits for MinimalSegmentTraits {}
impl ClosedBottomTopTraits for MinimalSegmentTraits {}
