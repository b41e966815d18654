//! Single cases.

#![allow(clippy::print_stdout, reason = "a case that fails shows its seed")]

use crate::script::{Made, check};
use exact::planar::Point2;
use splitstar_arrangement::edit::Mirror;
use splitstar_arrangement::history::{ArrangementWithHistory, Input, InputId};
use splitstar_arrangement::models::polycurve::PolycurveTraits;
use splitstar_arrangement::models::{Segment, SegmentTraits, TorusSegmentTraits};
use splitstar_arrangement::topology::{BoundedPlane, FlatTorus, Topology};
use splitstar_arrangement::traits::ArrangementTraits;

fn p(u: i64, v: i64) -> Point2 {
    Point2::from_i64([u, v])
}

fn segment(a: [i64; 2], b: [i64; 2]) -> Segment {
    Segment::from_i64([a, b]).expect("the ends are different")
}

fn watched<G: ArrangementTraits + Clone, T: Topology<G>>(traits: G, topology: T) -> Made<G, T> {
    Made::with_observers(traits, topology, Mirror::new).expect("the mirror is new")
}

fn counts<G: ArrangementTraits + Clone, T: Topology<G>>(made: &Made<G, T>) -> [usize; 3] {
    check(made, "a row");
    let counts = made.counts();
    [counts.vertices, counts.edges, counts.faces]
}

#[test]
fn a_vertex_where_a_closed_curve_was_cut_becomes_artificial_again() {
    let traits = PolycurveTraits::new(SegmentTraits);
    let rhombus = traits.make_polyline([p(0, 0), p(2, 2), p(4, 0), p(2, -2), p(0, 0)]).unwrap();
    let through = traits.make_polyline([p(-1, 0), p(5, 0)]).unwrap();
    let mut made = watched(traits, BoundedPlane);
    made.insert(&rhombus);
    assert_eq!(counts(&made), [1, 1, 2]);
    let through = made.insert(&through);
    assert_eq!(counts(&made), [4, 5, 3]);
    made.remove(through);
    assert_eq!(counts(&made), [1, 1, 2]);
    let end = made.insert_point(&p(4, 0));
    assert_eq!(made.vertices().filter(|&v| made.is_artificial(v)).count(), 1);
    made.remove(end);
    assert_eq!(made.vertices().filter(|&v| made.is_artificial(v)).count(), 2);
    assert_eq!(counts(&made), [1, 1, 2]);
}

#[test]
fn a_point_keeps_its_vertex() {
    let mut made = watched(SegmentTraits, BoundedPlane);
    let a = made.insert(&segment([0, 0], [4, 0]));
    let twice = [made.insert_point(&p(2, 0)), made.insert_point(&p(2, 0))];
    assert_eq!(counts(&made), [3, 2, 1]);
    let vertex = made.points_of(twice[0]).next().unwrap();
    assert_eq!(made.curves_at(vertex), [a, twice[0], twice[1]]);
    made.remove(twice[0]);
    assert_eq!(counts(&made), [3, 2, 1]);
    made.remove(a);
    assert_eq!(counts(&made), [1, 0, 1]);
    let b = made.insert(&segment([1, 0], [3, 0]));
    assert_eq!(counts(&made), [3, 2, 1]);
    assert_eq!(made.remove(twice[1]), Some(Input::Point(p(2, 0))));
    assert_eq!(counts(&made), [2, 1, 1]);
    made.remove(b);
    assert_eq!(counts(&made), [0, 0, 1]);
}

#[test]
fn a_point_at_the_end_of_a_curve_stays_behind() {
    let mut made = watched(SegmentTraits, BoundedPlane);
    made.insert_point(&p(0, 0));
    let a = made.insert(&segment([0, 0], [4, 0]));
    made.remove(a);
    assert_eq!(counts(&made), [1, 0, 1]);
}

#[test]
fn a_curve_may_be_a_point() {
    let traits = PolycurveTraits::new(SegmentTraits);
    let [dot, line] = [vec![p(1, 0)], vec![p(0, 0), p(2, 0)]].map(|path| traits.make_polyline(path).unwrap());
    let mut made = watched(traits, BoundedPlane);
    let dot = made.insert(&dot);
    assert_eq!((counts(&made), made.points_of(dot).count(), made.edges_of(dot).count()), ([1, 0, 1], 1, 0));
    let line = made.insert(&line);
    assert_eq!(counts(&made), [3, 2, 1]);
    made.remove(dot);
    assert_eq!((counts(&made), made.edges_of(line).count()), ([2, 1, 1], 1));
}

#[test]
fn overlaps_lie_on_the_curves_that_are_left() {
    let mut made = watched(SegmentTraits, BoundedPlane);
    let long = made.insert(&segment([0, 0], [9, 0]));
    let short = made.insert(&segment([2, 0], [6, 0]));
    let cross = made.insert(&segment([4, 1], [4, -1]));
    let other = made.insert(&segment([4, 0], [7, 0]));
    assert_eq!(made.edges_of(long).count(), 5);
    let of = |made: &Made<_, _>| -> Vec<Vec<InputId>> {
        made.edges_of(long).map(|e| made.curves_of(e).collect()).collect()
    };
    let all = [vec![long], vec![long, short], vec![long, short, other], vec![long, other], vec![long]];
    assert_eq!(of(&made), all);
    made.remove(long);
    assert_eq!(counts(&made), [6, 5, 1]);
    for e in made.dcel().edges() {
        assert!(*made.curve_of(e).min() != p(0, 0), "nothing lies on a curve that was removed");
    }
    made.remove(cross);
    assert_eq!(counts(&made), [4, 3, 1]);
    made.remove(other);
    assert_eq!(counts(&made), [2, 1, 1]);
    assert_eq!(made.edges_of(short).count(), 1);
}

#[test]
fn a_polyline_that_returns_runs_twice_along_an_edge() {
    let traits = PolycurveTraits::new(SegmentTraits);
    let there_and_back = traits.make_polyline([p(0, 0), p(3, 0), p(1, 0)]).unwrap();
    let crossing = traits.make_polyline([p(2, 1), p(2, -1)]).unwrap();
    let mut made = watched(traits, BoundedPlane);
    let a = made.insert(&there_and_back);
    made.insert(&crossing);
    assert_eq!(made.edges_of(a).count(), 5);
    assert_eq!(counts(&made), [6, 5, 1]);
    for e in made.edges_of(a) {
        assert_eq!(made.curves_of(e).collect::<Vec<_>>(), [a]);
    }
    made.remove(a);
    assert_eq!(counts(&made), [2, 1, 1]);
}

#[test]
fn a_star_loses_its_rays() {
    let mut made = watched(SegmentTraits, BoundedPlane);
    let ends = [[2, 0], [2, 1], [1, 2], [0, 2], [-1, 2], [-2, -1]];
    let rays: Vec<_> = ends.iter().map(|&end| made.insert(&segment([0, 0], end))).collect();
    for (i, &ray) in rays.iter().enumerate() {
        let left = rays.len() - i;
        assert_eq!(counts(&made), [left + 1, left, 1]);
        made.remove(ray);
    }
    assert_eq!(counts(&made), [0, 0, 1]);
}

#[test]
fn a_closed_path_on_a_torus_is_whole_again() {
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).unwrap();
    let [a, b] = [[1, 0], [0, 1]].map(|way| traits.closed_path(&p(0, 0), way).unwrap());
    let mut made = watched(traits, FlatTorus);
    let [a, b] = [made.insert(&a), made.insert(&b)];
    assert_eq!(counts(&made), [1, 2, 1]);
    made.remove(a);
    assert_eq!((counts(&made), made.edges_of(b).count()), ([1, 1, 1], 1));
    made.remove(b);
    assert_eq!(counts(&made), [0, 0, 1]);
}

#[test]
fn ids_are_used_again() {
    let mut made = ArrangementWithHistory::of_curves(
        SegmentTraits,
        BoundedPlane,
        &[segment([0, 0], [2, 0]), segment([1, 0], [3, 0])],
    );
    assert_eq!(made.inputs().map(|(id, _)| id).collect::<Vec<_>>(), [InputId(0), InputId(1)]);
    assert_eq!(made.remove(InputId(2)), None);
    assert_eq!(made.remove(InputId(0)), Some(Input::Curve(segment([0, 0], [2, 0]))));
    assert_eq!((made.remove(InputId(0)), made.curve(InputId(0)), made.input_count()), (None, None, 1));
    assert_eq!(made.insert_curves(&[segment([2, 1], [2, -1])]), [InputId(0)]);
    assert_eq!(made.curve(InputId(0)), Some(&segment([2, 1], [2, -1])));
    assert_eq!(made.insert_curves(&[]), []);
    made.clear();
    assert_eq!((made.input_count(), made.dcel().edge_count()), (0, 0));
    assert_eq!(made.insert(&segment([0, 0], [2, 0])), InputId(0));
}

#[test]
fn an_observer_of_another_arrangement_is_refused() {
    let other = splitstar_arrangement::Arrangement::new(SegmentTraits, BoundedPlane);
    let made = Made::with_observers(SegmentTraits, BoundedPlane, |_| Mirror::new(&other));
    assert!(made.is_err());
}

/// Curves that end at one vertex or pass through it, and one by one go again.
#[test]
fn a_star_goes_curve_by_curve() {
    let mut rng = testkit::Rng::new(11);
    println!("seed 11");
    for _ in 0..4 {
        let around: Vec<[i64; 2]> = (-6..=6).map(|u| [u, 9]).chain((-6..=6).map(|u| [9, u])).collect();
        let rays = around.iter().flat_map(|&to| [segment([0, 0], to), segment([0, 0], to.map(|c| -c))]);
        let lines = around.iter().map(|&to| segment(to.map(|c| -2 * c), to.map(|c| 2 * c)));
        let mut curves: Vec<Segment> = rays.chain(lines).collect();
        rng.shuffle(&mut curves);
        let mut made = watched(SegmentTraits, BoundedPlane);
        let mut ids = made.insert_curves(&curves);
        rng.shuffle(&mut ids);
        for (i, id) in ids.into_iter().enumerate() {
            made.remove(id);
            check(&made, &format!("removal {i}"));
        }
        assert_eq!(made.vertices().count(), 0);
    }
}
