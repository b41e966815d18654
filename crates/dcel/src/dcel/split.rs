//! Edits inside an edge: it is split at a vertex, merged with the next one, or turned round.

use super::{Dcel, VertexCell};
use crate::{EdgeId, HalfedgeId, VertexId};

impl Dcel {
    /// Splits `e` at `v`, a vertex just [added](Self::add_vertex). The part at the min vertex keeps the
    /// id; the other part, which is returned, runs from `v` to the max vertex of `e`.
    ///
    /// # Panics
    /// If there is no such edge, or `v` is attached, isolated or removed.
    ///
    /// # Complexity
    /// Constant, amortized.
    pub fn split_edge(&mut self, e: EdgeId, v: VertexId) -> EdgeId {
        assert!(self.has_edge(e), "only an edge is split");
        assert!(self.vertices[v.index()] == VertexCell::BARE, "an edge is split at a new vertex");
        let (h, twin) = (e.halfedge(), e.halfedge().twin());
        let max = self.source(twin);
        let new = self.new_edge([v, max]);
        let (new_h, new_twin) = (new.halfedge(), new.halfedge().twin());
        self.halfedges[new_h.index()].ccb = self.ccb(h);
        self.halfedges[new_twin.index()].ccb = self.ccb(twin);
        let (next, prev) = (self.next(h), self.prev(twin));
        if next == twin {
            self.link(new_h, new_twin);
        } else {
            self.link(new_h, next);
            self.link(prev, new_twin);
        }
        self.link(h, new_h);
        self.link(new_twin, twin);
        self.halfedges[twin.index()].source = v;
        self.vertices[v.index()] = VertexCell(new_h.0);
        if self.outgoing(max) == Some(twin) {
            self.vertices[max.index()] = VertexCell(new_twin.0);
        }
        new
    }

    /// Merges the two edges at `v` and removes `v`: the inverse of [`split_edge`](Self::split_edge). The
    /// edge `kept` reaches on to the other end of the other edge, and keeps its direction. Returns the id
    /// that is no more.
    ///
    /// # Panics
    /// If `v` has not exactly two edges, `kept` one of them, or its two halfedges are of one edge.
    ///
    /// # Complexity
    /// Constant, amortized.
    pub fn merge_edges(&mut self, kept: EdgeId, v: VertexId) -> EdgeId {
        assert!(self.has_edge(kept) && self.ends(kept).contains(&v), "the edge ends at the vertex");
        let out = kept.halfedge();
        let h = if self.target(out) == v { out } else { out.twin() };
        let (twin, away) = (h.twin(), self.next(h));
        assert!(
            away.edge_id() != kept && self.next(away.twin()) == twin,
            "two edges are merged at a vertex that has no others"
        );
        let back = away.twin();
        let (next, prev, end) = (self.next(away), self.prev(back), self.target(away));
        if next == back {
            self.link(h, twin);
        } else {
            self.link(h, next);
            self.link(prev, twin);
        }
        self.halfedges[twin.index()].source = end;
        if self.outgoing(end) == Some(back) {
            self.vertices[end.index()] = VertexCell(twin.0);
        }
        for (gone, stays) in [(away, h), (back, twin)] {
            let ccb = self.ccb(gone);
            if self.ccb_halfedge(ccb) == gone {
                self.ccbs[ccb.index()].first = stays;
            }
        }
        self.free_edge(away.edge_id());
        self.free_vertex(v);
        away.edge_id()
    }

    /// Exchanges the two halfedges of `e`: its min vertex becomes its max vertex. Nothing else changes.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Complexity
    /// Constant.
    pub fn reverse_edge(&mut self, e: EdgeId) {
        assert!(self.has_edge(e), "only an edge is turned round");
        let (h, twin) = (e.halfedge(), e.halfedge().twin());
        let renamed = |x: HalfedgeId| if x.edge_id() == e { x.twin() } else { x };
        let ([c, d], [v, w]) = ([self.ccb(h), self.ccb(twin)], self.ends(e));
        // What both halfedges share is renamed once.
        let firsts = [c, d].map(|c| renamed(self.ccb_halfedge(c)));
        let outgoing = [v, w].map(|v| self.outgoing(v).map(renamed));
        for (c, first) in [c, d].into_iter().zip(firsts) {
            self.ccbs[c.index()].first = first;
        }
        for (v, out) in [v, w].into_iter().zip(outgoing) {
            let out = out.expect("an end of an edge is attached");
            self.vertices[v.index()] = VertexCell(out.0);
        }
        self.halfedges.swap(h.index(), twin.index());
        let records = [h, twin].map(|x| (x, self.halfedges[x.index()]));
        for (x, record) in records {
            self.link(x, renamed(record.next));
            self.link(renamed(record.prev), x);
        }
    }
}
