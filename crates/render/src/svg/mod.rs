//! The writer of SVG.
//!
//! | module | role |
//! |---|---|
//! | `page` | where the frame lies on the screen |
//! | `path` | numbers and path data |
//! | `text` | escapes and attributes of styles |
//! | `shapes` | items as elements |
//! | `legend` | the rows below the picture |
//!
//! 1. The page is divided: margins, rows of the legend, and between them the frame, as large as it fits.
//! 2. Layers become groups. In them, items of one style in a row share a group with its attributes.
//! 3. Every item is cut off at the frame. What is left is turned into integers, the number of fractions of a screen
//!    unit, and all that follows is integer: so relative commands do not accumulate errors.
//!
//! There is no script, and one rule of style, which keeps the width of strokes when the picture is scaled.

mod legend;
mod page;
mod path;
mod shapes;
mod text;

use crate::colour::Colour;
use crate::error::{RenderError, within};
use crate::scene::{Layer, Scene};
use page::Page;
use path::push_number;
use shapes::push_item;
use text::{push_attribute, push_escaped, push_style};

/// How a scene is written as SVG.
///
/// ```
/// use splitstar_render::{Frame, Scene, SvgOptions};
/// let options = SvgOptions::new(400.0)?.with_height(300.0)?.with_background(None);
/// let svg = Scene::new(Frame::UNIT).to_svg(&options);
/// assert!(svg.contains(r#"width="400" height="300" viewBox="0 0 400 300""#));
/// # Ok::<(), splitstar_render::RenderError>(())
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct SvgOptions {
    width: f64,
    height: Option<f64>,
    margin: f64,
    background: Option<Colour>,
    legend: bool,
    decimals: u32,
}

impl Default for SvgOptions {
    /// 800 units wide, as high as the frame needs, a margin of 12 units, on white, with a legend.
    fn default() -> Self {
        Self {
            width: 800.0,
            height: None,
            margin: 12.0,
            background: Some(Colour::WHITE),
            legend: true,
            decimals: 3,
        }
    }
}

impl SvgOptions {
    /// The default with another width, in screen units, margins included.
    ///
    /// # Errors
    /// If it is not between 1 and 100,000.
    pub fn new(width: f64) -> Result<Self, RenderError> {
        within("the width", width, [1.0, 1e5], "between 1 and 100000")?;
        Ok(Self { width, ..Self::default() })
    }

    /// The same with a fixed height: the frame is fitted into it, in the middle. Without, the height follows from
    /// the frame, but is at least a tenth and at most ten times the width.
    ///
    /// # Errors
    /// If it is not between 1 and 100,000.
    pub fn with_height(self, height: f64) -> Result<Self, RenderError> {
        within("the height", height, [1.0, 1e5], "between 1 and 100000")?;
        Ok(Self { height: Some(height), ..self })
    }

    /// The same with another margin around the frame. It is never more than a quarter of width or height.
    ///
    /// # Errors
    /// If it is not between 0 and 100,000.
    pub fn with_margin(self, margin: f64) -> Result<Self, RenderError> {
        within("the margin", margin, [0.0, 1e5], "between 0 and 100000")?;
        Ok(Self { margin, ..self })
    }

    /// The same on another background, or none.
    #[must_use]
    pub fn with_background(self, background: Option<Colour>) -> Self {
        Self { background, ..self }
    }

    /// The same with or without the legend.
    #[must_use]
    pub fn with_legend(self, legend: bool) -> Self {
        Self { legend, ..self }
    }

    /// The same with coordinates to so many decimals of a screen unit, at most 6. The default 3 stands magnifying a
    /// thousand times.
    #[must_use]
    pub fn with_decimals(self, decimals: u32) -> Self {
        Self { decimals: decimals.min(6), ..self }
    }
}

impl Scene {
    /// The scene as an SVG document.
    ///
    /// Guarantees: well-formed XML; the same bytes on every machine; every coordinate of a region, polyline and
    /// marker lies in the frame. Items of which nothing is in the frame are left out.
    ///
    /// # Complexity
    /// Linear in the number of points and letters.
    pub fn to_svg(&self, options: &SvgOptions) -> String {
        let legend = if options.legend { self.legend() } else { &[] };
        let page = Page::new(self.frame(), options, legend);
        let mut out = String::new();
        push_head(&mut out, self, options, &page);
        for layer in self.layers() {
            push_layer(&mut out, layer, &page);
        }
        legend::push_legend(&mut out, legend, &page);
        out.push_str("</g>\n</svg>\n");
        out
    }
}

fn push_head(out: &mut String, scene: &Scene, options: &SvgOptions, page: &Page) {
    let (width, height) = (page.to_units(page.width), page.to_units(page.height));
    out.push_str("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"splitstar\"");
    push_attribute(out, "width", |out| push_number(out, width, page.decimals));
    push_attribute(out, "height", |out| push_number(out, height, page.decimals));
    out.push_str(" viewBox=\"0 0 ");
    push_number(out, width, page.decimals);
    out.push(' ');
    push_number(out, height, page.decimals);
    out.push_str("\">\n");
    if !scene.title().is_empty() {
        out.push_str("<title>");
        push_escaped(out, scene.title());
        out.push_str("</title>\n");
    }
    out.push_str("<style>.splitstar path{vector-effect:non-scaling-stroke}</style>\n");
    if let Some(colour) = options.background {
        out.push_str("<rect class=\"background\"");
        push_attribute(out, "width", |out| push_number(out, width, page.decimals));
        push_attribute(out, "height", |out| push_number(out, height, page.decimals));
        push_attribute(out, "fill", |out| out.push_str(&colour.to_hex()));
        out.push_str("/>\n");
    }
    out.push_str(
        "<g fill=\"none\" fill-rule=\"evenodd\" stroke-linejoin=\"round\" stroke-linecap=\"round\" \
         paint-order=\"stroke\" font-family=\"Helvetica,Arial,sans-serif\">\n",
    );
}

/// A layer: items of one style that follow each other share a group, unless it would hold one element only.
fn push_layer(out: &mut String, layer: &Layer, page: &Page) {
    out.push_str("<g");
    push_attribute(out, "data-layer", |out| push_escaped(out, layer.name()));
    out.push_str(">\n");
    for run in layer.items().chunk_by(|a, b| a.style == b.style) {
        let mut attributes = String::new();
        push_style(&mut attributes, &run[0].style, page.decimals);
        if let [item] = run {
            push_item(out, item, &attributes, page);
            continue;
        }
        let before = out.len();
        out.push_str("<g");
        out.push_str(&attributes);
        out.push_str(">\n");
        let start = out.len();
        run.iter().for_each(|item| push_item(out, item, "", page));
        if out.len() == start {
            out.truncate(before);
        } else {
            out.push_str("</g>\n");
        }
    }
    out.push_str("</g>\n");
}
