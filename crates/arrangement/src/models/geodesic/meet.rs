//! Arcs that meet.

use super::{GeodesicArc, GeodesicTraits};
use crate::traits::{BasicTraits, CurveEnd, Intersection, Meeting, Multiplicity, UMonotoneTraits, Window};
use exact::Sign;
use exact::spherical::{Direction, compare_height, crossing_side, rises_at, side_of_circle};
use std::cmp::Ordering;

type Common = Intersection<Direction, GeodesicArc>;

impl UMonotoneTraits for GeodesicTraits {
    /// Two arcs have up to two points in common, or a piece, and perhaps a point besides: an end of both on the identification, to which they may come
    /// from one side or from both. Poles are not appended: every end there is by itself.
    ///
    /// # Complexity
    /// Four side tests, and comparisons of longitudes for each crossing that they leave possible.
    fn intersect(&self, a: &GeodesicArc, b: &GeodesicArc, out: &mut Vec<Common>) {
        match (a.is_meridian(), b.is_meridian()) {
            (true, true) => {
                if a.circle() == b.circle() {
                    out.extend(self.overlap(a, b));
                }
            }
            (false, false) => {
                if a.circle() == b.circle() {
                    self.meet_on_circle(a, b, out);
                } else {
                    self.meet_across(a, b, out);
                }
            }
            (true, false) => out.extend(self.meet_vertical(a, b)),
            (false, true) => out.extend(self.meet_vertical(b, a)),
        }
    }

    fn split(&self, curve: &GeodesicArc, p: &Direction) -> [GeodesicArc; 2] {
        [curve.part([None, Some(p)]), curve.part([Some(p), None])]
    }

    /// The result is directed as `a`. Arcs that touch on the identification or at a pole are not merged, but two that lie along the identification are.
    fn merge(&self, a: &GeodesicArc, b: &GeodesicArc) -> Option<GeodesicArc> {
        let (left, right) = in_order(a, b)?;
        let places = [left.place(CurveEnd::Min), right.place(CurveEnd::Max)].map(|(p, at)| (p.clone(), at));
        Some(GeodesicArc::new(a.circle().clone(), places, a.is_directed_right()))
    }

    fn is_mergeable(&self, a: &GeodesicArc, b: &GeodesicArc) -> bool {
        in_order(a, b).is_some()
    }

    /// To the right of a point where `below` is below, the first crossing is the one where it goes over to the other side, n' x n with the normals n, n' of
    /// `below` and `above`; the other one comes half a circle later.
    ///
    /// # Complexity
    /// One side test for each pair that does not meet, unless both go round more than half of the sphere.
    #[inline]
    fn next_meeting(
        &self,
        below: &GeodesicArc,
        above: &GeodesicArc,
        window: Window<'_, Direction>,
    ) -> Meeting<Direction> {
        let (first, other) = if window.first_to_end == 0 { (below, above) } else { (above, below) };
        let until = match window.until {
            Some(until) => until,
            // Its part may end before its own end; but what comes to the identification ends there.
            None if first.is_along_side() => return Meeting::Never,
            None => first.end(CurveEnd::Max),
        };
        // On a side, every end is by itself.
        let at_end = || if window.until.is_some() { Meeting::AtEnd } else { Meeting::Never };
        let side = side_of_circle(until, other.circle());
        let out_of_order = if window.first_to_end == 0 { side } else { -side };
        if below.is_long() && above.is_long() && !out_of_order.is_positive() {
            return self.next_meeting_of_long(below, above, window, out_of_order);
        }
        match out_of_order {
            Sign::Negative => Meeting::Never,
            Sign::Zero => at_end(),
            Sign::Positive => crossing(below, above),
        }
    }

    fn end_of_overlap(&self, a: &GeodesicArc, b: &GeodesicArc, p: Option<&Direction>) -> Option<Direction> {
        let _ = p;
        if a.circle() != b.circle() {
            return None;
        }
        let (point, location) = self.first_max(a, b).place(CurveEnd::Max);
        (!a.is_at_side(location)).then(|| point.clone())
    }

    fn trim(&self, curve: &GeodesicArc, min: Option<&Direction>, max: Option<&Direction>) -> GeodesicArc {
        // A point on a side is an end of the curve, if it is not on an arc along the identification.
        let inner = |end: CurveEnd, p: Option<&Direction>| p.is_some_and(|p| p != curve.end(end));
        let [min, max] =
            [(CurveEnd::Min, min), (CurveEnd::Max, max)].map(|(end, p)| p.filter(|_| inner(end, p)));
        if min.is_none() && max.is_none() { curve.clone() } else { curve.part([min, max]) }
    }
}

/// The two arcs in their order, if they are pieces of one arc that touch in its interior.
fn in_order<'a>(a: &'a GeodesicArc, b: &'a GeodesicArc) -> Option<(&'a GeodesicArc, &'a GeodesicArc)> {
    let touches = |left: &GeodesicArc, right: &GeodesicArc| {
        let ([(p, here), (q, there)], inner) =
            ([left.place(CurveEnd::Max), right.place(CurveEnd::Min)], left.inner_location());
        here == inner && there == inner && p == q
    };
    if a.circle() != b.circle() {
        None
    } else if touches(a, b) {
        Some((a, b))
    } else {
        touches(b, a).then_some((b, a))
    }
}

/// The crossing to the right of which `below` is above.
fn crossing(below: &GeodesicArc, above: &GeodesicArc) -> Meeting<Direction> {
    match Direction::crossing(above.circle(), below.circle()) {
        Some(point) => Meeting::At(point, Multiplicity::Odd),
        None => Meeting::Never,
    }
}

impl GeodesicTraits {
    /// As [`UMonotoneTraits::next_meeting`], if at the end of the window the arcs are in order or meet: both may have crossed twice before, or once.
    #[cold]
    fn next_meeting_of_long(
        &self,
        below: &GeodesicArc,
        above: &GeodesicArc,
        window: Window<'_, Direction>,
        out_of_order: Sign,
    ) -> Meeting<Direction> {
        let first = if window.first_to_end == 0 { below } else { above };
        let until = window.until.unwrap_or(first.end(CurveEnd::Max));
        if out_of_order.is_zero() {
            return match crossing_side(above.circle(), below.circle(), until) {
                // They go back in order there, so they have left it before.
                Sign::Negative => crossing(below, above),
                _ if window.until.is_some() => Meeting::AtEnd,
                _ => Meeting::Never,
            };
        }
        let Meeting::At(point, multiplicity) = crossing(below, above) else { return Meeting::Never };
        let is_after = window.after.is_none_or(|after| self.compare_u(after, &point).is_lt());
        // Without `until`, the window ends on the right side.
        let is_before = || window.until.is_none() || self.compare_u(&point, until).is_lt();
        if is_after && is_before() { Meeting::At(point, multiplicity) } else { Meeting::Never }
    }

    /// Of two arcs of one circle, or one half meridian, the one that begins later.
    fn last_min<'a>(&self, a: &'a GeodesicArc, b: &'a GeodesicArc) -> &'a GeodesicArc {
        let [(p, here), (q, there)] = [a, b].map(|arc| arc.place(CurveEnd::Min));
        let order = match (a.is_at_side(here), b.is_at_side(there)) {
            (false, false) => self.compare_on_arc(a, p, q),
            (is_here, is_there) => is_there.cmp(&is_here),
        };
        if order.is_lt() { b } else { a }
    }

    /// Of two arcs of one circle, or one half meridian, the one that ends first.
    fn first_max<'a>(&self, a: &'a GeodesicArc, b: &'a GeodesicArc) -> &'a GeodesicArc {
        let [(p, here), (q, there)] = [a, b].map(|arc| arc.place(CurveEnd::Max));
        let order = match (a.is_at_side(here), b.is_at_side(there)) {
            (false, false) => self.compare_on_arc(a, p, q),
            (is_here, is_there) => is_here.cmp(&is_there),
        };
        if order.is_gt() { b } else { a }
    }

    /// Compares two points of one arc, not on the left or right side unless the arc lies along it.
    fn compare_on_arc(&self, arc: &GeodesicArc, p: &Direction, q: &Direction) -> Ordering {
        if arc.is_meridian() { compare_height(p, q) } else { self.compare_u(p, q) }
    }

    /// The common piece of two arcs of one circle, or one half meridian, or the one point.
    fn overlap(&self, a: &GeodesicArc, b: &GeodesicArc) -> Option<Common> {
        let ((min, at_min), (max, at_max)) =
            (self.last_min(a, b).place(CurveEnd::Min), self.first_max(a, b).place(CurveEnd::Max));
        let order = match a.is_at_side(at_min) || a.is_at_side(at_max) {
            true => Ordering::Less,
            false => self.compare_on_arc(a, min, max),
        };
        match order {
            Ordering::Less => {
                let places = [(min.clone(), at_min), (max.clone(), at_max)];
                let piece = GeodesicArc::new(a.circle().clone(), places, a.is_directed_right());
                Some(Intersection::Overlap(piece))
            }
            Ordering::Equal => Some(Intersection::Point(min.clone(), Multiplicity::Unknown)),
            Ordering::Greater => None,
        }
    }

    /// Two arcs of one circle, which is no meridian.
    fn meet_on_circle(&self, a: &GeodesicArc, b: &GeodesicArc, out: &mut Vec<Common>) {
        let ([a_left, a_right], [b_left, b_right]) = (a.ends_on_sides(), b.ends_on_sides());
        // One comes to the identification from the left and one from the right, and the common piece, if there is one, does not.
        let touch_there = (a_left && b_right) || (a_right && b_left);
        if touch_there && !(a_left && b_left) && !(a_right && b_right) {
            let end = if a_left { CurveEnd::Min } else { CurveEnd::Max };
            out.push(Intersection::Point(a.end(end).clone(), Multiplicity::Unknown));
        }
        out.extend(self.overlap(a, b));
    }

    /// Two arcs of different circles, neither of which is a meridian: perhaps one or both of two antipodal points.
    fn meet_across(&self, a: &GeodesicArc, b: &GeodesicArc, out: &mut Vec<Common>) {
        let sides = [(a, b), (b, a)]
            .map(|(arc, other)| CurveEnd::BOTH.map(|end| side_of_circle(arc.end(end), other.circle())));
        let is_apart =
            |arc: &GeodesicArc, sides: [Sign; 2]| !arc.is_long() && sides[0] * sides[1] == Sign::Positive;
        if is_apart(a, sides[0]) || is_apart(b, sides[1]) {
            return;
        }
        let Some(point) = Direction::crossing(a.circle(), b.circle()) else { return };
        let first = out.len();
        for (sense, candidate) in [(Sign::Positive, &point), (Sign::Negative, &point.opposite())] {
            let end = [a, b].into_iter().zip(sides).find_map(|(arc, sides)| {
                CurveEnd::BOTH.into_iter().zip(sides).find_map(|(end, side)| {
                    let is_candidate =
                        side.is_zero() && crossing_side(a.circle(), b.circle(), arc.end(end)) == sense;
                    is_candidate.then(|| arc.end(end))
                })
            });
            let (point, multiplicity) = match end {
                Some(end) => (end, Multiplicity::Unknown),
                None => (candidate, Multiplicity::Odd),
            };
            if self.is_within(point, a) && self.is_within(point, b) {
                out.push(Intersection::Point(point.clone(), multiplicity));
            }
        }
        if let [Intersection::Point(p, _), Intersection::Point(q, _)] = &out[first..]
            && self.compare_u(p, q).is_gt()
        {
            out.swap(first, first + 1);
        }
    }

    /// A piece of a meridian, and an arc that is none.
    fn meet_vertical(&self, vertical: &GeodesicArc, arc: &GeodesicArc) -> Option<Common> {
        let [below, above] = CurveEnd::BOTH.map(|end| side_of_circle(vertical.end(end), arc.circle()));
        if below.is_positive() || above.is_negative() {
            return None;
        }
        let is_on_half = |p: &&Direction| {
            side_of_circle(p, vertical.circle()).is_zero() && rises_at(p, vertical.circle()).is_positive()
        };
        let end = match (below, above) {
            (Sign::Zero, _) => Some(vertical.end(CurveEnd::Min)),
            (_, Sign::Zero) => Some(vertical.end(CurveEnd::Max)),
            _ => CurveEnd::BOTH.map(|end| arc.end(end)).into_iter().find(is_on_half),
        };
        let (point, multiplicity) = match end {
            Some(end) => (end.clone(), Multiplicity::Unknown),
            // With the normal n and a normal m x z it is m (n . z) - z (n . m): on the half meridian of m.
            None => (Direction::crossing(arc.circle(), vertical.circle())?, Multiplicity::Odd),
        };
        self.is_within(&point, arc).then_some(Intersection::Point(point, multiplicity))
    }
}
