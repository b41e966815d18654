//! The native text format: cells of all dimensions with marks, one record a line. `docs/star.md` specifies it.
//!
//! | file | role |
//! |---|---|
//! | `line` | lines, words and quoted names |
//! | `read` | records to a complex, and to a mesh if it says no more |
//! | `write` | the one text of a model |

mod line;
mod read;
mod write;

pub(crate) use read::read;
pub(crate) use write::{write_complex, write_mesh};
