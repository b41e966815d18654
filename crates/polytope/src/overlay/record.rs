//! What a walk of one map through the other records.

use super::OverlayCounts;
use dcel::{FacetId, HalfedgeId, Mesh, VertexId};

/// A vertex of the overlay, as one trace sees it: a [`Kind`] in four bytes.
#[derive(Clone, Copy, Debug)]
pub(super) struct OverlayVertex(u32);

/// What a vertex of the overlay is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Kind {
    /// A vertex of the red map.
    Red(u32),
    /// A vertex of the blue map in the interior of a red arc.
    Blue(u32),
    /// The crossing with this index in [`Trace::crossings`].
    Crossing(u32),
}

impl OverlayVertex {
    const LIMIT: u32 = 1 << 30;

    #[inline]
    pub(super) fn new(kind: Kind) -> Self {
        let (tag, index) = match kind {
            Kind::Red(f) => (0, f),
            Kind::Blue(f) => (1, f),
            Kind::Crossing(c) => (2, c),
        };
        assert!(index < Self::LIMIT, "a sum has fewer than 2^30 facets of a kind");
        Self(tag << 30 | index)
    }

    #[inline]
    pub(super) fn kind(self) -> Kind {
        let index = self.0 & (Self::LIMIT - 1);
        match self.0 >> 30 {
            0 => Kind::Red(index),
            1 => Kind::Blue(index),
            _ => Kind::Crossing(index),
        }
    }
}

/// An edge of the overlay: a part of a red arc. It starts where the piece before it ends, the first
/// one of an arc at the start of the arc.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// The red arc, in the direction in which it was traced.
    pub(super) arc: HalfedgeId,
    pub(super) to: OverlayVertex,
    pub(super) on: Track,
}

/// What a piece runs on in the blue map, in four bytes: a face, or an arc in the direction of the piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Track(u32);

impl Track {
    const ARC: u32 = 1 << 31;

    #[inline]
    pub(super) fn inside(face: VertexId) -> Self {
        assert!(face.0 < Self::ARC, "a summand has fewer than 2^31 vertices");
        Self(face.0)
    }

    #[inline]
    pub(super) fn along(arc: HalfedgeId) -> Self {
        assert!(arc.0 < Self::ARC, "a summand has fewer than 2^31 halfedges");
        Self(arc.0 | Self::ARC)
    }

    /// The face (a blue vertex), if it is not an arc.
    #[inline]
    pub(super) fn face(self) -> Option<VertexId> {
        (self.0 & Self::ARC == 0).then_some(VertexId(self.0))
    }

    /// The blue vertices (faces of the map) on the left and on the right.
    #[inline]
    pub(super) fn sides(self, blue: &Mesh) -> [VertexId; 2] {
        match self.face() {
            Some(w) => [w, w],
            None => {
                let arc = HalfedgeId(self.0 & !Self::ARC);
                [blue.target(arc), blue.source(arc)]
            }
        }
    }
}

/// Where two arcs cross: red from the left to the right of blue.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub(super) red: HalfedgeId,
    pub(super) blue: HalfedgeId,
}

/// Where a red vertex lies in the blue map.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    Unknown,
    /// Inside a face.
    Face(VertexId, Option<Chord>),
    /// In the interior of an arc.
    Arc(HalfedgeId),
    /// On a vertex.
    Vertex(FacetId),
}

/// The red circle through a vertex inside a blue face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chord {
    /// The arc that reached the vertex.
    pub(super) arc: HalfedgeId,
    /// The first corner of the face, counterclockwise, that is no longer on the right of the circle
    /// ahead of the vertex.
    pub(super) exit: u32,
    /// The first corner that is no longer on its left, behind the vertex.
    pub(super) entry: u32,
}

/// What the walk found.
#[derive(Default)]
pub(super) struct Trace {
    pub(super) pieces: Vec<Piece>,
    pub(super) crossings: Vec<Crossing>,
    /// The place of each red vertex.
    pub(super) places: Vec<Place>,
    pub(super) counts: OverlayCounts,
}
