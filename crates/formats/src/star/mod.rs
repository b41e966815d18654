//! The native text format, one record a line: cells of all dimensions with marks (kind `complex`), arrangements of curves on
//! surfaces (kind `arrangement`), and Gaussian maps (kind `gaussian`). `docs/star.md` specifies it.
//!
//! | file | role |
//! |---|---|
//! | `line` | lines, words and quoted names |
//! | `first` | the first line: version and kind |
//! | `door` | the way to the text of a kind that has a door of its own |
//! | `arrangement` | the kind `arrangement` |
//! | `gaussian` | the kind `gaussian` |
//! | `read` | the grammar of records of a complex |
//! | `cells` | what they say: a mesh if that is all, else a complex |
//! | `write` | the one text of a model |

mod arrangement;
mod cells;
mod door;
mod first;
mod gaussian;
mod line;
mod read;
mod write;

pub use arrangement::{
    CellNumbers, LinearArrangement, PolycurveArrangement, SphereArrangement, SpherePolycurveArrangement,
    StarArrangement, StarText, TorusArrangement, TorusPolycurveArrangement, read_arrangement,
    read_numbered_arrangement, write_arrangement,
};
pub(crate) use first::is_arrangement;
pub use gaussian::{StarGaussianMap, read_gaussian_map, write_gaussian_map};
pub(crate) use read::read;
pub(crate) use write::{write_complex, write_mesh};
