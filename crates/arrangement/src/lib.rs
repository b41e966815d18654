//! Arrangements of curves on surfaces.

mod arrangement;
mod insert;
pub mod models;
pub mod overlay;
mod queries;
pub mod sweep;
pub mod topology;
pub mod traits;
pub mod wrappers;

pub use arrangement::{
    Arrangement, CellOrder, Counts, CurveId, Difference, Parts, UserEdgeId, UserView, Violation,
};
pub use insert::Pieces;
pub use queries::{CommonEnds, do_any_meet, intersections, locate_all, subcurves};
