//! The page on the grammar and the seeds of the fuzz target: all are read.

use super::{notes, read, shown};
use splitstar_formats::{read_curves, write_curves};
use std::path::Path;

#[test]
fn the_examples_of_the_page_are_read() {
    let page = include_str!("../../../../docs/curves.md");
    let mut examples = page.split("```curves\n").skip(1).map(|rest| rest.split("```").next().unwrap());
    let mut next = || examples.next().unwrap();
    let own = read(next());
    assert_eq!((own.curves.len(), notes(&own)), (6, vec![]));
    let torus = read(next());
    assert!(torus.period.is_some());
    assert_eq!(torus.curves.len(), 3);
    let wkt = read(next());
    assert_eq!((wkt.curves.len(), wkt.notes.len()), (8, 2));
    let geojson = read(next());
    assert_eq!(shown(&geojson), "polyline 0 0 1/10 0 1/10 1/5 0 0\npoint 1/20 1/20\npoint 1 1");
    assert!(examples.next().is_none());
}

#[test]
fn every_seed_is_read_and_comes_back() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds/curves");
    let mut seeds = 0;
    for seed in std::fs::read_dir(folder).unwrap() {
        let seed = seed.unwrap().path();
        let file = read_curves(&std::fs::read(&seed).unwrap(), None)
            .unwrap_or_else(|error| panic!("{}: {error}", seed.display()));
        let again = read_curves(&write_curves(&file.curves), None).unwrap();
        assert_eq!(again.curves, file.curves, "{}", seed.display());
        seeds += 1;
    }
    assert!(seeds >= 7, "{seeds} seeds");
}
