//! The facts about a mesh or a result: one JSON object, or a readable table.

use crate::failure::one_line;
use serde::Serialize;
use splitstar::exact::{Point3, Rational};
use splitstar::formats::{Complex, Format, Loss, Model, Unit};
use splitstar::polytope::{Bounds, MeshSummary, PolygonMesh, Polytope};
use std::fmt::Write;
use std::time::{Duration, Instant};

/// The object that `--json` prints. Exact numbers are strings.
#[derive(Serialize)]
pub(crate) struct Report {
    vertices: usize,
    edges: usize,
    facets: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    filed: Option<Filed>,
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    file: Option<FileFacts>,
    #[serde(skip_serializing_if = "Option::is_none")]
    complex: Option<CellFacts>,
    dimension: Option<u8>,
    convex: bool,
    closed: bool,
    components: usize,
    genus: Vec<Option<u32>>,
    volume: Option<String>,
    bounds: Option<Corners>,
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    made: Option<Made>,
}

/// The numbers as they stand in the file.
#[derive(Serialize)]
struct Filed {
    vertices: usize,
    facets: usize,
}

/// What a file says beside its cells.
#[derive(Serialize)]
struct FileFacts {
    format: &'static str,
    unit: Option<&'static str>,
    objects: Vec<String>,
}

/// What only a complex of cells has.
#[derive(Serialize)]
struct CellFacts {
    directions: usize,
    holes: usize,
    volumes: usize,
    bounded: bool,
    unmarked: Unmarked,
}

#[derive(Serialize)]
struct Unmarked {
    vertices: usize,
    edges: usize,
    facets: usize,
    volumes: usize,
}

#[derive(Serialize)]
struct Corners {
    min: [String; 3],
    max: [String; 3],
}

/// What only results have.
#[derive(Serialize)]
pub(crate) struct Made {
    pub(crate) method: &'static str,
    pub(crate) width_bits: u32,
    /// The largest rounding of what was written.
    pub(crate) rounding: String,
    /// The quaternion of a rotation: w, x, y, z.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) quaternion: Option<[String; 4]>,
    pub(crate) seconds: Seconds,
}

#[derive(Serialize, Clone, Copy, Default)]
pub(crate) struct Seconds {
    pub(crate) read: f64,
    pub(crate) compute: f64,
    pub(crate) write: f64,
}

impl Report {
    pub(crate) fn of_summary(summary: &MeshSummary) -> Self {
        Self {
            vertices: summary.vertices,
            edges: summary.edges,
            facets: summary.facets,
            filed: None,
            file: None,
            complex: None,
            dimension: summary.dimension,
            convex: summary.convex,
            closed: summary.closed,
            components: summary.components,
            genus: summary.genus.clone(),
            volume: summary.volume.as_ref().map(Rational::to_string),
            bounds: summary.bounds.as_ref().map(Corners::of),
            made: None,
        }
    }

    pub(crate) fn of_mesh(mesh: &PolygonMesh) -> Self {
        Self::of_summary(&MeshSummary::of(mesh))
    }

    /// The cells are those of the complex; what is said of surfaces and volume is that of its regular part.
    pub(crate) fn of_complex(complex: &Complex) -> Self {
        let regular = MeshSummary::of(&complex.regular_part().unwrap_or_default());
        let facts = complex.summary();
        let unmarked = Unmarked {
            vertices: facts.unmarked.vertices,
            edges: facts.unmarked.edges,
            facets: facts.unmarked.facets,
            volumes: facts.unmarked.volumes,
        };
        let points: Vec<Point3> = complex.points().cloned().collect();
        Self {
            vertices: facts.vertices,
            edges: facts.edges,
            facets: facts.facets,
            complex: Some(CellFacts {
                directions: facts.directions,
                holes: facts.holes,
                volumes: facts.volumes,
                bounded: facts.bounded,
                unmarked,
            }),
            dimension: facts.dimension,
            // Pieces of lower dimension, and what is missing of the boundary, are not in the regular part.
            convex: regular.convex && is_regular(complex),
            bounds: Bounds::of(&points).filter(|_| facts.bounded).as_ref().map(Corners::of),
            ..Self::of_summary(&regular)
        }
    }

    /// What a polytope is needs no search.
    pub(crate) fn of_polytope(polytope: &Polytope) -> Self {
        let counts = polytope.counts();
        Self {
            vertices: counts.vertices,
            edges: counts.edges,
            facets: counts.facets,
            filed: None,
            file: None,
            complex: None,
            dimension: Some(polytope.dimension()),
            convex: true,
            closed: true,
            components: 1,
            genus: vec![Some(0)],
            volume: Some(polytope.volume().to_string()),
            bounds: Some(Corners::of(&polytope.bounds())),
            made: None,
        }
    }

    pub(crate) fn filed(self, vertices: usize, facets: usize) -> Self {
        Self { filed: Some(Filed { vertices, facets }), ..self }
    }

    /// The file that was read, or written.
    pub(crate) fn file(self, format: Format, model: &Model) -> Self {
        let objects = model.objects.iter().map(|object| object.name.clone()).collect();
        let file = FileFacts { format: format.name(), unit: model.unit.map(Unit::name), objects };
        Self { file: Some(file), ..self }
    }

    pub(crate) fn made(self, made: Made) -> Self {
        Self { made: Some(made), ..self }
    }

    /// One line.
    pub(crate) fn json(&self) -> String {
        one_line_of_json(self)
    }

    pub(crate) fn table(&self) -> String {
        let mut text = String::new();
        let mut row = |name: &str, value: &dyn std::fmt::Display| {
            writeln!(text, "{name:<12}{value}").expect("writing to memory does not fail");
        };
        if let Some(file) = &self.file {
            row("format", &file.format);
            if let Some(unit) = file.unit {
                row("unit", &unit);
            }
            if !file.objects.is_empty() {
                let names: Vec<String> = file.objects.iter().map(|name| one_line(name)).collect();
                row("objects", &format_args!("{}: {}", names.len(), names.join(", ")));
            }
        }
        let filed = |count: Option<usize>| count.map_or(String::new(), |n| format!(" (filed {n})"));
        let vertices = filed(self.filed.as_ref().map(|f| f.vertices).filter(|&n| n != self.vertices));
        let facets = filed(self.filed.as_ref().map(|f| f.facets).filter(|&n| n != self.facets));
        row("vertices", &format_args!("{}{vertices}", self.vertices));
        row("edges", &self.edges);
        row("facets", &format_args!("{}{facets}", self.facets));
        if let Some(CellFacts { directions, holes, volumes, bounded, unmarked }) = &self.complex {
            row("directions", directions);
            row("holes", holes);
            row("volumes", volumes);
            row("bounded", &yes(*bounded));
            let Unmarked { vertices, edges, facets, volumes } = unmarked;
            row(
                "unmarked",
                &format_args!("vertices {vertices}, edges {edges}, facets {facets}, volumes {volumes}"),
            );
        }
        row("dimension", &self.dimension.map_or("none".to_string(), |d| d.to_string()));
        row("convex", &yes(self.convex));
        row("closed", &yes(self.closed));
        row("components", &self.components);
        let genus = |g: &Option<u32>| g.map_or("none".to_string(), |g| g.to_string());
        row("genus", &self.genus.iter().map(genus).collect::<Vec<_>>().join(", "));
        row("volume", &self.volume.as_deref().unwrap_or("none"));
        if let Some(bounds) = &self.bounds {
            row("minimum", &bounds.min.join(" "));
            row("maximum", &bounds.max.join(" "));
        }
        text.lines().map(|line| format!("{}\n", line.trim_end())).collect()
    }
}

/// An object as a line.
pub(crate) fn one_line_of_json(object: &impl Serialize) -> String {
    let mut text = serde_json::to_string(object).expect("strings, numbers and lists make an object");
    text.push('\n');
    text
}

fn yes(fact: bool) -> &'static str {
    if fact { "yes" } else { "no" }
}

impl Corners {
    fn of(bounds: &Bounds) -> Self {
        let shown = |corner: &[Rational; 3]| corner.each_ref().map(Rational::to_string);
        Self { min: shown(&bounds.min), max: shown(&bounds.max) }
    }
}

/// Whether a set is its regular part.
fn is_regular(complex: &Complex) -> bool {
    let losses = complex.as_mesh().err().unwrap_or_default();
    losses.iter().all(|loss| matches!(loss, Loss::Holes(_) | Loss::Volumes(_)))
}

/// The widest integer, in bits, among the coordinates and weights of points.
pub(crate) fn width_bits(points: &[&Point3]) -> u32 {
    points.iter().map(|point| point.bits()).max().unwrap_or(0)
}

/// Measures one phase after the other.
pub(crate) struct Clock(Instant);

impl Clock {
    pub(crate) fn start() -> Self {
        Self(Instant::now())
    }

    /// The seconds since the last call, or since the start.
    pub(crate) fn lap(&mut self) -> f64 {
        let now = Instant::now();
        let lap: Duration = now - self.0;
        self.0 = now;
        lap.as_secs_f64()
    }
}
