//! The primitive changes, as values.

use crate::arrangement::CurveId;
use crate::traits::{BasicTraits, CurveEnd};
use dcel::{CcbId, CcbKind, EdgeId, EndFate, FaceId, HalfedgeId, Removed, Side, VertexId};

/// A primitive change of an arrangement. Points are `P`, u-monotone curves `C`.
///
/// The ids are those of cells before the change. An operation of a user is a sequence of primitives; in between, the arrangement may be
/// one of no curves: an edge is in and its face not split yet.
///
/// No variant is hidden, so that an observer that keeps something up to date notices when it has to know another one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Edit<P, C> {
    /// A vertex comes that has no edge and is in no face, soon to be attached.
    AddVertex {
        /// Where it is.
        point: P,
        /// Whether it is there only because a curve was cut.
        is_artificial: bool,
    },
    /// An isolated vertex comes.
    AddIsolatedVertex {
        /// Where it is.
        point: P,
        /// Whether it is there only because a curve was cut.
        is_artificial: bool,
        /// The face in which it lies.
        face: FaceId,
    },
    /// A vertex without edges goes.
    RemoveIsolatedVertex {
        /// The vertex.
        v: VertexId,
    },
    /// An edge comes between two vertices without edges: a new CCB.
    InsertEdgeInFace {
        /// Its min and its max vertex.
        ends: [VertexId; 2],
        /// The face in which it lies.
        face: FaceId,
        /// The kind of the CCB.
        kind: CcbKind,
        /// The curve on which it lies.
        support: CurveId,
    },
    /// An edge comes from a vertex without edges to itself: two new CCBs of the same face.
    InsertLoop {
        /// Its min and max vertex.
        v: VertexId,
        /// The face in which it lies.
        face: FaceId,
        /// The kinds of the CCBs on the even and on the odd side.
        kinds: [CcbKind; 2],
        /// The curve on which it lies.
        support: CurveId,
    },
    /// An edge comes whose max vertex had no edges.
    InsertEdgeFrom {
        /// The halfedge after which the even halfedge of the new edge comes.
        prev: HalfedgeId,
        /// The max vertex.
        v: VertexId,
        /// The curve on which it lies.
        support: CurveId,
    },
    /// An edge comes whose min vertex had no edges.
    InsertEdgeTo {
        /// The min vertex.
        v: VertexId,
        /// The halfedge after which the odd halfedge of the new edge comes.
        prev: HalfedgeId,
        /// The curve on which it lies.
        support: CurveId,
    },
    /// An edge comes between two places of one CCB, which becomes two of the same kind and face.
    InsertEdgeBetween {
        /// The halfedges after which the even and the odd halfedge of the new edge come.
        prevs: [HalfedgeId; 2],
        /// Whether the new edge is turned round then. If both ends are in one corner, its even halfedge is alone on its CCB
        /// before that.
        is_reversed: bool,
        /// The curve on which it lies.
        support: CurveId,
    },
    /// An edge comes between two CCBs of one face, which become one.
    InsertEdgeJoining {
        /// The halfedges after which the even and the odd halfedge of the new edge come.
        prevs: [HalfedgeId; 2],
        /// The kind of the CCB then.
        kind: CcbKind,
        /// The curve on which it lies.
        support: CurveId,
    },
    /// An edge goes; if it had two faces, they become one. Its CCBs have the kinds that [`Removed`] states.
    RemoveEdge {
        /// The edge.
        e: EdgeId,
        /// What becomes of its min and of its max vertex if they have no other edge. A vertex that stands for a side is never removed.
        ends: [EndFate; 2],
        /// The side whose face keeps its id. The face that goes is not the corner face.
        survivor: Side,
    },
    /// An edge becomes two on the same curve.
    SplitEdge {
        /// The edge.
        e: EdgeId,
        /// The vertex between, which has no edges.
        v: VertexId,
        /// At which end the part lies that keeps the id.
        kept: CurveEnd,
    },
    /// Two edges become one, on the curve of the one that stays, and the vertex between goes. It is the max vertex of one and the
    /// min vertex of the other.
    MergeEdges {
        /// The edge that stays.
        kept: EdgeId,
        /// The vertex.
        v: VertexId,
    },
    /// A CCB becomes that of a new face. What else belongs there is moved by other edits.
    SplitFace {
        /// The CCB.
        ccb: CcbId,
    },
    /// A face gets all that another one has, which goes.
    MergeFaces {
        /// The face that stays.
        kept: FaceId,
        /// The face that goes; not the corner face.
        gone: FaceId,
    },
    /// A CCB becomes one of another face.
    MoveCcb {
        /// The CCB.
        ccb: CcbId,
        /// Its face then.
        face: FaceId,
    },
    /// An isolated vertex gets into another face.
    MoveIsolatedVertex {
        /// The vertex.
        v: VertexId,
        /// Its face then.
        face: FaceId,
    },
    /// Another face becomes the [corner face](crate::Arrangement::corner_face). It comes next after [`SplitFace`](Self::SplitFace) if the
    /// new face has the corner, and before an edit by which the corner face goes.
    SetCornerFace {
        /// The corner face then.
        face: FaceId,
    },
    /// An outer CCB becomes an inner one, or the other way round.
    SetCcbKind {
        /// The CCB.
        ccb: CcbId,
        /// Its kind then.
        kind: CcbKind,
    },
    /// An edge gets another curve to lie on.
    SetSupport {
        /// The edge.
        e: EdgeId,
        /// Its curve then.
        curve: CurveId,
    },
    /// The point of a vertex is replaced, by an equal one that is stored otherwise or by another one.
    SetPoint {
        /// The vertex.
        v: VertexId,
        /// Its point then.
        point: P,
    },
    /// A vertex becomes an artificial or an ordinary one. So a pole comes and goes to which no edge comes: it is
    /// [absent](crate::Arrangement::is_absent) if it is artificial. Its vertex is always there, so no other edit tells of it; with the first edge at
    /// it, it comes, too.
    SetArtificial {
        /// The vertex.
        v: VertexId,
        /// Whether it is there only because a curve was cut.
        is_artificial: bool,
    },
    /// A curve comes on which edges are going to lie. Curves stay when no edge is on them any more, until everything is numbered
    /// anew.
    AddCurve {
        /// The curve.
        curve: C,
    },
}

/// A primitive change of an arrangement of these traits.
pub type EditOf<G> = Edit<<G as BasicTraits>::Point, <G as BasicTraits>::UMonotoneCurve>;

/// What came of a primitive change.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Done {
    /// Records were changed, and no cell came or went but what the edit names.
    Changed,
    /// The vertex came.
    Vertex(VertexId),
    /// The edge came; by [`Edit::SplitEdge`], the part that has a new id.
    Edge(EdgeId),
    /// The edge went, and so did perhaps a face, CCBs and vertices.
    Removed(Removed),
    /// The edge became a part of the one that stays.
    Merged(EdgeId),
    /// The face came.
    Face(FaceId),
    /// The curve came.
    Curve(CurveId),
}

/// For those who know which edit it was.
impl Done {
    pub(crate) fn vertex(self) -> VertexId {
        let Self::Vertex(v) = self else { unreachable!("the edit makes a vertex") };
        v
    }

    pub(crate) fn edge(self) -> EdgeId {
        let Self::Edge(e) = self else { unreachable!("the edit makes an edge") };
        e
    }

    pub(crate) fn removed(self) -> Removed {
        let Self::Removed(removed) = self else { unreachable!("the edit removes an edge") };
        removed
    }

    pub(crate) fn face(self) -> FaceId {
        let Self::Face(f) = self else { unreachable!("the edit makes a face") };
        f
    }

    pub(crate) fn curve(self) -> CurveId {
        let Self::Curve(curve) = self else { unreachable!("the edit stores a curve") };
        curve
    }
}
