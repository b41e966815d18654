//! Arrangements of curves on surfaces.
pub mod models;
pub mod sweep;
pub mod topology;
pub mod traits;
pub mod wrappers;
