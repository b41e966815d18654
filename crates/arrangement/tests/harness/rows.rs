//! Degenerate families: what is drawn, and how many cells it has.

use crate::curves::{Curve, parse, point, segment};

pub(crate) struct Row {
    pub(crate) name: String,
    pub(crate) curves: Vec<Curve>,
    /// Vertices, edges, faces, isolated vertices, components.
    pub(crate) counts: [usize; 5],
}

/// Written out.
const ROWS: &[(&str, &str, [usize; 5])] = &[
    ("nothing", "", [0, 0, 1, 0, 0]),
    ("a point", "point 3 4", [1, 0, 1, 1, 1]),
    ("a point twice", "point 3 4, point 3 4", [1, 0, 1, 1, 1]),
    ("points above each other", "point 3 4, point 3 5, point 3 3", [3, 0, 1, 3, 3]),
    ("a segment", "segment 0 0 2 1", [2, 1, 1, 0, 1]),
    ("a vertical segment", "segment 0 2 0 0", [2, 1, 1, 0, 1]),
    ("a line", "line 0 0 2 1", [0, 1, 2, 0, 1]),
    ("a vertical line", "line 0 0 0 1", [0, 1, 2, 0, 1]),
    ("a ray", "ray 0 0 2 1", [1, 1, 1, 0, 1]),
    ("a ray to the left", "ray 0 0 -2 1", [1, 1, 1, 0, 1]),
    ("a ray up", "ray 0 0 0 1", [1, 1, 1, 0, 1]),
    ("a ray down", "ray 0 0 0 -1", [1, 1, 1, 0, 1]),
    ("a crossing", "segment 0 0 2 2, segment 0 2 2 0", [5, 4, 1, 0, 1]),
    ("a crossing between integers", "segment 0 0 3 1, segment 0 1 3 0", [5, 4, 1, 0, 1]),
    ("a vertical crossed", "segment 1 0 1 3, segment 0 1 3 2", [5, 4, 1, 0, 1]),
    ("a triangle", "segment 0 0 2 0, segment 2 0 1 2, segment 1 2 0 0", [3, 3, 2, 0, 1]),
    ("a triangle with a vertical side", "segment 0 0 0 4, segment 0 4 3 2, segment 3 2 0 0", [3, 3, 2, 0, 1]),
    ("a rhombus", "segment 0 0 2 1, segment 2 1 4 0, segment 0 0 2 -1, segment 2 -1 4 0", [4, 4, 2, 0, 1]),
    // T-junctions.
    ("T from above", "segment 0 0 4 0, segment 2 0 2 2", [4, 3, 1, 0, 1]),
    ("T from below", "segment 0 0 4 0, segment 2 0 2 -2", [4, 3, 1, 0, 1]),
    ("T from the left", "segment 2 0 2 4, segment 0 1 2 1", [4, 3, 1, 0, 1]),
    ("T from the right", "segment 2 0 2 4, segment 2 1 4 3", [4, 3, 1, 0, 1]),
    ("T on a diagonal", "segment 0 0 6 3, segment 2 1 2 9, segment 4 2 0 9", [7, 7, 2, 0, 1]),
    ("T from both sides", "segment 0 0 4 0, segment 2 0 2 2, segment 2 0 1 -2", [5, 4, 1, 0, 1]),
    (
        "T of many",
        "segment 0 0 4 0, segment 2 0 1 2, segment 2 0 2 2, segment 2 0 3 2, segment 2 0 4 4",
        [7, 6, 1, 0, 1],
    ),
    // Overlaps.
    ("identical", "segment 0 0 2 1, segment 0 0 2 1", [2, 1, 1, 0, 1]),
    ("identical, turned round", "segment 0 0 2 1, segment 2 1 0 0, segment 0 0 2 1", [2, 1, 1, 0, 1]),
    ("overlap", "segment 0 0 2 0, segment 1 0 3 0", [4, 3, 1, 0, 1]),
    ("overlap on a diagonal", "segment 0 0 6 3, segment 2 1 8 4", [4, 3, 1, 0, 1]),
    ("overlap of verticals", "segment 0 0 0 4, segment 0 2 0 6", [4, 3, 1, 0, 1]),
    ("nested", "segment 0 0 6 0, segment 2 0 4 0", [4, 3, 1, 0, 1]),
    ("nested with a common left end", "segment 0 0 6 3, segment 0 0 4 2", [3, 2, 1, 0, 1]),
    ("nested with a common right end", "segment 0 0 6 3, segment 2 1 6 3", [3, 2, 1, 0, 1]),
    ("nested verticals", "segment 0 0 0 6, segment 0 2 0 4, segment 0 0 0 5", [5, 4, 1, 0, 1]),
    (
        "nested three deep",
        "segment 0 0 9 0, segment 1 0 8 0, segment 2 0 7 0, segment 3 0 6 0",
        [8, 7, 1, 0, 1],
    ),
    ("chained", "segment 0 0 2 0, segment 1 0 3 0, segment 2 0 4 0, segment 3 0 5 0", [6, 5, 1, 0, 1]),
    ("end to end", "segment 0 0 2 0, segment 2 0 3 0, segment 3 0 7 0", [4, 3, 1, 0, 1]),
    ("overlap crossed", "segment 0 0 4 0, segment 1 0 5 0, segment 2 -1 3 2", [7, 6, 1, 0, 1]),
    ("vertical overlap crossed", "segment 0 0 0 4, segment 0 2 0 6, segment -1 3 1 3", [7, 6, 1, 0, 1]),
    (
        "crossing where an overlap begins",
        "segment 0 0 4 0, segment 2 0 5 0, segment 1 -1 3 1",
        [6, 5, 1, 0, 1],
    ),
    (
        "overlap ends in a T",
        "segment 0 0 4 0, segment 2 0 6 0, segment 4 0 4 3, segment 2 0 2 -3",
        [6, 5, 1, 0, 1],
    ),
    (
        "two overlaps cross",
        "segment 0 0 4 4, segment 1 1 5 5, segment 0 4 4 0, segment -1 5 3 1",
        [9, 8, 1, 0, 1],
    ),
    // Points.
    ("a point in a face", "segment 0 0 4 0, segment 4 0 2 4, segment 2 4 0 0, point 2 1", [4, 3, 2, 1, 2]),
    ("a point on an edge", "segment 0 0 4 2, point 2 1", [3, 2, 1, 0, 1]),
    ("a point on a vertical edge", "segment 0 0 0 4, point 0 1", [3, 2, 1, 0, 1]),
    ("points on vertices", "segment 0 0 4 2, point 4 2, point 0 0", [2, 1, 1, 0, 1]),
    ("a point on a crossing", "segment 0 0 2 2, segment 0 2 2 0, point 1 1", [5, 4, 1, 0, 1]),
    ("a point on an overlap", "segment 0 0 4 0, segment 1 0 6 0, point 2 0", [5, 4, 1, 0, 1]),
    ("points beside an edge", "segment 0 0 4 2, point 2 0, point 2 2, point 0 1, point 4 1", [6, 1, 1, 4, 5]),
    // Lines and rays.
    ("two lines", "line 0 0 1 1, line 0 1 1 0", [1, 4, 4, 0, 1]),
    ("a line twice", "line 0 0 1 1, line 3 3 2 2", [0, 1, 2, 0, 1]),
    ("a vertical line twice", "line 0 0 0 1, line 0 3 0 2", [0, 1, 2, 0, 1]),
    ("three lines", "line 0 0 1 0, line 0 0 0 1, line 0 1 1 0", [3, 9, 7, 0, 1]),
    ("concurrent lines", "line 0 0 1 0, line 0 0 0 1, line 0 0 1 1, line 0 0 1 -1", [1, 8, 8, 0, 1]),
    ("parallel lines", "line 0 0 2 1, line 0 1 2 2, line 0 5 2 6, line 0 -3 2 -2", [0, 4, 5, 0, 4]),
    ("vertical lines", "line 0 0 0 1, line 3 0 3 1, line -5 0 -5 1", [0, 3, 4, 0, 3]),
    ("a grid of lines", "line 0 0 0 1, line 3 0 3 1, line 0 0 1 0, line 0 2 1 2", [4, 12, 9, 0, 1]),
    ("rays that make a line", "ray 0 0 1 0, ray 0 0 -1 0", [1, 2, 2, 0, 1]),
    ("rays that make a vertical line", "ray 0 0 0 1, ray 0 0 0 -1", [1, 2, 2, 0, 1]),
    ("rays that overlap", "ray 0 0 1 0, ray 3 0 4 0, ray 1 0 9 0", [3, 3, 1, 0, 1]),
    ("rays in opposite directions that overlap", "ray 0 0 1 0, ray 4 0 3 0", [2, 3, 2, 0, 1]),
    ("a ray on a line", "line 0 0 1 0, ray 1 0 2 0", [1, 2, 2, 0, 1]),
    ("a segment on a line", "line 0 0 2 1, segment 2 1 6 3", [2, 3, 2, 0, 1]),
    ("a vertical line with all on it", "line 0 0 0 1, ray 0 3 0 4, segment 0 1 0 2", [3, 4, 2, 0, 1]),
    ("a point on a line", "line 0 0 2 1, point 4 2, point 4 3", [2, 2, 2, 1, 2]),
    ("a point on a vertical line", "line 0 0 0 1, point 0 7, point 1 7, point -1 7", [3, 2, 2, 2, 3]),
    ("a ray down on a line", "ray 0 5 0 4, line 0 0 1 0", [2, 4, 3, 0, 1]),
    (
        "rays from one point",
        "ray 0 0 1 0, ray 0 0 1 3, ray 0 0 0 1, ray 0 0 -2 1, ray 0 0 -1 -1, ray 0 0 0 -1",
        [1, 6, 6, 0, 1],
    ),
    ("rays side by side", "ray 0 0 3 1, ray 0 1 3 2, ray 0 2 3 3", [3, 3, 1, 0, 3]),
    ("rays towards each other", "ray 0 0 1 0, ray 5 1 4 1, ray 2 9 2 8, ray 3 -9 3 -8", [8, 12, 5, 0, 1]),
    ("all kinds", "line 0 0 1 0, ray 0 1 0 2, segment -2 -1 -2 1, point 5 5", [5, 5, 2, 1, 3]),
    (
        "a strip closed by segments",
        "line 0 0 1 0, line 0 1 1 1, segment 0 0 0 1, segment 3 0 3 1",
        [4, 8, 5, 0, 1],
    ),
    (
        "a triangle between lines",
        "line 0 0 1 0, line 0 9 1 9, segment 1 1 5 1, segment 5 1 3 4, segment 3 4 1 1",
        [3, 5, 4, 0, 3],
    ),
];

/// All rows: those written out, and the families that have a size.
pub(crate) fn rows() -> Vec<Row> {
    let written =
        ROWS.iter().map(|&(name, text, counts)| Row { name: name.into(), curves: parse(text), counts });
    let mut rows: Vec<Row> = written.collect();
    let mut add = |name: String, curves, counts| rows.push(Row { name, curves, counts });
    for k in [2, 3, 7_usize] {
        let n = k as i64;
        let through = |i| segment([-2, -1 - i, 2, 1 + i]);
        add(format!("{k} through a point"), (0..n).map(through).collect(), [2 * k + 1, 2 * k, 1, 0, 1]);
        let with_vertical = (0..n).map(through).chain([segment([0, -1, 0, 1])]).collect();
        add(format!("{k} and a vertical through a point"), with_vertical, [2 * k + 3, 2 * k + 2, 1, 0, 1]);
        let fan = (0..n).map(|i| segment([0, 0, 3, i - 1])).collect();
        add(format!("{k} from a point to the right"), fan, [k + 1, k, 1, 0, 1]);
        let fan = (0..n).map(|i| segment([0, 0, -3, i - 1])).collect();
        add(format!("{k} from a point to the left"), fan, [k + 1, k, 1, 0, 1]);
        let comb = (0..n).map(|i| segment([2 * i + 1, 0, 2 * i + 1, 3])).chain([segment([0, 0, 2 * n, 0])]);
        add(format!("a comb of {k} teeth"), comb.collect(), [2 * k + 2, 2 * k + 1, 1, 0, 1]);
        let comb = (0..n).map(|i| segment([0, 2 * i + 1, 3, 2 * i])).chain([segment([0, 0, 0, 2 * n])]);
        add(format!("a comb of {k} teeth to the right"), comb.collect(), [2 * k + 2, 2 * k + 1, 1, 0, 1]);
        let parallel = (0..n).map(|i| segment([i, 2 * i, i + 5, 2 * i + 3])).collect();
        add(format!("{k} parallel segments"), parallel, [2 * k, k, 1, 0, k]);
        let copies = (0..n).map(|_| segment([1, 5, 4, 3])).collect();
        add(format!("a segment {k} times"), copies, [2, 1, 1, 0, 1]);
        add(
            format!("a grid of {k} unit segments a side"),
            unit_grid(n),
            [(k + 1) * (k + 1), 2 * k * (k + 1), k * k + 1, 0, 1],
        );
        let doubled = unit_grid(n)
            .into_iter()
            .chain((0..=n).flat_map(|i| [segment([i, 0, i, n]), segment([0, i, n, i])]));
        add(
            format!("a grid of {k} unit segments under long ones"),
            doubled.collect(),
            [(k + 1) * (k + 1), 2 * k * (k + 1), k * k + 1, 0, 1],
        );
        let crossing = (1..=n).flat_map(|i| [segment([i, 0, i, n + 1]), segment([0, i, n + 1, i])]);
        add(
            format!("{k} by {k} that cross"),
            crossing.collect(),
            [k * k + 4 * k, 2 * k * (k + 1), (k - 1) * (k - 1) + 1, 0, 1],
        );
    }
    let nested: Vec<Curve> = (1..=10).flat_map(square).collect();
    add("squares ten deep".into(), nested.clone(), [40, 40, 11, 0, 10]);
    let with_point = nested.iter().cloned().chain([point(0, 0)]).collect();
    add("squares ten deep and a point".into(), with_point, [41, 40, 11, 1, 11]);
    let points = (1..=10).map(|r| point(2 * r + 1, 0));
    let with_points = nested.into_iter().chain(points).collect();
    add("squares ten deep with points between".into(), with_points, [50, 40, 11, 10, 20]);
    let rhombi = (1..=10).flat_map(rhombus).collect();
    add("rhombi ten deep".into(), rhombi, [40, 40, 11, 0, 10]);
    let square_at = |x, y| {
        square(1).map(|curve| {
            curve.mapped(|[u, v]| [u + crate::curves::rational(x), v + crate::curves::rational(y)])
        })
    };
    let holes = [(-5, -5), (-5, 5), (5, 0)].into_iter().flat_map(|(x, y)| square_at(x, y)).chain(square(9));
    add("a square with three holes".into(), holes.collect(), [16, 16, 5, 0, 4]);
    let corners = [[0, 10], [6, -8], [-9, 3], [9, 3], [-6, -8]];
    let star = (0..5).map(|i| {
        let ([x, y], [z, w]) = (corners[i], corners[(i + 1) % 5]);
        segment([x, y, z, w])
    });
    add("a star of five".into(), star.collect(), [10, 15, 7, 0, 1]);
    rows
}

fn unit_grid(n: i64) -> Vec<Curve> {
    let along = (0..n)
        .flat_map(|i| (0..=n).flat_map(move |j| [segment([i, j, i + 1, j]), segment([j, i + 1, j, i])]));
    along.collect()
}

/// The sides of a square around the origin.
fn square(r: i64) -> [Curve; 4] {
    let r = 2 * r;
    [[-r, -r, r, -r], [r, -r, r, r], [r, r, -r, r], [-r, r, -r, -r]].map(segment)
}

fn rhombus(r: i64) -> [Curve; 4] {
    [[-r, 0, 0, r], [0, r, r, 0], [r, 0, 0, -r], [0, -r, -r, 0]].map(segment)
}
