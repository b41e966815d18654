//! Readers and writers of meshes with exact coordinates.
//!
//! A decimal in a file is the rational number that is written there, not the nearest float: `0.1` is
//! one tenth. Integers, decimals, exponents and fractions `p/q` may be mixed. Nothing is rounded on
//! the way in; on the way out only if [`Coordinates::Float`] is asked for, and then the largest
//! rounding is reported.
//!
//! | layer | file | role |
//! |---|---|---|
//! | text | `scan.rs` | tokens, comments and line numbers of a byte slice |
//! | numbers | `number.rs` | a token to an exact number, three numbers to a point |
//! | reading | `read_off.rs`, `error.rs` | the grammar of OFF, and what can be wrong with a file |
//! | writing | `write_off.rs` | exact text, or floats on request |
//!
//! The crate takes and gives bytes; it opens no file.
//!
//! ```
//! use splitstar_formats::{Kind, WriteOptions, read_off, write_off};
//!
//! let text = b"OFF # a triangle\n3 1 3\n0 0 0\n0.5 0 0\n0 1/3 0\n3 0 1 2\n";
//! let read = read_off(text)?;
//! assert_eq!(read.kind(), Kind::Polygon);
//! let (written, _) = write_off(&read.mesh, &WriteOptions::default())?;
//! assert_eq!(written, b"OFF\n3 1 3\n0 0 0\n1/2 0 0\n0 1/3 0\n3 0 1 2\n");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod number;
mod read_off;
mod scan;
mod write_off;

pub use error::{Count, NumberFault, ReadError, Record};
pub use read_off::{Kind, ReadMesh, read_off};
pub use write_off::{Coordinates, WriteError, WriteOptions, WriteReport, write_off};
