//! Edges are split and merged, and get other supports.

use crate::scenes::{Law, Scene, check, for_all, take_back, watch};
use exact::planar::Point2;
use splitstar_arrangement::models::{Linear, LinearTraits, Segment, SegmentTraits, TorusSegmentTraits};
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::{BoundedPlane, FlatTorus, Topology, UnboundedPlane};
use splitstar_arrangement::traits::ArrangementTraits;
use splitstar_arrangement::{Arrangement, Editor, VertexNeed};
use testkit::Rng;

struct SplitAndMerge;

impl Law for SplitAndMerge {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        // What the last curves meet are points to split edges at.
        let all = scene.sweep_all();
        let mut editor = watch(scene.sweep(scene.curves.len() / 2));
        let start = editor.arrangement().clone();
        let (mut states, mut made) = (Vec::new(), Vec::new());
        for v in all.vertices() {
            let point = all.point(v).unwrap();
            let Cell::Edge(e) = editor.locate(point) else { continue };
            let before = editor.arrangement().clone();
            let parts = editor.split_edge(e, point);
            let dcel = editor.arrangement().dcel();
            let [left, right] = parts.edges.map(|e| dcel.ends(e));
            assert_eq!((left[1], right[0]), (parts.vertex, parts.vertex));
            assert_eq!(parts.edges[0], e);
            check(&editor);
            let mut with_point = before.clone();
            with_point.insert_points([point.clone()]);
            assert_eq!(editor.arrangement().difference(&with_point), None);
            states.push(before);
            made.push(parts.vertex);
        }
        rng.shuffle(&mut made);
        for v in made {
            states.push(editor.arrangement().clone());
            editor.merge_edges(v).unwrap();
            check(&editor);
        }
        assert_eq!(editor.arrangement().difference(&start), None);
        take_back(&mut editor, states);
    }
}

#[test]
fn merging_takes_splitting_back() {
    for_all(&SplitAndMerge, 40, 2000);
}

struct OwnSupports;

impl Law for OwnSupports {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        let start = scene.sweep_all();
        let mut editor = watch(start.clone());
        let edges: Vec<_> = start.dcel().edges().collect();
        for e in edges {
            let curve = editor.arrangement().make_edge_curve(e);
            editor.modify_edge(e, curve);
            check(&editor);
        }
        for v in start.vertices() {
            let point = start.point(v).unwrap().clone();
            editor.modify_vertex(v, point);
        }
        check(&editor);
        assert_eq!(editor.arrangement().difference(&start), None);
        editor.compact();
        check(&editor);
        assert_eq!(editor.arrangement().curves().len(), editor.arrangement().dcel().edge_count());
        // Now supports are different at every vertex.
        let mut vertices: Vec<_> = editor.arrangement().vertices().collect();
        rng.shuffle(&mut vertices);
        for v in vertices {
            if editor.check_mergeable(v).is_ok() {
                let merged = editor.merge_edges(v).unwrap();
                assert!(!editor.arrangement().dcel().has_edge(merged.gone));
                check(&editor);
            }
        }
    }
}

#[test]
fn edges_on_supports_of_their_own_are_merged() {
    for_all(&OwnSupports, 40, 3000);
}

fn segment(ends: [[i64; 2]; 2]) -> Segment {
    Segment::from_i64(ends).unwrap()
}

fn p(u: i64, v: i64) -> Point2 {
    Point2::from_i64([u, v])
}

/// Why the vertex at a point cannot go.
fn need<G, T>(editor: &Editor<G, T>, point: &Point2) -> VertexNeed
where
    G: ArrangementTraits<Point = Point2>,
    T: Topology<G>,
{
    let Cell::Vertex(v) = editor.locate(point) else { panic!("{point:?} is no vertex") };
    let needed = editor.check_mergeable(v).unwrap_err();
    assert!(needed.to_string().contains(&format!("vertex {}", v.0)), "{needed}");
    needed.reason
}

#[test]
fn every_reason_to_stay_is_told() {
    let curves = [[[0, 0], [2, 0]], [[2, 0], [4, 1]], [[0, 0], [3, 5]], [[2, 2], [5, 2]]].map(segment);
    let plane = Arrangement::of_curves_and_points(SegmentTraits, BoundedPlane, &curves, [p(9, 9)]);
    let editor = Editor::new(plane);
    assert_eq!(need(&editor, &p(9, 9)), VertexNeed::Degree(0));
    assert_eq!(need(&editor, &p(4, 1)), VertexNeed::Degree(1));
    assert_eq!(need(&editor, &p(0, 0)), VertexNeed::Turn);
    assert_eq!(need(&editor, &p(2, 0)), VertexNeed::Curves);

    let line = Linear::line(&p(0, 0), &p(1, 1)).unwrap();
    let mut editor = Editor::new(Arrangement::of_curves(LinearTraits, UnboundedPlane, &[line]));
    let infinity = editor.dcel().vertices().next().unwrap();
    assert_eq!(editor.remove_vertex(infinity).unwrap_err().reason, VertexNeed::Side);
    assert_eq!(editor.remove_vertex_with_edges(infinity).unwrap_err().reason, VertexNeed::Side);
    assert_eq!(editor.check_mergeable(infinity).unwrap_err().reason, VertexNeed::Side);

    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).unwrap();
    let around = traits.closed_path(&p(0, 1), [1, 0]).unwrap();
    let across = traits.path(&p(3, 3), &[2.into(), 0.into()]).unwrap();
    let editor = Editor::new(Arrangement::of_curves(traits, FlatTorus, &[around, across]));
    assert_eq!(need(&editor, &p(0, 1)), VertexNeed::Loop);
    assert_eq!(need(&editor, &p(0, 3)), VertexNeed::Seam);
}

#[test]
fn edges_become_a_closed_one() {
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).unwrap();
    let around = traits.closed_path(&p(0, 1), [1, 0]).unwrap();
    let mut editor = watch(Arrangement::of_curves(traits, FlatTorus, &[around]));
    let e = editor.arrangement().dcel().edges().next().unwrap();
    let parts = editor.split_edge(e, &p(2, 1));
    check(&editor);
    editor.merge_edges(parts.vertex).unwrap();
    check(&editor);
    let [min, max] = editor.arrangement().dcel().ends(e);
    assert_eq!(min, max);
}

#[test]
#[cfg(debug_assertions)]
#[should_panic(expected = "the curve covers edge 0")]
fn a_curve_that_does_not_cover_an_edge_is_refused() {
    let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    let e = editor.insert_disjoint(segment([[0, 0], [4, 0]]));
    editor.modify_edge(e, segment([[1, 0], [5, 0]]));
}

#[test]
#[cfg(debug_assertions)]
#[should_panic(expected = "the point lies in the interior of edge 0")]
fn an_edge_is_not_split_elsewhere() {
    let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    let e = editor.insert_disjoint(segment([[0, 0], [4, 0]]));
    editor.split_edge(e, &p(2, 1));
}

#[test]
#[should_panic(expected = "edge 0 does not exist: only an edge is removed")]
fn an_edge_is_not_removed_twice() {
    let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    let e = editor.insert_disjoint(segment([[0, 0], [4, 0]]));
    editor.remove_edge(e);
    editor.remove_edge(e);
}
