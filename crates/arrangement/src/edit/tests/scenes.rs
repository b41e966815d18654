//! Arrangements on all surfaces, made by the sweep.

use super::Rng;
use crate::arrangement::Arrangement;
use crate::models::{Linear, LinearTraits, Segment, SegmentTraits, TorusSegmentTraits};
use crate::topology::{BoundedPlane, FlatTorus, UnboundedPlane};
use exact::Rational;
use exact::planar::Point2;

pub(super) type Plane = Arrangement<SegmentTraits, BoundedPlane>;
pub(super) type WholePlane = Arrangement<LinearTraits, UnboundedPlane>;
pub(super) type Torus = Arrangement<TorusSegmentTraits, FlatTorus>;

pub(super) fn plane(segments: &[[i64; 4]], points: &[[i64; 2]]) -> Plane {
    let segment =
        |&[x, y, z, w]: &[i64; 4]| Segment::from_i64([[x, y], [z, w]]).expect("the ends are different");
    let segments: Vec<Segment> = segments.iter().map(segment).collect();
    let points = points.iter().map(|&point| Point2::from_i64(point));
    Arrangement::of_curves_and_points(SegmentTraits, BoundedPlane, &segments, points)
}

pub(super) fn random_plane(rng: &mut Rng) -> Plane {
    let range = [2, 3, 6][rng.below(3)];
    let segments: Vec<[i64; 4]> = (0..rng.below(11))
        .map(|_| [0; 4].map(|_| rng.within(range)))
        .filter(|[x, y, z, w]| [x, y] != [z, w])
        .collect();
    let points: Vec<[i64; 2]> = (0..rng.below(4)).map(|_| [0; 2].map(|_| rng.within(range))).collect();
    plane(&segments, &points)
}

pub(super) fn whole_plane(curves: &[(u8, [i64; 4])], points: &[[i64; 2]]) -> WholePlane {
    let curve = |&(shape, [x, y, z, w]): &(u8, [i64; 4])| {
        let [p, q] = [[x, y], [z, w]].map(Point2::from_i64);
        match shape {
            0 => Linear::segment(p, q),
            1 => Linear::ray(p, &q),
            _ => Linear::line(&p, &q),
        }
    };
    let curves: Vec<Linear> = curves.iter().filter_map(curve).collect();
    let points = points.iter().map(|&point| Point2::from_i64(point));
    Arrangement::of_curves_and_points(LinearTraits, UnboundedPlane, &curves, points)
}

pub(super) fn random_whole_plane(rng: &mut Rng) -> WholePlane {
    let range = [2, 3, 6][rng.below(3)];
    let curves: Vec<(u8, [i64; 4])> =
        (0..rng.below(9)).map(|_| (rng.below(3) as u8, [0; 4].map(|_| rng.within(range)))).collect();
    let points: Vec<[i64; 2]> = (0..rng.below(3)).map(|_| [0; 2].map(|_| rng.within(range))).collect();
    whole_plane(&curves, &points)
}

#[derive(Clone, Copy, Debug)]
pub(super) enum OnTorus {
    Closed([i64; 2], [i64; 2]),
    Path([i64; 2], [i64; 2]),
    Point([i64; 2]),
}

/// With periods 4 and 3.
pub(super) fn torus(curves: &[OnTorus]) -> Torus {
    let traits = TorusSegmentTraits::new([4.into(), 3.into()]).expect("the periods are positive");
    let (mut paths, mut points) = (Vec::new(), Vec::new());
    for curve in curves {
        match *curve {
            OnTorus::Closed(through, winding) => {
                let path = traits.closed_path(&Point2::from_i64(through), winding);
                paths.push(path.expect("the path is short"));
            }
            OnTorus::Path(start, by) => {
                let path = traits.path(&Point2::from_i64(start), &by.map(Rational::from));
                paths.push(path.expect("the path is short"));
            }
            OnTorus::Point(point) => points.push(traits.point(&Point2::from_i64(point))),
        }
    }
    Arrangement::of_curves_and_points(traits, FlatTorus, &paths, points)
}

pub(super) fn random_torus(rng: &mut Rng) -> Torus {
    let curves: Vec<OnTorus> = (0..rng.below(6))
        .map(|_| {
            let start = [0; 2].map(|_| rng.within(6));
            match rng.below(8) {
                0 => OnTorus::Point(start),
                1..4 => OnTorus::Closed(start, [0; 2].map(|_| rng.within(2))),
                4 => OnTorus::Path(start, [rng.within(6), 0]),
                5 => OnTorus::Path(start, [0, rng.within(6)]),
                _ => OnTorus::Path(start, [0; 2].map(|_| rng.within(6))),
            }
        })
        .collect();
    torus(&curves)
}
