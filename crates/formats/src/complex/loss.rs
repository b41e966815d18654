//! What a mesh would lose of a complex.

use super::{Complex, Position, Vertex};
use polytope::{Facets, PolygonMesh};
use std::fmt;

/// Something that a mesh format cannot hold.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Loss {
    /// The holes of so many facets.
    Holes(usize),
    /// Marks that are not those of a closed set: of vertices, edges, facets and the volumes 0 and 1.
    Marks(usize),
    /// Points beside facets or edges.
    Points(usize),
    /// Edges beside facets.
    Edges(usize),
    /// Facets with nothing of the set on either side.
    Sheets(usize),
    /// Facets between volumes that both belong to the set.
    Walls(usize),
    /// Rays, lines, unbounded facets, and directions that no cell has.
    Unbounded(usize),
    /// Volumes beside 0 and 1. The set does not change if only their numbers are lost.
    Volumes(usize),
    /// There is no cell at all, and a mesh has at least a vertex.
    EmptySet,
}

impl Loss {
    /// Whether points are lost or gained, and not only a name.
    pub(super) fn changes_the_set(self) -> bool {
        !matches!(self, Self::Volumes(_))
    }
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (count, what) = match self {
            Self::Marks(n) => (n, ["mark of its own", "marks of their own"]),
            Self::Points(n) => (n, ["isolated vertex", "isolated vertices"]),
            Self::Edges(n) => (n, ["edge of its own", "edges of their own"]),
            Self::Sheets(n) => (n, ["facet without volume behind it", "facets without volume behind them"]),
            Self::Walls(n) => (n, ["facet within the set", "facets within the set"]),
            Self::Unbounded(n) => (n, ["unbounded cell", "unbounded cells"]),
            Self::Volumes(n) => (n, ["volume beside 0 and 1", "volumes beside 0 and 1"]),
            Self::Holes(n) => {
                return write!(f, "the holes of {n} {}", if *n == 1 { "facet" } else { "facets" });
            }
            Self::EmptySet => return f.write_str("the empty set"),
        };
        write!(f, "{count} {}", if *count == 1 { what[0] } else { what[1] })
    }
}

impl Complex {
    /// The mesh, if a mesh can say all: points only; segments only; one polygon, with nothing or volume 1 behind it;
    /// or facets between volume 0 and volume 1, all without holes, directions and marks. Facets with volume 1 in
    /// front are turned round.
    ///
    /// Vertices, and facets or segments, keep their order.
    ///
    /// # Errors
    /// Everything that a mesh would lose.
    ///
    /// # Panics
    /// If a vertex does not exist, or the facets have 2^32 corners or more.
    ///
    /// # Complexity
    /// O(n log e) for n cells and corners, and e edges.
    pub fn as_mesh(&self) -> Result<PolygonMesh, Vec<Loss>> {
        let losses = self.losses();
        if !losses.is_empty() {
            return Err(losses);
        }
        Ok(PolygonMesh { points: self.points().cloned().collect(), facets: self.turned_facets() })
    }

    /// As [`as_mesh`](Self::as_mesh), without a copy of the points; else the complex itself.
    pub(crate) fn into_mesh(self) -> Result<PolygonMesh, Self> {
        if !self.losses().is_empty() {
            return Err(self);
        }
        let facets = self.turned_facets();
        let point = |vertex: Vertex| match vertex.position {
            Position::Point(point) => Some(point),
            Position::Direction(_) => None,
        };
        Ok(PolygonMesh { points: self.vertices.into_iter().filter_map(point).collect(), facets })
    }

    /// The facets of a complex that is a mesh, or its edges.
    fn turned_facets(&self) -> Facets {
        let mut facets = Facets::new();
        if self.facets.is_empty() {
            self.edges.iter().for_each(|edge| facets.push(&edge.ends));
        }
        let mut turned = Vec::new();
        for facet in &self.facets {
            if facet.sides == [1, 0] {
                turned.clear();
                turned.extend(facet.outer.iter().rev());
                facets.push(&turned);
            } else {
                facets.push(&facet.outer);
            }
        }
        facets
    }

    /// Everything that a mesh would lose, in the order of [`Loss`].
    pub(super) fn losses(&self) -> Vec<Loss> {
        let (are_sides, isolated) = (self.are_sides(), self.isolated());
        let own_edges = are_sides.iter().filter(|&&is_side| !is_side).count();
        let edges = if self.facets.is_empty() { 0 } else { own_edges };
        let is_point = |vertex: usize| !self.vertices[vertex].is_direction();
        let points = isolated.iter().filter(|&&vertex| is_point(vertex)).count();
        let points = if self.facets.is_empty() && self.edges.is_empty() { 0 } else { points };
        // A facet with nothing beside it is a polygon.
        let polygon = self.facets.len() == 1 && edges + points == 0;
        let (mut sheets, mut walls, mut holes) = (0, 0, 0);
        for facet in &self.facets {
            holes += usize::from(!facet.holes.is_empty());
            match facet.sides.map(|volume| self.is_marked(volume)) {
                [true, true] => walls += 1,
                [false, false] if !(polygon && facet.sides == [0, 0]) => sheets += 1,
                _ => {}
            }
        }
        let empty = self.vertices.is_empty() && self.edges.is_empty() && self.facets.is_empty();
        let mut losses = Vec::new();
        let mut lose = |loss: fn(usize) -> Loss, count| {
            if count > 0 {
                losses.push(loss(count));
            }
        };
        lose(Loss::Holes, holes);
        lose(Loss::Marks, self.marks());
        lose(Loss::Points, points);
        lose(Loss::Edges, edges);
        lose(Loss::Sheets, sheets);
        lose(Loss::Walls, walls);
        lose(
            Loss::Unbounded,
            self.unbounded() + isolated.len() - isolated.iter().filter(|&&v| is_point(v)).count(),
        );
        lose(Loss::Volumes, self.volumes.keys().filter(|&&volume| volume > 1).count());
        if empty && losses.is_empty() {
            losses.push(Loss::EmptySet);
        }
        losses
    }

    /// The vertices that no edge and no facet has.
    pub(super) fn isolated(&self) -> Vec<usize> {
        let mut isolated = vec![true; self.vertices.len()];
        let ends = self.edges.iter().flat_map(|edge| edge.ends);
        let corners = self.facets.iter().flat_map(|facet| facet.cycles().flatten().copied());
        ends.chain(corners).for_each(|vertex| isolated[vertex as usize] = false);
        (0..isolated.len()).filter(|&vertex| isolated[vertex]).collect()
    }

    /// Marks that are not the usual ones. Volumes beside 0 and 1 have no usual one.
    fn marks(&self) -> usize {
        let vertices = self.vertices.iter().filter(|vertex| !vertex.marked && !vertex.is_direction()).count();
        let edges = self.edges.iter().filter(|edge| !edge.marked).count();
        let facets = self.facets.iter().filter(|facet| !facet.marked).count();
        let volumes = [0, 1].into_iter().filter(|&v| self.is_marked(v) != Self::default_mark(v)).count();
        vertices + edges + facets + volumes
    }

    fn unbounded(&self) -> usize {
        let edges = self.edges.iter().filter(|edge| self.is_unbounded(&edge.ends)).count();
        let is_unbounded = |facet: &&super::Facet| facet.cycles().any(|cycle| self.is_unbounded(cycle));
        edges + self.facets.iter().filter(is_unbounded).count()
    }
}
