//! Insertions with known neighbours, against sweeps and against `insert_curve`.

use crate::scenes::{Law, Scene, Watched, check, for_all, take_back, watch};
use dcel::{EdgeId, VertexId};
use exact::planar::Point2;
use splitstar_arrangement::models::polycurve::PolycurveTraits;
use splitstar_arrangement::models::{Segment, SegmentTraits};
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::{BoundedPlane, Topology};
use splitstar_arrangement::traits::{ArrangementTraits, CurveEnd};
use splitstar_arrangement::{Arrangement, Editor, Pieces};
use testkit::Rng;

/// What is at an end of a curve that is to be inserted.
#[derive(Clone, Copy, Debug)]
enum Neighbour {
    Vertex(VertexId),
    New,
}

/// Inserts a curve that meets nothing by what is known of its ends.
fn insert_known<G, T>(editor: &mut Watched<G, T>, curve: G::UMonotoneCurve, rng: &mut Rng) -> EdgeId
where
    G: ArrangementTraits<Point = Point2> + Clone,
    T: Topology<G>,
{
    let arrangement = editor.arrangement();
    let point = |end| arrangement.traits().end_point(&curve, end).cloned();
    let points = CurveEnd::BOTH.map(point);
    if rng.one_in(5) || points[0].is_some() && points[0] == points[1] && rng.one_in(2) {
        return editor.insert_disjoint(curve);
    }
    let mut face = arrangement.corner_face();
    let ends = points.clone().map(|point| match point.map(|point| editor.locate(&point)) {
        Some(Cell::Vertex(v)) => Neighbour::Vertex(v),
        Some(Cell::Face(f)) => {
            face = f;
            Neighbour::New
        }
        Some(Cell::Edge(e)) => panic!("an end is in the interior of {e:?}"),
        // The vertex at infinity may be given or not.
        None if rng.one_in(2) => Neighbour::Vertex(VertexId(0)),
        None => Neighbour::New,
    });
    match ends {
        [Neighbour::Vertex(v), Neighbour::Vertex(w)] => editor.insert_edge_between([v, w], curve),
        [Neighbour::Vertex(v), Neighbour::New] => editor.insert_edge_from(v, curve),
        [Neighbour::New, Neighbour::Vertex(v)] => editor.insert_edge_to(curve, v),
        _ if points[0].is_some() && points[0] == points[1] => {
            let v = editor.insert_point(points[0].as_ref().unwrap());
            editor.insert_edge_between([v, v], curve)
        }
        // A line through the plane does not tell by its ends in which face it lies.
        _ if points.iter().all(Option::is_none) => editor.insert_disjoint(curve),
        _ => editor.insert_edge_in_face(curve, face),
    }
}

struct EdgeByEdge;

impl Law for EdgeByEdge {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        let all = scene.sweep_all();
        let mut editor = watch(scene.empty());
        let mut pieces = Pieces::<G>::new();
        let isolated: Vec<_> = all.vertices().filter(|&v| all.dcel().outgoing(v).is_none()).collect();
        for &v in &isolated[..isolated.len() / 2] {
            let point = all.point(v).unwrap();
            editor.insert_point_in_face(point, editor.arrangement().corner_face());
            pieces.push_point(point.clone());
        }
        let mut edges: Vec<_> = all.dcel().edges().collect();
        rng.shuffle(&mut edges);
        for e in edges {
            let curve = all.make_edge_curve(e);
            let stored = curve.clone();
            let new = insert_known(&mut editor, curve, rng);
            let of_new = editor.arrangement().curve_of(new);
            assert_eq!(format!("{of_new:?}"), format!("{stored:?}"));
            pieces.push_curve(stored);
            check(&editor);
            let (traits, topology) = (scene.traits.clone(), scene.topology.clone());
            let swept = Arrangement::of_pieces(traits, topology, pieces.clone());
            assert_eq!(editor.arrangement().difference(&swept), None);
        }
        for &v in &isolated[isolated.len() / 2..] {
            let point = all.point(v).unwrap();
            let Cell::Face(face) = editor.locate(point) else { panic!("it was isolated") };
            editor.insert_point_in_face(point, face);
            check(&editor);
        }
        // Back to the beginning.
        let mut count = 0;
        while let Some(recorded) = editor.observers_mut().1.pop() {
            editor.take_back(recorded).unwrap();
            count += 1;
        }
        assert!(count >= all.dcel().edge_count());
        assert_eq!(editor.arrangement().difference(&scene.empty()), None);
        check(&editor);
    }
}

#[test]
fn edges_inserted_by_their_neighbours_give_the_sweep() {
    for_all(&EdgeByEdge, 40, 4000);
}

struct CurvesAndBack;

impl Law for CurvesAndBack {
    fn check<G, T>(&self, scene: &Scene<G, T>, _: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        let mut editor = watch(scene.empty());
        let mut states = Vec::new();
        for point in &scene.points {
            let before = editor.arrangement().clone();
            editor.insert_point(point);
            if before.stamp() != editor.arrangement().stamp() {
                states.push(before);
            }
        }
        for (i, curve) in scene.curves.iter().enumerate() {
            let before = editor.arrangement().clone();
            editor.insert_curve(curve);
            if before.stamp() != editor.arrangement().stamp() {
                states.push(before);
            }
            check(&editor);
            let swept = scene.sweep(i + 1);
            assert_eq!(editor.arrangement().difference(&swept), None);
        }
        take_back(&mut editor, states);
    }
}

#[test]
fn curves_inserted_one_by_one_are_taken_back() {
    for_all(&CurvesAndBack, 40, 5000);
}

fn segment(ends: [[i64; 2]; 2]) -> Segment {
    Segment::from_i64(ends).unwrap()
}

#[test]
fn local_insertions_give_what_insert_curve_gives() {
    // A square with a diagonal, and a hole.
    let [mut by_curve, mut local] =
        [0; 2].map(|_| Editor::new(Arrangement::new(SegmentTraits, BoundedPlane)));
    let plane = local.corner_face();
    let e = local.insert_edge_in_face(segment([[0, 0], [9, 0]]), plane);
    let [a, b] = local.dcel().ends(e);
    let e = local.insert_edge_from(b, segment([[9, 0], [9, 9]]));
    let [_, c] = local.dcel().ends(e);
    let e = local.insert_edge_to(segment([[0, 9], [9, 9]]), c);
    let [d, _] = local.dcel().ends(e);
    local.insert_edge_between([a, d], segment([[0, 0], [0, 9]]));
    let diagonal = local.insert_edge_between([a, c], segment([[0, 0], [9, 9]]));
    let below = local.dcel().face(diagonal.halfedge().twin());
    local.insert_edge_in_face(segment([[6, 1], [8, 3]]), below);
    local.insert_disjoint(segment([[4, 0], [5, 1]]));
    for ends in [
        [[0, 0], [9, 0]],
        [[9, 0], [9, 9]],
        [[0, 9], [9, 9]],
        [[0, 0], [0, 9]],
        [[0, 0], [9, 9]],
        [[6, 1], [8, 3]],
        [[4, 0], [5, 1]],
    ] {
        by_curve.insert_curve(&segment(ends));
    }
    assert_eq!(by_curve.difference(&local), None);
    assert_eq!(local.counts().faces, 3);
}

/// The polylines through the points given, one by one and by a sweep; the counts of vertices as a user sees them.
fn vertex_counts(polylines: &[&[[i64; 2]]]) -> [usize; 2] {
    let traits = PolycurveTraits::new(SegmentTraits);
    let polyline = |points: &&[[i64; 2]]| traits.make_polyline(points.iter().map(|&p| Point2::from_i64(p)));
    let curves: Vec<_> = polylines.iter().map(|points| polyline(points).unwrap()).collect();
    let mut editor = watch(Arrangement::new(traits, BoundedPlane));
    for curve in &curves {
        editor.insert_curve(curve);
        check(&editor);
    }
    let swept = Arrangement::of_curves(traits, BoundedPlane, &curves);
    assert_eq!(editor.arrangement().difference(&swept), None);
    [editor.arrangement().counts().vertices, editor.arrangement().counts_with_splits().vertices]
}

#[test]
fn where_a_closed_polyline_begins_is_no_vertex_if_it_runs_back_over_itself() {
    // It begins at (1, 1), where its second part passes, and is cut at its tips only.
    assert_eq!(vertex_counts(&[&[[1, 1], [2, 1], [0, 1], [1, 1]]]), [2, 2]);
}

#[test]
fn where_a_closed_polyline_begins_on_an_edge_is_no_vertex() {
    assert_eq!(vertex_counts(&[&[[0, 1], [4, 1]], &[[2, 1], [1, 1], [4, 1], [2, 1]]]), [3, 3]);
}

#[test]
fn a_walk_asks_for_meetings_with_edges_that_begin_on_its_way() {
    // The second polyline passes below the vertical one, in its second piece.
    assert_eq!(vertex_counts(&[&[[4, 2], [4, 4]], &[[0, 3], [4, 1], [7, 8]]]), [4, 4]);
}

#[test]
#[cfg(debug_assertions)]
#[should_panic(expected = "the interior of the curve is free")]
fn a_curve_that_crosses_an_edge_is_refused() {
    let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    editor.insert_disjoint(segment([[0, 0], [4, 4]]));
    editor.insert_disjoint(segment([[0, 4], [4, 0]]));
}

#[test]
#[cfg(debug_assertions)]
#[should_panic(expected = "the interior of the curve is free")]
fn a_curve_along_an_edge_is_refused() {
    let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    editor.insert_disjoint(segment([[0, 0], [4, 4]]));
    editor.insert_disjoint(segment([[0, 0], [8, 8]]));
}

#[test]
#[cfg(debug_assertions)]
#[should_panic(expected = "the ends lie in face 0")]
fn a_curve_in_another_face_is_refused() {
    let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    let plane = editor.corner_face();
    for ends in [[[0, 0], [9, 0]], [[9, 0], [0, 9]], [[0, 0], [0, 9]]] {
        editor.insert_disjoint(segment(ends));
    }
    editor.insert_edge_in_face(segment([[1, 1], [2, 2]]), plane);
}

#[test]
#[cfg(debug_assertions)]
#[should_panic(expected = "the curve ends at vertex 0")]
fn a_curve_from_another_vertex_is_refused() {
    let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    let v = editor.insert_point(&Point2::from_i64([1, 1]));
    editor.insert_edge_from(v, segment([[0, 0], [9, 0]]));
}
