//! The facts about an arrangement: one JSON object, or a readable table.

use crate::report::{Seconds, one_line_of_json};
use serde::Serialize;
use splitstar::formats::StarArrangement;

/// The object that `arrange --json` prints.
#[derive(Serialize)]
pub(crate) struct CellReport {
    pub(crate) vertices: usize,
    pub(crate) edges: usize,
    pub(crate) faces: usize,
    isolated: usize,
    components: usize,
    with_splits: Split,
    pub(crate) seconds: Seconds,
}

/// The numbers of cells as they are stored.
#[derive(Serialize)]
struct Split {
    vertices: usize,
    edges: usize,
    faces: usize,
}

impl CellReport {
    pub(crate) fn of(arrangement: &StarArrangement) -> Self {
        let (counts, split) = (arrangement.counts(), arrangement.counts_with_splits());
        Self {
            vertices: counts.vertices,
            edges: counts.edges,
            faces: counts.faces,
            isolated: counts.isolated,
            components: counts.components,
            with_splits: Split { vertices: split.vertices, edges: split.edges, faces: split.faces },
            seconds: Seconds::default(),
        }
    }

    /// One line.
    pub(crate) fn json(&self) -> String {
        one_line_of_json(self)
    }

    pub(crate) fn table(&self) -> String {
        let Self { vertices, edges, faces, isolated, components, with_splits, .. } = self;
        let split = format!(
            "vertices {}, edges {}, faces {}",
            with_splits.vertices, with_splits.edges, with_splits.faces
        );
        let rows = [
            ("vertices", vertices.to_string()),
            ("edges", edges.to_string()),
            ("faces", faces.to_string()),
            ("isolated", isolated.to_string()),
            ("components", components.to_string()),
            ("with splits", split),
        ];
        rows.iter().map(|(name, value)| format!("{name:<12}{value}\n")).collect()
    }
}
