//! Edges are split, and points and curves replaced, where nothing moves.

use super::Editor;
use crate::arrangement::assemble::covers;
use crate::edit::{Edit, Observer, Operation};
use crate::overlay::Cell;
use crate::topology::Topology;
use crate::traits::{Intersection, UMonotoneTraits};
use dcel::{EdgeId, VertexId};

/// An edge that was split.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct SplitParts {
    /// The vertex between the two parts.
    pub vertex: VertexId,
    /// The two parts: the first one ends at the vertex and keeps the id, the second one begins there.
    pub edges: [EdgeId; 2],
}

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Splits an edge at a point of its interior. [`Editor::merge_edges`] takes that back.
    ///
    /// # Preconditions
    /// The point lies in the interior of the edge.
    ///
    /// # Panics
    /// If there is no such edge. In debug builds, if the point does not lie in its interior.
    ///
    /// # Complexity
    /// Expected O(log n) if curves came in random order, and linear in the number of trapezoids along the part that has fewer.
    ///
    /// # References
    /// Thesis, section 2.3.2.
    ///
    /// # Examples
    /// ```
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// let segment = Segment::from_i64([[0, 0], [4, 2]]).expect("the ends are different");
    /// let e = editor.insert_disjoint(segment);
    /// let parts = editor.split_edge(e, &Point2::from_i64([2, 1]));
    /// assert_eq!(parts.edges[0], e);
    /// assert_eq!(editor.counts().edges, 2);
    /// editor.merge_edges(parts.vertex)?;
    /// assert_eq!(editor.counts().edges, 1);
    /// # Ok::<(), splitstar_arrangement::VertexNeeded>(())
    /// ```
    pub fn split_edge(&mut self, e: EdgeId, point: &G::Point) -> SplitParts {
        let is_edge = self.arrangement.dcel().has_edge(e);
        assert!(is_edge, "edge {} does not exist: only an edge is split", e.0);
        debug_assert_eq!(self.locate(point), Cell::Edge(e), "the point lies in the interior of edge {}", e.0);
        let location = self.arrangement.topology().point_location(self.arrangement.traits(), point);
        let rail = self.trapezoids.rail_of(e);
        self.operate(Operation::SplitEdge, |editor| {
            let vertex = editor.split_rail(rail, point, location, false).v;
            let dcel = editor.arrangement.dcel();
            let edges = dcel.around(vertex).map(|h| h.edge_id());
            let new = edges.into_iter().find(|&other| other != e).expect("the edge has two parts");
            SplitParts { vertex, edges: [e, new] }
        })
    }

    /// Replaces the point of a vertex by an equal one, which may be stored otherwise or have other data attached.
    ///
    /// # Preconditions
    /// The vertex has a point, and the points are equal.
    ///
    /// # Panics
    /// If there is no such vertex. In debug builds, if it stands for a side, which has no point, or has another point. In release builds, a
    /// vertex that stands for a side stays as it is.
    ///
    /// # Complexity
    /// Constant.
    ///
    /// # References
    /// Thesis, section 2.3.2.
    ///
    /// # Examples
    /// A crossing of two lines, with the same coordinates as numbers:
    ///
    /// ```
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::overlay::Cell;
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// for ends in [[[0, 0], [4, 4]], [[0, 4], [4, 0]]] {
    ///     editor.insert_curve(&Segment::from_i64(ends).expect("the ends are different"));
    /// }
    /// let middle = Point2::from_i64([2, 2]);
    /// let Cell::Vertex(v) = editor.locate(&middle) else { panic!("the segments cross there") };
    /// editor.modify_vertex(v, middle.clone());
    /// assert_eq!(editor.point(v), Some(&middle));
    /// ```
    pub fn modify_vertex(&mut self, v: VertexId, point: G::Point) {
        let arrangement = &self.arrangement;
        let is_vertex = arrangement.dcel().has_vertex(v);
        assert!(is_vertex, "vertex {} does not exist: only a vertex is modified", v.0);
        let old = arrangement.point(v);
        debug_assert!(
            old.is_some_and(|old| arrangement.traits().is_same_point(old, &point)),
            "the point is that of vertex {}",
            v.0
        );
        // The point of a contracted side is the topology's.
        if !arrangement.stands_for_side(v) {
            self.operate(Operation::Modify, |editor| {
                editor.arrangement.apply(Edit::SetPoint { v, point }, &mut editor.observers);
            });
        }
    }

    /// Gives an edge another support: a curve that runs through the same points between its ends, and may end elsewhere, or have other
    /// data attached. Other edges on the old support keep it.
    ///
    /// # Preconditions
    /// The curve covers the edge.
    ///
    /// # Panics
    /// If there is no such edge. In debug builds, if the curve does not cover it.
    ///
    /// # Complexity
    /// Constant.
    ///
    /// # References
    /// Thesis, section 2.3.2.
    ///
    /// # Examples
    /// ```
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let segment = |ends| Segment::from_i64(ends).expect("the ends are different");
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// let e = editor.insert_disjoint(segment([[0, 0], [4, 0]]));
    /// editor.modify_edge(e, segment([[-1, 0], [9, 0]]));
    /// assert_eq!(*editor.curve_of(e), segment([[-1, 0], [9, 0]]));
    /// assert_eq!(editor.make_edge_curve(e), segment([[0, 0], [4, 0]]), "its vertices are where they were");
    /// ```
    pub fn modify_edge(&mut self, e: EdgeId, curve: G::UMonotoneCurve) {
        let is_edge = self.arrangement.dcel().has_edge(e);
        assert!(is_edge, "edge {} does not exist: only an edge is modified", e.0);
        debug_assert!(self.is_covered(e, &curve), "the curve covers edge {}", e.0);
        self.operate(Operation::Modify, |editor| {
            let curve = editor.arrangement.apply(Edit::AddCurve { curve }, &mut editor.observers).curve();
            editor.set_support(e, curve);
        });
    }

    /// Tells whether a curve runs through all points of an edge.
    fn is_covered(&self, e: EdgeId, curve: &G::UMonotoneCurve) -> bool {
        let arrangement = &self.arrangement;
        let (traits, topology) = (arrangement.traits(), arrangement.topology());
        let ends = arrangement.dcel().ends(e).map(|v| arrangement.inner_point(v));
        let mut common = Vec::new();
        traits.intersect(&arrangement.make_edge_curve(e), curve, &mut common);
        common.iter().any(|part| match part {
            Intersection::Overlap(overlap) => covers(traits, topology, overlap, ends),
            Intersection::Point(..) => false,
        })
    }
}
