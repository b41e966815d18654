//! Wavefront OBJ.

use crate::base::budget::Budget;
use crate::base::error::Located;
use crate::base::model::ReadModel;
use crate::write::{Body, Task, WriteError};

pub(crate) fn read(_bytes: &[u8], _budget: &mut Budget) -> Result<ReadModel, Located> {
    unimplemented!()
}

pub(crate) fn write(_task: &Task<'_>) -> Result<Body, WriteError> {
    unimplemented!()
}
