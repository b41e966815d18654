//! What every family of curves can do: points, u-monotone curves, and the predicates that keep an arrangement.

use super::CurveEnd;
use std::cmp::Ordering;
use std::fmt::Debug;

/// Points and u-monotone curves of a family, and the predicates on them that suffice to keep an arrangement of curves whose
/// interiors are disjoint.
///
/// Parameters of the surface are u and v; the order of points is lexicographic, by u and then by v. A curve is *u-monotone* in the
/// weak sense: vertical curves (of one u) belong to the family. Points and curves in the arguments lie in the interior of the
/// parameter space unless a method says otherwise.
///
/// An arrangement does not cut curves: an edge is a curve, its *support*, and two vertices on it. So every predicate on a
/// curve is asked of the whole support, whatever part of it is meant.
///
/// # References
/// Thesis, section 2.5, `ArrangementBasicTraits`.
pub trait BasicTraits: Send + Sync {
    /// A point of the surface.
    type Point: Clone + Debug + Send + Sync;
    /// A u-monotone curve.
    type UMonotoneCurve: Clone + Debug + Send + Sync;

    /// Two different curves have at most one point in common, or one common piece that ends where one of the curves ends.
    ///
    /// True of segments, rays and lines. It lets the sweep leave out what cannot happen; a model of which this is not so must
    /// leave it `false`.
    const MEET_ONCE: bool = false;

    /// Where curves overlap, their common piece is a piece of each, and nothing is lost if an edge there is taken for a part of any
    /// one of them.
    ///
    /// True of curves that are nothing but sets of points. If it is `false`, edges along which several curves run have the overlap
    /// of all of these as their support, which costs as much as there are curves.
    const OVERLAPS_ARE_PLAIN: bool = false;

    /// Compares two points by their u-coordinates.
    ///
    /// # References
    /// Thesis, section 2.5, "Compare x".
    fn compare_u(&self, p: &Self::Point, q: &Self::Point) -> Ordering;

    /// Compares two points lexicographically, by u and then by v.
    ///
    /// Law: a total order; `Equal` if and only if the points are equal.
    ///
    /// # References
    /// Thesis, section 2.5, "Compare xy".
    fn compare_uv(&self, p: &Self::Point, q: &Self::Point) -> Ordering;

    /// Gives a number that orders points as far as it goes; 0 if it has none.
    ///
    /// Law: if two points have keys other than 0 and these are different, they are ordered as the points are by
    /// [`BasicTraits::compare_uv`]. Sorting asks it first. A model may leave it out.
    #[inline]
    fn order_key(&self, p: &Self::Point) -> u64 {
        let _ = p;
        0
    }

    /// Gives a range of numbers in which a number for the u-coordinate lies that orders points: the least one, and how much may be added to
    /// it; `u32::MAX` if nothing is known.
    ///
    /// Law: if the ranges of two points in the interior of the parameter space, of both of which something is known, have nothing in common,
    /// they are ordered as the points are by [`BasicTraits::compare_uv`]. Searches ask it first. A model may leave it out.
    #[inline]
    fn order_range(&self, p: &Self::Point) -> (u64, u32) {
        let _ = p;
        (0, u32::MAX)
    }

    /// Gives something small by which a side of a curve may be told without looking at the curve; zeros if there is nothing.
    ///
    /// What it is, only [`BasicTraits::compare_v_at_u_by_key`] knows. A model may leave both out.
    #[inline]
    fn side_key(&self, curve: &Self::UMonotoneCurve) -> [u32; 3] {
        let _ = curve;
        [0; 3]
    }

    /// Compares the v-coordinate of `p` with that of a curve of which the [side key](BasicTraits::side_key) is given; `None` if that does not
    /// tell.
    ///
    /// Law: for a point in the interior of the parameter space, an answer is that of [`BasicTraits::compare_v_at_u`].
    #[inline]
    fn compare_v_at_u_by_key(&self, p: &Self::Point, key: &[u32; 3]) -> Option<Ordering> {
        let _ = (p, key);
        None
    }

    /// Tells whether a point has the coordinates by which these traits know it.
    ///
    /// It is asked about points that come from outside: where sides of the parameter space are identified, one point of the surface
    /// can be written in several ways, and predicates take one of them. On a torus that is the one with coordinates that are at least
    /// zero and below the periods. A model of which every point is written in one way leaves it out: the provided version says yes.
    ///
    /// Law: the end points of curves, and the points that [`UMonotoneTraits::intersect`](super::UMonotoneTraits::intersect) gives, are.
    #[inline]
    fn is_canonical(&self, p: &Self::Point) -> bool {
        let _ = p;
        true
    }

    /// Tells whether a curve is one of these traits, if traits of one type with other parameters make curves of the same type: those of
    /// another torus, with other periods, or of a sphere with another identification. The provided version says yes.
    ///
    /// Law: what [`UMonotoneTraits`](super::UMonotoneTraits) makes of such curves is.
    #[inline]
    fn is_own_curve(&self, curve: &Self::UMonotoneCurve) -> bool {
        let _ = curve;
        true
    }

    /// Gives an end of a curve; `None` if that end is on an open side, where there is no point.
    ///
    /// Law: the point of `Min` is less than that of `Max`, unless one of them lies on an identified or contracted side.
    ///
    /// # References
    /// Thesis, section 2.5, "Construct min" and "Construct max".
    fn end_point<'a>(&self, curve: &'a Self::UMonotoneCurve, end: CurveEnd) -> Option<&'a Self::Point>;

    /// Tells whether all points of a curve have one u-coordinate.
    fn is_vertical(&self, curve: &Self::UMonotoneCurve) -> bool;

    /// Compares the v-coordinate of `p` with that of `curve` above or below it.
    ///
    /// `Less` means that `p` lies below the curve, `Greater` above, `Equal` on it.
    ///
    /// Laws:
    /// 1. An end point of `curve` gives `Equal`.
    /// 2. Splitting `curve` at an interior point changes no answer.
    ///
    /// Degenerate: on a vertical curve, `Equal` means that `p` lies between the ends, ends included.
    ///
    /// # Panics
    /// Perhaps in debug builds, if `p` is outside the u-range of `curve`.
    ///
    /// # References
    /// Thesis, section 2.5, "Compare y at x".
    fn compare_v_at_u(&self, p: &Self::Point, curve: &Self::UMonotoneCurve) -> Ordering;

    /// Compares two curves immediately to the right of a point `p` of both.
    ///
    /// Neither curve ends at `p` with its `Max` end. `Less` means that `a` is below `b`; `Equal` that they have a piece to the
    /// right of `p` in common. A vertical curve is above all others.
    ///
    /// # References
    /// Thesis, section 2.5, "Compare y at x right".
    fn compare_v_at_u_right(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        p: &Self::Point,
    ) -> Ordering;

    /// Compares two curves immediately to the left of a point `p` of both.
    ///
    /// Neither curve begins at `p`. `Less` means that `a` is below `b`; `Equal` that they have a piece to the left of `p` in
    /// common. A vertical curve is below all others.
    ///
    /// A model may leave this out, if no two of its curves are unbounded to the left and none ends on an identified or contracted
    /// side: the sweep does not ask it, but checks of validity, comparisons, local edits and the user's own algorithms do. The
    /// provided version is for curves that do not meet to the left of `p` but at their ends, as edges of an arrangement do not, and
    /// compares at the greater of their `Min` ends.
    ///
    /// # References
    /// Thesis, section 2.5, "Compare y at x left", and 2.5.1.
    fn compare_v_at_u_left(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        p: &Self::Point,
    ) -> Ordering {
        match (self.is_vertical(a), self.is_vertical(b)) {
            (true, true) => return Ordering::Equal,
            (true, false) => return Ordering::Less,
            (false, true) => return Ordering::Greater,
            (false, false) => {}
        }
        let _ = p;
        match (self.end_point(a, CurveEnd::Min), self.end_point(b, CurveEnd::Min)) {
            (Some(start_a), Some(start_b)) => match self.compare_uv(start_a, start_b) {
                Ordering::Less => self.compare_v_at_u(start_b, a).reverse(),
                Ordering::Greater => self.compare_v_at_u(start_a, b),
                Ordering::Equal => self.compare_v_at_u_right(a, b, start_a),
            },
            (Some(start_a), None) => self.compare_v_at_u(start_a, b),
            (None, Some(start_b)) => self.compare_v_at_u(start_b, a).reverse(),
            (None, None) => Ordering::Equal,
        }
    }

    /// Tells whether two points are equal.
    #[inline]
    fn is_same_point(&self, p: &Self::Point, q: &Self::Point) -> bool {
        self.compare_uv(p, q) == Ordering::Equal
    }

    /// Tells whether the u-coordinate of `p` lies between those of the ends of a curve, ends included.
    ///
    /// A model with vertical curves that have no end has to override this: the provided version says yes for them.
    ///
    /// # References
    /// Thesis, section 2.5.1.
    fn is_in_u_range(&self, p: &Self::Point, curve: &Self::UMonotoneCurve) -> bool {
        if self.is_vertical(curve) {
            let end = self.end_point(curve, CurveEnd::Min).or_else(|| self.end_point(curve, CurveEnd::Max));
            return end.is_none_or(|end| self.compare_u(end, p).is_eq());
        }
        let from = self.end_point(curve, CurveEnd::Min).is_none_or(|min| self.compare_u(min, p).is_le());
        from && self.end_point(curve, CurveEnd::Max).is_none_or(|max| self.compare_u(p, max).is_le())
    }

    /// Tells whether a point lies on a curve.
    fn is_on_curve(&self, p: &Self::Point, curve: &Self::UMonotoneCurve) -> bool {
        self.is_in_u_range(p, curve) && self.compare_v_at_u(p, curve) == Ordering::Equal
    }
}
