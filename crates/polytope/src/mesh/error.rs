//! What may be wrong with a mesh that should be a polytope, and what was mended.

use dcel::Defect;
use exact::Rational;
use std::fmt;

/// Why a mesh is not the boundary of a convex polytope. Vertices and facets are named by their index
/// in the mesh as it was given.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshError {
    /// The mesh has no point.
    Empty,
    /// The facets do not form a closed, orientable surface.
    NotClosed(Defect),
    /// The corners of a facet do not lie in one plane.
    NonPlanar {
        /// The facet.
        facet: u32,
        /// A corner off the plane of the first three corners that span one.
        vertex: u32,
        /// The square of its distance from that plane.
        squared_distance: Rational,
    },
    /// The surface turns inwards at an edge.
    ReflexEdge {
        /// The ends of the edge.
        edge: [u32; 2],
        /// The facets on both sides.
        facets: [u32; 2],
    },
    /// The surface has more than one shell.
    SeveralShells {
        /// How many.
        shells: u32,
        /// A facet of the first and one of the second shell.
        facets: [u32; 2],
    },
    /// No edge is reflex, and still the facet does not lie on the boundary of the convex hull, or the
    /// surface winds around it more than once.
    NotOnHull {
        /// The facet.
        facet: u32,
    },
    /// The one polygon turns the other way at a corner.
    ReflexCorner {
        /// The facet.
        facet: u32,
        /// The corner.
        vertex: u32,
    },
    /// A facet of two vertices beside other facets.
    LooseEdge {
        /// The facet.
        facet: u32,
    },
    /// Facets of two vertices that do not make up one segment.
    ScatteredEdges {
        /// A facet that does not continue those before it.
        facet: u32,
    },
    /// A corner of a facet that is no vertex.
    NoSuchVertex {
        /// The facet.
        facet: u32,
        /// The index of its corner.
        index: u32,
    },
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "there is no vertex"),
            Self::NotClosed(defect) => write!(f, "the surface is not closed: {defect}"),
            Self::NonPlanar { facet, vertex, squared_distance } => write!(
                f,
                "facet {facet} is not planar: vertex {vertex} is off the plane of the corners before it, the square of \
                 the distance is {squared_distance}"
            ),
            Self::ReflexEdge { edge: [a, b], facets: [p, q] } => write!(
                f,
                "not convex: the edge of vertices {a} and {b} is reflex, between facets {p} and {q}"
            ),
            Self::SeveralShells { shells, facets: [p, q] } => {
                write!(f, "not convex: {shells} shells, for example those of facets {p} and {q}")
            }
            Self::NotOnHull { facet } => write!(
                f,
                "not convex: facet {facet} does not lie on the boundary of the convex hull, or the surface covers it twice"
            ),
            Self::ReflexCorner { facet, vertex } => {
                write!(f, "not convex: the corner of facet {facet} at vertex {vertex} is reflex")
            }
            Self::LooseEdge { facet } => {
                write!(f, "facet {facet} has two vertices only, beside other facets")
            }
            Self::ScatteredEdges { facet } => {
                write!(f, "the facets of two vertices do not make up one segment: facet {facet} stands apart")
            }
            Self::NoSuchVertex { facet, index } => {
                write!(f, "facet {facet} has a corner at vertex {index}, which does not exist")
            }
        }
    }
}

impl std::error::Error for MeshError {}

/// What was mended, without any tolerance, to read a mesh as a polytope.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Note {
    /// Vertices at equal positions were made one.
    Welded {
        /// The number of vertices before.
        from: usize,
        /// The number of distinct positions.
        to: usize,
    },
    /// Facets were dropped that had fewer than three different vertices, perhaps only after these were welded.
    Collapsed {
        /// How many.
        facets: usize,
    },
    /// Vertices on no facet were dropped.
    Unused {
        /// How many.
        vertices: usize,
    },
    /// All facets were turned round: they were clockwise seen from outside.
    TurnedInsideOut,
    /// Coplanar facets and collinear edges were joined.
    Joined {
        /// The numbers of vertices and facets before.
        from: [usize; 2],
        /// And after.
        to: [usize; 2],
    },
    /// There is no facet: the mesh was read as a point set, which stands for its convex hull.
    PointSet,
    /// The surface encloses no volume: the polytope has a lower dimension.
    Flat {
        /// That dimension.
        dimension: u8,
    },
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Welded { from, to } => {
                let positions = if *to == 1 { "one position" } else { "equal positions" };
                write!(f, "{from} vertices welded to {to} at {positions}")
            }
            Self::Collapsed { facets } => {
                let (facets, have) =
                    (counted(*facets, "facet", "facets"), if *facets == 1 { "has" } else { "have" });
                write!(f, "{facets} dropped that {have} fewer than three different vertices")
            }
            Self::Unused { vertices } => {
                write!(f, "{} dropped", counted(*vertices, "unused vertex", "unused vertices"))
            }
            Self::TurnedInsideOut => write!(f, "the mesh is inside out; its facets were turned round"),
            Self::Joined { from: [v, n], to: [w, m] } => {
                let [facets, vertices] = [counted(*n, "facet", "facets"), counted(*v, "vertex", "vertices")];
                write!(
                    f,
                    "coplanar facets and collinear edges joined: {facets} and {vertices} became {m} and {w}"
                )
            }
            Self::PointSet => write!(f, "no facets: read as a point set, its convex hull is taken"),
            Self::Flat { dimension } => {
                write!(f, "the surface encloses no volume: read as a polytope of dimension {dimension}")
            }
        }
    }
}

/// A number of things, with the word for one or for several.
fn counted(number: usize, one: &str, several: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { several })
}
