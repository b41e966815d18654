//! A u-monotone chain, and the piece of it that a question is about.

use super::{PieceTraits, PolycurveTraits};
use crate::traits::CurveEnd;
use std::sync::Arc;

/// A u-monotone chain of u-monotone pieces.
///
/// Laws:
/// 1. There is a piece.
/// 2. Each piece begins, with its `Min` end, where the one before it ends, with its `Max` end.
/// 3. Either all pieces are vertical, or none is.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Chain<C> {
    pieces: Arc<[C]>,
    is_directed_right: bool,
}

impl<C> Chain<C> {
    pub(super) fn new(pieces: impl Into<Arc<[C]>>, is_directed_right: bool) -> Self {
        let pieces = pieces.into();
        debug_assert!(!pieces.is_empty());
        Self { pieces, is_directed_right }
    }

    /// The pieces, in lexicographic order.
    #[inline]
    pub fn pieces(&self) -> &[C] {
        &self.pieces
    }

    /// Tells whether the chain runs from its `Min` to its `Max` end.
    #[inline]
    pub fn is_directed_right(&self) -> bool {
        self.is_directed_right
    }

    /// The number of the last piece.
    #[inline]
    pub(super) fn last(&self) -> usize {
        self.pieces.len() - 1
    }

    /// The piece with an end of the chain.
    #[inline]
    pub(super) fn end_piece(&self, end: CurveEnd) -> &C {
        match end {
            CurveEnd::Min => &self.pieces[0],
            CurveEnd::Max => &self.pieces[self.last()],
        }
    }
}

impl<C: Clone> Chain<C> {
    /// The same chain in the other direction.
    pub(super) fn reversed(&self) -> Self {
        Self { pieces: self.pieces.clone(), is_directed_right: !self.is_directed_right }
    }
}

impl<S: PieceTraits> PolycurveTraits<S> {
    /// The joint after a piece; `None` after the last one.
    #[inline]
    pub(super) fn joint_after<'a>(
        &self,
        chain: &'a Chain<S::UMonotoneCurve>,
        piece: usize,
    ) -> Option<&'a S::Point> {
        // A joint is the `Min` end of what follows; the last piece may be unbounded, or end on a side.
        let next = chain.pieces.get(piece + 1)?;
        self.pieces.end_point(next, CurveEnd::Min)
    }

    /// The piece of a chain at `p`; at a joint, the one after it. The first or last one if `p` is before or after the chain.
    ///
    /// A point on a side is taken as the `Min` end: chains come to sides only with their ends.
    #[inline]
    pub(super) fn piece_after(&self, chain: &Chain<S::UMonotoneCurve>, p: &S::Point) -> usize {
        if !self.pieces.is_joint_allowed(p) {
            return 0;
        }
        self.find(chain, |joint| self.pieces.compare_uv(joint, p).is_le())
    }

    /// The piece of a chain at `p`; at a joint, the one before it. A point on a side is taken as the `Max` end.
    #[inline]
    pub(super) fn piece_before(&self, chain: &Chain<S::UMonotoneCurve>, p: &S::Point) -> usize {
        if !self.pieces.is_joint_allowed(p) {
            return chain.last();
        }
        self.find(chain, |joint| self.pieces.compare_uv(joint, p).is_lt())
    }

    /// A piece of a chain above or below `p`, wherever `p` is.
    #[inline]
    pub(super) fn piece_at_u(&self, chain: &Chain<S::UMonotoneCurve>, p: &S::Point) -> usize {
        let piece = self.find(chain, |joint| self.pieces.compare_uv(joint, p).is_le());
        // A point on an identified left side is one on the right side, too.
        let is_found = self.pieces.is_joint_allowed(p) || self.pieces.is_in_u_range(p, &chain.pieces[piece]);
        if is_found { piece } else { chain.last() }
    }

    /// The number of joints that are passed, all of which come before those that are not.
    #[inline]
    pub(super) fn find(
        &self,
        chain: &Chain<S::UMonotoneCurve>,
        is_passed: impl Fn(&S::Point) -> bool,
    ) -> usize {
        let (mut low, mut high) = (0, chain.last());
        while low < high {
            let middle = low + (high - low) / 2;
            if self.joint_after(chain, middle).is_some_and(&is_passed) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low
    }

    /// The numbers of the first and the last piece of the part of a chain between two of its points.
    pub(super) fn piece_range(
        &self,
        chain: &Chain<S::UMonotoneCurve>,
        min: Option<&S::Point>,
        max: Option<&S::Point>,
    ) -> [usize; 2] {
        [
            min.map_or(0, |p| self.piece_after(chain, p)),
            max.map_or(chain.last(), |p| self.piece_before(chain, p)),
        ]
    }

    /// Leaves out those of two points of a chain that are its ends already: they may lie on sides, where nothing can be looked for.
    pub(super) fn inner_points<'p>(
        &self,
        chain: &Chain<S::UMonotoneCurve>,
        min: Option<&'p S::Point>,
        max: Option<&'p S::Point>,
    ) -> [Option<&'p S::Point>; 2] {
        let is_inner = |end, p: &S::Point| {
            !self
                .pieces
                .end_point(chain.end_piece(end), end)
                .is_some_and(|point| self.pieces.is_same_point(point, p))
        };
        [min.filter(|p| is_inner(CurveEnd::Min, p)), max.filter(|p| is_inner(CurveEnd::Max, p))]
    }
}
