//! What can be wrong with a scene.

use std::fmt;

/// Why a shape, a frame or the options of a picture were refused.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum RenderError {
    /// A number is infinite or not a number. Leave the shape out, or clip it first.
    NotFinite {
        /// Which number.
        what: &'static str,
    },
    /// A number is finite and lies outside what makes sense for it.
    OutOfRange {
        /// Which number.
        what: &'static str,
        /// What is allowed, in words.
        allowed: &'static str,
    },
    /// The least corner of a frame is not below the greatest one.
    FrameTurnedOver,
    /// An arrow has the direction zero.
    NoDirection,
    /// The view of a globe, or the place of its identification, has the direction zero.
    NoView,
    /// A globe was asked for, and the surface is not a sphere with the poles below and above.
    NotASphere,
}

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { what } => write!(f, "{what} is infinite or not a number"),
            Self::OutOfRange { what, allowed } => write!(f, "{what} must be {allowed}"),
            Self::FrameTurnedOver => {
                write!(f, "the least corner of the frame is greater than the greatest one")
            }
            Self::NoDirection => write!(f, "an arrow needs a direction other than zero"),
            Self::NoView => write!(f, "a globe needs directions other than zero"),
            Self::NotASphere => write!(f, "a globe needs an arrangement on a sphere"),
        }
    }
}

impl std::error::Error for RenderError {}

/// Refuses infinities and NaN.
pub(crate) fn finite(what: &'static str, values: &[f64]) -> Result<(), RenderError> {
    if values.iter().all(|value| value.is_finite()) { Ok(()) } else { Err(RenderError::NotFinite { what }) }
}

/// Refuses what is not within `[low, high]`.
pub(crate) fn within(
    what: &'static str,
    value: f64,
    [low, high]: [f64; 2],
    allowed: &'static str,
) -> Result<(), RenderError> {
    finite(what, &[value])?;
    if (low..=high).contains(&value) { Ok(()) } else { Err(RenderError::OutOfRange { what, allowed }) }
}
