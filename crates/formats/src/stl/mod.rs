//! STL: triangles, binary or as text.

use crate::base::budget::Budget;
use crate::base::error::Located;
use crate::base::model::ReadModel;
use crate::write::{Body, Task, WriteError};

/// Whether a file is binary STL.
pub(crate) fn is_binary(_start: &[u8], _length: usize) -> bool {
    false
}

pub(crate) fn read_binary(_bytes: &[u8], _budget: &mut Budget) -> Result<ReadModel, Located> {
    unimplemented!()
}

pub(crate) fn read_ascii(_bytes: &[u8], _budget: &mut Budget) -> Result<ReadModel, Located> {
    unimplemented!()
}

pub(crate) fn write_binary(_task: &Task<'_>) -> Result<Body, WriteError> {
    unimplemented!()
}

pub(crate) fn write_ascii(_task: &Task<'_>) -> Result<Body, WriteError> {
    unimplemented!()
}
