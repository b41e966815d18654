//! The map: six arrangements, and how they are next to one another.

use arrangement::Arrangement;
use arrangement::models::SegmentTraits;
use arrangement::topology::BoundedPlane;
use dcel::{EdgeId, FaceId, HalfedgeId, VertexId};
use exact::gnomonic::CubeSide;
use exact::spherical::{Direction, GreatCircle};

/// The arrangement on one side of the cube, in the coordinates of the [side](CubeSide).
pub type SideArrangement = Arrangement<SegmentTraits, BoundedPlane>;

/// A cell of the arrangement on one side of the cube.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct At<T> {
    /// The side.
    pub side: CubeSide,
    /// The cell.
    pub id: T,
}

/// Names a face of the sphere: faces of sides, joined across artificial edges.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct CubicalFaceId(pub u32);

impl CubicalFaceId {
    pub(crate) const NONE: Self = Self(u32::MAX);

    /// The position of the face.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Where on the cube a vertex lies.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Place {
    /// Inside of a side.
    Side,
    /// On an edge of the cube, between two sides.
    Edge,
    /// At a corner of the cube, between three sides.
    Corner,
}

/// One side, with what joins it to the others.
#[derive(Clone, Debug)]
pub(crate) struct Side {
    pub(crate) arrangement: SideArrangement,
    pub(crate) is_real_vertex: Vec<bool>,
    pub(crate) is_real_edge: Vec<bool>,
    /// For each vertex on the border, the same one on the next side, clockwise.
    pub(crate) next_copy: Vec<Option<At<VertexId>>>,
    /// For each edge on the border, the same one on the other side.
    pub(crate) across: Vec<Option<At<EdgeId>>>,
    /// The vertices at (-1, -1), (-1, 1), (1, -1), (1, 1).
    pub(crate) corners: [VertexId; 4],
    /// For each face, the face of the sphere of which it is a part.
    pub(crate) faces: Vec<CubicalFaceId>,
}

/// The sphere cut into vertices, edges and faces by geodesic arcs, kept as six planar arrangements.
///
/// A vertex on an edge of the cube is a vertex of two sides, one at a corner of three: its *copies*. An edge along an edge of the cube is one of two
/// sides. Everything on the edges of the cube is *artificial* unless something given is there:
///
/// * an edge is real if it is a part of an arc;
/// * a vertex within a side is real; one on an edge of the cube is if a point was given there, or an arc ends there, or if more than two real edges
///   meet there. So where arcs only pass from side to side, the vertex is artificial.
///
/// Cells are named by the side and the id that they have there. Each side has four edges of its square, and an unbounded face, which is no part of the
/// sphere; halfedges that have it on their left are the *outer* ones. Those functions here that take and give halfedges go from side to side, and
/// treat the sphere as one closed surface of inner halfedges.
///
/// Data about cells may be kept in plain vectors: one for each side, by the id; or one for faces of the sphere, by [`CubicalFaceId::index`].
///
/// # References
/// Thesis, section 3.3.1.
#[derive(Clone, Debug)]
pub struct CubicalArrangement {
    pub(crate) sides: [Side; 6],
    pub(crate) face_count: u32,
    /// For each face of the sphere, the first of its parts.
    pub(crate) first_part: Vec<At<FaceId>>,
}

impl CubicalArrangement {
    /// The arrangement on one side.
    #[inline]
    pub fn side(&self, side: CubeSide) -> &SideArrangement {
        &self.sides[side.index()].arrangement
    }

    /// The vertices at the corners of a side, in lexicographic order of (u, v).
    ///
    /// # References
    /// Thesis, table 3.1.
    pub fn corners(&self, side: CubeSide) -> [VertexId; 4] {
        self.sides[side.index()].corners
    }

    /// Tells whether a vertex is one without the edges of the cube, too.
    #[inline]
    pub fn is_real_vertex(&self, v: At<VertexId>) -> bool {
        self.sides[v.side.index()].is_real_vertex[v.id.index()]
    }

    /// Tells whether an edge is a part of an arc.
    #[inline]
    pub fn is_real_edge(&self, e: At<EdgeId>) -> bool {
        self.sides[e.side.index()].is_real_edge[e.id.index()]
    }

    /// Tells whether a halfedge is a part of an arc.
    #[inline]
    pub fn is_real(&self, h: At<HalfedgeId>) -> bool {
        self.sides[h.side.index()].is_real_edge[h.id.edge()]
    }

    /// Tells where on the cube a vertex lies.
    pub fn place(&self, v: At<VertexId>) -> Place {
        match self.copies(v).count() {
            1 => Place::Side,
            2 => Place::Edge,
            _ => Place::Corner,
        }
    }

    /// The same vertex on the next side, clockwise around it; `None` if it lies within its side.
    #[inline]
    pub fn next_copy(&self, v: At<VertexId>) -> Option<At<VertexId>> {
        self.sides[v.side.index()].next_copy[v.id.index()]
    }

    /// The vertex on all sides on which it lies, itself first, clockwise.
    pub fn copies(&self, v: At<VertexId>) -> impl Iterator<Item = At<VertexId>> + '_ {
        std::iter::successors(Some(v), move |&copy| self.next_copy(copy).filter(|&next| next != v))
    }

    /// The copy of a vertex on the first side on which it lies.
    pub fn first_copy(&self, v: At<VertexId>) -> At<VertexId> {
        self.copies(v).min().expect("a vertex is a copy of itself")
    }

    /// The same edge on the other side; `None` if it is not along an edge of the cube.
    #[inline]
    pub fn across(&self, e: At<EdgeId>) -> Option<At<EdgeId>> {
        self.sides[e.side.index()].across[e.id.index()]
    }

    /// The halfedge of an edge that has no unbounded face on its left: the even one, if both have none.
    #[inline]
    pub fn inner_halfedge(&self, e: At<EdgeId>) -> HalfedgeId {
        let (arrangement, h) = (self.side(e.side), e.id.halfedge());
        if arrangement.dcel().face(h) == arrangement.corner_face() { h.twin() } else { h }
    }

    /// Tells whether a halfedge has the unbounded face of its side on its left.
    #[inline]
    pub fn is_outer(&self, h: At<HalfedgeId>) -> bool {
        let arrangement = self.side(h.side);
        arrangement.dcel().face(h.id) == arrangement.corner_face()
    }

    /// The halfedge on the other side of the edge, which may be on another side of the cube.
    #[inline]
    pub fn twin(&self, h: At<HalfedgeId>) -> At<HalfedgeId> {
        match self.across(At { side: h.side, id: h.id.edge_id() }) {
            None => At { side: h.side, id: h.id.twin() },
            Some(other) => At { side: other.side, id: self.inner_halfedge(other) },
        }
    }

    /// The next halfedge along the face on the left.
    #[inline]
    pub fn next(&self, h: At<HalfedgeId>) -> At<HalfedgeId> {
        At { side: h.side, id: self.side(h.side).dcel().next(h.id) }
    }

    /// The halfedge before, along the face on the left.
    #[inline]
    pub fn prev(&self, h: At<HalfedgeId>) -> At<HalfedgeId> {
        At { side: h.side, id: self.side(h.side).dcel().prev(h.id) }
    }

    /// The vertex from which a halfedge leaves.
    #[inline]
    pub fn source(&self, h: At<HalfedgeId>) -> At<VertexId> {
        At { side: h.side, id: self.side(h.side).dcel().source(h.id) }
    }

    /// The vertex to which a halfedge comes.
    #[inline]
    pub fn target(&self, h: At<HalfedgeId>) -> At<VertexId> {
        At { side: h.side, id: self.side(h.side).dcel().target(h.id) }
    }

    /// An inner halfedge that leaves a vertex; `None` if it is isolated.
    pub fn outgoing(&self, v: At<VertexId>) -> Option<At<HalfedgeId>> {
        let at = |id| At { side: v.side, id };
        self.side(v.side).dcel().around(v.id).map(at).find(|&h| !self.is_outer(h))
    }

    /// The halfedges that leave a vertex on whatever side, counterclockwise, artificial ones too.
    pub fn around(&self, v: At<VertexId>) -> impl Iterator<Item = At<HalfedgeId>> + '_ {
        let first = self.outgoing(v);
        std::iter::successors(first, move |&h| {
            Some(self.twin(self.prev(h))).filter(|&next| Some(next) != first)
        })
    }

    /// The halfedges that leave a vertex on whatever side, clockwise, artificial ones too.
    pub fn clockwise_around(&self, v: At<VertexId>) -> impl Iterator<Item = At<HalfedgeId>> + '_ {
        let first = self.outgoing(v);
        std::iter::successors(first, move |&h| {
            Some(self.next(self.twin(h))).filter(|&next| Some(next) != first)
        })
    }

    /// The real halfedges that leave a vertex, counterclockwise.
    pub fn real_around(&self, v: At<VertexId>) -> impl Iterator<Item = At<HalfedgeId>> + '_ {
        self.around(v).filter(|&h| self.is_real(h))
    }

    /// The real vertices, each by its first copy.
    pub fn real_vertices(&self) -> impl Iterator<Item = At<VertexId>> + '_ {
        CubeSide::ALL.into_iter().flat_map(move |side| {
            let vertices = self.side(side).dcel().vertices().map(move |id| At { side, id });
            vertices.filter(|&v| self.is_real_vertex(v) && self.first_copy(v) == v)
        })
    }

    /// How many faces the sphere is cut into.
    #[inline]
    pub fn face_count(&self) -> usize {
        self.face_count as usize
    }

    /// The faces of the sphere.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = CubicalFaceId> + use<> {
        (0..self.face_count).map(CubicalFaceId)
    }

    /// The face of the sphere of which a face of a side is a part; `None` if that is unbounded.
    #[inline]
    pub fn face_of(&self, f: At<FaceId>) -> Option<CubicalFaceId> {
        let face = self.sides[f.side.index()].faces[f.id.index()];
        (face != CubicalFaceId::NONE).then_some(face)
    }

    /// The face of the sphere on the left of an inner halfedge.
    ///
    /// # Panics
    /// If the halfedge is an outer one.
    #[inline]
    pub fn face(&self, h: At<HalfedgeId>) -> CubicalFaceId {
        let f = self.side(h.side).dcel().face(h.id);
        self.face_of(At { side: h.side, id: f })
            .expect("an inner halfedge has a face of the sphere on its left")
    }

    /// One of the faces of sides of which a face of the sphere consists.
    #[inline]
    pub fn part(&self, face: CubicalFaceId) -> At<FaceId> {
        self.first_part[face.index()]
    }

    /// The faces of sides of which a face of the sphere consists.
    ///
    /// # Complexity
    /// Linear in the number of all faces.
    pub fn parts(&self, face: CubicalFaceId) -> impl Iterator<Item = At<FaceId>> + '_ {
        CubeSide::ALL.into_iter().flat_map(move |side| {
            let faces = self.side(side).dcel().faces().map(move |id| At { side, id });
            faces.filter(move |&f| self.face_of(f) == Some(face))
        })
    }

    /// The direction of a vertex.
    pub fn direction(&self, v: At<VertexId>) -> Direction {
        let point = self.side(v.side).point(v.id).expect("in the bounded plane every vertex has a point");
        v.side.direction_of(point)
    }

    /// The great circle along a halfedge, run through in its sense.
    pub fn circle(&self, h: At<HalfedgeId>) -> GreatCircle {
        let circle = h.side.circle_of(self.side(h.side).curve_of(h.id.edge_id()).line());
        // The even halfedge runs to the right, or upwards: what is above it, or to its left, is on the positive side of the line.
        if h.id.is_even() { circle } else { circle.opposite() }
    }
}
