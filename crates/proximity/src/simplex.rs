//! The point of M closest to s without building M: a simplex of vertices of M that comes nearer.
//!
//! Each step finds the closest point of the simplex exactly, looks for the vertex of M that is extreme in the direction from
//! there to s, and keeps the vertices that span the closest point. The distance decreases strictly, and each closest point belongs to
//! one of finitely many simplices, so the search ends.
//!
//! # References
//! E. Gilbert, D. Johnson, S. Keerthi, "A fast procedure for computing the distance between complex objects in
//! three-dimensional space" (1988); here with exact decisions, and without their numerical test for the end.

use crate::bodies::{Bodies, Corner};
use crate::contact::Foot;
use exact::{Point3, Sign, Vector3, predicate};

/// Where M is closest to s.
#[derive(Clone, Debug)]
pub(crate) struct Nearest {
    /// Affinely independent; the closest point lies in the relative interior of their hull.
    pub(crate) corners: Vec<Corner>,
    /// From the closest point to s, some positive multiple; zero if M contains s.
    pub(crate) direction: Vector3,
    /// Known only of a point in a solid M, from the hull that has told the relation. If s lies in the boundary of M, it is the outer normal
    /// of a facet of M that contains s; if s lies in the interior, that of a facet of the hull, and of M only if the hull has grown so far.
    pub(crate) normal: Option<Vector3>,
}

impl Nearest {
    pub(crate) fn foot(&self, s: &Point3) -> Foot {
        if self.direction.is_zero() {
            let normal = self.normal.as_ref().unwrap_or(&self.direction);
            return Foot { point: s.coordinates(), normal: normal.clone() };
        }
        match &self.corners[..] {
            [a] => Foot::at(&a.at, s),
            [a, b] => Foot::on_line(&a.at.direction_to(&b.at), &a.at, s),
            [a, ..] => Foot::on_plane(&self.direction, &a.at, s),
            [] => unreachable!("a simplex has a vertex"),
        }
    }
}

/// Finds the point of M closest to s. If `is_far_enough`, it stops as soon as a plane separates s from M.
pub(crate) fn nearest(bodies: &Bodies<'_>, s: &Point3, start: [u32; 2], is_far_enough: bool) -> Nearest {
    let mut best = closest(&[bodies.corner(start)], s);
    loop {
        if best.direction.is_zero() {
            return best;
        }
        let last = best.corners.last().expect("a simplex has a vertex");
        let corner = bodies.corner(bodies.extreme(&best.direction, last.of));
        if predicate::plane_side(&best.direction, &last.at, &corner.at) != Sign::Positive {
            return best;
        }
        if is_far_enough && predicate::plane_side(&best.direction, &corner.at, s) == Sign::Positive {
            best.corners = vec![corner];
            return best;
        }
        best.corners.push(corner);
        best = closest(&best.corners, s);
    }
}

/// The least face of a simplex that contains its point closest to s. The last vertex belongs to it: the face of the others has
/// been the answer before, and the last vertex is nearer.
fn closest(corners: &[Corner], s: &Point3) -> Nearest {
    let (last, others) = corners.split_last().expect("a simplex has a vertex");
    let n = others.len();
    // Few vertices first, so that no barycentric coordinate is zero.
    for count in 0..=n {
        for chosen in (0_u32..1 << n).filter(|chosen| chosen.count_ones() as usize == count) {
            let is_chosen = |i: &usize| chosen >> i & 1 == 1;
            let mut face: Vec<&Corner> = (0..n).filter(is_chosen).map(|i| &others[i]).collect();
            face.push(last);
            let points: Vec<&Point3> = face.iter().map(|corner| &corner.at).collect();
            let Some(direction) = direction(&points, s) else { continue };
            let is_beyond =
                |i: usize| predicate::plane_side(&direction, &last.at, &others[i].at) == Sign::Positive;
            if direction.is_zero() || !(0..n).filter(|i| !is_chosen(i)).any(is_beyond) {
                let corners = face.into_iter().cloned().collect();
                return Nearest { corners, direction, normal: None };
            }
        }
    }
    unreachable!("one of the faces of a simplex contains its closest point")
}

/// The direction to s from the point of the hull of affinely independent points that is closest to s, if it lies in the relative
/// interior.
fn direction(points: &[&Point3], s: &Point3) -> Option<Vector3> {
    let is_acute = |a: &Vector3, b: &Vector3| predicate::same_direction(a, b) == Sign::Positive;
    match *points {
        [a] => Some(a.direction_to(s)),
        [a, b] => {
            let (edge, away) = (a.direction_to(b), a.direction_to(s));
            let is_inside = is_acute(&edge, &away) && is_acute(&edge, &s.direction_to(b));
            is_inside.then(|| edge.cross(&away).cross(&edge))
        }
        [a, b, c] => {
            let normal = a.direction_to(b).cross(&a.direction_to(c));
            let is_left = |a: &Point3, b: &Point3| {
                predicate::plane_side(&normal.cross(&a.direction_to(b)), a, s) == Sign::Positive
            };
            (is_left(a, b) && is_left(b, c) && is_left(c, a)).then(|| {
                match predicate::plane_side(&normal, a, s) {
                    Sign::Positive => normal.clone(),
                    Sign::Negative => -&normal,
                    Sign::Zero => Vector3::from_i64([0; 3]),
                }
            })
        }
        [a, b, c, d] => {
            let is_same_side = |[a, b, c]: [&Point3; 3], d: &Point3| {
                let normal = a.direction_to(b).cross(&a.direction_to(c));
                let side = predicate::plane_side(&normal, a, s);
                side != Sign::Zero && side == predicate::plane_side(&normal, a, d)
            };
            let is_inside = is_same_side([a, b, c], d)
                && is_same_side([b, c, d], a)
                && is_same_side([c, d, a], b)
                && is_same_side([d, a, b], c);
            is_inside.then(|| Vector3::from_i64([0; 3]))
        }
        _ => unreachable!("a simplex in space has at most four vertices"),
    }
}
