//! Removing an edge: the inverse of all that inserts one.

use super::{CcbKind, Dcel, Side, VertexCell};
use crate::{CcbId, EdgeId, FaceId, HalfedgeId, VertexId};

/// What becomes of an end vertex whose last edge is removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EndFate {
    /// It is isolated in the face where the edge was.
    Isolate,
    /// It is removed.
    Remove,
}

/// Two faces that became one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MergedFaces {
    /// The face that has all now.
    pub kept: FaceId,
    /// The face that is no more.
    pub gone: FaceId,
}

/// What the removal of an edge did.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Removed {
    /// The edge had a free end: its CCB is shorter now.
    Antenna {
        /// The CCB.
        ccb: CcbId,
    },
    /// The edge had one CCB on both sides, which fell in two. Both have the kind of the old one: which
    /// of them bounds the face from outside, the caller knows.
    Split {
        /// The CCB at the source of the even halfedge.
        at_source: CcbId,
        /// The CCB at its target.
        at_target: CcbId,
    },
    /// The edge had two CCBs, which became one: inner if one of them was, outer otherwise.
    Joined {
        /// The CCB.
        ccb: CcbId,
        /// The faces on the two sides, if they were two.
        faces: Option<MergedFaces>,
    },
    /// The edge was all of its component.
    Vanished {
        /// The faces on the two sides, if they were two (the edge was a loop then).
        faces: Option<MergedFaces>,
    },
}

impl Dcel {
    /// Removes `e`. If it has two faces, they become one: the face on the side `survivor` keeps its id.
    ///
    /// `ends` says what becomes of the min and of the max vertex if they have no other edge; for a loop
    /// the first counts. Kinds of CCBs are those that [`Removed`] states; change them by
    /// [`set_ccb_kind`](Self::set_ccb_kind) where they are others.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Complexity
    /// Linear in the length of the shorter of the CCBs that join or arise, and in the number of CCBs and
    /// isolated vertices of the face that is removed.
    pub fn remove_edge(&mut self, e: EdgeId, ends: [EndFate; 2], survivor: Side) -> Removed {
        assert!(self.has_edge(e), "only an edge is removed");
        let (h, twin) = (e.halfedge(), e.halfedge().twin());
        let vertices = self.ends(e);
        let (kept, gone) = match survivor {
            Side::Even => (self.face(h), self.face(twin)),
            Side::Odd => (self.face(twin), self.face(h)),
        };
        let mut removed =
            if self.ccb(h) == self.ccb(twin) { self.remove_from_one(h) } else { self.remove_between_two(h) };
        self.free_edge(e);
        if kept != gone {
            self.merge_faces(kept, gone);
            if let Removed::Joined { faces, .. } | Removed::Vanished { faces } = &mut removed {
                *faces = Some(MergedFaces { kept, gone });
            }
        }
        for (v, fate) in vertices.into_iter().zip(ends) {
            if self.vertices[v.index()] == VertexCell::BARE {
                match fate {
                    EndFate::Isolate => self.isolate(v, kept),
                    EndFate::Remove => self.free_vertex(v),
                }
            }
        }
        removed
    }

    /// Takes out an edge with the same CCB on both sides.
    fn remove_from_one(&mut self, h: HalfedgeId) -> Removed {
        let twin = h.twin();
        let ccb = self.ccb(h);
        let (at_source, at_target) = (self.prev(h), self.next(h));
        self.detach(h);
        self.detach(twin);
        match (at_source == twin, at_target == twin) {
            (true, true) => {
                self.remove_ccb(ccb);
                Removed::Vanished { faces: None }
            }
            (false, false) => {
                self.split_ccb([at_source, at_target], ccb);
                Removed::Split { at_source: self.ccb(at_source), at_target: self.ccb(at_target) }
            }
            (free, _) => {
                self.ccbs[ccb.index()].first = if free { at_target } else { at_source };
                Removed::Antenna { ccb }
            }
        }
    }

    /// Takes out an edge with another CCB on each side.
    fn remove_between_two(&mut self, h: HalfedgeId) -> Removed {
        let twin = h.twin();
        let ccbs = [self.ccb(h), self.ccb(twin)];
        let inner = ccbs.into_iter().any(|c| self.ccb_kind(c) == CcbKind::Inner);
        // A halfedge that stays: those of the edge are both alone only if nothing else is there.
        let rest = [h, twin].into_iter().find_map(|h| (self.next(h) != h).then_some(self.next(h)));
        let Some(rest) = rest else {
            self.detach(h);
            self.detach(twin);
            ccbs.into_iter().for_each(|c| self.remove_ccb(c));
            return Removed::Vanished { faces: None };
        };
        let ccb = self.join_ccbs([h, twin]);
        self.detach(h);
        self.detach(twin);
        self.ccbs[ccb.index()].first = rest;
        self.set_ccb_kind(ccb, if inner { CcbKind::Inner } else { CcbKind::Outer });
        Removed::Joined { ccb, faces: None }
    }

    /// Takes the halfedge `h` away from its source, which becomes bare if it has no other edge.
    fn detach(&mut self, h: HalfedgeId) {
        let v: VertexId = self.source(h);
        let (prev, next) = (self.prev(h), self.next(h.twin()));
        if prev == h.twin() {
            self.vertices[v.index()] = VertexCell::BARE;
            return;
        }
        if self.outgoing(v) == Some(h) {
            self.vertices[v.index()] = VertexCell(next.0);
        }
        self.link(prev, next);
    }
}
