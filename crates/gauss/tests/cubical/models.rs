//! The models of the repository, their sums, and the sums that other programs get wrong.

use crate::features::{check, check_map, check_sum};
use polytope::Polytope;
use splitstar_gauss::CubicalGaussianMap;
use testkit::{SumRow, assert_same, hull, model, model_names, rotation};

const QUATERNIONS: [[i64; 4]; 3] = [[1, 1, 1, 1], [3, 0, 1, 0], [7, -3, 2, 1]];

#[test]
fn every_model() {
    for name in model_names("convex") {
        check_map(&model(&name), &name);
    }
    for name in model_names("maxfacets") {
        let polytope = model(&name);
        check(&CubicalGaussianMap::of_polytope(&polytope), &polytope, &name);
    }
}

fn sum_of(summands: &[Polytope]) -> CubicalGaussianMap {
    let maps: Vec<_> = summands.iter().map(CubicalGaussianMap::of_polytope).collect();
    CubicalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>())
}

#[test]
fn every_sum_of_the_table() {
    let mut rows = 0;
    for row in SumRow::all() {
        let sum = sum_of(&row.summands);
        let expected = polytope::minkowski_sum(&row.summands.iter().collect::<Vec<_>>());
        row.check(&sum.make_polytope(), "by the map");
        check(&sum, &expected, &row.name());
        let swapped: Vec<Polytope> = row.summands.iter().rev().cloned().collect();
        assert_same(&sum_of(&swapped).make_polytope(), &expected, row.name());
        rows += 1;
    }
    assert!(rows > 36, "{rows}");
}

#[test]
fn every_sum_of_the_table_turned() {
    for row in SumRow::all() {
        let sum = polytope::minkowski_sum(&row.summands.iter().collect::<Vec<_>>());
        for (i, quaternion) in QUATERNIONS.into_iter().enumerate() {
            let turn = rotation(quaternion);
            let turned: Vec<Polytope> = row.summands.iter().map(|p| p.transformed(&turn)).collect();
            let (map, expected) = (sum_of(&turned), sum.transformed(&turn));
            let context = format!("{}, turned by {quaternion:?}", row.name());
            let made = map.make_polytope();
            row.check(&made, &context);
            assert!(made.same_set(&expected), "{context}");
            // The last turn is the one about an axis that is none of the models.
            if i + 1 == QUATERNIONS.len() {
                check(&map, &expected, &context);
            }
        }
    }
}

/// CGAL 5.6 gives wrong vertices here.
#[test]
fn pentagonal_hexecontahedron_and_truncated_icosidodecahedron() {
    let [p, q] =
        ["convex/pentagonal_hexecontahedron.xoff", "convex/truncated_icosidodecahedron.xoff"].map(model);
    check_sum(&p, &q, "pentagonal hexecontahedron + truncated icosidodecahedron");
}

/// CGAL 5.6 crashes: an arc passes through a pole.
#[test]
fn an_arc_through_a_pole() {
    let p = hull(&[
        [1, -2, 2],
        [-1, -2, -2],
        [-1, -2, -1],
        [-1, 1, 2],
        [-2, -2, -2],
        [2, -2, -1],
        [-1, -2, 1],
        [0, -2, 1],
    ]);
    check_map(&p, "an arc through a pole");
    check_sum(&p, &model("convex/cube.off"), "an arc through a pole, and the cube");
}
