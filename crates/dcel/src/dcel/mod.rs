//! The halfedge structure of arrangements on surfaces of any genus.
//!
//! | module | role |
//! |---|---|
//! | `mod` | records, and making the whole in one go |
//! | `access` | reading |
//! | `lists` | the lists of a face |
//! | `place` | edits that touch no edge |
//! | `insert`, `remove` | an edge comes, an edge goes |
//! | `compact` | dense ids again |
//! | `split` | an edge is split, merged with the next one, turned round |
//! | `mirror` | the mirror image; vertices exchange their ids |
//! | `validity`, `euler` | every broken promise; components and genus |

mod access;
mod compact;
mod euler;
mod insert;
mod lists;
mod mirror;
mod place;
mod remove;
mod split;
#[cfg(test)]
mod tests;
mod validity;
#[cfg(test)]
mod violations;

use crate::{CcbId, FaceId, HalfedgeId, VertexId};
pub use compact::Compaction;
pub use insert::{CcbSplit, Side};
pub use remove::{EndFate, MergedFaces, Removed};
pub use validity::{DcelViolation, FaceList};

use lists::{Linked, Links, NONE};

/// The cells of an arrangement of curves on an orientable surface of any genus, and which is next to
/// which.
///
/// - A *vertex* is attached to edges, or is isolated inside a face.
/// - An *edge* `e` is two *halfedges*, `2 e` and `2 e + 1`, in opposite directions; the even one runs
///   from the min to the max vertex of the edge. Loops and parallel edges are edges as others. A
///   halfedge has its face on its left.
/// - The halfedges that follow one another by `next` form a cycle, a connected component of the
///   boundary (*CCB*) of its face. A face has any number of outer CCBs, inner CCBs and isolated
///   vertices: in the plane, a bounded face has one outer CCB, the unbounded face none, and an inner
///   CCB is the boundary of a hole. On a surface of higher genus a face may have several outer CCBs.
///
/// A halfedge knows its CCB and the CCB its face: what a face has moves to another one in constant
/// time. Ids stay as they are under edits; those of removed cells are used again.
///
/// # Complexity
/// A halfedge takes 16 bytes, a CCB 16, a face 12, an attached vertex 4 and an isolated one 20. There
/// are fewer than 2^31 halfedges, and fewer than 2^31 faces.
///
/// # References
/// Thesis, section 2.3.1.
#[derive(Clone, Debug)]
pub struct Dcel {
    halfedges: Vec<Halfedge>,
    vertices: Vec<VertexCell>,
    ccbs: Vec<Ccb>,
    faces: Vec<Face>,
    isolated: Vec<Isolated>,
    free_edges: Vec<u32>,
    free_vertices: Vec<u32>,
    free_ccbs: Vec<u32>,
    free_faces: Vec<u32>,
    free_isolated: Vec<u32>,
}

/// The record of a halfedge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Halfedge {
    /// The halfedge that follows along the same CCB.
    pub next: HalfedgeId,
    /// The halfedge that this one follows.
    pub prev: HalfedgeId,
    /// The vertex where it starts; none if the halfedge is free.
    pub source: VertexId,
    /// The CCB on which it lies.
    pub ccb: CcbId,
}

impl Halfedge {
    /// The record of a free halfedge.
    const FREE: Self =
        Self { next: HalfedgeId::NONE, prev: HalfedgeId::NONE, source: VertexId::NONE, ccb: CcbId::NONE };
}

/// Whether a CCB has its face inside or around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CcbKind {
    /// A boundary of the face from outside, and on surfaces of higher genus any that is not a hole.
    Outer,
    /// The boundary of a hole.
    Inner,
}

/// A vertex in four bytes: the halfedge that leaves it, or [`ISOLATED`] and its place among the
/// isolated vertices, or one of the two last numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct VertexCell(u32);

const ISOLATED: u32 = 1 << 31;

/// What a vertex is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum VertexState {
    Attached(HalfedgeId),
    Isolated(u32),
    /// Neither attached nor isolated: added, and soon to be used.
    Bare,
    Free,
}

impl VertexCell {
    const BARE: Self = Self(u32::MAX);
    const FREE: Self = Self(u32::MAX - 1);

    fn isolated(place: u32) -> Self {
        Self(ISOLATED | place)
    }

    #[inline]
    fn state(self) -> VertexState {
        match self {
            Self::BARE => VertexState::Bare,
            Self::FREE => VertexState::Free,
            Self(cell) if cell & ISOLATED != 0 => VertexState::Isolated(cell & !ISOLATED),
            Self(cell) => VertexState::Attached(HalfedgeId(cell)),
        }
    }
}

/// A vertex in the list of isolated vertices of a face; a free record has no vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Isolated {
    vertex: VertexId,
    face: FaceId,
    links: Links,
}

impl Isolated {
    const FREE: Self = Self { vertex: VertexId::NONE, face: FaceId::NONE, links: Links::NONE };
}

/// A CCB; a free one has no first halfedge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Ccb {
    first: HalfedgeId,
    /// The face, and [`INNER`] if the CCB is inner.
    face_and_kind: u32,
    links: Links,
}

const INNER: u32 = 1 << 31;

impl Ccb {
    const FREE: Self = Self { first: HalfedgeId::NONE, face_and_kind: NONE, links: Links::NONE };

    fn new(first: HalfedgeId, face: FaceId, kind: CcbKind) -> Self {
        let inner = if kind == CcbKind::Inner { INNER } else { 0 };
        Self { first, face_and_kind: face.0 | inner, links: Links::NONE }
    }

    #[inline]
    fn face(self) -> FaceId {
        FaceId(self.face_and_kind & !INNER)
    }

    #[inline]
    fn is_of(self, face: FaceId, kind: CcbKind) -> bool {
        self.face() == face && self.kind() == kind
    }

    #[inline]
    fn kind(self) -> CcbKind {
        if self.face_and_kind & INNER == 0 { CcbKind::Outer } else { CcbKind::Inner }
    }
}

/// The heads of the lists of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Face {
    outer: u32,
    inner: u32,
    isolated: u32,
}

impl Face {
    const EMPTY: Self = Self { outer: NONE, inner: NONE, isolated: NONE };
    /// No list has its head there: there are fewer than 2^31 CCBs.
    const FREE: Self = Self { outer: NONE - 1, inner: NONE, isolated: NONE };

    fn head_mut(&mut self, kind: CcbKind) -> &mut u32 {
        match kind {
            CcbKind::Outer => &mut self.outer,
            CcbKind::Inner => &mut self.inner,
        }
    }
}

impl Linked for Ccb {
    fn links(&self) -> Links {
        self.links
    }
    fn links_mut(&mut self) -> &mut Links {
        &mut self.links
    }
}

impl Linked for Isolated {
    fn links(&self) -> Links {
        self.links
    }
    fn links_mut(&mut self) -> &mut Links {
        &mut self.links
    }
}

/// A CCB as [`RawDcel`] has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RawCcb {
    /// One of its halfedges.
    pub first: HalfedgeId,
    /// The face on whose boundary it lies.
    pub face: FaceId,
    /// Its kind.
    pub kind: CcbKind,
}

/// The parts of a [`Dcel`], made by somebody who knows all of them.
#[derive(Clone, Debug, Default)]
pub struct RawDcel {
    /// Two for each edge: source, next and CCB must be right, `prev` may be anything.
    pub halfedges: Vec<Halfedge>,
    /// For each vertex a halfedge that leaves it, [`HalfedgeId::NONE`] if it is isolated.
    pub outgoing: Vec<HalfedgeId>,
    /// The CCBs, those of one face in the order in which the face is to list them.
    pub ccbs: Vec<RawCcb>,
    /// How many faces there are.
    pub face_count: usize,
    /// The isolated vertices, each with the face in which it lies.
    pub isolated: Vec<(VertexId, FaceId)>,
}

impl Default for Dcel {
    fn default() -> Self {
        Self::new()
    }
}

impl Dcel {
    /// A surface without curves: one face and nothing else.
    pub fn new() -> Self {
        Self::from_parts(RawDcel { face_count: 1, ..RawDcel::default() })
    }

    /// Makes the structure from its parts. Cells have the ids of their positions.
    ///
    /// Nothing is checked; [`check_valid`](Self::check_valid) tells whether the parts fit together.
    ///
    /// # Panics
    /// If the number of halfedges is odd, or a `next`, a face of a CCB, or a vertex or face of an
    /// isolated vertex is not below the number of those cells, or there are too many cells for their ids.
    ///
    /// # Complexity
    /// Linear. The halfedges stay where they are, and so do the vertices.
    pub fn from_parts(raw: RawDcel) -> Self {
        let RawDcel { mut halfedges, outgoing, ccbs, face_count, isolated } = raw;
        assert!(halfedges.len().is_multiple_of(2), "halfedges come in pairs");
        assert!(halfedges.len() <= ISOLATED as usize && face_count <= INNER as usize, "too many cells");
        for i in 0..halfedges.len() {
            let next = halfedges[i].next.index();
            halfedges[next].prev = HalfedgeId(i as u32);
        }
        let mut faces = vec![Face::EMPTY; face_count];
        let mut linked = Vec::with_capacity(ccbs.len());
        for (i, RawCcb { first, face, kind }) in ccbs.into_iter().enumerate() {
            linked.push(Ccb::new(first, face, kind));
            lists::push_back(&mut linked, faces[face.index()].head_mut(kind), i as u32);
        }
        // Of the same size, so they are changed in place.
        let mut vertices: Vec<VertexCell> = outgoing.into_iter().map(|h| VertexCell(h.0)).collect();
        let mut places = Vec::with_capacity(isolated.len());
        for (i, (vertex, face)) in isolated.into_iter().enumerate() {
            vertices[vertex.index()] = VertexCell::isolated(i as u32);
            places.push(Isolated { vertex, face, links: Links::NONE });
            lists::push_back(&mut places, &mut faces[face.index()].isolated, i as u32);
        }
        Self {
            halfedges,
            vertices,
            ccbs: linked,
            faces,
            isolated: places,
            free_edges: Vec::new(),
            free_vertices: Vec::new(),
            free_ccbs: Vec::new(),
            free_faces: Vec::new(),
            free_isolated: Vec::new(),
        }
    }
}
