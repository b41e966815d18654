//! Floats along pieces of lines, for pictures.

use super::Straight;
use crate::traits::CurveEnd;
use exact::Rational;
use exact::planar::{Line2, Point2};
use std::borrow::Borrow;

/// Appends both ends of the part of a curve between two points; an end at infinity is put where the line leaves the window.
///
/// Nothing is appended if an unbounded part does not reach the window.
pub(in crate::models) fn approx_curve(
    curve: &impl Straight,
    ends: [Option<&Point2>; 2],
    window: [f64; 4],
    out: &mut Vec<[f64; 2]>,
) {
    let [min, max] = CurveEnd::BOTH.map(|end| ends[end as usize].or(curve.end(end)).map(Point2::approx_f64));
    if let (Some(min), Some(max)) = (min, max) {
        out.extend([min, max]);
        return;
    }
    let Some([enters, leaves]) = chord(curve.line().borrow(), window) else {
        return;
    };
    // Lexicographic, as the ends are.
    let is_less = |p: [f64; 2], q: [f64; 2]| p[0] < q[0] || (p[0] <= q[0] && p[1] < q[1]);
    let reaches = min.is_none_or(|min| is_less(min, leaves)) && max.is_none_or(|max| is_less(enters, max));
    if reaches {
        out.extend([min.unwrap_or(enters), max.unwrap_or(leaves)]);
    }
}

/// The first and the last point of a line in a window.
fn chord(line: &Line2, [left, bottom, right, top]: [f64; 4]) -> Option<[[f64; 2]; 2]> {
    let [a, b, c] = line.coefficients();
    let quotient = |p, q| Rational::new(p, q).map(|quotient| quotient.approx_f64());
    if line.is_vertical() {
        let x = quotient(c, a)?;
        return (left <= x && x <= right).then_some([[x, bottom], [x, top]]);
    }
    let (slope, height) = (quotient(-a, b.clone())?, quotient(c, b)?);
    let at = |x: f64| slope.mul_add(x, height);
    let [mut first, mut last] = [left, right].map(|x| [x, at(x)]);
    for (value, is_top) in [(bottom, false), (top, true)] {
        let is_out = |y: f64| if is_top { y > value } else { y < value };
        let clipped = [(value - height) / slope, value];
        match (is_out(first[1]), is_out(last[1])) {
            (true, true) => return None,
            (true, false) => first = clipped,
            (false, true) => last = clipped,
            (false, false) => {}
        }
    }
    [first, last].iter().flatten().all(|value| value.is_finite()).then_some([first, last])
}
