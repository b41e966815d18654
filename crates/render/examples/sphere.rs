//! Prints the pictures of a sphere that `tests/golden` holds: `globe` or `unfolded`.

#![allow(clippy::print_stdout)]

use splitstar_render::{GlobeOptions, RenderError, Scene, SvgOptions};

#[path = "../tests/geodesics/mod.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod geodesics;

fn main() -> Result<(), RenderError> {
    let arrangement = geodesics::sample();
    let scene = if std::env::args().nth(1).as_deref() == Some("unfolded") {
        Scene::of_arrangement(&arrangement, None)?
    } else {
        Scene::of_globe(&arrangement, &GlobeOptions::default())?
    };
    print!("{}", scene.to_svg(&SvgOptions::default()));
    Ok(())
}
