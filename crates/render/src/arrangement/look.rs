//! How cells are painted in every picture of an arrangement.

use crate::colour::Colour;
use crate::style::{Dash, Stroke, Style};

/// Above this many vertices markers and strokes are thin.
const MANY: usize = 2_000;

/// The sizes of what is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Look {
    /// Of the stroke of an edge.
    width: f64,
    /// Of the marker of a vertex.
    pub(crate) size: f64,
}

impl Look {
    pub(crate) fn new(vertex_count: usize) -> Self {
        let (width, size) = if vertex_count > MANY { (0.5, 1.5) } else { (1.25, 5.0) };
        Self { width, size }
    }

    pub(crate) fn edge(self) -> Style {
        Style::stroked("edge", Colour::INK, self.width)
    }

    pub(crate) fn vertex(self, is_isolated: bool) -> Style {
        if is_isolated {
            Style::filled("vertex isolated", Colour::WHITE)
                .with_stroke(Stroke::new(Colour::INK, self.size / 4.0))
        } else {
            Style::filled("vertex", Colour::INK).with_stroke(Stroke::new(Colour::WHITE, self.size / 6.0))
        }
    }

    /// A vertex that is a side of the parameter space.
    pub(super) fn pole(self, is_isolated: bool) -> Style {
        let stroke = Stroke::new(Colour::INK, self.size / 1.5);
        if is_isolated {
            Style { class: "vertex isolated".into(), ..Style::default() }
                .with_stroke(stroke.with_dash(Dash::Dotted))
        } else {
            Style { class: "vertex".into(), ..Style::default() }.with_stroke(stroke)
        }
    }
}
