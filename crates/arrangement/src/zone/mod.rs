//! The zone of a curve: the cells that it meets, in their order along it.

mod walk;

pub(crate) use walk::{Hit, Walk};
