//! The native text format, one record a line: cells of all dimensions with marks (kind `complex`), and arrangements of curves on
//! surfaces (kind `arrangement`). `docs/star.md` specifies it.
//!
//! | file | role |
//! |---|---|
//! | `line` | lines, words and quoted names |
//! | `first` | the first line: version and kind |
//! | `arrangement` | the kind `arrangement` |
//! | `read` | the grammar of records of a complex |
//! | `cells` | what they say: a mesh if that is all, else a complex |
//! | `write` | the one text of a model |

mod arrangement;
mod cells;
mod first;
mod line;
mod read;
mod write;

pub use arrangement::{
    CellNumbers, LinearArrangement, PolycurveArrangement, SphereArrangement, SpherePolycurveArrangement,
    StarArrangement, StarText, TorusArrangement, TorusPolycurveArrangement, read_arrangement,
    read_numbered_arrangement, write_arrangement,
};
pub(crate) use first::is_arrangement;
pub(crate) use read::read;
pub(crate) use write::{write_complex, write_mesh};
