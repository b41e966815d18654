//! What all straight curves have in common: the predicates on pieces of lines, and the traits made of them.

mod approx;
#[cfg(test)]
pub(super) mod tests;

pub(super) use approx::approx_curve;

use crate::traits::{CurveEnd, Intersection, Meeting, Multiplicity};
use exact::Sign;
use exact::planar::{Line2, Point2, compare_x, compare_y, side_of_line};
use std::borrow::Borrow;
use std::cmp::Ordering;
use std::fmt::Debug;

/// A connected piece of a line with more than one point.
///
/// Law: both ends, if there are two, lie on the line, and are different and in lexicographic order.
pub(super) trait Straight: Clone + Debug + Send + Sync {
    /// The line, kept or made.
    fn line(&self) -> impl Borrow<Line2>;

    /// An end, if the piece is bounded there.
    fn end(&self, end: CurveEnd) -> Option<&Point2>;

    /// Whether the piece is directed from `Min` to `Max`.
    fn is_directed_right(&self) -> bool;

    /// Another piece of the same line.
    fn with_ends(&self, ends: [Option<Point2>; 2]) -> Self;

    /// The same piece, directed the other way.
    fn opposite(&self) -> Self;
}

#[inline]
pub(super) fn is_vertical(curve: &impl Straight) -> bool {
    curve.line().borrow().is_vertical()
}

/// Compares heights at the u of `p`; see [`crate::traits::BasicTraits::compare_v_at_u`].
#[inline]
pub(super) fn compare_v_at_u(p: &Point2, curve: &impl Straight) -> Ordering {
    let line = curve.line();
    let line: &Line2 = line.borrow();
    if line.is_vertical() { compare_v_with_ends(p, curve) } else { side_of_line(p, line).ordering() }
}

#[inline(never)]
fn compare_v_with_ends(p: &Point2, curve: &impl Straight) -> Ordering {
    if curve.end(CurveEnd::Min).is_some_and(|min| compare_y(p, min).is_lt()) {
        Ordering::Less
    } else if curve.end(CurveEnd::Max).is_some_and(|max| compare_y(p, max).is_gt()) {
        Ordering::Greater
    } else {
        Ordering::Equal
    }
}

/// See [`crate::traits::BasicTraits::side_key`].
#[inline]
pub(super) fn side_key(curve: &impl Straight) -> [u32; 3] {
    let line = curve.line();
    let line: &Line2 = line.borrow();
    // What is beside a vertical piece is told by its ends.
    if line.is_vertical() { [0; 3] } else { line.side_key() }
}

/// Compares two pieces right of a common point. A vertical line is the steepest of all.
#[inline]
pub(super) fn compare_v_at_u_right(a: &impl Straight, b: &impl Straight) -> Ordering {
    a.line().borrow().compare_slope(b.line().borrow())
}

/// Tells whether the u of `p` lies between those of the ends.
#[inline]
pub(super) fn is_in_u_range(p: &Point2, curve: &impl Straight) -> bool {
    let (min, max) = (curve.end(CurveEnd::Min), curve.end(CurveEnd::Max));
    if (min.is_none() || max.is_none()) && is_vertical(curve) {
        // The missing end has the same u as all the rest.
        return side_of_line(p, curve.line().borrow()).is_zero();
    }
    min.is_none_or(|min| compare_x(min, p).is_le()) && max.is_none_or(|max| compare_x(p, max).is_le())
}

/// Finds where two neighbours of a sweep meet, one side test for each pair that does not.
///
/// `until` is where `first_to_end` (0: `below`, 1: `above`) ends, `None` if it does not. That the curves are in order before
/// tells the rest: they have crossed before `until` if they are out of order there.
#[inline]
pub(super) fn next_meeting<S: Straight>(
    below: &S,
    above: &S,
    until: Option<&Point2>,
    first_to_end: usize,
) -> Meeting<Point2> {
    let out_of_order = match until {
        Some(until) if first_to_end == 0 => side_of_line(until, above.line().borrow()),
        Some(until) => -side_of_line(until, below.line().borrow()),
        // Neither ends: they cross if they approach one another.
        None => match compare_v_at_u_right(below, above) {
            Ordering::Greater => Sign::Positive,
            Ordering::Less | Ordering::Equal => Sign::Negative,
        },
    };
    match out_of_order {
        Sign::Negative => Meeting::Never,
        Sign::Zero => Meeting::AtEnd,
        Sign::Positive => match Point2::crossing(below.line().borrow(), above.line().borrow()) {
            Some(point) => Meeting::At(point, Multiplicity::Odd),
            None => Meeting::Never,
        },
    }
}

/// Finds what two pieces have in common: nothing, a point or a piece.
///
/// # Complexity
/// Four side tests, and a crossing if there is one in the interior of both.
pub(super) fn intersection<S: Straight>(a: &S, b: &S) -> Option<Intersection<Point2, S>> {
    let (line_a, line_b) = (a.line(), b.line());
    let (line_a, line_b): (&Line2, &Line2) = (line_a.borrow(), line_b.borrow());
    let by_slope = line_a.compare_slope(line_b);
    if by_slope.is_eq() {
        return if line_a.is_same(line_b) { overlap(a, b) } else { None };
    }
    let sides_of_a = sides_of_ends(a, by_slope.into(), line_b);
    if sides_of_a[0] * sides_of_a[1] == Sign::Positive {
        return None;
    }
    let sides_of_b = sides_of_ends(b, by_slope.reverse().into(), line_a);
    if sides_of_b[0] * sides_of_b[1] == Sign::Positive {
        return None;
    }
    // An end on the other line is where the lines cross, and both pieces reach that point.
    for (curve, sides) in [(a, sides_of_a), (b, sides_of_b)] {
        for (end, side) in CurveEnd::BOTH.into_iter().zip(sides) {
            if let (Sign::Zero, Some(point)) = (side, curve.end(end)) {
                return Some(Intersection::Point(point.clone(), Multiplicity::Unknown));
            }
        }
    }
    Point2::crossing(line_a, line_b).map(|point| Intersection::Point(point, Multiplicity::Odd))
}

/// The sides of a line on which both ends lie. An end at infinity lies where its line goes: `by_slope` is the sign of the difference of
/// the slopes.
fn sides_of_ends(curve: &impl Straight, by_slope: Sign, line: &Line2) -> [Sign; 2] {
    [(CurveEnd::Min, -by_slope), (CurveEnd::Max, by_slope)]
        .map(|(end, at_infinity)| curve.end(end).map_or(at_infinity, |point| side_of_line(point, line)))
}

/// What two pieces of one line have in common.
fn overlap<S: Straight>(a: &S, b: &S) -> Option<Intersection<Point2, S>> {
    let greater = |p, q| if p > q { p } else { q };
    let smaller = |p, q| if p < q { p } else { q };
    let both = |end, choose: fn(_, _) -> _| match (a.end(end), b.end(end)) {
        (Some(p), Some(q)) => Some(choose(p, q)),
        (p, q) => p.or(q),
    };
    let (min, max) = (both(CurveEnd::Min, greater), both(CurveEnd::Max, smaller));
    let order = match (min, max) {
        (Some(min), Some(max)) => min.cmp(max),
        _ => Ordering::Less,
    };
    match order {
        Ordering::Less => Some(Intersection::Overlap(a.with_ends([min.cloned(), max.cloned()]))),
        Ordering::Equal => min.map(|point| Intersection::Point(point.clone(), Multiplicity::Unknown)),
        Ordering::Greater => None,
    }
}

/// The two pieces on either side of an inner point.
pub(super) fn split<S: Straight>(curve: &S, p: &Point2) -> [S; 2] {
    [trim(curve, None, Some(p)), trim(curve, Some(p), None)]
}

/// The piece between two points; `None` keeps the end.
pub(super) fn trim<S: Straight>(curve: &S, min: Option<&Point2>, max: Option<&Point2>) -> S {
    curve.with_ends([min.or(curve.end(CurveEnd::Min)).cloned(), max.or(curve.end(CurveEnd::Max)).cloned()])
}

/// Tells which of two curves is the left one if they are pieces of one line that share an end: 0 for the first.
pub(super) fn left_of_mergeable<S: Straight>(a: &S, b: &S) -> Option<usize> {
    if !a.line().borrow().is_same(b.line().borrow()) {
        return None;
    }
    let touches = |left: &S, right: &S| matches!((left.end(CurveEnd::Max), right.end(CurveEnd::Min)), (Some(p), Some(q)) if p == q);
    if touches(a, b) { Some(0) } else { touches(b, a).then_some(1) }
}

/// Both as one piece, directed as the first, if they are pieces of one line that share an end.
pub(super) fn merge<S: Straight>(a: &S, b: &S) -> Option<S> {
    let (left, right) = match left_of_mergeable(a, b)? {
        0 => (a, b),
        _ => (b, a),
    };
    Some(a.with_ends([left.end(CurveEnd::Min).cloned(), right.end(CurveEnd::Max).cloned()]))
}

/// Implements the traits that all families of straight curves share, for a traits object and its curve.
macro_rules! straight_traits {
    ($traits:ty, $curve:ty) => {
        impl $crate::traits::BasicTraits for $traits {
            type Point = exact::planar::Point2;
            type UMonotoneCurve = $curve;

            const MEET_ONCE: bool = true;
            const OVERLAPS_ARE_PLAIN: bool = true;

            #[inline]
            fn order_key(&self, p: &Self::Point) -> u64 {
                p.order_key()
            }

            #[inline]
            fn order_range(&self, p: &Self::Point) -> (u64, u32) {
                p.order_range()
            }

            #[inline]
            fn compare_u(&self, p: &Self::Point, q: &Self::Point) -> std::cmp::Ordering {
                exact::planar::compare_x(p, q)
            }

            #[inline]
            fn compare_uv(&self, p: &Self::Point, q: &Self::Point) -> std::cmp::Ordering {
                exact::planar::compare_xy(p, q)
            }

            #[inline]
            fn end_point<'a>(
                &self,
                curve: &'a $curve,
                end: $crate::traits::CurveEnd,
            ) -> Option<&'a Self::Point> {
                $crate::models::straight::Straight::end(curve, end)
            }

            #[inline]
            fn is_vertical(&self, curve: &$curve) -> bool {
                $crate::models::straight::is_vertical(curve)
            }

            #[inline]
            fn compare_v_at_u(&self, p: &Self::Point, curve: &$curve) -> std::cmp::Ordering {
                $crate::models::straight::compare_v_at_u(p, curve)
            }

            #[inline]
            fn compare_v_at_u_right(&self, a: &$curve, b: &$curve, _: &Self::Point) -> std::cmp::Ordering {
                $crate::models::straight::compare_v_at_u_right(a, b)
            }

            #[inline]
            fn side_key(&self, curve: &$curve) -> [u32; 3] {
                $crate::models::straight::side_key(curve)
            }

            #[inline]
            fn compare_v_at_u_by_key(&self, p: &Self::Point, key: &[u32; 3]) -> Option<std::cmp::Ordering> {
                exact::planar::side_of_key(p, key).map(exact::Sign::ordering)
            }

            /// The steeper line is below to the left.
            #[inline]
            fn compare_v_at_u_left(&self, a: &$curve, b: &$curve, _: &Self::Point) -> std::cmp::Ordering {
                $crate::models::straight::compare_v_at_u_right(b, a)
            }

            #[inline]
            fn is_in_u_range(&self, p: &Self::Point, curve: &$curve) -> bool {
                $crate::models::straight::is_in_u_range(p, curve)
            }
        }

        impl $crate::traits::UMonotoneTraits for $traits {
            fn intersect(
                &self,
                a: &$curve,
                b: &$curve,
                out: &mut Vec<$crate::traits::Intersection<Self::Point, $curve>>,
            ) {
                out.extend($crate::models::straight::intersection(a, b));
            }

            fn split(&self, curve: &$curve, p: &Self::Point) -> [$curve; 2] {
                $crate::models::straight::split(curve, p)
            }

            /// The result is directed as `a`.
            fn merge(&self, a: &$curve, b: &$curve) -> Option<$curve> {
                $crate::models::straight::merge(a, b)
            }

            fn is_mergeable(&self, a: &$curve, b: &$curve) -> bool {
                $crate::models::straight::left_of_mergeable(a, b).is_some()
            }

            #[inline]
            fn next_meeting(
                &self,
                below: &$curve,
                above: &$curve,
                window: $crate::traits::Window<'_, Self::Point>,
            ) -> $crate::traits::Meeting<Self::Point> {
                $crate::models::straight::next_meeting(below, above, window.until, window.first_to_end)
            }

            fn trim(&self, curve: &$curve, min: Option<&Self::Point>, max: Option<&Self::Point>) -> $curve {
                $crate::models::straight::trim(curve, min, max)
            }
        }

        impl $crate::traits::ArrangementTraits for $traits {
            type Curve = $curve;

            fn make_u_monotone(
                &self,
                curve: &$curve,
                out: &mut Vec<$crate::traits::Piece<Self::Point, $curve>>,
            ) {
                out.push($crate::traits::Piece::Curve { curve: curve.clone(), is_artificial: [false; 2] });
            }
        }

        impl $crate::traits::DirectionalTraits for $traits {
            #[inline]
            fn is_directed_right(&self, curve: &$curve) -> bool {
                $crate::models::straight::Straight::is_directed_right(curve)
            }

            fn opposite(&self, curve: &$curve) -> $curve {
                $crate::models::straight::Straight::opposite(curve)
            }
        }

        impl $crate::traits::ApproxTraits for $traits {
            #[inline]
            fn approx_point(&self, p: &Self::Point) -> [f64; 2] {
                p.approx_f64()
            }

            fn approx_curve(
                &self,
                curve: &$curve,
                min: Option<&Self::Point>,
                max: Option<&Self::Point>,
                window: [f64; 4],
                out: &mut Vec<[f64; 2]>,
            ) {
                $crate::models::straight::approx_curve(curve, [min, max], window, out);
            }
        }

        impl $crate::traits::LandmarkTraits for $traits {
            fn approx_to_point(&self, parameters: [f64; 2]) -> Option<Self::Point> {
                Self::Point::from_f64s(parameters)
            }
        }
    };
}
pub(super) use straight_traits;
