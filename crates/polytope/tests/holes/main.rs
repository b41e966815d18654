//! Facets with holes, cut into triangles. The oracle: all triangles are positive, no two overlap, and their
//! edges, where they do not cancel, are those of the boundary.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

mod random;

use exact::Point3;
use splitstar_polytope::{Facets, HoleError, PolygonMesh, TriangulateError, triangulate_with_holes};
use std::collections::{BTreeMap, BTreeSet};
use testkit::mesh;

type Place = [i64; 2];
type Lift = fn(Place) -> [i64; 3];

/// Planes in which the front is seen from positive `z`, `x` or `y`, tilted or not, and ways to turn and
/// mirror them.
const PLANES: [Lift; 8] = [
    |[x, y]| [x, y, 3],
    |[x, y]| [5 * x, 5 * y, -x - 2 * y],
    |[x, y]| [7, x, y],
    |[x, y]| [y, -4, x],
    |[x, y]| [x - y, x + y, x],
    |[x, y]| [-y, x, x + 3 * y],
    |[x, y]| [-x, -y, 1],
    |[x, y]| [3 * x + y, y - x, -9 * x + 2 * y],
];

fn cross(a: Place, b: Place, c: Place) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

fn doubled_area(places: &[Place], cycle: &[u32]) -> i64 {
    let corner = |i: usize| places[cycle[i % cycle.len()] as usize];
    (0..cycle.len()).map(|i| cross([0, 0], corner(i), corner(i + 1))).sum()
}

/// Whether two counterclockwise triangles have no inner point in common: an edge of one separates them.
fn apart(a: [Place; 3], b: [Place; 3]) -> bool {
    let separates = |a: [Place; 3], b: [Place; 3]| {
        (0..3).any(|i| b.iter().all(|&corner| cross(a[i], a[(i + 1) % 3], corner) <= 0))
    };
    separates(a, b) || separates(b, a)
}

/// How often an edge is run through from its lower to its higher vertex, less how often back.
fn boundary<'c>(cycles: impl IntoIterator<Item = &'c [u32]>) -> BTreeMap<[u32; 2], i32> {
    let mut count = BTreeMap::new();
    for cycle in cycles {
        for (i, &a) in cycle.iter().enumerate() {
            let b = cycle[(i + 1) % cycle.len()];
            *count.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
    }
    count.retain(|_, count| *count != 0);
    count
}

fn check_triangles(name: &str, places: &[Place], cycles: &[Vec<u32>], triangles: &[[u32; 3]]) {
    let at = |triangle: &[u32; 3]| triangle.map(|v| places[v as usize]);
    for (i, triangle) in triangles.iter().enumerate() {
        assert!(doubled_area(places, triangle) > 0, "{name}: {triangle:?} in {triangles:?}");
        let clash = triangles[..i].iter().find(|other| !apart(at(triangle), at(other)));
        assert_eq!(clash, None, "{name}: overlaps {triangle:?}");
    }
    let parts = boundary(triangles.iter().map(|triangle| &triangle[..]));
    let long = || cycles.iter().filter(|cycle| cycle.len() > 1);
    assert_eq!(parts, boundary(long().map(|cycle| &cycle[..])), "{name}");
    let sides: BTreeSet<[u32; 2]> =
        triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    for cycle in long() {
        for (i, &a) in cycle.iter().enumerate() {
            let side = [a, cycle[(i + 1) % cycle.len()]];
            assert!(sides.contains(&side), "{name}: {side:?} is no side of a triangle");
        }
    }
}

fn cut(places: &[Place], cycles: &[Vec<u32>], lift: Lift) -> Result<Vec<[u32; 3]>, HoleError> {
    let points: Vec<Point3> = places.iter().map(|&place| Point3::from_i64(lift(place))).collect();
    let holes: Vec<&[u32]> = cycles[1..].iter().map(|hole| &hole[..]).collect();
    triangulate_with_holes(&points, &cycles[0], &holes)
}

/// Cuts a facet in all planes, with its cycles begun anywhere and its holes in any order.
fn check(name: &str, places: &[Place], cycles: &[Vec<u32>], expected: usize) {
    for (plane, &lift) in PLANES.iter().enumerate() {
        let mut cycles = cycles.to_vec();
        for cycle in &mut cycles {
            let by = plane % cycle.len();
            cycle.rotate_left(by);
        }
        let holes = cycles.len() - 1;
        cycles[1..].rotate_left(if holes == 0 { 0 } else { plane % holes });
        let name = format!("{name} in plane {plane}");
        let triangles =
            cut(places, &cycles, lift).unwrap_or_else(|error| panic!("{name}: {error}: {cycles:?}"));
        check_triangles(&name, places, &cycles, &triangles);
        assert_eq!(triangles.len(), expected, "{name}");
    }
}

/// Cycles as lists of places; a place that occurs twice is one vertex.
fn indexed(cycles: &[&[Place]]) -> (Vec<Place>, Vec<Vec<u32>>) {
    let mut places: Vec<Place> = Vec::new();
    let mut index = |place: &Place| {
        let found = places.iter().position(|other| other == place);
        found.unwrap_or_else(|| {
            places.push(*place);
            places.len() - 1
        }) as u32
    };
    let cycles = cycles.iter().map(|cycle| cycle.iter().map(&mut index).collect()).collect();
    (places, cycles)
}

struct Row {
    name: &'static str,
    cycles: &'static [&'static [Place]],
    triangles: usize,
}

const fn row(name: &'static str, cycles: &'static [&'static [Place]], triangles: usize) -> Row {
    Row { name, cycles, triangles }
}

const SQUARE: &[Place] = &[[0, 0], [6, 0], [6, 6], [0, 6]];

const ROWS: &[Row] = &[
    row("no hole", &[SQUARE], 2),
    row("frame", &[SQUARE, &[[2, 2], [2, 4], [4, 4], [4, 2]]], 8),
    row(
        "two holes in a line",
        &[SQUARE, &[[1, 2], [1, 4], [2, 4], [2, 2]], &[[4, 2], [4, 4], [5, 4], [5, 2]]],
        14,
    ),
    row("a hole that touches the outer cycle", &[SQUARE, &[[0, 0], [2, 4], [4, 2]]], 5),
    row("a hole at two corners: two pieces", &[SQUARE, &[[0, 0], [2, 4], [6, 6], [4, 2]]], 4),
    row(
        "a hole at all corners",
        &[SQUARE, &[[0, 0], [1, 3], [0, 6], [3, 5], [6, 6], [5, 3], [6, 0], [3, 1]]],
        4,
    ),
    row(
        "holes that touch",
        &[SQUARE, &[[1, 3], [2, 4], [3, 3], [2, 2]], &[[3, 3], [4, 4], [5, 3], [4, 2]]],
        12,
    ),
    row(
        "holes in a ring, an island within",
        &[
            &[[-9, -9], [9, -9], [9, 9], [-9, 9]],
            &[[0, -3], [-2, -3], [-3, 0]],
            &[[-3, 0], [-3, 2], [0, 3]],
            &[[0, 3], [2, 3], [3, 0]],
            &[[3, 0], [3, -2], [0, -3]],
        ],
        14,
    ),
    row(
        "straight corners",
        &[&[[0, 0], [3, 0], [6, 0], [6, 6], [0, 6], [0, 3]], &[[2, 2], [2, 3], [2, 4], [4, 3]]],
        10,
    ),
    row("a slit", &[SQUARE, &[[2, 3], [4, 3]]], 6),
    row("a slit from the boundary", &[SQUARE, &[[0, 0], [2, 4]]], 4),
    row("slits that branch", &[SQUARE, &[[1, 3], [3, 3]], &[[3, 3], [5, 5]], &[[3, 3], [5, 1]]], 10),
    row("a cross of slits from corner to corner", &[SQUARE, &[[0, 0], [3, 3]], &[[3, 3], [6, 6]]], 4),
    row(
        "a slit along the boundary of a hole",
        &[SQUARE, &[[2, 2], [2, 4], [4, 4], [4, 2]], &[[2, 2], [1, 1]]],
        10,
    ),
    row("a point", &[SQUARE, &[[2, 3]]], 4),
    row("points in a line with the corners", &[SQUARE, &[[3, 3]], &[[2, 2]], &[[4, 4]]], 8),
    row("a point outside, and one at a corner", &[SQUARE, &[[9, 9]], &[[0, 0]]], 2),
    row("a keyhole", &[&[[0, 0], [6, 0], [6, 6], [0, 6], [0, 0], [2, 2], [2, 4], [4, 4], [4, 2], [2, 2]]], 8),
    row(
        "an outer cycle that touches itself within",
        &[&[[0, 0], [6, 0], [6, 6], [0, 6], [0, 0], [2, 4], [4, 2]]],
        5,
    ),
    row("two triangles at a vertex", &[&[[0, 0], [4, 1], [1, 4], [0, 0], [-4, -1], [-1, -4]]], 2),
];

#[test]
fn rows() {
    for row in ROWS {
        let (places, cycles) = indexed(row.cycles);
        check(row.name, &places, &cycles, row.triangles);
    }
}

#[test]
fn what_is_refused() {
    let outcome = |cycles: &[&[Place]]| {
        let (places, cycles) = indexed(cycles);
        let mut outcomes = PLANES.iter().map(|&lift| cut(&places, &cycles, lift));
        let first = outcomes.next().expect("there are planes");
        assert!(outcomes.all(|other| other.is_err() == first.is_err()), "{cycles:?}");
        first.expect_err("refused")
    };
    let tangled = |cycles: &[&[Place]]| {
        let HoleError::Tangled { edges } = outcome(cycles) else { panic!("{cycles:?}: {}", outcome(cycles)) };
        edges
    };
    let astray =
        |cycles: &[&[Place]]| assert!(matches!(outcome(cycles), HoleError::Astray { .. }), "{cycles:?}");
    // The vertices of the square are 0 to 3, those of the hole 4 and on.
    assert_eq!(tangled(&[SQUARE, &[[5, 2], [5, 4], [8, 3]]]), [[1, 2], [6, 4]]);
    tangled(&[SQUARE, &[[0, 2], [2, 4], [2, 2]]]); // touches the inside of an edge
    tangled(&[SQUARE, &[[0, 2], [0, 4], [2, 4], [2, 2]]]); // overlaps one
    tangled(&[SQUARE, &[[1, 3], [5, 3]], &[[3, 1], [3, 5]]]); // slits that cross
    tangled(&[SQUARE, &[[0, 0], [6, 0], [3, 3]], &[[0, 0], [6, 0], [3, 4]]]);
    tangled(&[&[[0, 0], [6, 0], [6, 6], [0, 6], [0, 0], [6, 0], [6, 6], [0, 6]]]); // twice around
    tangled(&[&[[0, 0], [4, 4], [6, 0], [0, 3], [6, 6]]]);
    astray(&[SQUARE, &[[2, 2], [4, 2], [4, 4], [2, 4]]]); // the wrong way round
    astray(&[SQUARE, &[[7, 7], [7, 8], [8, 8]]]); // outside
    astray(&[SQUARE, &[[1, 1], [1, 3], [3, 3], [3, 1]], &[[2, 2], [2, 4], [4, 4], [4, 2]]]); // overlaps
    astray(&[SQUARE, &[[1, 1], [1, 5], [5, 5], [5, 1]], &[[2, 2], [2, 4], [4, 4], [4, 2]]]); // in a hole
    astray(&[SQUARE, &[[7, 7], [8, 8]]]); // a slit outside
    astray(&[&[[0, 0], [6, 0], [6, 6], [9, 9], [6, 6], [0, 6]]]); // a spike
    for cycles in
        [&[&SQUARE[..2]] as &[&[Place]], &[&[[0, 0], [2, 2], [5, 5]]], &[&[[0, 0], [2, 2], [2, 0], [0, 2]]]]
    {
        assert_eq!(outcome(cycles), HoleError::NoArea);
    }
    let points = [[0, 0, 0], [9, 0, 0], [0, 9, 0], [1, 1, 0], [1, 2, 2], [2, 1, 0]].map(Point3::from_i64);
    let error = triangulate_with_holes(&points, &[0, 1, 2], &[&[3, 4, 5]]).expect_err("vertex 4 is above");
    assert_eq!(error.to_string(), "vertex 4 is off the plane of the facet, the square of the distance is 4");
}

/// Vertices at one place that are not one vertex: the hole at the corner of the outer cycle keeps its own.
#[test]
fn touching_without_a_common_vertex() {
    let places = [[0, 0], [6, 0], [6, 6], [0, 6], [0, 0], [2, 4], [4, 2]];
    for &lift in &PLANES {
        let cycles = [vec![0, 1, 2, 3], vec![4, 5, 6]];
        // On both sides of the hole the facet lies between an edge of vertex 0 and one of vertex 4.
        assert!(matches!(cut(&places, &cycles, lift), Err(HoleError::Tangled { .. })));
        let cycles = [vec![0, 1, 2, 3, 4, 5, 6]];
        let triangles = cut(&places, &cycles, lift).expect("the vertices are in order");
        check_triangles("two vertices", &places, &cycles, &triangles);
        assert_eq!(triangles.len(), 5);
    }
}

/// A facet as files without holes write one with holes: the mesh is cut in the same way.
#[test]
fn keyholes_in_meshes() {
    let lift = PLANES[1];
    let places = [[0, 0], [6, 0], [6, 6], [0, 6], [2, 2], [2, 4], [4, 4], [4, 2]];
    let points: Vec<[i64; 3]> = places.iter().map(|&place| lift(place)).collect();
    let keyhole = [0, 1, 2, 3, 0, 4, 5, 6, 7, 4];
    for turn in 0..keyhole.len() {
        let mut cycle = keyhole;
        cycle.rotate_left(turn);
        let cut = mesh(&points, &[&cycle]).triangulated().expect("the boundary is in order");
        let triangles: Vec<[u32; 3]> =
            cut.facets.iter().map(|cycle| cycle.try_into().expect("a triangle")).collect();
        check_triangles("keyhole", &places, &[cycle.to_vec()], &triangles);
        assert_eq!(triangles.len(), 8);
    }
    // Two lobes at a vertex are not one facet.
    let lobes = mesh(&[[0, 0, 0], [4, 1, 0], [1, 4, 0], [-4, -1, 0], [-1, -4, 0]], &[&[0, 1, 2, 0, 3, 4]]);
    assert_eq!(lobes.triangulated().map(|_| ()), Err(TriangulateError::Tangled { facet: 0 }));
}

/// Many corners: combs within combs, and a long time only if a step is not logarithmic.
#[test]
fn a_grid_of_many_holes() {
    const N: i64 = 60;
    let mut places: Vec<Place> = vec![[0, 0], [3 * N, 0], [3 * N, 3 * N], [0, 3 * N]];
    let mut cycles: Vec<Vec<u32>> = vec![vec![0, 1, 2, 3]];
    for x in 0..N {
        for y in 0..N {
            let first = places.len() as u32;
            places.extend([[1, 1], [1, 2], [2, 2], [2, 1]].map(|[u, v]| [3 * x + u, 3 * y + v]));
            cycles.push((first..first + 4).collect());
        }
    }
    let triangles = cut(&places, &cycles, PLANES[1]).expect("holes are in order");
    assert_eq!(triangles.len() as i64, 6 * N * N + 2);
    let areas: Vec<i64> = triangles.iter().map(|triangle| doubled_area(&places, triangle)).collect();
    assert!(areas.iter().all(|&area| area > 0));
    assert_eq!(areas.iter().sum::<i64>(), 2 * (9 - 1) * N * N);
    let whole = PolygonMesh { points: Vec::new(), facets: Facets::new() };
    assert!(whole.triangulated().is_ok_and(|mesh| mesh.facets.is_empty()));
}
