//! Curves that reach the sides of the parameter space: one refinement for each kind of side and axis.

use super::{BasicTraits, CurveEnd, Location};
use std::cmp::Ordering;

/// Curves that have two end points in the interior of the parameter space, as all surfaces can carry that ask for nothing more.
pub trait BoundedTraits: BasicTraits {}

/// Curves whose ends may lie on sides of the parameter space.
///
/// # References
/// Thesis, section 2.5, `HasBoundaryTraits`.
pub trait BoundaryTraits: BasicTraits {
    /// Tells where an end of a curve lies.
    ///
    /// Law: an end in the interior has a point; one on an open side has none.
    fn end_location(&self, curve: &Self::UMonotoneCurve, end: CurveEnd) -> Location;
}

/// Curves that are compared near the left or right side.
pub trait NearLeftRightTraits: BoundaryTraits {
    /// Compares the v-coordinates of two curves near their ends on one side, left (`Min`) or right (`Max`).
    ///
    /// `Equal` means that they have a piece next to the side in common.
    ///
    /// # References
    /// Thesis, section 2.5, "Compare y near boundary".
    fn compare_v_near_side(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        end: CurveEnd,
    ) -> Ordering;
}

/// Curves that are compared near the bottom or top side.
pub trait NearBottomTopTraits: BoundaryTraits {
    /// Compares the u-coordinate of a point in the interior with that of a curve near an end on the bottom or top side.
    ///
    /// # References
    /// Thesis, section 2.5, "Compare x near boundary", 1.
    fn compare_u_near_end(&self, p: &Self::Point, curve: &Self::UMonotoneCurve, end: CurveEnd) -> Ordering;

    /// Compares the u-coordinates of two curves near ends on the bottom or top side.
    ///
    /// # References
    /// Thesis, section 2.5, "Compare x near boundary", 2.
    fn compare_u_of_ends(
        &self,
        a: (&Self::UMonotoneCurve, CurveEnd),
        b: (&Self::UMonotoneCurve, CurveEnd),
    ) -> Ordering;
}

/// Curves that may reach a closed left or right side: one whose points are points of the surface like all others.
///
/// Laws:
/// 1. What lies on the side has coordinates, and every predicate answers for it as for what is in the interior. So the side comes first,
///    or last, in the order of points.
/// 2. A curve along the side is a vertical curve like others, and a curve that ends on the side has a point there.
///
/// A topology has nothing to ask about a closed side, and must not tell a sweep of it: where it says what is located where, it says
/// [`Inside`](crate::traits::Along::Inside) along this axis. Beyond the side there is one face more, into which no curve runs, as if the
/// rim were filled with a disc. It is the face next to the side, unless curves run along all of it.
///
/// # References
/// Thesis, section 2.5, closed boundaries.
pub trait ClosedLeftRightTraits: BasicTraits {}

/// Curves that may reach a closed bottom or top side: one whose points are points of the surface like all others.
///
/// What [`ClosedLeftRightTraits`] says of the left and right side holds here along the other axis; a curve along the side is not
/// vertical.
pub trait ClosedBottomTopTraits: BasicTraits {}

/// Curves that may be unbounded to the left or right.
pub trait OpenLeftRightTraits: NearLeftRightTraits {}

/// Curves that may be unbounded downwards or upwards.
pub trait OpenBottomTopTraits: NearBottomTopTraits {}

/// Curves that may end in a point to which the left or right side is contracted.
pub trait ContractedLeftRightTraits: NearLeftRightTraits {}

/// Curves that may end in a point to which the bottom or top side is contracted, as a pole of a sphere is.
pub trait ContractedBottomTopTraits: NearBottomTopTraits {
    /// Gives the point to which a side is contracted: the bottom for `Min`, the top for `Max`.
    ///
    /// Law: ends of curves on that side have this point, if they have one.
    fn contraction_bottom_top(&self, side: CurveEnd) -> Self::Point;

    /// Tells to which side, of these two, a point is the contraction. A model whose points tell it at once should.
    fn contracted_bottom_top(&self, p: &Self::Point) -> Option<CurveEnd> {
        CurveEnd::BOTH.into_iter().find(|&side| self.is_same_point(p, &self.contraction_bottom_top(side)))
    }
}

/// Curves on a surface whose left side is glued to the right one.
///
/// A curve along the identification belongs to the left side. The point of an end on either side is one and the same.
pub trait IdentifiedLeftRightTraits: BoundaryTraits {
    /// Tells whether a point lies on the identification.
    fn is_on_left_right(&self, p: &Self::Point) -> bool;

    /// Compares the v-coordinates of two points on the identification.
    ///
    /// # References
    /// Thesis, section 2.5, "Compare y on identification".
    fn compare_v_on_left_right(&self, p: &Self::Point, q: &Self::Point) -> Ordering;
}

/// Curves on a surface whose bottom side is glued to the top one.
///
/// A curve along the identification belongs to the bottom side. The point of an end on either side is one and the same.
pub trait IdentifiedBottomTopTraits: BoundaryTraits {
    /// Tells whether a point lies on the identification.
    fn is_on_bottom_top(&self, p: &Self::Point) -> bool;

    /// Compares the u-coordinates of two points, each of them on the identification or in the interior.
    ///
    /// # References
    /// Thesis, section 2.5, "Compare x on identification".
    fn compare_u_on_bottom_top(&self, p: &Self::Point, q: &Self::Point) -> Ordering;
}
