//! What a model must tell so that chains can be made of its curves.

use crate::models::{
    Linear, LinearTraits, MinimalSegment, MinimalSegmentTraits, Segment, SegmentTraits, TorusSegmentTraits,
};
use crate::traits::{IdentifiedBottomTopTraits, IdentifiedLeftRightTraits, Piece, UMonotoneTraits};
use exact::planar::Point2;

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

/// Two points of a torus do not tell which way round a path between them goes: polycurves are made of paths.
impl PieceTraits for TorusSegmentTraits {
    fn is_joint_allowed(&self, p: &Point2) -> bool {
        !self.is_on_left_right(p) && !self.is_on_bottom_top(p)
    }
}
