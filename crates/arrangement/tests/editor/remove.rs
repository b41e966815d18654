//! Edges and vertices go, until nothing is left; and come again when that is taken back.

#![allow(clippy::print_stdout, reason = "a case that fails shows its seed")]

use crate::scenes::{Law, Scene, check, for_all, take_back, watch};
use dcel::{EdgeId, EndFate};
use exact::planar::Point2;
use splitstar_arrangement::models::{Segment, SegmentTraits};
use splitstar_arrangement::topology::{BoundedPlane, Topology};
use splitstar_arrangement::traits::{ArrangementTraits, Intersection, Piece, UMonotoneTraits};
use splitstar_arrangement::{Arrangement, Editor};
use std::ops::Range;
use testkit::Rng;

struct EveryEdge;

impl Law for EveryEdge {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        let mut editor = watch(scene.sweep_all());
        check(&editor);
        let mut states = Vec::new();
        let mut edges: Vec<_> = editor.arrangement().dcel().edges().collect();
        rng.shuffle(&mut edges);
        for e in edges {
            states.push(editor.arrangement().clone());
            let fates = [0; 2].map(|_| if rng.one_in(6) { EndFate::Isolate } else { EndFate::Remove });
            editor.remove_edge_with(e, fates);
            check(&editor);
        }
        let isolated: Vec<_> = editor.arrangement().vertices().collect();
        for v in isolated {
            states.push(editor.arrangement().clone());
            assert_eq!(editor.remove_vertex(v), Ok(None));
            check(&editor);
        }
        assert_eq!(editor.arrangement().difference(&scene.empty()), None);
        take_back(&mut editor, states);
    }
}

#[test]
fn removing_every_edge_leaves_nothing() {
    for_all(&EveryEdge, 40, 1);
}

struct EveryVertex;

impl Law for EveryVertex {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        let mut editor = watch(scene.sweep_all());
        let mut states = Vec::new();
        let mut vertices: Vec<_> = editor.arrangement().vertices().collect();
        rng.shuffle(&mut vertices);
        for v in vertices {
            if !editor.arrangement().dcel().has_vertex(v) {
                continue;
            }
            let before = editor.arrangement().clone();
            let degree = before.dcel().degree(v);
            if rng.one_in(2) {
                let edges = editor.remove_vertex_with_edges(v).unwrap();
                assert!(edges.iter().all(|&e| !editor.arrangement().dcel().has_edge(e)));
            } else if let Err(needed) = editor.remove_vertex(v) {
                assert!(degree > 0 && needed.vertex == v, "{needed}");
                assert_eq!(before.stamp(), editor.arrangement().stamp(), "nothing is changed");
                continue;
            }
            assert!(!editor.arrangement().dcel().has_vertex(v));
            states.push(before);
            check(&editor);
        }
        take_back(&mut editor, states);
    }
}

#[test]
fn vertices_go_with_their_edges_or_without() {
    for_all(&EveryVertex, 40, 1000);
}

/// The edges on stored curves of these numbers: those of one curve that was inserted, but where it runs along an older one.
fn edges_on<G: UMonotoneTraits, T>(arrangement: &Arrangement<G, T>, curves: &Range<usize>) -> Vec<EdgeId>
where
    T: Topology<G>,
{
    let edges = arrangement.dcel().edges();
    edges.filter(|&e| curves.contains(&arrangement.support(e).index())).collect()
}

struct EveryCurve;

impl Law for EveryCurve {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        let mut editor = watch(scene.empty());
        let mut states = Vec::new();
        let mut inserted = Vec::new();
        // A curve that is a point has no edge.
        let has_edges = |curve: &&G::Curve| {
            let mut pieces = Vec::new();
            scene.traits.make_u_monotone(curve, &mut pieces);
            pieces.iter().all(|piece| matches!(piece, Piece::Curve { .. }))
        };
        for curve in scene.curves.iter().filter(has_edges) {
            states.push(editor.arrangement().clone());
            let first = editor.arrangement().curves().len();
            editor.insert_curve(curve);
            inserted.push(first..editor.arrangement().curves().len());
        }
        rng.shuffle(&mut inserted);
        for curves in inserted {
            let mut edges = edges_on(editor.arrangement(), &curves);
            if edges.is_empty() {
                continue;
            }
            rng.shuffle(&mut edges);
            let before = editor.arrangement().clone();
            let merged = editor.remove_edges(&edges);
            let (old, new) = (before.dcel(), editor.arrangement().dcel());
            assert!(edges.iter().all(|&e| !new.has_edge(e)));
            assert!(merged.iter().all(|m| old.has_edge(m.gone) && !new.has_edge(m.gone)));
            assert_eq!(new.edge_count() + edges.len() + merged.len(), old.edge_count());
            // What is no end of an edge that went stays.
            let is_touched = |v| old.around(v).any(|h| edges.contains(&h.edge_id()));
            assert!(old.vertices().all(|v| is_touched(v) || new.has_vertex(v)));
            states.push(before);
            check(&editor);
        }
        assert_eq!(editor.arrangement().difference(&scene.empty()), None);
        take_back(&mut editor, states);
    }
}

#[test]
fn removing_curve_by_curve_leaves_nothing() {
    for_all(&EveryCurve, 40, 2000);
}

/// Where no two curves overlap, what is left is the arrangement of the others.
#[test]
fn without_a_curve_it_is_as_if_that_had_not_come() {
    let mut rng = Rng::new(77);
    let (mut scenes, mut merges) = (0, 0);
    while scenes < 60 {
        let seed = rng.below(u64::MAX);
        let mut rng = Rng::new(seed);
        println!("seed {seed}");
        let mut point = || Point2::from_i64([rng.below(8) as i64, rng.below(8) as i64]);
        let curves: Vec<Segment> = (0..9).filter_map(|_| Segment::new(point(), point())).collect();
        let do_overlap = |a: &Segment, b: &Segment| {
            let mut common = Vec::new();
            SegmentTraits.intersect(a, b, &mut common);
            common.iter().any(|part| matches!(part, Intersection::Overlap(_)))
        };
        if (1..curves.len()).any(|i| curves[..i].iter().any(|other| do_overlap(other, &curves[i]))) {
            continue;
        }
        scenes += 1;
        let mut editor = watch(Arrangement::new(SegmentTraits, BoundedPlane));
        curves.iter().for_each(|curve| drop(editor.insert_curve(curve)));
        let mut left: Vec<usize> = (0..curves.len()).collect();
        rng.shuffle(&mut left);
        while let Some(i) = left.pop() {
            let edges = edges_on(editor.arrangement(), &(i..i + 1));
            merges += editor.remove_edges(&edges).len();
            check(&editor);
            let others =
                Arrangement::of_curves(SegmentTraits, BoundedPlane, left.iter().map(|&i| &curves[i]));
            assert_eq!(editor.arrangement().difference(&others), None);
        }
    }
    assert!(merges > 100, "{merges}");
}

fn cross() -> (Editor<SegmentTraits, BoundedPlane>, [Vec<EdgeId>; 2]) {
    let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    let edges = [[[0, 0], [4, 4]], [[0, 4], [4, 0]]]
        .map(|ends| editor.insert_curve(&Segment::from_i64(ends).unwrap()));
    (editor, edges)
}

#[test]
fn two_curves_that_meet_in_their_ends_stay_two() {
    let (mut editor, [_, second]) = cross();
    let v = editor.dcel().ends(second[0])[1];
    let [up, down] = [[[2, 2], [2, 5]], [[2, -1], [2, 2]]]
        .map(|ends| editor.insert_curve(&Segment::from_i64(ends).unwrap()));
    let diagonals: Vec<EdgeId> = editor.dcel().edges().filter(|e| ![up[0], down[0]].contains(e)).collect();
    assert_eq!(editor.remove_edges(&diagonals), []);
    assert!(editor.dcel().has_vertex(v) && editor.dcel().degree(v) == 2);
    assert!(editor.check_mergeable(v).is_ok(), "it could go");
}

#[test]
#[should_panic(expected = "edge 1 comes twice")]
fn an_edge_is_not_given_twice() {
    let (mut editor, _) = cross();
    editor.remove_edges(&[EdgeId(1), EdgeId(0), EdgeId(1)]);
}

#[test]
#[should_panic(expected = "edge 9 does not exist: only an edge is removed")]
fn an_edge_that_does_not_exist_is_not_removed() {
    let (mut editor, _) = cross();
    editor.remove_edges(&[EdgeId(0), EdgeId(9)]);
}
