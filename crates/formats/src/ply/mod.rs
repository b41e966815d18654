//! PLY.

use crate::base::budget::Budget;
use crate::base::error::Located;
use crate::base::model::ReadModel;
use crate::format::Format;
use crate::write::{Body, Task, WriteError};

pub(crate) fn write(_task: &Task<'_>, _format: Format) -> Result<Body, WriteError> {
    unimplemented!()
}

pub(crate) fn read(_bytes: &[u8], _budget: &mut Budget) -> Result<ReadModel, Located> {
    unimplemented!()
}
