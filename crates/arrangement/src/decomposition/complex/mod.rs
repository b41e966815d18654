//! The vertical decomposition as a cell complex.
//!
//! | file | role |
//! |---|---|
//! | this one | what a user reads |
//! | `columns` | sites of one u; the corners and the points to which sides are closed |
//! | `pieces` | vertices and edges, made in the order of the sites |
//! | `sides` | those on identified sides |
//! | `cycles` | the boundary of each face |

mod columns;
mod cycles;
mod pieces;
mod sides;

use super::{SiteId, TrapezoidId, VerticalDecomposition};
use crate::arrangement::Arrangement;
use crate::edit::{Stale, Stamp};
use crate::topology::Topology;
use crate::traits::BasicTraits;
use dcel::{Dcel, EdgeId, FaceId, VertexId};

/// What a vertex of a [`DecompositionComplex`] is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum VertexOrigin {
    /// A vertex of the arrangement.
    Vertex(VertexId),
    /// Where walls meet the interior of an edge, or an identified side where no edge runs along it.
    Foot {
        /// The site whose wall comes from below.
        below: Option<SiteId>,
        /// The site whose wall comes from above.
        above: Option<SiteId>,
        /// The edge.
        edge: Option<EdgeId>,
    },
    /// The corner of the parameter space, where all four sides are identified and no vertex is there.
    Corner,
    /// The point to which closed sides are closed.
    Infinity,
}

/// What an edge of a [`DecompositionComplex`] is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum EdgeOrigin {
    /// A piece of an edge of the arrangement, or all of it. It runs the same way.
    Edge(EdgeId),
    /// A wall. It runs upwards.
    Wall {
        /// The site from which it goes up.
        below: Option<SiteId>,
        /// The site from which it goes down.
        above: Option<SiteId>,
    },
    /// A piece of an identified side, where no edge runs along it. It runs as the parameter grows.
    Identification,
}

/// The vertical decomposition as a cell complex: its faces are the trapezoids that are not degenerate.
///
/// No point is constructed. Cells are those of the plane as it is, not sheared: what lies straight above one another is connected by one
/// wall, and walls that meet an edge in one point from both sides have one foot.
///
/// - Vertices are those of the arrangement, and the feet of walls. Sides that are not identified are closed by the vertices that the
///   arrangement has for them. Closed ones get one: a vertex at infinity for all, or where the others are identified, one for each.
/// - Edges are pieces of edges and walls. Along identified sides the parameter space is cut open: there are pieces of these.
/// - Each face has one boundary, an outer CCB, which may come to a vertex or along an edge more than once. Without curves and points, the
///   plane is one face around its vertex at infinity.
///
/// Halfedge `2 e` runs from left to right, along a wall upwards.
///
/// # Examples
/// A segment, from whose ends four walls go to infinity:
///
/// ```
/// use splitstar_arrangement::decomposition::{EdgeOrigin, VertexOrigin, VerticalDecomposition};
/// use splitstar_arrangement::models::{Segment, SegmentTraits};
/// use splitstar_arrangement::{Arrangement, topology::BoundedPlane};
///
/// let segment = Segment::from_i64([[0, 0], [2, 1]]).expect("the ends are different");
/// let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, [&segment]);
/// let complex = VerticalDecomposition::new(&arrangement).complex(&arrangement)?;
/// let dcel = complex.dcel();
/// assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.face_count()), (3, 5, 4));
/// assert!(dcel.check_euler(0).is_empty());
/// let walls = dcel.edges().filter(|&e| matches!(complex.edge_origin(e), EdgeOrigin::Wall { .. }));
/// assert_eq!(walls.count(), 4);
/// let infinity = dcel.vertices().find(|&v| complex.vertex_origin(v) == VertexOrigin::Infinity);
/// assert_eq!(dcel.degree(infinity.expect("walls end there")), 4);
/// # Ok::<(), splitstar_arrangement::edit::Stale>(())
/// ```
///
/// # References
/// Thesis, sections 2.4.5 and 6.1.3.
#[derive(Clone, Debug)]
pub struct DecompositionComplex {
    stamp: Stamp,
    dcel: Dcel,
    vertices: Vec<VertexOrigin>,
    edges: Vec<EdgeOrigin>,
    /// For each face its trapezoid, and the face of the arrangement.
    faces: Vec<(TrapezoidId, FaceId)>,
}

impl DecompositionComplex {
    /// The state of the arrangement that was decomposed.
    pub fn stamp(&self) -> Stamp {
        self.stamp
    }

    /// The cells.
    pub fn dcel(&self) -> &Dcel {
        &self.dcel
    }

    /// What a vertex is.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[inline]
    pub fn vertex_origin(&self, v: VertexId) -> VertexOrigin {
        self.vertices[v.index()]
    }

    /// What an edge is.
    ///
    /// # Panics
    /// If there is no such edge.
    #[inline]
    pub fn edge_origin(&self, e: EdgeId) -> EdgeOrigin {
        self.edges[e.index()]
    }

    /// The trapezoid that a face is.
    ///
    /// # Panics
    /// If there is no such face.
    #[inline]
    pub fn trapezoid(&self, f: FaceId) -> TrapezoidId {
        self.faces[f.index()].0
    }

    /// The face of the arrangement in which a face lies.
    ///
    /// # Panics
    /// If there is no such face.
    #[inline]
    pub fn arrangement_face(&self, f: FaceId) -> FaceId {
        self.faces[f.index()].1
    }

    /// The face that a trapezoid is; `None` if that is degenerate.
    ///
    /// # Complexity
    /// Logarithmic.
    pub fn face_of(&self, t: TrapezoidId) -> Option<FaceId> {
        self.faces.binary_search_by_key(&t, |&(t, _)| t).ok().map(FaceId::new)
    }
}

impl VerticalDecomposition {
    /// Makes the cell complex of the decomposition.
    ///
    /// # Errors
    /// If the decomposition is of another state of the arrangement, or of another arrangement.
    ///
    /// # Panics
    /// With 2^31 pieces or more.
    ///
    /// # Complexity
    /// O(n log n) for n trapezoids: the feet of walls along each edge are sorted, and found by bisection.
    pub fn complex<G: BasicTraits, T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
    ) -> Result<DecompositionComplex, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        let pieces = pieces::Pieces::new(self, arrangement);
        cycles::link(self, arrangement, pieces)
    }
}
