//! Small cases with known answers.

use crate::glue::face_count;
use crate::paths::{Curve, cells, make};
use splitstar_arrangement::traits::SideKind::{self, Closed, Contracted, Open};

const SIZE: [i64; 2] = [12, 8];

pub(crate) const KINDS: [[SideKind; 2]; 6] = [
    [Open, Open],
    [Contracted, Contracted],
    [Closed, Closed],
    [Contracted, Open],
    [Closed, Contracted],
    [Open, Closed],
];

fn path(from: [i64; 2], to: [i64; 2]) -> Curve {
    Curve::Path([from, to])
}

fn meridian(u: i64) -> Curve {
    path([u, 0], [u, SIZE[1]])
}

/// Vertices, edges and faces as a user sees them.
struct Row {
    name: &'static str,
    curves: Vec<Curve>,
    cells: [usize; 3],
}

/// What does not come to the bottom or top is the same whatever these are.
fn inner_rows() -> Vec<Row> {
    let row = |name, curves: &[Curve], cells| Row { name, curves: curves.to_vec(), cells };
    use Curve::Parallel;
    vec![
        row("nothing", &[], [0, 0, 1]),
        row("a point", &[path([3, 4], [3, 4])], [1, 0, 1]),
        row("a point on the seam", &[path([0, 4], [0, 4])], [1, 0, 1]),
        row("a parallel", &[Parallel(4)], [1, 1, 2]),
        row("three parallels", &[Parallel(1), Parallel(4), Parallel(5)], [3, 3, 4]),
        row("a parallel twice", &[Parallel(4), Parallel(4)], [1, 1, 2]),
        row("a parallel and a point on it", &[Parallel(4), path([3, 4], [3, 4])], [1, 1, 2]),
        row("a parallel and a point on it at the seam", &[Parallel(4), path([0, 4], [0, 4])], [1, 1, 2]),
        row("across the seam", &[path([10, 3], [14, 5])], [2, 1, 1]),
        row("along the seam", &[path([0, 2], [0, 5])], [2, 1, 1]),
        row(
            "along the seam, in two overlapping parts",
            &[path([0, 2], [0, 5]), path([12, 3], [12, 6])],
            [4, 3, 1],
        ),
        row("touching the seam from both sides", &[path([0, 2], [3, 5]), path([8, 1], [12, 2])], [3, 2, 1]),
        row("ladder", &[Parallel(2), Parallel(6), path([5, 2], [5, 6])], [2, 3, 3]),
        row("ladder on the seam", &[Parallel(2), Parallel(6), path([0, 2], [0, 6])], [2, 3, 3]),
        row("helix of two turns and a parallel", &[path([1, 1], [25, 7]), Parallel(4)], [3, 3, 2]),
        row("two helices", &[path([1, 1], [25, 7]), path([1, 7], [25, 1])], [5, 8, 5]),
        row(
            "a square around the seam",
            &[path([10, 2], [14, 2]), path([14, 2], [14, 6]), path([14, 6], [10, 6]), path([10, 6], [10, 2])],
            [4, 4, 2],
        ),
        row(
            "a square with its left side on the seam",
            &[path([0, 2], [4, 2]), path([4, 2], [4, 6]), path([4, 6], [0, 6]), path([0, 6], [0, 2])],
            [4, 4, 2],
        ),
        row(
            "a square with its right side on the seam",
            &[path([8, 2], [12, 2]), path([12, 2], [12, 6]), path([12, 6], [8, 6]), path([8, 6], [8, 2])],
            [4, 4, 2],
        ),
        row("a closed zigzag around", &[path([2, 2], [8, 6]), path([8, 6], [14, 2])], [2, 2, 2]),
    ]
}

fn check(name: &str, kinds: [SideKind; 2], curves: &[Curve], expected: [usize; 3]) {
    for by in [0, 1, 5, 9, 11, -7] {
        let curves: Vec<Curve> = curves.iter().map(|curve| curve.moved(by)).collect();
        let context = format!("{name}, {kinds:?}, moved by {by}: {curves:?}");
        assert_eq!(face_count(SIZE, kinds, &curves), expected[2], "the oracle: {context}");
        let arrangement = make::<true>(SIZE, kinds, &curves);
        assert_eq!(arrangement.check_valid(), [], "{context}");
        assert_eq!(cells(&arrangement.counts()), expected, "{context}");
        let sorted = make::<false>(SIZE, kinds, &curves);
        assert_eq!(sorted.check_valid(), [], "sorted at every event: {context}");
        assert_eq!(sorted.counts(), arrangement.counts(), "sorted at every event: {context}");
    }
}

#[test]
fn inside_the_strip() {
    for kinds in KINDS {
        for Row { name, curves, cells } in inner_rows() {
            check(name, kinds, &curves, cells);
        }
    }
}

/// Curves that come to open or contracted sides, where nothing is counted as a vertex.
#[test]
fn to_the_poles() {
    use Curve::Parallel;
    for kinds in [[Open, Open], [Contracted, Contracted], [Contracted, Open], [Open, Contracted]] {
        let check = |name: &str, curves: &[Curve], cells| check(name, kinds, curves, cells);
        check("a meridian", &[meridian(3)], [0, 1, 1]);
        check("two meridians", &[meridian(3), meridian(8)], [0, 2, 2]);
        check("a meridian twice", &[meridian(3), meridian(3)], [0, 1, 1]);
        check("from the south", &[path([3, 0], [3, 4])], [1, 1, 1]);
        check("from the north", &[path([3, 4], [3, 8])], [1, 1, 1]);
        check("from the south to a parallel", &[path([3, 0], [3, 4]), Parallel(4)], [1, 2, 2]);
        check("from the north to a parallel", &[path([3, 8], [3, 4]), Parallel(4)], [1, 2, 2]);
        check("two from the south that meet", &[path([3, 0], [6, 4]), path([9, 0], [6, 4])], [1, 2, 2]);
        check("two from the north that meet", &[path([3, 8], [6, 4]), path([9, 8], [6, 4])], [1, 2, 2]);
        check("a slanted one", &[path([3, 0], [7, 8])], [0, 1, 1]);
        check("one that winds twice around", &[path([3, 0], [29, 8])], [0, 1, 1]);
        check("two that wind, and cross", &[path([3, 0], [29, 8]), meridian(4)], [3, 8, 5]);
        let from_one_place =
            [path([3, 0], [1, 4]), path([3, 0], [3, 4]), path([3, 0], [5, 4]), path([3, 0], [9, 4])];
        check("a bundle from one place", &from_one_place, [4, 4, 1]);
        let to_one_place: Vec<Curve> = from_one_place
            .iter()
            .map(|&curve| match curve {
                Curve::Path([[u, _], [w, v]]) => path([u, 8], [w, v]),
                parallel => parallel,
            })
            .collect();
        check("a bundle to one place", &to_one_place, [4, 4, 1]);
        let with_parallel = |curves: &[Curve]| [curves, &[Parallel(4)]].concat();
        check("a bundle and a parallel", &with_parallel(&from_one_place), [4, 8, 5]);
        check("a bundle from above and a parallel", &with_parallel(&to_one_place), [4, 8, 5]);
        let all = [&from_one_place[..], &to_one_place[..], &[Parallel(4)]].concat();
        check("both bundles and a parallel", &all, [4, 12, 8]);
        check("a bundle and its bound", &[&from_one_place[..], &[path([1, 4], [9, 4])]].concat(), [4, 7, 4]);
        for n in 1..5_i64 {
            for m in 0..4_i64 {
                let meridians = (0..n).map(|i| meridian(2 * i));
                let curves: Vec<Curve> = meridians.chain((0..m).map(|i| Parallel(2 * i + 1))).collect();
                let [n, m] = [n, m].map(|count| count as usize);
                check("a grid", &curves, [n * m, n * (2 * m + 1), n * (m + 1)]);
            }
        }
    }
}

/// The points of closed sides are points like others.
#[test]
fn to_closed_sides() {
    use Curve::Parallel;
    let kinds = [Closed, Closed];
    let check = |name: &str, curves: &[Curve], cells| check(name, kinds, curves, cells);
    check("a parallel on the bottom", &[Parallel(0)], [1, 1, 2]);
    check("a parallel on the top", &[Parallel(8)], [1, 1, 2]);
    check("both", &[Parallel(0), Parallel(8)], [2, 2, 3]);
    check("a meridian", &[meridian(3)], [2, 1, 1]);
    check("a meridian between both", &[Parallel(0), meridian(3), Parallel(8)], [2, 3, 3]);
    check("a piece of the bottom", &[path([1, 0], [9, 0]), path([4, 0], [6, 3])], [4, 3, 1]);
    check(
        "a roof on the bottom",
        &[path([1, 0], [9, 0]), path([1, 0], [5, 3]), path([5, 3], [9, 0])],
        [3, 3, 2],
    );
    check("a point on the bottom", &[path([0, 0], [0, 0]), path([3, 8], [3, 8])], [2, 0, 1]);
}

/// What a curve along the seam closes off is behind it: on the right side of the strip, not on the left one.
#[test]
fn a_meridian_on_the_seam_separates_left_from_right() {
    let curves = [path([0, 0], [0, 8]), path([2, 8], [0, 3]), path([5, 0], [5, 8])];
    check("a meridian on the seam", [Contracted, Open], &curves[..1], [0, 1, 1]);
    check("with a curve to it from the top", [Contracted, Open], &curves[..2], [1, 3, 2]);
    check("with another meridian", [Open, Contracted], &curves, [1, 4, 3]);
}

/// In a corner, events come in the order of the left or right side, which is not that around the pole.
#[test]
fn curves_into_a_corner_are_in_order_around_the_pole() {
    for corner in [[0, 0], [0, 8], [12, 0], [12, 8]] {
        let inwards = if corner[0] == 0 { 1 } else { -1 };
        let to = |by: i64, v: i64| [corner[0] + inwards * by, v];
        let rays = [to(1, 4), to(3, 4), to(6, 4)].map(|to| path(corner, to));
        let rim = [path(to(1, 4), to(3, 4)), path(to(3, 4), to(6, 4))];
        let curves = [&rays[..], &rim[..]].concat();
        check("a fan in a corner", [Contracted, Contracted], &curves, [3, 5, 3]);
        check("a fan in a corner", [Open, Open], &curves, [3, 5, 3]);
        let with_seam = [&curves[..], &[meridian(0)]].concat();
        check("a fan beside the seam", [Contracted, Contracted], &with_seam, [3, 6, 3]);
    }
}

/// A side to which nothing comes is in the face beside it, and not in that of the lower left corner.
#[test]
fn a_pole_beyond_a_parallel_is_in_its_own_face() {
    for kinds in [[Open, Open], [Contracted, Contracted]] {
        let arrangement = make::<true>(SIZE, kinds, &[Curve::Parallel(4)]);
        let dcel = arrangement.dcel();
        let poles = dcel.vertices().filter(|&v| arrangement.is_at_infinity(v));
        let faces: Vec<_> = poles.map(|v| dcel.isolated_face(v).unwrap()).collect();
        assert_eq!(faces.len(), 2);
        assert_ne!(faces[0], faces[1], "{kinds:?}");
        assert_eq!(faces[0], arrangement.corner_face(), "{kinds:?}");
    }
}
