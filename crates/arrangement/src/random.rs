//! Random curves on small grids, full of degenerate cases, for unit tests of all modules.

use crate::arrangement::Arrangement;
use crate::models::{
    Geodesic, GeodesicTraits, Linear, LinearTraits, Segment, SegmentTraits, TorusPath, TorusSegmentTraits,
};
use crate::topology::{BoundedPlane, FlatTorus, Site, Sphere, Topology, UnboundedPlane};
use crate::traits::{ArrangementTraits, BasicTraits, CurveEnd, Location, SideKind, Sides};
use exact::Rational;
use exact::planar::Point2;
use exact::spherical::{Direction, GreatCircle};
use std::cmp::Ordering;

/// Curves and points of one family, on a surface.
#[derive(Debug)]
pub(crate) struct Scene<G: ArrangementTraits, T> {
    pub(crate) traits: G,
    pub(crate) topology: T,
    pub(crate) curves: Vec<G::Curve>,
    pub(crate) points: Vec<G::Point>,
}

impl<G: ArrangementTraits + Clone, T: Topology<G>> Scene<G, T> {
    /// The arrangement of all, made by a sweep.
    pub(crate) fn arrangement(&self) -> Arrangement<G, T> {
        let Self { traits, topology, curves, points } = self;
        Arrangement::of_curves_and_points(traits.clone(), topology.clone(), curves, points.iter().cloned())
    }
}

/// Numbers as good as random.
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    pub(crate) fn of_seed(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x1234_5678_9abc))
    }

    pub(crate) fn below(&mut self, bound: i64) -> i64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound as u64) as i64
    }

    /// Between `-bound` and `bound`.
    pub(crate) fn around(&mut self, bound: i64) -> i64 {
        self.below(2 * bound + 1) - bound
    }

    pub(crate) fn point(&mut self, size: [i64; 2]) -> Point2 {
        Point2::from_i64(size.map(|size| self.below(size)))
    }

    /// A direction in space; often a pole, or on one of two half meridians.
    pub(crate) fn direction(&mut self, size: i64) -> Direction {
        let [x, y, z] = [0; 3].map(|_: i64| self.around(size));
        let vector = match self.below(8) {
            0 => [0, 0, if z < 0 { -1 } else { 1 }],
            1 => [-1 - x.abs(), 0, z],
            2 => [1, 0, z],
            _ if [x, y, z] == [0; 3] => [0, 0, 1],
            _ => [x, y, z],
        };
        Direction::from_i64(vector).expect("a direction is not zero")
    }

    pub(crate) fn some_points(&mut self, size: [i64; 2]) -> Vec<Point2> {
        (0..self.below(4)).map(|_| self.point(size)).collect()
    }
}

/// Segments and points on a small grid.
pub(crate) fn random_segments(numbers: &mut Numbers, most: i64) -> Scene<SegmentTraits, BoundedPlane> {
    let size = [3 + numbers.below(6); 2];
    let curves = (0..1 + numbers.below(most))
        .filter_map(|_| {
            let mut point = || size.map(|size| numbers.below(size));
            Segment::from_i64([point(), point()])
        })
        .collect();
    let points = numbers.some_points(size);
    Scene { traits: SegmentTraits, topology: BoundedPlane, curves, points }
}

/// Lines, rays, segments and points on a small grid.
pub(crate) fn random_lines(numbers: &mut Numbers, most: i64) -> Scene<LinearTraits, UnboundedPlane> {
    let size = [2 + numbers.below(4); 2];
    let curves = (0..1 + numbers.below(most))
        .filter_map(|_| {
            let (p, q) = (numbers.point(size), numbers.point(size));
            match numbers.below(3) {
                0 => Linear::line(&p, &q),
                1 => Linear::ray(p, &q),
                _ => Linear::segment(p, q),
            }
        })
        .collect();
    let points = numbers.some_points(size);
    Scene { traits: LinearTraits, topology: UnboundedPlane, curves, points }
}

/// A path on a torus: anywhere, along a seam, through the corner, or closed and not dividing.
fn random_path(traits: &TorusSegmentTraits, numbers: &mut Numbers, size: [i64; 2]) -> TorusPath {
    let way = |way: [i64; 2]| way.map(Rational::from);
    let start = numbers.point(size);
    let [x, y] = size.map(|size| numbers.below(size));
    let path = match numbers.below(6) {
        0 => traits.path(&Point2::from_i64([0, y]), &way([0, numbers.around(5)])),
        1 => traits.path(&Point2::from_i64([x, 0]), &way([numbers.around(5), 0])),
        2 => {
            let [a, b] = [numbers.around(2), numbers.around(2)];
            traits.path(&Point2::from_i64([a, b]), &way([-2 * a, -2 * b]))
        }
        3 => traits.closed_path(&start, [numbers.around(2), numbers.around(2)]),
        4 => traits.path(&Point2::from_i64([0, y]), &way([numbers.around(5), numbers.around(5)])),
        _ => traits.path(&start, &way([numbers.around(5), numbers.around(5)])),
    };
    path.expect("the path is short")
}

/// Paths and points on a torus, on a small grid.
pub(crate) fn random_paths(numbers: &mut Numbers, most: i64) -> Scene<TorusSegmentTraits, FlatTorus> {
    let size = [1 + numbers.below(4), 1 + numbers.below(4)];
    let traits = TorusSegmentTraits::new(size.map(Rational::from)).expect("the periods are positive");
    let n = numbers.below(most + 1);
    let curves = (0..n).map(|_| random_path(&traits, numbers, size)).collect();
    let points = numbers.some_points(size);
    Scene { traits, topology: FlatTorus, curves, points }
}

/// A torus of which one pair of sides is not glued: no curve reaches it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cylinder {
    is_u_identified: bool,
}

impl Topology<TorusSegmentTraits> for Cylinder {
    fn sides(&self) -> Sides {
        let [closed, identified] = [[SideKind::Closed; 2], [SideKind::Identified; 2]];
        match self.is_u_identified {
            true => Sides { u: identified, v: closed },
            false => Sides { u: closed, v: identified },
        }
    }

    fn genus(&self) -> u32 {
        0
    }

    fn end_location(
        &self,
        traits: &TorusSegmentTraits,
        curve: &<TorusSegmentTraits as BasicTraits>::UMonotoneCurve,
        end: CurveEnd,
    ) -> Location {
        FlatTorus.end_location(traits, curve, end)
    }

    fn point_location(&self, traits: &TorusSegmentTraits, point: &Point2) -> Location {
        FlatTorus.point_location(traits, point)
    }

    fn compare_sites(
        &self,
        traits: &TorusSegmentTraits,
        a: &Site<'_, TorusSegmentTraits>,
        b: &Site<'_, TorusSegmentTraits>,
    ) -> Ordering {
        FlatTorus.compare_sites(traits, a, b)
    }
}

/// Paths and points on a cylinder, on a small grid.
pub(crate) fn random_cylinder(numbers: &mut Numbers, most: i64) -> Scene<TorusSegmentTraits, Cylinder> {
    let cylinder = Cylinder { is_u_identified: numbers.below(2) == 0 };
    // Around and along.
    let size = [1 + numbers.below(4), 2 + numbers.below(4)];
    let turned = |[around, along]: [i64; 2]| match cylinder.is_u_identified {
        true => [around, along],
        false => [along, around],
    };
    let traits = TorusSegmentTraits::new(turned(size).map(Rational::from)).expect("the periods are positive");
    let place = |numbers: &mut Numbers| [numbers.below(size[0]), 1 + numbers.below(size[1] - 1)];
    let n = numbers.below(most + 1);
    let curves = (0..n)
        .map(|_| {
            let start = place(numbers);
            let through = Point2::from_i64(turned(start));
            let path = match numbers.below(4) {
                0 => traits.closed_path(&through, turned([1, 0])),
                1 => {
                    let along = [0, place(numbers)[1] - start[1]];
                    let on_seam = Point2::from_i64(turned([0, start[1]]));
                    traits.path(&on_seam, &turned(along).map(Rational::from))
                }
                _ => {
                    let way = [numbers.around(5), place(numbers)[1] - start[1]];
                    traits.path(&through, &turned(way).map(Rational::from))
                }
            };
            path.expect("the path is short")
        })
        .collect();
    let points = (0..numbers.below(4)).map(|_| Point2::from_i64(turned(place(numbers)))).collect();
    Scene { traits, topology: cylinder, curves, points }
}

/// An arc, shorter or longer than half a circle, or just half of one; all round with a vertex or without, and a part of a meridian.
fn random_geodesic(numbers: &mut Numbers, size: i64) -> Option<Geodesic> {
    let (p, q) = (numbers.direction(size), numbers.direction(size));
    let circle = GreatCircle::through(&p, &q);
    match numbers.below(12) {
        0 => circle.map(Geodesic::circle),
        1 => Geodesic::arc_via(p.clone(), &q, p.opposite()).ok(),
        2 => Geodesic::arc_around(p.clone(), p, circle?).ok(),
        3 | 4 => Geodesic::arc_around(p, q, circle?.opposite()).ok(),
        5 | 6 => {
            let [[x, y, _], [.., z]] = [p.coordinates(), q.coordinates()];
            Geodesic::arc(p, Direction::new([x, y, z])?).ok()
        }
        _ => Geodesic::arc(p, q).ok(),
    }
}

/// Arcs and points on a sphere, between few directions.
pub(crate) fn random_globe(numbers: &mut Numbers, most: i64) -> Scene<GeodesicTraits, Sphere> {
    const IDENTIFICATIONS: [[i64; 2]; 4] = [[-1, 0], [-1, 0], [0, 1], [2, -1]];
    let size = 1 + numbers.below(2);
    let identification = IDENTIFICATIONS[numbers.below(4) as usize].map(Into::into);
    let traits =
        GeodesicTraits::with_identification(identification).expect("the identification is not at a pole");
    let curves = (0..numbers.below(most + 1)).filter_map(|_| random_geodesic(numbers, size)).collect();
    let points = (0..numbers.below(4)).map(|_| numbers.direction(size)).collect();
    Scene { traits, topology: Sphere, curves, points }
}
