//! Cells of dimension 0 to 3 with marks: what no mesh format can say.

use crate::base::model::Shape;
use crate::format::Format;
use crate::write::{WriteError, WriteNote};
use exact::{Affine3, Point3, Vector3};
use polytope::PolygonMesh;
use std::collections::BTreeMap;
use std::fmt;

/// A set of points of space, cut into cells: vertices, edges, facets and volumes, each of which belongs to the set or
/// not (its mark).
///
/// Nothing about it is checked but that indices are those of vertices, and volumes are declared.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Complex {
    /// Points, and points at infinity.
    pub vertices: Vec<Vertex>,
    /// Edges that are said by themselves: pieces of dimension 1, and edges of facets whose marks are not those of the
    /// default.
    pub edges: Vec<Edge>,
    /// The facets.
    pub facets: Vec<Facet>,
    /// Whether the points of each volume belong to the set. Volume 0 is what is outside, 1 what is inside.
    pub volumes: BTreeMap<u32, bool>,
}

/// A vertex.
#[derive(Clone, Debug)]
pub struct Vertex {
    /// Where it is.
    pub position: Position,
    /// Whether it belongs to the set.
    pub marked: bool,
}

/// Where a vertex is.
#[derive(Clone, Debug)]
pub enum Position {
    /// A point.
    Point(Point3),
    /// The point at infinity in a direction, where rays and unbounded facets end. Its length does not matter.
    Direction(Vector3),
}

/// An edge.
#[derive(Clone, Debug)]
pub struct Edge {
    /// Its ends: two points bound a segment, a point and a direction a ray, two opposite directions a line.
    pub ends: [u32; 2],
    /// A point of a line, which has no vertex to say where it lies.
    pub through: Option<Point3>,
    /// Whether it belongs to the set.
    pub marked: bool,
}

/// A facet: a planar region, perhaps with holes, perhaps unbounded.
#[derive(Clone, Debug)]
pub struct Facet {
    /// The vertices around it, counterclockwise seen from its front.
    pub outer: Vec<u32>,
    /// The vertices around each hole, clockwise seen from the front; one vertex is a missing or isolated point, two
    /// an edge within the facet.
    pub holes: Vec<Vec<u32>>,
    /// A point of a facet that is bounded by directions only.
    pub through: Option<Point3>,
    /// The volumes in front and behind. In front is the side from which the outer cycle is counterclockwise.
    pub sides: [u32; 2],
    /// Whether it belongs to the set.
    pub marked: bool,
}

impl Complex {
    /// The mesh that a format without marks, holes and directions can hold. With `lossy` the regular part is given,
    /// and what is left out is noted.
    pub(crate) fn to_mesh(
        &self,
        _format: Format,
        _lossy: bool,
        _notes: &mut Vec<WriteNote>,
    ) -> Result<PolygonMesh, WriteError> {
        unimplemented!()
    }

    /// The points among its vertices, in order.
    pub fn points(&self) -> impl Iterator<Item = &Point3> {
        self.vertices.iter().filter_map(|vertex| match &vertex.position {
            Position::Point(point) => Some(point),
            Position::Direction(_) => None,
        })
    }

    /// Whether there are vertices at infinity.
    pub fn has_directions(&self) -> bool {
        self.vertices.iter().any(|vertex| matches!(vertex.position, Position::Direction(_)))
    }

    /// The complex of a mesh.
    pub fn of_mesh(_mesh: &PolygonMesh) -> Self {
        unimplemented!()
    }

    /// The mesh, if a mesh can say it all.
    pub fn as_mesh(&self) -> Result<Shape, Vec<Loss>> {
        unimplemented!()
    }

    /// The complex under an affine map; cycles are turned round if the map reflects.
    pub fn transformed(&self, _map: &Affine3) -> Self {
        unimplemented!()
    }
}

/// Something that a format cannot hold.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Loss {
    /// Facets with holes.
    Holes(usize),
    /// Marks that are not those of a closed set.
    Marks(usize),
    /// Points beside facets or edges.
    Points(usize),
    /// Edges beside facets.
    Edges(usize),
    /// Facets with the same volume on both sides.
    Sheets(usize),
    /// Facets between volumes that both belong to the set.
    Walls(usize),
    /// Rays, lines and unbounded facets.
    Unbounded(usize),
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (count, what) = match self {
            Self::Holes(n) => (n, ["facet with holes", "facets with holes"]),
            Self::Marks(n) => (n, ["mark of its own", "marks of their own"]),
            Self::Points(n) => (n, ["isolated vertex", "isolated vertices"]),
            Self::Edges(n) => (n, ["edge of its own", "edges of their own"]),
            Self::Sheets(n) => (n, ["facet without volume behind it", "facets without volume behind them"]),
            Self::Walls(n) => (n, ["facet within the set", "facets within the set"]),
            Self::Unbounded(n) => (n, ["unbounded cell", "unbounded cells"]),
        };
        write!(f, "{count} {}", if *count == 1 { what[0] } else { what[1] })
    }
}
