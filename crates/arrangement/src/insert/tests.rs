//! What is inserted together and one after the other; insertion that is stopped.

use super::*;
use crate::models::{Segment, SegmentTraits, TorusSegmentTraits};
use crate::overlay::{Cell, overlay_all, overlay_all_with};
use crate::topology::{BoundedPlane, FlatTorus};
use exact::planar::Point2;

fn segment(ends: [[i64; 2]; 2]) -> Segment {
    Segment::from_i64(ends).expect("the ends are different")
}

/// A segment cut at (2, 0), another one, and a point.
fn cut_segment() -> Pieces<SegmentTraits> {
    let mut pieces = Pieces::new();
    pieces.push_curve(segment([[0, 1], [4, 1]]));
    pieces.push_piece(segment([[0, 0], [2, 0]]), [false, true]);
    pieces.push_point(Point2::from_i64([9, 9]));
    pieces.push_piece(segment([[2, 0], [4, 0]]), [true, false]);
    pieces
}

#[test]
fn flags_stay_with_their_curves() {
    let pieces = cut_segment();
    assert_eq!(pieces.is_artificial(), [[false; 2], [false, true], [true, false]]);
    assert_eq!((pieces.curves().len(), pieces.points().len()), (3, 1));
    let mut extended = Pieces::<SegmentTraits>::new();
    let flags = pieces.is_artificial().iter();
    extended.extend(
        pieces
            .curves()
            .iter()
            .zip(flags)
            .map(|(curve, &is_artificial)| Piece::Curve { curve: curve.clone(), is_artificial }),
    );
    extended.extend([Piece::Point(Point2::from_i64([9, 9]))]);
    for pieces in [pieces, extended] {
        let arrangement = Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces);
        assert_eq!(arrangement.check_valid(), []);
        let [counts, stored] = [arrangement.counts(), arrangement.counts_with_splits()];
        assert_eq!((counts.vertices, counts.edges, counts.isolated), (5, 2, 1));
        assert_eq!((stored.vertices, stored.edges, stored.isolated), (6, 3, 1));
    }
}

#[test]
fn points_are_inserted_with_curves_and_after_them() {
    // On an edge, at an end, at the place of a cut, in the face, and twice.
    let points = || [[1, 1], [0, 0], [2, 0], [5, 5], [5, 5], [9, 9]].map(Point2::from_i64);
    let mut arrangement = Arrangement::of_pieces(SegmentTraits, BoundedPlane, cut_segment());
    let plane = arrangement.corner_face();
    let provenance = arrangement.insert_points(points());
    assert_eq!(arrangement.check_valid(), []);
    let counts = arrangement.counts();
    assert_eq!((counts.vertices, counts.edges, counts.isolated), (8, 4, 2));
    let origin = |at| {
        let at = Point2::from_i64(at);
        let v = arrangement.vertices().find(|&v| arrangement.point(v) == Some(&at));
        provenance.of_vertex(v.expect("a point is a vertex"))[0]
    };
    assert!(matches!(origin([1, 1]), Cell::Edge(_)));
    assert!(matches!(origin([2, 0]), Cell::Vertex(_)));
    assert_eq!(origin([5, 5]), Cell::Face(plane));

    let segments = [segment([[0, 1], [4, 1]]), segment([[0, 0], [2, 0]]), segment([[2, 0], [4, 0]])];
    let together = Arrangement::of_curves_and_points(SegmentTraits, BoundedPlane, &segments, points());
    assert!(arrangement.is_isomorphic(&together));
}

#[test]
fn nothing_is_inserted() {
    let none: [Segment; 0] = [];
    let mut empty = Arrangement::of_curves_and_points(SegmentTraits, BoundedPlane, &none, []);
    empty.insert_points([]);
    assert_eq!(empty.check_valid(), []);
    assert_eq!((empty.counts().vertices, empty.counts().faces), (0, 1));
}

#[test]
fn points_of_a_torus_are_brought_home() {
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).expect("the periods are positive");
    let through = Point2::from_i64([1, 1]);
    let path = traits.closed_path(&through, [1, 0]).expect("the path is short");
    // Two on the path, of which one is where it crosses the left side; one at a corner.
    let points = [[6, 5], [8, -3], [-4, 4]].map(|at| traits.point(&Point2::from_i64(at)));
    let together = Arrangement::of_curves_and_points(traits.clone(), FlatTorus, [&path], points.clone());
    let mut after = Arrangement::of_curves(traits, FlatTorus, [&path]);
    after.insert_points(points);
    for arrangement in [&together, &after] {
        assert_eq!(arrangement.check_valid(), []);
        let counts = arrangement.counts();
        assert_eq!((counts.vertices, counts.edges, counts.isolated), (3, 2, 1));
    }
}

/// Rows of short segments, at different heights.
fn rows(u: i64) -> Pieces<SegmentTraits> {
    let mut pieces = Pieces::new();
    for v in 0..2000 {
        pieces.push_curve(segment([[u, v], [u + 2, v + v % 2]]));
    }
    pieces
}

#[test]
fn insertion_that_is_stopped_changes_nothing() {
    let mut arrangement = Arrangement::of_pieces(SegmentTraits, BoundedPlane, rows(0));
    let before = arrangement.clone();
    let mut calls = Vec::new();
    let stopped = arrangement.insert_pieces_with(rows(1), |progress| {
        calls.push(progress);
        if calls.len() == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert!(stopped.is_none());
    assert_eq!(calls.len(), 3);
    assert!(calls.iter().all(|progress| progress.sites == 7001));
    assert!(calls.windows(2).all(|pair| pair[0].events < pair[1].events));
    assert_eq!(arrangement.cell_order(), before.cell_order(), "the same ids");
    assert_eq!(arrangement.difference(&before), None);
    assert_eq!(arrangement.curves().len(), 2000);

    let provenance = arrangement.insert_pieces_with(rows(1), |_| ControlFlow::Continue(()));
    assert_eq!(provenance.expect("nobody stops it").operand_count(), 1);
    let mut other = before;
    other.insert_pieces(rows(1));
    assert_eq!(arrangement.difference(&other), None);
}

#[test]
fn an_overlay_can_be_stopped() {
    let [red, blue] = [0, 1].map(|u| Arrangement::of_pieces(SegmentTraits, BoundedPlane, rows(u)));
    let mut calls = 0;
    let stopped = overlay_all_with(&[&red, &blue], |_| {
        calls += 1;
        ControlFlow::Break(())
    });
    assert!(stopped.is_none() && calls == 1);
    let whole = overlay_all_with(&[&red, &blue], |_| {
        calls += 1;
        ControlFlow::Continue(())
    });
    let (overlay, provenance) = whole.expect("nobody stops it");
    assert!(calls > 3 && provenance.operand_count() == 2);
    let (expected, _) = overlay_all(&[&red, &blue]);
    assert_eq!(overlay.difference(&expected), None);
}
