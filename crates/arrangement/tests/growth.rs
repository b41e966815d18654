//! Calls of predicates grow as the documentation says, on input on which naive ways take quadratic time.

use exact::planar::Point2;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::models::{Segment, SegmentTraits};
use splitstar_arrangement::topology::BoundedPlane;
use splitstar_arrangement::wrappers::CountingTraits;

fn segment(ends: [[i64; 2]; 2]) -> Segment {
    Segment::from_i64(ends).expect("the ends are different")
}

/// The calls of all methods, and the numbers of vertices and edges.
fn calls(curves: &[Segment]) -> (u64, [usize; 2]) {
    let arrangement = Arrangement::of_curves(CountingTraits::new(SegmentTraits), BoundedPlane, curves);
    let counts = arrangement.counts();
    (arrangement.traits().counters().total(), [counts.vertices, counts.edges])
}

fn assert_grows_slowly(
    name: &str,
    family: impl Fn(i64) -> Vec<Segment>,
    cells: impl Fn(usize) -> [usize; 2],
) {
    let sizes = [2_000, 4_000, 8_000];
    let counted = sizes.map(|n| {
        let (calls, found) = calls(&family(n));
        assert_eq!(found, cells(n as usize), "{name} {n}");
        calls
    });
    for pair in counted.windows(2) {
        assert!(pair[1] < pair[0] * 5 / 2, "{name}: {counted:?}");
    }
}

#[test]
fn nested_overlaps() {
    let family = |n| (0..n).map(|i| segment([[i, 0], [3 * n - i, 0]])).collect();
    assert_grows_slowly("nested", family, |n| [2 * n, 2 * n - 1]);
}

#[test]
fn staggered_overlaps() {
    let family = |n| (0..n).map(|i| segment([[i, 0], [i + n, 0]])).collect();
    // i + n for i, and j for j = i + n with j < n: none; 0 to n - 1 begin, n to 2 n - 1 end.
    assert_grows_slowly("staggered", family, |n| [2 * n, 2 * n - 1]);
}

#[test]
fn equal_segments_below_short_ones() {
    let family = |n| {
        let equal = (0..n).map(|_| segment([[0, 0], [4 * n, 0]]));
        equal.chain((0..n).map(|i| segment([[4 * i, 1], [4 * i + 2, 1]]))).collect()
    };
    assert_grows_slowly("equal", family, |n| [2 * n + 2, n + 1]);
}

#[test]
fn one_point_for_all() {
    let family = |n| (0..n).map(|i| segment([[-n, -i - 1], [n, i + 1]])).collect();
    assert_grows_slowly("pencil", family, |n| [2 * n + 1, 2 * n]);
}

#[test]
fn parallel_bundles_that_cross() {
    // Every bundle is ten equal segments; bundles cross each other once.
    let family = |n: i64| {
        let side = (n / 20).isqrt();
        let starts =
            (0..side).flat_map(|i| [[[2 * i, 0], [2 * i + 400, 400]], [[2 * i + 1, 401], [2 * i + 401, 1]]]);
        starts.flat_map(|ends| [ends; 10]).map(segment).collect::<Vec<_>>()
    };
    let (few, [least, _]) = calls(&family(20_000));
    let (many, [most, _]) = calls(&family(80_000));
    // Twice as many bundles of each kind meet in four times as many points.
    assert!(most > 3 * least && many < 5 * few, "{few} {many} {least} {most}");
}

/// A point of three lines is one vertex, whatever else happens: kept beside the others because its lines are bundles.
#[test]
fn bundles_through_a_point() {
    let thrice = |ends| [segment(ends), segment(ends), segment(ends)];
    let curves: Vec<_> = [[[-2, -2], [2, 2]], [[-2, 2], [2, -2]], [[0, -2], [0, 2]], [[-2, 0], [2, 0]]]
        .into_iter()
        .flat_map(thrice)
        .collect();
    let arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, &curves);
    assert_eq!(arrangement.check_valid(), []);
    assert_eq!((arrangement.counts().vertices, arrangement.counts().edges), (9, 8));
    let centre = Point2::from_i64([0, 0]);
    assert!(arrangement.vertices().any(|v| arrangement.point(v) == Some(&centre)));
}
