//! glTF 2, binary: written only.

use crate::write::{Body, Task, WriteError};

pub(crate) fn write(_task: &Task<'_>) -> Result<Body, WriteError> {
    unimplemented!()
}
