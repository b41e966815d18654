//! Gaussian maps as arrangements, on the sphere and on the cube: polytopes, their reflections and their Minkowski sums.

mod cubical;

pub use crate::cubical::{CubicalGaussianMap, CubicalGaussianViolation};
