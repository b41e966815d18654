//! Weights of nodes and edges: made when they are asked for.

/// Gives each node, or each edge, its weight.
///
/// Every function of an id is one, if it can be copied and its values can: a closure that borrows a property map and reads it, or gives
/// references into it.
pub trait Weights<Id>: Copy {
    /// What a weight is.
    type Weight: Copy;

    /// The weight of a node or of an edge.
    fn weight(&self, id: Id) -> Self::Weight;
}

/// The weight of a node or of an edge is its id.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ids;

impl<Id: Copy> Weights<Id> for Ids {
    type Weight = Id;

    fn weight(&self, id: Id) -> Id {
        id
    }
}

impl<Id, W: Copy, F: Fn(Id) -> W + Copy> Weights<Id> for F {
    type Weight = W;

    fn weight(&self, id: Id) -> W {
        self(id)
    }
}
