//! Floats: parameters of points, points along arcs, and points near parameters. Pictures are made of them, and places from where to start;
//! nothing is decided by them. How far apart the points of a picture are is a matter of looks.

use super::{GeodesicArc, GeodesicTraits};
use crate::traits::{Along, ApproxTraits, CurveEnd, LandmarkTraits};
use exact::spherical::{Direction, Meridian, approx_angle, is_between};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The greatest step along u and v between points of a picture: two degrees.
const STEP: f64 = PI / 90.0;

/// Steps along the arc below this have no points between: beside a pole, floats do not tell the longitude there.
const RESOLVED: f64 = 1e-13;

/// Halvings of an arc after which its points are near enough, whatever their parameters are: it may pass close to a pole.
const MAX_HALVINGS: u32 = 40;

impl ApproxTraits for GeodesicTraits {
    /// Gives longitude and latitude in radians. The longitude of points on the identification and of the poles is zero.
    #[inline]
    fn approx_point(&self, p: &Direction) -> [f64; 2] {
        self.meridian().approx_f64(p)
    }

    /// The points are two degrees from each other at most, along u and along v. An end on the right side has the longitude 2 pi, and the poles have
    /// those of the meridians that come to them.
    fn approx_curve(
        &self,
        curve: &GeodesicArc,
        min: Option<&Direction>,
        max: Option<&Direction>,
        _: [f64; 4],
        out: &mut Vec<[f64; 2]>,
    ) {
        let ends = [(CurveEnd::Min, min), (CurveEnd::Max, max)].map(|(end, p)| {
            let own = curve.end(end);
            match p.filter(|p| *p != own) {
                Some(p) => (p, curve.inner_location().u),
                None => (own, curve.location(end).u),
            }
        });
        let [from, to] = ends.map(|(p, along)| {
            let [u, v] = self.approx_point(p);
            match along {
                Along::Low => [0.0, v],
                Along::Inside => [u, v],
                Along::High => [TAU, v],
            }
        });
        if curve.is_meridian() {
            let node = curve.circle().ascending_node();
            let [u, _] = node.map_or(from, |node| self.approx_point(&node));
            out.extend([from, to].map(|[_, v]| [u, v]));
            return;
        }
        let normal = curve.circle().pole().approx_f64();
        let [start, end] = ends.map(|(p, _)| p.approx_f64());
        let ahead = cross(normal, start);
        let angle = approx_angle([dot(start, end), dot(ahead, end)]);
        // Rounding may take an angle near to nothing, or to half a circle, to the other side of it.
        let [(p, _), (q, _)] = ends;
        let is_long = is_between(curve.circle(), p, &p.opposite(), q);
        let whole = match is_long {
            true if angle > FRAC_PI_2 => angle,
            true => angle + TAU,
            false if angle < -FRAC_PI_2 => angle + TAU,
            false => angle.max(0.0),
        };
        let course = Course { meridian: self.meridian(), u: [from[0], to[0].max(from[0])] };
        out.push(from);
        // Quarters of the circle, from which halvings need no angles.
        let [back, down] = [start, ahead].map(|vector| vector.map(|value| -value));
        let mut last = (start, from);
        for (quarter, vector) in (1_u32..).zip([ahead, back, down]) {
            if whole - f64::from(quarter) * FRAC_PI_2 < STEP {
                break;
            }
            let next = (vector, course.at(vector, last.1[0]));
            course.bisect([last, next], MAX_HALVINGS, out);
            last = next;
        }
        course.bisect([last, (end, to)], MAX_HALVINGS, out);
    }
}

/// What the points of an arc are made with.
struct Course<'m> {
    meridian: &'m Meridian,
    /// The least and the greatest u.
    u: [f64; 2],
}

impl Course<'_> {
    /// The parameters of a vector, not to the left of a u: the arc is u-monotone, but for rounding.
    fn at(&self, vector: [f64; 3], least: f64) -> [f64; 2] {
        let [u, v] = self.meridian.approx_of_floats(vector);
        let [low, high] = self.u;
        [u.clamp(low, high).max(least), v]
    }

    /// Appends the points after the first one up to the second one, at most a quarter of the circle further.
    fn bisect(&self, [a, b]: [([f64; 3], [f64; 2]); 2], halvings: u32, out: &mut Vec<[f64; 2]>) {
        let ((start, from), (end, to)) = (a, b);
        let is_near = (0..2).all(|i| (to[i] - from[i]).abs() <= STEP) && dot(start, end) > 0.5;
        if is_near || halvings == 0 {
            out.push(to);
            return;
        }
        let sum = [0, 1, 2].map(|i: usize| start[i] + end[i]);
        let length = dot(sum, sum).sqrt();
        let step = [0, 1, 2].map(|i: usize| end[i] - start[i]);
        // So near together, vectors do not tell where u is; and what rounding made nearly opposite has no middle.
        if dot(step, step) < RESOLVED * RESOLVED || length < 1.0 {
            out.push(to);
            return;
        }
        let middle = sum.map(|value| value / length);
        let [u, v] = self.at(middle, from[0]);
        let between = (middle, [u.min(to[0].max(from[0])), v]);
        self.bisect([a, between], halvings - 1, out);
        self.bisect([between, b], halvings - 1, out);
    }
}

fn cross([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> [f64; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

fn dot([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> f64 {
    ax * bx + ay * by + az * bz
}

impl LandmarkTraits for GeodesicTraits {
    /// Coordinates are rounded to multiples of 2^-32, so that nothing is known where a direction is so near to a pole.
    fn approx_to_point(&self, parameters: [f64; 2]) -> Option<Direction> {
        const SCALE: f64 = (1_u64 << 32) as f64;
        let [u, v] = parameters;
        if !u.is_finite() || !v.is_finite() {
            return None;
        }
        let ([a, b, _], (sine, cosine)) = (self.identification().approx_f64(), u.sin_cos());
        let (height, radius) = v.clamp(-FRAC_PI_2, FRAC_PI_2).sin_cos();
        // Turned from the identification.
        let vector = [(a * cosine - b * sine) * radius, (b * cosine + a * sine) * radius, height];
        let [x, y, z] = vector.map(|value| (value * SCALE).round() as i64);
        if x == 0 && y == 0 { None } else { Direction::from_i64([x, y, z]) }
    }
}
