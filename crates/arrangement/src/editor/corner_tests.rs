//! A loop around many holes, which opens to the corner face and is closed again: what lies in the larger part stays.

use super::*;
use crate::edit::{Done, Edit, EditOf};
use crate::models::{Segment, SegmentTraits};
use crate::topology::BoundedPlane;
use dcel::EdgeId;

const HOLES: i64 = 40;

/// Counts the CCBs and isolated vertices that get into another face.
#[derive(Default)]
struct Moves {
    moved: usize,
    corners: usize,
}

impl<T: Topology<SegmentTraits>> Observer<SegmentTraits, T> for Moves {
    fn before(&mut self, arrangement: &Arrangement<SegmentTraits, T>, edit: &EditOf<SegmentTraits>) {
        let dcel = arrangement.dcel();
        assert!(dcel.has_face(arrangement.corner_face()));
        match *edit {
            Edit::MoveCcb { .. } | Edit::MoveIsolatedVertex { .. } => self.moved += 1,
            Edit::SetCornerFace { face } => {
                assert_ne!(face, arrangement.corner_face());
                self.corners += 1;
            }
            Edit::RemoveEdge { e, survivor, .. } => {
                let kept = dcel.face(e.half(survivor));
                let beside = [e.halfedge(), e.halfedge().twin()].map(|h| dcel.face(h));
                let gone = beside.into_iter().find(|&f| f != kept);
                self.moved +=
                    gone.map_or(0, |f| dcel.face_ccbs(f).count() + dcel.isolated_vertices(f).count());
            }
            _ => {}
        }
    }

    fn after(&mut self, arrangement: &Arrangement<SegmentTraits, T>, _: &EditOf<SegmentTraits>, _: &Done) {
        assert!(arrangement.dcel().has_face(arrangement.corner_face()));
    }
}

fn segment(ends: [[i64; 2]; 2]) -> Segment {
    Segment::from_i64(ends).expect("the ends are different")
}

fn square([x, y]: [i64; 2], side: i64) -> [Segment; 4] {
    let [a, b] = [[x, y], [x + side, y + side]];
    [
        segment([a, [b[0], a[1]]]),
        segment([[b[0], a[1]], b]),
        segment([b, [a[0], b[1]]]),
        segment([[a[0], b[1]], a]),
    ]
}

/// Many small squares, and a large one that has them all within it, or none of them.
fn squares(are_within: bool) -> (Editor<SegmentTraits, BoundedPlane, Moves>, [Segment; 4]) {
    let large = if are_within { square([-5, -5], 4 * HOLES + 10) } else { square([-60, -60], 9) };
    let small = (0..HOLES * HOLES).flat_map(|i| square([4 * (i / HOLES), 4 * (i % HOLES)], 2));
    let curves: Vec<Segment> = small.chain(large.clone()).collect();
    let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, &curves);
    (Editor::with_observers(arrangement, Moves::default()).expect("it watches from now on"), large)
}

/// Both with the holes inside the loop, where the corner face is the smaller part, and with the holes outside.
#[test]
fn few_holes_move_beside_the_corner_face() {
    for are_within in [true, false] {
        let (mut editor, large) = squares(are_within);
        let faces = editor.counts().faces;
        for step in 0..8 {
            let side = &large[step % 4];
            let edges: Vec<EdgeId> = editor.insert_curve(side);
            let [e] = edges[..] else { panic!("nothing crosses the side") };
            editor.remove_edge_with(e, [dcel::EndFate::Isolate; 2]);
            assert_eq!(editor.counts().faces, faces - 1, "the loop is open");
            assert_eq!(editor.insert_curve(side).len(), 1);
            assert_eq!(editor.counts().faces, faces, "the loop is closed");
        }
        assert_eq!(editor.check_valid(), []);
        let (arrangement, Moves { moved, corners }) = editor.finish();
        // One in each step: the loop itself, if the face on the other side of it goes, and has nothing else.
        assert!(moved <= 16, "{moved} moved, {are_within}");
        assert_eq!(corners, if are_within { 16 } else { 0 });
        assert!(arrangement.is_isomorphic(&squares(are_within).0));
    }
}
