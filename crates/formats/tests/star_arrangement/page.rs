//! The page on the format, and the seeds of the fuzz target: all are read, and the page shows what is written.

use super::{comes_back, read};
use splitstar_formats::{StarArrangement, read_arrangement};
use std::path::Path;

fn examples() -> Vec<&'static str> {
    let page = include_str!("../../../../docs/star.md");
    let blocks = page.split("```star-arrangement\n").skip(1).map(|rest| rest.split("```").next().unwrap());
    blocks.collect()
}

#[test]
fn the_examples_of_the_page_are_what_is_written() {
    let counts: Vec<[usize; 3]> = examples()
        .into_iter()
        .map(|example| {
            let arrangement = read(example);
            assert_eq!(comes_back(&arrangement), example);
            let counts = arrangement.counts();
            [counts.vertices, counts.edges, counts.faces]
        })
        .collect();
    assert_eq!(counts, [[8, 7, 2], [1, 4, 4], [4, 4, 1], [1, 1, 1], [5, 4, 1], [4, 2, 2], [3, 3, 2]]);
}

#[test]
fn every_seed_is_read_and_comes_back() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds/star_arrangement");
    let mut families = [0; 6];
    for seed in std::fs::read_dir(folder).unwrap() {
        let seed = seed.unwrap().path();
        let arrangement = read_arrangement(&std::fs::read(&seed).unwrap(), None)
            .unwrap_or_else(|error| panic!("{}: {error}", seed.display()));
        comes_back(&arrangement);
        families[match arrangement {
            StarArrangement::Linear(_) => 0,
            StarArrangement::Polycurves(_) => 1,
            StarArrangement::Torus(_) => 2,
            StarArrangement::TorusPolycurves(_) => 3,
            StarArrangement::Sphere(_) => 4,
            _ => 5,
        }] += 1;
    }
    assert!(families.iter().all(|&seeds| seeds > 0), "{families:?}");
}
