//! Arrangements as text: the kind `arrangement` of the native format.

mod model;

pub use model::{LinearArrangement, PolycurveArrangement, StarArrangement, TorusArrangement};
