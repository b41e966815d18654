//! Random sets: what they are does not depend on the identification, nor on exact rotations.

use crate::arcs::{identifications, random_geodesic};
use exact::{Integer, Quaternion};
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::models::{Geodesic, GeodesicTraits};
use splitstar_arrangement::topology::Sphere;
use testkit::Rng;

fn counts(traits: &GeodesicTraits, curves: &[Geodesic]) -> [usize; 4] {
    let arrangement = Arrangement::of_curves(traits.clone(), Sphere, curves);
    let identification = traits.identification();
    assert_eq!(arrangement.check_valid(), [], "{curves:?} from {identification}");
    let counts = arrangement.counts();
    [counts.vertices, counts.edges, counts.faces, counts.isolated]
}

#[test]
fn every_identification_and_rotation_gives_the_same_cells() {
    let mut rng = Rng::new(301);
    for round in 0..150 {
        eprintln!("seed {}", rng.state());
        let size = 1 + i64::from(round % 3 == 2);
        let curves: Vec<_> = (0..2 + rng.index(9)).map(|_| random_geodesic(&mut rng, size)).collect();
        let expected = counts(&GeodesicTraits::new(), &curves);
        for traits in identifications() {
            assert_eq!(counts(&traits, &curves), expected, "{curves:?} from {}", traits.identification());
        }
        let rotation =
            Quaternion::new([(); 4].map(|()| rng.within(3).into())).unwrap_or_else(Quaternion::identity);
        let turned: Vec<_> = curves.iter().map(|curve| curve.turned(&rotation)).collect();
        assert_eq!(counts(&GeodesicTraits::new(), &turned), expected, "{curves:?} turned by {rotation}");
        let antipodal: Vec<_> = curves.iter().map(Geodesic::antipodal).collect();
        assert_eq!(counts(&GeodesicTraits::new(), &antipodal), expected, "antipodal {curves:?}");
        let reversed: Vec<_> = curves.iter().rev().map(Geodesic::reversed).collect();
        assert_eq!(counts(&GeodesicTraits::new(), &reversed), expected, "reversed {curves:?}");
    }
}

/// Coordinates of hundreds of bits, and all that is degenerate stays so.
#[test]
fn wide_coordinates_give_the_same_cells() {
    let mut rng = Rng::new(302);
    for bits in [4, 8, 12, 20, 70] {
        for _ in 0..6 {
            eprintln!("seed {}", rng.state());
            let curves: Vec<_> = (0..3 + rng.index(6)).map(|_| random_geodesic(&mut rng, 2)).collect();
            let expected = counts(&GeodesicTraits::new(), &curves);
            let component =
                |rng: &mut Rng| (Integer::from(rng.within(1 << 20)) << bits) + Integer::from(rng.within(99));
            let rotation = Quaternion::new([(); 4].map(|()| component(&mut rng))).unwrap();
            let turned: Vec<_> = curves.iter().map(|curve| curve.turned(&rotation)).collect();
            for traits in &identifications()[..2] {
                assert_eq!(counts(traits, &turned), expected, "{curves:?} turned by {rotation}");
            }
        }
    }
}
