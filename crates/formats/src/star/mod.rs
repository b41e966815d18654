//! The native text format: cells of all dimensions with marks, one record a line. `docs/star.md` specifies it.
//!
//! | file | role |
//! |---|---|
//! | `line` | lines, words and quoted names |
//! | `read` | the grammar of records |
//! | `cells` | what they say: a mesh if that is all, else a complex |
//! | `write` | the one text of a model |

mod arrangement;
mod cells;
mod line;
mod read;
mod write;

pub use arrangement::{LinearArrangement, PolycurveArrangement, StarArrangement, TorusArrangement};
pub(crate) use read::read;
pub(crate) use write::{write_complex, write_mesh};
