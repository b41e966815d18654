//! Families on a torus of periods 12 and 10: what is drawn, and how many cells it has.

use crate::curves::{P, at};
use crate::torus_oracle::TorusCurve;

pub(crate) struct TorusRow {
    pub(crate) name: &'static str,
    pub(crate) curves: Vec<TorusCurve>,
    /// Vertices, edges, faces, isolated vertices, components.
    pub(crate) counts: [usize; 5],
}

pub(crate) const PERIOD: [i64; 2] = [12, 10];

pub(crate) fn period() -> P {
    at(PERIOD[0], PERIOD[1])
}

fn point(x: i64, y: i64) -> TorusCurve {
    TorusCurve::Point(at(x, y))
}

fn path([x, y]: [i64; 2], [dx, dy]: [i64; 2]) -> TorusCurve {
    TorusCurve::Path(at(x, y), at(dx, dy))
}

fn closed([x, y]: [i64; 2], winding: [i64; 2]) -> TorusCurve {
    TorusCurve::Closed(at(x, y), winding)
}

fn square([x, y]: [i64; 2], side: i64) -> Vec<TorusCurve> {
    let [z, w] = [x + side, y + side];
    vec![path([x, y], [side, 0]), path([z, y], [0, side]), path([z, w], [-side, 0]), path([x, w], [0, -side])]
}

pub(crate) fn rows() -> Vec<TorusRow> {
    let mut rows = Vec::new();
    let mut add = |name, curves, counts| rows.push(TorusRow { name, curves, counts });
    add("nothing", vec![], [0, 0, 1, 0, 0]);
    add("a point", vec![point(3, 4)], [1, 0, 1, 1, 1]);
    add("a point in the corner", vec![point(0, 0)], [1, 0, 1, 1, 1]);
    add("points on the seams", vec![point(0, 4), point(3, 0), point(12, 4)], [2, 0, 1, 2, 2]);
    for start in [[0, 0], [0, 4], [5, 0], [5, 4], [6, 5]] {
        for winding in [[1, 0], [0, 1], [1, 1], [1, -1], [-1, 2], [2, 1], [3, 2], [-5, -3], [0, -1], [-1, 0]]
        {
            add("a first closed geodesic", vec![closed(start, winding)], [1, 1, 1, 0, 1]);
            let twice = closed(start, winding.map(|w| 2 * w));
            add("round twice", vec![twice.clone()], [1, 1, 1, 0, 1]);
            add("round once and twice", vec![closed(start, winding), twice], [1, 1, 1, 0, 1]);
            let path = path(start, [winding[0] * PERIOD[0], winding[1] * PERIOD[1]]);
            add("a path that closes", vec![path.clone()], [1, 1, 1, 0, 1]);
            add("a path along a geodesic", vec![path, closed(start, winding)], [1, 1, 1, 0, 1]);
        }
        let [x, y] = start;
        let cross = vec![closed(start, [1, 0]), closed(start, [0, 1])];
        add("two closed geodesics", cross.clone(), [1, 2, 1, 0, 1]);
        let three = cross.iter().cloned().chain([closed(start, [1, 1])]).collect();
        add("three through a point", three, [1, 3, 2, 0, 1]);
        let parallel = vec![closed(start, [1, 0]), closed([x, y + 3], [1, 0]), closed([x, y + 5], [-1, 0])];
        add("parallel to the bottom", parallel, [3, 3, 3, 0, 3]);
        let parallel = vec![closed(start, [0, 1]), closed([x + 3, y], [0, 1])];
        add("parallel to the left side", parallel.clone(), [2, 2, 2, 0, 2]);
        let with_point = parallel.into_iter().chain([point(x + 1, y), point(x + 5, y)]).collect();
        add("points between geodesics", with_point, [4, 2, 2, 2, 4]);
        add("slopes 1/2 and 2", vec![closed(start, [2, 1]), closed(start, [1, 2])], [3, 6, 3, 0, 1]);
        add("diagonals", vec![closed(start, [1, 1]), closed(start, [1, -1])], [2, 4, 2, 0, 1]);
        add("slopes 3 and -2", vec![closed(start, [1, 3]), closed(start, [1, -2])], [5, 10, 5, 0, 1]);
        add("a point on a geodesic", vec![closed(start, [1, 1]), point(x, y)], [1, 1, 1, 0, 1]);
        add("a square", square([x - 1, y - 1], 2), [4, 4, 2, 0, 1]);
        let holed: Vec<_> = (1..=4).flat_map(|r| square([x - r, y - r], 2 * r)).collect();
        add("squares four deep", holed, [16, 16, 5, 0, 4]);
        let beside = square([x + 1, y + 1], 2).into_iter().chain([closed(start, [1, 0])]).collect();
        add("a square beside a geodesic", beside, [5, 5, 2, 0, 2]);
        let across = square([x - 1, y - 1], 2).into_iter().chain([closed(start, [1, 0])]).collect();
        add("a square across a geodesic", across, [6, 8, 3, 0, 1]);
        add("a path longer than its circle", vec![path(start, [18, 0])], [2, 2, 1, 0, 1]);
        add("a vertical path longer than its circle", vec![path(start, [0, -23])], [2, 2, 1, 0, 1]);
        add("an open path", vec![path(start, [7, 3])], [2, 1, 1, 0, 1]);
        add("a path almost round", vec![path(start, [11, 0])], [2, 1, 1, 0, 1]);
        add("two paths that overlap", vec![path(start, [8, 0]), path([x + 6, y], [8, 0])], [4, 4, 1, 0, 1]);
        let grid = (0..3).flat_map(|i| [closed([x + 4 * i, y], [0, 1]), closed([x, y + 3 * i], [1, 0])]);
        add("a grid", grid.collect(), [9, 18, 9, 0, 1]);
        let star = [[3, 1], [1, 3], [-1, 3], [-3, 1], [-3, -1], [-1, -3], [1, -3], [3, -1], [2, 0], [0, -2]];
        add("a star", star.into_iter().map(|step| path(start, step)).collect(), [11, 10, 1, 0, 1]);
        let comb = (0..3).map(|i| path([x + 3 * i, y], [0, 2])).chain([closed(start, [1, 0])]).collect();
        add("a comb around the torus", comb, [6, 6, 1, 0, 1]);
    }
    add("along both seams", vec![path([0, 2], [0, 5]), path([3, 0], [5, 0])], [4, 2, 1, 0, 2]);
    add("T on a seam from the left", vec![path([0, 2], [0, 5]), path([-3, 4], [3, 0])], [4, 3, 1, 0, 1]);
    add("T on a seam from the right", vec![path([0, 2], [0, 5]), path([0, 4], [3, 1])], [4, 3, 1, 0, 1]);
    add("through a seam", vec![path([0, 2], [0, 5]), path([-3, 4], [6, 0])], [5, 4, 1, 0, 1]);
    add("T on the bottom from below", vec![path([2, 0], [5, 0]), path([4, -3], [0, 3])], [4, 3, 1, 0, 1]);
    add("through the corner", vec![path([-2, -2], [4, 4]), path([-2, 2], [4, -4])], [5, 4, 1, 0, 1]);
    add(
        "into the corner",
        vec![path([-2, -2], [2, 2]), path([-2, 2], [2, -2]), path([0, 3], [0, -3])],
        [4, 3, 1, 0, 1],
    );
    rows
}
