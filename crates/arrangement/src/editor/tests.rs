//! Curves one by one against all at once.

#![allow(clippy::print_stdout, reason = "a case that fails shows its seed")]

use super::*;
use crate::models::polycurve::PolycurveTraits;
use crate::models::{Linear, LinearTraits, Segment, SegmentTraits, TorusSegmentTraits};
use crate::topology::{BoundedPlane, FlatTorus, UnboundedPlane};
use crate::traits::ArrangementTraits;
use crate::wrappers::CountingTraits;
use exact::planar::Point2;

/// Numbers as good as random.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: i64) -> i64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound as u64) as i64
    }
}

fn check<G: ArrangementTraits<Point = Point2> + Clone, T: Topology<G>>(
    traits: G,
    topology: T,
    curves: &[G::Curve],
    points: &[Point2],
) {
    let mut editor = Editor::new(Arrangement::new(traits.clone(), topology.clone()));
    for (i, point) in points.iter().enumerate() {
        if i % 2 == 0 {
            editor.insert_point(point);
        }
    }
    for (i, curve) in curves.iter().enumerate() {
        editor.insert_curve(curve);
        assert_eq!(editor.trapezoids.find_faults(&editor.arrangement), Vec::<String>::new());
        assert_eq!(editor.check_valid(), [], "after curve {i}");
    }
    for (i, point) in points.iter().enumerate() {
        if i % 2 == 1 {
            editor.insert_point(point);
        }
    }
    assert_eq!(editor.check_valid(), []);
    let swept = Arrangement::of_curves_and_points(traits, topology, curves, points.iter().cloned());
    assert_eq!(editor.counts(), swept.counts());
    assert!(editor.is_isomorphic(&swept));
}

#[test]
fn segments() {
    for seed in 1..200 {
        println!("seed {seed}");
        let mut numbers = Numbers(seed * 0x1234_5678_9abc);
        let n = 1 + numbers.below(12);
        let size = 3 + numbers.below(6);
        let segments: Vec<Segment> = (0..n)
            .filter_map(|_| {
                let mut point = || [numbers.below(size), numbers.below(size)];
                Segment::from_i64([point(), point()])
            })
            .collect();
        let points = [[0, 0], [1, 1], [1, 2], [7, 1]].map(Point2::from_i64);
        check(SegmentTraits, BoundedPlane, &segments, &points);
    }
}

#[test]
fn lines_and_rays() {
    for seed in 1..200 {
        println!("seed {seed}");
        let mut numbers = Numbers(seed * 0x1234_5678_9abc);
        let n = 1 + numbers.below(10);
        let size = 2 + numbers.below(4);
        let curves: Vec<Linear> = (0..n)
            .filter_map(|_| {
                let mut point = || Point2::from_i64([numbers.below(size), numbers.below(size)]);
                let (p, q) = (point(), point());
                match numbers.below(3) {
                    0 => Linear::line(&p, &q),
                    1 => Linear::ray(p, &q),
                    _ => Linear::segment(p, q),
                }
            })
            .collect();
        let points = [[0, 0], [1, 1], [7, 1]].map(Point2::from_i64);
        check(LinearTraits, UnboundedPlane, &curves, &points);
    }
}

#[test]
fn paths_on_a_torus() {
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).expect("the periods are positive");
    for seed in 1..200 {
        println!("seed {seed}");
        let mut numbers = Numbers(seed * 0x1234_5678_9abc);
        let n = 1 + numbers.below(6);
        let paths: Vec<_> = (0..n)
            .filter_map(|_| {
                let start = Point2::from_i64([numbers.below(4), numbers.below(4)]);
                let way = [numbers.below(9) - 4, numbers.below(9) - 4].map(exact::Rational::from);
                traits.path(&start, &way).ok()
            })
            .collect();
        let points = [[0, 0], [1, 1], [0, 3]].map(Point2::from_i64);
        check(traits.clone(), FlatTorus, &paths, &points);
    }
}

/// What an adverse order costs: segments side by side, each above the one before, whose search structure would be a list.
#[test]
fn an_adverse_order_costs_less_than_linear_searches() {
    let calls = [500, 1_000, 2_000].map(|n: i64| {
        let mut editor = Editor::new(Arrangement::new(CountingTraits::new(SegmentTraits), BoundedPlane));
        for i in 0..n {
            editor.insert_curve(&Segment::from_i64([[i, i], [4 * n - i, i]]).expect("it is long"));
        }
        assert_eq!(editor.counts().edges, n as usize);
        editor.traits().counters().total()
    });
    println!("{calls:?}");
    // Linear searches would make four times as many of twice as many segments.
    assert!(calls.windows(2).all(|pair| pair[1] < 3 * pair[0] + pair[0] / 2), "{calls:?}");
    assert!(calls[2] < 2_000 * 2_000, "{calls:?}");
}

/// A chain may begin and end on the bottom, and not run along it.
#[test]
fn a_point_below_an_arc_from_the_bottom_to_the_bottom() {
    let inner = TorusSegmentTraits::new([6.into(), 4.into()]).expect("the periods are positive");
    let traits = PolycurveTraits::new(inner);
    let arc = traits.make_cover_polyline([[1, 0], [3, 1], [5, 0]].map(Point2::from_i64));
    let mut editor = Editor::new(Arrangement::new(traits, FlatTorus));
    editor.insert_curve(&arc.expect("there are vertices"));
    let point = Point2::from_i64([3, 0]);
    assert_eq!(editor.locate(&point), Cell::Face(editor.corner_face()));
    editor.insert_point(&point);
    assert_eq!(editor.counts().isolated, 1);
    assert_eq!(editor.check_valid(), []);
}
