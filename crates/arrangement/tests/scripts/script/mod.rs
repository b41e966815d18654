//! Scripts of edits: bytes say what is done to an arrangement, and everything is checked after each step.
//!
//! The first bytes choose a family of curves and the grid of coordinates; then every step takes [`STEP`] bytes, so that a step can be
//! dropped without a change of the others.
//!
//! The crate that has this module has `family` and `swept_again` of `tests/common` at its root.

mod check;
mod draw;
mod drawn;
mod globe;
mod globe_scan;
mod rays;
mod scan;
mod steps;
mod straight;

use crate::family::{Linears, MinimalSegments, Numbered, Polylinears, Polylines, Segments};
use draw::Draw;
use drawn::Drawn;
use globe::{Globe, GlobeChains};
pub(crate) use steps::Log;
use steps::World;
use straight::{Torus, TorusPolylines};

/// The number of bytes before the first step.
pub(crate) const HEADER: usize = 4;

/// The number of bytes of a step.
pub(crate) const STEP: usize = 16;

/// The number of families.
pub(crate) const FAMILIES: u8 = 10;

/// Runs the script that bytes describe, and has written down what it does.
///
/// # Panics
/// If anything is not as it should be.
pub(crate) fn run(bytes: &[u8], log: Log<'_>) {
    let Some((header, steps)) = bytes.split_at_checked(HEADER) else { return };
    // Coordinates from a small grid, so that everything degenerate happens.
    let size = 2 + u64::from(header[1] % 5);
    let denominator = 1 + i64::from(header[1] >= 192);
    let period = [[1, 1], [2, 3], [4, 3], [4, 4]][usize::from(header[1] % 4)];
    let identification = [[-1, 0], [0, 1], [1, 1], [-2, 1]][usize::from(header[1] % 4)];
    let draw = |step| Draw::new(step, size, denominator);
    let takes_all_back = header[2] % 2 == 0;
    let steps = || steps.chunks_exact(STEP).map(draw);
    match header[0] % FAMILIES {
        0 => play(Segments, steps(), takes_all_back, log),
        1 => play(Linears, steps(), takes_all_back, log),
        2 => play(Torus::new(period), steps(), takes_all_back, log),
        3 => play(Numbered, steps(), takes_all_back, log),
        4 => play(Polylinears, steps(), takes_all_back, log),
        5 => play(TorusPolylines::new(period), steps(), takes_all_back, log),
        6 => play(MinimalSegments, steps(), takes_all_back, log),
        7 => play(Polylines, steps(), takes_all_back, log),
        8 => play(Globe::new(identification), steps(), takes_all_back, log),
        _ => play(GlobeChains::new(identification), steps(), takes_all_back, log),
    }
}

fn play<'a, F: Drawn>(family: F, steps: impl Iterator<Item = Draw<'a>>, takes_all_back: bool, log: Log<'_>) {
    log(format!("{family:?}"));
    let mut world = World::new(family);
    for mut step in steps {
        world.step(&mut step, log);
        world.check(&mut step);
    }
    if takes_all_back {
        log("take all back".into());
        world.take_all_back();
    }
}
