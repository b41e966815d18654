//! Segments, rays and lines with small integers, for pictures of arrangements.

use std::cmp::Ordering;

use arrangement::topology::UnboundedPlane;
use arrangement::traits::{
    Along, ApproxTraits, BasicTraits, BoundaryTraits, CurveEnd, Intersection, Location, Multiplicity,
    NearBottomTopTraits, NearLeftRightTraits, OpenBottomTopTraits, OpenLeftRightTraits, UMonotoneTraits,
};
use arrangement::{Arrangement, Pieces};
use splitstar_render::{Frame, clip_line, clip_ray};

/// `x / w`, `y / w`, with positive `w`.
pub(crate) type Place = [i128; 3];

/// The part of the line `a x + b y = c` between its ends; `b` is positive, or it is zero and `a` is.
#[derive(Clone, Debug)]
pub(crate) struct Straight {
    line: [i128; 3],
    ends: [Option<Place>; 2],
}

/// A straight curve through two points; which of them are ends.
pub(crate) fn straight([px, py]: [i128; 2], [qx, qy]: [i128; 2], [p_ends, q_ends]: [bool; 2]) -> Straight {
    let (a, b) = (py - qy, qx - px);
    let sign = if b < 0 || (b == 0 && a < 0) { -1 } else { 1 };
    let line = [sign * a, sign * b, sign * (a * px + b * py)];
    let mut ends = [p_ends.then_some([px, py, 1]), q_ends.then_some([qx, qy, 1])];
    if [px, py] > [qx, qy] {
        ends.swap(0, 1);
    }
    Straight { line, ends }
}

#[derive(Clone, Debug)]
pub(crate) struct Straights;

fn compare_slopes(a: &Straight, b: &Straight) -> Ordering {
    (-a.line[0] * b.line[1]).cmp(&(-b.line[0] * a.line[1]))
}

/// Compares `a.line[2] / a.line[k]` with that of `b`.
fn compare_offsets(a: &Straight, b: &Straight, k: usize) -> Ordering {
    (a.line[2] * b.line[k]).cmp(&(b.line[2] * a.line[k]))
}

impl Straights {
    fn is_between(&self, p: &Place, curve: &Straight) -> bool {
        curve.ends[0].as_ref().is_none_or(|min| self.compare_uv(min, p).is_le())
            && curve.ends[1].as_ref().is_none_or(|max| self.compare_uv(p, max).is_le())
    }
}

impl BasicTraits for Straights {
    type Point = Place;
    type UMonotoneCurve = Straight;

    fn compare_u(&self, p: &Place, q: &Place) -> Ordering {
        (p[0] * q[2]).cmp(&(q[0] * p[2]))
    }

    fn compare_uv(&self, p: &Place, q: &Place) -> Ordering {
        self.compare_u(p, q).then((p[1] * q[2]).cmp(&(q[1] * p[2])))
    }

    fn end_point<'a>(&self, curve: &'a Straight, end: CurveEnd) -> Option<&'a Place> {
        curve.ends[end as usize].as_ref()
    }

    fn is_vertical(&self, curve: &Straight) -> bool {
        curve.line[1] == 0
    }

    fn compare_v_at_u(&self, p: &Place, curve: &Straight) -> Ordering {
        let [a, b, c] = curve.line;
        if b != 0 {
            return (a * p[0] + b * p[1] - c * p[2]).cmp(&0);
        }
        match &curve.ends {
            [Some(min), _] if self.compare_uv(p, min).is_lt() => Ordering::Less,
            [_, Some(max)] if self.compare_uv(p, max).is_gt() => Ordering::Greater,
            _ => Ordering::Equal,
        }
    }

    fn compare_v_at_u_right(&self, a: &Straight, b: &Straight, _: &Place) -> Ordering {
        match (self.is_vertical(a), self.is_vertical(b)) {
            (false, false) => compare_slopes(a, b),
            (a, b) => a.cmp(&b),
        }
    }

    fn compare_v_at_u_left(&self, a: &Straight, b: &Straight, _: &Place) -> Ordering {
        match (self.is_vertical(a), self.is_vertical(b)) {
            (false, false) => compare_slopes(b, a),
            (a, b) => b.cmp(&a),
        }
    }
}

impl BoundaryTraits for Straights {
    fn end_location(&self, curve: &Straight, end: CurveEnd) -> Location {
        let side = [Along::Low, Along::High][end as usize];
        match (&curve.ends[end as usize], self.is_vertical(curve)) {
            (Some(_), _) => Location::INTERIOR,
            (None, true) => Location { v: side, ..Location::INTERIOR },
            (None, false) => Location { u: side, ..Location::INTERIOR },
        }
    }
}

impl NearLeftRightTraits for Straights {
    fn compare_v_near_side(&self, a: &Straight, b: &Straight, end: CurveEnd) -> Ordering {
        let by_slope = compare_slopes(a, b);
        let near = if end == CurveEnd::Min { by_slope.reverse() } else { by_slope };
        near.then(compare_offsets(a, b, 1))
    }
}

impl NearBottomTopTraits for Straights {
    fn compare_u_near_end(&self, p: &Place, curve: &Straight, _: CurveEnd) -> Ordering {
        (p[0] * curve.line[0]).cmp(&(curve.line[2] * p[2]))
    }

    fn compare_u_of_ends(&self, a: (&Straight, CurveEnd), b: (&Straight, CurveEnd)) -> Ordering {
        compare_offsets(a.0, b.0, 0)
    }
}

impl OpenLeftRightTraits for Straights {}
impl OpenBottomTopTraits for Straights {}

impl UMonotoneTraits for Straights {
    fn intersect(&self, a: &Straight, b: &Straight, out: &mut Vec<Intersection<Place, Straight>>) {
        let ([a1, b1, c1], [a2, b2, c2]) = (a.line, b.line);
        let det = a1 * b2 - a2 * b1;
        if det == 0 {
            // The curves of the tests do not overlap.
            let shared = a.ends.iter().flatten().filter(|p| a2 * p[0] + b2 * p[1] == c2 * p[2]);
            let shared = shared.filter(|p| self.is_between(p, b));
            out.extend(shared.map(|&p| Intersection::Point(p, Multiplicity::Unknown)));
            return;
        }
        let p = [c1 * b2 - c2 * b1, a1 * c2 - a2 * c1, det].map(|c| c * det.signum());
        if self.is_between(&p, a) && self.is_between(&p, b) {
            out.push(Intersection::Point(p, Multiplicity::Unknown));
        }
    }

    fn split(&self, curve: &Straight, p: &Place) -> [Straight; 2] {
        let Straight { line, ends: [min, max] } = curve.clone();
        [Straight { line, ends: [min, Some(*p)] }, Straight { line, ends: [Some(*p), max] }]
    }
}

impl ApproxTraits for Straights {
    fn approx_point(&self, &[x, y, w]: &Place) -> [f64; 2] {
        [x as f64 / w as f64, y as f64 / w as f64]
    }

    fn approx_curve(
        &self,
        curve: &Straight,
        min: Option<&Place>,
        max: Option<&Place>,
        [left, bottom, right, top]: [f64; 4],
        out: &mut Vec<[f64; 2]>,
    ) {
        let window = Frame::new([left, bottom], [right, top]).expect("a window");
        let [a, b, c] = curve.line.map(|c| c as f64);
        let ends = [min.or(curve.ends[0].as_ref()), max.or(curve.ends[1].as_ref())];
        let direction = if curve.line[1] == 0 { [0.0, 1.0] } else { [b, -a] };
        let foot = [a * c / (a * a + b * b), b * c / (a * a + b * b)];
        match ends.map(|end| end.map(|p| self.approx_point(p))) {
            [Some(min), Some(max)] => out.extend([min, max]),
            [Some(min), None] => out.extend(clip_ray(&window, min, direction).into_iter().flatten()),
            [None, Some(max)] => {
                let back = direction.map(|c| -c);
                out.extend(clip_ray(&window, max, back).into_iter().flat_map(|[p, q]| [q, p]));
            }
            [None, None] => out.extend(clip_line(&window, foot, direction).into_iter().flatten()),
        }
    }
}

pub(crate) const LINE: [bool; 2] = [false, false];
pub(crate) const RAY: [bool; 2] = [true, false];
pub(crate) const SEGMENT: [bool; 2] = [true, true];

pub(crate) fn arrange(curves: Vec<Straight>, points: Vec<Place>) -> Arrangement<Straights, UnboundedPlane> {
    let mut pieces = Pieces::new();
    curves.into_iter().for_each(|curve| pieces.push_curve(curve));
    points.into_iter().for_each(|point| pieces.push_point(point));
    Arrangement::of_pieces(Straights, UnboundedPlane, pieces)
}

fn polygon(corners: &[[i128; 2]]) -> Vec<Straight> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&p, &q)| straight(p, q, SEGMENT)).collect()
}

/// A square in a square with an island in it, a triangle, lines and a ray, isolated points and one on a line.
pub(crate) fn sample() -> Arrangement<Straights, UnboundedPlane> {
    let mut curves = polygon(&[[0, 0], [12, 0], [12, 12], [0, 12]]);
    curves.extend(polygon(&[[3, 3], [9, 3], [9, 9], [3, 9]]));
    curves.extend(polygon(&[[5, 5], [7, 5], [6, 7]]));
    curves.extend(polygon(&[[16, 1], [22, 3], [17, 8]]));
    curves.push(straight([0, -3], [27, -1], LINE));
    curves.push(straight([13, 13], [20, 9], LINE));
    curves.push(straight([23, 0], [23, 1], LINE));
    curves.push(straight([18, 4], [24, 5], RAY));
    arrange(curves, vec![[1, 1, 1], [4, 4, 1], [27, 5, 1]])
}
