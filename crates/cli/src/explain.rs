//! What is wrong with a mesh, in the lines of its file.

use crate::approx::approx_root;
use crate::input::Operand;
use splitstar::polytope::{Defect, MeshError};

/// The line at fault, and what is wrong there; not yet what to do.
pub(crate) fn mesh_error(error: &MeshError, operand: &Operand) -> (Option<u32>, String) {
    let lines = Lines(operand);
    match error {
        MeshError::NotClosed(defect) => not_closed(*defect, &lines),
        MeshError::NonPlanar { facet, vertex, squared_distance } => (
            lines.facet(*facet),
            format!(
                "the facet is not planar: {} lies {} off the plane of its first corners",
                lines.vertex(*vertex),
                approx_root(squared_distance)
            ),
        ),
        MeshError::ReflexEdge { edge: [a, b], facets: [left, right] } => (
            lines.facet(*left),
            format!(
                "not convex: the edge from {} to {} is reflex, between the {}",
                lines.vertex(*a),
                lines.vertex(*b),
                lines.facets([*left, *right])
            ),
        ),
        MeshError::SeveralShells { shells, facets } => (
            lines.facet(facets[1]),
            format!(
                "not convex: the surface has {shells} shells, those of the {}, say",
                lines.facets(*facets)
            ),
        ),
        MeshError::NotOnHull { facet } => (
            lines.facet(*facet),
            "not convex: the facet does not lie on the boundary of the convex hull, or the surface covers \
             the boundary more than once"
                .into(),
        ),
        MeshError::ReflexCorner { facet, vertex } => {
            (lines.facet(*facet), format!("not convex: the corner at {} is reflex", lines.vertex(*vertex)))
        }
        MeshError::LooseEdge { facet } => {
            (lines.facet(*facet), "a facet of two vertices beside other facets".into())
        }
        MeshError::ScatteredEdges { facet } => (
            lines.facet(*facet),
            "the facets of two vertices do not make up one segment: this one stands apart".into(),
        ),
        other => (None, other.to_string()),
    }
}

fn not_closed(defect: Defect, lines: &Lines<'_>) -> (Option<u32>, String) {
    match defect {
        Defect::Border { edge: [a, b], facet } => (
            lines.facet(facet),
            format!(
                "not closed: the edge from {} to {} has a facet on one side only",
                lines.vertex(a),
                lines.vertex(b)
            ),
        ),
        Defect::Orientation { edge: [a, b], facets } => (
            lines.facet(facets[1]),
            format!(
                "the orientation disagrees: the {} both run from {} to {}; turn one of them round",
                lines.facets(facets),
                lines.vertex(a),
                lines.vertex(b)
            ),
        ),
        Defect::NonManifoldEdge { edge: [a, b], facets } => (
            lines.vertex_line(a),
            format!(
                "not convex: {facets} facets meet at the edge from {} to {}, and only two may",
                lines.vertex(a),
                lines.vertex(b)
            ),
        ),
        Defect::NonManifoldVertex { vertex } => (
            lines.vertex_line(vertex),
            format!("not convex: the facets at {} form more than one cycle around it", lines.vertex(vertex)),
        ),
        Defect::DegenerateCycle { facet } => (
            lines.facet(facet),
            "the facet is degenerate: fewer than three corners, or one twice in a row".into(),
        ),
        other => (None, format!("the surface is not closed: {other}")),
    }
}

/// Names the cells of a mesh by the lines of its file.
struct Lines<'a>(&'a Operand);

impl Lines<'_> {
    /// A single polygon has a back that is in no file: the polygon stands for it.
    fn facet(&self, facet: u32) -> Option<u32> {
        self.0.facet_line(facet as usize).or_else(|| self.0.facet_line(0))
    }

    fn vertex_line(&self, vertex: u32) -> Option<u32> {
        self.0.vertex_line(vertex as usize)
    }

    fn vertex(&self, vertex: u32) -> String {
        match self.vertex_line(vertex) {
            Some(line) => format!("vertex {vertex} (line {line})"),
            None => format!("vertex {vertex}"),
        }
    }

    fn facets(&self, [left, right]: [u32; 2]) -> String {
        match [left, right].map(|facet| self.facet(facet)) {
            [Some(a), Some(b)] => format!("facets {left} (line {a}) and {right} (line {b})"),
            _ => format!("facets {left} and {right}"),
        }
    }
}
