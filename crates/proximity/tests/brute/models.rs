//! Models with hundreds of features against brute force, each with a partner that is turned.

use crate::check::{Expected, Subject};
use crate::distance::squared_distance_of_many;
use crate::number::plus;
use crate::placements::{PARTS, placement, rational};
use crate::planes::{Brute, Place};
use crate::random::direction;
use crate::solid::{Solid, common_scale};
use exact::Integer;
use splitstar_proximity::{Pair, RelativePlacement, Translation};
use testkit::{Rng, model};

/// Placements of each pair.
const COUNT: usize = 100;
const MANY: usize = 100;

fn compare(names: [&str; 2]) {
    let [p, q] = names.map(|name| model(&format!("convex/{name}")));
    let scale = common_scale(&p, &q) * Integer::from(PARTS);
    let brute = Brute::<Integer>::new(&p, &q, scale.clone());
    let solids = [&p, &q].map(|polytope| Solid::<Integer>::new(polytope, &scale));
    let seed = 7;
    println!("{names:?}: seed {seed}, {} candidates", brute.candidates.len());
    let mut rng = Rng::new(seed);
    let (sum, pair) = (RelativePlacement::new(&p, &q), Pair::new(&p, &q));
    let mut hints = [None; 2];
    let mut places = [0_usize; 3];
    for number in 0..COUNT {
        let made = placement(&brute, number, &mut rng);
        let direction = direction(&mut rng);
        let s = Translation::new(&rational(&made.s, &scale));
        let case = format!("{names:?}, placement {number}: {made:?} over {scale}");
        let distance = || {
            let vertices = brute.q.vertices.iter().map(|vertex| plus(vertex, &made.s)).collect();
            squared_distance_of_many(&brute.p, &Solid { vertices, ..brute.q.clone() })
        };
        let expected = Expected::new(&brute, &made.s, direction, distance);
        places[expected.place as usize] += 1;
        let subjects = [Subject::Sum(&sum), Subject::Pair(&pair, None)];
        subjects[number % 2].check_membership(&solids, &scale, &s, &expected, hints[number % 2], &case);
        for (subject, hint) in subjects.iter().zip(&mut hints) {
            *hint = Some(subject.check(&s, direction, &expected, *hint, &case));
            subject.check_direction(&brute, &made.s, &s, &case);
        }
        // To compare all edges takes long.
        if brute.p.edges.len() < MANY || number == 2 {
            subjects[0].check_closest([&p, &q], &s, &expected, &case);
        }
        if expected.place != Place::Overlapping {
            let [a, b] = subjects.each_ref().map(|subject| {
                let separation = subject.separation(&s, None);
                (separation.closest_points(), separation.features())
            });
            assert_eq!(a, b, "closest points with the sum and without: {case}");
        }
    }
    assert!(places[Place::Touching as usize] >= COUNT / 3, "{names:?}: {places:?}");
    assert!(places[Place::Overlapping as usize] >= 3 * COUNT / 10, "{names:?}: {places:?}");
    assert!(places[Place::Disjoint as usize] >= COUNT / 20, "{names:?}: {places:?}");
}

#[test]
fn gs4() {
    compare(["gs4.off", "gs4.off"]);
}

#[test]
fn gs4_turned() {
    compare(["gs4.off", "rgs4.xoff"]);
}

#[test]
fn el16() {
    compare(["el16.off", "el16.off"]);
}

#[test]
fn el16_turned() {
    compare(["el16.off", "oel16.xoff"]);
}

#[test]
fn dp() {
    compare(["dp.off", "dp.off"]);
}

#[test]
fn dp_turned() {
    compare(["dp.off", "odp.xoff"]);
}
