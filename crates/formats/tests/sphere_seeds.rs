//! The seeds of the fuzz target `sphere_curves`: all are read and come back, and whatever order the curves are given in, their arrangement has
//! one text, which comes back, too.

use arrangement::models::GeodesicTraits;
use exact::Integer;
use splitstar_formats::{
    SphereCurve, StarArrangement, read_arrangement, read_sphere_curves, read_sphere_points,
    write_arrangement, write_sphere_curves,
};
use std::path::Path;

fn text_of(curves: &[SphereCurve], identification: [i64; 2], name: &str) -> Vec<u8> {
    let traits = GeodesicTraits::with_identification(identification.map(Integer::from)).expect("not zero");
    let made = StarArrangement::of_sphere_curves(curves.to_vec(), traits);
    write_arrangement(&made.unwrap_or_else(|error| panic!("{name}: {error}")))
}

#[test]
fn every_seed_comes_back_and_has_one_text() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds/sphere_curves");
    let (mut curves_read, mut points_read) = (0, 0);
    for seed in std::fs::read_dir(folder).expect("the seeds are there") {
        let seed = seed.expect("a folder can be read").path();
        let name = seed.display().to_string();
        let bytes = std::fs::read(&seed).expect("a seed can be read");
        if let Ok(file) = read_sphere_points(&bytes, None) {
            points_read += file.points.len();
        }
        let mut curves = match read_sphere_curves(&bytes, None) {
            Ok(file) => file.curves,
            Err(_) if name.ends_with("points") => continue,
            Err(error) => panic!("{name}: {error}"),
        };
        let again = read_sphere_curves(&write_sphere_curves(&curves), None);
        assert_eq!(again.unwrap_or_else(|error| panic!("{name}: {error}")).curves, curves, "{name}");
        let identifications = [[-1, 0], [2, 1], [0, -1]];
        let texts = identifications.map(|place| text_of(&curves, place, &name));
        for text in &texts {
            let again = read_arrangement(text, None).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_eq!(write_arrangement(&again), *text, "{name}");
        }
        curves.reverse();
        assert!(identifications.map(|place| text_of(&curves, place, &name)) == texts, "{name}");
        curves_read += curves.len();
    }
    assert!(curves_read > 30 && points_read > 3, "{curves_read} curves, {points_read} points");
}
