//! Checking the structure against what it promises.
//!
//! Nothing is believed on the way: each step looks at the ids it follows, and walks no longer than what
//! it walks along can be. So every violation is found in one call, however many there are.

use super::lists::{Linked, NONE};
use super::{CcbKind, Dcel, Isolated, VertexState};
use crate::{CcbId, EdgeId, FaceId, HalfedgeId, VertexId};
use std::fmt;

/// A list of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FaceList {
    /// Its outer CCBs.
    Outer,
    /// Its inner CCBs.
    Inner,
    /// Its isolated vertices.
    Isolated,
}

/// Something that a [`Dcel`] promises and does not keep.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum DcelViolation {
    /// One halfedge of the edge is free and the other is not.
    Twin(EdgeId),
    /// The next or the previous halfedge does not exist, or does not know this one.
    NextPrev(HalfedgeId),
    /// The next halfedge does not start where this one ends.
    Chain(HalfedgeId),
    /// The source does not exist, or has no edges.
    Source(HalfedgeId),
    /// The CCB does not exist.
    Ccb(HalfedgeId),
    /// The next halfedge has another CCB.
    CcbOfNext(HalfedgeId),
    /// The stored halfedge of the CCB does not exist or has another CCB.
    CcbHalfedge(CcbId),
    /// The halfedges of the CCB are not one cycle.
    CcbCycle(CcbId),
    /// The face of the CCB does not exist.
    CcbFace(CcbId),
    /// The CCB is in no list of its face.
    CcbUnlisted(CcbId),
    /// The list is not well linked, or has an item that is not of this face and kind.
    List(FaceId, FaceList),
    /// The stored halfedge of the vertex does not exist or does not start there.
    Outgoing(VertexId),
    /// The halfedges that leave the vertex are not one cycle around it.
    VertexCycle(VertexId),
    /// The vertex is neither attached nor isolated.
    Bare(VertexId),
    /// The vertex is isolated, but its record is that of another one.
    Place(VertexId),
    /// The face of the isolated vertex does not exist.
    IsolatedFace(VertexId),
    /// The isolated vertex is not in the list of its face.
    IsolatedUnlisted(VertexId),
    /// The record of an isolated vertex names a vertex that is none.
    PlaceUnused(u32),
    /// The vertex is free and not listed as such, or the other way round, or listed twice.
    FreeVertex(VertexId),
    /// The same of an edge.
    FreeEdge(EdgeId),
    /// The same of a CCB.
    FreeCcb(CcbId),
    /// The same of a face.
    FreeFace(FaceId),
    /// The same of a record of an isolated vertex.
    FreePlace(u32),
    /// Components and faces hang together in several pieces: that is no connected surface.
    Pieces(usize),
    /// The surface must have a higher genus for these CCBs.
    Genus {
        /// The least genus that there can be.
        least: usize,
        /// The genus that the surface is said to have.
        given: usize,
    },
    /// `V - E + F` is not `1 + C`, as it is on the sphere and in the plane.
    Euler {
        /// The value of `V - E + F`.
        characteristic: i64,
        /// The number of components, `C`.
        components: usize,
    },
}

impl fmt::Display for DcelViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Twin(e) => write!(f, "one half of edge {} is free", e.0),
            Self::NextPrev(h) => write!(f, "next and prev are not inverse at halfedge {}", h.0),
            Self::Chain(h) => write!(f, "the halfedge after {} does not start where that one ends", h.0),
            Self::Source(h) => write!(f, "the source of halfedge {} has no edges", h.0),
            Self::Ccb(h) => write!(f, "the CCB of halfedge {} does not exist", h.0),
            Self::CcbOfNext(h) => write!(f, "the halfedge after {} has another CCB", h.0),
            Self::CcbHalfedge(c) => write!(f, "the stored halfedge of CCB {} has another one", c.0),
            Self::CcbCycle(c) => write!(f, "the halfedges of CCB {} are not one cycle", c.0),
            Self::CcbFace(c) => write!(f, "the face of CCB {} does not exist", c.0),
            Self::CcbUnlisted(c) => write!(f, "CCB {} is in no list of its face", c.0),
            Self::List(face, list) => write!(f, "the {list:?} list of face {} is broken", face.0),
            Self::Outgoing(v) => write!(f, "the stored halfedge of vertex {} does not start there", v.0),
            Self::VertexCycle(v) => write!(f, "the halfedges that leave vertex {} are not one cycle", v.0),
            Self::Bare(v) => write!(f, "vertex {} is neither attached nor isolated", v.0),
            Self::Place(v) => write!(f, "the record of isolated vertex {} is not its own", v.0),
            Self::IsolatedFace(v) => write!(f, "the face of isolated vertex {} does not exist", v.0),
            Self::IsolatedUnlisted(v) => write!(f, "isolated vertex {} is not in the list of its face", v.0),
            Self::PlaceUnused(i) => write!(f, "record {i} of the isolated vertices is nobody's"),
            Self::FreeVertex(v) => write!(f, "vertex {} is in use and free", v.0),
            Self::FreeEdge(e) => write!(f, "edge {} is in use and free", e.0),
            Self::FreeCcb(c) => write!(f, "CCB {} is in use and free", c.0),
            Self::FreeFace(g) => write!(f, "face {} is in use and free", g.0),
            Self::FreePlace(i) => write!(f, "record {i} of the isolated vertices is in use and free"),
            Self::Pieces(n) => write!(f, "the surface falls in {n} pieces"),
            Self::Genus { least, given } => write!(f, "a surface of genus {given} would need genus {least}"),
            Self::Euler { characteristic, components } => {
                write!(f, "V - E + F is {characteristic}, with {components} components")
            }
        }
    }
}

impl std::error::Error for DcelViolation {}

impl Dcel {
    /// Lists every violation of what the structure promises, sorted; none for a valid one.
    ///
    /// What it promises: `next` and `prev` are inverse, and a halfedge starts where the one before it
    /// ends; the halfedges of a CCB are one cycle, and those that leave a vertex are one cycle around it;
    /// a vertex is either attached or isolated; each CCB and each isolated vertex is in the right list of
    /// its face, once; nothing uses a removed cell. It says nothing of the surface: that is what
    /// [`check_euler`](Self::check_euler) does.
    ///
    /// # Complexity
    /// Linear, but for the sorting of violations.
    pub fn check_valid(&self) -> Vec<DcelViolation> {
        let mut found = Vec::new();
        self.check_free(&mut found);
        self.check_halfedges(&mut found);
        self.check_ccbs(&mut found);
        self.check_vertices(&mut found);
        self.check_lists(&mut found);
        found.sort_unstable();
        found.dedup();
        found
    }

    fn check_free(&self, found: &mut Vec<DcelViolation>) {
        use DcelViolation as D;
        let edges = (0..self.edge_bound()).map(|e| self.has_edge(EdgeId::new(e)));
        check_free(&self.free_edges, edges, |i| D::FreeEdge(EdgeId(i)), found);
        let vertices = (0..self.vertex_bound()).map(|v| self.has_vertex(VertexId::new(v)));
        check_free(&self.free_vertices, vertices, |i| D::FreeVertex(VertexId(i)), found);
        let ccbs = (0..self.ccb_bound()).map(|c| self.has_ccb(CcbId::new(c)));
        check_free(&self.free_ccbs, ccbs, |i| D::FreeCcb(CcbId(i)), found);
        let faces = (0..self.face_bound()).map(|f| self.has_face(FaceId::new(f)));
        check_free(&self.free_faces, faces, |i| D::FreeFace(FaceId(i)), found);
        let places = self.isolated.iter().map(|place| *place != Isolated::FREE);
        check_free(&self.free_isolated, places, D::FreePlace, found);
    }

    /// Whether the halfedge itself, not only its edge, is there.
    fn is_used(&self, h: HalfedgeId) -> bool {
        self.halfedges.get(h.index()).is_some_and(|record| record.source != VertexId::NONE)
    }

    fn check_halfedges(&self, found: &mut Vec<DcelViolation>) {
        for h in (0..self.halfedge_bound()).map(HalfedgeId::new) {
            if !self.is_used(h) {
                if self.is_used(h.twin()) {
                    found.push(DcelViolation::Twin(h.edge_id()));
                }
                continue;
            }
            let (next, prev) = (self.next(h), self.prev(h));
            let known = self.is_used(next) && self.is_used(prev);
            if !known || self.prev(next) != h || self.next(prev) != h {
                found.push(DcelViolation::NextPrev(h));
            }
            if self.is_used(next) {
                if self.target(h) != self.source(next) {
                    found.push(DcelViolation::Chain(h));
                }
                if self.ccb(h) != self.ccb(next) {
                    found.push(DcelViolation::CcbOfNext(h));
                }
            }
            let cell = self.vertices.get(self.source(h).index());
            if !cell.is_some_and(|cell| matches!(cell.state(), VertexState::Attached(_))) {
                found.push(DcelViolation::Source(h));
            }
            if !self.has_ccb(self.ccb(h)) {
                found.push(DcelViolation::Ccb(h));
            }
        }
    }

    fn check_ccbs(&self, found: &mut Vec<DcelViolation>) {
        let counts = self.count_by(self.ccb_bound(), |h| self.ccb(h).index());
        for c in self.ccbs() {
            let first = self.ccb_halfedge(c);
            if !self.is_used(first) || self.ccb(first) != c {
                found.push(DcelViolation::CcbHalfedge(c));
            } else if !self.is_cycle(first, counts[c.index()], |h| Some(self.next(h))) {
                found.push(DcelViolation::CcbCycle(c));
            }
            if !self.has_face(self.ccb_face(c)) {
                found.push(DcelViolation::CcbFace(c));
            }
        }
    }

    fn check_vertices(&self, found: &mut Vec<DcelViolation>) {
        let counts = self.count_by(self.vertex_bound(), |h| self.source(h).index());
        for v in self.vertices() {
            match self.vertices[v.index()].state() {
                VertexState::Attached(h) if !self.is_used(h) || self.source(h) != v => {
                    found.push(DcelViolation::Outgoing(v));
                }
                VertexState::Attached(h) => {
                    let step = |h| self.is_used(self.prev(h)).then(|| self.prev(h).twin());
                    if !self.is_cycle(h, counts[v.index()], step) {
                        found.push(DcelViolation::VertexCycle(v));
                    }
                }
                VertexState::Isolated(place) => match self.isolated.get(place as usize) {
                    Some(record) if record.vertex == v => {
                        if !self.has_face(record.face) {
                            found.push(DcelViolation::IsolatedFace(v));
                        }
                    }
                    _ => found.push(DcelViolation::Place(v)),
                },
                VertexState::Bare => found.push(DcelViolation::Bare(v)),
                VertexState::Free => {}
            }
        }
        for (i, record) in self.isolated.iter().enumerate().filter(|(_, r)| **r != Isolated::FREE) {
            let cell = self.vertices.get(record.vertex.index());
            if cell.map(|cell| cell.state()) != Some(VertexState::Isolated(i as u32)) {
                found.push(DcelViolation::PlaceUnused(i as u32));
            }
        }
    }

    fn check_lists(&self, found: &mut Vec<DcelViolation>) {
        let mut ccbs = vec![false; self.ccb_bound()];
        let mut places = vec![false; self.isolated.len()];
        for f in self.faces() {
            let face = self.faces[f.index()];
            let is_mine = |c: u32, kind| self.has_ccb(CcbId(c)) && self.ccbs[c as usize].is_of(f, kind);
            if !is_list(&self.ccbs, face.outer, &mut ccbs, |c| is_mine(c, CcbKind::Outer)) {
                found.push(DcelViolation::List(f, FaceList::Outer));
            }
            if !is_list(&self.ccbs, face.inner, &mut ccbs, |c| is_mine(c, CcbKind::Inner)) {
                found.push(DcelViolation::List(f, FaceList::Inner));
            }
            let is_mine = |i: u32| self.isolated[i as usize].face == f;
            if !is_list(&self.isolated, face.isolated, &mut places, is_mine) {
                found.push(DcelViolation::List(f, FaceList::Isolated));
            }
        }
        found.extend(self.ccbs().filter(|c| !ccbs[c.index()]).map(DcelViolation::CcbUnlisted));
        for (record, listed) in self.isolated.iter().zip(places) {
            if *record != Isolated::FREE && !listed {
                found.push(DcelViolation::IsolatedUnlisted(record.vertex));
            }
        }
    }

    /// How many halfedges have each key; keys out of range do not count.
    fn count_by(&self, bound: usize, key: impl Fn(HalfedgeId) -> usize) -> Vec<usize> {
        let mut counts = vec![0; bound];
        for h in (0..self.halfedge_bound()).map(HalfedgeId::new).filter(|&h| self.is_used(h)) {
            if let Some(count) = counts.get_mut(key(h)) {
                *count += 1;
            }
        }
        counts
    }

    /// Whether `count` steps lead from `first` back to it, and no fewer.
    fn is_cycle(
        &self,
        first: HalfedgeId,
        count: usize,
        step: impl Fn(HalfedgeId) -> Option<HalfedgeId>,
    ) -> bool {
        let mut h = first;
        for steps in 1..=count {
            match step(h) {
                Some(next) if self.is_used(next) => h = next,
                _ => return false,
            }
            if h == first {
                return steps == count;
            }
        }
        false
    }
}

/// Whether the list from `head` is well linked and has only items that are wanted and not listed yet.
/// Marks them as listed.
fn is_list<T: Linked>(items: &[T], head: u32, listed: &mut [bool], wanted: impl Fn(u32) -> bool) -> bool {
    if head == NONE {
        return true;
    }
    let mut item = head;
    loop {
        match listed.get_mut(item as usize) {
            Some(mark @ false) if wanted(item) => *mark = true,
            _ => return false,
        }
        let next = items[item as usize].links().next;
        if items.get(next as usize).is_none_or(|next| next.links().prev != item) {
            return false;
        }
        if next == head {
            return true;
        }
        item = next;
    }
}

/// Finds the cells of a kind that are listed as free and used, free and not listed, or listed twice.
fn check_free(
    listed: &[u32],
    used: impl ExactSizeIterator<Item = bool>,
    violation: impl Fn(u32) -> DcelViolation,
    found: &mut Vec<DcelViolation>,
) {
    let mut times = vec![0u32; used.len()];
    for &i in listed {
        match times.get_mut(i as usize) {
            Some(times) => *times += 1,
            None => found.push(violation(i)),
        }
    }
    for (i, used) in used.enumerate() {
        if times[i] != u32::from(!used) {
            found.push(violation(i as u32));
        }
    }
}
