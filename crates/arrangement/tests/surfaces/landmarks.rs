//! Landmarks where left and right are glued, and bottom and top are of all kinds: against the sweep, and against all edges one by one.

use crate::paths::{Curve, Made, make};
use crate::random::{SIZE, random_curves};
use crate::strip::{Band, Strip};
use crate::tables::KINDS;
use dcel::{EdgeId, VertexId};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::locate_by_sweep;
use splitstar_arrangement::location::{LandmarkGenerator, Landmarks, PointLocation, VerticalRay};
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::{BasicTraits, CurveEnd, SideKind};
use testkit::Rng;

/// Where an edge ends in the closed strip.
fn place_of(made: &Made<true>, e: EdgeId, end: CurveEnd) -> [Rational; 2] {
    let curve = made.curve_of(e);
    match made.point(made.dcel().ends(e)[end as usize]).map(Point2::coordinates) {
        None => curve.place(end).coordinates(),
        Some([u, v]) if end == CurveEnd::Max && u.is_zero() && !made.traits().is_vertical(curve) => {
            [SIZE[0].into(), v]
        }
        Some(at) => at,
    }
}

/// What a ray meets, by looking at everything.
fn first_on_ray(made: &Made<true>, point: &Point2, ray: VerticalRay) -> Cell {
    let [x, y] = point.coordinates();
    let mut found: Vec<(Rational, Cell)> = Vec::new();
    let way = |v: &Rational| match ray {
        VerticalRay::Up => v - &y,
        VerticalRay::Down => &y - v,
    };
    for v in made.vertices() {
        let at = made.point(v).map(Point2::coordinates);
        found.extend(at.filter(|at| at[0] == x).map(|at| (way(&at[1]), Cell::Vertex(v))));
    }
    for e in made.dcel().edges() {
        let [start, end] = CurveEnd::BOTH.map(|end| place_of(made, e, end));
        if start[0] != end[0] {
            if start[0] < x && x < end[0] {
                let slope = (&end[1] - &start[1]).checked_div(&(&end[0] - &start[0])).unwrap();
                found.push((way(&(&start[1] + &(slope * (&x - &start[0])))), Cell::Edge(e)));
            }
        } else if start[0] == x {
            let is_here = match ray {
                VerticalRay::Up => start[1] <= y && y < end[1],
                VerticalRay::Down => start[1] < y && y <= end[1],
            };
            if is_here {
                return Cell::Edge(e);
            }
        }
    }
    let ahead = found.into_iter().filter(|(way, _)| *way > Rational::from(0));
    if let Some((_, cell)) = ahead.min_by(|a, b| a.0.cmp(&b.0)) {
        return cell;
    }
    let [side, step] = match ray {
        VerticalRay::Up => [1, 1],
        VerticalRay::Down => [0, -1],
    };
    if made.traits().v[side as usize] == SideKind::Contracted {
        let poles = <Band as Topology<Strip<true>>>::side_vertices(made.topology());
        let pole = poles[2 + side as usize];
        if let Some(pole) = pole.map(VertexId).filter(|&v| made.dcel().degree(v) > 0) {
            return Cell::Vertex(pole);
        }
    }
    let step = Rational::new(step.into(), 16.into()).unwrap();
    locate_by_sweep(made, &[Point2::from_rationals(&[x, y + step])])[0]
}

#[test]
fn landmarks_serve_strips_of_all_kinds() {
    let generators = [
        LandmarkGenerator::Vertices,
        LandmarkGenerator::Grid { count: None },
        LandmarkGenerator::Halton { count: Some(5) },
        LandmarkGenerator::Random { count: Some(0), seed: 1 },
    ];
    let mut rng = Rng::new(11);
    for kinds in KINDS {
        for round in 0..12 {
            let curves = random_curves(&mut rng, kinds, 7);
            let made: Made<true> = make(SIZE, kinds, &curves);
            let home = |u: i64, v: i64| {
                let at = [u, v].map(|value| Rational::new(value.into(), 2.into()).unwrap());
                Point2::from_rationals(&at)
            };
            let grid = (0..2 * SIZE[0]).flat_map(|u| (0..=2 * SIZE[1]).map(move |v| home(u, v)));
            let mut queries: Vec<Point2> =
                grid.filter(|p| made.traits().point_of_place(p).as_ref() == Some(p)).collect();
            queries.extend(made.vertices().filter_map(|v| made.point(v).cloned()));
            let cells = locate_by_sweep(&made, &queries);
            for generator in generators {
                let landmarks = Landmarks::with_generator(&made, generator);
                for (p, cell) in queries.iter().zip(&cells) {
                    let context = format!("{kinds:?}, round {round}, {curves:?}, {generator:?}, {p}");
                    assert_eq!(landmarks.locate(&made, p), Ok(*cell), "{context}");
                    for ray in VerticalRay::BOTH {
                        let met = landmarks.shoot(&made, p, ray);
                        assert_eq!(met, Ok(first_on_ray(&made, p, ray)), "{context}, {ray:?}");
                    }
                }
            }
        }
    }
}

/// The curve comes to the corner, but not to the ray, which runs along the seam to the same corner.
#[test]
fn a_ray_to_an_open_corner_meets_no_curve_that_ends_there() {
    for (v, target, ray) in [(0, [5, 3], VerticalRay::Down), (SIZE[1], [5, 1], VerticalRay::Up)] {
        let kinds = [SideKind::Open; 2];
        let made: Made<true> = make(SIZE, kinds, &[Curve::Path([[0, v], target])]);
        let p = Point2::from_i64([0, 2]);
        let met = Landmarks::new(&made).shoot(&made, &p, ray);
        assert_eq!(met, Ok(locate_by_sweep(&made, &[p])[0]), "{ray:?}");
        assert!(matches!(met, Ok(Cell::Face(_))), "{ray:?}");
    }
}
