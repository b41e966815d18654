//! The regular part of a complex as a mesh: the closure of the interior of the set.

use super::{Complex, Facet, Loss, Position, Vertex};
use crate::base::model::Object;
use crate::format::Format;
use crate::write::{WriteError, WriteNote};
use exact::Point3;
use polytope::{Facets, PolygonMesh, corner_off_plane, triangulate_with_holes};

impl Complex {
    /// The closure of the interior of the set, as a mesh; `None` if it is unbounded or empty, if a facet is not
    /// planar, or if facets with holes cannot be cut.
    ///
    /// # Complexity
    /// O(n log n) for n edges and corners of facets.
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
    /// regular part is, or what is outside belongs to the set; `NothingLeft`, if the regular part is empty;
    /// `NotPlanar` for a facet that is written and is not, and `CutHoles` for one with holes.
    pub(crate) fn to_mesh(
        &self,
        objects: &[Object],
        format: Format,
        lossy: bool,
        notes: &mut Vec<WriteNote>,
    ) -> Result<(PolygonMesh, Vec<Object>), WriteError> {
        self.check().map_err(WriteError::Malformed)?;
        let losses = match self.as_mesh() {
            Ok(mesh) => {
                for (index, cycle) in mesh.facets.iter().enumerate() {
                    check_planar(&mesh.points, cycle, index)?;
                }
                return Ok((mesh, objects.to_vec()));
            }
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
        let mut part = Part::of(self);
        let mut starts = Vec::with_capacity(self.facets.len() + 1);
        for (index, facet) in self.facets.iter().enumerate() {
            starts.push(part.facets.len() as u32);
            if is_boundary(facet) {
                part.push(index, facet)?;
            }
        }
        let end = part.facets.len() as u32;
        if end == 0 {
            return Err(WriteError::NothingLeft);
        }
        // Facets with holes are cut, not left out.
        let left_out = losses.into_iter().filter(|loss| !matches!(loss, Loss::Holes(_)));
        notes.extend(left_out.map(WriteNote::LeftOut));
        if part.cut.0 > 0 {
            notes.push(WriteNote::CutHoles { from: part.cut.0, to: part.cut.1 });
        }
        let moved = |object: &Object| {
            let first_facet = starts.get(object.first_facet as usize).copied().unwrap_or(end);
            Object { name: object.name.clone(), first_facet }
        };
        let objects = objects.iter().map(moved).collect();
        Ok((part.into_mesh(), objects))
    }
}

impl Complex {
    /// A point for each vertex; those of directions mean nothing.
    pub(super) fn points_by_vertex(&self) -> Vec<Point3> {
        let point = |vertex: &Vertex| match &vertex.position {
            Position::Point(point) => point.clone(),
            Position::Direction(_) => Point3::ORIGIN,
        };
        self.vertices.iter().map(point).collect()
    }
}

/// Facets with holes are checked when they are cut.
fn check_planar(points: &[Point3], cycle: &[u32], facet: usize) -> Result<(), WriteError> {
    match corner_off_plane(points, cycle) {
        Some((vertex, squared_distance)) => Err(WriteError::NotPlanar { facet, vertex, squared_distance }),
        None => Ok(()),
    }
}

/// The facets of the regular part. Its vertices are those of the complex until the end, so that errors name these.
struct Part<'a> {
    complex: &'a Complex,
    /// The points; those of directions mean nothing.
    points: Vec<Point3>,
    facets: Facets,
    /// The numbers of facets with holes that were cut, and of their triangles.
    cut: (usize, usize),
}

impl<'a> Part<'a> {
    fn of(complex: &'a Complex) -> Self {
        Self { complex, points: complex.points_by_vertex(), facets: Facets::new(), cut: (0, 0) }
    }

    /// Appends a facet, the side that does not belong to the set in front.
    fn push(&mut self, index: usize, facet: &Facet) -> Result<(), WriteError> {
        let turn = self.complex.is_marked(facet.sides[0]);
        // One of one or two vertices becomes a vertex or an edge between triangles: other facets may meet there.
        let holes: Vec<&[u32]> = facet.holes.iter().map(Vec::as_slice).collect();
        let mut push = |cycle: &mut [u32]| {
            if turn {
                cycle.reverse();
            }
            self.facets.push(cycle);
        };
        if holes.is_empty() {
            check_planar(&self.points, &facet.outer, index)?;
            push(&mut facet.outer.clone());
            return Ok(());
        }
        let triangles = triangulate_with_holes(&self.points, &facet.outer, &holes)
            .map_err(|error| WriteError::CutHoles { facet: index, error })?;
        self.cut.0 += 1;
        self.cut.1 += triangles.len();
        for mut triangle in triangles {
            push(&mut triangle);
        }
        Ok(())
    }

    /// Leaves out the vertices that no facet has.
    fn into_mesh(self) -> PolygonMesh {
        let Self { points, mut facets, .. } = self;
        let mut new: Vec<u32> = vec![0; points.len()];
        facets.corners().iter().for_each(|&corner| new[corner as usize] = 1);
        let mut kept = Vec::new();
        for (point, new) in points.into_iter().zip(&mut new).filter(|(_, used)| **used == 1) {
            *new = kept.len() as u32;
            kept.push(point);
        }
        facets.relabel(&new);
        PolygonMesh { points: kept, facets }
    }
}
