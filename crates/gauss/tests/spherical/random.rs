//! Random polytopes with small coordinates, so that degenerate cases are frequent; and wide ones.

use crate::features::{check, check_maps, check_sum, identifications};
use polytope::Polytope;
use splitstar_gauss::SphericalGaussianMap;
use testkit::Rng;

fn random(rng: &mut Rng) -> Polytope {
    let dimension = if rng.one_in(2) { 3 } else { rng.below(4) as u8 };
    let range = rng.between(1, 3) as i64;
    testkit::hull_of_dimension(rng, dimension, range)
}

#[test]
fn maps_of_small_polytopes() {
    for seed in 0..150 {
        check_maps(&random(&mut Rng::new(seed)), &format!("seed {seed}"));
    }
}

#[test]
fn sums_of_small_polytopes() {
    for seed in 1000..1300 {
        let mut rng = Rng::new(seed);
        let (p, q) = (random(&mut rng), random(&mut rng));
        check_sum(&p, &q, &format!("seed {seed}"));
    }
}

#[test]
fn sums_of_three_and_reflections() {
    for seed in 2000..2150 {
        let mut rng = Rng::new(seed);
        let polytopes = [(); 3].map(|()| random(&mut rng));
        let traits = identifications().swap_remove(rng.below(5) as usize);
        let maps = polytopes.each_ref().map(|p| SphericalGaussianMap::of_polytope_with(p, traits.clone()));
        let expected = polytope::minkowski_sum(&polytopes.each_ref());
        let sum = SphericalGaussianMap::minkowski_sum_all(&maps.each_ref());
        check(&sum, &expected, &format!("seed {seed}"));
        let [a, b, c] = &maps;
        check(&a.minkowski_sum(b).minkowski_sum(c), &expected, &format!("seed {seed}, pairwise"));
        let reflected = maps.each_ref().map(SphericalGaussianMap::reflected);
        let sum = SphericalGaussianMap::minkowski_sum_all(&reflected.each_ref());
        check(&sum, &expected.reflected(), &format!("seed {seed}, reflected"));
    }
}

#[test]
fn wide_polytopes() {
    for seed in 3000..3020 {
        let mut rng = Rng::new(seed);
        for bits in [20, 31, 62, 100] {
            let p = testkit::wide_hull(&mut rng, 8, bits);
            let q = testkit::mixed_width_hull(&mut rng, 8, 3, bits);
            let r = testkit::weighted_hull(&mut rng, 8, 3, bits);
            check_sum(&p, &q, &format!("seed {seed}, {bits} bits"));
            check_sum(&q, &r, &format!("seed {seed}, {bits} bits, weighted"));
            check_maps(&r, &format!("seed {seed}, {bits} bits, weighted"));
        }
    }
}
