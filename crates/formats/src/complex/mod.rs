//! Cells of dimension 0 to 3 with marks: what no mesh format can say.
//!
//! | file | role |
//! |---|---|
//! | `mod` | the cells, from a mesh, under a map |
//! | `check` | the rules that cells keep |
//! | `edges` | which edges are sides of facets, and which are said twice |
//! | `loss` | what a mesh would lose |
//! | `regular` | the regular part as a mesh |
//! | `triangles` | facets cut into triangles |
//! | `summary` | counts |

mod check;
mod edges;
mod loss;
mod regular;
mod summary;
mod triangles;

pub use check::{Cell, Malformed, Rule};
pub(crate) use check::{check_polygon, check_segment};
pub(crate) use edges::repeated_segment;
pub use loss::Loss;
pub use summary::{ComplexSummary, UnmarkedCells};

use crate::base::model::Kind;
use exact::{Affine3, Point3, Sign, Vector3};
use polytope::{Facets, Mended, PolygonMesh};
use std::collections::BTreeMap;

/// A set of points of space, cut into cells: vertices, edges, facets and volumes, each of which belongs to the set or
/// not (its mark).
///
/// [`check`](Self::check) says what the lists must keep, and readers and writers do check it. How the cells lie in
/// space is not checked there: whether facets are planar only where a mesh is made of them, whether cells meet in
/// vertices and edges only nowhere.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Complex {
    /// Points, and points at infinity. One that no edge and no facet has is an isolated point.
    pub vertices: Vec<Vertex>,
    /// Edges that are said by themselves, each once: pieces of dimension 1, and sides of facets that do not belong to
    /// the set.
    /// All other sides of facets are edges that do.
    pub edges: Vec<Edge>,
    /// The facets.
    pub facets: Vec<Facet>,
    /// Whether the points of each volume belong to the set. Volume 0 is what is outside, 1 what is inside; if they
    /// are not in the map, 0 is unmarked and 1 is marked.
    pub volumes: BTreeMap<u32, bool>,
}

/// A vertex.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Vertex {
    /// Where it is.
    pub position: Position,
    /// Whether it belongs to the set. For a direction it means nothing, and readers give `false`.
    pub marked: bool,
}

/// Where a vertex is.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Position {
    /// A point.
    Point(Point3),
    /// The point at infinity in a direction, where rays and unbounded facets end. Its length does not matter.
    Direction(Vector3),
}

/// An edge.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Edge {
    /// Its ends: two points bound a segment, a point and a direction a ray, two opposite directions a line.
    pub ends: [u32; 2],
    /// A point of a line, which has no vertex to say where it lies.
    pub through: Option<Point3>,
    /// Whether it belongs to the set.
    pub marked: bool,
}

/// A facet: a planar region, perhaps with holes, perhaps unbounded.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Facet {
    /// The vertices around it, counterclockwise seen from its front. Between two directions it has a piece of the
    /// circle at infinity; if they are opposite, the line through `through`.
    pub outer: Vec<u32>,
    /// The vertices around each hole, clockwise seen from the front; one vertex is a missing or isolated point, two
    /// an edge within the facet.
    pub holes: Vec<Vec<u32>>,
    /// A point of a facet that has no vertex but directions; if two opposite ones follow each other, of the line
    /// between them.
    pub through: Option<Point3>,
    /// The volumes in front and behind. In front is the side from which the outer cycle is counterclockwise.
    pub sides: [u32; 2],
    /// Whether it belongs to the set.
    pub marked: bool,
}

/// The empty set: nothing outside, and no cell.
impl Default for Complex {
    fn default() -> Self {
        let volumes = [0, 1].map(|volume| (volume, Self::default_mark(volume)));
        Self { vertices: Vec::new(), edges: Vec::new(), facets: Vec::new(), volumes: volumes.into() }
    }
}

impl Complex {
    /// Whether a volume belongs to the set if nothing is said: what is outside does not.
    pub(crate) fn default_mark(volume: u32) -> bool {
        volume != 0
    }

    /// Whether a volume belongs to the set.
    pub fn is_marked(&self, volume: u32) -> bool {
        self.volumes.get(&volume).copied().unwrap_or(Self::default_mark(volume))
    }

    /// Whether there is such a volume.
    pub(crate) fn has_volume(&self, volume: u32) -> bool {
        volume <= 1 || self.volumes.contains_key(&volume)
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
        self.vertices.iter().any(Vertex::is_direction)
    }

    /// The complex of a mesh: isolated points; segments; one polygon, which encloses nothing; or the surface of
    /// volume 1.
    ///
    /// Vertices without a facet are left out, and the others renumbered, where there are facets: they would be points
    /// of the set. Segments that the mesh has twice are edges once.
    ///
    /// # Panics
    /// If a corner is the index of no vertex.
    ///
    /// # Complexity
    /// Linear; for n segments O(n log n).
    pub fn of_mesh(mesh: &PolygonMesh) -> Self {
        let mut complex = Self::default();
        let kind = Kind::of(mesh);
        let mut used = vec![kind == Kind::Points; mesh.points.len()];
        mesh.facets.corners().iter().for_each(|&corner| used[corner as usize] = true);
        let mut new = vec![0_u32; mesh.points.len()];
        for (old, point) in mesh.points.iter().enumerate().filter(|&(old, _)| used[old]) {
            new[old] = complex.vertices.len() as u32;
            complex.vertices.push(Vertex::point(point.clone()));
        }
        if kind == Kind::Segments {
            let segments = distinct_segments(&mesh.facets).into_iter();
            let ends = segments.map(|index| [0, 1].map(|end| mesh.facets.get(index as usize)[end]));
            complex.edges.extend(ends.map(|ends| Edge::segment(ends.map(|old| new[old as usize]))));
            return complex;
        }
        let sides = if kind == Kind::Surface { [0, 1] } else { [0, 0] };
        for cycle in mesh.facets.iter() {
            let outer = cycle.iter().map(|&old| new[old as usize]).collect();
            complex.facets.push(Facet::of_cycle(outer, sides));
        }
        complex
    }

    /// The complex of a mended mesh, whose facets may have holes: as [`of_mesh`](Self::of_mesh), with all its vertices.
    /// A single facet encloses nothing.
    ///
    /// # Complexity
    /// Linear; for n segments O(n log n).
    pub fn of_mended(mended: Mended) -> Self {
        let Mended { mesh, holes, .. } = mended;
        if holes.is_empty() {
            return Self::of_mesh(&mesh);
        }
        let mut complex = Self::default();
        let sides = if mesh.facets.len() == 1 { [0, 0] } else { [0, 1] };
        complex.facets.extend(mesh.facets.iter().map(|cycle| Facet::of_cycle(cycle.to_vec(), sides)));
        for hole in holes {
            complex.facets[hole.facet as usize].holes.push(hole.cycle);
        }
        complex.vertices.extend(mesh.points.into_iter().map(Vertex::point));
        complex
    }

    /// The complex under an affine map: points by the map, directions by its linear part. If the map reflects, cycles
    /// are turned round, so that they are counterclockwise from the front again; sides and marks stay.
    ///
    /// `None` if the map takes a direction to zero, as only maps do that flatten space: an unbounded cell may then
    /// become a bounded one.
    ///
    /// Degenerate: under a map that flattens space, cells may cover each other or lose their dimension.
    ///
    /// # Complexity
    /// Linear.
    pub fn transformed(&self, map: &Affine3) -> Option<Self> {
        let vertex = |vertex: &Vertex| {
            let position = match &vertex.position {
                Position::Point(point) => Position::Point(map.apply(point)),
                Position::Direction(direction) => {
                    let image = map.linear().apply(direction);
                    if image.is_zero() {
                        return None;
                    }
                    Position::Direction(image.primitive())
                }
            };
            Some(Vertex { position, marked: vertex.marked })
        };
        let mut image = self.clone();
        image.vertices = self.vertices.iter().map(vertex).collect::<Option<_>>()?;
        let through = image.edges.iter_mut().map(|edge| &mut edge.through);
        for point in through.chain(image.facets.iter_mut().map(|facet| &mut facet.through)).flatten() {
            *point = map.apply(point);
        }
        if map.determinant_sign() == Sign::Negative {
            for facet in &mut image.facets {
                facet.outer.reverse();
                facet.holes.iter_mut().for_each(|hole| hole.reverse());
            }
        }
        Some(image)
    }
}

/// The indices of the segments of a mesh, without those that have the ends of one before.
pub(crate) fn distinct_segments(segments: &Facets) -> Vec<u32> {
    let mut by_ends: Vec<([u32; 2], u32)> =
        segments.iter().map(|ends| edges::sorted([ends[0], ends[1]])).zip(0..).collect();
    by_ends.sort_unstable();
    by_ends.dedup_by_key(|(ends, _)| *ends);
    let mut indices: Vec<u32> = by_ends.into_iter().map(|(_, index)| index).collect();
    indices.sort_unstable();
    indices
}

impl Vertex {
    /// A point of the set.
    pub fn point(point: Point3) -> Self {
        Self { position: Position::Point(point), marked: true }
    }

    /// A point at infinity.
    pub fn direction(direction: Vector3) -> Self {
        Self { position: Position::Direction(direction), marked: false }
    }

    /// Whether it is a point at infinity.
    pub fn is_direction(&self) -> bool {
        matches!(self.position, Position::Direction(_))
    }
}

impl Edge {
    /// An edge of the set that has an end which is a point: a segment or a ray.
    pub fn segment(ends: [u32; 2]) -> Self {
        Self { ends, through: None, marked: true }
    }

    /// The line of the set through a point, between two opposite directions.
    pub fn line(ends: [u32; 2], through: Point3) -> Self {
        Self { ends, through: Some(through), marked: true }
    }
}

impl Facet {
    /// A facet of one cycle between two volumes, which belongs to the set.
    pub fn of_cycle(outer: Vec<u32>, sides: [u32; 2]) -> Self {
        Self { outer, holes: Vec::new(), through: None, sides, marked: true }
    }

    /// Its cycles, the outer one first.
    pub fn cycles(&self) -> impl Iterator<Item = &[u32]> {
        std::iter::once(self.outer.as_slice()).chain(self.holes.iter().map(Vec::as_slice))
    }
}
