//! What a decomposition is made of.

use crate::traits::Location;
use dcel::{EdgeId, VertexId};

/// Stands for no site and no edge.
pub(super) const NONE: u32 = u32::MAX;

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub struct $name(pub u32);

        impl $name {
            /// The position of it.
            #[inline]
            pub fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

id!(
    /// Names a trapezoid of a [`VerticalDecomposition`](super::VerticalDecomposition).
    TrapezoidId
);
id!(
    /// Names a place in the parameter space from which walls go. A greater number is farther to the right, or above.
    SiteId
);

/// A trapezoid: the sites at its left and right walls, and the edges below and above; `None` is a side of the parameter space.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Trapezoid {
    /// The site at whose wall it begins.
    pub left: Option<SiteId>,
    /// The site at whose wall it ends.
    pub right: Option<SiteId>,
    /// The edge below.
    pub below: Option<EdgeId>,
    /// The edge above.
    pub above: Option<EdgeId>,
}

/// A trapezoid in 16 bytes.
#[derive(Clone, Copy, Debug)]
pub(super) struct TrapezoidRecord {
    pub(super) left: u32,
    pub(super) right: u32,
    pub(super) below: u32,
    pub(super) above: u32,
}

impl TrapezoidRecord {
    #[inline]
    pub(super) fn make_trapezoid(self) -> Trapezoid {
        let some = |number: u32| (number != NONE).then_some(number);
        Trapezoid {
            left: some(self.left).map(SiteId),
            right: some(self.right).map(SiteId),
            below: some(self.below).map(EdgeId),
            above: some(self.above).map(EdgeId),
        }
    }
}

/// A site.
#[derive(Clone, Copy, Debug)]
pub(super) struct SiteRecord {
    /// The trapezoids at its walls on the left, below and above.
    pub(super) left: [TrapezoidId; 2],
    /// Those on the right.
    pub(super) right: [TrapezoidId; 2],
    pub(super) vertex: VertexId,
    /// The next site of the same vertex.
    pub(super) next: u32,
    pub(super) location: Location,
    /// Whether the site before has the same u.
    pub(super) has_last_u: bool,
}

/// The place of an edge among all, where none comes first.
#[inline]
pub(super) fn key(edge: u32) -> usize {
    edge.wrapping_add(1) as usize
}
