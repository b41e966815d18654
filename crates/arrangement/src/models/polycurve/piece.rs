//! What a model must tell so that chains can be made of its curves.

use crate::traits::{Piece, UMonotoneTraits};

/// Curves of which chains can be made.
pub trait PieceTraits: UMonotoneTraits {
    /// Tells whether two curves that share an end can be pieces of one chain there: whether the point is in the interior of the
    /// parameter space.
    ///
    /// The provided version is for surfaces on which every point is.
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
