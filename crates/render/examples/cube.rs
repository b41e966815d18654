//! Prints the picture of a cube that `tests/golden` holds.

#![allow(clippy::print_stdout)]

use splitstar_render::{RenderError, Scene, SvgOptions};

#[path = "../tests/geodesics/mod.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod geodesics;

fn main() -> Result<(), RenderError> {
    let scene = Scene::of_cube(&geodesics::on_cube(&geodesics::sample_curves()))?;
    print!("{}", scene.to_svg(&SvgOptions::default()));
    Ok(())
}
