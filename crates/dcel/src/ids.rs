//! Typed ids of cells.

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub struct $name(pub u32);

        impl $name {
            /// No cell: the largest number, which names none.
            pub const NONE: Self = Self(u32::MAX);

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

id!(
    /// Names an edge: the halfedges `2 e` and `2 e + 1`.
    EdgeId
);
id!(
    /// Names a face of an arrangement.
    FaceId
);
id!(
    /// Names a connected component of the boundary (CCB) of a face.
    CcbId
);

impl EdgeId {
    /// The even halfedge, which runs from the min to the max vertex of the edge.
    #[inline]
    pub fn halfedge(self) -> HalfedgeId {
        HalfedgeId(self.0 << 1)
    }
}

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

    /// The edge, of which this is one of the two halves.
    #[inline]
    pub fn edge_id(self) -> EdgeId {
        EdgeId(self.0 >> 1)
    }

    /// Whether this is the even halfedge of its edge, the one from the min to the max vertex.
    #[inline]
    pub fn is_even(self) -> bool {
        self.0 & 1 == 0
    }
}
