//! Every row, on every model that can carry it, by every route.

use crate::curves::fraction;
use crate::models::{Linears, MinimalSegments, Model, Numbered, Polylinears, Polylines, Segments, WideTorus};
use crate::oracle::brute_force;
use crate::routes::{Route, check};
use crate::rows::rows;
use splitstar_arrangement::Counts;
use testkit::Rng;

/// Checks all rows on a model, and gives how many it could carry.
fn check_rows(model: &impl Model) -> usize {
    let mut rng = Rng::new(1);
    let mut run = 0;
    for row in rows() {
        let cells = brute_force(&row.curves);
        run += usize::from(check(model, &row.curves, &Route::ALL, &cells, &mut rng).is_some());
    }
    run
}

#[test]
fn brute_force_finds_what_the_table_says() {
    let rows = rows();
    assert!(rows.len() > 100, "there are rows");
    let wrong = rows.iter().filter_map(|row| {
        let [vertices, edges, faces, isolated, components] = row.counts;
        let counts = Counts { vertices, edges, faces, isolated, components };
        let found = brute_force(&row.curves).counts;
        (found != counts).then(|| format!("{}: {counts:?}, found {found:?}", row.name))
    });
    assert_eq!(wrong.collect::<Vec<_>>(), Vec::<String>::new());
}

fn bounded_rows() -> usize {
    let count = rows().iter().filter(|row| row.curves.iter().all(|curve| curve.is_bounded())).count();
    assert!(count > 60, "there are rows without rays and lines");
    count
}

#[test]
fn segments() {
    assert_eq!(check_rows(&Segments), bounded_rows());
}

#[test]
fn minimal_segments() {
    assert_eq!(check_rows(&MinimalSegments), bounded_rows());
}

#[test]
fn linear_curves() {
    assert_eq!(check_rows(&Linears), rows().len());
}

#[test]
fn polylines() {
    assert_eq!(check_rows(&Polylines), bounded_rows());
}

#[test]
fn polycurves_of_linear_curves() {
    assert_eq!(check_rows(&Polylinears), rows().len());
}

#[test]
fn segments_with_data() {
    assert_eq!(check_rows(&Numbered), bounded_rows());
}

#[test]
fn torus_with_seams_outside() {
    assert_eq!(check_rows(&WideTorus::new([100, 90], [fraction(45, 1), fraction(43, 1)])), bounded_rows());
}

#[test]
fn torus_with_seams_through_the_origin() {
    assert_eq!(check_rows(&WideTorus::new([100, 90], [fraction(0, 1), fraction(0, 1)])), bounded_rows());
}

#[test]
fn torus_with_seams_between_integers() {
    assert_eq!(check_rows(&WideTorus::new([61, 57], [fraction(-1, 2), fraction(-2, 3)])), bounded_rows());
}
