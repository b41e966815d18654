//! Edits that touch no edge: vertices come and go, and what a face has moves to another face.

use super::lists;
use super::{Ccb, CcbKind, Dcel, Face, ISOLATED, Isolated, VertexCell, VertexState};
use crate::{CcbId, FaceId, HalfedgeId, VertexId};

impl Dcel {
    /// Adds a vertex that is neither attached nor isolated: for use by the next call that inserts or
    /// splits an edge.
    ///
    /// # Complexity
    /// Constant, amortized.
    pub fn add_vertex(&mut self) -> VertexId {
        if let Some(v) = self.free_vertices.pop() {
            self.vertices[v as usize] = VertexCell::BARE;
            return VertexId(v);
        }
        self.vertices.push(VertexCell::BARE);
        VertexId::new(self.vertices.len() - 1)
    }

    /// Adds an isolated vertex in `face`.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Complexity
    /// Constant, amortized.
    pub fn add_isolated_vertex(&mut self, face: FaceId) -> VertexId {
        let v = self.add_vertex();
        self.isolate(v, face);
        v
    }

    /// Removes a vertex that has no edge.
    ///
    /// # Panics
    /// If `v` is attached or removed already.
    ///
    /// # Complexity
    /// Constant, amortized.
    pub fn remove_isolated_vertex(&mut self, v: VertexId) {
        self.make_bare(v);
        self.free_vertex(v);
    }

    /// Moves the isolated vertex `v` to another face.
    ///
    /// # Panics
    /// If `v` is not isolated or there is no such face.
    ///
    /// # Complexity
    /// Constant.
    pub fn move_isolated_vertex(&mut self, v: VertexId, face: FaceId) {
        assert!(self.isolated_face(v).is_some(), "only an isolated vertex lies in a face");
        self.make_bare(v);
        self.isolate(v, face);
    }

    /// Moves `ccb` to another face. Its kind stays.
    ///
    /// # Panics
    /// If there is no such CCB or no such face.
    ///
    /// # Complexity
    /// Constant.
    pub fn move_ccb(&mut self, ccb: CcbId, face: FaceId) {
        let kind = self.ccb_kind(ccb);
        self.place_ccb(ccb, face, kind);
    }

    /// Changes the kind of `ccb`, which comes last in its list then.
    ///
    /// # Panics
    /// If there is no such CCB.
    ///
    /// # Complexity
    /// Constant.
    pub fn set_ccb_kind(&mut self, ccb: CcbId, kind: CcbKind) {
        if self.ccb_kind(ccb) != kind {
            self.place_ccb(ccb, self.ccb_face(ccb), kind);
        }
    }

    /// Makes `ccb` the one CCB of a new face. What else belongs there is for the caller to move.
    ///
    /// # Panics
    /// If there is no such CCB.
    ///
    /// # Complexity
    /// Constant, amortized.
    pub fn split_face(&mut self, ccb: CcbId) -> FaceId {
        let face = self.free_faces.pop().map_or_else(
            || {
                assert!(self.faces.len() < (1 << 31), "there are fewer than 2^31 faces");
                self.faces.push(Face::EMPTY);
                FaceId::new(self.faces.len() - 1)
            },
            FaceId,
        );
        self.faces[face.index()] = Face::EMPTY;
        self.move_ccb(ccb, face);
        face
    }

    /// Moves all that `gone` has to `kept`, and removes `gone`.
    ///
    /// # Panics
    /// If the faces are the same, or one of them does not exist.
    ///
    /// # Complexity
    /// Linear in the number of CCBs and isolated vertices of `gone`.
    pub fn merge_faces(&mut self, kept: FaceId, gone: FaceId) {
        assert!(kept != gone && self.has_face(kept) && self.has_face(gone), "two faces are merged");
        for kind in [CcbKind::Outer, CcbKind::Inner] {
            loop {
                let head = *self.faces[gone.index()].head_mut(kind);
                if head == lists::NONE {
                    break;
                }
                self.place_ccb(CcbId(head), kept, kind);
            }
        }
        while let Some(v) = self.first_isolated(gone) {
            self.move_isolated_vertex(v, kept);
        }
        self.faces[gone.index()] = Face::FREE;
        self.free_faces.push(gone.0);
    }

    fn first_isolated(&self, face: FaceId) -> Option<VertexId> {
        self.isolated_vertices(face).next()
    }

    /// Puts a vertex without edges into the list of a face.
    pub(super) fn isolate(&mut self, vertex: VertexId, face: FaceId) {
        assert!(self.has_face(face), "an isolated vertex lies in a face");
        let record = Isolated { vertex, face, links: lists::Links::NONE };
        let place = if let Some(place) = self.free_isolated.pop() {
            self.isolated[place as usize] = record;
            place
        } else {
            // The two last numbers say that a vertex is bare, and that it is free.
            assert!(self.isolated.len() < ISOLATED as usize - 2, "too many isolated vertices");
            self.isolated.push(record);
            self.isolated.len() as u32 - 1
        };
        self.vertices[vertex.index()] = VertexCell::isolated(place);
        lists::push_back(&mut self.isolated, &mut self.faces[face.index()].isolated, place);
    }

    /// Takes a vertex without edges out of the list of its face, if it is in one.
    ///
    /// # Panics
    /// If it is attached or free.
    pub(super) fn make_bare(&mut self, v: VertexId) {
        match self.vertices[v.index()].state() {
            VertexState::Bare => {}
            VertexState::Isolated(place) => {
                let face = self.isolated[place as usize].face;
                lists::unlink(&mut self.isolated, &mut self.faces[face.index()].isolated, place);
                self.isolated[place as usize] = Isolated::FREE;
                self.free_isolated.push(place);
                self.vertices[v.index()] = VertexCell::BARE;
            }
            VertexState::Attached(_) | VertexState::Free => {
                panic!("vertex {} is attached or removed", v.0)
            }
        }
    }

    pub(super) fn free_vertex(&mut self, v: VertexId) {
        self.vertices[v.index()] = VertexCell::FREE;
        self.free_vertices.push(v.0);
    }

    /// Adds a CCB to the lists of its face.
    pub(super) fn add_ccb(&mut self, first: HalfedgeId, face: FaceId, kind: CcbKind) -> CcbId {
        assert!(self.has_face(face), "a CCB belongs to a face");
        let record = Ccb::new(first, face, kind);
        let ccb = if let Some(ccb) = self.free_ccbs.pop() {
            self.ccbs[ccb as usize] = record;
            CcbId(ccb)
        } else {
            self.ccbs.push(record);
            CcbId::new(self.ccbs.len() - 1)
        };
        lists::push_back(&mut self.ccbs, self.faces[face.index()].head_mut(kind), ccb.0);
        ccb
    }

    /// Takes a CCB out of the lists of its face, and removes it.
    pub(super) fn remove_ccb(&mut self, ccb: CcbId) {
        let record = self.ccbs[ccb.index()];
        let head = self.faces[record.face().index()].head_mut(record.kind());
        lists::unlink(&mut self.ccbs, head, ccb.0);
        self.ccbs[ccb.index()] = Ccb::FREE;
        self.free_ccbs.push(ccb.0);
    }

    /// Puts a CCB into another list.
    fn place_ccb(&mut self, ccb: CcbId, face: FaceId, kind: CcbKind) {
        assert!(self.has_ccb(ccb) && self.has_face(face), "a CCB belongs to a face");
        let old = self.ccbs[ccb.index()];
        lists::unlink(&mut self.ccbs, self.faces[old.face().index()].head_mut(old.kind()), ccb.0);
        self.ccbs[ccb.index()] = Ccb::new(old.first, face, kind);
        lists::push_back(&mut self.ccbs, self.faces[face.index()].head_mut(kind), ccb.0);
    }
}
