//! Typed ids of cells.

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub struct $name(pub u32);

        impl $name {
            /// The id of the cell at position `index`.
            ///
            /// # Panics
            /// If `index` is 2^32 or more.
            #[inline]
            pub fn new(index: usize) -> Self {
                Self(u32::try_from(index).expect("a mesh has fewer than 2^32 cells of a kind"))
            }

            /// The position of the cell.
            #[inline]
            pub fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

id!(
    /// Names a vertex.
    VertexId
);
id!(
    /// Names a halfedge. The twin is one bit away.
    HalfedgeId
);
id!(
    /// Names a facet.
    FacetId
);

impl HalfedgeId {
    /// The same edge in the other direction.
    #[inline]
    pub fn twin(self) -> Self {
        Self(self.0 ^ 1)
    }

    /// The position of the edge, of which this is one of the two halves.
    #[inline]
    pub fn edge(self) -> usize {
        (self.0 >> 1) as usize
    }
}
