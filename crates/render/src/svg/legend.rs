//! The legend: rows below the picture, filled from left to right.

use std::ops::Range;

use super::page::Page;
use super::path::{PathData, push_number};
use super::shapes::{push_circle, push_mark};
use super::text::{push_attribute, push_escaped, push_style};
use crate::scene::{LegendEntry, Mark, Swatch};

/// The height of a row.
pub(super) const ROW: f64 = 18.0;
/// The size of letters.
const LETTERS: f64 = 12.0;
/// The width of what stands before a text, and the gaps after it and after the text.
const SWATCH: f64 = 20.0;
const GAP: f64 = 6.0;
const SPACE: f64 = 18.0;

/// The entries of a row, with the places where they begin, from the left margin.
#[derive(Debug)]
pub(super) struct Row {
    entries: Range<usize>,
    starts: Vec<f64>,
}

/// About how wide an entry is. Nothing is known of the fonts: letters of other scripts than ours count as squares.
fn width_of(entry: &LegendEntry) -> f64 {
    let letters: f64 = entry.text.chars().map(|c| if c.is_ascii() { 0.56 } else { 1.0 }).sum();
    SWATCH + GAP + letters * LETTERS
}

/// Divides the entries into rows of that width. A row has at least one.
pub(super) fn rows(entries: &[LegendEntry], width: f64) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    let mut at = 0.0;
    for (index, entry) in entries.iter().enumerate() {
        let needed = width_of(entry);
        match rows.last_mut() {
            Some(row) if at + needed <= width => {
                row.starts.push(at);
                row.entries.end = index + 1;
            }
            _ => {
                at = 0.0;
                rows.push(Row { entries: index..index + 1, starts: vec![0.0] });
            }
        }
        at += needed + SPACE;
    }
    rows
}

/// Writes the rows that the page has.
pub(super) fn push_legend(out: &mut String, entries: &[LegendEntry], page: &Page) {
    if page.rows.is_empty() {
        return;
    }
    out.push_str("<g class=\"legend\">\n");
    for (index, row) in page.rows.iter().enumerate() {
        let middle = page.to_units(page.legend_top + (index as f64 + 0.5) * ROW);
        for (entry, start) in entries[row.entries.clone()].iter().zip(&row.starts) {
            push_entry(out, entry, [page.to_units(page.margin + start), middle], page);
        }
    }
    out.push_str("</g>\n");
}

fn push_entry(out: &mut String, entry: &LegendEntry, [left, middle]: [i64; 2], page: &Page) {
    let decimals = page.decimals;
    let (width, half) = (page.to_units(SWATCH), page.to_units(LETTERS / 2.0));
    let centre = [left + width / 2, middle];
    let is_disc = entry.swatch == Swatch::Point(Mark::Disc);
    out.push_str(if is_disc { "<circle" } else { "<path" });
    push_style(out, &entry.style, decimals);
    match entry.swatch {
        Swatch::Point(Mark::Disc) => push_circle(out, centre, 8.0, decimals),
        Swatch::Point(mark) => {
            push_attribute(out, "d", |out| push_mark(out, centre, mark, page.to_units(4.0), decimals));
        }
        Swatch::Line => push_attribute(out, "d", |out| {
            PathData::new(out, decimals).chain([[left, middle], [left + width, middle]], false);
        }),
        Swatch::Area => push_attribute(out, "d", |out| {
            let corners =
                [[left, middle - half], [left + width, middle - half], [left + width, middle + half]];
            PathData::new(out, decimals).chain(corners.into_iter().chain([[left, middle + half]]), true);
        }),
    }
    out.push_str("/>\n<text");
    push_attribute(out, "x", |out| push_number(out, left + page.to_units(SWATCH + GAP), decimals));
    push_attribute(out, "y", |out| push_number(out, middle + page.to_units(0.36 * LETTERS), decimals));
    push_attribute(out, "font-size", |out| out.push_str("12"));
    push_attribute(out, "fill", |out| out.push_str(&crate::colour::Colour::INK.to_hex()));
    out.push('>');
    push_escaped(out, &entry.text);
    out.push_str("</text>\n");
}
