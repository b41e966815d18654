//! The sides of a cube, unfolded: a row of four around the axis z, and one above and one below the second of these.
//!
//! Each side has coordinates u and v of its own, counterclockwise seen from outside, and is turned by quarters of a circle until it
//! fits to its neighbours.

use cubical::CubeSide;

use crate::frame::Point;
use crate::scene::Anchor;

/// What is shown, with room for labels.
pub(super) const FRAME: [Point; 2] = [[-3.15, -3.35], [5.15, 3.35]];

/// The middle of each side, and the quarter turns, counterclockwise, that it is turned by: in the order of the sides,
/// x, y, z = -1 and then 1.
///
/// To the right in the row of four is east, and z is up.
const SIDES: [(Point, u8); 6] =
    [([4.0, 0.0], 1), ([-2.0, 0.0], 0), ([0.0, -2.0], 0), ([0.0, 0.0], 0), ([2.0, 0.0], 1), ([0.0, 2.0], 3)];

/// Where the point with these coordinates on a side is drawn.
pub(super) fn place(side: CubeSide, [u, v]: Point) -> Point {
    let ([x, y], turns) = SIDES[side.index()];
    let [right, up] = match turns {
        0 => [u, v],
        1 => [-v, u],
        _ => [v, -u],
    };
    [x + right, y + up]
}

/// Where the name of a side stands: beside it, outside of the cross.
pub(super) fn label(side: CubeSide) -> (Point, [f64; 2], Anchor) {
    let ([x, y], _) = SIDES[side.index()];
    match (side.axis(), side.is_positive()) {
        // Above and below the cross.
        (2, true) => ([x, y + 1.0], [0.0, 10.0], Anchor::Middle),
        (2, false) => ([x, y - 1.0], [0.0, -16.0], Anchor::Middle),
        // In the middle there is room nowhere but in the corner between two others.
        (0, true) => ([x - 1.0, y + 1.0], [-8.0, 10.0], Anchor::End),
        _ => ([x, y - 1.0], [0.0, -16.0], Anchor::Middle),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where a direction is drawn, on a side on which it lies.
    fn drawn(side: CubeSide, direction: [f64; 3]) -> Point {
        place(side, side.axes().map(|axis| direction[axis]))
    }

    /// Edges between sides that are next to one another in the cross are drawn once.
    #[test]
    fn neighbours_fit() {
        let [west, south, down, front, east, up] = CubeSide::ALL;
        let rows = [(south, front), (front, east), (east, west), (front, up), (front, down)];
        for (a, b) in rows {
            let mut direction = [0.5; 3];
            for side in [a, b] {
                direction[side.axis()] = if side.is_positive() { 1.0 } else { -1.0 };
            }
            let [p, q] = [a, b].map(|side| drawn(side, direction));
            assert!((p[0] - q[0]).abs() + (p[1] - q[1]).abs() < 1e-12, "{a} and {b}");
        }
    }

    /// No side is turned over: where u is to the right, v is up.
    #[test]
    fn sides_are_seen_from_outside() {
        for side in CubeSide::ALL {
            let [o, p, q] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|point| place(side, point));
            let area = (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
            assert_eq!(area.to_bits(), 1.0_f64.to_bits(), "{side}");
        }
    }
}
