//! Edges and vertices go.

use super::{Editor, MergedEdges, VertexNeed, VertexNeeded};
use crate::edit::{Edit, Observer, Operation};
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use dcel::{EdgeId, EndFate, Removed, VertexId};

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Removes an edge. A vertex that is left without edges goes, too.
    ///
    /// If there were two faces beside the edge, they become one, which has the id of the face that had more CCBs and isolated vertices. If
    /// the other one was the [corner face], it is the corner face then. The kinds of CCBs in the answer are settled when it is given.
    ///
    /// Degenerate: a vertex that stands for a side stays. A vertex of which two edges are left that are one curve stays, too: see
    /// [`Editor::merge_edges`]. An artificial vertex that is left with one edge or none becomes an ordinary
    /// one.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids on both sides of the edge, in the length of the shorter of the CCBs that join or arise, and in
    /// the number of CCBs and isolated vertices of the face that goes.
    ///
    /// # References
    /// Thesis, section 2.3.2.
    ///
    /// # Examples
    /// ```
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// let triangle = [[[0, 0], [4, 0]], [[4, 0], [2, 3]], [[2, 3], [0, 0]]];
    /// let edges: Vec<_> = triangle
    ///     .iter()
    ///     .flat_map(|&ends| editor.insert_curve(&Segment::from_i64(ends).expect("the ends are different")))
    ///     .collect();
    /// editor.remove_edge(edges[0]);
    /// let counts = editor.counts();
    /// assert_eq!((counts.vertices, counts.edges, counts.faces), (3, 2, 1));
    /// editor.remove_edge(edges[1]);
    /// assert_eq!(editor.counts().vertices, 2, "the vertex (4, 0) went");
    /// ```
    ///
    /// [corner face]: crate::Arrangement::corner_face
    pub fn remove_edge(&mut self, e: EdgeId) -> Removed {
        self.remove_edge_with(e, [EndFate::Remove; 2])
    }

    /// Removes an edge; `fates` says what becomes of its min and of its max vertex if they have no other edge. Of a closed edge, which
    /// has one vertex, the first counts.
    ///
    /// Degenerate: a vertex that stands for a side stays in any case.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Complexity
    /// As of [`Editor::remove_edge`].
    pub fn remove_edge_with(&mut self, e: EdgeId, fates: [EndFate; 2]) -> Removed {
        assert!(self.arrangement.dcel().has_edge(e), "only an edge is removed");
        self.operate(Operation::RemoveEdge, |editor| editor.take_out_edge(e, fates))
    }

    /// Removes a vertex that no edge needs: one that is isolated, or one where two edges meet that are one curve. Those become one, and
    /// the answer names them.
    ///
    /// # Errors
    /// If the vertex stands for a side, or its edges need it. Then nothing is changed.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Complexity
    /// Constant for an isolated vertex; else as of [`Editor::merge_edges`].
    pub fn remove_vertex(&mut self, v: VertexId) -> Result<Option<MergedEdges>, VertexNeeded> {
        self.check_point(v)?;
        if self.arrangement.dcel().outgoing(v).is_none() {
            self.operate(Operation::RemoveVertex, |editor| editor.take_out_isolated(v));
            return Ok(None);
        }
        self.check_mergeable(v)?;
        self.operate(Operation::RemoveVertex, |editor| editor.merge_redundant(v)).map(Some)
    }

    /// Removes a vertex with all its edges, and gives these. Their other ends go, too, if they are left without edges.
    ///
    /// # Errors
    /// If the vertex stands for a side. Then nothing is changed.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Complexity
    /// For each edge, as of [`Editor::remove_edge`].
    pub fn remove_vertex_with_edges(&mut self, v: VertexId) -> Result<Vec<EdgeId>, VertexNeeded> {
        self.check_point(v)?;
        let mut edges: Vec<EdgeId> = self.arrangement.dcel().around(v).map(|h| h.edge_id()).collect();
        // A closed edge leaves the vertex twice.
        edges.sort_unstable();
        edges.dedup();
        self.operate(Operation::RemoveVertex, |editor| {
            if edges.is_empty() {
                editor.take_out_isolated(v);
            }
            for &e in &edges {
                editor.take_out_edge(e, [EndFate::Remove; 2]);
            }
        });
        Ok(edges)
    }

    fn check_point(&self, v: VertexId) -> Result<(), VertexNeeded> {
        assert!(self.arrangement.dcel().has_vertex(v), "only a vertex is removed");
        if self.arrangement.is_at_infinity(v) {
            return Err(VertexNeeded { vertex: v, reason: VertexNeed::Side });
        }
        Ok(())
    }

    /// Removes an edge within an operation: see [`Editor::remove_edge_with`].
    pub(crate) fn take_out_edge(&mut self, e: EdgeId, fates: [EndFate; 2]) -> Removed {
        let ends = self.arrangement.dcel().ends(e);
        let fate =
            |i: usize| if self.arrangement.is_at_infinity(ends[i]) { EndFate::Isolate } else { fates[i] };
        let fates = [fate(0), fate(if ends[0] == ends[1] { 0 } else { 1 })];
        self.trapezoids.remove_edge(&self.arrangement, e, fates);
        let removed = self.arrangement.remove_and_settle(e, fates, &mut self.observers);
        for v in ends {
            let dcel = self.arrangement.dcel();
            if dcel.has_vertex(v) && dcel.around(v).nth(1).is_none() {
                // Nothing is cut there any more.
                self.make_ordinary(v);
            }
        }
        removed
    }

    /// Removes a vertex without edges within an operation.
    pub(crate) fn take_out_isolated(&mut self, v: VertexId) {
        self.trapezoids.remove_sites_of(&self.arrangement, v);
        self.arrangement.apply(Edit::RemoveIsolatedVertex { v }, &mut self.observers);
    }
}
