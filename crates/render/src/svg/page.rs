//! Where the frame lies on the screen.

use super::SvgOptions;
use super::legend::{self, Row};
use crate::frame::{Frame, Point};
use crate::scene::LegendEntry;

/// The page: its size in screen units, and the map from the plane to it.
#[derive(Debug)]
pub(super) struct Page {
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) decimals: u32,
    /// What is cut off at.
    pub(super) frame: Frame,
    /// The frame on the screen: left, top, right, bottom.
    drawn: [f64; 4],
    /// What the greater of width and height, in relation to the room for it, stands for: half of it in the plane.
    half_plane: f64,
    /// And half of it on the screen.
    half_screen: f64,
    /// Rows of the legend, and where they begin.
    pub(super) rows: Vec<Row>,
    pub(super) legend_top: f64,
    pub(super) margin: f64,
}

impl Page {
    pub(super) fn new(frame: &Frame, options: &SvgOptions, entries: &[LegendEntry]) -> Self {
        let frame = frame.thickened();
        let [half_width, half_height] = frame.half_extent();
        let width = options.width;
        let margin = options.margin.min(width / 4.0).min(options.height.unwrap_or(width) / 4.0);
        let room_width = width - 2.0 * margin;
        let mut rows = legend::rows(entries, room_width);
        let legend_height =
            |rows: &[Row]| if rows.is_empty() { 0.0 } else { rows.len() as f64 * legend::ROW + margin };
        let height = options.height.unwrap_or_else(|| {
            // A frame without width has an infinite ratio, which is cut like any other.
            let ratio = (half_height / half_width).clamp(0.1, 10.0);
            room_width * ratio + 2.0 * margin + legend_height(&rows)
        });
        if options.height.is_some() {
            // The legend takes no more than half of a fixed height.
            let fit = ((height / 2.0 - 2.0 * margin) / legend::ROW).max(0.0).floor();
            rows.truncate(fit as usize);
        }
        let legend_top = height - legend_height(&rows);
        let room_height = legend_top - 2.0 * margin;
        let is_wide = half_width / room_width >= half_height / room_height;
        let (half_plane, half_screen) =
            if is_wide { (half_width, room_width / 2.0) } else { (half_height, room_height / 2.0) };
        let middle = [width / 2.0, margin + room_height / 2.0];
        let half = [half_width, half_height].map(|c| c / half_plane * half_screen);
        let drawn = [middle[0] - half[0], middle[1] - half[1], middle[0] + half[0], middle[1] + half[1]];
        Self {
            width,
            height,
            decimals: options.decimals,
            frame,
            drawn,
            half_plane,
            half_screen,
            rows,
            legend_top,
            margin,
        }
    }

    /// A point of the frame on the screen, in screen units.
    fn screen(&self, point: Point) -> Point {
        let middle = self.frame.middle();
        let moved =
            [0, 1].map(|k| (point[k] / 2.0 - middle[k] / 2.0) / self.half_plane * 2.0 * self.half_screen);
        let [left, top, right, bottom] = self.drawn;
        [
            ((left + right) / 2.0 + moved[0]).clamp(left, right),
            ((top + bottom) / 2.0 - moved[1]).clamp(top, bottom),
        ]
    }

    /// A point of the frame in units of the writer.
    pub(super) fn place(&self, point: Point) -> [i64; 2] {
        self.screen(point).map(|c| self.to_units(c))
    }

    /// A length on the screen in units of the writer.
    pub(super) fn to_units(&self, length: f64) -> i64 {
        to_units(length, self.decimals)
    }
}

/// A length on the screen as a number of units of the last decimal. Lengths are below 10^6 and decimals at most 6, so
/// it is exact but for the rounding.
pub(super) fn to_units(length: f64, decimals: u32) -> i64 {
    (length * 10_u32.pow(decimals) as f64).round() as i64
}
