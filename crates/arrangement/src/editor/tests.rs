//! Curves one by one against all at once.

#![allow(clippy::print_stdout, reason = "a case that fails shows its seed")]

use super::*;
use crate::models::polycurve::PolycurveTraits;
use crate::models::{Segment, SegmentTraits, TorusSegmentTraits};
use crate::random::{
    Numbers, Scene, random_cylinder, random_globe, random_lines, random_paths, random_segments,
};
use crate::topology::{BoundedPlane, FlatTorus};
use crate::traits::ArrangementTraits;
use crate::wrappers::CountingTraits;
use exact::planar::Point2;

/// Half of the points come before the curves.
fn check<G: ArrangementTraits + Clone, T: Topology<G>>(
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

#[test]
fn arcs_on_a_sphere() {
    check(300, 7, random_globe);
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

/// Points in their order made the search structure a list, also when it was built anew.
#[test]
fn points_in_their_order_cost_less_than_linear_searches() {
    let calls = [500, 1_000, 2_000].map(|n: i64| {
        let mut editor = Editor::new(Arrangement::new(CountingTraits::new(SegmentTraits), BoundedPlane));
        for i in 0..n {
            editor.insert_point(&Point2::from_i64([i, 0]));
        }
        assert_eq!(editor.counts().isolated, n as usize);
        editor.traits().counters().total()
    });
    assert!(calls.windows(2).all(|pair| pair[1] < 3 * pair[0] + pair[0] / 2), "{calls:?}");
    assert!(calls[2] < 2_000 * 2_000, "{calls:?}");
}

/// Records that were given away and not taken back led to a panic in the middle of an edit.
#[test]
fn records_are_taken_back_in_their_order_or_not_at_all() {
    use crate::edit::Undo;
    let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
    let crossed = || {
        let empty = Arrangement::new(SegmentTraits, BoundedPlane);
        let undo = Undo::new(&empty);
        let mut editor = Editor::with_observers(empty, (undo.clone(), undo)).expect("both begin there");
        editor.insert_curve(&segment([[0, 0], [4, 4]]));
        editor.insert_curve(&segment([[0, 4], [4, 0]]));
        editor
    };
    let mut editor = crossed();
    drop(editor.observers_mut().0.pop());
    assert!(editor.observers_mut().0.pop().is_none(), "the way back is lost");

    let mut editor = crossed();
    drop(editor.observers_mut().0.pop());
    editor.insert_curve(&segment([[9, 0], [9, 1]]));
    let last = editor.observers_mut().0.pop().expect("it was recorded");
    assert_eq!(editor.take_back(last), Ok(()));
    assert!(editor.observers_mut().0.pop().is_none());
    assert_eq!((editor.check_valid(), editor.counts().edges), (vec![], 4));

    // The other recorder sees that somebody else took something back.
    let mut editor = crossed();
    let last = editor.observers_mut().0.pop().expect("it was recorded");
    assert_eq!(editor.take_back(last), Ok(()));
    assert!(editor.observers_mut().1.pop().is_none());
    let last = editor.observers_mut().0.pop().expect("it was recorded");
    assert_eq!(editor.take_back(last), Ok(()));
    assert_eq!(editor.counts().vertices, 0);

    // Out of date.
    let mut editor = crossed();
    let last = editor.observers_mut().0.pop().expect("it was recorded");
    editor.insert_point(&Point2::from_i64([7, 7]));
    assert!(editor.take_back(last).is_err());
    assert_eq!(editor.check_valid(), []);
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
