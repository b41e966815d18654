//! Walking along a curve through trapezoids, up to the first thing that it meets.

use crate::arrangement::Arrangement;
use crate::topology::{Site, Topology};
use crate::traits::{CurveEnd, Meeting, UMonotoneTraits, Window};
use crate::trapezoids::{RailId, Side, SiteId, TrapezoidId, Trapezoids, side};
use std::cmp::Ordering;

/// What a curve meets first.
#[derive(Clone, Debug)]
pub(crate) enum Hit<P> {
    /// A site: the curve passes through it, or ends there.
    Site { site: SiteId, is_end: bool },
    /// An edge, at a point of its interior through which the curve passes.
    Edge { rail: RailId, point: P },
    /// Nothing: it ends in a face, or on an edge.
    End { on: Option<RailId> },
}

/// A curve on its way through trapezoids.
pub(crate) struct Walk<'a, G: UMonotoneTraits, T> {
    arrangement: &'a Arrangement<G, T>,
    trapezoids: &'a Trapezoids<G>,
    curve: &'a G::UMonotoneCurve,
    end: Site<'a, G>,
    /// Where the walk began, or the last wall that it has passed, if that is no place on a side: there the curve and a rail that is below
    /// or above it for the first time became neighbours. To the left of it, the rail may not be.
    after: Option<&'a G::Point>,
    /// The trapezoid in which it is.
    at: TrapezoidId,
    /// The rails below and above the last trapezoids, and where the curve meets them next.
    meetings: [(RailId, Meeting<G::Point>); 2],
}

impl<'a, G: UMonotoneTraits, T: Topology<G>> Walk<'a, G, T> {
    /// A walk along `curve` that begins at `start`, a place on it, in the trapezoid `at`.
    pub(crate) fn new(
        arrangement: &'a Arrangement<G, T>,
        trapezoids: &'a Trapezoids<G>,
        curve: &'a G::UMonotoneCurve,
        start: &Site<'a, G>,
        at: TrapezoidId,
    ) -> Self {
        let end = Site::of_end(arrangement.topology(), arrangement.traits(), curve, CurveEnd::Max);
        let after = start.point().filter(|_| start.location.is_interior());
        let meetings = [(); 2].map(|()| (RailId::NONE, Meeting::Never));
        Self { arrangement, trapezoids, curve, end, after, at, meetings }
    }

    /// The trapezoid in which the walk is.
    pub(crate) fn at(&self) -> TrapezoidId {
        self.at
    }

    fn compare(&self, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
        self.arrangement.topology().compare_sites(self.arrangement.traits(), a, b)
    }

    /// Goes on to what the curve meets first. It does not run along an edge where the walk begins.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids on the way.
    pub(crate) fn run(&mut self) -> Hit<G::Point> {
        loop {
            let trapezoid = *self.trapezoids.trapezoid(self.at);
            self.meet(Side::Below, trapezoid.below);
            self.meet(Side::Above, trapezoid.above);
            let wall = (!trapezoid.right.is_none()).then_some(trapezoid.right);
            if let Some((rail, point)) = self.first_meeting() {
                let place = Site::interior(point);
                let is_before = |site: SiteId| {
                    self.compare(&place, &self.trapezoids.place(self.arrangement, site)).is_lt()
                };
                if wall.is_none_or(is_before) {
                    return Hit::Edge { rail, point: point.clone() };
                }
            }
            let beyond = wall
                .map(|site| (site, self.compare(&self.trapezoids.place(self.arrangement, site), &self.end)));
            let Some((site, order)) = beyond.filter(|(_, order)| order.is_le()) else {
                return Hit::End { on: self.rail_at_end([trapezoid.below, trapezoid.above]) };
            };
            let place = self.trapezoids.place(self.arrangement, site);
            let wall = match (order, side(self.arrangement, &place, self.curve)) {
                (Ordering::Equal, _) => return Hit::Site { site, is_end: true },
                (_, Ordering::Equal) => return Hit::Site { site, is_end: false },
                (_, Ordering::Greater) => Side::Below,
                (_, Ordering::Less) => Side::Above,
            };
            self.at = self.trapezoids.right_of(site)[wall as usize];
            self.after = place.point().filter(|_| place.location.is_interior());
        }
    }

    /// Finds where the curve meets the rail below or above next, unless that is known.
    fn meet(&mut self, side: Side, rail: RailId) {
        if self.meetings[side as usize].0 == rail {
            return;
        }
        let meeting = if rail.is_none() { Meeting::Never } else { self.ask(side, rail) };
        self.meetings[side as usize] = (rail, meeting);
    }

    fn ask(&self, side: Side, rail: RailId) -> Meeting<G::Point> {
        let rail = self.trapezoids.rail(rail);
        let other = &self.arrangement.curves()[rail.curve as usize];
        let max = self.trapezoids.place(self.arrangement, rail.ends[1]);
        let is_other_first = self.compare(&max, &self.end).is_lt();
        let first = if is_other_first { max } else { self.end };
        let (lower, upper) = match side {
            Side::Below => (other, self.curve),
            Side::Above => (self.curve, other),
        };
        // The lower one is the other one if that is below.
        let first_to_end = usize::from(is_other_first != (side == Side::Below));
        let until = first.point().filter(|_| first.location.is_interior());
        self.arrangement.traits().next_meeting(
            lower,
            upper,
            Window { after: self.after, until, first_to_end },
        )
    }

    /// The first point at which the curve meets the rail below or the one above, and that rail.
    fn first_meeting(&self) -> Option<(RailId, &G::Point)> {
        let point = |i: usize| match &self.meetings[i] {
            (rail, Meeting::At(point, _)) => Some((*rail, point)),
            _ => None,
        };
        match [point(0), point(1)] {
            [Some(p), Some(q)] => {
                Some(if self.arrangement.traits().compare_uv(p.1, q.1).is_gt() { q } else { p })
            }
            [p, q] => p.or(q),
        }
    }

    /// The rail on which the curve ends, if it does.
    fn rail_at_end(&self, rails: [RailId; 2]) -> Option<RailId> {
        rails.into_iter().filter(|rail| !rail.is_none()).find(|&rail| {
            let curve = &self.arrangement.curves()[self.trapezoids.rail(rail).curve as usize];
            side(self.arrangement, &self.end, curve).is_eq()
        })
    }
}
