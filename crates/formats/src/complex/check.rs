//! The rules that cells keep.

use super::edges::{are_opposite, sides_of};
use super::{Complex, Edge, Facet, Position, Vertex};
use exact::{Point3, Vector3};
use std::fmt;

/// A cell that is against the rules.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Malformed {
    /// The cell.
    pub cell: Cell,
    /// The rule.
    pub rule: Rule,
}

/// A cell of a complex, by its place in its list.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Cell {
    /// A vertex.
    Vertex(usize),
    /// An edge.
    Edge(usize),
    /// A facet.
    Facet(usize),
}

/// A rule that a cell breaks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Rule {
    /// There is no vertex of this index.
    UnknownVertex(u32),
    /// There is no volume of this number.
    UnknownVolume(u32),
    /// The direction is zero.
    ZeroDirection,
    /// Both ends of an edge are this vertex.
    Loop(u32),
    /// The edge of this index has the same ends, and is the same line if they are directions.
    RepeatedEdge(usize),
    /// A cycle has this vertex twice.
    Repeated(u32),
    /// The outer cycle has fewer than three vertices.
    Small(usize),
    /// A hole has no vertex that is a point.
    HoleWithoutPoint,
    /// The ends of an edge are two directions, and not opposite ones.
    NotOpposite,
    /// Nothing says where a line or a facet lies.
    NoThrough,
    /// The point beside vertices that say where the cell lies.
    NeedlessThrough,
    /// More than one pair of opposite directions in a row: more than one line without a vertex around one facet.
    TwoLines,
    /// A pair of opposite directions in a row in a hole: a line without a vertex there.
    LineInHole,
}

impl fmt::Display for Malformed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, index) = match self.cell {
            Cell::Vertex(index) => ("vertex", index),
            Cell::Edge(index) => ("edge", index),
            Cell::Facet(index) => ("facet", index),
        };
        write!(f, "{what} {index}: {}", self.rule)
    }
}

impl std::error::Error for Malformed {}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownVertex(vertex) => write!(f, "there is no vertex {vertex}; declare it"),
            Self::UnknownVolume(volume) => write!(f, "there is no volume {volume}; declare it"),
            Self::ZeroDirection => f.write_str("the direction is zero; give one that points somewhere"),
            Self::Loop(vertex) => write!(f, "both ends are vertex {vertex}; name two different ones"),
            Self::RepeatedEdge(first) => write!(f, "edge {first} is the same; remove one of them"),
            Self::Repeated(vertex) => write!(
                f,
                "vertex {vertex} stands twice in a cycle; name every vertex of a cycle once, and write a part that \
                 touches the cycle as a hole"
            ),
            Self::Small(size) => write!(
                f,
                "a facet of {size} {}; name three or more, or write an edge",
                if *size == 1 { "vertex" } else { "vertices" }
            ),
            Self::HoleWithoutPoint => {
                f.write_str("a hole without a vertex that is a point; name one that is no direction")
            }
            Self::NotOpposite => f.write_str(
                "an edge between two directions that are not opposite; a line has opposite ones, a ray one",
            ),
            Self::NoThrough => {
                f.write_str("no vertex says where it lies; write `through` and one of its points")
            }
            Self::NeedlessThrough => {
                f.write_str("`through` where the vertices say where it lies; remove it and its point")
            }
            Self::TwoLines => f.write_str(
                "two lines without a vertex around one facet; put a vertex on all of its lines but one",
            ),
            Self::LineInHole => f.write_str("a line without a vertex in a hole; put a vertex on it"),
        }
    }
}

/// Cycles of more vertices look for repeated ones by sorting.
const SMALL: usize = 16;

impl Complex {
    /// Finds the first cell that is against the rules: vertices and volumes exist, no direction is zero, no cycle and
    /// no edge has a vertex twice, no edge is there twice, outer cycles have three vertices or more, and `through`
    /// stands where it is needed and nowhere else.
    ///
    /// # Complexity
    /// O(n log n) for n cells and corners.
    pub fn check(&self) -> Result<(), Malformed> {
        for (index, vertex) in self.vertices.iter().enumerate() {
            if vertex.direction_vector().is_some_and(Vector3::is_zero) {
                return Err(Malformed { cell: Cell::Vertex(index), rule: Rule::ZeroDirection });
            }
        }
        for (index, edge) in self.edges.iter().enumerate() {
            self.check_edge(edge).map_err(|rule| Malformed { cell: Cell::Edge(index), rule })?;
        }
        if let Some([first, again]) = self.repeated_edge() {
            return Err(Malformed { cell: Cell::Edge(again), rule: Rule::RepeatedEdge(first) });
        }
        for (index, facet) in self.facets.iter().enumerate() {
            self.check_facet(facet).map_err(|rule| Malformed { cell: Cell::Facet(index), rule })?;
        }
        Ok(())
    }

    pub(crate) fn check_edge(&self, edge: &Edge) -> Result<(), Rule> {
        let [a, b] = edge.ends;
        self.check_vertices(&edge.ends)?;
        check_segment([a, b])?;
        let is_line = match (self.direction(a), self.direction(b)) {
            (Some(a), Some(b)) if !are_opposite(a, b) => return Err(Rule::NotOpposite),
            (Some(_), Some(_)) => true,
            _ => false,
        };
        through_as_needed(is_line, edge.through.as_ref())
    }

    pub(crate) fn check_facet(&self, facet: &Facet) -> Result<(), Rule> {
        for cycle in facet.cycles() {
            self.check_vertices(cycle)?;
            check_repeated(cycle)?;
        }
        check_size(&facet.outer)?;
        let at_infinity = |cycle: &[u32]| cycle.iter().all(|&vertex| self.direction(vertex).is_some());
        if facet.holes.iter().any(|hole| at_infinity(hole)) {
            return Err(Rule::HoleWithoutPoint);
        }
        let lines = sides_of(&facet.outer).filter(|&side| self.is_line(side)).count();
        let in_holes = facet.holes.iter().flat_map(|hole| sides_of(hole)).any(|side| self.is_line(side));
        if in_holes {
            return Err(Rule::LineInHole);
        }
        if lines > 1 {
            return Err(Rule::TwoLines);
        }
        through_as_needed(lines == 1 || at_infinity(&facet.outer), facet.through.as_ref())?;
        match facet.sides.into_iter().find(|&volume| !self.has_volume(volume)) {
            Some(volume) => Err(Rule::UnknownVolume(volume)),
            None => Ok(()),
        }
    }

    fn check_vertices(&self, vertices: &[u32]) -> Result<(), Rule> {
        match vertices.iter().find(|&&vertex| vertex as usize >= self.vertices.len()) {
            Some(&vertex) => Err(Rule::UnknownVertex(vertex)),
            None => Ok(()),
        }
    }

    /// The direction of a vertex at infinity.
    pub(crate) fn direction(&self, vertex: u32) -> Option<&Vector3> {
        self.vertices[vertex as usize].direction_vector()
    }

    /// Whether some of the vertices are at infinity.
    pub(crate) fn is_unbounded(&self, cycle: &[u32]) -> bool {
        cycle.iter().any(|&vertex| self.direction(vertex).is_some())
    }
}

impl Vertex {
    pub(crate) fn direction_vector(&self) -> Option<&Vector3> {
        match &self.position {
            Position::Direction(direction) => Some(direction),
            Position::Point(_) => None,
        }
    }
}

fn through_as_needed(needed: bool, through: Option<&Point3>) -> Result<(), Rule> {
    match (needed, through) {
        (true, None) => Err(Rule::NoThrough),
        (false, Some(_)) => Err(Rule::NeedlessThrough),
        _ => Ok(()),
    }
}

/// The rule for an edge between two points.
pub(crate) fn check_segment([a, b]: [u32; 2]) -> Result<(), Rule> {
    if a == b { Err(Rule::Loop(a)) } else { Ok(()) }
}

/// The rules for the cycle of a facet that has no hole and no direction.
pub(crate) fn check_polygon(cycle: &[u32]) -> Result<(), Rule> {
    check_repeated(cycle)?;
    check_size(cycle)
}

fn check_repeated(cycle: &[u32]) -> Result<(), Rule> {
    repeated(cycle).map_or(Ok(()), |vertex| Err(Rule::Repeated(vertex)))
}

fn check_size(outer: &[u32]) -> Result<(), Rule> {
    if outer.len() < 3 { Err(Rule::Small(outer.len())) } else { Ok(()) }
}

/// A vertex that a cycle has twice.
fn repeated(cycle: &[u32]) -> Option<u32> {
    if cycle.len() <= SMALL {
        return (1..cycle.len()).find_map(|at| cycle[..at].contains(&cycle[at]).then_some(cycle[at]));
    }
    let mut vertices = cycle.to_vec();
    vertices.sort_unstable();
    vertices.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}
