//! What is wrong with a mesh, by the places in its file.

use crate::approx::approx_root;
use crate::input::Operand;
use splitstar::exact::Rational;
use splitstar::formats::Place;
use splitstar::polytope::{Defect, MeshError, PolygonMesh};

/// The place at fault, and what is wrong there; not yet what to do.
pub(crate) fn mesh_error(error: &MeshError, operand: &Operand) -> (Option<Place>, String) {
    mesh_error_in(error, &Places { operand, triangulated: None })
}

/// The same of the mesh that came of cutting the facets of `mesh` into triangles.
pub(crate) fn triangles_error(
    error: &MeshError,
    operand: &Operand,
    mesh: &PolygonMesh,
) -> (Option<Place>, String) {
    mesh_error_in(error, &Places { operand, triangulated: Some(mesh) })
}

fn mesh_error_in(error: &MeshError, places: &Places<'_>) -> (Option<Place>, String) {
    match error {
        MeshError::NotClosed(defect) => not_closed(*defect, places),
        MeshError::NonPlanar { facet, vertex, squared_distance } => (
            places.facet(*facet),
            format!(
                "the facet is not planar: {} lies {} off the plane of its first corners; the square of this distance \
                 is {}",
                places.vertex(*vertex),
                approx_root(squared_distance),
                shown_exactly(squared_distance)
            ),
        ),
        MeshError::ReflexEdge { edge: [a, b], facets: [left, right] } => (
            places.facet(*left),
            format!(
                "not convex: the edge from {} to {} is reflex, between the {}",
                places.vertex(*a),
                places.vertex(*b),
                places.facets([*left, *right])
            ),
        ),
        MeshError::SeveralShells { shells, facets } => (
            places.facet(facets[1]),
            format!(
                "not convex: the surface has {shells} shells, those of the {}, say",
                places.facets(*facets)
            ),
        ),
        MeshError::NotOnHull { facet } => (
            places.facet(*facet),
            "not convex: the facet does not lie on the boundary of the convex hull, or the surface covers \
             the boundary more than once"
                .into(),
        ),
        MeshError::ReflexCorner { facet, vertex } => {
            (places.facet(*facet), format!("not convex: the corner at {} is reflex", places.vertex(*vertex)))
        }
        MeshError::LooseEdge { facet } => {
            (places.facet(*facet), "a facet of two vertices beside other facets".into())
        }
        MeshError::ScatteredEdges { facet } => (
            places.facet(*facet),
            "the facets of two vertices do not make up one segment: this one stands apart".into(),
        ),
        other => (None, other.to_string()),
    }
}

/// A number as it is, if it can be read at all.
fn shown_exactly(number: &Rational) -> String {
    const LONGEST: usize = 400;
    let text = number.to_string();
    if text.len() <= LONGEST { text } else { format!("a fraction of {} digits", text.len() - 1) }
}

fn not_closed(defect: Defect, places: &Places<'_>) -> (Option<Place>, String) {
    match defect {
        Defect::Border { edge: [a, b], facet } => (
            places.facet(facet),
            format!(
                "not closed: the edge from {} to {} has a facet on one side only",
                places.vertex(a),
                places.vertex(b)
            ),
        ),
        Defect::Orientation { edge: [a, b], facets } => (
            places.facet(facets[1]),
            format!(
                "the orientation disagrees: the {} both run from {} to {}; turn one of them round",
                places.facets(facets),
                places.vertex(a),
                places.vertex(b)
            ),
        ),
        Defect::NonManifoldEdge { edge: [a, b], facets } => (
            places.vertex_place(a),
            format!(
                "not convex: {facets} facets meet at the edge from {} to {}, and only two may",
                places.vertex(a),
                places.vertex(b)
            ),
        ),
        Defect::NonManifoldVertex { vertex } => (
            places.vertex_place(vertex),
            format!("not convex: the facets at {} form more than one cycle around it", places.vertex(vertex)),
        ),
        Defect::DegenerateCycle { facet } => (
            places.facet(facet),
            "the facet is degenerate: fewer than three corners, or one twice in a row".into(),
        ),
        other => (None, format!("the surface is not closed: {other}")),
    }
}

/// Names the cells of a mesh by their places in its file.
struct Places<'a> {
    operand: &'a Operand,
    /// The mesh of the file, where the one at fault has its triangles.
    triangulated: Option<&'a PolygonMesh>,
}

impl Places<'_> {
    /// A single polygon has a back that is in no file: the polygon stands for it.
    fn facet(&self, facet: u32) -> Option<Place> {
        let facet = self.facet_of_file(facet) as usize;
        self.operand.facet_place(facet).or_else(|| self.operand.facet_place(0))
    }

    /// A facet of k corners has become k - 2 triangles.
    fn facet_of_file(&self, facet: u32) -> u32 {
        let Some(mesh) = self.triangulated else { return facet };
        let mut triangles = 0;
        let is_in = |cycle: &[u32]| {
            triangles += cycle.len().max(3) - 2;
            triangles > facet as usize
        };
        mesh.facets.iter().position(is_in).map_or(facet, |found| found as u32)
    }

    fn vertex_place(&self, vertex: u32) -> Option<Place> {
        self.operand.vertex_place(vertex as usize)
    }

    fn vertex(&self, vertex: u32) -> String {
        let name = vertex + self.operand.read.format.first_index();
        match self.vertex_place(vertex) {
            Some(place) => format!("vertex {name} ({place})"),
            None => format!("vertex {name}"),
        }
    }

    fn facets(&self, [left, right]: [u32; 2]) -> String {
        let places = [left, right].map(|facet| self.facet(facet));
        let [left, right] = [left, right].map(|facet| self.facet_of_file(facet));
        match places {
            [Some(a), Some(b)] => format!("facets {left} ({a}) and {right} ({b})"),
            _ => format!("facets {left} and {right}"),
        }
    }
}
