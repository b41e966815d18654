//! OFF: vertices, then facets by the indices of their vertices.

mod read;
mod write;

pub(crate) use read::read;
pub(crate) use write::write;
