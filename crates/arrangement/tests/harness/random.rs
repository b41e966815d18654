//! Random curves of small coordinates, so that everything degenerate happens.

use crate::curves::{Curve, P, Shape, fraction, rational};
use crate::models::{Linears, MinimalSegments, Model, Numbered, Polylinears, Polylines, Segments, WideTorus};
use crate::oracle::{brute_force, has_point};
use crate::routes::{Route, check};
use testkit::Rng;

/// Up to `most` curves with coordinates from 0 to `range`, some of them fractions; one in `others` is not a segment.
pub(crate) fn random_curves(rng: &mut Rng, most: usize, range: u64, are_bounded: bool) -> Vec<Curve> {
    let denominator = if rng.one_in(4) { 2 } else { 1 };
    let coordinate = |rng: &mut Rng| fraction(rng.below(range + 1) as i64, denominator);
    let count = rng.index(most + 1);
    let shapes: &[Shape] =
        if are_bounded { &[Shape::Segment] } else { &[Shape::Segment, Shape::Ray, Shape::Line] };
    (0..count)
        .map(|_| {
            let [p, q] = [0; 2].map(|_| [coordinate(rng), coordinate(rng)]);
            if p == q || rng.one_in(8) {
                Curve::Point(p)
            } else {
                Curve::Straight(*rng.choose(shapes), [p, q])
            }
        })
        .collect()
}

fn run(model: &impl Model, cases: u32, are_bounded: bool) {
    let mut rng = Rng::new(20_261_122);
    let mut run = 0;
    for case in 0..cases {
        let most = [4, 8, 14][rng.index(3)];
        let range = if case % 8 == 0 { 20 } else { rng.between(1, 6) };
        let curves = random_curves(&mut rng, most, range, are_bounded);
        let cells = brute_force(&curves);
        // One route more than the sweep, each in its turn; all of them now and then.
        let one = [Route::Sweep, *rng.choose(&Route::ALL[1..])];
        let routes = if case % 10 == 0 { &Route::ALL[..] } else { &one };
        run += u32::from(check(model, &curves, routes, &cells, &mut rng).is_some());
    }
    assert_eq!(run, cases);
}

test_models! {
    segments: Segments, 3000, true;
    minimal_segments: MinimalSegments, 800, true;
    linear_curves: Linears, 3000, false;
    polylines: Polylines, 800, true;
    polycurves_of_linear_curves: Polylinears, 800, false;
    segments_with_data: Numbered, 500, true;
}

/// Every edge knows all the curves that run along it, and no others.
#[test]
fn edges_have_the_data_of_their_curves() {
    let mut rng = Rng::new(31);
    let mut overlaps = 0;
    for _ in 0..1000 {
        let seed = rng.state();
        let curves = random_curves(&mut rng, 8, 3, true);
        let made = Route::Sweep.build(&Numbered, &curves, &mut rng).expect("segments");
        for e in made.dcel().edges() {
            let ends =
                made.dcel().ends(e).map(|v| made.point(v).expect("segments are bounded").coordinates());
            let has_edge = |curve: &&Curve| {
                matches!(curve, Curve::Straight(..)) && ends.iter().all(|p| has_point(curve, p))
            };
            let expected: Vec<u32> =
                (0..).zip(&curves).filter(|(_, curve)| has_edge(curve)).map(|(number, _)| number).collect();
            let data: Vec<u32> = made.curve_of(e).data.iter().copied().collect();
            assert_eq!(data, expected, "edge {}, seed {seed}: {curves:?}", e.0);
            overlaps += u32::from(data.len() > 1);
        }
    }
    assert!(overlaps > 100, "{overlaps}");
}

#[test]
fn torus_with_seams_anywhere() {
    let mut rng = Rng::new(5);
    for _ in 0..20 {
        let shift: P = [0; 2].map(|_| fraction(rng.within(12), [1, 2, 3][rng.index(3)]));
        run(&WideTorus::new([41, 43], shift), 60, true);
    }
    run(&WideTorus::new([30, 27], [rational(-3), rational(-3)]), 500, true);
}
