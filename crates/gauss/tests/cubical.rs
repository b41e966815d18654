//! Gaussian maps on the cube against sums by other methods.

use polytope::{Polytope, minkowski_sum};
use splitstar_gauss::CubicalGaussianMap;
use testkit::{Rng, SumRow, assert_same, hull_of_dimension, model, rotation};

fn map_of(polytope: &Polytope) -> CubicalGaussianMap {
    let map = CubicalGaussianMap::of_polytope(polytope);
    assert_eq!(map.arrangement().check_valid(), []);
    assert_eq!(map.counts(), polytope.counts());
    map
}

#[track_caller]
fn assert_round_trip(polytope: &Polytope, context: &str) {
    let map = map_of(polytope);
    assert_same(&map.make_polytope(), polytope, context);
    let reflected = map.reflected();
    assert_eq!(reflected.arrangement().check_valid(), [], "{context}");
    assert_same(&reflected.make_polytope(), &polytope.reflected(), context);
}

#[test]
fn every_sum_of_the_table() {
    let mut rows = 0;
    for row in SumRow::all() {
        let maps: Vec<_> = row.summands.iter().map(map_of).collect();
        let sum = CubicalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>());
        assert_eq!(sum.arrangement().check_valid(), [], "{}", row.name());
        assert_eq!(sum.counts().to_array(), row.counts, "{}", row.name());
        let polytope = sum.make_polytope();
        row.check(&polytope, "as it stands");
        assert_same(&polytope, &minkowski_sum(&row.summands.iter().collect::<Vec<_>>()), row.name());
        rows += 1;
    }
    assert!(rows > 36, "{rows}");
}

#[test]
fn polytopes_of_all_dimensions() {
    let mut rng = Rng::new(0x0c0b_1ca1);
    for round in 0..400 {
        let seed = rng.state();
        let range = 1 + round % 3;
        let [p, q] = [0, 1].map(|_| {
            let dimension = rng.below(4) as u8;
            hull_of_dimension(&mut rng, dimension, range)
        });
        let context = format!("seed {seed}");
        assert_round_trip(&p, &context);
        let [red, blue] = [&p, &q].map(map_of);
        let expected = minkowski_sum(&[&p, &q]);
        for sum in [red.minkowski_sum(&blue), blue.minkowski_sum(&red)] {
            assert_eq!(sum.arrangement().check_valid(), [], "{context}");
            assert_eq!(sum.counts(), expected.counts(), "{context}");
            assert_same(&sum.make_polytope(), &expected, &context);
        }
    }
}

#[test]
fn counts_of_the_thesis() {
    // Table 3.3: vertices, halfedges and faces of all six sides.
    for (name, counts) in [("convex/dioctagonal_pyramid.off", [97, 280, 55])] {
        let map = map_of(&model(name));
        let stored = map.arrangement().counts_with_artificial();
        assert_eq!([stored.vertices, 2 * stored.edges, stored.faces], counts, "{name}");
    }
}

#[test]
fn turned() {
    let turn = rotation([2, 1, -5, 4]);
    for row in SumRow::all().iter().take(12) {
        let summands: Vec<_> = row.summands.iter().map(|p| p.transformed(&turn)).collect();
        let maps: Vec<_> = summands.iter().map(map_of).collect();
        let sum = CubicalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>());
        row.check(&sum.make_polytope(), "turned");
    }
}
