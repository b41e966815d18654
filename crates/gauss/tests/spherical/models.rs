//! The models of the repository, their sums, and the sums that other programs get wrong.

use crate::features::{check, check_maps, check_sum, hull, identifications};
use polytope::Polytope;
use splitstar_gauss::SphericalGaussianMap;
use testkit::{SumRow, assert_same, model, model_names, rotation};

const QUATERNIONS: [[i64; 4]; 3] = [[1, 1, 1, 1], [3, 0, 1, 0], [7, -3, 2, 1]];

#[test]
fn every_model() {
    for name in model_names("convex") {
        check_maps(&model(&name), &name);
    }
    for name in model_names("maxfacets") {
        let polytope = model(&name);
        check(&SphericalGaussianMap::of_polytope(&polytope), &polytope, &name);
    }
}

fn sum_of(summands: &[Polytope]) -> SphericalGaussianMap {
    let maps: Vec<_> = summands.iter().map(SphericalGaussianMap::of_polytope).collect();
    SphericalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>())
}

#[test]
fn every_sum_of_the_table() {
    for row in SumRow::all() {
        let sum = sum_of(&row.summands);
        let expected = polytope::minkowski_sum(&row.summands.iter().collect::<Vec<_>>());
        row.check(&sum.make_polytope(), "by the map");
        check(&sum, &expected, &row.name());
        let swapped: Vec<Polytope> = row.summands.iter().rev().cloned().collect();
        let swapped = sum_of(&swapped);
        assert_eq!(swapped.counts_with_splits(), sum.counts_with_splits(), "{}", row.name());
        assert_same(&swapped.make_polytope(), &expected, row.name());
    }
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

#[test]
fn every_sum_of_the_table_with_other_identifications() {
    for row in SumRow::all() {
        for traits in identifications().into_iter().skip(1) {
            let context = format!("identification {}", traits.identification());
            let maps: Vec<_> = row
                .summands
                .iter()
                .map(|p| SphericalGaussianMap::of_polytope_with(p, traits.clone()))
                .collect();
            let sum = SphericalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>());
            assert_eq!(*sum.arrangement().traits(), traits);
            row.check(&sum.make_polytope(), &context);
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
    check_maps(&p, "an arc through a pole");
    check_sum(&p, &model("convex/cube.off"), "an arc through a pole, and the cube");
}

/// Two of the family in chapter 4 of the thesis have 4mn - 9m - 9n + 26 facets.
#[test]
fn the_maximal_family() {
    for m in [4, 5, 7, 11] {
        for n in [4, 7, 21] {
            let p = model(&format!("maxfacets/p{m}.off"));
            let q = model(&format!("maxfacets/p{n}_rot90y.off"));
            check_sum(&p, &q, &format!("{m} and {n}"));
            let sum = sum_of(&[p, q]);
            assert_eq!(sum.counts().facets, 4 * m * n + 26 - 9 * (m + n), "{m} and {n}");
        }
    }
}
