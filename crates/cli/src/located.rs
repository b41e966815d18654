//! The answers of `locate`: one a line, or one JSON object.

use crate::report::one_line_of_json;
use serde::Serialize;
use splitstar::arrangement::overlay::Cell;
use splitstar::formats::CellNumbers;
use std::fmt::Write;

/// A cell, by its number in the file of the arrangement.
#[derive(Serialize, Clone, Copy)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Answer {
    /// Without a number, it is the one at infinity.
    Vertex(Option<u32>),
    Edge(u32),
    Face(u32),
}

/// The object that `locate --json` prints.
#[derive(Serialize)]
pub(crate) struct LocateReport {
    pub(crate) strategy: &'static str,
    pub(crate) ray: Option<&'static str>,
    pub(crate) points: usize,
    pub(crate) located: Located,
    pub(crate) answers: Vec<Answer>,
    pub(crate) seconds: LocateSeconds,
}

/// How many answers are cells of each kind.
#[derive(Serialize, Clone, Copy, Default)]
pub(crate) struct Located {
    pub(crate) vertices: usize,
    pub(crate) edges: usize,
    pub(crate) faces: usize,
}

#[derive(Serialize, Clone, Copy, Default)]
pub(crate) struct LocateSeconds {
    pub(crate) read: f64,
    /// What a strategy does before the first point.
    pub(crate) prepare: f64,
    pub(crate) compute: f64,
    pub(crate) write: f64,
}

impl Answer {
    pub(crate) fn of(cell: Cell, numbers: &CellNumbers) -> Self {
        match cell {
            Cell::Vertex(v) => Self::Vertex(numbers.vertex(v)),
            Cell::Edge(e) => Self::Edge(numbers.edge(e)),
            Cell::Face(f) => Self::Face(numbers.face(f)),
        }
    }
}

impl Located {
    pub(crate) fn of(answers: &[Answer]) -> Self {
        let mut located = Self::default();
        for answer in answers {
            *match answer {
                Answer::Vertex(_) => &mut located.vertices,
                Answer::Edge(_) => &mut located.edges,
                Answer::Face(_) => &mut located.faces,
            } += 1;
        }
        located
    }
}

impl LocateReport {
    /// One line.
    pub(crate) fn json(&self) -> String {
        one_line_of_json(self)
    }

    /// One answer a line.
    pub(crate) fn lines(&self) -> String {
        let mut text = String::with_capacity(12 * self.answers.len());
        for answer in &self.answers {
            match answer {
                Answer::Vertex(Some(number)) => writeln!(text, "vertex {number}"),
                Answer::Vertex(None) => writeln!(text, "infinity"),
                Answer::Edge(number) => writeln!(text, "edge {number}"),
                Answer::Face(number) => writeln!(text, "face {number}"),
            }
            .expect("writing to memory does not fail");
        }
        text
    }
}
