//! Pictures of what the other crates compute: one description of a scene, and writers for it.
//!
//! | module | what it has |
//! |---|---|
//! | `frame` | the rectangle of the plane that is shown |
//! | `clip` | segments, rays, lines, polylines and rings cut off at the frame |
//! | `colour`, `style` | colours from a palette without end; fills and strokes |
//! | `scene` | shapes, layers and the scene |
//! | `svg` | the writer of SVG |
//! | `arrangement` | scenes of arrangements: of the plane, of a torus, of a sphere unfolded and as a globe |
//! | `cube` | scenes of maps on the sides of a cube |
//! | `trig` | cosine and sine, the same on every machine |
//!
//! Here, and only here, a point is a pair of doubles: a picture decides nothing. Coordinates are those of the
//! plane, with `y` upwards; sizes of strokes, markers and letters are in units of the screen.
//!
//! The same scene gives the same bytes on every machine: nothing but the four operations and the square root is
//! computed with doubles, and coordinates are written as integers of a small fraction of the screen unit.
//!
//! ```
//! use splitstar_render::{Colour, Item, Layer, Scene, Shape, Style, SvgOptions};
//! let mut faces = Layer::new("faces");
//! let triangle = vec![[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
//! let style = Style::filled("face", Colour::pale(0));
//! faces.push(Item::new(Shape::region(vec![triangle]), style).with_id("f1"))?;
//! let scene = Scene::around(vec![faces]);
//! let svg = scene.to_svg(&SvgOptions::default());
//! assert!(svg.contains(r#"data-id="f1""#));
//! assert_eq!(svg, scene.to_svg(&SvgOptions::default()));
//! # Ok::<(), splitstar_render::RenderError>(())
//! ```

mod arrangement;
mod clip;
mod colour;
mod cube;
mod error;
mod frame;
mod scene;
mod style;
mod svg;
mod trig;

pub use arrangement::GlobeOptions;
pub use clip::{clip_closed_polyline, clip_line, clip_polyline, clip_ray, clip_ring, clip_segment};
pub use colour::{Colour, Tone};
pub use error::RenderError;
pub use frame::{Frame, Point};
pub use scene::{Anchor, FillRule, Item, Layer, LegendEntry, Mark, Scene, Shape, Swatch};
pub use style::{Dash, Paint, Stroke, Style};
pub use svg::SvgOptions;
