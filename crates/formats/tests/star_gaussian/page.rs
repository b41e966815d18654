//! The page on the format shows what is written, and the seeds of the fuzz target are read.

use super::{comes_back, read};
use splitstar_formats::read_gaussian_map;
use std::path::Path;

#[test]
fn the_examples_of_the_page_are_what_is_written() {
    let page = include_str!("../../../../docs/star.md");
    let blocks = page.split("```star-gaussian\n").skip(1).map(|rest| rest.split("```").next().unwrap());
    let mut counts = Vec::new();
    for example in blocks {
        let map = read(example);
        assert_eq!(comes_back(&map), example);
        counts.push(map.make_polytope().counts().to_array());
    }
    assert_eq!(counts, [[4, 6, 4], [2, 1, 0], [4, 6, 4]]);
}

#[test]
fn every_seed_is_read_and_comes_back() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds/star_gaussian");
    let mut dimensions = [0; 4];
    for seed in std::fs::read_dir(folder).unwrap() {
        let seed = seed.unwrap().path();
        let map = read_gaussian_map(&std::fs::read(&seed).unwrap(), None)
            .unwrap_or_else(|error| panic!("{}: {error}", seed.display()));
        comes_back(&map);
        dimensions[usize::from(map.make_polytope().dimension())] += 1;
    }
    assert!(dimensions.iter().all(|&seeds| seeds > 0), "{dimensions:?}");
}
