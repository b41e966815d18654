//! Polytopes of all dimensions, with normals at the poles and on the identification.

use crate::features::{check, check_maps, check_sum, hull, identification, point};
use arrangement::Editor;
use exact::{Point3, Rational};
use polytope::Polytope;
use splitstar_gauss::SphericalGaussianMap;

fn rows() -> Vec<(&'static str, Polytope)> {
    let cube: Vec<[i64; 3]> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2]).collect();
    vec![
        ("origin", point([0, 0, 0])),
        ("point", point([3, -1, 2])),
        ("segment along x", hull(&[[0, 0, 0], [2, 0, 0]])),
        ("the opposite segment", hull(&[[0, 0, 0], [-1, 0, 0]])),
        ("segment along y", hull(&[[0, 0, 0], [0, 1, 0]])),
        ("segment along z", hull(&[[0, 0, 1], [0, 0, -1]])),
        ("segment with a circle through poles", hull(&[[0, 0, 0], [1, 2, 0]])),
        ("segment", hull(&[[1, 0, 0], [2, 3, -1]])),
        ("square, normals at the poles", hull(&[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])),
        ("square, normals on x", hull(&[[0, 0, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1]])),
        ("square, normals on y", hull(&[[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]])),
        ("triangle", hull(&[[0, 0, 0], [3, 0, 1], [1, 2, -1]])),
        ("triangle on the identification", hull(&[[0, 0, 0], [1, 0, 1], [1, 2, 1]])),
        ("cube", hull(&cube)),
        ("octahedron", hull(&[[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])),
        ("tetrahedron", hull(&[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])),
        ("tetrahedron of the cube", hull(&[[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])),
        ("wedge", hull(&[[0, 0, 0], [2, 0, 0], [0, 3, 0], [2, 3, 0], [1, 0, 1], [1, 3, 1]])),
        ("pyramid", hull(&[[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0], [0, 0, 2]])),
        ("pyramid along x", hull(&[[0, 1, 1], [0, -1, 1], [0, -1, -1], [0, 1, -1], [2, 0, 0]])),
    ]
}

#[test]
fn maps() {
    for (name, polytope) in rows() {
        check_maps(&polytope, name);
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
        let map = SphericalGaussianMap::of_polytope(&p);
        let doubled = polytope::minkowski_sum(&[&p, &p]);
        check(&map.minkowski_sum(&map), &doubled, &format!("{name}, twice"));
        let symmetric = polytope::minkowski_sum(&[&p, &p.reflected()]);
        check(&map.minkowski_sum(&map.reflected()), &symmetric, &format!("{name} and its reflection"));
        let opposite = SphericalGaussianMap::of_polytope_with(&p, map.arrangement().traits().reflected());
        check(
            &map.minkowski_sum(&opposite.reflected()),
            &symmetric,
            &format!("{name}, no new identification"),
        );
    }
}

#[test]
fn sums_of_many() {
    let rows = rows();
    let maps: Vec<_> = rows.iter().map(|(_, p)| SphericalGaussianMap::of_polytope(p)).collect();
    for first in 0..rows.len() {
        for count in 0..4 {
            let chosen: Vec<usize> = (0..count).map(|i| (first + 7 * i) % rows.len()).collect();
            let summands: Vec<&Polytope> = chosen.iter().map(|&i| &rows[i].1).collect();
            let operands: Vec<&SphericalGaussianMap> = chosen.iter().map(|&i| &maps[i]).collect();
            let sum = SphericalGaussianMap::minkowski_sum_all(&operands);
            check(&sum, &polytope::minkowski_sum(&summands), &format!("{chosen:?}"));
        }
    }
    let all = SphericalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>());
    let expected = polytope::minkowski_sum(&rows.iter().map(|(_, p)| p).collect::<Vec<_>>());
    check(&all, &expected, "all");
    let half = maps.len() / 2;
    let [a, b] = [&maps[..half], &maps[half..]]
        .map(|part| SphericalGaussianMap::minkowski_sum_all(&part.iter().collect::<Vec<_>>()));
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
    check_maps(&p, "wide");
    check_sum(&p, &q, "wide");
    check_sum(&p, &q.reflected(), "wide, reflected");
}

/// Without arcs, the only face need not have the number 0, and points of faces that are no more mean nothing.
#[test]
fn a_map_that_was_edited_is_reidentified() {
    let [p, q] = [[1, 2, 3], [4, 4, 4]];
    let map = SphericalGaussianMap::of_polytope(&hull(&[p, q]));
    let (arrangement, points) = map.into_parts();
    let mut editor = Editor::new(arrangement);
    let edges: Vec<_> = editor.dcel().edges().collect();
    editor.remove_edges(&edges);
    let (arrangement, ()) = editor.finish();
    assert_eq!((arrangement.dcel().face_count(), arrangement.dcel().face_bound()), (1, 2));
    let face = arrangement.dcel().faces().next().expect("an arrangement has a face");
    let expected = Polytope::point(points[face.index()].clone());
    let others = Point3::from_i64([100, 100, 100]);
    let points = (0..2).map(|i| if i == face.index() { points[i].clone() } else { others.clone() }).collect();
    let edited = SphericalGaussianMap::try_from_parts(arrangement, points).expect("the map of a point");
    check(&edited, &expected, "edited");
    let again = edited.reidentified(identification([2, 3]));
    check(&again, &expected, "edited and identified anew");
    check(&again.minkowski_sum(&edited), &polytope::minkowski_sum(&[&expected, &expected]), "its double");
}
