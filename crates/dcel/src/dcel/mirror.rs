//! The structure seen from the other side of the surface, and vertices and halfedges that exchange their ids.

use super::{Dcel, Halfedge, VertexCell, VertexState};
use crate::{EdgeId, HalfedgeId, VertexId};

impl Dcel {
    /// Gives the mirror image. All cells keep their ids; the order around each vertex is the reverse, so a halfedge has on its left the face that it had
    /// on its right. Kinds of CCBs stay as they are.
    ///
    /// Law: the mirror image of the mirror image is the structure itself.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// ```
    /// use splitstar_dcel::{CcbKind::Inner, Dcel, FaceId};
    /// let mut star = Dcel::new();
    /// let [center, a, b, c] = [(); 4].map(|()| star.add_vertex());
    /// let first = star.insert_edge_in_face(center, a, FaceId(0), Inner).halfedge();
    /// let second = star.insert_edge_from(first.twin(), b).halfedge();
    /// let third = star.insert_edge_from(second.twin(), c).halfedge();
    /// let mirrored = star.mirrored();
    /// let before: Vec<_> = star.around(center).collect();
    /// let mut after: Vec<_> = mirrored.around(center).collect();
    /// after[1..].reverse();
    /// assert_eq!(before, after);
    /// # assert!(before.contains(&third) && mirrored.check_valid().is_empty());
    /// ```
    pub fn mirrored(&self) -> Self {
        let mut mirrored = self.clone();
        for h in self.halfedges() {
            // What lies on the left of h lay on the right, and is walked along the other way.
            let Halfedge { next, prev, ccb, .. } = self.halfedges[h.twin().index()];
            let source = self.source(h);
            mirrored.halfedges[h.index()] = Halfedge { next: prev.twin(), prev: next.twin(), source, ccb };
        }
        for c in self.ccbs() {
            mirrored.ccbs[c.index()].first = self.ccb_halfedge(c).twin();
        }
        mirrored
    }

    /// Exchanges the ids of the two halfedges of some edges. Nothing else changes.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// ```
    /// use splitstar_dcel::{CcbKind::Inner, Dcel, FaceId};
    /// let mut path = Dcel::new();
    /// let [a, b, c] = [(); 3].map(|()| path.add_vertex());
    /// let first = path.insert_edge_in_face(a, b, FaceId(0), Inner).halfedge();
    /// let second = path.insert_edge_from(first, c).halfedge();
    /// path.turn_edges(|e| e == first.edge_id());
    /// assert_eq!([path.source(first), path.source(second)], [b, b]);
    /// assert_eq!(path.next(first.twin()), second);
    /// # assert!(path.check_valid().is_empty());
    /// ```
    pub fn turn_edges(&mut self, is_turned: impl Fn(EdgeId) -> bool) {
        let is_turned: Vec<bool> = (0..self.edge_bound()).map(|e| is_turned(EdgeId::new(e))).collect();
        // What is none stays none.
        let new_id = |h: HalfedgeId| match is_turned.get(h.edge()) {
            Some(true) => h.twin(),
            _ => h,
        };
        for halfedge in &mut self.halfedges {
            halfedge.next = new_id(halfedge.next);
            halfedge.prev = new_id(halfedge.prev);
        }
        for e in (0..is_turned.len()).filter(|&e| is_turned[e]) {
            self.halfedges.swap(2 * e, 2 * e + 1);
        }
        for ccb in &mut self.ccbs {
            ccb.first = new_id(ccb.first);
        }
        for vertex in &mut self.vertices {
            if let VertexState::Attached(h) = vertex.state() {
                *vertex = VertexCell(new_id(h).0);
            }
        }
    }

    /// Exchanges the ids of two vertices. Nothing else changes.
    ///
    /// # Panics
    /// If one of them is not there.
    ///
    /// # Complexity
    /// Linear in their degrees.
    pub fn exchange_vertices(&mut self, v: VertexId, w: VertexId) {
        assert!(self.has_vertex(v) && self.has_vertex(w), "vertices that are there are exchanged");
        let leaving = [v, w].map(|v| self.around(v).collect::<Vec<HalfedgeId>>());
        let places = [v, w].map(|v| match self.vertices[v.index()].state() {
            VertexState::Isolated(place) => Some(place as usize),
            _ => None,
        });
        for (i, new) in [w, v].into_iter().enumerate() {
            for h in &leaving[i] {
                self.halfedges[h.index()].source = new;
            }
            if let Some(place) = places[i] {
                self.isolated[place].vertex = new;
            }
        }
        self.vertices.swap(v.index(), w.index());
    }
}
