//! Questions that one sweep answers, without making an arrangement.
//!
//! | file | role |
//! |---|---|
//! | `locate` | in which cells of an arrangement points lie |
//! | `meetings` | where curves meet, and whether they do |
//! | `subcurves` | the pieces into which curves cut each other |
//! | `owners` | pieces of curves that know whose they are, and which curves run together |

mod locate;
mod meetings;
mod owners;
mod subcurves;

pub use locate::{locate_by_sweep, locate_by_sweep_with};
pub use meetings::{CommonEnds, do_any_meet, intersections};
pub use subcurves::subcurves;
