//! What a model must tell so that chains can be made of its curves.

use crate::models::{
    Linear, LinearTraits, MinimalSegment, MinimalSegmentTraits, Segment, SegmentTraits, TorusSegment,
    TorusSegmentTraits,
};
use crate::traits::{
    BasicTraits, CurveEnd, DirectionalTraits, IdentifiedBottomTopTraits, IdentifiedLeftRightTraits, Piece,
    UMonotoneTraits,
};
use exact::planar::Point2;
use std::cmp::Ordering;

/// Curves of which chains can be made.
pub trait PieceTraits: UMonotoneTraits {
    /// Tells whether two curves that share an end can be pieces of one chain there: whether the point is in the interior of the
    /// parameter space.
    ///
    /// So chains come to sides only with their ends, or are one piece along a side. The provided version is for surfaces on which
    /// every point is in the interior.
    #[inline]
    fn is_joint_allowed(&self, p: &Self::Point) -> bool {
        let _ = p;
        true
    }

    /// Tells, of two curves that share this end on a side of the parameter space, whether the second goes back the way that the
    /// first came: whether near that end they are one curve.
    ///
    /// Curves that come to the side in different places, as one does from the left and the other from the right, are not. The
    /// provided version is for surfaces on which every point is in the interior: it is not asked.
    fn is_foldback_on_side(&self, a: &Self::UMonotoneCurve, b: &Self::UMonotoneCurve, end: CurveEnd) -> bool {
        let _ = (a, b, end);
        false
    }

    /// Compares the u-coordinate of a point in the interior with that of an end of a curve; `None` if that end has no point.
    ///
    /// The provided version compares with the point of the end. A model with a contracted side has to override it: the point of an end there does not
    /// tell its u-coordinate.
    fn compare_u_to_end(
        &self,
        p: &Self::Point,
        curve: &Self::UMonotoneCurve,
        end: CurveEnd,
    ) -> Option<Ordering> {
        self.end_point(curve, end).map(|end| self.compare_u(p, end))
    }

    /// Tells whether a curve runs to the right, if it has a direction. Only where its ends do not tell which way a polycurve runs
    /// through it does the direction matter, as for a curve whose ends are one point.
    #[inline]
    fn direction(&self, curve: &Self::UMonotoneCurve) -> Option<bool> {
        let _ = curve;
        None
    }
}

/// Curves of which two points define one, as they do a segment.
pub trait ConnectTraits: PieceTraits {
    /// Appends the curve from one point to another: its u-monotone pieces, in their order along it.
    ///
    /// Degenerate: nothing, if the points are equal.
    fn connect(
        &self,
        source: &Self::Point,
        target: &Self::Point,
        out: &mut Vec<Piece<Self::Point, Self::UMonotoneCurve>>,
    );
}

macro_rules! connect_by_segments {
    ($($traits:ty, $curve:ty, $make:path;)*) => {
        $(
            impl PieceTraits for $traits {}

            impl ConnectTraits for $traits {
                fn connect(&self, source: &Point2, target: &Point2, out: &mut Vec<Piece<Point2, $curve>>) {
                    let segment = $make(source.clone(), target.clone());
                    out.extend(segment.map(|curve| Piece::Curve { curve, is_artificial: [false; 2] }));
                }
            }
        )*
    };
}

connect_by_segments! {
    SegmentTraits, Segment, Segment::new;
    MinimalSegmentTraits, MinimalSegment, MinimalSegment::new;
    LinearTraits, Linear, Linear::segment;
}

/// Two points of a torus do not tell which way round a path between them goes: see
/// [`make_cover_polyline`](super::PolycurveTraits::make_cover_polyline).
impl PieceTraits for TorusSegmentTraits {
    fn is_joint_allowed(&self, p: &Point2) -> bool {
        !self.is_on_left_right(p) && !self.is_on_bottom_top(p)
    }

    fn is_foldback_on_side(&self, a: &TorusSegment, b: &TorusSegment, end: CurveEnd) -> bool {
        // The ends are one point, so in the same place of the rectangle if on the same sides.
        if a.location(end) != b.location(end) {
            return false;
        }
        let (p, is_vertical) = (a.point(end), [a, b].map(|piece| self.is_vertical(piece)));
        match (is_vertical, end) {
            ([true, true], _) => true,
            ([false, false], CurveEnd::Min) => self.compare_v_at_u_right(a, b, p) == Ordering::Equal,
            ([false, false], CurveEnd::Max) => self.compare_v_at_u_left(a, b, p) == Ordering::Equal,
            _ => false,
        }
    }

    /// Once round the torus, a piece has its ends in one point; and between two points on sides, two pieces may.
    fn direction(&self, curve: &TorusSegment) -> Option<bool> {
        Some(self.is_directed_right(curve))
    }
}
