//! Poly-geodesics.

use crate::arcs::{grid, identifications, random_direction};
use crate::oracle::direction;
use exact::spherical::{Direction, is_antipodal};
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::models::polycurve::{PolycurveError, PolycurveTraits};
use splitstar_arrangement::models::{Geodesic, GeodesicTraits};
use splitstar_arrangement::topology::Sphere;
use testkit::Rng;

/// A walk, of which consecutive points are different and not antipodal.
fn random_walk(rng: &mut Rng, length: usize) -> Vec<Direction> {
    let mut walk = vec![random_direction(rng, 1)];
    while walk.len() < length {
        let p = random_direction(rng, 1);
        let last = &walk[walk.len() - 1];
        if *last != p && !is_antipodal(last, &p) {
            walk.push(p);
        }
    }
    walk
}

#[test]
fn chains_have_the_faces_of_their_arcs() {
    let mut rng = Rng::new(401);
    for _ in 0..200 {
        eprintln!("seed {}", rng.state());
        let walks: Vec<_> = (0..1 + rng.index(3))
            .map(|_| {
                let length = 2 + rng.index(7);
                random_walk(&mut rng, length)
            })
            .collect();
        let arcs: Vec<_> = walks
            .iter()
            .flat_map(|walk| {
                walk.windows(2).map(|pair| Geodesic::arc(pair[0].clone(), pair[1].clone()).unwrap())
            })
            .collect();
        for traits in identifications() {
            let chains = PolycurveTraits::new(traits.clone());
            let curves: Vec<_> =
                walks.iter().map(|walk| chains.make_polyline(walk.iter().cloned()).unwrap()).collect();
            let of_chains = Arrangement::of_curves(chains, Sphere, &curves);
            assert_eq!(of_chains.check_valid(), [], "{walks:?}");
            let of_arcs = Arrangement::of_curves(traits, Sphere, &arcs);
            let [here, there] = [of_chains.counts(), of_arcs.counts()];
            assert_eq!(here.faces, there.faces, "{walks:?}");
            // A joint of two arcs is a vertex and an edge more; all else is the same.
            assert_eq!(here.edges + there.vertices, there.edges + here.vertices, "{walks:?}");
            assert!(here.vertices <= there.vertices, "{walks:?}");
        }
    }
}

#[test]
fn antipodal_vertices_are_not_connected() {
    let chains = PolycurveTraits::new(GeodesicTraits::new());
    for p in grid(1) {
        let straight = chains.make_polyline([p.clone(), p.opposite()]);
        assert_eq!(straight.err(), Some(PolycurveError::NotConnected { curve: 0 }), "{p}");
        let q = direction([3, 5, 7]);
        let later = chains.make_polyline([q, p.clone(), p.opposite()]);
        assert_eq!(later.err(), Some(PolycurveError::NotConnected { curve: 1 }), "{p}");
    }
}
