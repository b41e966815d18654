//! How shapes are painted.

use std::borrow::Cow;

use crate::colour::Colour;
use crate::error::{RenderError, within};

/// How a shape is painted: what is `None` is not painted.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Style {
    /// Classes for style sheets and viewers, separated by spaces; may be empty.
    pub class: Cow<'static, str>,
    /// The inside.
    pub fill: Option<Paint>,
    /// The outline.
    pub stroke: Option<Stroke>,
}

/// A colour, more or less transparent.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Paint {
    /// The colour.
    pub colour: Colour,
    /// From 0, invisible, to 1.
    pub opacity: f64,
}

/// An outline.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stroke {
    /// Its colour.
    pub paint: Paint,
    /// In screen units, whatever the scale of the picture.
    pub width: f64,
    /// Its gaps.
    pub dash: Dash,
}

/// The gaps of an outline.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[non_exhaustive]
pub enum Dash {
    /// None.
    #[default]
    Solid,
    /// Dashes of four widths.
    Dashed,
    /// Dots.
    Dotted,
}

impl From<Colour> for Paint {
    /// The colour, opaque.
    fn from(colour: Colour) -> Self {
        Self { colour, opacity: 1.0 }
    }
}

impl Stroke {
    /// A solid, opaque outline.
    pub fn new(colour: Colour, width: f64) -> Self {
        Self { paint: colour.into(), width, dash: Dash::Solid }
    }

    /// The same with other gaps.
    #[must_use]
    pub fn with_dash(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    /// The same with another opacity.
    #[must_use]
    pub fn with_opacity(self, opacity: f64) -> Self {
        Self { paint: Paint { opacity, ..self.paint }, ..self }
    }
}

impl Style {
    /// An inside without outline.
    pub fn filled(class: impl Into<Cow<'static, str>>, colour: Colour) -> Self {
        Self { class: class.into(), fill: Some(colour.into()), stroke: None }
    }

    /// An outline without inside.
    pub fn stroked(class: impl Into<Cow<'static, str>>, colour: Colour, width: f64) -> Self {
        Self { class: class.into(), fill: None, stroke: Some(Stroke::new(colour, width)) }
    }

    /// The same with another outline.
    #[must_use]
    pub fn with_stroke(self, stroke: Stroke) -> Self {
        Self { stroke: Some(stroke), ..self }
    }

    /// The same with an inside of another opacity.
    #[must_use]
    pub fn with_fill_opacity(self, opacity: f64) -> Self {
        Self { fill: self.fill.map(|paint| Paint { opacity, ..paint }), ..self }
    }

    pub(crate) fn check(&self) -> Result<(), RenderError> {
        let paints = self.fill.iter().chain(self.stroke.as_ref().map(|stroke| &stroke.paint));
        for paint in paints {
            within("an opacity", paint.opacity, [0.0, 1.0], "between 0 and 1")?;
        }
        match self.stroke {
            Some(stroke) => within("a stroke width", stroke.width, [0.0, 1000.0], "between 0 and 1000"),
            None => Ok(()),
        }
    }
}
