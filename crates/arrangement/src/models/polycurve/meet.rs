//! Chains that meet.

use super::{Chain, PieceTraits, PolycurveTraits};
use crate::traits::{BasicTraits, CurveEnd, Intersection, Meeting, Multiplicity, UMonotoneTraits, Window};
use std::cmp::Ordering;

impl<S: PieceTraits> UMonotoneTraits for PolycurveTraits<S> {
    /// Appends all that two chains have in common.
    ///
    /// Law: an overlap is as long as can be, across joints; at a joint nothing is told twice.
    ///
    /// # Complexity
    /// Pairs of pieces are asked along the common u-range: O(log m) for the first, and no more pairs than there are pieces.
    fn intersect(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        out: &mut Vec<Intersection<Self::Point, Self::UMonotoneCurve>>,
    ) {
        let mut i = self.inner_end(b, CurveEnd::Min).map_or(0, |p| self.piece_before(a, p));
        let mut j = self.inner_end(a, CurveEnd::Min).map_or(0, |p| self.piece_before(b, p));
        let mut found = Vec::new();
        let mut common = Common { traits: &self.pieces, from: out.len(), overlap: Vec::new(), out };
        loop {
            self.pieces.intersect(&a.pieces()[i], &b.pieces()[j], &mut found);
            for intersection in found.drain(..) {
                match &intersection {
                    Intersection::Point(p, _) if !self.pieces.is_joint_allowed(p) => {}
                    _ => common.add(intersection, a.is_directed_right()),
                }
            }
            let [last_a, last_b] = [i == a.last(), j == b.last()];
            let end = |chain, piece, is_last| match is_last {
                false => self.joint_after(chain, piece),
                true => self.inner_end(chain, CurveEnd::Max),
            };
            let order = match (end(a, i, last_a), end(b, j, last_b)) {
                (Some(p), Some(q)) => self.pieces.compare_uv(p, q),
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (None, None) => Ordering::Equal,
            };
            if order.is_eq() && !last_a && !last_b {
                common.note_joint(self.joint_after(a, i));
            }
            // Where both pieces end at one point, a chain that ends there meets the next piece of the other there, too, and that is
            // known already.
            if order.is_le() && last_a || order.is_ge() && last_b {
                break;
            }
            i += usize::from(order.is_le());
            j += usize::from(order.is_ge());
        }
        common.flush(a.is_directed_right());
        let from = common.from;
        self.add_points_on_sides(a, b, from, out);
    }

    fn split(&self, curve: &Self::UMonotoneCurve, p: &Self::Point) -> [Self::UMonotoneCurve; 2] {
        let chain = |pieces: Vec<S::UMonotoneCurve>| Chain::new(pieces, curve.is_directed_right());
        let at = self.piece_after(curve, p);
        let (before, after) = curve.pieces().split_at(at);
        let is_joint = !before.is_empty()
            && self
                .pieces
                .end_point(&after[0], CurveEnd::Min)
                .is_some_and(|joint| self.pieces.is_same_point(joint, p));
        if is_joint {
            return [before, after].map(|part| chain(part.to_vec()));
        }
        let [smaller, greater] = self.pieces.split(&after[0], p);
        let lower = before.iter().cloned().chain([smaller]).collect();
        let upper = [greater].into_iter().chain(after[1..].iter().cloned()).collect();
        [chain(lower), chain(upper)]
    }

    /// Joins two chains that share an end, if both are vertical or neither is. The result is directed as `a`.
    ///
    /// If the pieces that touch can be merged, they are, so that merging undoes splitting.
    fn merge(&self, a: &Self::UMonotoneCurve, b: &Self::UMonotoneCurve) -> Option<Self::UMonotoneCurve> {
        let [lower, upper] = self.in_order(a, b)?;
        let (before, after) = (lower.pieces(), upper.pieces());
        let (last, first) = (lower.end_piece(CurveEnd::Max), upper.end_piece(CurveEnd::Min));
        let pieces: Vec<_> = match self.pieces.merge(last, first) {
            Some(merged) => {
                before[..before.len() - 1].iter().chain([&merged]).chain(&after[1..]).cloned().collect()
            }
            None => before.iter().chain(after).cloned().collect(),
        };
        Some(Chain::new(pieces, a.is_directed_right()))
    }

    fn is_mergeable(&self, a: &Self::UMonotoneCurve, b: &Self::UMonotoneCurve) -> bool {
        self.in_order(a, b).is_some()
    }

    /// Finds the next common point of two neighbours, by walking along both from the point where they became neighbours.
    ///
    /// # Complexity
    /// O(log m) comparisons for chains of m pieces, and one question of the same kind, and at most two comparisons, for each pair
    /// of pieces up to the meeting. No allocation but those of the model of the pieces.
    fn next_meeting(
        &self,
        below: &Self::UMonotoneCurve,
        above: &Self::UMonotoneCurve,
        window: Window<'_, Self::Point>,
    ) -> Meeting<Self::Point> {
        let [mut i, mut j] = match window.after {
            Some(after) => [below, above].map(|chain| self.piece_after(chain, after)),
            None => self.first_pieces(below, above),
        };
        let mut after = window.after;
        loop {
            let (lower, upper) = (&below.pieces()[i], &above.pieces()[j]);
            // The ends of the chains themselves are not before the end of the window, and may lie on sides.
            let (order, end) = match (self.joint_after(below, i), self.joint_after(above, j)) {
                (Some(p), Some(q)) => match self.pieces.compare_uv(p, q) {
                    Ordering::Greater => (Ordering::Greater, q),
                    order => (order, p),
                },
                (Some(p), None) => (Ordering::Less, p),
                (None, Some(q)) => (Ordering::Greater, q),
                (None, None) => return self.pieces.next_meeting(lower, upper, Window { after, ..window }),
            };
            let is_first_over = match window.until {
                Some(until) => self.pieces.compare_uv(until, end).is_le(),
                // It ends on a side, or is unbounded: a vertical one is over before the other comes to its joint.
                None => match window.first_to_end {
                    0 => i == below.last() && self.is_over_before(lower, end),
                    _ => j == above.last() && self.is_over_before(upper, end),
                },
            };
            if is_first_over {
                return self.pieces.next_meeting(lower, upper, Window { after, ..window });
            }
            let first_to_end = usize::from(order.is_gt());
            let until_joint = Window { after, until: Some(end), first_to_end };
            match self.pieces.next_meeting(lower, upper, until_joint) {
                Meeting::Never => {}
                Meeting::At(point, multiplicity) => return Meeting::At(point, multiplicity),
                Meeting::AtEnd => return Meeting::At(end.clone(), Multiplicity::Unknown),
            }
            // They do not meet at the joint: so they keep their order, and that is all that the next pair has to know.
            after = Some(end);
            i += usize::from(order.is_le());
            j += usize::from(order.is_ge());
        }
    }

    /// Finds where two chains part, by walking along both from `p` on.
    ///
    /// # Complexity
    /// O(log m) comparisons for chains of m pieces, and two for each pair of pieces up to the end of the overlap; besides, if the curves
    /// of the model of the pieces do not meet once, one question of the same kind.
    fn end_of_overlap(
        &self,
        a: &Self::UMonotoneCurve,
        b: &Self::UMonotoneCurve,
        p: Option<&Self::Point>,
    ) -> Option<Self::Point> {
        let [mut i, mut j] = [a, b].map(|chain| p.map_or(0, |p| self.piece_after(chain, p)));
        let mut from = p;
        loop {
            let end = |chain, piece| match self.joint_after(chain, piece) {
                Some(joint) => Some(joint),
                None => self.inner_end(chain, CurveEnd::Max),
            };
            let [end_a, end_b] = [end(a, i), end(b, j)];
            // Pieces that run together come to points of the interior before they come to a side.
            let (order, end) = match (end_a, end_b) {
                (Some(p), Some(q)) => match self.pieces.compare_uv(p, q) {
                    Ordering::Greater => (Ordering::Greater, Some(q)),
                    order => (order, Some(p)),
                },
                (Some(p), None) => (Ordering::Less, Some(p)),
                (None, Some(q)) => (Ordering::Greater, Some(q)),
                (None, None) => (Ordering::Equal, None),
            };
            if !S::MEET_ONCE {
                let parting = self.pieces.end_of_overlap(&a.pieces()[i], &b.pieces()[j], from);
                let is_first = |q: &S::Point| end.is_none_or(|end| self.pieces.compare_uv(q, end).is_lt());
                if let Some(point) = parting.filter(is_first) {
                    return Some(point);
                }
            }
            let joint = end?;
            if order.is_le() && i == a.last() || order.is_ge() && j == b.last() {
                return Some(joint.clone());
            }
            i += usize::from(order.is_le());
            j += usize::from(order.is_ge());
            if self.pieces.compare_v_at_u_right(&a.pieces()[i], &b.pieces()[j], joint).is_ne() {
                return Some(joint.clone());
            }
            from = Some(joint);
        }
    }

    fn trim(
        &self,
        curve: &Self::UMonotoneCurve,
        min: Option<&Self::Point>,
        max: Option<&Self::Point>,
    ) -> Self::UMonotoneCurve {
        let [min, max] = self.inner_points(curve, min, max);
        if min.is_none() && max.is_none() {
            return curve.clone();
        }
        let [first, last] = self.piece_range(curve, min, max);
        let pieces: Vec<_> = (first..=last)
            .map(|i| {
                let (from, to) = (min.filter(|_| i == first), max.filter(|_| i == last));
                match (from, to) {
                    (None, None) => curve.pieces()[i].clone(),
                    _ => self.pieces.trim(&curve.pieces()[i], from, to),
                }
            })
            .collect();
        Chain::new(pieces, curve.is_directed_right())
    }
}

impl<S: PieceTraits> PolycurveTraits<S> {
    /// The end of a chain, if it is a point in the interior.
    fn inner_end<'a>(&self, chain: &'a Chain<S::UMonotoneCurve>, end: CurveEnd) -> Option<&'a S::Point> {
        self.end_point(chain, end).filter(|p| self.pieces.is_joint_allowed(p))
    }

    /// Tells whether a piece that ends on a side or is unbounded does so before a joint of another chain is met.
    ///
    /// A vertical line has no end to compare with, and need not: joints to the left and to the right of it are on its two sides.
    fn is_over_before(&self, piece: &S::UMonotoneCurve, joint: &S::Point) -> bool {
        if !self.pieces.is_vertical(piece) {
            return !self.pieces.is_in_u_range(joint, piece);
        }
        let order =
            CurveEnd::BOTH.into_iter().find_map(|end| self.pieces.compare_u_to_end(joint, piece, end));
        order.is_some_and(Ordering::is_gt)
    }

    /// The pieces of two chains where the later of them begins, which became neighbours there or before any of their joints.
    ///
    /// It may begin on the bottom or the top, and the other far to the left: pieces further left have another order, or none.
    fn first_pieces(&self, a: &Chain<S::UMonotoneCurve>, b: &Chain<S::UMonotoneCurve>) -> [usize; 2] {
        let first_piece =
            |chain, other: &Chain<_>| self.find(chain, |joint| self.is_passed_at_start(joint, other));
        [first_piece(a, b), first_piece(b, a)]
    }

    /// Tells whether a chain begins behind a joint of another one, or there.
    fn is_passed_at_start(&self, joint: &S::Point, chain: &Chain<S::UMonotoneCurve>) -> bool {
        let first = chain.end_piece(CurveEnd::Min);
        let by_u = self.pieces.compare_u_to_end(joint, first, CurveEnd::Min);
        // A point on the bottom is before all joints with its u, so that the other chain is taken up a piece too early rather
        // than too late; so is one on the top, if both are identified.
        by_u.is_some_and(|by_u| {
            by_u.is_lt()
                || by_u.is_eq()
                    && self
                        .inner_end(chain, CurveEnd::Min)
                        .is_some_and(|start| self.pieces.compare_uv(joint, start).is_le())
        })
    }

    /// Adds to what two chains have in common the points on sides, where chains end. One is in several places of the parameter
    /// space, so the walk cannot find it.
    fn add_points_on_sides(
        &self,
        a: &Chain<S::UMonotoneCurve>,
        b: &Chain<S::UMonotoneCurve>,
        from: usize,
        out: &mut Vec<Intersection<S::Point, Chain<S::UMonotoneCurve>>>,
    ) {
        let before = out.len();
        for (chain, other) in [(a, b), (b, a)] {
            for end in CurveEnd::BOTH {
                let Some(p) = self.end_point(chain, end).filter(|p| !self.pieces.is_joint_allowed(p)) else {
                    continue;
                };
                let is_known = |intersection: &Intersection<_, _>| match intersection {
                    Intersection::Point(q, _) => self.is_same_point(p, q),
                    Intersection::Overlap(piece) => self.is_on_curve(p, piece),
                };
                if self.is_on_curve(p, other) && !out[from..].iter().any(is_known) {
                    out.push(Intersection::Point(p.clone(), Multiplicity::Unknown));
                }
            }
        }
        if out.len() > before {
            out[from..].sort_by(|x, y| {
                let [x, y] = [x, y].map(|intersection| match intersection {
                    Intersection::Point(p, _) => Some(p),
                    Intersection::Overlap(piece) => self.end_point(piece, CurveEnd::Min),
                });
                // What has no point begins on an open side, before all others.
                match (x, y) {
                    (Some(x), Some(y)) => self.compare_uv(x, y),
                    _ => x.is_some().cmp(&y.is_some()),
                }
            });
        }
    }

    /// Two chains that can be merged, the smaller first.
    fn in_order<'a>(
        &self,
        a: &'a Chain<S::UMonotoneCurve>,
        b: &'a Chain<S::UMonotoneCurve>,
    ) -> Option<[&'a Chain<S::UMonotoneCurve>; 2]> {
        if self.is_vertical(a) != self.is_vertical(b) {
            return None;
        }
        [[a, b], [b, a]].into_iter().find(|[lower, upper]| {
            match (self.inner_end(lower, CurveEnd::Max), self.inner_end(upper, CurveEnd::Min)) {
                (Some(p), Some(q)) => self.pieces.is_same_point(p, q),
                _ => false,
            }
        })
    }
}

/// What two chains have in common, as far as it was found.
struct Common<'o, S: UMonotoneTraits> {
    traits: &'o S,
    /// Where the answer begins in `out`.
    from: usize,
    /// The pieces of an overlap that may go on.
    overlap: Vec<S::UMonotoneCurve>,
    out: &'o mut Vec<Intersection<S::Point, Chain<S::UMonotoneCurve>>>,
}

impl<S: UMonotoneTraits> Common<'_, S> {
    /// Adds what two pieces have in common: it is not before what was found, but may be there already.
    fn add(&mut self, intersection: Intersection<S::Point, S::UMonotoneCurve>, is_directed_right: bool) {
        match intersection {
            Intersection::Point(point, multiplicity) => {
                if self.overlap_end().is_some_and(|end| self.traits.is_same_point(end, &point)) {
                    return;
                }
                self.flush(is_directed_right);
                match self.out[self.from..].last_mut() {
                    Some(Intersection::Point(last, told)) if self.traits.is_same_point(last, &point) => {
                        *told = Multiplicity::Unknown;
                    }
                    _ => self.out.push(Intersection::Point(point, multiplicity)),
                }
            }
            Intersection::Overlap(curve) => {
                let start = self.traits.end_point(&curve, CurveEnd::Min);
                let is_start = |p: &S::Point| start.is_some_and(|start| self.traits.is_same_point(start, p));
                if !self.overlap_end().is_some_and(is_start) {
                    let is_told = match self.out[self.from..].last() {
                        Some(Intersection::Point(last, _)) => self.overlap.is_empty() && is_start(last),
                        _ => false,
                    };
                    if is_told {
                        self.out.pop();
                    }
                    self.flush(is_directed_right);
                }
                self.overlap.push(curve);
            }
        }
    }

    /// Where the overlap ends that may go on.
    fn overlap_end(&self) -> Option<&S::Point> {
        self.traits.end_point(self.overlap.last()?, CurveEnd::Max)
    }

    /// A joint of both chains: if they meet there, only their next pieces tell how.
    fn note_joint(&mut self, joint: Option<&S::Point>) {
        if let (Some(Intersection::Point(last, multiplicity)), Some(joint)) =
            (self.out[self.from..].last_mut(), joint)
            && self.traits.is_same_point(last, joint)
        {
            *multiplicity = Multiplicity::Unknown;
        }
    }

    /// The overlap, if there is one, does not go on.
    fn flush(&mut self, is_directed_right: bool) {
        if !self.overlap.is_empty() {
            let pieces = std::mem::take(&mut self.overlap);
            self.out.push(Intersection::Overlap(Chain::new(pieces, is_directed_right)));
        }
    }
}
