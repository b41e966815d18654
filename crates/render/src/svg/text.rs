//! Escapes, and the attributes of a style.

use super::page::to_units;
use super::path::push_number;
use crate::style::{Dash, Paint, Style};

/// Text for content and for attributes. What XML cannot hold at all becomes U+FFFD.
pub(super) fn push_escaped(out: &mut String, text: &str) {
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' => out.push_str("&#9;"),
            '\n' => out.push_str("&#10;"),
            '\r' => out.push_str("&#13;"),
            '\0'..'\u{20}' | '\u{FFFE}' | '\u{FFFF}' => out.push('\u{FFFD}'),
            _ => out.push(c),
        }
    }
}

/// An attribute with a space before it.
pub(super) fn push_attribute(out: &mut String, name: &str, value: impl FnOnce(&mut String)) {
    out.push(' ');
    out.push_str(name);
    out.push_str("=\"");
    value(out);
    out.push('"');
}

/// An attribute that is a length in screen units.
pub(super) fn push_length(out: &mut String, name: &str, length: f64, decimals: u32) {
    push_attribute(out, name, |out| push_number(out, to_units(length, decimals), decimals));
}

/// The attributes of a style. What is not painted is inherited from the outermost group, where it is `none`.
pub(super) fn push_style(out: &mut String, style: &Style, decimals: u32) {
    if !style.class.is_empty() {
        push_attribute(out, "class", |out| push_escaped(out, &style.class));
    }
    if let Some(paint) = &style.fill {
        push_paint(out, ["fill", "fill-opacity"], paint);
    }
    let Some(stroke) = &style.stroke else { return };
    push_paint(out, ["stroke", "stroke-opacity"], &stroke.paint);
    push_length(out, "stroke-width", stroke.width, decimals.max(2));
    let pattern: &[f64] = match stroke.dash {
        Dash::Solid => &[],
        Dash::Dashed => &[4.0, 3.0],
        Dash::Dotted => &[0.0, 2.5],
    };
    if !pattern.is_empty() {
        push_attribute(out, "stroke-dasharray", |out| {
            for (index, &length) in pattern.iter().enumerate() {
                if index > 0 {
                    out.push(' ');
                }
                let decimals = decimals.max(2);
                push_number(out, to_units(length * stroke.width, decimals), decimals);
            }
        });
    }
}

fn push_paint(out: &mut String, [colour, opacity]: [&str; 2], paint: &Paint) {
    push_attribute(out, colour, |out| out.push_str(&paint.colour.to_hex()));
    if paint.opacity < 1.0 {
        push_length(out, opacity, paint.opacity, 3);
    }
}
