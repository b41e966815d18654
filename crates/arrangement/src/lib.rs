//! Arrangements of curves on surfaces.

mod arrangement;
mod insert;
pub mod sweep;
pub mod topology;
pub mod traits;

pub use arrangement::{Arrangement, Counts, CurveId, Violation};
pub use insert::Pieces;
