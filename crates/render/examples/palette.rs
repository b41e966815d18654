//! Prints a picture of the palette: the three tones of the first colours.

#![allow(clippy::print_stdout)]

use splitstar_render::{Colour, Item, Layer, RenderError, Scene, Shape, Stroke, Style, SvgOptions, Tone};

fn main() -> Result<(), RenderError> {
    let mut layer = Layer::new("palette");
    for index in 0..48_u32 {
        for (tone, row) in [(Tone::Pale, 2.0), (Tone::Plain, 1.0), (Tone::Deep, 0.0)] {
            let [x, y] = [f64::from(index % 16), row - 4.0 * f64::from(index / 16)];
            let square = vec![[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]];
            layer.push(Item::new(
                Shape::region(vec![square]),
                Style::filled("", Colour::Palette { index, tone }),
            ))?;
            if tone == Tone::Pale {
                let text = Style::filled("", Colour::INK);
                layer.push(Item::new(Shape::label([x + 0.5, y + 0.65], index.to_string(), 14.0), text))?;
                let line = Style::default().with_stroke(Stroke::new(Colour::deep(index), 2.0));
                layer.push(Item::new(Shape::Polyline(vec![[x + 0.2, y + 0.2], [x + 0.8, y + 0.2]]), line))?;
            }
        }
    }
    print!("{}", Scene::around(vec![layer]).to_svg(&SvgOptions::default()));
    Ok(())
}
