//! A hemisphere as a disc.
//!
//! Faces are cut not at the horizon itself, but at a great circle that is turned against it by less than can be seen, and so that no
//! vertex is near it. So edges along the horizon and vertices on it are no special cases for faces. Edges and vertices are drawn in
//! both discs if they are as good as on the horizon.

use super::rim::{Boundary, Rim};
use super::view::Vector;
use crate::frame::Point;
use crate::trig::cos_sin_turns;

/// Turns the circle at which faces are cut, in radians.
const TILT: f64 = 1e-7;
/// What is no farther behind the horizon is drawn.
const NEAR: f64 = 1e-6;
/// The corners of the rim.
const CORNERS: u32 = 180;

/// One of the two discs.
#[derive(Debug)]
pub(super) struct Disc {
    centre: Point,
    /// 1 in front and -1 behind, where the axis to the right is the opposite one.
    sign: f64,
    /// Faces are cut where `z` plus this times `x` and `y` is zero.
    tilt: [f64; 2],
    rim: Rim,
}

impl Disc {
    /// The disc in front and the one behind, for vertices at some places.
    pub(super) fn pair<I: Iterator<Item = Vector>>(vertices: impl Fn() -> I) -> [Self; 2] {
        // Of some directions, by the golden angle, the one that keeps away from all vertices best.
        let mut best = ([TILT, 0.0], -1.0);
        for k in 0..8 {
            let (cos, sin) = cos_sin_turns(0.1 + 0.381_966 * f64::from(k));
            let tilt = [TILT * cos, TILT * sin];
            let nearest = vertices().map(|p| depth(p, tilt).abs()).fold(f64::INFINITY, f64::min);
            if nearest > best.1 {
                best = (tilt, nearest);
            }
        }
        [1.0, -1.0].map(|sign| {
            let centre = [-1.05 * sign, 0.0];
            let corners = (0..CORNERS).map(|k| {
                let (cos, sin) = cos_sin_turns(f64::from(k) / f64::from(CORNERS));
                [centre[0] + cos, centre[1] + sin]
            });
            Self { centre, sign, tilt: best.0, rim: Rim::new(centre, corners.collect()) }
        })
    }

    pub(super) fn rim(&self) -> &Rim {
        &self.rim
    }

    /// Where a point is drawn.
    pub(super) fn place(&self, [x, y, _]: Vector) -> Point {
        [self.centre[0] + self.sign * x, self.centre[1] + y]
    }

    /// Whether a point is in front of the disc, or as good as on its rim.
    pub(super) fn shows(&self, [.., z]: Vector) -> bool {
        self.sign * z >= -NEAR
    }

    /// The parts of a chain that the disc shows.
    pub(super) fn visible(&self, chain: &[Vector]) -> Vec<Vec<Point>> {
        let mut parts: Vec<Vec<Point>> = Vec::new();
        let mut part: Vec<Point> = Vec::new();
        let mut is_cut = false;
        for (i, &p) in chain.iter().enumerate() {
            if i > 0 && self.shows(chain[i - 1]) != self.shows(p) {
                let [z, before] = [p, chain[i - 1]].map(|[.., z]| self.sign * z + NEAR);
                part.push(self.on_rim(between(chain[i - 1], p, before / (before - z))));
                is_cut = true;
            }
            if self.shows(p) {
                part.push(self.place(p));
            }
            if !part.is_empty() && (!self.shows(p) || i + 1 == chain.len()) {
                // What only touches the rim is shown by the other disc.
                let [x, y] = part[0];
                let is_dot = part.iter().all(|q| (q[0] - x).abs() + (q[1] - y).abs() < 1e-3);
                if !(is_cut && is_dot) {
                    parts.push(std::mem::take(&mut part));
                }
                part.clear();
                is_cut = false;
            }
        }
        parts
    }

    /// Cuts a closed chain, which is on the boundary of a face.
    pub(super) fn add_cycle(&self, cycle: &[Vector], boundary: &mut Boundary) {
        let is_inside: Vec<bool> = cycle.iter().map(|&p| self.has(p)).collect();
        let count = cycle.len();
        let before = |i: usize| (i + count - 1) % count;
        let Some(first) = (0..count).find(|&i| is_inside[i] && !is_inside[before(i)]) else {
            if is_inside.first() == Some(&true) {
                boundary.loops.push(cycle.iter().map(|&p| self.place(p)).collect());
            }
            return;
        };
        let mut chain = Vec::new();
        for i in (0..count).map(|k| (first + k) % count) {
            let previous = before(i);
            match (is_inside[previous], is_inside[i]) {
                (false, true) => {
                    chain.extend([self.crossing(cycle[previous], cycle[i]), self.place(cycle[i])])
                }
                (true, true) => chain.push(self.place(cycle[i])),
                (true, false) => {
                    chain.push(self.crossing(cycle[i], cycle[previous]));
                    boundary.chains.push(std::mem::take(&mut chain));
                }
                (false, false) => {}
            }
        }
    }

    /// Whether faces have a point in this disc: every point is in one of the two.
    fn has(&self, p: Vector) -> bool {
        (depth(p, self.tilt) > 0.0) == (self.sign > 0.0)
    }

    /// Where the rim is between two points, the first of which is not in the disc. The same, to the last bit, for both halfedges of an
    /// edge.
    fn crossing(&self, out: Vector, inside: Vector) -> Point {
        let [from, to] = [out, inside].map(|p| depth(p, self.tilt));
        self.on_rim(between(out, inside, from / (from - to)))
    }

    /// The point of the rim in the direction of a point.
    fn on_rim(&self, [x, y, _]: Vector) -> Point {
        let length = (x * x + y * y).sqrt();
        if length > 0.0 { self.place([x / length, y / length, 0.0]) } else { self.place([1.0, 0.0, 0.0]) }
    }
}

/// How far a point is in front of the circle at which faces are cut.
fn depth([x, y, z]: Vector, tilt: [f64; 2]) -> f64 {
    z + (tilt[0] * x + tilt[1] * y)
}

fn between(p: Vector, q: Vector, t: f64) -> Vector {
    [0, 1, 2].map(|k| p[k] + t * (q[k] - p[k]))
}
