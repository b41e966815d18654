//! Predicates on chains: each is asked of the piece at the point.

use super::{Chain, PieceTraits, PolycurveTraits};
use crate::traits::{BasicTraits, CurveEnd, DirectionalTraits};
use std::cmp::Ordering;

impl<S: PieceTraits> BasicTraits for PolycurveTraits<S> {
    type Point = S::Point;
    type UMonotoneCurve = Chain<S::UMonotoneCurve>;

    const OVERLAPS_ARE_PLAIN: bool = S::OVERLAPS_ARE_PLAIN;

    #[inline]
    fn order_key(&self, p: &Self::Point) -> u64 {
        self.pieces.order_key(p)
    }

    #[inline]
    fn order_range(&self, p: &Self::Point) -> (u64, u32) {
        self.pieces.order_range(p)
    }

    #[inline]
    fn is_canonical(&self, p: &Self::Point) -> bool {
        self.pieces.is_canonical(p)
    }

    /// Each piece is.
    fn is_own_curve(&self, curve: &Self::UMonotoneCurve) -> bool {
        curve.pieces().iter().all(|piece| self.pieces.is_own_curve(piece))
    }

    #[inline]
    fn compare_u(&self, p: &Self::Point, q: &Self::Point) -> Ordering {
        self.pieces.compare_u(p, q)
    }

    #[inline]
    fn compare_uv(&self, p: &Self::Point, q: &Self::Point) -> Ordering {
        self.pieces.compare_uv(p, q)
    }

    #[inline]
    fn end_point<'a>(&self, curve: &'a Self::UMonotoneCurve, end: CurveEnd) -> Option<&'a Self::Point> {
        self.pieces.end_point(curve.end_piece(end), end)
    }

    #[inline]
    fn is_vertical(&self, curve: &Self::UMonotoneCurve) -> bool {
        self.pieces.is_vertical(curve.end_piece(CurveEnd::Min))
    }

    #[inline]
    fn compare_v_at_u(&self, p: &Self::Point, curve: &Self::UMonotoneCurve) -> Ordering {
        let piece = self.piece_at_u(curve, p);
        self.pieces.compare_v_at_u(p, &curve.pieces()[piece])
    }

    #[inline]
    fn compare_v_at_u_right(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        p: &Self::Point,
    ) -> Ordering {
        let [i, j] = [a, b].map(|chain| self.piece_after(chain, p));
        self.pieces.compare_v_at_u_right(&a.pieces()[i], &b.pieces()[j], p)
    }

    #[inline]
    fn compare_v_at_u_left(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        p: &Self::Point,
    ) -> Ordering {
        let [i, j] = [a, b].map(|chain| self.piece_before(chain, p));
        self.pieces.compare_v_at_u_left(&a.pieces()[i], &b.pieces()[j], p)
    }

    #[inline]
    fn is_same_point(&self, p: &Self::Point, q: &Self::Point) -> bool {
        self.pieces.is_same_point(p, q)
    }

    fn is_in_u_range(&self, p: &Self::Point, curve: &Self::UMonotoneCurve) -> bool {
        let piece = self.piece_at_u(curve, p);
        self.pieces.is_in_u_range(p, &curve.pieces()[piece])
    }

    fn is_on_curve(&self, p: &Self::Point, curve: &Self::UMonotoneCurve) -> bool {
        if !self.pieces.is_joint_allowed(p) {
            return CurveEnd::BOTH.into_iter().any(|end| self.pieces.is_on_curve(p, curve.end_piece(end)));
        }
        let piece = self.piece_after(curve, p);
        self.pieces.is_on_curve(p, &curve.pieces()[piece])
    }
}

impl<S: PieceTraits> DirectionalTraits for PolycurveTraits<S> {
    #[inline]
    fn is_directed_right(&self, curve: &Self::UMonotoneCurve) -> bool {
        curve.is_directed_right()
    }

    fn opposite(&self, curve: &Self::UMonotoneCurve) -> Self::UMonotoneCurve {
        curve.reversed()
    }
}
