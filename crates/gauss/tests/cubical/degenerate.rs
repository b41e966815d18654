//! Polytopes of all dimensions, with normals on edges and at corners of the cube, and arcs along its edges.

use crate::features::{check, check_map, check_sum};
use exact::{Point3, Rational};
use polytope::Polytope;
use splitstar_gauss::CubicalGaussianMap;
use testkit::hull;

fn rows() -> Vec<(&'static str, Polytope)> {
    let cube: Vec<[i64; 3]> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2]).collect();
    let cuboctahedron: Vec<[i64; 3]> = (0..12_i64)
        .map(|i| {
            let (axis, s, t) = ((i / 4) as usize, 2 * (i & 1) - 1, 2 * (i >> 1 & 1) - 1);
            let mut p = [0; 3];
            (p[(axis + 1) % 3], p[(axis + 2) % 3]) = (s, t);
            p
        })
        .collect();
    let dodecahedron: Vec<[i64; 3]> = cube
        .iter()
        .map(|p| p.map(|c| 2 * c - 1))
        .chain((0..6).map(|i| {
            let mut p = [0; 3];
            p[i / 2] = if i % 2 == 0 { 2 } else { -2 };
            p
        }))
        .collect();
    vec![
        ("origin", hull(&[[0, 0, 0]])),
        ("point", hull(&[[3, -1, 2]])),
        ("segment along x", hull(&[[0, 0, 0], [2, 0, 0]])),
        ("segment whose circle runs along edges of the cube", hull(&[[0, 0, 0], [1, -1, 0]])),
        ("segment whose circle runs through six sides", hull(&[[0, 0, 0], [1, 1, 1]])),
        ("segment whose circle runs through two corners", hull(&[[0, 0, 0], [1, 2, -3]])),
        ("segment", hull(&[[1, 0, 0], [2, 3, -1]])),
        ("square, normals in the middle of sides", hull(&[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])),
        ("triangle, normals at corners", hull(&[[1, 0, 0], [0, 1, 0], [0, 0, 1]])),
        ("rectangle, normals on edges of the cube", hull(&[[0, 0, 0], [1, -1, 0], [1, -1, 3], [0, 0, 3]])),
        ("triangle", hull(&[[0, 0, 0], [3, 0, 1], [1, 2, -1]])),
        ("cube", hull(&cube)),
        (
            "octahedron, normals at all corners",
            hull(&[[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]),
        ),
        ("tetrahedron, empty sides", hull(&[[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])),
        ("tetrahedron", hull(&[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])),
        ("cuboctahedron", hull(&cuboctahedron)),
        ("rhombic dodecahedron, normals on all edges of the cube", hull(&dodecahedron)),
        ("wedge", hull(&[[0, 0, 0], [2, 0, 0], [0, 3, 0], [2, 3, 0], [1, 0, 1], [1, 3, 1]])),
        ("pyramid", hull(&[[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0], [0, 0, 2]])),
    ]
}

#[test]
fn maps() {
    for (name, polytope) in rows() {
        check_map(&polytope, name);
    }
}

#[test]
fn sums_of_all_pairs() {
    for (a, p) in rows() {
        for (b, q) in rows() {
            check_sum(&p, &q, &format!("{a} + {b}"));
        }
    }
}

#[test]
fn sums_with_themselves_and_their_reflections() {
    for (name, p) in rows() {
        let map = CubicalGaussianMap::of_polytope(&p);
        let doubled = polytope::minkowski_sum(&[&p, &p]);
        check(&map.minkowski_sum(&map), &doubled, &format!("{name}, twice"));
        let symmetric = polytope::minkowski_sum(&[&p, &p.reflected()]);
        check(&map.minkowski_sum(&map.reflected()), &symmetric, &format!("{name} and its reflection"));
    }
}

#[test]
fn sums_of_many() {
    let rows = rows();
    let maps: Vec<_> = rows.iter().map(|(_, p)| CubicalGaussianMap::of_polytope(p)).collect();
    for first in 0..rows.len() {
        for count in 0..4 {
            let chosen: Vec<usize> = (0..count).map(|i| (first + 7 * i) % rows.len()).collect();
            let summands: Vec<&Polytope> = chosen.iter().map(|&i| &rows[i].1).collect();
            let operands: Vec<&CubicalGaussianMap> = chosen.iter().map(|&i| &maps[i]).collect();
            let sum = CubicalGaussianMap::minkowski_sum_all(&operands);
            check(&sum, &polytope::minkowski_sum(&summands), &format!("{chosen:?}"));
        }
    }
    let all = CubicalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>());
    let expected = polytope::minkowski_sum(&rows.iter().map(|(_, p)| p).collect::<Vec<_>>());
    check(&all, &expected, "all");
    let half = maps.len() / 2;
    let [a, b] = [&maps[..half], &maps[half..]]
        .map(|part| CubicalGaussianMap::minkowski_sum_all(&part.iter().collect::<Vec<_>>()));
    check(&a.minkowski_sum(&b), &expected, "a sum of sums");
    check(&a.reflected().minkowski_sum(&b.reflected()), &expected.reflected(), "a sum of reflections");
}

#[test]
fn wide_rational_points_stay_exact() {
    let coordinate = |n: i64, d: i64| Rational::new(n.into(), d.into()).expect("not divided by zero");
    let big = i64::MAX / 3;
    let points = |d: i64| {
        let rows = [[0, 0, 0], [big, 1, 2], [3, big - 1, 5], [7, 11, big - 2], [big, big, big]];
        let rational = |p: [i64; 3]| Point3::from_rationals(&p.map(|n| coordinate(n, d)));
        polytope::convex_hull(&rows.map(rational)).expect("there are points")
    };
    let (p, q) = (points(1_000_003), points(998_244_353));
    check_map(&p, "wide");
    check_sum(&p, &q, "wide");
    check_sum(&p, &q.reflected(), "wide, reflected");
}
