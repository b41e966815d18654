//! The rectangle of the plane that a picture shows.

use std::cmp::Ordering;

use crate::error::{RenderError, finite};

/// A point of the plane, `y` upwards.
pub type Point = [f64; 2];

/// A closed axis-parallel rectangle of the plane: what a picture shows. It may be a segment or a point.
///
/// All coordinates are finite, and none of the methods overflows, whatever the magnitudes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Frame {
    min: Point,
    max: Point,
}

impl Frame {
    /// The unit square, which is shown where there is nothing to show.
    pub const UNIT: Self = Self { min: [0.0, 0.0], max: [1.0, 1.0] };

    /// The rectangle between two corners.
    ///
    /// # Errors
    /// If a coordinate is not finite, or one of `min` is greater than that of `max`.
    pub fn new(min: Point, max: Point) -> Result<Self, RenderError> {
        finite("a coordinate of the frame", &[min[0], min[1], max[0], max[1]])?;
        if min[0] <= max[0] && min[1] <= max[1] {
            Ok(Self { min, max })
        } else {
            Err(RenderError::FrameTurnedOver)
        }
    }

    /// The least rectangle around some points; `None` if there are none. Points that are not finite are passed over.
    ///
    /// ```
    /// use splitstar_render::Frame;
    /// let frame = Frame::around([[2.0, 1.0], [-1.0, 5.0]]).expect("there are points");
    /// assert_eq!((frame.min(), frame.max()), ([-1.0, 1.0], [2.0, 5.0]));
    /// ```
    pub fn around(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        let mut points = points.into_iter().filter(|point| point.iter().all(|c| c.is_finite()));
        let first = points.next()?;
        Some(points.fold(Self { min: first, max: first }, |frame, point| frame.with_point(point)))
    }

    fn with_point(self, point: Point) -> Self {
        Self {
            min: [self.min[0].min(point[0]), self.min[1].min(point[1])],
            max: [self.max[0].max(point[0]), self.max[1].max(point[1])],
        }
    }

    /// The corner with the least coordinates.
    pub fn min(&self) -> Point {
        self.min
    }

    /// The corner with the greatest coordinates.
    pub fn max(&self) -> Point {
        self.max
    }

    /// The corners, counterclockwise from the least one.
    pub fn corners(&self) -> [Point; 4] {
        [self.min, [self.max[0], self.min[1]], self.max, [self.min[0], self.max[1]]]
    }

    /// Whether the point lies in the rectangle or on its boundary.
    pub fn contains(&self, point: Point) -> bool {
        (0..2).all(|axis| (self.min[axis]..=self.max[axis]).contains(&point[axis]))
    }

    /// The nearest point of the rectangle.
    pub(crate) fn clamp(&self, point: Point) -> Point {
        [0, 1].map(|axis| point[axis].clamp(self.min[axis], self.max[axis]))
    }

    /// The least rectangle around this one and another.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        self.with_point(other.min).with_point(other.max)
    }

    /// The rectangle with a margin on all sides: a fraction of its longer side, rounded up so that the new sides are
    /// multiples of a step 1, 2 or 5 times a power of ten. A rectangle that is a point becomes a square.
    ///
    /// A negative fraction, or one that is not a number, counts as zero; one above 10 as 10.
    ///
    /// ```
    /// use splitstar_render::Frame;
    /// let frame = Frame::new([0.0, 0.0], [97.0, 31.0])?.with_margin(0.05);
    /// assert_eq!((frame.min(), frame.max()), ([-6.0, -6.0], [102.0, 36.0]));
    /// # Ok::<(), splitstar_render::RenderError>(())
    /// ```
    #[must_use]
    pub fn with_margin(self, fraction: f64) -> Self {
        let fraction = if fraction >= 0.0 { fraction.min(10.0) } else { 0.0 };
        let frame = self.thickened();
        let [width, height] = frame.half_extent();
        let longer = 2.0 * width.max(height).min(f64::MAX / 8.0);
        let step = round_step(longer / 50.0);
        let margin = longer * fraction;
        let out = |value: f64, sign: f64| {
            let moved = value + sign * margin;
            let rounded = if sign < 0.0 { (moved / step).floor() } else { (moved / step).ceil() } * step;
            // Far from the origin a step may be lost in rounding, and near the limit it overflows.
            let best = if rounded.is_finite() { rounded } else { moved };
            best.clamp(-f64::MAX, f64::MAX)
        };
        let min = [0, 1].map(|axis| out(frame.min[axis], -1.0).min(frame.min[axis]));
        let max = [0, 1].map(|axis| out(frame.max[axis], 1.0).max(frame.max[axis]));
        Self { min, max }
    }

    /// Half of width and height: these do not overflow.
    pub(crate) fn half_extent(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.max[axis] / 2.0 - self.min[axis] / 2.0)
    }

    /// The point in the middle.
    pub(crate) fn middle(&self) -> Point {
        [0, 1].map(|axis| self.max[axis] / 2.0 + self.min[axis] / 2.0)
    }

    /// The rectangle itself, or a square around it if it is a point or as good as one.
    pub(crate) fn thickened(self) -> Self {
        let size = self.min.iter().chain(&self.max).fold(0.0_f64, |size, c| size.max(c.abs()));
        let [width, height] = self.half_extent();
        // Below that, or near the least positive double, there are no steps to show.
        if width.max(height) > (size * f64::EPSILON).max(1e-290) {
            return self;
        }
        let half = (size / 1_048_576.0).max(1.0);
        let middle = self.middle();
        Self { min: middle.map(|c| (c - half).max(-f64::MAX)), max: middle.map(|c| (c + half).min(f64::MAX)) }
    }

    /// The corners met when the boundary is walked counterclockwise from one of its points to another; none if they
    /// are on one side in that order. From a point to itself the way is empty.
    ///
    /// With it the part of an unbounded face in the frame is closed. Points off the boundary count as the nearest
    /// points of the rectangle; inner points as if on the right side.
    ///
    /// ```
    /// use splitstar_render::Frame;
    /// let way = Frame::UNIT.walk_boundary([0.5, 0.0], [0.0, 0.5]);
    /// assert_eq!(way, [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    /// ```
    pub fn walk_boundary(&self, from: Point, to: Point) -> Vec<Point> {
        let (start, end) = (self.place(self.clamp(from)), self.place(self.clamp(to)));
        let corners = self.corners();
        // The corner of index i ends side i - 1 and begins side i.
        let turns = if end.0 == start.0 && end.1 < start.1 { 4 } else { (end.0 + 4 - start.0) % 4 };
        let end_point = self.clamp(to);
        let is_end = |corner: &Point| corner.partial_cmp(&end_point) == Some(Ordering::Equal);
        (1..=turns).map(|k| corners[(start.0 + k) % 4]).filter(|corner| !is_end(corner)).collect()
    }

    /// The corners met when the boundary is walked counterclockwise from one of its points back to it.
    pub(crate) fn walk_around(&self, from: Point) -> Vec<Point> {
        let (start, _) = self.place(self.clamp(from));
        (1..=4).map(|k| self.corners()[(start + k) % 4]).collect()
    }

    /// Side (bottom, right, top, left) and how far along it, increasing counterclockwise.
    fn place(&self, point: Point) -> (usize, f64) {
        let [x, y] = point;
        if y <= self.min[1] && x < self.max[0] {
            (0, x)
        } else if y >= self.max[1] && x > self.min[0] {
            (2, -x)
        } else if x <= self.min[0] && y > self.min[1] {
            (3, -y)
        } else {
            (1, y)
        }
    }
}

/// The least of 1, 2, 5 times a power of ten that is not below `value`, which is positive.
///
/// The power comes from the decimal text, so that no logarithm of a platform decides it.
fn round_step(value: f64) -> f64 {
    let text = format!("{value:e}");
    let exponent = text.split_once('e').map_or("0", |(_, exponent)| exponent);
    let power: f64 = format!("1e{exponent}").parse().unwrap_or(1.0);
    [1.0, 2.0, 5.0]
        .into_iter()
        .map(|digit| digit * power)
        .find(|&step| step >= value)
        .unwrap_or(10.0 * power)
        .max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_round_and_not_below() {
        for (value, step) in
            [(1.0, 1.0), (1.94, 2.0), (2.5, 5.0), (6.0, 10.0), (0.03, 0.05), (3e-300, 5e-300)]
        {
            assert!((round_step(value) / step - 1.0).abs() < 1e-15, "{value}");
        }
    }

    #[test]
    fn points_become_squares() {
        for c in [0.0, 5e-324, 1e-310, 1e-200, 0.5, 1.0, 3.0, 1e6, 1e17, -1e300, f64::MAX, -f64::MAX] {
            let point = Frame::new([c, -c], [c, -c]).unwrap();
            for frame in [point.thickened(), point.with_margin(0.05)] {
                assert!(frame.contains([c, -c]), "{c}");
                let [width, height] = frame.half_extent();
                assert!(width > 0.0 && height > 0.0 && width.is_finite() && height.is_finite(), "{c}");
                assert!(frame.corners().iter().flatten().all(|c| c.is_finite()), "{c}");
            }
        }
    }

    #[test]
    fn margins_contain_at_any_magnitude() {
        for size in [1e-320, 1e-300, 1e-5, 1.0, 7.3, 1e9, 1e300, f64::MAX] {
            let frame = Frame::new([-size, 0.0], [size, 0.0]).unwrap();
            let wide = frame.with_margin(0.1);
            assert!(wide.contains([size, 0.0]) && wide.contains([-size, 0.0]));
            assert!(wide.corners().iter().flatten().all(|c| c.is_finite()), "{size}");
        }
    }

    #[test]
    fn boundary_walks_go_round_once() {
        let frame = Frame::new([0.0, 0.0], [4.0, 2.0]).unwrap();
        let [a, b, c, d] = frame.corners();
        assert_eq!(frame.walk_boundary([1.0, 0.0], [3.0, 0.0]), [] as [Point; 0]);
        assert_eq!(frame.walk_boundary([3.0, 0.0], [1.0, 0.0]), [b, c, d, a]);
        assert_eq!(frame.walk_boundary(a, c), [b]);
        assert_eq!(frame.walk_boundary(c, a), [d]);
        assert_eq!(frame.walk_boundary(a, a), [] as [Point; 0]);
        assert_eq!(frame.walk_boundary([4.0, 1.0], [0.0, 1.0]), [c, d]);
        assert_eq!(frame.walk_boundary([0.0, 1.0], [4.0, 1.0]), [a, b]);
    }

    #[test]
    fn bad_frames_are_refused() {
        assert_eq!(Frame::new([1.0, 0.0], [0.0, 1.0]), Err(RenderError::FrameTurnedOver));
        assert!(matches!(Frame::new([f64::NAN, 0.0], [0.0, 1.0]), Err(RenderError::NotFinite { .. })));
        assert_eq!(Frame::around([[f64::INFINITY, 0.0]]), None);
    }
}
