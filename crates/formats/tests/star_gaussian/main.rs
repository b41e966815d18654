//! Gaussian maps in the native format: one text for each, which comes back as the polytope; and what is refused.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod bad;
mod models;
mod page;

use arrangement::models::GeodesicTraits;
use exact::Integer;
use gauss::{CubicalGaussianMap, SphericalGaussianMap};
use polytope::Polytope;
use splitstar_formats::{StarGaussianMap, read_gaussian_map, write_gaussian_map};

fn read(text: &str) -> StarGaussianMap {
    read_gaussian_map(text.as_bytes(), None).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn write(map: &StarGaussianMap) -> String {
    String::from_utf8(write_gaussian_map(map)).unwrap()
}

/// The map on a sphere that is cut open there.
fn on_sphere(polytope: &Polytope, identification: [i64; 2]) -> StarGaussianMap {
    let traits = GeodesicTraits::with_identification(identification.map(Integer::from)).unwrap();
    SphericalGaussianMap::of_polytope_with(polytope, traits).into()
}

/// All maps of a polytope.
fn maps(polytope: &Polytope) -> Vec<StarGaussianMap> {
    let identifications = [[-1, 0], [0, 1], [3, -2]];
    let mut maps: Vec<_> = identifications.into_iter().map(|at| on_sphere(polytope, at)).collect();
    maps.push(CubicalGaussianMap::of_polytope(polytope).into());
    maps
}

/// Writes, reads and writes again; gives the text.
fn comes_back(map: &StarGaussianMap) -> String {
    let text = write(map);
    let again = read(&text);
    assert!(again.make_polytope().same_set(&map.make_polytope()), "{text}");
    assert_eq!(write(&again), text);
    text
}
