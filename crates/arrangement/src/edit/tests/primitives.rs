//! Every primitive once, with what is there then.

use super::scenes::{Plane, plane};
use super::{Snapshot, is_shown_alike};
use crate::arrangement::CurveId;
use crate::edit::{Done, Edit, EditOf, Mirror, Observer, Operation, Undo};
use crate::models::{Segment, SegmentTraits};
use crate::topology::BoundedPlane;
use crate::traits::CurveEnd;
use dcel::{CcbKind, DcelViolation, EndFate, FaceId, HalfedgeId, Side, VertexId};
use exact::planar::Point2;
use std::collections::BTreeSet;

type E = EditOf<SegmentTraits>;

/// The name of a variant. There are as many as the test below says.
fn name(edit: &E) -> String {
    let text = format!("{edit:?}");
    text.split([' ', '{']).next().expect("a variant has a name").to_owned()
}

struct Script {
    arrangement: Plane,
    observers: (Mirror<SegmentTraits>, Undo<SegmentTraits>),
    states: Vec<Snapshot>,
    names: BTreeSet<String>,
}

impl Script {
    fn new(arrangement: Plane) -> Self {
        let observers = (Mirror::new(&arrangement), Undo::new(&arrangement));
        Self { states: vec![Snapshot::of(&arrangement)], arrangement, observers, names: BTreeSet::new() }
    }

    fn run(&mut self, edit: E) -> Done {
        self.names.insert(name(&edit));
        let before = self.arrangement.stamp();
        let done = self.arrangement.apply(edit.clone(), &mut self.observers);
        assert_ne!(self.arrangement.stamp(), before);
        self.check(&format!("{edit:?}"));
        self.states.push(Snapshot::of(&self.arrangement));
        done
    }

    fn check(&self, context: &str) {
        let dcel = self.arrangement.dcel();
        let violations: Vec<_> =
            dcel.check_valid().into_iter().filter(|found| !matches!(found, DcelViolation::Bare(_))).collect();
        assert_eq!(violations, [], "{context}");
        assert_eq!(self.observers.0.difference(&self.arrangement, is_shown_alike), None, "{context}");
    }

    fn vertex(&mut self, [x, y]: [i64; 2]) -> VertexId {
        self.run(Edit::AddVertex { point: Point2::from_i64([x, y]), is_artificial: false }).vertex()
    }

    fn take_all_back(mut self) {
        while let Some(state) = self.states.pop() {
            assert_eq!(Snapshot::of(&self.arrangement), state);
            let (mirror, undo) = &mut self.observers;
            assert_eq!(undo.take_back(&mut self.arrangement, mirror), Ok(!self.states.is_empty()));
            self.check("taking back");
        }
    }
}

#[test]
fn every_primitive() {
    let mut script = Script::new(plane(&[], &[]));
    let plane = FaceId(0);
    let curve = |ends| Edit::AddCurve { curve: Segment::from_i64(ends).expect("the ends are different") };
    let support = script.run(curve([[0, 0], [4, 0]])).curve();
    assert_eq!(support, CurveId(0));
    let [a, b, c] = [[0, 0], [4, 0], [4, 4]].map(|at| script.vertex(at));
    let kind = CcbKind::Inner;
    let ab = script.run(Edit::InsertEdgeInFace { ends: [a, b], face: plane, kind, support }).edge();
    let bc = script.run(Edit::InsertEdgeFrom { prev: ab.halfedge(), v: c, support }).edge();
    assert_eq!(script.arrangement.dcel().ends(bc), [b, c]);
    // A triangle: the cycle a, b, c is on the right of the edge from a to c.
    let prevs = [ab.halfedge().twin(), bc.halfedge()];
    let ac = script.run(Edit::InsertEdgeBetween { prevs, is_reversed: false, support }).edge();
    let settled = script.arrangement.clone().settle_insertion(ac, &mut ());
    assert!(!settled.kinds.contains(&CcbKind::Outer) || settled.splits_face);
    let ccb = script.arrangement.dcel().ccb(ab.halfedge());
    script.run(Edit::SetCcbKind { ccb, kind: CcbKind::Outer });
    let triangle = script.run(Edit::SplitFace { ccb }).face();
    assert_eq!(script.arrangement.dcel().face(ac.halfedge().twin()), triangle);
    script.run(Edit::SetCornerFace { face: triangle });
    assert_eq!(script.arrangement.corner_face(), triangle);
    script.run(Edit::SetCornerFace { face: plane });
    let point = |x, y| Point2::from_i64([x, y]);
    let d = script
        .run(Edit::AddIsolatedVertex { point: point(3, 1), is_artificial: false, face: plane })
        .vertex();
    script.run(Edit::MoveIsolatedVertex { v: d, face: triangle });
    let o = script.vertex([2, 1]);
    let od = script.run(Edit::InsertEdgeInFace { ends: [o, d], face: triangle, kind, support }).edge();
    let hole = script.arrangement.dcel().ccb(od.halfedge());
    script.run(Edit::MoveCcb { ccb: hole, face: plane });
    script.run(Edit::MoveCcb { ccb: hole, face: triangle });
    let n = script.vertex([1, 0]);
    let no = script.run(Edit::InsertEdgeTo { v: n, prev: od.halfedge().twin(), support }).edge();
    let joined = [no.halfedge().twin(), HalfedgeId(2 * ac.0)];
    let joined = [joined[0], script.arrangement.dcel().prev(joined[1].twin())];
    let an = script.run(Edit::InsertEdgeJoining { prevs: joined, kind: CcbKind::Outer, support }).edge();
    // Edges are split and merged, whichever part keeps the id.
    for (kept, of) in [(CurveEnd::Min, ab), (CurveEnd::Max, ab), (CurveEnd::Min, od), (CurveEnd::Max, an)] {
        let ends = script.arrangement.dcel().ends(of);
        let v = script.vertex([1, 7]);
        let new = script.run(Edit::SplitEdge { e: of, v, kept }).edge();
        let parts = if kept == CurveEnd::Min { [of, new] } else { [new, of] };
        let found = parts.map(|e| script.arrangement.dcel().ends(e));
        assert_eq!(found, [[ends[0], v], [v, ends[1]]]);
        let other = script.run(curve([[0, 0], [1, 1]])).curve();
        script.run(Edit::SetSupport { e: new, curve: other });
        let merged = script.run(Edit::MergeEdges { kept: [of, new][script.states.len() % 2], v });
        assert!(merged == Done::Merged(new) || merged == Done::Merged(of));
        if merged == Done::Merged(of) {
            // Once more, so that the edge has its id again.
            let v = script.vertex([1, 7]);
            assert_eq!(script.run(Edit::SplitEdge { e: new, v, kept }).edge(), of);
            script.run(Edit::MergeEdges { kept: of, v });
        }
        assert_eq!(script.arrangement.dcel().ends(of), ends);
    }
    script.run(Edit::SetPoint { v: o, point: point(3, 2) });
    script.run(Edit::SetArtificial { v: o, is_artificial: true });
    // Loops: alone, and in a corner on either side.
    let l = script.vertex([9, 9]);
    let kinds = [CcbKind::Outer, CcbKind::Inner];
    let at_l = script.run(Edit::InsertLoop { v: l, face: plane, kinds, support }).edge();
    for is_reversed in [false, true] {
        let prevs = [at_l.halfedge().twin(); 2];
        let e = script.run(Edit::InsertEdgeBetween { prevs, is_reversed, support }).edge();
        let alone = if is_reversed { e.halfedge().twin() } else { e.halfedge() };
        assert_eq!(script.arrangement.dcel().next(alone), alone);
        let ccb = script.arrangement.dcel().ccb(alone);
        script.run(Edit::SplitFace { ccb });
    }
    for survivor in [Side::Even, Side::Odd] {
        let edges: Vec<_> = script.arrangement.dcel().around(l).map(|h| h.edge_id()).collect();
        let e = *edges.iter().find(|&&e| e != at_l).expect("there are loops");
        let face = script.arrangement.dcel().face(e.half(survivor));
        script.run(Edit::SetCornerFace { face });
        script.run(Edit::RemoveEdge { e, ends: [EndFate::Remove; 2], survivor });
    }
    script.run(Edit::RemoveEdge { e: at_l, ends: [EndFate::Isolate; 2], survivor: Side::Odd });
    script.run(Edit::RemoveIsolatedVertex { v: l });
    let outside = script.arrangement.dcel().face(ac.halfedge());
    script.run(Edit::SetCornerFace { face: outside });
    script.run(Edit::MergeFaces { kept: outside, gone: triangle });
    let names: Vec<&str> = script.names.iter().map(String::as_str).collect();
    assert_eq!(names.len(), 22, "every variant: {names:?}");
    script.take_all_back();
}

#[test]
#[should_panic(expected = "the corner face does not go")]
fn the_corner_face_does_not_go() {
    let mut arrangement = plane(&[[0, 0, 4, 0], [0, 0, 4, 4], [4, 0, 4, 4]], &[]);
    let kept = arrangement.dcel().faces().find(|&f| f != arrangement.corner_face()).expect("there are two");
    arrangement.apply(Edit::MergeFaces { kept, gone: arrangement.corner_face() }, &mut ());
}

/// An operation of several primitives is taken back at once.
#[test]
fn operations_are_taken_back_as_one() {
    let mut script = Script::new(plane(&[[0, 0, 4, 0], [0, 0, 4, 4], [4, 0, 4, 4]], &[[3, 1], [9, 9]]));
    let before = Snapshot::of(&script.arrangement);
    let observer: &mut dyn Observer<SegmentTraits, BoundedPlane> = &mut script.observers;
    observer.begin_operation(&script.arrangement, Operation::RemoveVertex);
    let edges: Vec<_> = script.arrangement.dcel().edges().collect();
    for e in edges {
        script.arrangement.remove_and_settle(e, [EndFate::Remove; 2], observer);
    }
    observer.end_operation(&script.arrangement, Operation::RemoveVertex);
    assert_eq!((script.arrangement.dcel().edge_count(), script.arrangement.dcel().face_count()), (0, 1));
    let (mirror, undo) = &mut script.observers;
    assert_eq!(undo.take_back(&mut script.arrangement, mirror), Ok(true));
    assert_eq!(Snapshot::of(&script.arrangement), before);
    script.check("taken back");
}
