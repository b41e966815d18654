//! What is known of the ends of chains: it is known of their first and last pieces.

use super::{Chain, PieceTraits, PolycurveTraits};
use crate::traits::{
    ApproxTraits, BoundaryTraits, BoundedTraits, ClosedBottomTopTraits, ClosedLeftRightTraits,
    ContractedBottomTopTraits, ContractedLeftRightTraits, CurveEnd, IdentifiedBottomTopTraits,
    IdentifiedLeftRightTraits, LandmarkTraits, Location, NearBottomTopTraits, NearLeftRightTraits,
    OpenBottomTopTraits, OpenLeftRightTraits,
};
use std::cmp::Ordering;

impl<S: PieceTraits + BoundedTraits> BoundedTraits for PolycurveTraits<S> {}
impl<S: PieceTraits + ClosedLeftRightTraits> ClosedLeftRightTraits for PolycurveTraits<S> {}
impl<S: PieceTraits + ClosedBottomTopTraits> ClosedBottomTopTraits for PolycurveTraits<S> {}

impl<S: PieceTraits + BoundaryTraits> BoundaryTraits for PolycurveTraits<S> {
    #[inline]
    fn end_location(&self, curve: &Self::UMonotoneCurve, end: CurveEnd) -> Location {
        self.pieces.end_location(curve.end_piece(end), end)
    }
}

impl<S: PieceTraits + NearLeftRightTraits> NearLeftRightTraits for PolycurveTraits<S> {
    fn compare_v_near_side(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        end: CurveEnd,
    ) -> Ordering {
        self.pieces.compare_v_near_side(a.end_piece(end), b.end_piece(end), end)
    }
}

impl<S: PieceTraits + NearBottomTopTraits> NearBottomTopTraits for PolycurveTraits<S> {
    fn compare_u_near_end(&self, p: &Self::Point, curve: &Self::UMonotoneCurve, end: CurveEnd) -> Ordering {
        self.pieces.compare_u_near_end(p, curve.end_piece(end), end)
    }

    fn compare_u_of_ends(
        &self,
        (a, end_a): (&Self::UMonotoneCurve, CurveEnd),
        (b, end_b): (&Self::UMonotoneCurve, CurveEnd),
    ) -> Ordering {
        self.pieces.compare_u_of_ends((a.end_piece(end_a), end_a), (b.end_piece(end_b), end_b))
    }
}

impl<S: PieceTraits + OpenLeftRightTraits> OpenLeftRightTraits for PolycurveTraits<S> {}
impl<S: PieceTraits + OpenBottomTopTraits> OpenBottomTopTraits for PolycurveTraits<S> {}
impl<S: PieceTraits + ContractedLeftRightTraits> ContractedLeftRightTraits for PolycurveTraits<S> {}

impl<S: PieceTraits + ContractedBottomTopTraits> ContractedBottomTopTraits for PolycurveTraits<S> {
    fn contraction_bottom_top(&self, side: CurveEnd) -> Self::Point {
        self.pieces.contraction_bottom_top(side)
    }

    fn contracted_bottom_top(&self, p: &Self::Point) -> Option<CurveEnd> {
        self.pieces.contracted_bottom_top(p)
    }
}

impl<S: PieceTraits + IdentifiedLeftRightTraits> IdentifiedLeftRightTraits for PolycurveTraits<S> {
    fn is_on_left_right(&self, p: &Self::Point) -> bool {
        self.pieces.is_on_left_right(p)
    }

    fn compare_v_on_left_right(&self, p: &Self::Point, q: &Self::Point) -> Ordering {
        self.pieces.compare_v_on_left_right(p, q)
    }
}

impl<S: PieceTraits + IdentifiedBottomTopTraits> IdentifiedBottomTopTraits for PolycurveTraits<S> {
    fn is_on_bottom_top(&self, p: &Self::Point) -> bool {
        self.pieces.is_on_bottom_top(p)
    }

    fn compare_u_on_bottom_top(&self, p: &Self::Point, q: &Self::Point) -> Ordering {
        self.pieces.compare_u_on_bottom_top(p, q)
    }
}

impl<S: PieceTraits + LandmarkTraits> LandmarkTraits for PolycurveTraits<S> {
    fn approx_to_point(&self, parameters: [f64; 2]) -> Option<Self::Point> {
        self.pieces.approx_to_point(parameters)
    }
}

impl<S: PieceTraits + ApproxTraits> ApproxTraits for PolycurveTraits<S> {
    fn approx_point(&self, p: &Self::Point) -> [f64; 2] {
        self.pieces.approx_point(p)
    }

    fn approx_curve(
        &self,
        curve: &Chain<S::UMonotoneCurve>,
        min: Option<&Self::Point>,
        max: Option<&Self::Point>,
        window: [f64; 4],
        out: &mut Vec<[f64; 2]>,
    ) {
        let [min, max] = self.inner_points(curve, min, max);
        let [first, last] = self.piece_range(curve, min, max);
        let bits = |p: [f64; 2]| p.map(f64::to_bits);
        for i in first..=last {
            let (from, to) = (min.filter(|_| i == first), max.filter(|_| i == last));
            let joint = out.len();
            self.pieces.approx_curve(&curve.pieces()[i], from, to, window, out);
            // Both pieces give their joint.
            if i > first && joint > 0 && joint < out.len() && bits(out[joint - 1]) == bits(out[joint]) {
                out.remove(joint);
            }
        }
    }
}
