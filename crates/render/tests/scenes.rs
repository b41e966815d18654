//! Whole pictures: golden bytes, and what every picture promises.

use splitstar_render as render;

mod sample;

use quick_xml::events::{BytesStart, Event};
use render::{
    Anchor, Colour, Dash, FillRule, Frame, Item, Layer, LegendEntry, Mark, Point, RenderError, Scene, Shape,
    Stroke, Style, SvgOptions, Swatch,
};

/// The tags and texts of a document; fails if it is not well-formed.
fn elements(svg: &str) -> (Vec<BytesStart<'static>>, Vec<String>) {
    let mut reader = quick_xml::Reader::from_str(svg);
    let (mut tags, mut texts) = (Vec::new(), Vec::new());
    loop {
        match reader.read_event().expect("well-formed") {
            Event::Start(tag) | Event::Empty(tag) => {
                assert!(tag.attributes().all(|attribute| attribute.is_ok()), "{tag:?}");
                tags.push(tag.into_owned());
            }
            Event::Text(text) => texts.push((*text).to_owned()),
            Event::Eof => return (tags, texts),
            _ => {}
        }
    }
}

fn attribute(tag: &BytesStart<'_>, name: &str) -> Option<String> {
    let found = tag.attributes().flatten().find(|attribute| attribute.key.as_ref() == name)?;
    Some(found.value.into_owned())
}

fn tags_of(svg: &str, name: &str) -> Vec<BytesStart<'static>> {
    elements(svg).0.into_iter().filter(|tag| tag.name().as_ref() == name).collect()
}

/// The points of path data as we write it, followed by relative steps.
fn points_of(data: &str) -> Vec<Point> {
    let mut text = String::new();
    for c in data.chars() {
        match c {
            'M' | 'l' | 'h' | 'v' | 'z' => text.extend([' ', c, ' ']),
            '-' => text.extend([' ', c]),
            _ => text.push(c),
        }
    }
    let (mut points, mut at, mut command) = (Vec::new(), [0.0, 0.0], ' ');
    let mut words = text.split_whitespace().peekable();
    while let Some(word) = words.peek() {
        if word.chars().all(char::is_alphabetic) {
            command = word.chars().next().expect("a letter");
            words.next();
            if command == 'z' {
                continue;
            }
        }
        let mut number = || words.next().expect("a number").parse::<f64>().expect("a number");
        match command {
            'M' => at = [number(), number()],
            'l' => at = [at[0] + number(), at[1] + number()],
            'h' => at[0] += number(),
            'v' => at[1] += number(),
            other => panic!("command {other}"),
        }
        points.push(at);
    }
    points
}

/// Every point of a path or disc.
fn drawn_points(svg: &str) -> Vec<Point> {
    let mut points = Vec::new();
    for tag in elements(svg).0 {
        if let Some(data) = attribute(&tag, "d") {
            points.extend(points_of(&data));
        }
        if let (Some(x), Some(y)) = (attribute(&tag, "cx"), attribute(&tag, "cy")) {
            points.push([x, y].map(|c| c.parse().expect("a number")));
        }
    }
    points
}

fn number(svg: &str, name: &str) -> f64 {
    attribute(&tags_of(svg, "svg")[0], name).expect("there").parse().expect("a number")
}

/// A deterministic sequence of numbers in [-1, 1].
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn point(&mut self, size: f64) -> Point {
        [self.next() * size, self.next() * size]
    }
}

#[test]
fn the_sample_is_the_golden_one() {
    let svg = sample::scene().unwrap().to_svg(&SvgOptions::default());
    assert_eq!(svg, include_str!("golden/sample.svg"));
}

#[test]
fn the_sample_keeps_names_titles_and_texts() {
    let svg = sample::scene().unwrap().to_svg(&SvgOptions::default());
    let (tags, texts) = elements(&svg);
    let ids: Vec<String> = tags.iter().filter_map(|tag| attribute(tag, "data-id")).collect();
    assert_eq!(ids, ["f1", "f2", "e1", "e2", "e3", "v0", "v1", "v2", "v3"]);
    let layers: Vec<String> = tags.iter().filter_map(|tag| attribute(tag, "data-layer")).collect();
    assert_eq!(layers, ["faces", "edges", "vertices", "labels"]);
    assert!(svg.contains("face 2 &lt;cut off&gt;") && svg.contains("f1 &amp; hole"));
    assert!(texts.iter().any(|text| text == "component 1"));
    assert!(!svg.contains("script"));
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    let write = || sample::scene().unwrap().to_svg(&SvgOptions::new(333.0).unwrap().with_decimals(4));
    assert_eq!(write(), write());
}

#[test]
fn an_empty_scene_is_a_document() {
    for scene in [Scene::new(Frame::UNIT), Scene::around(Vec::new()), Scene::around(vec![Layer::new("none")])]
    {
        let svg = scene.to_svg(&SvgOptions::default());
        elements(&svg);
        assert!(drawn_points(&svg).is_empty());
        assert_eq!([number(&svg, "width"), number(&svg, "height")].map(|c| c as i64), [800, 800]);
    }
}

/// The shapes of `points`, one of each kind that has points.
fn shapes(points: &[Point], noise: &mut Noise) -> Vec<Shape> {
    let at = points[0];
    vec![
        Shape::region(vec![points.to_vec(), points.iter().rev().copied().collect()]),
        Shape::Region { rings: vec![points.to_vec()], rule: FillRule::NonZero },
        Shape::Polyline(points.to_vec()),
        Shape::ClosedPolyline(points.to_vec()),
        Shape::disc(at, 5.0),
        Shape::Arrow { tip: at, direction: noise.point(1e-9), size: 0.0 },
        Shape::Marker { at, mark: Mark::Square, size: 0.0 },
        Shape::Label {
            at,
            text: "<\u{1}&\"]]>".into(),
            anchor: Anchor::End,
            offset: [3.0, -3.0],
            size: 10.0,
        },
    ]
}

#[test]
fn coordinates_stay_in_the_page_at_every_magnitude() {
    let mut noise = Noise(7);
    let style = Style::filled("a b", Colour::pale(3))
        .with_stroke(Stroke::new(Colour::INK, 1.0).with_dash(Dash::Dotted));
    let sizes = [5e-324, 1e-310, 1e-300, 1e-17, 1e-3, 1.0, 12345.678, 1e16, 1e153, 1e160, 1e300, f64::MAX];
    for (frame_size, size) in sizes.iter().flat_map(|&a| sizes.iter().map(move |&b| (a, b))) {
        for degenerate in [[1.0, 1.0], [0.0, 1.0], [1.0, 0.0], [0.0, 0.0]] {
            let mut layer = Layer::new("all");
            for count in [1, 2, 3, 17] {
                let points: Vec<Point> = (0..count).map(|_| noise.point(size)).collect();
                for shape in shapes(&points, &mut noise) {
                    layer.push(Item::new(shape, style.clone()).with_title("t")).unwrap();
                }
            }
            let half = degenerate.map(|c| c * frame_size);
            let framed = Frame::new(half.map(|c| -c), half).unwrap();
            let mut scene = Scene::new(framed);
            scene.push_layer(layer.clone());
            for scene in [scene, Scene::around(vec![layer])] {
                let svg = scene.to_svg(&SvgOptions::new(300.0).unwrap().with_legend(false));
                let (width, height) = (number(&svg, "width"), number(&svg, "height"));
                for [x, y] in drawn_points(&svg) {
                    assert!(
                        (11.99..=width - 11.99).contains(&x) && (11.99..=height - 11.99).contains(&y),
                        "frame {frame_size} {degenerate:?} size {size}: {x} {y} of {width} {height}"
                    );
                }
            }
        }
    }
}

#[test]
fn what_is_not_finite_is_refused() {
    let style = || Style::stroked("", Colour::INK, 1.0);
    let mut layer = Layer::new("bad");
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let points = vec![[0.0, 0.0], [bad, 1.0]];
        for shape in [
            Shape::region(vec![vec![], points.clone()]),
            Shape::Polyline(points.clone()),
            Shape::ClosedPolyline(points),
            Shape::disc([0.0, bad], 1.0),
            Shape::disc([0.0, 0.0], bad),
            Shape::label([bad, 0.0], "", 1.0),
            Shape::Arrow { tip: [0.0; 2], direction: [1.0, bad], size: 1.0 },
        ] {
            let refused = layer.push(Item::new(shape, style()));
            assert!(matches!(refused, Err(RenderError::NotFinite { .. })), "{refused:?}");
        }
        let stroke = Style::stroked("", Colour::INK, bad);
        assert!(layer.push(Item::new(Shape::disc([0.0; 2], 1.0), stroke)).is_err());
        assert!(SvgOptions::new(bad).is_err() && SvgOptions::default().with_height(bad).is_err());
        assert!(SvgOptions::default().with_margin(bad).is_err());
    }
    let still = Shape::Arrow { tip: [0.0; 2], direction: [0.0, -0.0], size: 1.0 };
    assert_eq!(layer.push(Item::new(still, style())), Err(RenderError::NoDirection));
    let large = layer.push(Item::new(Shape::disc([0.0; 2], -1.0), style()));
    assert!(matches!(large, Err(RenderError::OutOfRange { .. })));
    let opaque = Style::filled("", Colour::INK).with_fill_opacity(1.5);
    assert!(layer.push(Item::new(Shape::disc([0.0; 2], 1.0), opaque)).is_err());
    assert!(layer.items().is_empty());
}

#[test]
fn a_cut_region_has_no_outline_along_the_frame() {
    let mut layer = Layer::new("faces");
    let style = Style::filled("face", Colour::pale(0)).with_stroke(Stroke::new(Colour::INK, 1.0));
    let wide = vec![[-10.0, 0.25], [10.0, 0.25], [10.0, 0.75], [-10.0, 0.75]];
    layer.push(Item::new(Shape::region(vec![wide]), style).with_id("f")).unwrap();
    let mut scene = Scene::new(Frame::UNIT);
    scene.push_layer(layer);
    let svg = scene.to_svg(&SvgOptions::new(100.0).unwrap().with_margin(0.0).unwrap());
    let paths: Vec<String> = tags_of(&svg, "path").iter().filter_map(|tag| attribute(tag, "d")).collect();
    assert_eq!(paths, ["M0 75h100v-50h-100z", "M0 75h100M100 25h-100"]);
}

#[test]
fn small_pages_with_long_legends_are_drawn() {
    let mut scene = sample::scene().unwrap();
    for index in 0..200 {
        let style = Style::filled("", Colour::plain(index));
        let text = format!("entry {index} \u{4e2d}");
        scene.push_legend(LegendEntry { swatch: Swatch::Point(Mark::Cross), style, text }).unwrap();
    }
    for width in [1.0, 10.0, 50.0, 1e5] {
        for height in [None, Some(1.0), Some(30.0), Some(100.0), Some(1e5)] {
            let options = SvgOptions::new(width).unwrap();
            let options = height.map_or(Ok(options.clone()), |height| options.with_height(height)).unwrap();
            for margin in [0.0, 12.0, 1e5] {
                let svg = scene.to_svg(&options.clone().with_margin(margin).unwrap());
                elements(&svg);
                assert!(height.is_none_or(|height| (number(&svg, "height") - height).abs() < 1e-9));
            }
        }
    }
}

#[test]
fn many_items_take_few_bytes() {
    let mut noise = Noise(11);
    let (mut edges, mut vertices) = (Layer::new("edges"), Layer::new("vertices"));
    for index in 0..100_000 {
        let [a, b] = [noise.point(1000.0), noise.point(10.0)];
        let segment = Shape::Polyline(vec![a, [a[0] + b[0], a[1] + b[1]]]);
        let style = Style::stroked("edge", Colour::INK, 0.5);
        edges.push(Item::new(segment, style).with_id(format!("e{index}"))).unwrap();
        vertices.push(Item::new(Shape::disc(a, 1.0), Style::filled("vertex", Colour::INK))).unwrap();
    }
    let scene = Scene::around(vec![edges, vertices]);
    let svg = scene.to_svg(&SvgOptions::default());
    assert_eq!((tags_of(&svg, "path").len(), tags_of(&svg, "circle").len()), (100_000, 100_000));
    assert!(svg.len() < 100_000 * (60 + 45), "{} bytes", svg.len());
}
