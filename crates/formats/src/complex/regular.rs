//! The regular part of a complex as a mesh: the closure of the interior of the set.

use super::{Complex, Facet, Loss, Position};
use crate::base::model::Object;
use crate::format::Format;
use crate::write::{WriteError, WriteNote};
use exact::Point3;
use polytope::{Facets, PolygonMesh, TriangulateError};

impl Complex {
    /// The closure of the interior of the set, as a mesh; `None` if it is unbounded or empty, or if facets with holes
    /// cannot be cut.
    pub fn regular_part(&self) -> Option<PolygonMesh> {
        self.to_mesh(&[], Format::Off, true, &mut Vec::new()).ok().map(|(mesh, _)| mesh)
    }

    /// The mesh, and its objects, that a format without marks, holes and directions can hold. With `lossy` the
    /// regular part is given, and what is left out is noted.
    ///
    /// The regular part is bounded by the facets between a volume of the set and one that is not; holes that enclose
    /// an area are cut away, by triangulating the facet.
    ///
    /// # Errors
    /// `Loses` with all losses, if the set would change and `lossy` is not given; `Unbounded`, if a facet of the
    /// regular part is, or what is outside belongs to the set; `NothingLeft`, if the regular part is empty.
    pub(crate) fn to_mesh(
        &self,
        objects: &[Object],
        format: Format,
        lossy: bool,
        notes: &mut Vec<WriteNote>,
    ) -> Result<(PolygonMesh, Vec<Object>), WriteError> {
        self.check().map_err(WriteError::Malformed)?;
        let losses = match self.as_mesh() {
            Ok(mesh) => return Ok((mesh, objects.to_vec())),
            Err(losses) => losses,
        };
        if !lossy && losses.iter().any(|loss| loss.changes_the_set()) {
            return Err(WriteError::Loses { format, losses });
        }
        let is_boundary = |facet: &Facet| self.is_marked(facet.sides[0]) != self.is_marked(facet.sides[1]);
        let is_unbounded = |facet: &Facet| facet.cycles().any(|cycle| self.is_unbounded(cycle));
        if self.is_marked(0) || self.facets.iter().any(|facet| is_boundary(facet) && is_unbounded(facet)) {
            return Err(WriteError::Unbounded);
        }
        let mut part = Part::new(self);
        let mut starts = Vec::with_capacity(self.facets.len() + 1);
        for facet in &self.facets {
            starts.push(part.facets.len() as u32);
            if is_boundary(facet) {
                part.push(facet)?;
            }
        }
        let end = part.facets.len() as u32;
        if end == 0 {
            return Err(WriteError::NothingLeft);
        }
        notes.extend(
            losses.iter().filter(|loss| !matches!(loss, Loss::Holes(_))).copied().map(WriteNote::LeftOut),
        );
        if part.cut.0 > 0 {
            notes.push(WriteNote::CutHoles { from: part.cut.0, to: part.cut.1 });
        }
        let moved = |object: &Object| {
            let first_facet = starts.get(object.first_facet as usize).copied().unwrap_or(end);
            Object { name: object.name.clone(), first_facet }
        };
        let objects = objects.iter().map(moved).collect();
        Ok((PolygonMesh { points: part.points, facets: part.facets }, objects))
    }
}

/// The facets of the regular part, and the vertices that they have.
struct Part<'a> {
    complex: &'a Complex,
    /// For each vertex of the complex its index here.
    new: Vec<Option<u32>>,
    points: Vec<Point3>,
    facets: Facets,
    /// The numbers of facets with holes that were cut, and of their triangles.
    cut: (usize, usize),
}

impl<'a> Part<'a> {
    fn new(complex: &'a Complex) -> Self {
        let mut part = Self {
            complex,
            new: vec![None; complex.vertices.len()],
            points: Vec::new(),
            facets: Facets::new(),
            cut: (0, 0),
        };
        let is_boundary =
            |facet: &&Facet| complex.is_marked(facet.sides[0]) != complex.is_marked(facet.sides[1]);
        let mut used = vec![false; complex.vertices.len()];
        for facet in complex.facets.iter().filter(is_boundary) {
            // A hole of one or two vertices has no area, and disappears.
            let cycles = facet.cycles().filter(|cycle| cycle.len() > 2);
            cycles.flatten().for_each(|&vertex| used[vertex as usize] = true);
        }
        for (vertex, used) in complex
            .vertices
            .iter()
            .zip(&mut part.new)
            .zip(used)
            .filter(|(_, used)| *used)
            .map(|(pair, _)| pair)
        {
            let Position::Point(point) = &vertex.position else { continue };
            *used = Some(part.points.len() as u32);
            part.points.push(point.clone());
        }
        part
    }

    /// Appends a facet, the side that does not belong to the set in front.
    fn push(&mut self, facet: &Facet) -> Result<(), WriteError> {
        let turn = self.complex.is_marked(facet.sides[0]);
        let renumbered = |cycle: &[u32]| {
            let index = |&vertex: &u32| self.new[vertex as usize].expect("a bounded facet has points only");
            let mut cycle: Vec<u32> = cycle.iter().map(index).collect();
            if turn {
                cycle.reverse();
            }
            cycle
        };
        let outer = renumbered(&facet.outer);
        let holes: Vec<Vec<u32>> =
            facet.holes.iter().filter(|hole| hole.len() > 2).map(|hole| renumbered(hole)).collect();
        if holes.is_empty() {
            self.facets.push(&outer);
            return Ok(());
        }
        let holes: Vec<&[u32]> = holes.iter().map(Vec::as_slice).collect();
        let name = self.complex.facets.iter().position(|other| std::ptr::eq(other, facet)).unwrap_or(0);
        let triangles = triangulate_with_holes(&self.points, &outer, &holes)
            .map_err(|_| WriteError::Triangulate(TriangulateError::Tangled { facet: name }))?;
        triangles.iter().for_each(|triangle| self.facets.push(triangle));
        self.cut.0 += 1;
        self.cut.1 += triangles.len();
        Ok(())
    }
}

/// Stands for the function of `polytope`, which is not there yet.
fn triangulate_with_holes(
    _points: &[Point3],
    _outer: &[u32],
    _holes: &[&[u32]],
) -> Result<Vec<[u32; 3]>, ()> {
    Err(())
}
