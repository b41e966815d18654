//! The facts about a Gaussian map: one JSON object, or a readable table.

use crate::report::{Seconds, one_line_of_json};
use serde::Serialize;
use splitstar::formats::StarGaussianMap;
use splitstar::polytope::Polytope;

/// The object that `gauss --json` prints.
#[derive(Serialize)]
pub(crate) struct MapReport {
    surface: &'static str,
    pub(crate) vertices: usize,
    pub(crate) edges: usize,
    pub(crate) faces: usize,
    with_splits: Stored,
    primal: Primal,
    pub(crate) seconds: Seconds,
}

/// The numbers of cells as they are stored: on the sphere with what is cut, on the six sides of a cube all of them.
#[derive(Serialize)]
struct Stored {
    vertices: usize,
    edges: usize,
    faces: usize,
}

/// The polytope for which the map stands.
#[derive(Serialize)]
struct Primal {
    dimension: u8,
    vertices: usize,
    edges: usize,
    facets: usize,
}

impl MapReport {
    pub(crate) fn of(map: &StarGaussianMap, polytope: &Polytope) -> Self {
        let (surface, [vertices, edges, faces], stored) = match map {
            StarGaussianMap::Spherical(map) => {
                let (real, stored) = (map.arrangement().counts(), map.counts_with_splits());
                (
                    "sphere",
                    [real.vertices, real.edges, real.faces],
                    [stored.vertices, stored.edges, stored.faces],
                )
            }
            StarGaussianMap::Cubical(map) => {
                let (real, stored) = (map.arrangement().counts(), map.arrangement().counts_with_artificial());
                (
                    "cube",
                    [real.vertices, real.edges, real.faces],
                    [stored.vertices, stored.edges, stored.faces],
                )
            }
            _ => unreachable!("no other map is made"),
        };
        let with_splits = Stored { vertices: stored[0], edges: stored[1], faces: stored[2] };
        let counts = polytope.counts();
        let primal = Primal {
            dimension: polytope.dimension(),
            vertices: counts.vertices,
            edges: counts.edges,
            facets: counts.facets,
        };
        Self { surface, vertices, edges, faces, with_splits, primal, seconds: Seconds::default() }
    }

    /// One line.
    pub(crate) fn json(&self) -> String {
        one_line_of_json(self)
    }

    pub(crate) fn table(&self) -> String {
        let Self { surface, vertices, edges, faces, with_splits, primal, .. } = self;
        let Stored { vertices: v, edges: e, faces: f } = with_splits;
        let split = format!("vertices {v}, edges {e}, faces {f}");
        let Primal { dimension, vertices: v, edges: e, facets: f } = primal;
        let primal = format!("dimension {dimension}, vertices {v}, edges {e}, facets {f}");
        let rows = [
            ("surface", (*surface).to_string()),
            ("vertices", vertices.to_string()),
            ("edges", edges.to_string()),
            ("faces", faces.to_string()),
            ("with splits", split),
            ("polytope", primal),
        ];
        rows.iter().map(|(name, value)| format!("{name:<12}{value}\n")).collect()
    }
}
