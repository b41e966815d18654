//! A model for tests: segments between rational points, with the plainest arithmetic and nothing kept.

use exact::{Rational, Sign};
use splitstar_arrangement::models::polycurve::{ConnectTraits, PieceTraits};
use splitstar_arrangement::traits::{
    ArrangementTraits, BasicTraits, BoundedTraits, CurveEnd, Intersection, Multiplicity, Piece,
    UMonotoneTraits,
};
use std::cmp::Ordering;
use std::fmt;

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Point {
    pub(crate) u: Rational,
    pub(crate) v: Rational,
}

impl fmt::Debug for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {})", self.u, self.v)
    }
}

pub(crate) fn point([u, v]: [i64; 2]) -> Point {
    Point { u: u.into(), v: v.into() }
}

/// A segment, its smaller end first.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Segment(pub(crate) [Point; 2]);

impl fmt::Debug for Segment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}--{:?}", self.0[0], self.0[1])
    }
}

pub(crate) fn segment(p: [i64; 2], q: [i64; 2]) -> Segment {
    let mut ends = [p, q].map(point);
    ends.sort();
    assert_ne!(ends[0], ends[1]);
    Segment(ends)
}

type Vector = [Rational; 2];

fn between(p: &Point, q: &Point) -> Vector {
    [&q.u - &p.u, &q.v - &p.v]
}

fn cross(a: &Vector, b: &Vector) -> Rational {
    &a[0] * &b[1] - &a[1] * &b[0]
}

impl Segment {
    fn direction(&self) -> Vector {
        between(&self.0[0], &self.0[1])
    }
}

#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct RationalSegments;

impl BasicTraits for RationalSegments {
    type Point = Point;
    type UMonotoneCurve = Segment;

    fn compare_u(&self, p: &Point, q: &Point) -> Ordering {
        p.u.cmp(&q.u)
    }

    fn compare_uv(&self, p: &Point, q: &Point) -> Ordering {
        p.cmp(q)
    }

    fn end_point<'a>(&self, curve: &'a Segment, end: CurveEnd) -> Option<&'a Point> {
        Some(&curve.0[end as usize])
    }

    fn is_vertical(&self, curve: &Segment) -> bool {
        curve.0[0].u == curve.0[1].u
    }

    fn compare_v_at_u(&self, p: &Point, curve: &Segment) -> Ordering {
        let Segment([min, max]) = curve;
        assert!(self.is_in_u_range(p, curve), "{p:?} is not in the u-range of {curve:?}");
        if self.is_vertical(curve) {
            return if p < min {
                Ordering::Less
            } else if p > max {
                Ordering::Greater
            } else {
                Ordering::Equal
            };
        }
        ordering(&cross(&between(min, max), &between(min, p)))
    }

    fn compare_v_at_u_right(&self, a: &Segment, b: &Segment, p: &Point) -> Ordering {
        assert!(self.is_on_curve(p, a) && self.is_on_curve(p, b) && p < &a.0[1] && p < &b.0[1]);
        ordering(&cross(&b.direction(), &a.direction()))
    }

    fn compare_v_at_u_left(&self, a: &Segment, b: &Segment, p: &Point) -> Ordering {
        assert!(self.is_on_curve(p, a) && self.is_on_curve(p, b) && p > &a.0[0] && p > &b.0[0]);
        ordering(&cross(&a.direction(), &b.direction()))
    }
}

fn ordering(value: &Rational) -> Ordering {
    match value.sign() {
        Sign::Negative => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Positive => Ordering::Greater,
    }
}

impl UMonotoneTraits for RationalSegments {
    fn intersect(&self, a: &Segment, b: &Segment, out: &mut Vec<Intersection<Point, Segment>>) {
        let (da, db, ab) = (a.direction(), b.direction(), between(&a.0[0], &b.0[0]));
        let (zero, one) = (Rational::from(0), Rational::from(1));
        match cross(&da, &db).recip() {
            None if cross(&da, &ab).is_zero() => {
                let (from, to) = (a.0[0].clone().max(b.0[0].clone()), a.0[1].clone().min(b.0[1].clone()));
                match from.cmp(&to) {
                    Ordering::Less => out.push(Intersection::Overlap(Segment([from, to]))),
                    Ordering::Equal => out.push(Intersection::Point(from, Multiplicity::Unknown)),
                    Ordering::Greater => {}
                }
            }
            None => {}
            Some(inverse) => {
                let [s, t] = [cross(&ab, &db) * &inverse, cross(&ab, &da) * &inverse];
                let is_in = |t: &Rational| zero <= *t && *t <= one;
                let is_inside = |t: &Rational| zero < *t && *t < one;
                if is_in(&s) && is_in(&t) {
                    let point = Point { u: &a.0[0].u + &s * &da[0], v: &a.0[0].v + &s * &da[1] };
                    let is_crossing = is_inside(&s) && is_inside(&t);
                    let told = if is_crossing { Multiplicity::Odd } else { Multiplicity::Unknown };
                    out.push(Intersection::Point(point, told));
                }
            }
        }
    }

    fn split(&self, curve: &Segment, p: &Point) -> [Segment; 2] {
        let Segment([min, max]) = curve;
        assert!(self.is_on_curve(p, curve) && min < p && p < max, "{p:?} is not inside {curve:?}");
        [Segment([min.clone(), p.clone()]), Segment([p.clone(), max.clone()])]
    }

    fn merge(&self, a: &Segment, b: &Segment) -> Option<Segment> {
        let is_line = cross(&a.direction(), &b.direction()).is_zero();
        match (a.0[1] == b.0[0], b.0[1] == a.0[0]) {
            (true, _) if is_line => Some(Segment([a.0[0].clone(), b.0[1].clone()])),
            (_, true) if is_line => Some(Segment([b.0[0].clone(), a.0[1].clone()])),
            _ => None,
        }
    }
}

impl ArrangementTraits for RationalSegments {
    type Curve = Segment;

    fn make_u_monotone(&self, curve: &Segment, out: &mut Vec<Piece<Point, Segment>>) {
        out.push(Piece::Curve { curve: curve.clone(), is_artificial: [false; 2] });
    }
}

impl BoundedTraits for RationalSegments {}
impl PieceTraits for RationalSegments {}

impl ConnectTraits for RationalSegments {
    fn connect(&self, source: &Point, target: &Point, out: &mut Vec<Piece<Point, Segment>>) {
        if source != target {
            let mut ends = [source.clone(), target.clone()];
            ends.sort();
            out.push(Piece::Curve { curve: Segment(ends), is_artificial: [false; 2] });
        }
    }
}
