//! The primitive changes of an arrangement, and those who watch them.
//!
//! Whatever changes cells that are there goes through one place as a value, an [`Edit`], and is told to an [`Observer`] before and
//! after. So whoever keeps something about the cells (an index, a property map, a copy, what is needed to take changes back)
//! can keep it up to date; and whoever does not notices by a [`Stamp`] that it is out of date.
//!
//! | layer | files | role |
//! |---|---|---|
//! | changes | `primitive`, `apply` | what there is to change, and the one place that does it |
//! | watching | `observer`, `stamp` | who is told; which state something belongs to |
//! | observers | `mirror`, `undo` | a copy kept by what is told alone; what takes changes back |
//! | rules | `turns` | the kinds of CCBs after an edge came or went |

mod apply;
mod mirror;
mod observer;
mod primitive;
mod stamp;
#[cfg(test)]
mod tests;
mod turns;
mod undo;

pub use mirror::{Mirror, MirrorDifference};
pub use observer::{Observer, Operation};
pub use primitive::{Done, Edit, EditOf};
pub use stamp::{Stale, Stamp, Stamped};
pub(crate) use turns::SettledInsertion;
pub use undo::{Recorded, Undo};
