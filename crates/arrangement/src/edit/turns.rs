//! The kinds of CCBs after an edge came or went, and what becomes of faces.
//!
//! A CCB turns once to the left, once to the right, or, where it winds round the surface, not at all; its kind follows from that
//! ([`Topology::ccb_kind`]). How often it turns is counted along it, corner by corner. An edit changes two CCBs, of which one is
//! seldom counted: their turns have a known sum. With t the turns,
//!
//! | an edge | before | after | law |
//! |---|---|---|---|
//! | between two places of a CCB | C | C1, C2 | t(C1) + t(C2) = t(C) + 1 |
//! | joins two CCBs | C1, C2 | C | t(C) = t(C1) + t(C2) + 1 |
//! | with one CCB on both sides is removed | C | C1, C2 | t(C1) + t(C2) = t(C) - 1 |
//! | with two CCBs is removed | C1, C2 | C | t(C) = t(C1) + t(C2) - 1 |
//!
//! A CCB through a vertex without a point is an outer one, however it turns.
//!
//! On a torus, the turns of the CCBs of a face have its Euler characteristic as their sum (the surface is flat). So a face has one outer
//! CCB, which turns once, or two, which do not turn, or none.

use super::{Edit, Observer};
use crate::arrangement::Arrangement;
use crate::arrangement::build::special_count;
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use dcel::{CcbId, CcbKind, EdgeId, EndFate, FaceId, HalfedgeId, Removed, Side, VertexId};

/// What a new edge made of the CCBs at it, once these have their kinds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct SettledInsertion {
    /// The kinds of the CCBs on the even and on the odd side.
    pub(crate) kinds: [CcbKind; 2],
    /// Whether the face falls apart: one of the two CCBs has to become that of a new face. If one of them is an inner one, all that the
    /// face has besides lies on its side, or is to be moved.
    pub(crate) splits_face: bool,
    /// The side of the CCB that has fewer halfedges.
    pub(crate) shorter: Side,
}

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// How often a cycle of halfedges turns: 1 to the left, -1 to the right, 0 not at all. `None` if it passes through a vertex
    /// without a point.
    ///
    /// Along the cycle, the direction changes between right and left at a vertex by half a turn: to the right if the corner contains
    /// the whole other side of the vertex, else to the left.
    ///
    /// # Complexity
    /// Linear in the length of the cycle. Curves are compared where the direction changes.
    pub(crate) fn turns_of(&self, h: HalfedgeId) -> Option<i64> {
        let mut half_turns = 0;
        for h in self.dcel.cycle(h) {
            self.inner_point(self.dcel.source(h))?;
            half_turns += self.half_turn_after(h);
        }
        debug_assert!(matches!(half_turns, -2 | 0 | 2), "a CCB turns once or not at all");
        Some(half_turns / 2)
    }

    fn half_turn_after(&self, h: HalfedgeId) -> i64 {
        // Both leave the vertex; from the one to the other it goes clockwise.
        let (from, to) = (h.twin(), self.dcel.next(h));
        if from.is_even() != to.is_even() {
            0
        } else if from != to && self.compare_around(from, to).is_gt() {
            1
        } else {
            -1
        }
    }

    /// The kind that a CCB has by its turns.
    fn counted_kind(&self, ccb: CcbId) -> CcbKind {
        let turns = self.turns_of(self.dcel.ccb_halfedge(ccb));
        turns.map_or(CcbKind::Outer, |turns| self.topology.ccb_kind(turns))
    }

    /// The position of the shorter one of two cycles; both are walked in step.
    fn shorter_of(&self, [a, b]: [HalfedgeId; 2]) -> usize {
        let (mut on_a, mut on_b) = (self.dcel.cycle(a), self.dcel.cycle(b));
        loop {
            match (on_a.next(), on_b.next()) {
                (_, None) => return 1,
                (None, _) => return 0,
                _ => {}
            }
        }
    }

    fn set_kind<O: Observer<G, T> + ?Sized>(&mut self, ccb: CcbId, kind: CcbKind, observer: &mut O) {
        if self.dcel.ccb_kind(ccb) != kind {
            self.apply(Edit::SetCcbKind { ccb, kind }, observer);
        }
    }

    /// The kind of the CCB that two CCBs of a face become, if an edge joins them: for [`Edit::InsertEdgeJoining`].
    pub(crate) fn joined_kind(&self, prevs: [HalfedgeId; 2]) -> CcbKind {
        let is_inner = |h| self.dcel.ccb_kind(self.dcel.ccb(h)) == CcbKind::Inner;
        if prevs.into_iter().all(is_inner) { CcbKind::Inner } else { CcbKind::Outer }
    }

    /// Gives the CCBs at an edge that was inserted their kinds, and tells whether it splits its face.
    ///
    /// It comes next after an edit that inserts an edge. By [`Edit::InsertLoop`], both CCBs have to be inner ones so far: what was there
    /// before is a vertex, which is like a hole.
    ///
    /// # Complexity
    /// Linear in the length of the shorter CCB.
    pub(crate) fn settle_insertion<O: Observer<G, T> + ?Sized>(
        &mut self,
        e: EdgeId,
        observer: &mut O,
    ) -> SettledInsertion {
        let halves = [e.halfedge(), e.halfedge().twin()];
        let ccbs = halves.map(|h| self.dcel.ccb(h));
        let old_kind = self.dcel.ccb_kind(ccbs[0]);
        debug_assert_eq!(old_kind, self.dcel.ccb_kind(ccbs[1]), "both are made of one");
        if ccbs[0] == ccbs[1] {
            let is_through_side = self.dcel.ends(e).into_iter().any(|v| self.stands_for_side(v));
            let kind = if is_through_side { CcbKind::Outer } else { old_kind };
            self.set_kind(ccbs[0], kind, observer);
            return SettledInsertion { kinds: [kind; 2], splits_face: false, shorter: Side::Even };
        }
        let shorter = self.shorter_of(halves);
        let has_outer_ccb = self.dcel.outer_ccbs(self.dcel.face(halves[0])).next().is_some();
        let (mut kinds, turns) = match old_kind {
            // Neither turns to the right, because the sum of the turns is 1 or 2; if it was through a side, what is not so any more
            // is on the inside of a closed curve.
            CcbKind::Outer => ([CcbKind::Outer; 2], 1),
            CcbKind::Inner => match self.turns_of(halves[shorter]) {
                None => ([CcbKind::Outer; 2], 0),
                Some(turns) => ([turns, -turns].map(|turns| self.topology.ccb_kind(turns)), turns),
            },
        };
        if shorter == 1 {
            kinds.reverse();
        }
        for (ccb, kind) in ccbs.into_iter().zip(kinds) {
            self.set_kind(ccb, kind, observer);
        }
        SettledInsertion {
            kinds,
            splits_face: self.topology.splits_face(has_outer_ccb, turns),
            shorter: [Side::Even, Side::Odd][shorter],
        }
    }

    /// Gives the CCBs that the removal of an edge left their kinds. `ends` are the vertices that it had; they may be gone.
    ///
    /// It comes next after [`Edit::RemoveEdge`].
    ///
    /// # Complexity
    /// Linear in the length of the shorter CCB, if the edge had one CCB on both sides; constant else. On a surface of which one pair of
    /// sides is identified, linear in the length of all CCBs that arise.
    pub(crate) fn settle_removal<O: Observer<G, T> + ?Sized>(
        &mut self,
        ends: [VertexId; 2],
        removed: Removed,
        observer: &mut O,
    ) {
        match removed {
            Removed::Vanished { .. } => {}
            Removed::Antenna { ccb } => {
                let is_left = |&v: &VertexId| self.stands_for_side(v) && self.dcel.outgoing(v).is_none();
                // Its component was connected with that vertex, and is a hole now.
                if ends.iter().any(is_left) {
                    let kind = if self.is_one_sided() { CcbKind::Inner } else { self.counted_kind(ccb) };
                    self.set_kind(ccb, kind, observer);
                }
            }
            Removed::Split { at_source, at_target } => {
                if let Some(hole) = self.new_hole([at_source, at_target]) {
                    self.set_kind(hole, CcbKind::Inner, observer);
                }
            }
            Removed::Joined { ccb, faces } => {
                let is_hole = self.dcel.ccb_kind(ccb) == CcbKind::Outer
                    && match self.winding() {
                        Winding::None => false,
                        // Two outer ones that do not turn became one that turns to the right. There were two in each face.
                        Winding::Torus => faces.is_none() || self.outer_count(self.dcel.ccb_face(ccb)) == 3,
                        Winding::Other => self.counted_kind(ccb) == CcbKind::Inner,
                    };
                if is_hole {
                    self.set_kind(ccb, CcbKind::Inner, observer);
                }
            }
        }
    }

    /// Which of two CCBs that were one became an inner one. They have the kind of that one.
    fn new_hole(&self, ccbs: [CcbId; 2]) -> Option<CcbId> {
        if self.dcel.ccb_kind(ccbs[0]) == CcbKind::Inner {
            // Both turn to the right.
            return None;
        }
        let halves = ccbs.map(|ccb| self.dcel.ccb_halfedge(ccb));
        let shorter = self.shorter_of(halves);
        let other = ccbs[1 - shorter];
        let is_other = match self.turns_of(halves[shorter]) {
            Some(turns) if turns < 0 => return Some(ccbs[shorter]),
            Some(turns) if turns > 0 => true,
            None if self.is_one_sided() => true,
            Some(_) if self.winding() == Winding::Torus => {
                // The sum is 0 if the one CCB turned, and was the only outer one; else it is -1.
                self.outer_count(self.dcel.ccb_face(other)) == 3
            }
            _ => self.counted_kind(other) == CcbKind::Inner,
        };
        is_other.then_some(other)
    }

    /// The number of outer CCBs of a face, but 3 if there are more.
    fn outer_count(&self, face: FaceId) -> usize {
        self.dcel.outer_ccbs(face).take(3).count()
    }

    /// Whether one vertex without a point stands for all sides: what is not connected with it is a hole. Where sides are identified,
    /// it may wind round the surface.
    fn is_one_sided(&self) -> bool {
        special_count(&self.topology) == 1 && self.winding() == Winding::None
    }

    fn winding(&self) -> Winding {
        let sides = self.topology.sides();
        match (sides.is_u_identified(), sides.is_v_identified()) {
            (false, false) => Winding::None,
            (true, true) => Winding::Torus,
            _ => Winding::Other,
        }
    }

    /// The side of an edge whose face is to keep its id when the edge is removed: that of the face that has more CCBs and isolated
    /// vertices.
    ///
    /// # Complexity
    /// Linear in the number of CCBs and isolated vertices of the face that has fewer.
    pub(crate) fn survivor_of(&self, e: EdgeId) -> Side {
        let faces = [Side::Even, Side::Odd].map(|side| self.dcel.face(e.half(side)));
        if faces[0] == faces[1] {
            return Side::Even;
        }
        let [mut even, mut odd] = faces.map(|f| {
            let isolated = self.dcel.isolated_vertices(f).map(|_| ());
            self.dcel.face_ccbs(f).map(|_| ()).chain(isolated)
        });
        loop {
            match (even.next(), odd.next()) {
                (_, None) => return Side::Even,
                (None, _) => return Side::Odd,
                _ => {}
            }
        }
    }

    /// Removes an edge, and settles the kinds of CCBs. Faces become one by [`Arrangement::survivor_of`]; if the corner face is the one
    /// that goes, the other one is the corner face then.
    ///
    /// # Panics
    /// If a vertex that stands for a side is to be removed.
    ///
    /// # Complexity
    /// Linear in the length of the shorter CCB, and in the number of CCBs and isolated vertices of the face that goes.
    pub(crate) fn remove_and_settle<O: Observer<G, T> + ?Sized>(
        &mut self,
        e: EdgeId,
        fates: [EndFate; 2],
        observer: &mut O,
    ) -> Removed {
        let (ends, survivor) = (self.dcel.ends(e), self.survivor_of(e));
        let kept = self.dcel.face(e.half(survivor));
        let is_corner = |side| self.dcel.face(e.half(side)) == self.corner_face;
        if kept != self.corner_face && [Side::Even, Side::Odd].into_iter().any(is_corner) {
            self.apply(Edit::SetCornerFace { face: kept }, observer);
        }
        let removed = self.apply(Edit::RemoveEdge { e, ends: fates, survivor }, observer).removed();
        self.settle_removal(ends, removed, observer);
        removed
    }
}

/// Whether there are CCBs that wind round the surface and do not turn.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Winding {
    None,
    Torus,
    Other,
}
