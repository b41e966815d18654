//! Geodesic arcs with small integers, for pictures of spheres.

use arrangement::Arrangement;
use arrangement::models::{Geodesic, GeodesicTraits};
use arrangement::topology::Sphere;
use arrangement::traits::BasicTraits;
use cubical::{CubicalArrangement, CubicalPieces};

pub(crate) type Direction = <GeodesicTraits as BasicTraits>::Point;

pub(crate) fn direction(coordinates: [i64; 3]) -> Direction {
    Direction::from_i64(coordinates).expect("not zero")
}

/// The shorter arc.
pub(crate) fn arc(p: [i64; 3], q: [i64; 3]) -> Geodesic {
    Geodesic::arc(direction(p), direction(q)).expect("neither equal nor antipodal")
}

/// An arc through a third point.
pub(crate) fn via(p: [i64; 3], r: [i64; 3], q: [i64; 3]) -> Geodesic {
    Geodesic::arc_via(direction(p), &direction(r), direction(q)).expect("in one plane, in this order")
}

/// The great circle through two points.
pub(crate) fn circle(p: [i64; 3], q: [i64; 3]) -> Geodesic {
    Geodesic::circle(arc(p, q).great_circle().expect("an arc is on one").clone())
}

pub(crate) fn point(p: [i64; 3]) -> Geodesic {
    Geodesic::point(direction(p))
}

pub(crate) fn polygon(corners: &[[i64; 3]]) -> Vec<Geodesic> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&p, &q)| arc(p, q)).collect()
}

pub(crate) fn arrange(curves: &[Geodesic]) -> Arrangement<GeodesicTraits, Sphere> {
    Arrangement::of_curves(GeodesicTraits::new(), Sphere, curves)
}

pub(crate) fn sample() -> Arrangement<GeodesicTraits, Sphere> {
    arrange(&sample_curves())
}

pub(crate) fn on_cube(curves: &[Geodesic]) -> CubicalArrangement {
    let mut pieces = CubicalPieces::new();
    curves.iter().for_each(|curve| pieces.push_geodesic(curve));
    CubicalArrangement::of_pieces(pieces)
}

/// A triangle over the identification with another one in it; an arc through the north pole, and one that ends in the south pole; a
/// great circle, and an arc of more than half of one; isolated points, one of them on the identification.
pub(crate) fn sample_curves() -> Vec<Geodesic> {
    let mut curves = polygon(&[[-4, 3, 1], [-4, -3, 1], [-3, 0, 4]]);
    curves.extend(polygon(&[[-8, 1, 4], [-8, -1, 4], [-4, 0, 3]]));
    curves.extend([arc([1, 2, 4], [-1, -2, 4]), arc([3, -1, 2], [0, 0, -1])]);
    curves.extend([circle([1, 0, 0], [0, 3, -2]), via([3, 0, -1], [-3, -3, 2], [0, 3, -1])]);
    curves.extend([point([2, 2, 1]), point([-2, 0, -1])]);
    curves
}
