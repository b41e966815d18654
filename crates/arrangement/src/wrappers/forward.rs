//! The forwarding macro of the wrappers.

/// Implements, for a wrapper with a field `traits`, the traits whose methods make no curve: all but `UMonotoneTraits`,
/// `ArrangementTraits`, `DirectionalTraits` and `ConnectTraits`.
///
/// `$via` is a macro that makes a call: `via!(self, Method, method(kind argument, ...))` or, for a method that appends its answer
/// to a buffer, `via!(self, Method, method(kind argument, ...) appends out)`. The kind is `curve` for a curve of the wrapper, `end`
/// for a pair of such a curve and an end, and `plain` for the rest. `$plain` is the value of `OVERLAPS_ARE_PLAIN`.
macro_rules! forward_traits {
    ([$($param:tt)*] $wrapper:ty, $curve:ty, $via:ident, $plain:expr) => {
        impl<G: BasicTraits, $($param)*> BasicTraits for $wrapper {
            type Point = G::Point;
            type UMonotoneCurve = $curve;

            const MEET_ONCE: bool = G::MEET_ONCE;
            const OVERLAPS_ARE_PLAIN: bool = $plain;

            #[inline]
            fn compare_u(&self, p: &Self::Point, q: &Self::Point) -> Ordering {
                $via!(self, CompareU, compare_u(plain p, plain q))
            }

            #[inline]
            fn compare_uv(&self, p: &Self::Point, q: &Self::Point) -> Ordering {
                $via!(self, CompareUv, compare_uv(plain p, plain q))
            }

            #[inline]
            fn order_key(&self, p: &Self::Point) -> u64 {
                $via!(self, OrderKey, order_key(plain p))
            }

            #[inline]
            fn order_range(&self, p: &Self::Point) -> (u64, u32) {
                $via!(self, OrderRange, order_range(plain p))
            }

            #[inline]
            fn side_key(&self, curve: &Self::UMonotoneCurve) -> [u32; 3] {
                $via!(self, SideKey, side_key(curve curve))
            }

            #[inline]
            fn compare_v_at_u_by_key(&self, p: &Self::Point, key: &[u32; 3]) -> Option<Ordering> {
                $via!(self, CompareVAtUByKey, compare_v_at_u_by_key(plain p, plain key))
            }

            #[inline]
            fn is_canonical(&self, p: &Self::Point) -> bool {
                $via!(self, IsCanonical, is_canonical(plain p))
            }

            #[inline]
            fn is_own_curve(&self, curve: &Self::UMonotoneCurve) -> bool {
                $via!(self, IsOwnCurve, is_own_curve(curve curve))
            }

            #[inline]
            fn end_point<'a>(&self, curve: &'a Self::UMonotoneCurve, end: CurveEnd) -> Option<&'a Self::Point> {
                $via!(self, EndPoint, end_point(curve curve, plain end))
            }

            #[inline]
            fn is_vertical(&self, curve: &Self::UMonotoneCurve) -> bool {
                $via!(self, IsVertical, is_vertical(curve curve))
            }

            #[inline]
            fn compare_v_at_u(&self, p: &Self::Point, curve: &Self::UMonotoneCurve) -> Ordering {
                $via!(self, CompareVAtU, compare_v_at_u(plain p, curve curve))
            }

            #[inline]
            fn compare_v_at_u_right(
                &self,
                a: &Self::UMonotoneCurve,
                b: &Self::UMonotoneCurve,
                p: &Self::Point,
            ) -> Ordering {
                $via!(self, CompareVAtURight, compare_v_at_u_right(curve a, curve b, plain p))
            }

            #[inline]
            fn compare_v_at_u_left(
                &self,
                a: &Self::UMonotoneCurve,
                b: &Self::UMonotoneCurve,
                p: &Self::Point,
            ) -> Ordering {
                $via!(self, CompareVAtULeft, compare_v_at_u_left(curve a, curve b, plain p))
            }

            #[inline]
            fn is_same_point(&self, p: &Self::Point, q: &Self::Point) -> bool {
                $via!(self, IsSamePoint, is_same_point(plain p, plain q))
            }

            #[inline]
            fn is_in_u_range(&self, p: &Self::Point, curve: &Self::UMonotoneCurve) -> bool {
                $via!(self, IsInURange, is_in_u_range(plain p, curve curve))
            }

            #[inline]
            fn is_on_curve(&self, p: &Self::Point, curve: &Self::UMonotoneCurve) -> bool {
                $via!(self, IsOnCurve, is_on_curve(plain p, curve curve))
            }
        }

        impl<G: ApproxTraits, $($param)*> ApproxTraits for $wrapper {
            fn approx_point(&self, p: &Self::Point) -> [f64; 2] {
                $via!(self, ApproxPoint, approx_point(plain p))
            }

            fn approx_curve(
                &self,
                curve: &Self::UMonotoneCurve,
                min: Option<&Self::Point>,
                max: Option<&Self::Point>,
                window: [f64; 4],
                out: &mut Vec<[f64; 2]>,
            ) {
                $via!(self, ApproxCurve, approx_curve(curve curve, plain min, plain max, plain window) appends out)
            }
        }

        impl<G: LandmarkTraits, $($param)*> LandmarkTraits for $wrapper {
            fn approx_to_point(&self, parameters: [f64; 2]) -> Option<Self::Point> {
                $via!(self, ApproxToPoint, approx_to_point(plain parameters))
            }
        }

        impl<G: BoundaryTraits, $($param)*> BoundaryTraits for $wrapper {
            #[inline]
            fn end_location(&self, curve: &Self::UMonotoneCurve, end: CurveEnd) -> Location {
                $via!(self, EndLocation, end_location(curve curve, plain end))
            }
        }

        impl<G: NearLeftRightTraits, $($param)*> NearLeftRightTraits for $wrapper {
            fn compare_v_near_side(
                &self,
                a: &Self::UMonotoneCurve,
                b: &Self::UMonotoneCurve,
                end: CurveEnd,
            ) -> Ordering {
                $via!(self, CompareVNearSide, compare_v_near_side(curve a, curve b, plain end))
            }
        }

        impl<G: NearBottomTopTraits, $($param)*> NearBottomTopTraits for $wrapper {
            fn compare_u_near_end(
                &self,
                p: &Self::Point,
                curve: &Self::UMonotoneCurve,
                end: CurveEnd,
            ) -> Ordering {
                $via!(self, CompareUNearEnd, compare_u_near_end(plain p, curve curve, plain end))
            }

            fn compare_u_of_ends(
                &self,
                a: (&Self::UMonotoneCurve, CurveEnd),
                b: (&Self::UMonotoneCurve, CurveEnd),
            ) -> Ordering {
                $via!(self, CompareUOfEnds, compare_u_of_ends(end a, end b))
            }
        }

        impl<G: IdentifiedLeftRightTraits, $($param)*> IdentifiedLeftRightTraits for $wrapper {
            fn is_on_left_right(&self, p: &Self::Point) -> bool {
                $via!(self, IsOnLeftRight, is_on_left_right(plain p))
            }

            fn compare_v_on_left_right(&self, p: &Self::Point, q: &Self::Point) -> Ordering {
                $via!(self, CompareVOnLeftRight, compare_v_on_left_right(plain p, plain q))
            }
        }

        impl<G: IdentifiedBottomTopTraits, $($param)*> IdentifiedBottomTopTraits for $wrapper {
            fn is_on_bottom_top(&self, p: &Self::Point) -> bool {
                $via!(self, IsOnBottomTop, is_on_bottom_top(plain p))
            }

            fn compare_u_on_bottom_top(&self, p: &Self::Point, q: &Self::Point) -> Ordering {
                $via!(self, CompareUOnBottomTop, compare_u_on_bottom_top(plain p, plain q))
            }
        }

        impl<G: PieceTraits, $($param)*> PieceTraits for $wrapper {
            fn is_joint_allowed(&self, p: &Self::Point) -> bool {
                $via!(self, IsJointAllowed, is_joint_allowed(plain p))
            }

            fn is_foldback_on_side(
                &self,
                a: &Self::UMonotoneCurve,
                b: &Self::UMonotoneCurve,
                end: CurveEnd,
            ) -> bool {
                $via!(self, IsFoldbackOnSide, is_foldback_on_side(curve a, curve b, plain end))
            }

            fn compare_u_to_end(
                &self,
                p: &Self::Point,
                curve: &Self::UMonotoneCurve,
                end: CurveEnd,
            ) -> Option<Ordering> {
                $via!(self, CompareUToEnd, compare_u_to_end(plain p, curve curve, plain end))
            }

            fn direction(&self, curve: &Self::UMonotoneCurve) -> Option<bool> {
                $via!(self, Direction, direction(curve curve))
            }
        }

        impl<G: BoundedTraits, $($param)*> BoundedTraits for $wrapper {}
        impl<G: ClosedLeftRightTraits, $($param)*> ClosedLeftRightTraits for $wrapper {}
        impl<G: ClosedBottomTopTraits, $($param)*> ClosedBottomTopTraits for $wrapper {}
        impl<G: OpenLeftRightTraits, $($param)*> OpenLeftRightTraits for $wrapper {}
        impl<G: OpenBottomTopTraits, $($param)*> OpenBottomTopTraits for $wrapper {}
        impl<G: ContractedLeftRightTraits, $($param)*> ContractedLeftRightTraits for $wrapper {}

        impl<G: ContractedBottomTopTraits, $($param)*> ContractedBottomTopTraits for $wrapper {
            fn contraction_bottom_top(&self, side: CurveEnd) -> Self::Point {
                $via!(self, ContractionBottomTop, contraction_bottom_top(plain side))
            }

            fn contracted_bottom_top(&self, p: &Self::Point) -> Option<CurveEnd> {
                $via!(self, ContractedBottomTop, contracted_bottom_top(plain p))
            }
        }
    };
}

pub(super) use forward_traits;
