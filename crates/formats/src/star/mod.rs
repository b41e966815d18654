//! The native text format.

use crate::base::budget::Budget;
use crate::base::error::Located;
use crate::base::model::Model;
use crate::base::model::ReadModel;
use crate::complex::Complex;
use crate::write::WriteOptions;
use crate::write::{Body, Task, WriteError};

pub(crate) fn write_complex(
    _complex: &Complex,
    _model: &Model,
    _options: &WriteOptions,
) -> Result<Body, WriteError> {
    unimplemented!()
}

pub(crate) fn read(_bytes: &[u8], _budget: &mut Budget) -> Result<ReadModel, Located> {
    unimplemented!()
}

pub(crate) fn write_mesh(_task: &Task<'_>) -> Result<Body, WriteError> {
    unimplemented!()
}
