//! Polytopes of small coordinates, of all dimensions.

use crate::features::{check_map, check_sum};
use testkit::{Rng, hull_of_dimension, mixed_width_hull, weighted_hull};

#[test]
fn polytopes_of_all_dimensions() {
    let mut rng = Rng::new(0x0c0b_1ca1);
    for round in 0..400 {
        let context = format!("seed {}", rng.state());
        let range = 1 + round % 3;
        let [p, q] = [0, 1].map(|_| {
            let dimension = rng.below(4) as u8;
            hull_of_dimension(&mut rng, dimension, range)
        });
        check_map(&p, &context);
        check_sum(&p, &q, &context);
    }
}

#[test]
fn wide_and_weighted_polytopes() {
    let mut rng = Rng::new(0x0c0b_1ca2);
    for round in 0..40 {
        let context = format!("seed {}", rng.state());
        let bits = 20 + 10 * (round % 6);
        let p = mixed_width_hull(&mut rng, 8, 9, bits);
        let q = weighted_hull(&mut rng, 8, 9, bits);
        check_map(&p, &context);
        check_map(&q, &context);
        check_sum(&p, &q, &context);
    }
}
