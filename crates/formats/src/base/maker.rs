//! How a reader makes a mesh: vertex by vertex, facet by facet, within its budget.

use super::budget::Budget;
use super::error::{Count, Fault, Located};
use super::model::{Kind, Model, ReadModel, ReadNote};
use super::places::{Place, PlaceList, Places};
use crate::format::Format;
use exact::Point3;
use polytope::{Facets, PolygonMesh};

/// Collects points and facets with their places, and charges them to the budget.
#[derive(Debug)]
pub(crate) struct MeshMaker<'b> {
    points: Vec<Point3>,
    facets: Facets,
    vertex_places: PlaceList,
    facet_places: PlaceList,
    budget: &'b mut Budget,
    /// For each vertex the last large facet that has it, counted from 1, and its place in that facet.
    seen: Vec<(u32, u32)>,
    notes: Vec<ReadNote>,
}

/// Facets of more corners look for repeated ones in a table.
const SMALL: usize = 16;

/// A growing list takes up to twice the size of what it holds.
const GROWTH: u64 = 2;
const VERTEX: u64 = GROWTH * size_of::<Point3>() as u64;
const FACET: u64 = GROWTH * 4;
const CORNER: u64 = GROWTH * 4;
/// What is done with a mesh takes at most so much memory besides: copies of it, tables of positions and of edges. `info`
/// takes most.
const VERTEX_LATER: u64 = 96;
const CORNER_LATER: u64 = 72;
/// Copies of a point that is not narrow, with the numbers that are written for it.
const WIDE_LATER: u64 = 4;

/// Reserves what is done with a vertex after it is read; `wide` is what its point takes on the heap.
#[inline]
pub(crate) fn reserve_vertex(budget: &mut Budget, wide: u64) -> Result<(), Fault> {
    budget.reserve(VERTEX_LATER + WIDE_LATER * wide)
}

/// Reserves what is done with so many corners of facets after they are read.
#[inline]
pub(crate) fn reserve_corners(budget: &mut Budget, corners: u64) -> Result<(), Fault> {
    budget.reserve(CORNER_LATER * corners)
}

/// What a point takes on the heap when its numbers do not fit into machine words: four numbers with their floats, and
/// the digits of those that are longer than two words.
pub(crate) fn wide_bytes(point: &Point3) -> u64 {
    let digits = match point.bits() {
        0..=128 => 0,
        bits => 4 * (u64::from(bits) * 9 / 64 + 40),
    };
    160 + digits
}

impl<'b> MeshMaker<'b> {
    /// An empty mesh, with empty lists for the places of vertices and facets.
    pub(crate) fn new(budget: &'b mut Budget, vertex_places: PlaceList, facet_places: PlaceList) -> Self {
        let (points, facets, seen, notes) = (Vec::new(), Facets::new(), Vec::new(), Vec::new());
        Self { points, facets, vertex_places, facet_places, budget, seen, notes }
    }

    pub(crate) fn vertex_count(&self) -> u32 {
        self.points.len() as u32
    }

    pub(crate) fn facet_count(&self) -> u32 {
        self.facets.len() as u32
    }

    /// For what a reader keeps beside the mesh.
    pub(crate) fn budget(&mut self) -> &mut Budget {
        self.budget
    }

    /// Adds a note on what is left out.
    pub(crate) fn note(&mut self, note: ReadNote) {
        self.notes.push(note);
    }

    /// Appends a vertex, and gives its index.
    #[inline]
    pub(crate) fn vertex(&mut self, point: Point3, place: Place) -> Result<u32, Fault> {
        let wide = if point.as_narrow().is_some() { 0 } else { wide_bytes(&point) };
        self.budget.charge(VERTEX + GROWTH * self.vertex_places.bytes_each() + wide)?;
        reserve_vertex(self.budget, wide)?;
        let index = self.vertex_count();
        if index == u32::MAX - 1 {
            return Err(Fault::CountTooLarge {
                token: (u64::from(index) + 1).to_string(),
                of: Count::Vertices,
            });
        }
        self.points.push(point);
        self.vertex_places.push(place);
        Ok(index)
    }

    /// Appends a facet of at least two corners, all different, each the index of a vertex that was appended before.
    /// The error names vertices as the file does: its first vertex is `base`.
    #[inline]
    pub(crate) fn facet(&mut self, cycle: &[u32], place: Place, base: u32) -> Result<(), Fault> {
        let place_bytes = GROWTH * self.facet_places.bytes_each();
        let corners = cycle.len() as u64;
        self.budget.charge(FACET + place_bytes + CORNER * corners)?;
        reserve_corners(self.budget, corners)?;
        if cycle.len() < 2 {
            return Err(Fault::SmallFacet { size: cycle.len() as u32 });
        }
        let name = self.facet_count() + 1;
        if name == u32::MAX {
            return Err(Fault::CountTooLarge { token: name.to_string(), of: Count::Facets });
        }
        if let Some((first, second)) = self.repeated(cycle, name)? {
            let in_a_row = second - first == 1 || second - first == cycle.len() - 1;
            return Err(Fault::RepeatedVertex { vertex: cycle[first] + base, in_a_row });
        }
        if self.facets.corners().len() + cycle.len() > u32::MAX as usize {
            return Err(Fault::CountTooLarge { token: (1_u64 << 32).to_string(), of: Count::Corners });
        }
        self.facets.push(cycle);
        self.facet_places.push(place);
        Ok(())
    }

    /// The places in a cycle of the first vertex that it repeats.
    #[inline]
    fn repeated(&mut self, cycle: &[u32], name: u32) -> Result<Option<(usize, usize)>, Fault> {
        if cycle.len() <= SMALL {
            let before = |at: usize| cycle[..at].iter().position(|&vertex| vertex == cycle[at]);
            return Ok((1..cycle.len()).find_map(|at| Some((before(at)?, at))));
        }
        if self.seen.len() < self.points.len() {
            self.budget.charge(8 * (self.points.len() - self.seen.len()) as u64)?;
            self.seen.resize(self.points.len(), (0, 0));
        }
        for (at, &vertex) in cycle.iter().enumerate() {
            let last = &mut self.seen[vertex as usize];
            if last.0 == name {
                return Ok(Some((last.1 as usize, at)));
            }
            *last = (name, at as u32);
        }
        Ok(None)
    }

    /// The model of one mesh. A facet of two vertices is a segment, and has no place beside polygons.
    pub(crate) fn read_model(self, format: Format) -> Result<ReadModel, Located> {
        let Self { points, facets, vertex_places, facet_places, notes, .. } = self;
        if points.is_empty() {
            return Err(Fault::NoVertices.into());
        }
        let is_segment = |cycle: &[u32]| cycle.len() == 2;
        if let Some(segment) = facets.iter().position(is_segment)
            && !facets.iter().all(is_segment)
        {
            return Err(Located { place: facet_places.get(segment), fault: Fault::SegmentBesidePolygons });
        }
        let model = Model::of_mesh(PolygonMesh { points, facets });
        let places = Places { part: None, vertices: vertex_places, facets: facet_places };
        Ok(ReadModel { model, format, places, notes })
    }
}

impl Kind {
    /// Whether the facets are polygons.
    pub(crate) fn has_polygons(self) -> bool {
        matches!(self, Self::Polygon | Self::Surface)
    }
}
