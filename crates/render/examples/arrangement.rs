//! Prints the picture that `tests/golden/arrangement.svg` holds.

#![allow(clippy::print_stdout)]

use splitstar_render::{RenderError, Scene, SvgOptions};

#[path = "../tests/model/mod.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod model;

fn main() -> Result<(), RenderError> {
    print!("{}", Scene::of_arrangement(&model::sample(), None)?.to_svg(&SvgOptions::default()));
    Ok(())
}
