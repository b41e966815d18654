//! In which directions an edge can be walked.

use dcel::{Dcel, EdgeId, HalfedgeId};
use petgraph::{Directed, EdgeType, Undirected};
use std::fmt::Debug;
use std::hash::Hash;

/// What the edges of a graph are.
///
/// | way | its edges | named by | in the primal graph | in the dual |
/// |---|---|---|---|---|
/// | [`Undirected`] | edges | [`EdgeId`] | between the ends | between the faces on both sides |
/// | [`Directed`] | halfedges | [`HalfedgeId`] | from source to target | from the face on the left to that on the right |
/// | [`Ascending`] | even halfedges | [`EdgeId`] | from min to max vertex | from the face on the left, as seen from the min vertex, to that on the right |
///
/// An undirected edge with both ends at one node appears once among the edges of the node.
pub trait Way: sealed::Sealed {
    /// Names an edge of the graph.
    type EdgeId: Copy + Eq + Ord + Hash + Debug;

    /// What `petgraph` makes of it.
    type EdgeType: EdgeType;

    /// How many edges of the graph an edge is.
    #[doc(hidden)]
    const EDGES: usize;

    /// Whether a node has an arc, given whether the arc leads to the same node.
    #[doc(hidden)]
    fn has(arc: HalfedgeId, is_loop: bool) -> bool;

    #[doc(hidden)]
    fn id(arc: HalfedgeId) -> Self::EdgeId;

    /// An arc of an edge of the graph: the one of the list of all.
    #[doc(hidden)]
    fn arc(id: Self::EdgeId) -> HalfedgeId;

    /// The position of an edge.
    #[doc(hidden)]
    fn index(id: Self::EdgeId) -> usize;

    /// The edge at a position.
    #[doc(hidden)]
    fn from_index(i: usize) -> Self::EdgeId;

    /// A number above the positions of all edges.
    #[doc(hidden)]
    fn bound(dcel: &Dcel) -> usize;
}

/// Each edge from its min to its max vertex only.
///
/// In the plane the primal graph has no cycle then: the vertices in lexicographic order are in topological order. With the
/// vertex at infinity it may have some, and on a torus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ascending {}

macro_rules! along_edges {
    ($way:ty, $edge_type:ty, $has:expr) => {
        impl Way for $way {
            type EdgeId = EdgeId;
            type EdgeType = $edge_type;

            const EDGES: usize = 1;

            fn has(arc: HalfedgeId, is_loop: bool) -> bool {
                let has: fn(HalfedgeId, bool) -> bool = $has;
                has(arc, is_loop)
            }

            fn id(arc: HalfedgeId) -> EdgeId {
                arc.edge_id()
            }

            fn arc(id: EdgeId) -> HalfedgeId {
                id.halfedge()
            }

            fn index(id: EdgeId) -> usize {
                id.index()
            }

            fn from_index(i: usize) -> EdgeId {
                EdgeId::new(i)
            }

            fn bound(dcel: &Dcel) -> usize {
                dcel.edge_bound()
            }
        }
    };
}

along_edges!(Undirected, Undirected, |arc, is_loop| arc.is_even() || !is_loop);
along_edges!(Ascending, Directed, |arc, _| arc.is_even());

impl Way for Directed {
    type EdgeId = HalfedgeId;
    type EdgeType = Directed;

    const EDGES: usize = 2;

    fn has(_: HalfedgeId, _: bool) -> bool {
        true
    }

    fn id(arc: HalfedgeId) -> HalfedgeId {
        arc
    }

    fn arc(id: HalfedgeId) -> HalfedgeId {
        id
    }

    fn index(id: HalfedgeId) -> usize {
        id.index()
    }

    fn from_index(i: usize) -> HalfedgeId {
        HalfedgeId::new(i)
    }

    fn bound(dcel: &Dcel) -> usize {
        dcel.halfedge_bound()
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for petgraph::Undirected {}
    impl Sealed for petgraph::Directed {}
    impl Sealed for super::Ascending {}
}
