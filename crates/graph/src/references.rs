//! Nodes and edges with their weights.

use dcel::HalfedgeId;
use petgraph::visit::{EdgeRef, NodeRef};

/// A node and its weight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NodeReference<Id, W> {
    pub(crate) id: Id,
    pub(crate) weight: W,
}

impl<Id: Copy, W: Copy> NodeRef for NodeReference<Id, W> {
    type NodeId = Id;
    type Weight = W;

    fn id(&self) -> Id {
        self.id
    }

    fn weight(&self) -> &W {
        &self.weight
    }
}

/// An edge of the graph, seen from one of its nodes, and its weight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeReference<Id, E, W> {
    pub(crate) source: Id,
    pub(crate) target: Id,
    pub(crate) arc: HalfedgeId,
    pub(crate) id: E,
    pub(crate) weight: W,
}

impl<Id, E, W> EdgeReference<Id, E, W> {
    /// The halfedge along the edge: from source to target in the primal graph, with the source on its left in the dual.
    pub fn halfedge(&self) -> HalfedgeId {
        self.arc
    }
}

impl<Id: Copy, E: Copy, W: Copy> EdgeRef for EdgeReference<Id, E, W> {
    type NodeId = Id;
    type EdgeId = E;
    type Weight = W;

    fn source(&self) -> Id {
        self.source
    }

    fn target(&self) -> Id {
        self.target
    }

    fn weight(&self) -> &W {
        &self.weight
    }

    fn id(&self) -> E {
        self.id
    }
}
