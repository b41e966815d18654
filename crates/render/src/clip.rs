//! Cutting off at the frame: Liang and Barsky for segments, rays and lines, Sutherland and Hodgman for rings.
//!
//! All results lie in the frame, and none of the computations overflows. Coordinates that are not finite are the
//! caller's mistake; such pieces are left out.
//!
//! # References
//! Liang and Barsky, A new concept and method for line clipping, ACM Transactions on Graphics 3 (1984).
//! Sutherland and Hodgman, Reentrant polygon clipping, Communications of the ACM 17 (1974).

use crate::frame::{Frame, Point};

/// The part of the segment from `a` to `b` in the frame; `None` if there is none. It may be a point.
///
/// Laws: an end in the frame is an end of the result, unchanged; the direction is kept.
///
/// ```
/// use splitstar_render::{Frame, clip_segment};
/// assert_eq!(clip_segment(&Frame::UNIT, [-1.0, 0.5], [0.5, 0.5]), Some([[0.0, 0.5], [0.5, 0.5]]));
/// assert_eq!(clip_segment(&Frame::UNIT, [-1.0, 2.0], [2.0, 2.0]), None);
/// ```
pub fn clip_segment(frame: &Frame, a: Point, b: Point) -> Option<[Point; 2]> {
    if frame.contains(a) && frame.contains(b) {
        return Some([a, b]);
    }
    let direction = [0, 1].map(|axis| b[axis] / 2.0 - a[axis] / 2.0);
    let [enter, leave] = part_inside(frame, a, direction, [0.0, 1.0])?;
    let at = |cut: Cut| cut.on_frame(frame, [0, 1].map(|axis| between(a[axis], b[axis], cut.parameter)));
    let first = if frame.contains(a) { a } else { at(enter) };
    let last = if frame.contains(b) { b } else { at(leave) };
    Some([first, last])
}

/// The part in the frame of the ray from `source` in `direction`; `None` if there is none.
///
/// Degenerate: the direction zero gives the source alone, if it is in the frame.
pub fn clip_ray(frame: &Frame, source: Point, direction: Point) -> Option<[Point; 2]> {
    clip_unbounded(frame, source, direction, 0.0)
}

/// The part in the frame of the line through `point` along `direction`; `None` if there is none.
///
/// Degenerate: the direction zero gives the point alone, if it is in the frame.
pub fn clip_line(frame: &Frame, point: Point, direction: Point) -> Option<[Point; 2]> {
    clip_unbounded(frame, point, direction, f64::NEG_INFINITY)
}

fn clip_unbounded(frame: &Frame, point: Point, direction: Point, from: f64) -> Option<[Point; 2]> {
    let size = direction[0].abs().max(direction[1].abs());
    if size == 0.0 {
        return frame.contains(point).then_some([point, point]);
    }
    // The greater component becomes 1 or -1, so the parameters of its axis are finite.
    let direction = direction.map(|c| c / size);
    let [enter, leave] = part_inside(frame, point, direction, [from, f64::INFINITY])?;
    let at = |cut: Cut| {
        cut.on_frame(frame, [0, 1].map(|axis| 2.0 * (point[axis] / 2.0 + cut.parameter * direction[axis])))
    };
    let first = if from == 0.0 && frame.contains(point) { point } else { at(enter) };
    Some([first, at(leave)])
}

/// Where a line enters or leaves the frame.
#[derive(Clone, Copy, Debug)]
struct Cut {
    parameter: f64,
    /// The coordinate that is that of a side there; `None` at an end of the range.
    side: Option<(usize, f64)>,
}

impl Cut {
    /// The point, which was computed by rounding, where it must be: on the side, and in the frame.
    fn on_frame(self, frame: &Frame, mut point: Point) -> Point {
        if let Some((axis, bound)) = self.side {
            point[axis] = bound;
        }
        frame.clamp(point)
    }
}

/// The parameters within `range` for which half of `point` plus `t` times `direction` is in half the frame.
fn part_inside(frame: &Frame, point: Point, direction: Point, range: [f64; 2]) -> Option<[Cut; 2]> {
    let [mut enter, mut leave] = range.map(|parameter| Cut { parameter, side: None });
    for axis in 0..2 {
        let (low, high) = (frame.min()[axis], frame.max()[axis]);
        if direction[axis] == 0.0 {
            // The difference of two numbers next to each other may vanish when halved.
            if !(low / 2.0..=high / 2.0).contains(&(point[axis] / 2.0)) {
                return None;
            }
            continue;
        }
        let at = |bound: f64| Cut {
            parameter: (bound / 2.0 - point[axis] / 2.0) / direction[axis],
            side: Some((axis, bound)),
        };
        let (first, last) = if direction[axis] > 0.0 { (at(low), at(high)) } else { (at(high), at(low)) };
        if first.parameter > enter.parameter {
            enter = first;
        }
        if last.parameter < leave.parameter {
            leave = last;
        }
    }
    (enter.parameter <= leave.parameter).then_some([enter, leave])
}

/// The point of parameter `t` between two numbers, without overflow.
fn between(a: f64, b: f64, t: f64) -> f64 {
    a * (1.0 - t) + b * t
}

/// The parts of a polyline in the frame, in order. One point is a polyline.
///
/// # Complexity
/// Linear in the number of points.
pub fn clip_polyline(frame: &Frame, points: &[Point]) -> Vec<Vec<Point>> {
    if let [point] = points {
        return if frame.contains(*point) { vec![vec![*point]] } else { Vec::new() };
    }
    let mut parts: Vec<Vec<Point>> = Vec::new();
    let mut goes_on = false;
    for pair in points.windows(2) {
        let Some([first, last]) = clip_segment(frame, pair[0], pair[1]) else {
            goes_on = false;
            continue;
        };
        match parts.last_mut() {
            Some(part) if goes_on => part.push(last),
            _ => parts.push(vec![first, last]),
        }
        // Then the next part begins where this one ends.
        goes_on = frame.contains(pair[1]);
    }
    parts
}

/// The parts of a closed polyline in the frame, and whether it is still closed: then it is in the frame as a whole,
/// and the only part. Otherwise no part begins at the first point, unless it is on the boundary of the frame.
///
/// # Complexity
/// Linear in the number of points.
pub fn clip_closed_polyline(frame: &Frame, points: &[Point]) -> (Vec<Vec<Point>>, bool) {
    if points.iter().all(|&point| frame.contains(point)) {
        let parts = if points.is_empty() { Vec::new() } else { vec![points.to_vec()] };
        return (parts, true);
    }
    let closed: Vec<Point> = points.iter().chain(points.first()).copied().collect();
    let mut parts = clip_polyline(frame, &closed);
    // What runs through the first point is one part.
    if parts.len() > 1
        && parts[0].first() == points.first()
        && parts.last().and_then(|p| p.last()) == points.first()
    {
        let first = parts.remove(0);
        if let Some(last) = parts.last_mut() {
            last.extend(&first[1..]);
        }
    }
    (parts, false)
}

/// A ring cut off at the frame: what is in the frame has the same winding number with respect to the result.
///
/// Where the ring leaves the frame the result runs along the boundary of it. Empty if nothing is left.
///
/// # Complexity
/// Linear in the number of points.
pub fn clip_ring(frame: &Frame, ring: &[Point]) -> Vec<Point> {
    let mut points = ring.to_vec();
    for (axis, bound, sign) in [
        (0, frame.min()[0], 1.0),
        (0, frame.max()[0], -1.0),
        (1, frame.min()[1], 1.0),
        (1, frame.max()[1], -1.0),
    ] {
        if points.iter().all(|point| sign * point[axis] >= sign * bound) {
            continue;
        }
        points = clip_at(&points, axis, bound, sign);
    }
    points
}

/// The part of a ring where `sign * coordinate >= sign * bound`.
fn clip_at(ring: &[Point], axis: usize, bound: f64, sign: f64) -> Vec<Point> {
    let mut out = Vec::with_capacity(ring.len() + 4);
    let Some(&last) = ring.last() else { return out };
    let is_inside = |point: Point| sign * point[axis] >= sign * bound;
    let mut before = last;
    for &point in ring {
        if is_inside(before) != is_inside(point) {
            let t = (bound / 2.0 - before[axis] / 2.0) / (point[axis] / 2.0 - before[axis] / 2.0);
            // Next to the least positive double it may be zero over zero.
            let t = if t.is_nan() { 0.0 } else { t.clamp(0.0, 1.0) };
            let mut crossing = [0, 1].map(|k| between(before[k], point[k], t));
            crossing[axis] = bound;
            out.push(crossing);
        }
        if is_inside(point) {
            out.push(point);
        }
        before = point;
    }
    out
}
