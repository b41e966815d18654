//! Parameters of the sphere as points in space, as somebody sees them.

use super::outline::Outline;
use crate::error::{RenderError, finite};
use crate::frame::Point;
use crate::trig::cos_sin;

/// A point in space.
pub(super) type Vector = [f64; 3];

/// How a globe is drawn.
///
/// ```
/// use splitstar_render::{GlobeOptions, RenderError};
/// let from_north = GlobeOptions::default().with_view([0.0, 0.0, 1.0])?.with_graticule(false);
/// assert_eq!(from_north.view(), [0.0, 0.0, 1.0]);
/// assert_eq!(from_north.with_view([0.0; 3]), Err(RenderError::NoView));
/// # Ok::<(), RenderError>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct GlobeOptions {
    view: Vector,
    identification: [f64; 2],
    has_graticule: bool,
}

impl Default for GlobeOptions {
    /// Seen from (4, 2, 2); the identification is the half great circle through (-1, 0, 0); with graticule.
    fn default() -> Self {
        Self { view: [4.0, 2.0, 2.0], identification: [-1.0, 0.0], has_graticule: true }
    }
}

impl GlobeOptions {
    /// The same seen from another direction: the middle of the first disc. The second disc is seen from the opposite one. North is
    /// above the middle; seen from a pole, the axis of `x` points to the right in the first disc.
    ///
    /// # Errors
    /// If the direction is zero or not finite.
    pub fn with_view(self, view: [f64; 3]) -> Result<Self, RenderError> {
        unit(view).map(|_| Self { view, ..self })
    }

    /// The same with the identification, where u is zero, through another horizontal direction: that of the traits of the
    /// arrangement.
    ///
    /// # Errors
    /// If the direction is zero or not finite.
    pub fn with_identification(self, identification: [f64; 2]) -> Result<Self, RenderError> {
        let [x, y] = identification;
        unit([x, y, 0.0]).map(|_| Self { identification, ..self })
    }

    /// The same with or without meridians and parallels, 30 degrees apart.
    #[must_use]
    pub fn with_graticule(self, has_graticule: bool) -> Self {
        Self { has_graticule, ..self }
    }

    /// From where the first disc is seen.
    pub fn view(&self) -> [f64; 3] {
        self.view
    }

    /// The horizontal direction where u is zero.
    pub fn identification(&self) -> [f64; 2] {
        self.identification
    }

    /// Whether meridians and parallels are drawn.
    pub fn has_graticule(&self) -> bool {
        self.has_graticule
    }
}

/// The vector of length 1 with a direction, without overflow.
fn unit(vector: Vector) -> Result<Vector, RenderError> {
    finite("a direction", &vector)?;
    let greatest = vector.iter().fold(0.0_f64, |greatest, c| greatest.max(c.abs()));
    if greatest == 0.0 {
        return Err(RenderError::NoView);
    }
    let vector = vector.map(|c| c / greatest);
    let length = dot(vector, vector).sqrt();
    Ok(vector.map(|c| c / length))
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The sphere as it is seen: to the right, up, and towards who looks.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    axes: [Vector; 3],
    /// The direction where u is zero.
    identification: Vector,
}

/// No part of a chain is longer than this part of the radius.
const STEP: f64 = 0.05;

impl View {
    pub(super) fn new(options: &GlobeOptions) -> Result<Self, RenderError> {
        let toward = unit(options.view)?;
        let [x, y, _] = toward;
        // As good as a pole is a pole.
        let right = if x.abs().max(y.abs()) < 1e-9 { [1.0, 0.0, 0.0] } else { unit([-y, x, 0.0])? };
        let [x, y] = options.identification;
        Ok(Self { axes: [right, cross(toward, right), toward], identification: unit([x, y, 0.0])? })
    }

    /// Where a direction of space is seen.
    pub(super) fn seen(&self, direction: Vector) -> Vector {
        self.axes.map(|axis| dot(axis, direction))
    }

    /// Where the point with parameters u and v is seen.
    pub(super) fn place(&self, [u, v]: Point) -> Vector {
        let ((cos_u, sin_u), (cos_v, sin_v)) = (cos_sin(u), cos_sin(v));
        let [x, y, _] = self.identification;
        self.seen([cos_v * (cos_u * x - sin_u * y), cos_v * (cos_u * y + sin_u * x), sin_v])
    }

    /// An edge as it is seen, with points so close together that straight lines between them will do.
    pub(super) fn chain(&self, outline: &Outline) -> Vec<Vector> {
        let mut chain = Vec::new();
        for pair in outline.points.windows(2) {
            let [p, q] = [pair[0], pair[1]].map(|point| self.place(point));
            if chain.is_empty() {
                chain.push(p);
            }
            // Between opposite points, only the parameters tell the way.
            if squared_distance(p, q) > 3.99 {
                let middle = self.place([0, 1].map(|axis| (pair[0][axis] + pair[1][axis]) / 2.0));
                push_arc(&mut chain, p, middle);
                push_arc(&mut chain, middle, q);
            } else {
                push_arc(&mut chain, p, q);
            }
        }
        chain
    }
}

/// Appends points of the shorter arc from `p` to `q`, without `p`.
fn push_arc(chain: &mut Vec<Vector>, p: Vector, q: Vector) {
    let distance = squared_distance(p, q);
    if distance > STEP * STEP && distance < 3.999 {
        let sum = [p[0] + q[0], p[1] + q[1], p[2] + q[2]];
        let length = dot(sum, sum).sqrt();
        let middle = sum.map(|c| c / length);
        push_arc(chain, p, middle);
        push_arc(chain, middle, q);
    } else {
        chain.push(q);
    }
}

fn squared_distance(p: Vector, q: Vector) -> f64 {
    let between = [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    dot(between, between)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn view(from: Vector) -> View {
        View::new(&GlobeOptions::default().with_view(from).unwrap()).unwrap()
    }

    fn seen(from: Vector, point: Point) -> Vec<f64> {
        view(from).place(point).to_vec()
    }

    #[test]
    fn axes_are_exact_seen_along_axes() {
        let (front, north, south) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1e300], [0.0, 0.0, -5e-324]);
        assert_eq!(seen(front, [PI, 0.0]), [0.0, 0.0, 1.0], "the identification is behind");
        assert_eq!(seen(front, [1.5 * PI, 0.0]), [1.0, 0.0, 0.0]);
        assert_eq!(seen(front, [0.3, FRAC_PI_2]), [0.0, 1.0, 0.0]);
        assert_eq!(seen(north, [PI, 0.0]), [1.0, 0.0, 0.0]);
        assert_eq!(seen(north, [1.5 * PI, 0.0]), [0.0, 1.0, 0.0]);
        assert_eq!(seen(south, [1.5 * PI, 0.0]), [0.0, -1.0, 0.0]);
    }

    #[test]
    fn arcs_are_cut_in_short_parts_of_the_sphere() {
        let points = vec![[0.5, -FRAC_PI_2], [0.5, FRAC_PI_2]];
        let view = view([1.0, 2.0, 3.0]);
        let chain = view.chain(&Outline { points, ..Outline::default() });
        assert!(chain.len() > 60);
        for pair in chain.windows(2) {
            assert!(squared_distance(pair[0], pair[1]) <= STEP * STEP);
            assert!((dot(pair[0], pair[0]) - 1.0).abs() < 1e-12);
        }
        assert_eq!(chain[0].to_vec(), view.seen([0.0, 0.0, -1.0]));
    }
}
