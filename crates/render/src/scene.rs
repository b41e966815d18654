//! What a picture shows: shapes in layers.

use crate::error::{RenderError, finite, within};
use crate::frame::{Frame, Point};
use crate::style::Style;

/// A shape, in coordinates of the plane; sizes are in screen units.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum Shape {
    /// What some rings enclose. A ring is closed by itself: its first point is not repeated.
    Region {
        /// Outer rings, holes and islands, in any order.
        rings: Vec<Vec<Point>>,
        /// Which points are inside.
        rule: FillRule,
    },
    /// A chain of segments. One point is drawn as a dot.
    Polyline(Vec<Point>),
    /// A closed chain of segments.
    ClosedPolyline(Vec<Point>),
    /// A point.
    Marker {
        /// Where.
        at: Point,
        /// What it looks like.
        mark: Mark,
        /// From side to side.
        size: f64,
    },
    /// An arrow head.
    Arrow {
        /// Where its tip is.
        tip: Point,
        /// Where it points to; the length does not matter.
        direction: Point,
        /// Its length.
        size: f64,
    },
    /// A line of text. An outline of its style is painted below the letters, as a halo.
    Label {
        /// The point that it belongs to.
        at: Point,
        /// The text; what XML cannot hold is replaced.
        text: String,
        /// Which part of the text is at that point.
        anchor: Anchor,
        /// How far it is moved to the right and up, in screen units.
        offset: [f64; 2],
        /// The size of the letters.
        size: f64,
    },
}

/// Which points are inside of rings.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum FillRule {
    /// Those around which all rings together wind an odd number of times: holes may have any orientation.
    #[default]
    EvenOdd,
    /// Those around which they wind at all.
    NonZero,
}

/// What a point looks like.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[non_exhaustive]
pub enum Mark {
    /// A disc.
    #[default]
    Disc,
    /// A square.
    Square,
    /// A square on its corner.
    Diamond,
    /// Two strokes that cross; it has no inside.
    Cross,
}

/// Which part of a text is at its point.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    #[default]
    Middle,
    /// Its right end.
    End,
}

impl Shape {
    /// What rings enclose, by the even-odd rule.
    pub fn region(rings: Vec<Vec<Point>>) -> Self {
        Self::Region { rings, rule: FillRule::EvenOdd }
    }

    /// A disc.
    pub fn disc(at: Point, size: f64) -> Self {
        Self::Marker { at, mark: Mark::Disc, size }
    }

    /// A text with its middle at a point.
    pub fn label(at: Point, text: impl Into<String>, size: f64) -> Self {
        Self::Label { at, text: text.into(), anchor: Anchor::Middle, offset: [0.0; 2], size }
    }

    /// Calls `visit` with all its points.
    fn for_each_point(&self, mut visit: impl FnMut(Point)) {
        match self {
            Self::Region { rings, .. } => rings.iter().flatten().for_each(|&point| visit(point)),
            Self::Polyline(points) | Self::ClosedPolyline(points) => points.iter().for_each(|&p| visit(p)),
            Self::Marker { at, .. } | Self::Label { at, .. } | Self::Arrow { tip: at, .. } => visit(*at),
        }
    }

    fn check(&self) -> Result<(), RenderError> {
        let mut all_finite = true;
        self.for_each_point(|point| all_finite &= point.iter().all(|c| c.is_finite()));
        if !all_finite {
            return Err(RenderError::NotFinite { what: "a coordinate" });
        }
        let check_size = |size: f64| within("a size", size, [0.0, 10_000.0], "between 0 and 10000");
        match self {
            Self::Region { .. } | Self::Polyline(_) | Self::ClosedPolyline(_) => Ok(()),
            Self::Marker { size, .. } => check_size(*size),
            Self::Arrow { direction, size, .. } => {
                finite("the direction of an arrow", direction)?;
                if direction.iter().all(|&c| c == 0.0) {
                    return Err(RenderError::NoDirection);
                }
                check_size(*size)
            }
            Self::Label { offset, size, .. } => {
                for &c in offset {
                    within("the offset of a label", c, [-10_000.0, 10_000.0], "between -10000 and 10000")?;
                }
                check_size(*size)
            }
        }
    }
}

/// A shape with what is known of it.
#[derive(Clone, PartialEq, Debug)]
pub struct Item {
    /// The shape.
    pub shape: Shape,
    /// How it is painted.
    pub style: Style,
    /// The name by which a viewer finds it: the attribute `data-id`. It need not be unique.
    pub id: Option<String>,
    /// What is shown when it is pointed at.
    pub title: Option<String>,
}

impl Item {
    /// A shape without name and title.
    pub fn new(shape: Shape, style: Style) -> Self {
        Self { shape, style, id: None, title: None }
    }

    /// The same with a name.
    #[must_use]
    pub fn with_id(self, id: impl Into<String>) -> Self {
        Self { id: Some(id.into()), ..self }
    }

    /// The same with a title.
    #[must_use]
    pub fn with_title(self, title: impl Into<String>) -> Self {
        Self { title: Some(title.into()), ..self }
    }
}

/// Items that are painted one after the other, under a name.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Layer {
    name: String,
    items: Vec<Item>,
}

impl Layer {
    /// A layer without items.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), items: Vec::new() }
    }

    /// Its name: the attribute `data-layer`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its items, the lowest first.
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// Puts an item on top.
    ///
    /// # Errors
    /// If a number of it is not finite or makes no sense; the layer is unchanged then.
    ///
    /// ```
    /// use splitstar_render::{Colour, Item, Layer, RenderError, Shape, Style};
    /// let item = Item::new(Shape::disc([0.0, f64::NAN], 5.0), Style::filled("vertex", Colour::INK));
    /// assert_eq!(Layer::new("vertices").push(item), Err(RenderError::NotFinite { what: "a coordinate" }));
    /// ```
    pub fn push(&mut self, item: Item) -> Result<(), RenderError> {
        item.shape.check()?;
        item.style.check()?;
        self.items.push(item);
        Ok(())
    }
}

/// A line of the legend.
#[derive(Clone, PartialEq, Debug)]
pub struct LegendEntry {
    /// What stands before the text.
    pub swatch: Swatch,
    /// How that is painted.
    pub style: Style,
    /// The text.
    pub text: String,
}

/// What stands before the text of a line of the legend.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Swatch {
    /// A rectangle.
    Area,
    /// A stroke.
    Line,
    /// A marker.
    Point(Mark),
}

/// A picture before it is written: a frame and layers.
#[derive(Clone, PartialEq, Debug)]
pub struct Scene {
    frame: Frame,
    title: String,
    layers: Vec<Layer>,
    legend: Vec<LegendEntry>,
    is_collapsed: bool,
}

impl Scene {
    /// An empty scene that shows `frame`. What lies outside is cut off when the scene is written.
    pub fn new(frame: Frame) -> Self {
        Self { frame, title: String::new(), layers: Vec::new(), legend: Vec::new(), is_collapsed: false }
    }

    /// A scene with a frame around all of its layers, with a margin. Without items it shows the unit square.
    pub fn around(layers: Vec<Layer>) -> Self {
        let mut bounds: Option<Frame> = None;
        for item in layers.iter().flat_map(Layer::items) {
            item.shape.for_each_point(|point| {
                let frame = Frame::around([point]);
                bounds = bounds.into_iter().chain(frame).reduce(Frame::union);
            });
        }
        let frame = bounds.map_or(Frame::UNIT, |bounds| bounds.with_margin(0.05));
        Self { layers, ..Self::new(frame) }
    }

    /// What is shown.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// Whether coordinates differ too little for a picture: the scene was made of an arrangement of the plane whose extent is below
    /// 1e-9 of its largest coordinate, or of one on a sphere with faces too narrow, or vertices too near to a pole, for doubles. What is
    /// different may then be drawn in one place, and a face where there is none of it.
    pub fn is_collapsed(&self) -> bool {
        self.is_collapsed
    }

    pub(crate) fn set_collapsed(&mut self, is_collapsed: bool) {
        self.is_collapsed = is_collapsed;
    }

    /// The title of the picture, for those who cannot see it and for tooltips; may be empty.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The layers, the lowest first.
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// The lines of the legend.
    pub fn legend(&self) -> &[LegendEntry] {
        &self.legend
    }

    /// The same scene with a title.
    #[must_use]
    pub fn with_title(self, title: impl Into<String>) -> Self {
        Self { title: title.into(), ..self }
    }

    /// Puts a layer on top.
    pub fn push_layer(&mut self, layer: Layer) {
        self.layers.push(layer);
    }

    /// Appends a line to the legend.
    ///
    /// # Errors
    /// If a number of its style makes no sense.
    pub fn push_legend(&mut self, entry: LegendEntry) -> Result<(), RenderError> {
        entry.style.check()?;
        self.legend.push(entry);
        Ok(())
    }
}
