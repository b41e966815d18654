//! Prints the picture that `tests/golden/sample.svg` holds.

#![allow(clippy::print_stdout)]

use splitstar_render as render;

#[path = "../tests/sample/mod.rs"]
mod sample;

fn main() -> Result<(), render::RenderError> {
    print!("{}", sample::scene()?.to_svg(&render::SvgOptions::default()));
    Ok(())
}
