//! Exact computational geometry: the facade.

pub use {dcel, exact, formats, polytope};
