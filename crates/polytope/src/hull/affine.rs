//! The dimension of a point set.

use exact::predicate::plane_side;
use exact::{Sign, Vector3};

use super::sites::Sites;

/// The affine hull of a point set.
pub(super) enum Frame {
    /// All points equal this one.
    Point(u32),
    /// Collinear, not all equal.
    Line,
    /// Coplanar, not collinear; a normal of the plane.
    Plane(Vector3),
    /// The set spans space; four of its points that are not coplanar.
    Space([u32; 4]),
}

/// Finds the dimension of the set, with points far from each other where the approximations can tell.
///
/// # Complexity
/// O(n). Exact arithmetic on O(1) points if the approximations find an independent point where there is one.
pub(super) fn frame(sites: &Sites<'_>) -> Frame {
    let at = |p: u32| &sites.points[p as usize];
    let near = |p: u32| sites.approx[p as usize];

    let a = sites.best(|p| -p[0]);
    let far = sites.best(|p| norm2(sub(p, near(a))));
    let Some(b) = confirm(sites, far, |p| at(p) != at(a)) else {
        return Frame::Point(a);
    };

    let ab = at(a).direction_to(at(b));
    let along = sub(near(b), near(a));
    let far = sites.best(|p| norm2(cross(along, sub(p, near(a)))));
    let normal_with = |p: u32| ab.cross(&at(a).direction_to(at(p)));
    let Some(c) = confirm(sites, far, |p| !normal_with(p).is_zero()) else {
        return Frame::Line;
    };

    let normal = normal_with(c);
    let up = cross(along, sub(near(c), near(a)));
    let far = sites.best(|p| dot(up, sub(p, near(a))).abs());
    match confirm(sites, far, |p| plane_side(&normal, at(a), at(p)) != Sign::Zero) {
        Some(d) => Frame::Space([a, b, c, d]),
        None => Frame::Plane(normal),
    }
}

/// Returns `guess` if it is independent, otherwise the first point that is.
fn confirm(sites: &Sites<'_>, guess: u32, is_independent: impl Fn(u32) -> bool) -> Option<u32> {
    if is_independent(guess) {
        return Some(guess);
    }
    sites.distinct.iter().copied().find(|&p| is_independent(p))
}

pub(super) fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn norm2(a: [f64; 3]) -> f64 {
    dot(a, a)
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
