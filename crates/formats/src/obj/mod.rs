//! Wavefront OBJ: statements of a line each, vertices and the facets between them.

mod corner;
mod read;
mod statement;
mod write;

pub(crate) use read::read;
pub(crate) use write::{takes_name, write};
