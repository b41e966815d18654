//! A model of one's own: circles of the taxicab metric, and arcs of them. `docs/write-your-own-curve.md` walks through it.

#![allow(missing_docs, unreachable_pub, reason = "the document explains what is not said here")]

use splitstar_arrangement::traits::{
    ArrangementTraits, BasicTraits, BoundedTraits, CurveEnd, Intersection, Multiplicity, Piece,
    UMonotoneTraits,
};
use std::cmp::Ordering;

/// A point with doubled coordinates: where curves with integer tips cross, these are integers.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Point {
    pub u: i64,
    pub v: i64,
}

/// A u-monotone curve: the part of v = tip.v + side |u - tip.u| between two ends. A V has side 1, a roof -1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Arc {
    tip: Point,
    side: i64,
    ends: [Point; 2],
}

impl Arc {
    fn new(tip: Point, side: i64, range: [i64; 2]) -> Self {
        let arc = Self { tip, side, ends: [tip; 2] };
        Self { ends: range.map(|u| arc.at(u)), ..arc }
    }

    fn at(&self, u: i64) -> Point {
        Point { u, v: self.tip.v + self.side * (u - self.tip.u).abs() }
    }
}

/// A curve as a user gives it, with plain coordinates. Any value is valid.
#[derive(Clone, Debug)]
pub enum Curve {
    /// All points (x, y) with |x - centre.x| + |y - centre.y| = radius.
    Circle { centre: [i32; 2], radius: u32 },
    /// A part of a V or of a roof between two abscissas.
    Arc { tip: [i32; 2], opens_up: bool, range: [i32; 2] },
}

#[derive(Clone, Copy, Debug, Default)]
pub struct TaxicabTraits;

impl BasicTraits for TaxicabTraits {
    type Point = Point;
    type UMonotoneCurve = Arc;

    fn compare_u(&self, p: &Point, q: &Point) -> Ordering {
        p.u.cmp(&q.u)
    }

    fn compare_uv(&self, p: &Point, q: &Point) -> Ordering {
        p.cmp(q)
    }

    fn end_point<'a>(&self, curve: &'a Arc, end: CurveEnd) -> Option<&'a Point> {
        Some(&curve.ends[end as usize])
    }

    fn is_vertical(&self, _: &Arc) -> bool {
        false
    }

    fn compare_v_at_u(&self, p: &Point, curve: &Arc) -> Ordering {
        p.v.cmp(&curve.at(p.u).v)
    }

    fn compare_v_at_u_right(&self, a: &Arc, b: &Arc, p: &Point) -> Ordering {
        a.at(p.u + 1).v.cmp(&b.at(p.u + 1).v)
    }

    fn compare_v_at_u_left(&self, a: &Arc, b: &Arc, p: &Point) -> Ordering {
        a.at(p.u - 1).v.cmp(&b.at(p.u - 1).v)
    }
}

impl BoundedTraits for TaxicabTraits {}

impl UMonotoneTraits for TaxicabTraits {
    fn intersect(&self, a: &Arc, b: &Arc, out: &mut Vec<Intersection<Point, Arc>>) {
        let (from, to) = (a.ends[0].u.max(b.ends[0].u), a.ends[1].u.min(b.ends[1].u));
        let (sum, rise) = (a.tip.u + b.tip.u, b.tip.v - a.tip.v);
        let mut breaks = vec![from, to, a.tip.u, b.tip.u, (sum + rise) / 2, (sum - rise) / 2];
        breaks.retain(|u| (from..=to).contains(u));
        breaks.sort_unstable();
        breaks.dedup();
        let gaps: Vec<i64> = breaks.iter().map(|&u| (a.at(u).v - b.at(u).v).signum()).collect();
        let mut first = 0;
        for run in gaps.chunk_by(|g, h| (*g, *h) == (0, 0)) {
            let next = first + run.len();
            if run.len() > 1 {
                out.push(Intersection::Overlap(Arc::new(a.tip, a.side, [breaks[first], breaks[next - 1]])));
            } else if run == [0] {
                let multiplicity = match (gaps[..first].last(), gaps.get(next)) {
                    (Some(g), Some(h)) if g == h => Multiplicity::Even,
                    (Some(_), Some(_)) => Multiplicity::Odd,
                    _ => Multiplicity::Unknown,
                };
                out.push(Intersection::Point(a.at(breaks[first]), multiplicity));
            }
            first = next;
        }
    }

    fn split(&self, curve: &Arc, p: &Point) -> [Arc; 2] {
        let [min, max] = curve.ends;
        [[min, *p], [*p, max]].map(|ends| Arc { ends, ..*curve })
    }

    fn merge(&self, a: &Arc, b: &Arc) -> Option<Arc> {
        let (left, right) = if a.ends[1] == b.ends[0] { (a, b) } else { (b, a) };
        let ends = (left.ends[1] == right.ends[0]).then_some([left.ends[0], right.ends[1]])?;
        let agree = |joined: &Arc, part: &Arc| {
            let [min, max] = part.ends.map(|end| end.u);
            [min, part.tip.u.clamp(min, max), max].iter().all(|&u| joined.at(u) == part.at(u))
        };
        [a, b].map(|&arc| Arc { ends, ..arc }).into_iter().find(|joined| agree(joined, a) && agree(joined, b))
    }
}

impl ArrangementTraits for TaxicabTraits {
    type Curve = Curve;

    fn make_u_monotone(&self, curve: &Curve, out: &mut Vec<Piece<Point, Arc>>) {
        let double = |[x, y]: [i32; 2]| [2 * i64::from(x), 2 * i64::from(y)];
        let mut push = |[u, v]: [i64; 2], side, range: [i64; 2], is_artificial| {
            let curve = Arc::new(Point { u, v }, side, range);
            out.push(match range[0] == range[1] {
                true => Piece::Point(curve.ends[0]),
                false => Piece::Curve { curve, is_artificial: [is_artificial; 2] },
            });
        };
        match *curve {
            Curve::Arc { tip, opens_up, range } => {
                let [x, y] = double(range);
                push(double(tip), if opens_up { 1 } else { -1 }, [x.min(y), x.max(y)], false);
            }
            Curve::Circle { centre, radius } => {
                let ([u, v], r) = (double(centre), 2 * i64::from(radius));
                for side in if r > 0 { [1, -1].iter() } else { [1].iter() } {
                    push([u, v - side * r], *side, [u - r, u + r], true);
                }
            }
        }
    }
}

// Optional: what makes the model quicker, and lets it be drawn.

use splitstar_arrangement::traits::{ApproxTraits, Meeting, Window};

/// A quicker `next_meeting`: in the impl it replaces the provided one.
pub fn next_meeting(below: &Arc, above: &Arc, window: Window<'_, Point>) -> Meeting<Point> {
    let (from, to) = (below.ends[0].u.max(above.ends[0].u), below.ends[1].u.min(above.ends[1].u));
    let from = window.after.map_or(from, |p| p.u);
    let mut straight_until = [below.tip.u, above.tip.u, to];
    straight_until.sort_unstable();
    for u in straight_until.into_iter().filter(|&u| from < u && u <= to) {
        // The gap changes by two in a step, or not at all.
        let gap = above.at(u).v - below.at(u).v;
        let meeting = u + gap / 2;
        match gap.signum() {
            1 => {}
            0 if meeting == to => return Meeting::AtEnd,
            0 => return Meeting::At(below.at(meeting), Multiplicity::Unknown),
            _ => return Meeting::At(below.at(meeting), Multiplicity::Odd),
        }
    }
    Meeting::Never
}

impl ApproxTraits for TaxicabTraits {
    fn approx_point(&self, p: &Point) -> [f64; 2] {
        [p.u as f64 / 2.0, p.v as f64 / 2.0]
    }

    fn approx_curve(
        &self,
        curve: &Arc,
        min: Option<&Point>,
        max: Option<&Point>,
        _: [f64; 4],
        out: &mut Vec<[f64; 2]>,
    ) {
        let (min, max) = (min.unwrap_or(&curve.ends[0]), max.unwrap_or(&curve.ends[1]));
        let tip = Some(&curve.tip).filter(|tip| min.u < tip.u && tip.u < max.u);
        out.extend([Some(min), tip, Some(max)].into_iter().flatten().map(|p| self.approx_point(p)));
    }
}

// Use.

use splitstar_arrangement::wrappers::{CountingTraits, Method};
use splitstar_arrangement::{Arrangement, overlay::Cell, topology::BoundedPlane};

pub fn main() {
    let circle = |x, radius| Curve::Circle { centre: [x, 0], radius };
    // Two circles that touch, and a point.
    let curves = [circle(0, 2), circle(4, 2), circle(9, 0)];
    let counted = Arrangement::of_curves(CountingTraits::new(TaxicabTraits), BoundedPlane, &curves);
    assert!(counted.traits().counters().count(Method::NextMeeting) > 0);
    let counts = counted.counts();
    assert_eq!((counts.vertices, counts.edges, counts.faces, counts.isolated), (2, 2, 3, 1));
    // The left and right corner of each circle, two of which are the same point, and the point of its own.
    assert_eq!(counted.counts_with_splits().vertices, 4);

    let mut arrangement = Arrangement::of_curves(TaxicabTraits, BoundedPlane, &curves);
    let roof = Curve::Arc { tip: [2, 2], opens_up: false, range: [0, 5] };
    let provenance = arrangement.insert_curves([&roof]);
    let counts = arrangement.counts();
    assert_eq!((counts.vertices, counts.edges, counts.faces, counts.isolated), (6, 8, 5, 1));
    let is_new = |e: &_| matches!(provenance.of_edge(*e), [Cell::Face(_)]);
    assert_eq!(arrangement.dcel().edges().filter(is_new).count(), 3);
}
