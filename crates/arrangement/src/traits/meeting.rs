//! Curves that meet: intersections, splitting and merging.

use super::{BasicTraits, CurveEnd};
use std::cmp::Ordering;

/// What two u-monotone curves have in common at one place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Intersection<P, C> {
    /// A point.
    Point(P, Multiplicity),
    /// A common piece.
    Overlap(C),
}

/// How two curves meet at a common point.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Multiplicity {
    /// They change sides.
    Odd,
    /// They touch, and keep their sides.
    Even,
    /// Not known, or one of them ends there: the order to the right has to be asked.
    Unknown,
}

/// What [`UMonotoneTraits::next_meeting`] found.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Meeting<P> {
    /// They do not meet there.
    Never,
    /// They meet first at a point before the end of the window.
    At(P, Multiplicity),
    /// They meet first at the end of the window.
    AtEnd,
}

/// The part of the parameter space in which a sweep looks for the next common point of two curves.
#[derive(Debug)]
pub struct Window<'a, P> {
    /// Only points greater than this one; `None` begins at the left side.
    pub after: Option<&'a P>,
    /// Only points up to this one, at which `first_to_end` ends; `None` if neither curve ends in the interior.
    pub until: Option<&'a P>,
    /// Which of the two curves ends at `until`: 0 the lower, 1 the upper one.
    pub first_to_end: usize,
}

impl<P> Clone for Window<'_, P> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<P> Copy for Window<'_, P> {}

/// Curves whose interiors may meet.
///
/// # References
/// Thesis, section 2.5, `ArrangementXMonotoneTraits`.
pub trait UMonotoneTraits: BasicTraits {
    /// Appends all that two curves have in common, in lexicographic order.
    ///
    /// Common end points count, and points where one curve ends on the other; but a point to which a side is contracted may be left out. An
    /// overlap is appended once, as a curve; its ends are not appended.
    ///
    /// # References
    /// Thesis, section 2.5, "Intersection".
    fn intersect(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        out: &mut Vec<Intersection<Self::Point, Self::UMonotoneCurve>>,
    );

    /// Cuts a curve at a point of its interior, and gives the smaller part first.
    ///
    /// # References
    /// Thesis, section 2.5, "Split".
    fn split(&self, curve: &Self::UMonotoneCurve, p: &Self::Point) -> [Self::UMonotoneCurve; 2];

    /// Joins two curves into one, if together they are one curve of the family; `None` if not.
    ///
    /// The curves share an end. A model may leave this out: then nothing can be merged, and vertices between two curves stay.
    ///
    /// # References
    /// Thesis, section 2.5, "Merge" and "Is mergeable", and 2.5.1.
    fn merge(&self, a: &Self::UMonotoneCurve, b: &Self::UMonotoneCurve) -> Option<Self::UMonotoneCurve> {
        let _ = (a, b);
        None
    }

    /// Tells whether [`UMonotoneTraits::merge`] can join two curves.
    fn is_mergeable(&self, a: &Self::UMonotoneCurve, b: &Self::UMonotoneCurve) -> bool {
        self.merge(a, b).is_some()
    }

    /// Finds the next common point of two curves that a sweep has just found to be neighbours.
    ///
    /// `below` is below `above` immediately to the right of `window.after`, and they have no piece in common there. The point
    /// where a later overlap begins counts as a common point. A common point on a side of the parameter space counts only if one of
    /// the curves runs along that side: then it is `AtEnd`, and the other one ends there.
    ///
    /// The provided version asks [`UMonotoneTraits::intersect`] and looks for the first point in the window. A model that can
    /// tell without finding all intersections should.
    fn next_meeting(
        &self,
        below: &Self::UMonotoneCurve,
        above: &Self::UMonotoneCurve,
        window: Window<'_, Self::Point>,
    ) -> Meeting<Self::Point> {
        let mut common = Vec::new();
        self.intersect(below, above, &mut common);
        for intersection in common {
            let (point, multiplicity) = match intersection {
                Intersection::Point(point, multiplicity) => (point, multiplicity),
                Intersection::Overlap(curve) => match self.end_point(&curve, CurveEnd::Min) {
                    Some(point) => (point.clone(), Multiplicity::Unknown),
                    None => continue,
                },
            };
            if window.after.is_some_and(|after| self.compare_uv(&point, after).is_le()) {
                continue;
            }
            return match window.until.map_or(Ordering::Less, |until| self.compare_uv(&point, until)) {
                Ordering::Less => Meeting::At(point, multiplicity),
                Ordering::Equal => Meeting::AtEnd,
                Ordering::Greater => Meeting::Never,
            };
        }
        Meeting::Never
    }

    /// Finds where two curves that run together to the right of a point `p` of both cease to: the greater end of their common piece
    /// there. `None`, or a point on the side, if that end is on a side of the parameter space, where both curves end.
    ///
    /// Without `p`, the common piece begins on an open or contracted side.
    ///
    /// Law: the point is greater than `p`.
    ///
    /// The sweep asks it if curves may part before one of them ends, that is, if they do not [meet once](BasicTraits::MEET_ONCE).
    /// The provided version asks [`UMonotoneTraits::intersect`] and looks for the first common piece that ends beyond `p`.
    fn end_of_overlap(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        p: Option<&Self::Point>,
    ) -> Option<Self::Point> {
        let mut common = Vec::new();
        self.intersect(a, b, &mut common);
        let is_beyond = |end: &Self::Point| p.is_none_or(|p| self.compare_uv(p, end).is_lt());
        common.into_iter().find_map(|intersection| match intersection {
            Intersection::Overlap(piece) => {
                self.end_point(&piece, CurveEnd::Max).filter(|end| is_beyond(end)).cloned()
            }
            Intersection::Point(..) => None,
        })
    }

    /// Cuts from a curve the part between two of its points; `None` keeps that end.
    ///
    /// Degenerate: a point that is the end already cuts nothing.
    fn trim(
        &self,
        curve: &Self::UMonotoneCurve,
        min: Option<&Self::Point>,
        max: Option<&Self::Point>,
    ) -> Self::UMonotoneCurve {
        let is_end = |end, p: &Self::Point| {
            self.end_point(curve, end).is_some_and(|point| self.is_same_point(point, p))
        };
        let mut part = curve.clone();
        if let Some(p) = min.filter(|p| !is_end(CurveEnd::Min, p)) {
            let [_, greater] = self.split(&part, p);
            part = greater;
        }
        if let Some(p) = max.filter(|p| !is_end(CurveEnd::Max, p)) {
            let [smaller, _] = self.split(&part, p);
            part = smaller;
        }
        part
    }
}

/// One piece of a general curve.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Piece<P, C> {
    /// A u-monotone piece.
    Curve {
        /// The piece.
        curve: C,
        /// For each end, whether it is there only because the curve had to be cut: at a u-extremal point, at an
        /// identification or at a contraction.
        is_artificial: [bool; 2],
    },
    /// A point of its own.
    Point(P),
}

/// General curves, which can be cut into u-monotone ones.
///
/// # References
/// Thesis, section 2.5, `ArrangementTraits`.
pub trait ArrangementTraits: UMonotoneTraits {
    /// A curve as a user gives it.
    type Curve: Clone + Send + Sync;

    /// Appends the u-monotone pieces of a curve, in the order along it, and its isolated points.
    ///
    /// Laws: the pieces have disjoint interiors, or their overlaps are those of the curve with itself; together they are the curve.
    fn make_u_monotone(&self, curve: &Self::Curve, out: &mut Vec<Piece<Self::Point, Self::UMonotoneCurve>>);
}

/// Curves that run from a source to a target.
///
/// # References
/// Thesis, section 2.7.1, `ArrangementDirectionalXMonotoneTraits`.
pub trait DirectionalTraits: BasicTraits {
    /// Tells whether a curve runs from its `Min` to its `Max` end.
    fn is_directed_right(&self, curve: &Self::UMonotoneCurve) -> bool;

    /// Turns a curve round: source and target change places.
    fn opposite(&self, curve: &Self::UMonotoneCurve) -> Self::UMonotoneCurve;

    /// Gives the source of a curve; `None` on an open side.
    fn source<'a>(&self, curve: &'a Self::UMonotoneCurve) -> Option<&'a Self::Point> {
        let end = if self.is_directed_right(curve) { CurveEnd::Min } else { CurveEnd::Max };
        self.end_point(curve, end)
    }

    /// Gives the target of a curve; `None` on an open side.
    fn target<'a>(&self, curve: &'a Self::UMonotoneCurve) -> Option<&'a Self::Point> {
        let end = if self.is_directed_right(curve) { CurveEnd::Max } else { CurveEnd::Min };
        self.end_point(curve, end)
    }
}

/// Points and curves of which floats can be made: for pictures, and to choose what to look at first. Nothing is decided by them.
pub trait ApproxTraits: BasicTraits {
    /// Gives parameters u and v near to those of a point.
    fn approx_point(&self, p: &Self::Point) -> [f64; 2];

    /// Appends points along the part of a curve between two of its points, from the smaller to the greater end; `None` keeps that
    /// end. A part that is unbounded is cut off where it leaves `window`, given as least u, least v, greatest u, greatest v.
    fn approx_curve(
        &self,
        curve: &Self::UMonotoneCurve,
        min: Option<&Self::Point>,
        max: Option<&Self::Point>,
        window: [f64; 4],
        out: &mut Vec<[f64; 2]>,
    );
}
