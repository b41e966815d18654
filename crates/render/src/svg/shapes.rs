//! Items as elements of SVG.

use super::page::Page;
use super::path::{PathData, push_number};
use super::text::{push_attribute, push_escaped, push_length};
use crate::clip::{clip_closed_polyline, clip_polyline, clip_ring};
use crate::frame::Point;
use crate::scene::{Anchor, FillRule, Item, Mark, Shape};

/// Writes an item with `attributes` besides its own; nothing if nothing of it is in the frame.
pub(super) fn push_item(out: &mut String, item: &Item, attributes: &str, page: &Page) {
    let element = Element { item, attributes, page };
    match &item.shape {
        Shape::Region { rings, rule } => element.region(out, rings, *rule),
        Shape::Polyline(points) => {
            let parts = clip_polyline(&page.frame, points);
            element.path(out, &parts, false, "");
        }
        Shape::ClosedPolyline(points) => {
            let (parts, closed) = clip_closed_polyline(&page.frame, points);
            element.path(out, &parts, closed, "");
        }
        Shape::Marker { at, mark, size } if page.frame.contains(*at) => {
            element.marker(out, page.place(*at), *mark, *size);
        }
        Shape::Arrow { tip, direction, size } if page.frame.contains(*tip) => {
            element.arrow(out, page.place(*tip), *direction, *size);
        }
        Shape::Label { at, text, anchor, offset, size } if page.frame.contains(*at) => {
            element.label(out, page.place(*at), (text, *anchor, *offset, *size));
        }
        Shape::Marker { .. } | Shape::Arrow { .. } | Shape::Label { .. } => {}
    }
}

/// An item being written.
struct Element<'a> {
    item: &'a Item,
    attributes: &'a str,
    page: &'a Page,
}

impl Element<'_> {
    /// What the rings enclose. Cut off at the frame, a ring runs along it, and its outline must not: then fill and
    /// outline are two elements.
    fn region(&self, out: &mut String, rings: &[Vec<Point>], rule: FillRule) {
        let frame = &self.page.frame;
        let rule = if rule == FillRule::NonZero { " fill-rule=\"nonzero\"" } else { "" };
        if self.item.style.stroke.is_none() || rings.iter().flatten().all(|&point| frame.contains(point)) {
            let inside: Vec<Vec<Point>> = rings.iter().map(|ring| clip_ring(frame, ring)).collect();
            self.path(out, &inside, true, rule);
            return;
        }
        let inside: Vec<Vec<Point>> = rings.iter().map(|ring| clip_ring(frame, ring)).collect();
        if inside.iter().all(Vec::is_empty) {
            return;
        }
        self.open(out, "g", "");
        out.push('>');
        self.title(out);
        out.push_str("<path stroke=\"none\"");
        out.push_str(rule);
        self.data(out, &inside, |_| true);
        out.push_str("/><path fill=\"none\"");
        let outlines: Vec<(Vec<Vec<Point>>, bool)> =
            rings.iter().map(|ring| clip_closed_polyline(frame, ring)).collect();
        let is_closed: Vec<bool> =
            outlines.iter().flat_map(|(parts, closed)| parts.iter().map(|_| *closed)).collect();
        let parts: Vec<Vec<Point>> = outlines.into_iter().flat_map(|(parts, _)| parts).collect();
        self.data(out, &parts, |index| is_closed[index]);
        out.push_str("/></g>\n");
    }

    /// Chains of one kind.
    fn path(&self, out: &mut String, parts: &[Vec<Point>], closed: bool, more: &str) {
        if parts.iter().all(Vec::is_empty) {
            return;
        }
        self.open(out, "path", more);
        self.data(out, parts, |_| closed);
        self.close(out, "path");
    }

    fn data(&self, out: &mut String, parts: &[Vec<Point>], is_closed: impl Fn(usize) -> bool) {
        push_attribute(out, "d", |out| {
            let mut data = PathData::new(out, self.page.decimals);
            for (index, part) in parts.iter().enumerate() {
                data.chain(part.iter().map(|&point| self.page.place(point)), is_closed(index));
            }
        });
    }

    fn marker(&self, out: &mut String, at: [i64; 2], mark: Mark, size: f64) {
        if mark == Mark::Disc {
            self.open(out, "circle", "");
            push_circle(out, at, size, self.page.decimals);
            self.close(out, "circle");
            return;
        }
        self.open(out, "path", "");
        push_attribute(out, "d", |out| {
            push_mark(out, at, mark, self.page.to_units(size / 2.0), self.page.decimals)
        });
        self.close(out, "path");
    }

    /// A triangle with its tip at the place, and a notch behind.
    fn arrow(&self, out: &mut String, tip: [i64; 2], direction: Point, size: f64) {
        let greater = direction[0].abs().max(direction[1].abs());
        let [dx, dy] = direction.map(|c| c / greater);
        let length = (dx * dx + dy * dy).sqrt();
        // On the screen, `y` points down.
        let along = [dx / length, -dy / length];
        let corner = |back: f64, side: f64| {
            let moved = [-back * along[0] - side * along[1], -back * along[1] + side * along[0]];
            [0, 1].map(|k| tip[k] + self.page.to_units(moved[k] * size))
        };
        self.open(out, "path", "");
        push_attribute(out, "d", |out| {
            let corners = [tip, corner(1.0, 0.4), corner(0.75, 0.0), corner(1.0, -0.4)];
            PathData::new(out, self.page.decimals).chain(corners, true);
        });
        self.close(out, "path");
    }

    fn label(
        &self,
        out: &mut String,
        at: [i64; 2],
        (text, anchor, offset, size): (&str, Anchor, [f64; 2], f64),
    ) {
        let decimals = self.page.decimals;
        // Half of the height of a capital letter below the middle.
        let moved = [offset[0], 0.36 * size - offset[1]];
        self.open(out, "text", "");
        push_attribute(out, "x", |out| push_number(out, at[0] + self.page.to_units(moved[0]), decimals));
        push_attribute(out, "y", |out| push_number(out, at[1] + self.page.to_units(moved[1]), decimals));
        push_length(out, "font-size", size, decimals.max(2));
        match anchor {
            Anchor::Start => {}
            Anchor::Middle => out.push_str(" text-anchor=\"middle\""),
            Anchor::End => out.push_str(" text-anchor=\"end\""),
        }
        out.push('>');
        self.title(out);
        push_escaped(out, text);
        out.push_str("</text>\n");
    }

    /// The begin of a tag, up to the attributes of the shape.
    fn open(&self, out: &mut String, tag: &str, more: &str) {
        out.push('<');
        out.push_str(tag);
        out.push_str(self.attributes);
        out.push_str(more);
        if let Some(id) = &self.item.id {
            push_attribute(out, "data-id", |out| push_escaped(out, id));
        }
    }

    /// The end of a tag that holds nothing but perhaps a title.
    fn close(&self, out: &mut String, tag: &str) {
        if self.item.title.is_none() {
            out.push_str("/>\n");
            return;
        }
        out.push('>');
        self.title(out);
        out.push_str("</");
        out.push_str(tag);
        out.push_str(">\n");
    }

    fn title(&self, out: &mut String) {
        if let Some(title) = &self.item.title {
            out.push_str("<title>");
            push_escaped(out, title);
            out.push_str("</title>");
        }
    }
}

/// The attributes of a disc.
pub(super) fn push_circle(out: &mut String, at: [i64; 2], size: f64, decimals: u32) {
    push_attribute(out, "cx", |out| push_number(out, at[0], decimals));
    push_attribute(out, "cy", |out| push_number(out, at[1], decimals));
    push_length(out, "r", size / 2.0, decimals.max(2));
}

/// The path of a marker that is no disc, `half` of its size to each side.
pub(super) fn push_mark(out: &mut String, [x, y]: [i64; 2], mark: Mark, half: i64, decimals: u32) {
    let mut data = PathData::new(out, decimals);
    match mark {
        Mark::Disc | Mark::Square => {
            // A square looks as large as a disc when it is smaller.
            let half = half * 7 / 8;
            data.chain(
                [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]],
                true,
            );
        }
        Mark::Diamond => data.chain([[x, y - half], [x + half, y], [x, y + half], [x - half, y]], true),
        Mark::Cross => {
            data.chain([[x - half, y - half], [x + half, y + half]], false);
            data.chain([[x - half, y + half], [x + half, y - half]], false);
        }
    }
}
