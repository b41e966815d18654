//! Maps of models, of random polytopes and of sums: they come back, and however they are made they have one text.

use super::{comes_back, maps, on_sphere, read, write};
use gauss::{CubicalGaussianMap, SphericalGaussianMap};
use polytope::{Polytope, minkowski_sum};
use splitstar_formats::{StarGaussianMap, pack_gzip, read_gaussian_map};
use testkit::{Rng, assert_same, hull_of_dimension, model, weighted_hull};

const MODELS: [&str; 8] = [
    "convex/tetrahedron.off",
    "convex/octahedron.off",
    "convex/cube.off",
    "convex/icosahedron.off",
    "convex/dp.off",
    "convex/odp.xoff",
    "convex/ph_snub_dodecahedron.off",
    "maxfacets/p7_rot90y.off",
];

#[test]
fn models_come_back() {
    for name in MODELS {
        let polytope = model(name);
        for map in maps(&polytope) {
            assert_same(&map.make_polytope(), &polytope, name);
            comes_back(&map);
        }
    }
}

#[test]
fn random_polytopes_of_all_dimensions_come_back() {
    let mut rng = Rng::new(20_261_123);
    for _ in 0..60 {
        for dimension in 0..=3 {
            println!("state {}", rng.state());
            let polytope = hull_of_dimension(&mut rng, dimension, 3);
            maps(&polytope).iter().for_each(|map| drop(comes_back(map)));
        }
    }
    let polytope = weighted_hull(&mut rng, 12, 1000, 90);
    maps(&polytope).iter().for_each(|map| drop(comes_back(map)));
}

/// The text of a sum does not tell how it was made.
#[test]
fn a_map_has_one_text_however_it_is_made() {
    let mut rng = Rng::new(7);
    let check = |a: &Polytope, b: &Polytope| {
        let sum = minkowski_sum(&[a, b]);
        let [p, q] = [a, b].map(SphericalGaussianMap::of_polytope);
        let by_overlay: StarGaussianMap = p.minkowski_sum(&q).into();
        assert_eq!(write(&by_overlay), write(&on_sphere(&sum, [-1, 0])));
        // The reflection has the opposite identification.
        let reflected: StarGaussianMap = p.reflected().into();
        assert_eq!(write(&reflected), write(&on_sphere(&a.reflected(), [1, 0])));

        let [p, q] = [a, b].map(CubicalGaussianMap::of_polytope);
        let by_overlay: StarGaussianMap = p.minkowski_sum(&q).into();
        assert_eq!(write(&by_overlay), write(&CubicalGaussianMap::of_polytope(&sum).into()));
        let reflected: StarGaussianMap = p.reflected().into();
        assert_eq!(write(&reflected), write(&CubicalGaussianMap::of_polytope(&a.reflected()).into()));
    };
    check(&model("convex/dp.off"), &model("convex/odp_exact90.off"));
    check(&model("convex/cube.off"), &model("convex/octahedron.off"));
    for _ in 0..20 {
        println!("state {}", rng.state());
        let dimensions = [rng.below(4) as u8, rng.below(4) as u8];
        let [a, b] = dimensions.map(|dimension| hull_of_dimension(&mut rng, dimension, 2));
        check(&a, &b);
    }
}

#[test]
fn blanks_comments_and_gzip_do_not_matter() {
    let map = on_sphere(&model("convex/tetrahedron.off"), [-1, 0]);
    let text = write(&map);
    let loose = text.replace('\n', " # what\r\n\r\n\t").replace(' ', "  ");
    assert_eq!(write(&read(&loose)), text);
    let packed = pack_gzip(text.as_bytes());
    assert_eq!(write(&read_gaussian_map(&packed, None).unwrap()), text);
    assert!(read_gaussian_map(&pack_gzip(&packed), None).is_err());
}

/// The reader of models gives the polytope.
#[test]
fn a_map_is_a_model() {
    for name in MODELS {
        let polytope = model(name);
        for map in maps(&polytope) {
            let text = write(&map);
            let read = splitstar_formats::read(text.as_bytes(), None).unwrap();
            let mesh = read.model.shape.into_mesh().unwrap();
            let mut notes = Vec::new();
            assert_same(&Polytope::from_mesh(&mesh, &mut notes).unwrap(), &polytope, name);
            assert!(notes.is_empty(), "{name}: {notes:?}");
        }
    }
}
