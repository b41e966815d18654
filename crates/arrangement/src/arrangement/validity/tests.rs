//! Arrangements that are broken in one way each.

use super::Violation as V;
use crate::CurveId;
use crate::arrangement::Arrangement;
use crate::editor::Editor;
use crate::models::polycurve::PolycurveTraits;
use crate::models::{Linear, LinearTraits, Segment, SegmentTraits, TorusSegmentTraits};
use crate::random::{Numbers, random_cylinder, random_globe, random_lines, random_paths, random_segments};
use crate::topology::{BoundedPlane, FlatTorus, Topology, UnboundedPlane};
use crate::traits::{BasicTraits, UMonotoneTraits};
use dcel::{EdgeId, FaceId, VertexId};
use exact::planar::Point2;

type Plane = Arrangement<SegmentTraits, BoundedPlane>;

fn segment(ends: [i64; 4]) -> Segment {
    let [x, y, z, w] = ends;
    Segment::from_i64([[x, y], [z, w]]).expect("the ends are different")
}

fn plane(segments: &[[i64; 4]], points: &[[i64; 2]]) -> Plane {
    let segments: Vec<Segment> = segments.iter().map(|&ends| segment(ends)).collect();
    let points = points.iter().map(|&point| Point2::from_i64(point));
    let plane = Arrangement::of_curves_and_points(SegmentTraits, BoundedPlane, &segments, points);
    assert_eq!(plane.check_valid(), []);
    plane
}

/// The vertex at a point.
fn vertex(plane: &Plane, at: [i64; 2]) -> VertexId {
    let point = Point2::from_i64(at);
    plane.vertices().find(|&v| plane.point(v) == Some(&point)).expect("there is a vertex")
}

fn move_vertex(plane: &mut Plane, from: [i64; 2], to: [i64; 2]) -> VertexId {
    let v = vertex(plane, from);
    plane.points[v.index()] = Some(Point2::from_i64(to));
    v
}

/// Puts another segment in the place of the one edge of a support, with its ends.
fn move_edge(plane: &mut Plane, support: usize, ends: [i64; 4]) -> EdgeId {
    let is_on_it = |e: &EdgeId| plane.support(*e) == CurveId(support as u32);
    let e = plane.dcel.edges().find(is_on_it).expect("the support has an edge");
    let segment = segment(ends);
    let vertices = plane.dcel.ends(e);
    plane.points[vertices[0].index()] = Some(segment.min().clone());
    plane.points[vertices[1].index()] = Some(segment.max().clone());
    plane.curves[support] = segment;
    e
}

const SQUARES: [[i64; 4]; 8] = [
    [0, 0, 9, 0],
    [9, 0, 9, 9],
    [9, 9, 0, 9],
    [0, 9, 0, 0],
    [3, 3, 6, 3],
    [6, 3, 6, 6],
    [6, 6, 3, 6],
    [3, 6, 3, 3],
];

#[test]
fn records() {
    let good = plane(&[[0, 0, 2, 0]], &[]);
    let mut bad = good.clone();
    bad.points.pop();
    assert_eq!(bad.check_valid(), [V::Records]);
    let mut bad = good.clone();
    bad.supports[0] = 7;
    assert_eq!(bad.check_valid(), [V::Support(EdgeId(0))]);
    let mut bad = good.clone();
    bad.points[1] = None;
    assert_eq!(bad.check_valid(), [V::PointMissing(VertexId(1))]);
    let mut bad = good.clone();
    bad.is_artificial[1] = true;
    assert_eq!(bad.check_valid(), [V::Artificial(VertexId(1))]);
    let line = Linear::line(&Point2::from_i64([0, 0]), &Point2::from_i64([1, 0])).expect("different points");
    let mut bad = Arrangement::of_curves(LinearTraits, UnboundedPlane, [&line]);
    assert_eq!(bad.check_valid(), []);
    bad.points[0] = Some(Point2::from_i64([3, 0]));
    assert_eq!(bad.check_valid(), [V::PointOnSide(VertexId(0))]);
}

#[test]
fn records_of_another_torus() {
    let traits =
        |periods: [i64; 2]| TorusSegmentTraits::new(periods.map(Into::into)).expect("periods are positive");
    let (small, large) = (traits([4, 3]), traits([9, 3]));
    let start = Point2::from_i64([1, 1]);
    let path =
        |traits: &TorusSegmentTraits| traits.path(&start, &[2.into(), 1.into()]).expect("the path is short");
    let points = [Point2::from_i64([0, 2])];
    let good = Arrangement::of_curves_and_points(small.clone(), FlatTorus, [&path(&small)], points);
    assert_eq!(good.check_valid(), []);
    let v = good.vertices().find(|&v| good.dcel.isolated_face(v).is_some()).expect("a point is isolated");
    for (at, is_inside) in
        [([3, 1], true), ([4, 2], false), ([3, 3], false), ([-1, 0], false), ([0, -1], false)]
    {
        let mut other = good.clone();
        other.points[v.index()] = Some(Point2::from_i64(at));
        let expected = if is_inside { vec![] } else { vec![V::NotCanonical(v)] };
        assert_eq!(other.check_valid(), expected, "{at:?}");
        let made = Arrangement::from_parts(small.clone(), FlatTorus, other.into_parts());
        assert_eq!(made.is_ok(), is_inside, "{at:?}");
    }
    // A segment with the same ends, of a torus that is wider; and of an equal one.
    let mut other = good.clone();
    let foreign = Arrangement::of_curves(large.clone(), FlatTorus, [&path(&large)]);
    other.curves.clone_from(&foreign.curves);
    assert_eq!(other.check_valid(), [V::ForeignSupport(EdgeId(0))]);
    let equal = traits([4, 3]);
    other.curves.clone_from(&Arrangement::of_curves(equal.clone(), FlatTorus, [&path(&equal)]).curves);
    assert_eq!(other.check_valid(), []);
    // Polycurves pass both questions on to their pieces.
    let (small, large) = (PolycurveTraits::new(small), PolycurveTraits::new(large));
    let chain = |traits: &PolycurveTraits<TorusSegmentTraits>| {
        let line = traits.make_cover_polyline([[1, 1], [3, 2]].map(Point2::from_i64)).expect("a polyline");
        Arrangement::of_curves(traits.clone(), FlatTorus, [&line]).curves[0].clone()
    };
    assert!(small.is_own_curve(&chain(&small)) && !small.is_own_curve(&chain(&large)));
    assert!(small.is_canonical(&Point2::from_i64([3, 2])) && !small.is_canonical(&Point2::from_i64([4, 2])));
}

/// What debug builds say of points and curves of another rectangle, instead of a wrong answer later.
#[cfg(debug_assertions)]
#[test]
fn debug_builds_refuse_points_and_curves_of_another_torus() {
    use std::panic::{AssertUnwindSafe, catch_unwind};
    let [small, large] = [[4, 3], [9, 3]].map(|periods: [i64; 2]| {
        TorusSegmentTraits::new(periods.map(Into::into)).expect("periods are positive")
    });
    let outside = Point2::from_i64([5, 1]);
    let path = large.path(&outside, &[2.into(), 1.into()]).expect("the path is short");
    let empty = Arrangement::new(small, FlatTorus);
    let editor = || Editor::new(empty.clone());
    let refuses = |call: &dyn Fn()| catch_unwind(AssertUnwindSafe(call)).is_err();
    assert!(refuses(&|| _ = crate::locate_by_sweep(&empty, std::slice::from_ref(&outside))));
    assert!(refuses(&|| _ = empty.clone().insert_points([outside.clone()])));
    assert!(refuses(&|| _ = empty.clone().insert_curves([&path])));
    assert!(refuses(&|| _ = editor().locate(&outside)));
    assert!(refuses(&|| _ = editor().insert_point(&outside)));
    assert!(refuses(&|| _ = editor().insert_curve(&path)));
    assert!(refuses(&|| _ = editor().zone_cells_of(&path)));
}

#[test]
fn cells() {
    let mut bad = plane(&SQUARES, &[]);
    let f = bad.dcel.faces().last().expect("there are faces");
    bad.dcel.add_isolated_vertex(f);
    bad.points.push(Some(Point2::from_i64([1, 1])));
    bad.is_artificial.push(false);
    let v = bad.dcel.add_vertex();
    bad.points.push(Some(Point2::from_i64([1, 2])));
    bad.is_artificial.push(false);
    let found = bad.check_valid();
    assert_eq!(found, [V::Cells(dcel::DcelViolation::Bare(v))]);
    assert_eq!(found[0].to_string(), format!("vertex {} is neither attached nor isolated", v.0));
}

#[test]
fn edges() {
    let mut bad = plane(&[[0, 0, 4, 0]], &[]);
    let v = move_vertex(&mut bad, [4, 0], [5, 0]);
    assert_eq!(bad.check_valid(), [V::OffSupport(v, EdgeId(0))]);
    bad.points[v.index()] = Some(Point2::from_i64([3, 1]));
    assert_eq!(bad.check_valid(), [V::OffSupport(v, EdgeId(0))]);
    let mut bad = plane(&[[0, 0, 4, 0]], &[]);
    bad.points.swap(0, 1);
    assert_eq!(bad.check_valid(), [V::EndOrder(EdgeId(0))]);
}

#[test]
fn rotations() {
    let mut bad = plane(&[[0, 0, 4, 0], [0, 0, 4, 1], [0, 0, 4, 2]], &[]);
    move_edge(&mut bad, 0, [0, 0, 4, 1]);
    move_edge(&mut bad, 1, [0, 0, 4, 0]);
    let v = vertex(&bad, [0, 0]);
    assert!(bad.check_valid().contains(&V::Rotation(v)));
    // Without the third one, two halfedges are always in order.
    let mut good = plane(&[[0, 0, 4, 0], [0, 0, 4, 1]], &[]);
    move_edge(&mut good, 0, [0, 0, 4, 1]);
    move_edge(&mut good, 1, [0, 0, 4, 0]);
    assert_eq!(good.check_valid(), []);
}

#[test]
fn vertices() {
    let mut bad = plane(&[], &[[0, 0], [1, 0], [2, 0]]);
    let w = move_vertex(&mut bad, [2, 0], [0, 0]);
    assert_eq!(bad.check_valid(), [V::SamePoint(VertexId(0), w)]);
    let mut bad = plane(&[[0, 0, 4, 2]], &[[1, 0]]);
    let v = move_vertex(&mut bad, [1, 0], [2, 1]);
    assert_eq!(bad.check_valid(), [V::VertexOnEdge(v, EdgeId(0))]);
    let mut bad = plane(&[[0, 0, 4, 2], [2, 7, 5, 5]], &[]);
    move_edge(&mut bad, 1, [2, 1, 5, 5]);
    let v = vertex(&bad, [2, 1]);
    assert_eq!(bad.check_valid(), [V::VertexOnEdge(v, EdgeId(0))]);
}

#[test]
fn meetings() {
    let mut bad = plane(&[[0, 0, 4, 0], [0, 3, 4, 3]], &[]);
    let [d, e] = [move_edge(&mut bad, 0, [0, 0, 4, 0]), move_edge(&mut bad, 1, [0, 3, 4, -2])];
    assert_eq!(bad.check_valid(), [V::Crossing(d, e)]);
    let e = move_edge(&mut bad, 1, [1, 0, 3, 0]);
    let found = bad.check_valid();
    assert!(found.contains(&V::Overlap(d, e)) || found.contains(&V::Overlap(e, d)), "{found:?}");
}

#[test]
fn faces() {
    let mut bad = plane(&SQUARES, &[[1, 1]]);
    let v = move_vertex(&mut bad, [1, 1], [5, 5]);
    let (by_cells, found) = match bad.check_valid()[..] {
        [V::WrongFace(w, by_cells, found)] if w == v => (by_cells, found),
        ref other => panic!("{other:?}"),
    };
    assert_eq!(Some(by_cells), bad.dcel.isolated_face(v));
    assert_ne!(found, by_cells);
    bad.dcel.move_isolated_vertex(v, found);
    assert_eq!(bad.check_valid(), []);
    let v = move_vertex(&mut bad, [5, 5], [20, 5]);
    bad.dcel.move_isolated_vertex(v, FaceId(0));
    assert_eq!(bad.check_valid(), []);
    // The hole of the outer square becomes one of the unbounded face.
    let hole = bad.dcel.inner_ccbs(by_cells).next().expect("the outer square has a hole");
    bad.dcel.move_ccb(hole, FaceId(0));
    let found = bad.check_valid();
    assert!(!found.is_empty() && found.iter().all(|v| matches!(v, V::WrongFace(..))), "{found:?}");
}

fn check_corner_faces<G: UMonotoneTraits, T: Topology<G>>(mut arrangement: Arrangement<G, T>) -> usize {
    let corner = arrangement.corner_face();
    assert_eq!(arrangement.check_valid(), []);
    let faces: Vec<FaceId> = (0..=arrangement.dcel.face_bound()).map(FaceId::new).collect();
    for &f in faces.iter().filter(|&&f| f != corner) {
        arrangement.corner_face = f;
        assert_eq!(arrangement.check_valid(), [V::CornerFace(f)]);
    }
    faces.len() - 1
}

/// Every other face is refused as the corner face, and so is one that is none.
#[test]
fn corner_faces() {
    assert_eq!(check_corner_faces(plane(&SQUARES, &[[1, 1]])), 3);
    assert_eq!(check_corner_faces(plane(&[], &[[1, 1]])), 1);
    let mut refused = 0;
    for seed in 1..60 {
        let mut numbers = Numbers::of_seed(seed);
        refused += check_corner_faces(random_segments(&mut numbers, 9).arrangement());
        refused += check_corner_faces(random_lines(&mut numbers, 6).arrangement());
        refused += check_corner_faces(random_paths(&mut numbers, 5).arrangement());
        refused += check_corner_faces(random_cylinder(&mut numbers, 5).arrangement());
        refused += check_corner_faces(random_globe(&mut numbers, 5).arrangement());
    }
    assert!(refused > 500, "{refused}");
}
