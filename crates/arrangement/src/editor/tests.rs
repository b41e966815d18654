//! Curves one by one against all at once.

#![allow(clippy::print_stdout, reason = "a case that fails shows its seed")]

use super::*;
use crate::models::{Segment, SegmentTraits};
use crate::random::{Numbers, Scene, random_cylinder, random_lines, random_paths, random_segments};
use crate::topology::BoundedPlane;
use crate::traits::ArrangementTraits;
use crate::wrappers::CountingTraits;
use exact::planar::Point2;

/// Half of the points come before the curves.
fn check<G: ArrangementTraits<Point = Point2> + Clone, T: Topology<G>>(
    seeds: u64,
    most: i64,
    draw: impl Fn(&mut Numbers, i64) -> Scene<G, T>,
) {
    for seed in 1..seeds {
        println!("seed {seed}");
        let scene = draw(&mut Numbers::of_seed(seed), most);
        let mut editor = Editor::new(Arrangement::new(scene.traits.clone(), scene.topology.clone()));
        let (before, after) = scene.points.split_at(scene.points.len() / 2);
        for point in before {
            editor.insert_point(point);
        }
        for (i, curve) in scene.curves.iter().enumerate() {
            editor.insert_curve(curve);
            assert_eq!(editor.trapezoids.find_faults(&editor.arrangement), Vec::<String>::new());
            assert_eq!(editor.check_valid(), [], "after curve {i}");
        }
        for point in after {
            editor.insert_point(point);
        }
        assert_eq!(editor.check_valid(), []);
        let swept = scene.arrangement();
        assert_eq!(editor.counts(), swept.counts());
        assert!(editor.is_isomorphic(&swept));
    }
}

#[test]
fn segments() {
    check(200, 12, random_segments);
}

#[test]
fn lines_and_rays() {
    check(200, 10, random_lines);
}

#[test]
fn paths_on_a_torus() {
    check(400, 6, random_paths);
}

#[test]
fn paths_on_a_cylinder() {
    check(200, 6, random_cylinder);
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
