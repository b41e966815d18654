//! A small picture with something of everything.

use super::render::{
    Anchor, Colour, Dash, Frame, Item, Layer, LegendEntry, Mark, Point, RenderError, Scene, Shape, Stroke,
    Style, Swatch, clip_line,
};

/// Two components, one with a hole, a line cut off at the frame, and every kind of marker.
pub(crate) fn scene() -> Result<Scene, RenderError> {
    let frame = Frame::new([-1.0, -1.0], [13.0, 8.0])?;
    let outer: Vec<Point> = vec![[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]];
    let hole: Vec<Point> = vec![[2.0, 2.0], [2.0, 4.0], [4.0, 4.0], [4.0, 2.0]];
    let triangle: Vec<Point> = vec![[7.0, 1.0], [15.0, 1.0], [9.5, 6.0]];

    let mut faces = Layer::new("faces");
    let region = |rings, index| Item::new(Shape::region(rings), Style::filled("face", Colour::pale(index)));
    faces
        .push(region(vec![outer.clone(), hole.clone()], 0).with_id("f1").with_title("face 1, with a hole"))?;
    faces.push(region(vec![triangle.clone()], 1).with_id("f2").with_title("face 2 <cut off>"))?;

    let mut edges = Layer::new("edges");
    let edge = Style::stroked("edge", Colour::INK, 1.5);
    edges.push(Item::new(Shape::ClosedPolyline(outer.clone()), edge.clone()).with_id("e1"))?;
    edges.push(Item::new(Shape::ClosedPolyline(hole), edge.clone()).with_id("e2"))?;
    edges.push(Item::new(Shape::ClosedPolyline(triangle), edge).with_id("e3"))?;
    let [a, b] = clip_line(&frame, [0.0, 7.0], [3.0, -1.0]).expect("the line meets the frame");
    let line = Stroke::new(Colour::deep(2), 2.0).with_dash(Dash::Dashed);
    let line = Style { class: "line".into(), fill: None, stroke: Some(line) };
    edges.push(Item::new(Shape::Polyline(vec![a, b]), line.clone()))?;
    let arrow = Shape::Arrow { tip: b, direction: [3.0, -1.0], size: 12.0 };
    edges.push(Item::new(arrow, Style::filled("arrow", Colour::deep(2))))?;

    let mut vertices = Layer::new("vertices");
    let vertex = Style::filled("vertex", Colour::INK).with_stroke(Stroke::new(Colour::WHITE, 1.0));
    for (index, &at) in outer.iter().enumerate() {
        vertices.push(Item::new(Shape::disc(at, 7.0), vertex.clone()).with_id(format!("v{index}")))?;
    }
    for (index, mark) in (3..).zip([Mark::Disc, Mark::Square, Mark::Diamond, Mark::Cross]) {
        let style = Style::filled("isolated", Colour::plain(index))
            .with_stroke(Stroke::new(Colour::deep(index), 1.5).with_opacity(0.8));
        let at = [7.0 + f64::from(index), 7.0];
        vertices.push(Item::new(Shape::Marker { at, mark, size: 12.0 }, style))?;
    }

    let mut labels = Layer::new("labels");
    let text = Style::filled("label", Colour::INK).with_stroke(Stroke::new(Colour::WHITE, 3.0));
    labels.push(Item::new(Shape::label([3.0, 5.0], "f1 & hole", 16.0), text.clone()))?;
    let start = Shape::Label {
        at: [6.0, 6.0],
        text: "v2".into(),
        anchor: Anchor::Start,
        offset: [6.0, 8.0],
        size: 14.0,
    };
    labels.push(Item::new(start, text))?;

    let mut scene = Scene::new(frame).with_title("A sample");
    [faces, edges, vertices, labels].into_iter().for_each(|layer| scene.push_layer(layer));
    let entries = [
        (Swatch::Area, Style::filled("face", Colour::pale(0)), "component 0"),
        (Swatch::Area, Style::filled("face", Colour::pale(1)), "component 1"),
        (Swatch::Line, line, "a line"),
        (Swatch::Point(Mark::Disc), vertex, "vertex"),
        (Swatch::Point(Mark::Diamond), Style::filled("isolated", Colour::plain(5)), "isolated vertex"),
    ];
    for (swatch, style, text) in entries {
        scene.push_legend(LegendEntry { swatch, style, text: text.to_owned() })?;
    }
    Ok(scene)
}
