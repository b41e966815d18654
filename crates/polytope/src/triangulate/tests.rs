//! Polygons of the plane, cut; the area is the oracle.

use super::*;

/// A facet in the plane `x + 2 y + 5 z = 0`, over points of the plane.
fn tilted(corners: &[[i64; 2]]) -> PolygonMesh {
    let lift = |&[x, y]: &[i64; 2]| Point3::from_i64([5 * x, 5 * y, -x - 2 * y]);
    let mut facets = Facets::new();
    facets.push(&(0..corners.len() as u32).collect::<Vec<_>>());
    PolygonMesh { points: corners.iter().map(lift).collect(), facets }
}

fn doubled_area(corners: &[[i64; 2]], cycle: &[u32]) -> i64 {
    let [first, rest @ ..] = cycle else { return 0 };
    let corner = |v: u32| corners[v as usize];
    let [x, y] = corner(*first);
    let cross = |a: [i64; 2], b: [i64; 2]| (a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x);
    rest.windows(2).map(|pair| cross(corner(pair[0]), corner(pair[1]))).sum()
}

/// Cuts the polygon from every first corner and in both orientations.
fn check(name: &str, corners: &[[i64; 2]]) {
    let n = corners.len();
    for turn in 0..n {
        let mut corners: Vec<[i64; 2]> = (0..n).map(|i| corners[(i + turn) % n]).collect();
        for _ in 0..2 {
            let cut = tilted(&corners).triangulated().unwrap_or_else(|e| panic!("{name}: {e}"));
            let whole = doubled_area(&corners, &(0..n as u32).collect::<Vec<_>>());
            let parts: Vec<i64> = cut.facets.iter().map(|t| doubled_area(&corners, t)).collect();
            assert_eq!(parts.len(), n - 2, "{name}");
            // Parts of the same sign that add up cover the polygon without overlap.
            assert!(parts.iter().all(|part| part.signum() == whole.signum()), "{name}: {parts:?}");
            assert_eq!(parts.iter().sum::<i64>(), whole, "{name}");
            assert!(cut.facets.iter().all(|cycle| cycle.len() == 3), "{name}");
            corners.reverse();
        }
    }
}

#[test]
fn simple_polygons() {
    check("square", &[[0, 0], [1, 0], [1, 1], [0, 1]]);
    check("L", &[[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]);
    check("arrow", &[[0, 0], [2, 1], [0, 2], [1, 1]]);
    check("straight corners", &[[0, 0], [1, 0], [2, 0], [3, 0], [3, 3], [2, 2], [1, 1]]);
    check("straight corners all round", &[[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]]);
    check(
        "cross",
        &[[1, 0], [2, 0], [2, 1], [3, 1], [3, 2], [2, 2], [2, 3], [1, 3], [1, 2], [0, 2], [0, 1], [1, 1]],
    );
    check(
        "spiral",
        &[
            [0, 0],
            [7, 0],
            [7, 7],
            [2, 7],
            [2, 3],
            [4, 3],
            [4, 5],
            [5, 5],
            [5, 2],
            [1, 2],
            [1, 8],
            [8, 8],
            [8, -1],
            [0, -1],
        ],
    );
    let comb: Vec<[i64; 2]> =
        (0..40).map(|i| [i, if i % 2 == 0 { 0 } else { 9 }]).chain([[39, -1], [0, -1]]).collect();
    check("comb", &comb);
    // The lexicographic order of the corners has one lowest, and still a corner is reflex.
    check("dart", &[[0, 0], [9, 1], [4, 2], [9, 9]]);
}

#[test]
fn what_winds_twice_is_not_convex() {
    // A pentagram turns left at every corner.
    let star = tilted(&[[0, 10], [6, -8], [-10, 3], [10, 3], [-6, -8]]);
    assert_eq!(star.triangulated().map(|_| ()), Err(TriangulateError::Tangled { facet: 0 }));
}

#[test]
fn no_area() {
    let flat = tilted(&[[0, 0], [1, 1], [2, 2], [3, 3]]);
    assert_eq!(flat.triangulated().map(|_| ()), Err(TriangulateError::NoArea { facet: 0 }));
    let balanced = tilted(&[[0, 0], [2, 2], [2, 0], [0, 2]]);
    assert_eq!(balanced.triangulated().map(|_| ()), Err(TriangulateError::NoArea { facet: 0 }));
}

#[test]
fn a_facet_that_is_almost_planar_is_cut_by_its_outline() {
    let mut mesh = tilted(&[[0, 0], [30, 0], [30, 10], [10, 10], [10, 20], [0, 20]]);
    mesh.points[3] = Point3::from_rationals(
        &["50", "50", "-30.0000000000000003"].map(|text| text.parse().expect("a number")),
    );
    let cut = mesh.triangulated().unwrap();
    let corners = [[0, 0], [30, 0], [30, 10], [10, 10], [10, 20], [0, 20]];
    assert!(cut.facets.iter().all(|triangle| doubled_area(&corners, triangle) > 0));
    assert_eq!(cut.facets.iter().map(|triangle| doubled_area(&corners, triangle)).sum::<i64>(), 800);
}

/// A parabola, and back just above it: the corners above are reflex, and only the ends have ears.
fn parabola(n: i64) -> Vec<[i64; 2]> {
    let half = n / 4;
    let below = (-half..half).map(|x| [x, x * x]);
    below.chain((-half..half).rev().map(|x| [x, x * x + 1])).collect()
}

#[test]
fn a_parabola_of_1000_corners_takes_few_tests() {
    let corners = parabola(1000);
    assert_eq!(corners.len(), 1000);
    let mesh = tilted(&corners);
    let before = exact::tier::thread_counts();
    let cut = mesh.triangulated().unwrap();
    let tests = (exact::tier::thread_counts() - before).total();
    let parts: Vec<i64> = cut.facets.iter().map(|t| doubled_area(&corners, t)).collect();
    assert_eq!(parts.len(), 998);
    assert!(parts.iter().all(|&part| part > 0));
    // A strip of height 1 and width 499.
    assert_eq!(parts.iter().sum::<i64>(), 2 * 499);
    // k = 1000 corners: k log k, several times.
    assert!(tests > 1_000, "the tests are counted");
    assert!(tests < 100_000, "{tests} exact tests");
}

/// All strips over five abscissae whose two sides are zigzags of height 1, straight corners included.
#[test]
fn all_small_strips() {
    for bits in 0..1 << 10 {
        let bit = |i: i64| (bits >> i) & 1;
        let below = (0..5).map(|x| [x, bit(x)]);
        let corners: Vec<[i64; 2]> = below.chain((0..5).rev().map(|x| [x, 2 + bit(5 + x)])).collect();
        check(&format!("strip {bits:010b}"), &corners);
    }
}

/// The directions along which corners are sorted depend on the axis of the normal.
#[test]
fn planes_along_the_axes() {
    let corners =
        [[0, 0], [7, 0], [7, 7], [2, 7], [2, 3], [4, 3], [4, 5], [5, 5], [5, 2], [1, 2], [1, 8], [0, 8]];
    let planes: [fn([i64; 2]) -> [i64; 3]; 6] = [
        |[x, y]| [3, x, y],
        |[x, y]| [x, 3, y],
        |[x, y]| [x, y, 3],
        |[x, y]| [x, -x, y],
        |[x, y]| [x, y, -x],
        |[x, y]| [y, x, -x],
    ];
    for (which, lift) in planes.iter().enumerate() {
        let mut mesh = tilted(&corners);
        mesh.points = corners.iter().map(|&corner| Point3::from_i64(lift(corner))).collect();
        let cut = mesh.triangulated().unwrap();
        let parts: Vec<i64> = cut.facets.iter().map(|t| doubled_area(&corners, t)).collect();
        assert!(parts.iter().all(|&part| part > 0), "plane {which}: {parts:?}");
    }
}
