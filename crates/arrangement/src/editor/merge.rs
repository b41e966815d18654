//! Vertices that nobody needs: two edges become one.

use super::Editor;
use crate::arrangement::CurveId;
use crate::edit::{Edit, Observer, Operation};
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use dcel::{EdgeId, VertexId};
use std::fmt;

/// Two edges that became one.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct MergedEdges {
    /// The edge that has all now: the one that ended at the vertex.
    pub kept: EdgeId,
    /// The edge that is no more: the one that began there.
    pub gone: EdgeId,
}

/// A vertex cannot go while its edges stay.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub struct VertexNeeded {
    /// The vertex.
    pub vertex: VertexId,
    /// Why it has to stay.
    pub reason: VertexNeed,
}

/// Why a vertex cannot go while its edges stay.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum VertexNeed {
    /// It is no point: it stands for a side of the parameter space.
    Side,
    /// Not two edges end there, but so many.
    Degree(usize),
    /// It is both ends of one edge.
    Loop,
    /// Both edges begin there, or both end there: together they are not u-monotone.
    Turn,
    /// One edge comes to an identified side, and the other one leaves the opposite side.
    Seam,
    /// No curve of the family runs along both edges.
    Curves,
}

impl fmt::Display for VertexNeeded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let v = self.vertex.0;
        match self.reason {
            VertexNeed::Side => write!(f, "vertex {v} stands for a side, and is no point"),
            VertexNeed::Degree(degree) => write!(f, "vertex {v} has degree {degree}, not 2"),
            VertexNeed::Loop => write!(f, "vertex {v} is both ends of one edge"),
            VertexNeed::Turn => write!(f, "the edges at vertex {v} are together not u-monotone"),
            VertexNeed::Seam => write!(f, "the edges at vertex {v} meet across an identification"),
            VertexNeed::Curves => write!(f, "the edges at vertex {v} do not lie on one curve"),
        }
    }
}

impl std::error::Error for VertexNeeded {}

/// What it takes to merge two edges.
struct Mergeable<C> {
    edges: MergedEdges,
    /// The support of both, or a curve that is to be stored.
    curve: Result<CurveId, C>,
}

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Makes one edge of the two that meet at a vertex, which goes. The edge that ends at the vertex keeps its id, and its min vertex.
    ///
    /// The edges may lie on one support, or on two that [`UMonotoneTraits::merge`] joins. Whether anybody wants the vertex, because a
    /// curve ends there or a point was inserted, is not asked.
    ///
    /// # Errors
    /// If there are not two edges there, or they cannot be one: [`VertexNeeded::reason`] says why. Then nothing is changed.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids along the one edge that has fewer; and that of a merge of curves, if there are two supports.
    ///
    /// # References
    /// Thesis, section 2.3.2.
    ///
    /// # Examples
    /// ```
    /// use splitstar_arrangement::{Arrangement, Editor, models::{Segment, SegmentTraits}, topology::BoundedPlane};
    /// let mut editor = Editor::new(Arrangement::new(SegmentTraits, BoundedPlane));
    /// for ends in [[[0, 0], [2, 0]], [[2, 0], [4, 0]]] {
    ///     editor.insert_curve(&Segment::from_i64(ends).expect("the ends are different"));
    /// }
    /// let [end, middle] = [0, 2].map(|u| editor.insert_point(&exact::planar::Point2::from_i64([u, 0])));
    /// let error = editor.merge_edges(end).expect_err("a curve ends there");
    /// assert_eq!(error.to_string(), "vertex 0 has degree 1, not 2");
    /// let merged = editor.merge_edges(middle)?;
    /// assert_eq!(editor.dcel().edges().collect::<Vec<_>>(), [merged.kept]);
    /// # Ok::<(), splitstar_arrangement::VertexNeeded>(())
    /// ```
    pub fn merge_edges(&mut self, v: VertexId) -> Result<MergedEdges, VertexNeeded> {
        let mergeable = self.find_mergeable(v)?;
        Ok(self.operate(Operation::MergeEdges, |editor| editor.merge(v, mergeable)))
    }

    /// Tells whether [`Editor::merge_edges`] can make one edge of the two that meet at a vertex.
    ///
    /// # Errors
    /// If it cannot.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Complexity
    /// Constant; that of a merge of curves, if there are two supports.
    pub fn check_mergeable(&self, v: VertexId) -> Result<(), VertexNeeded> {
        self.find_mergeable(v).map(|_| ())
    }

    /// Merges the edges at a vertex within an operation.
    pub(crate) fn merge_redundant(&mut self, v: VertexId) -> Result<MergedEdges, VertexNeeded> {
        let mergeable = self.find_mergeable(v)?;
        Ok(self.merge(v, mergeable))
    }

    fn find_mergeable(&self, v: VertexId) -> Result<Mergeable<G::UMonotoneCurve>, VertexNeeded> {
        let (arrangement, dcel) = (&self.arrangement, self.arrangement.dcel());
        assert!(dcel.has_vertex(v), "vertex {} does not exist: only at a vertex edges are merged", v.0);
        let needed = |reason| Err(VertexNeeded { vertex: v, reason });
        if arrangement.stands_for_side(v) {
            return needed(VertexNeed::Side);
        }
        let mut around = dcel.around(v);
        let (Some(a), Some(b), None) = (around.next(), around.next(), around.next()) else {
            return needed(VertexNeed::Degree(dcel.degree(v)));
        };
        if a.edge_id() == b.edge_id() {
            return needed(VertexNeed::Loop);
        }
        let (before, after) = match (a.is_even(), b.is_even()) {
            (false, true) => (a.edge_id(), b.edge_id()),
            (true, false) => (b.edge_id(), a.edge_id()),
            _ => return needed(VertexNeed::Turn),
        };
        let [site, other] = [(before, 1), (after, 0)]
            .map(|(e, end)| self.trapezoids.rail(self.trapezoids.rail_of(e)).ends[end]);
        if site != other {
            return needed(VertexNeed::Seam);
        }
        let [support, other] = [before, after].map(|e| arrangement.support(e));
        let curve = if support == other {
            Ok(support)
        } else {
            let [a, b] = [before, after].map(|e| arrangement.make_edge_curve(e));
            match arrangement.traits().merge(&a, &b) {
                Some(curve) => Err(curve),
                None => return needed(VertexNeed::Curves),
            }
        };
        Ok(Mergeable { edges: MergedEdges { kept: before, gone: after }, curve })
    }

    fn merge(&mut self, v: VertexId, mergeable: Mergeable<G::UMonotoneCurve>) -> MergedEdges {
        let Mergeable { edges, curve } = mergeable;
        let curve = curve.unwrap_or_else(|curve| {
            self.arrangement.apply(Edit::AddCurve { curve }, &mut self.observers).curve()
        });
        let kept = edges.kept;
        self.trapezoids.merge_edges(&self.arrangement, kept, v);
        self.arrangement.apply(Edit::MergeEdges { kept, v }, &mut self.observers);
        self.set_support(kept, curve);
        edges
    }

    /// Gives an edge another support, which runs through the same points between its ends.
    pub(super) fn set_support(&mut self, e: EdgeId, curve: CurveId) {
        if self.arrangement.support(e) != curve {
            self.arrangement.apply(Edit::SetSupport { e, curve }, &mut self.observers);
        }
        self.trapezoids.set_curve(e, curve.0);
    }
}
