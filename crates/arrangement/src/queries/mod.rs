//! Questions that one sweep answers, without making an arrangement.

mod locate;
mod meetings;

pub use locate::locate_all;
pub use meetings::{CommonEnds, do_any_meet, intersections, subcurves};
