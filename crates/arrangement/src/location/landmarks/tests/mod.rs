//! Landmarks against the sweep, and rays against all edges one by one.

mod cases;

use super::*;
use crate::models::{LinearTraits, SegmentTraits, TorusSegmentTraits};
use crate::queries::locate_by_sweep;
use crate::random::{Numbers, Scene, random_cylinder, random_lines, random_paths, random_segments};
use crate::traits::{Along, ArrangementTraits};
use dcel::HalfedgeId;
use exact::Rational;
use exact::planar::{Line2, Point2};
use std::cmp::Ordering;

/// What an oracle has to know of a model.
trait Model: ArrangementTraits<Point = Point2> + LandmarkTraits + Clone {
    fn line(curve: &Self::UMonotoneCurve) -> &Line2;

    /// The size of the rectangle, if sides are identified.
    fn size(&self) -> Option<[Rational; 2]> {
        None
    }

    /// The same point as the model knows it.
    fn home(&self, p: Point2) -> Point2 {
        p
    }
}

impl Model for SegmentTraits {
    fn line(curve: &Self::UMonotoneCurve) -> &Line2 {
        curve.line()
    }
}

impl Model for LinearTraits {
    fn line(curve: &Self::UMonotoneCurve) -> &Line2 {
        curve.supporting_line()
    }
}

impl Model for TorusSegmentTraits {
    fn line(curve: &Self::UMonotoneCurve) -> &Line2 {
        curve.supporting_line()
    }

    fn size(&self) -> Option<[Rational; 2]> {
        Some(self.period().clone())
    }

    fn home(&self, p: Point2) -> Point2 {
        self.point(&p)
    }
}

const GENERATORS: [LandmarkGenerator; 6] = [
    LandmarkGenerator::Vertices,
    LandmarkGenerator::Grid { count: None },
    LandmarkGenerator::Random { count: None, seed: 7 },
    LandmarkGenerator::Halton { count: None },
    LandmarkGenerator::Halton { count: Some(1) },
    LandmarkGenerator::Random { count: Some(0), seed: 7 },
];

fn quotient(p: i64, q: i64) -> Rational {
    Rational::new(p.into(), q.into()).unwrap()
}

/// The place in the closed rectangle at which a halfedge begins; `None` at infinity.
fn start_of<G: Model, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    h: HalfedgeId,
) -> Option<[Rational; 2]> {
    let site = arrangement.start_site(h);
    let mut at = site.point()?.coordinates();
    if let Some(size) = arrangement.traits().size() {
        for (axis, along) in [site.location.u, site.location.v].into_iter().enumerate() {
            if along == Along::High {
                at[axis] += &size[axis];
            }
        }
    }
    Some(at)
}

/// What a ray meets, by looking at everything.
fn first_on_ray<G: Model, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    point: &Point2,
    ray: VerticalRay,
) -> Cell {
    let period = match arrangement.topology().sides().is_v_identified() {
        true => arrangement.traits().size().map(|[_, height]| height),
        false => None,
    };
    let zero = Rational::from(0);
    let [x, mut y] = point.coordinates();
    // On the seam a ray that goes down begins at the top.
    if let (Some(height), true, VerticalRay::Down) = (&period, y.is_zero(), ray) {
        y = height.clone();
    }
    // How far a ray goes to a v: nothing if it does not come there.
    let way = |v: &Rational| {
        let way = match ray {
            VerticalRay::Up => v - &y,
            VerticalRay::Down => &y - v,
        };
        match &period {
            _ if way > zero => Some(way),
            Some(height) => Some(way + height),
            None => None,
        }
    };
    let mut found: Vec<(Rational, Cell)> = Vec::new();
    for v in arrangement.vertices() {
        if let Some(at) = arrangement.point(v).map(Point2::coordinates)
            && at[0] == x
        {
            found.extend(way(&at[1]).map(|way| (way, Cell::Vertex(v))));
        }
    }
    for e in arrangement.dcel().edges() {
        let line = G::line(arrangement.curve_of(e));
        let [start, end] = [e.halfedge(), e.halfedge().twin()].map(|h| start_of(arrangement, h));
        let is_before = |at: &Option<[Rational; 2]>, axis: usize, value: &Rational, is: Ordering| {
            at.as_ref().is_none_or(|at| at[axis].cmp(value) == is)
        };
        let [a, b, c] = line.coefficients();
        if line.is_vertical() {
            let is_here = Rational::new(c, a).unwrap() == x;
            let (begins, ends) =
                (is_before(&start, 1, &y, Ordering::Less), is_before(&end, 1, &y, Ordering::Greater));
            let touches = match ray {
                VerticalRay::Up => begins || start.as_ref().is_some_and(|at| at[1] == y),
                VerticalRay::Down => begins,
            } && match ray {
                VerticalRay::Up => ends,
                VerticalRay::Down => ends || end.as_ref().is_some_and(|at| at[1] == y),
            };
            if is_here && touches {
                return Cell::Edge(e);
            }
        } else if is_before(&start, 0, &x, Ordering::Less) && is_before(&end, 0, &x, Ordering::Greater) {
            let [a, b, c] = [a, b, c].map(Rational::from);
            let v = (c - a * &x).checked_div(&b).unwrap();
            found.extend(way(&v).map(|way| (way, Cell::Edge(e))));
        }
    }
    // No edge is as near as a vertex at its end: only its interior counts.
    match found.into_iter().min_by(|a, b| a.0.cmp(&b.0)) {
        Some((_, cell)) => cell,
        None => {
            let step = match (&period, ray) {
                (Some(_), _) => zero,
                (None, VerticalRay::Up) => quotient(1, 16),
                (None, VerticalRay::Down) => quotient(-1, 16),
            };
            let beside = arrangement.traits().home(Point2::from_rationals(&[x, y + step]));
            locate_by_sweep(arrangement, &[beside])[0]
        }
    }
}

/// Points on a grid of quarters around and in a square, all vertices, and points on edges.
fn queries<G: Model, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    numbers: &mut Numbers,
    is_allowed: impl Fn(&[Rational; 2]) -> bool,
) -> Vec<Point2> {
    let mut at: Vec<[Rational; 2]> =
        (0..60).map(|_| [(); 2].map(|()| quotient(numbers.around(40), 4))).collect();
    at.extend((0..30).map(|_| [(); 2].map(|()| quotient(numbers.below(12), 2))));
    at.extend(arrangement.vertices().filter_map(|v| arrangement.point(v)).map(Point2::coordinates));
    for e in arrangement.dcel().edges() {
        let [start, end] = [e.halfedge(), e.halfedge().twin()].map(|h| start_of(arrangement, h));
        if let (Some(p), Some(q)) = (start, end) {
            let half = quotient(1, 2);
            let [x, y] = [0, 1].map(|axis| (&p[axis] + &q[axis]) * &half);
            // Above, on and below the middle.
            at.extend([-1, 0, 1].map(|step| [x.clone(), &y + &quotient(step, 3)]));
        }
    }
    let homes = at.iter().filter(|at| is_allowed(at));
    homes.map(|at| arrangement.traits().home(Point2::from_rationals(at))).collect()
}

#[track_caller]
fn agree<G: Model, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    queries: &[Point2],
    landmarks: &Landmarks,
    context: &str,
) {
    let cells = locate_by_sweep(arrangement, queries);
    for (p, cell) in queries.iter().zip(cells) {
        assert_eq!(landmarks.locate(arrangement, p), Ok(cell), "{context}, {p}");
        for ray in VerticalRay::BOTH {
            let expected = first_on_ray(arrangement, p, ray);
            assert_eq!(landmarks.shoot(arrangement, p, ray), Ok(expected), "{context}, {p} {ray:?}");
        }
    }
}

fn run<G: Model, T: Topology<G>>(
    seeds: u64,
    make: impl Fn(&mut Numbers) -> Scene<G, T>,
    is_allowed: impl Fn(&Arrangement<G, T>, &[Rational; 2]) -> bool,
) {
    for seed in 1..=seeds {
        let mut numbers = Numbers::of_seed(seed);
        let arrangement = make(&mut numbers).arrangement();
        let queries = queries(&arrangement, &mut numbers, |at| is_allowed(&arrangement, at));
        for generator in GENERATORS {
            let landmarks = Landmarks::with_generator(&arrangement, generator);
            agree(&arrangement, &queries, &landmarks, &format!("seed {seed}, {generator:?}"));
        }
    }
}

#[test]
fn segments() {
    run(60, |numbers| random_segments(numbers, 12), |_, _| true);
}

#[test]
fn lines() {
    run(60, |numbers| random_lines(numbers, 8), |_, _| true);
}

#[test]
fn paths_on_a_torus() {
    run(60, |numbers| random_paths(numbers, 6), |_, _| true);
}

#[test]
fn paths_on_cylinders() {
    run(
        60,
        |numbers| random_cylinder(numbers, 6),
        |arrangement, at| {
            // Between the sides that are not identified.
            let size = arrangement.traits().size().unwrap();
            let axis = usize::from(arrangement.topology().sides().is_u_identified());
            at[axis] > quotient(1, 8) && at[axis] < &size[axis] - &quotient(1, 8)
        },
    );
}
