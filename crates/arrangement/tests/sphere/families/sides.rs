//! What ends at poles and passes through them, lies on the identification and crosses it, or is on one circle.

use super::{Add, NORTH, SOUTH, V, cross, end_to_end, minus, polygon, with};
use crate::arcs::{Curve, around, circle, point, short, via};

/// Points of the identification.
const SEAM: [V; 5] = [[-1, 0, -2], [-1, 0, -1], [-1, 0, 0], [-1, 0, 1], [-1, 0, 3]];

/// Arcs that end at poles or pass through them, and what goes round them.
pub(super) fn at_poles(add: Add<'_>) {
    let horizontal = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [1, 1, 0], [-1, 2, 0], [-1, -1, 0]];
    for pole in [NORTH, SOUTH] {
        let at = |i: usize, v: i64| [0, 1, 2].map(|c| 2 * horizontal[i][c] + v * pole[c]);
        let to_pole: Vec<Curve> = (0..7).map(|i| short(at(i, i as i64 % 3), pole)).collect();
        add("meridians that end at a pole", to_pole.clone(), [8, 7, 1, 0, 1]);
        let through: Vec<Curve> = (0..2).map(|i| short(at(i, 3), at(i + 2, 1))).collect();
        add("an arc through a pole", through[..1].to_vec(), [2, 1, 1, 0, 1]);
        add("two arcs through a pole", through.clone(), [5, 4, 1, 0, 1]);
        add("arcs through a pole and to it", with(through.clone(), &to_pole[4..]), [8, 7, 1, 0, 1]);
        let rim: Vec<Curve> = (0..4).map(|i| short(at(i, 3), at((i + 1) % 4, 3))).collect();
        add("a rim", rim.clone(), [4, 4, 2, 0, 1]);
        let spokes: Vec<Curve> = (0..4).map(|i| short(at(i, 3), pole)).collect();
        add("a wheel", with(spokes, &rim), [5, 8, 5, 0, 1]);
        let long = via(at(0, -1), pole, at(2, -1));
        add("a long arc through a pole", vec![long.clone()], [2, 1, 1, 0, 1]);
        add("a long arc through a pole across a rim", with(rim.clone(), &[long]), [6, 7, 3, 0, 1]);
        add("a rim across a meridian", with(rim, &[circle([1, 1, 0])]), [6, 8, 4, 0, 1]);
        let overlap = vec![short(at(0, 2), at(2, 2)), short(at(0, 1), at(2, 4)), short(at(2, 3), pole)];
        add("overlaps through a pole", overlap, [6, 5, 1, 0, 1]);
    }
    let all = |v: V| via(SOUTH, v, NORTH);
    add("from pole to pole", vec![all([1, 2, 5])], [2, 1, 1, 0, 1]);
    add(
        "from pole to pole, and turned round",
        vec![all([1, 2, 5]), via(NORTH, [2, 4, -1], SOUTH)],
        [2, 1, 1, 0, 1],
    );
    add("round both poles", vec![circle([2, 1, 0])], [1, 1, 2, 0, 1]);
    add("round both poles, with one", vec![circle([2, 1, 0]), point(NORTH)], [1, 1, 2, 0, 1]);
    add("round both poles, with both", vec![circle([2, 1, 0]), point(NORTH), point(SOUTH)], [2, 2, 2, 0, 1]);
    add("round both poles, from one", vec![around(SOUTH, SOUTH, [2, 1, 0])], [1, 1, 2, 0, 1]);
    add("almost round, both poles inside", vec![around([1, -2, 1], [1, -2, 0], [2, 1, 0])], [2, 1, 1, 0, 1]);
    add("between the poles, past none", vec![short([1, -2, 9], [1, -2, -9])], [2, 1, 1, 0, 1]);
    add("the equator and both poles", vec![circle(NORTH), point(NORTH), point(SOUTH)], [3, 1, 2, 2, 3]);
    add("beside a pole", vec![circle([0, 1, 1000]), circle([1000, 1, 0])], [2, 4, 4, 0, 1]);
}

/// Arcs on the identification, to it, and across.
pub(super) fn at_the_identification(add: Add<'_>) {
    let [a, b, c, d, e] = SEAM;
    let (east, west) = ([-2, -1, 1], [-2, 1, 0]);
    let along = short(a, d);
    let whole = via(SOUTH, c, NORTH);
    add("along it", vec![along.clone()], [2, 1, 1, 0, 1]);
    add("along it, in two that overlap", vec![short(a, c), short(b, e)], [4, 3, 1, 0, 1]);
    add("along it, end to end", vec![short(a, b), short(b, c), short(d, c)], [4, 3, 1, 0, 1]);
    add("all of it", vec![whole.clone()], [2, 1, 1, 0, 1]);
    add("all of it, and parts", vec![whole.clone(), along.clone(), short(c, e)], [6, 5, 1, 0, 1]);
    add("all of it, and points", vec![whole.clone(), point(b), point(d), point(NORTH)], [4, 3, 1, 0, 1]);
    add("its circle", vec![circle([0, 1, 0])], [1, 1, 2, 0, 1]);
    add("its circle, from a point of it", vec![around(c, c, [0, 1, 0])], [1, 1, 2, 0, 1]);
    add("its circle, and a part of it", vec![circle([0, -1, 0]), along.clone()], [2, 2, 2, 0, 1]);
    add("its circle, and all of it", vec![circle([0, -1, 0]), whole.clone()], [2, 2, 2, 0, 1]);
    add("more than it, through both poles", vec![around([1, 0, 5], [1, 0, -5], [0, -1, 0])], [2, 1, 1, 0, 1]);
    add("points of it", SEAM.map(point).to_vec(), [5, 0, 1, 5, 5]);
    add("to it from the east", vec![short(east, c)], [2, 1, 1, 0, 1]);
    add("to it from the west", vec![short(c, west)], [2, 1, 1, 0, 1]);
    add("to it from both sides", vec![short(east, c), short(c, west)], [3, 2, 1, 0, 1]);
    add("across it", vec![short(east, west)], [2, 1, 1, 0, 1]);
    add("across it the long way", vec![around(east, west, cross(east, west))], [2, 1, 1, 0, 1]);
    add("not across it, the long way", vec![around(west, east, cross(west, east))], [2, 1, 1, 0, 1]);
    let two = vec![short(east, c), short(west, d)];
    add("two to it", two.clone(), [4, 2, 1, 0, 2]);
    add("two to it, and along it", with(two.clone(), &[short(b, e)]), [6, 5, 1, 0, 1]);
    add("two to it, and all of it", with(two, std::slice::from_ref(&whole)), [6, 5, 1, 0, 1]);
    add("across an arc along it", vec![short(a, e), short([-1, 1, 1], [-1, -1, 1])], [5, 4, 1, 0, 1]);
    add(
        "across the end of an arc along it",
        vec![short(a, d), short([-1, 1, 1], [-1, -1, 1])],
        [4, 3, 1, 0, 1],
    );
    add("across a point of it", vec![short([-1, 1, 1], [-1, -1, 1]), point(d)], [3, 2, 1, 0, 1]);
    let crossing = vec![short([-1, 1, 1], [-1, -1, 1]), short([-2, 1, 1], [-2, -1, 3])];
    add("two cross on it", crossing.clone(), [5, 4, 1, 0, 1]);
    add("two cross on an arc along it", with(crossing, &[short(b, e)]), [7, 6, 1, 0, 1]);
    let overlap = vec![short([-3, 1, 0], [-3, -1, 0]), short([-5, 1, 0], c), short(c, [-1, -1, 0])];
    add("overlaps across it", overlap, [5, 4, 1, 0, 1]);
    let square = polygon(c, 4, 5);
    add(
        "a square with its side on it",
        vec![short(b, d), short(d, [-2, 1, 1]), short([-2, 1, 1], [-2, 1, -1]), short([-2, 1, -1], b)],
        [4, 4, 2, 0, 1],
    );
    add(
        "a square with its other side on it",
        vec![short(b, d), short(d, [-2, -1, 1]), short([-2, -1, 1], [-2, -1, -1]), short([-2, -1, -1], b)],
        [4, 4, 2, 0, 1],
    );
    add("a square about it, and along it", with(square.clone(), &[short(a, e)]), [8, 9, 3, 0, 1]);
    add(
        "a square about it, and all of it",
        with(square.clone(), std::slice::from_ref(&whole)),
        [8, 9, 3, 0, 1],
    );
    add(
        "a square about it, and an arc in it",
        with(square.clone(), &[short([-20, 0, 1], [-20, 0, -1])]),
        [6, 5, 2, 0, 2],
    );
    add("a square about it, and a point in it", with(square, &[point(c)]), [5, 4, 2, 1, 2]);
    for pole in [NORTH, SOUTH] {
        let z = pole[2];
        let fan = [[-3, 1, z], [-1, 1, z], [-1, 3, z]].map(|end| short(pole, end));
        let rim = [short([-3, 1, z], [-1, 1, z]), short([-1, 1, z], [-1, 3, z])];
        add("a fan beside it", with(fan.to_vec(), &rim), [4, 5, 3, 0, 1]);
        let both = with(with(fan.to_vec(), &rim), std::slice::from_ref(&whole));
        add("a fan beside all of it", both, [5, 6, 3, 0, 1]);
        let fan = fan.map(|curve| curve.mapped(&crate::space::matrix([[1, 0, 0], [0, -1, 0], [0, 0, 1]])));
        add("a fan on the other side", with(fan.to_vec(), std::slice::from_ref(&whole)), [5, 4, 1, 0, 1]);
        add("from a pole to it", vec![short(pole, c)], [2, 1, 1, 0, 1]);
        add("past a pole to it", vec![short([1, 0, 2 * z], [-1, 0, 2 * z])], [2, 1, 1, 0, 1]);
    }
    add(
        "the same place from both sides, and along it",
        vec![short(east, c), short(west, c), short(c, d), short(c, a)],
        [5, 4, 1, 0, 1],
    );
}

/// Arcs of one circle: the equator, the circle of the identification, a meridian, and one that is tilted.
pub(super) fn along_one_circle(add: Add<'_>) {
    for (normal, start) in [
        (NORTH, [-1, 0, 0]),
        ([0, 1, 0], NORTH),
        ([0, 1, 0], [-1, 0, 1]),
        ([1, 1, 0], [1, -1, 1]),
        ([1, 2, 3], [3, 0, -1]),
        ([2, 0, 1], [-1, 0, 2]),
    ] {
        let ahead = cross(normal, start);
        let at = |s: i64, t: i64| [0, 1, 2].map(|i| s * start[i] + t * ahead[i]);
        let arc = |from: [i64; 2], to: [i64; 2]| around(at(from[0], from[1]), at(to[0], to[1]), normal);
        add("an arc", vec![arc([1, 0], [1, 1])], [2, 1, 1, 0, 1]);
        add(
            "an arc twice, and turned round",
            vec![arc([1, 0], [1, 1]), arc([1, 0], [1, 1]), arc([1, 0], [1, 1]).swapped()],
            [2, 1, 1, 0, 1],
        );
        add("nested", vec![arc([3, -1], [-1, 3]), arc([1, 0], [1, 1])], [4, 3, 1, 0, 1]);
        add("nested, with a common end", vec![arc([1, 0], [-1, 3]), arc([1, 0], [1, 1])], [3, 2, 1, 0, 1]);
        let deep = [[9, 0], [9, 1], [9, 2], [9, 3]].map(|from| arc(from, [-from[0], from[1]]));
        add("nested four deep", deep.to_vec(), [8, 7, 1, 0, 1]);
        add("nested in more than half", vec![arc([1, 0], [1, -2]), arc([0, 1], [-1, 0])], [4, 3, 1, 0, 1]);
        add(
            "chained",
            vec![arc([2, -1], [2, 1]), arc([1, 0], [0, 1]), arc([1, 2], [-1, 1])],
            [6, 5, 1, 0, 1],
        );
        add("two that cover all", vec![arc([1, 0], [0, -1]), arc([-1, 0], [1, 1])], [4, 4, 2, 0, 1]);
        add("two that meet in both ends", vec![arc([1, 0], [0, -1]), arc([0, -1], [1, 0])], [2, 2, 2, 0, 1]);
        add("two that meet in one end", vec![arc([1, 0], [0, -1]), arc([0, -1], [2, -1])], [3, 2, 1, 0, 1]);
        add("apart", vec![arc([1, 0], [1, 1]), arc([-1, 0], [-1, -1])], [4, 2, 1, 0, 2]);
        for k in [3, 4, 7_usize] {
            add(&format!("{k} arcs, end to end all round"), end_to_end(normal, start, k), [k, k, 2, 0, 1]);
            let with_circle = with(end_to_end(normal, start, k), &[circle(normal)]);
            add(&format!("{k} arcs all round, and the circle"), with_circle, [k, k, 2, 0, 1]);
        }
        add("a circle", vec![circle(normal)], [1, 1, 2, 0, 1]);
        add(
            "a circle twice",
            vec![circle(normal), circle(minus(normal)), circle(normal.map(|c| 3 * c))],
            [1, 1, 2, 0, 1],
        );
        add("a circle and an arc of it", vec![circle(normal), arc([1, 2], [-3, 1])], [2, 2, 2, 0, 1]);
        add("a circle and a point of it", vec![circle(normal), point(at(2, 1))], [1, 1, 2, 0, 1]);
        add(
            "all round from two points",
            vec![around(start, start, normal), around(at(1, 1), at(1, 1), minus(normal))],
            [2, 2, 2, 0, 1],
        );
        add(
            "all round, and a long arc",
            vec![around(start, start, normal), arc([1, 1], [1, -1])],
            [3, 3, 2, 0, 1],
        );
        let middle = [0, 1, 2].map(|i| at(1, 1)[i] + normal[i]);
        let tooth = short(at(1, 1), middle);
        add("a tooth on a circle", vec![circle(normal), tooth.clone()], [2, 2, 2, 0, 1]);
        let crossing = short(middle, [0, 1, 2].map(|i| at(1, 1)[i] - normal[i]));
        add("a bar across a circle", vec![circle(normal), crossing.clone()], [3, 3, 2, 0, 1]);
        add(
            "a bar across an overlap",
            vec![arc([2, 1], [0, 1]), arc([1, 0], [1, 2]), crossing],
            [7, 6, 1, 0, 1],
        );
        add(
            "a tooth where an overlap begins",
            vec![arc([1, 0], [1, 2]), arc([1, 1], [0, 1]), tooth],
            [5, 4, 1, 0, 1],
        );
        let points = vec![point(at(1, 0)), point(at(0, 1)), point(at(-1, 0)), point(at(2, -1))];
        add("points on a circle", with(points.clone(), &[circle(normal)]), [4, 4, 2, 0, 1]);
        add("points on an arc and beside it", with(points, &[arc([1, 0], [-1, 3])]), [5, 2, 1, 2, 3]);
    }
}
