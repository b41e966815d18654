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
    /// Degenerate: a vertex at infinity stays; a pole goes as others do, and its vertex becomes [absent](crate::Arrangement::is_absent). A vertex of which two edges are left that are one curve stays, too: see
    /// [`Editor::merge_edges`]. An artificial vertex that is left with one edge or none becomes an ordinary
    /// one.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids on both sides of the edge, in the length of the shorter of the CCBs that join or arise, and in
    /// the number of CCBs and isolated vertices of the face that goes. Where one pair of sides is identified, as on a sphere, linear in the
    /// length of all CCBs that join or arise.
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
    /// Degenerate: a vertex at infinity stays in any case. A pole that is to be isolated is like a point that was given there.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Complexity
    /// As of [`Editor::remove_edge`].
    pub fn remove_edge_with(&mut self, e: EdgeId, fates: [EndFate; 2]) -> Removed {
        let is_edge = self.arrangement.dcel().has_edge(e);
        assert!(is_edge, "edge {} does not exist: only an edge is removed", e.0);
        self.operate(Operation::RemoveEdge, |editor| editor.take_out_edge(e, fates))
    }

    /// Removes several edges, as those of a curve that [`Editor::insert_curve`] gave, and vertices that are of no use without them. Gives
    /// the edges that became one, in the order in which they did.
    ///
    /// A list of edges is good until the next edit: a curve that comes later cuts edges, and ids are used again.
    /// [`ArrangementWithHistory`](crate::history::ArrangementWithHistory) keeps such lists.
    ///
    /// What becomes of the vertices at which a removed edge ended; all other ones stay as they are:
    ///
    /// - One that is left without edges goes, but one at infinity stays.
    /// - One that is left with two edges of one support, of which one ends and the other begins there, goes, and the edges become one: the
    ///   curve passes there, and was only divided. That is what
    ///   [`ArrangementWithHistory`](crate::history::ArrangementWithHistory) does if nobody needs the vertex. But nobody is asked here: also a
    ///   vertex goes that was made by [`Editor::insert_point`], and one at which another curve begins or ends that overlaps that one.
    /// - All others stay. So does one with two edges on different supports, even if [`UMonotoneTraits::merge`] would join these: a curve may end
    ///   there. And so does one on an identified side, where a curve was cut; if it became an ordinary vertex, it stays that.
    ///
    /// An edge goes with all curves that run along it. Nothing is known of those that were inserted besides the one that it is stored with.
    ///
    /// # Panics
    /// If there is no such edge, or one comes twice. Then nothing is changed.
    ///
    /// # Complexity
    /// For each edge, as of [`Editor::remove_edge`], and for each that is merged, as of [`Editor::merge_edges`]; and O(n log n) for n edges.
    ///
    /// # References
    /// Thesis, section 2.3.2.
    ///
    /// # Examples
    /// ```
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
    /// let first = editor.insert_curve(&segment([[0, 0], [4, 4]]));
    /// let second = editor.insert_curve(&segment([[0, 4], [4, 0]]));
    /// assert_eq!(editor.counts().edges, 4);
    /// let merged = editor.remove_edges(&second);
    /// assert_eq!((editor.counts().vertices, editor.counts().edges), (2, 1), "the crossing went");
    /// assert_eq!(merged[0].kept, first[0]);
    /// ```
    pub fn remove_edges(&mut self, edges: &[EdgeId]) -> Vec<MergedEdges> {
        let dcel = self.arrangement.dcel();
        for e in edges {
            assert!(dcel.has_edge(*e), "edge {} does not exist: only an edge is removed", e.0);
        }
        let mut sorted = edges.to_vec();
        sorted.sort_unstable();
        for pair in sorted.windows(2) {
            assert!(pair[0] != pair[1], "edge {} comes twice: an edge is removed once", pair[0].0);
        }
        let mut touched: Vec<VertexId> = edges.iter().flat_map(|&e| dcel.ends(e)).collect();
        touched.sort_unstable();
        touched.dedup();
        self.operate(Operation::RemoveCurve, |editor| {
            for &e in edges {
                editor.take_out_edge(e, [EndFate::Remove; 2]);
            }
            touched.into_iter().filter_map(|v| editor.merge_if_passed(v)).collect()
        })
    }

    /// Merges the edges at a vertex, if it is still there and one curve passes it and has both.
    fn merge_if_passed(&mut self, v: VertexId) -> Option<MergedEdges> {
        let dcel = self.arrangement.dcel();
        if !dcel.has_vertex(v) {
            return None;
        }
        let mut supports = dcel.around(v).map(|h| self.arrangement.support(h.edge_id()));
        let are_one =
            matches!((supports.next(), supports.next(), supports.next()), (Some(a), Some(b), None) if a == b);
        drop(supports);
        if are_one { self.merge_redundant(v).ok() } else { None }
    }

    /// Removes a vertex that no edge needs: one that is isolated, or one where two edges meet that are one curve. Those become one, and
    /// the answer names them.
    ///
    /// # Errors
    /// If the vertex is at infinity, or its edges need it. Then nothing is changed.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Complexity
    /// Constant for an isolated vertex; else as of [`Editor::merge_edges`].
    ///
    /// # Examples
    /// ```
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// editor.insert_curve(&Segment::from_i64([[0, 0], [4, 0]]).expect("the ends are different"));
    /// let [alone, middle, end] = [[1, 1], [2, 0], [4, 0]].map(|at| editor.insert_point(&Point2::from_i64(at)));
    /// assert_eq!(editor.remove_vertex(alone), Ok(None));
    /// let merged = editor.remove_vertex(middle)?.expect("two edges meet there");
    /// assert_eq!(editor.dcel().edges().collect::<Vec<_>>(), [merged.kept]);
    /// assert!(editor.remove_vertex(end).is_err(), "the edge needs it");
    /// # Ok::<(), splitstar_arrangement::VertexNeeded>(())
    /// ```
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
        let is_vertex = self.arrangement.dcel().has_vertex(v);
        assert!(is_vertex, "vertex {} does not exist: only a vertex is removed", v.0);
        if self.arrangement.is_at_infinity(v) || self.arrangement.is_absent(v) {
            return Err(VertexNeeded { vertex: v, reason: VertexNeed::Side });
        }
        Ok(())
    }

    /// Removes an edge within an operation: see [`Editor::remove_edge_with`].
    pub(crate) fn take_out_edge(&mut self, e: EdgeId, fates: [EndFate; 2]) -> Removed {
        let (ends, wanted) = (self.arrangement.dcel().ends(e), fates);
        let fate =
            |i: usize| if self.arrangement.stands_for_side(ends[i]) { EndFate::Isolate } else { fates[i] };
        let fates = [fate(0), fate(if ends[0] == ends[1] { 0 } else { 1 })];
        self.trapezoids.remove_edge(&self.arrangement, e, fates);
        let removed = self.arrangement.remove_and_settle(e, fates, &mut self.observers);
        for v in ends {
            let dcel = self.arrangement.dcel();
            if !dcel.has_vertex(v) || dcel.around(v).nth(1).is_some() {
                continue;
            }
            let is_last = dcel.outgoing(v).is_none() && self.arrangement.is_contraction(v);
            if is_last && wanted[usize::from(v != ends[0])] == EndFate::Remove {
                self.take_out_isolated(v);
            } else {
                // Nothing is cut there any more.
                self.make_ordinary(v);
            }
        }
        removed
    }

    /// Removes a vertex without edges within an operation.
    pub(crate) fn take_out_isolated(&mut self, v: VertexId) {
        if self.arrangement.is_contraction(v) {
            // The vertex stays, and nothing is there.
            if !self.arrangement.is_artificial[v.index()] {
                self.arrangement.apply(Edit::SetArtificial { v, is_artificial: true }, &mut self.observers);
            }
            return;
        }
        self.trapezoids.remove_sites_of(&self.arrangement, v);
        self.arrangement.apply(Edit::RemoveIsolatedVertex { v }, &mut self.observers);
    }
}
