//! The arrangement: cells with their points and curves.
//!
//! | layer | files | role |
//! |---|---|---|
//! | the object | `mod`, `counts`, `view` | cells, what lies where, how many there are, what a user sees |
//! | checking | `validity`, `isomorphism`, `around` | every violation; are two the same; the geometric order around a vertex |
//! | making it | `build`, `assemble`, `parts` | cells from a sweep; an arrangement from cells and supports, or from anybody's |
//! | order | `order` | one order of all cells |

pub(crate) mod around;
pub(crate) mod assemble;
pub(crate) mod build;
mod counts;
mod isomorphism;
mod order;
mod parts;
mod validity;
mod view;

pub use counts::Counts;
pub use isomorphism::Difference;
pub use order::CellOrder;
pub use parts::Parts;
pub use validity::Violation;
pub use view::{UserEdgeId, UserView};

use crate::edit::Stamp;
use crate::overlay::Cell;
use crate::topology::Topology;
use crate::traits::{BasicTraits, Location, UMonotoneTraits};
use dcel::{Dcel, EdgeId, FaceId, HalfedgeId, VertexId};

/// Names a curve that an arrangement stores: the support of edges.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct CurveId(pub u32);

impl CurveId {
    /// The position of the curve.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A surface cut into vertices, edges and faces by curves.
///
/// An edge is a part of a u-monotone curve, its *support*, between two vertices; halfedge `2 e` runs from the min to the max vertex
/// of edge `e`, in lexicographic order. Which cell is next to which, [`Arrangement::dcel`] knows.
///
/// Vertices without a point stand for open sides of the parameter space, as the one vertex at infinity of the unbounded plane. A
/// contracted side has a vertex, too, whether anything [is there](Arrangement::is_absent) or not: its point is the pole.
///
/// Curves are stored u-monotone, and [`Arrangement::counts`] does not show it: vertices that are there only for that reason are
/// marked, and taken out of the count. See `docs/arrangement.md`.
///
/// # References
/// Thesis, section 2.3.
#[derive(Clone, Debug)]
pub struct Arrangement<G: BasicTraits, T> {
    pub(crate) traits: G,
    pub(crate) topology: T,
    pub(crate) dcel: Dcel,
    pub(crate) points: Vec<Option<G::Point>>,
    pub(crate) is_artificial: Vec<bool>,
    pub(crate) curves: Vec<G::UMonotoneCurve>,
    /// For each edge, its curve.
    pub(crate) supports: Vec<u32>,
    pub(crate) corner_face: FaceId,
    /// For each vertex that stands for a side, the point to which the side is contracted, if it is.
    pub(crate) contractions: Vec<Option<G::Point>>,
    /// Another one after every change.
    pub(crate) stamp: Stamp,
}

impl<G: BasicTraits, T: Topology<G>> Arrangement<G, T> {
    /// The surface without curves: one face.
    pub fn new(traits: G, topology: T) -> Self {
        let built = build::Builder::new(&traits, &topology, &[]).finish(&topology);
        let contractions = build::contractions(&traits, &topology);
        Self {
            contractions,
            traits,
            topology,
            dcel: built.dcel,
            points: built.points,
            is_artificial: built.is_artificial,
            curves: Vec::new(),
            supports: Vec::new(),
            corner_face: build::CORNER_FACE,
            stamp: Stamp::fresh(),
        }
    }

    /// The geometry traits.
    pub fn traits(&self) -> &G {
        &self.traits
    }

    /// The surface.
    pub fn topology(&self) -> &T {
        &self.topology
    }

    /// The cells and their incidences.
    #[inline]
    pub fn dcel(&self) -> &Dcel {
        &self.dcel
    }

    /// Gives the point of a vertex; `None` if it stands for an open side of the parameter space. That of a vertex that was removed means
    /// nothing.
    ///
    /// # Panics
    /// If the arrangement never had the vertex.
    #[inline]
    pub fn point(&self, v: VertexId) -> Option<&G::Point> {
        self.inner_point(v).or_else(|| self.contractions.get(v.index())?.as_ref())
    }

    /// The point by which predicates know a vertex; `None` if it stands for a side, contracted ones included.
    #[inline]
    pub(crate) fn inner_point(&self, v: VertexId) -> Option<&G::Point> {
        self.points[v.index()].as_ref()
    }

    /// Tells whether a vertex stands for an open side of the parameter space, and not for a point.
    #[inline]
    pub fn is_at_infinity(&self, v: VertexId) -> bool {
        self.point(v).is_none()
    }

    /// Tells whether a vertex stands for a side of the parameter space, open or contracted.
    #[inline]
    pub(crate) fn stands_for_side(&self, v: VertexId) -> bool {
        self.points[v.index()].is_none()
    }

    /// The vertices that are points, isolated ones included.
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        self.dcel.vertices().filter(|&v| !self.is_at_infinity(v) && !self.is_absent(v))
    }

    /// Tells whether a vertex is there only because a curve had to be cut: at a u-extremal point, where it crosses an identification, or
    /// where it passes through a contraction. The user's view does not show it.
    pub fn is_artificial(&self, v: VertexId) -> bool {
        self.is_artificial[v.index()] && self.dcel.degree(v) == 2
    }

    /// Tells whether a vertex stands for a contracted side, and nothing is there: no curve comes to the point, and no point was given
    /// there. It is among the cells of [`Arrangement::dcel`], and not among [`Arrangement::vertices`].
    #[inline]
    pub fn is_absent(&self, v: VertexId) -> bool {
        self.is_artificial[v.index()] && self.is_contraction(v) && self.dcel.outgoing(v).is_none()
    }

    /// Tells whether a vertex stands for a contracted side and has a point.
    #[inline]
    pub(crate) fn is_contraction(&self, v: VertexId) -> bool {
        self.contractions.get(v.index()).is_some_and(Option::is_some)
    }

    /// Tells whether something is at a vertex that stands for a contracted side.
    pub(crate) fn is_at_contraction(&self, v: VertexId) -> bool {
        self.dcel.outgoing(v).is_some() || self.is_contraction(v) && !self.is_absent(v)
    }

    /// The vertex that stands for the contracted side on which a place is, if it has a point.
    #[inline]
    pub(crate) fn contraction_at(&self, location: Location) -> Option<VertexId> {
        if self.contractions.is_empty() || location.is_interior() {
            return None;
        }
        crate::zone::side_vertex(self, location).filter(|&v| self.is_contraction(v))
    }

    /// The cell at a place that is on a contracted side: the vertex, or the face around it if nothing is there.
    pub(crate) fn cell_at_contraction(&self, location: Location) -> Option<Cell> {
        let v = self.contraction_at(location)?;
        Some(self.face_of_absent(v).map_or(Cell::Vertex(v), Cell::Face))
    }

    /// The face in which a vertex is that stands for a contracted side, if [nothing is there](Arrangement::is_absent).
    pub(crate) fn face_of_absent(&self, v: VertexId) -> Option<FaceId> {
        self.dcel.isolated_face(v).filter(|_| self.is_absent(v))
    }

    /// The curve of which an edge is a part. That of an edge that was removed means nothing.
    ///
    /// # Panics
    /// If the arrangement never had the edge.
    #[inline]
    pub fn support(&self, e: EdgeId) -> CurveId {
        CurveId(self.supports[e.index()])
    }

    /// A curve that the arrangement stores.
    ///
    /// # Panics
    /// If there is no such curve.
    #[inline]
    pub fn curve(&self, curve: CurveId) -> &G::UMonotoneCurve {
        &self.curves[curve.index()]
    }

    /// The curve of which an edge is a part: [`Arrangement::support`] and [`Arrangement::curve`] in one.
    ///
    /// # Panics
    /// If the arrangement never had the edge.
    #[inline]
    pub fn curve_of(&self, e: EdgeId) -> &G::UMonotoneCurve {
        self.curve(self.support(e))
    }

    /// The curves that the arrangement stores.
    pub fn curves(&self) -> &[G::UMonotoneCurve] {
        &self.curves
    }

    /// Makes the curve of an edge: the part of its support between its vertices.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Complexity
    /// That of cutting a curve twice.
    pub fn make_edge_curve(&self, e: EdgeId) -> G::UMonotoneCurve
    where
        G: UMonotoneTraits,
    {
        let [min, max] = self.dcel.ends(e);
        self.traits.trim(self.curve_of(e), self.inner_point(min), self.inner_point(max))
    }

    /// The face that has no point of a curve below or to the left of it: the unbounded face of a bounded arrangement.
    ///
    /// In an unbounded arrangement it is the face that is left of and below all others, on a torus the one at the lower left
    /// corner of the rectangle.
    ///
    /// A sweep makes it face 0. Edits may give it another id: where it is split or becomes one with another face, the larger of the
    /// two keeps its id.
    #[inline]
    pub fn corner_face(&self) -> FaceId {
        self.corner_face
    }

    /// Tells whether a face is unbounded: it has no outer CCB, or one through infinity. On a torus and on a sphere none is.
    pub fn is_unbounded(&self, f: FaceId) -> bool {
        let through_infinity = |h: HalfedgeId| self.is_at_infinity(self.dcel.source(h));
        self.topology.genus() == 0
            && self.contractions.iter().all(Option::is_none)
            && (self.dcel.outer_ccbs(f).next().is_none()
                || self.dcel.outer_ccbs(f).any(|ccb| self.dcel.ccb_cycle(ccb).any(through_infinity)))
    }
}
