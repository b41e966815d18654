//! Every way to make an arrangement: all must be valid, the same, and what brute force found.

use crate::arcs::Curve;
use crate::cube;
use crate::families::rows;
use crate::graph::Graph;
use crate::incidences::Incidences;
use crate::matching::Matching;
use crate::own::{Globe, own, sweep, sweep_with};
use crate::planar::all_rows;
use crate::random::{almost, random_curves};
use splitstar_arrangement::models::GeodesicTraits;
use splitstar_arrangement::overlay::overlay_all;
use splitstar_arrangement::topology::Sphere;
use splitstar_arrangement::{Arrangement, Counts, Editor};
use testkit::Rng;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Route {
    /// In another order, and some curves turned round.
    Shuffled,
    /// Two sweeps, one upon the other.
    Halves,
    /// A sweep for each curve.
    Aggregated,
    /// By an editor, curve by curve.
    OneByOne,
    OverlayOfTwo,
    OverlayOfThree,
    OverlayOfFour,
}

impl Route {
    pub(crate) const ALL: [Self; 7] = [
        Self::Shuffled,
        Self::Halves,
        Self::Aggregated,
        Self::OneByOne,
        Self::OverlayOfTwo,
        Self::OverlayOfThree,
        Self::OverlayOfFour,
    ];

    pub(crate) fn build(self, traits: &GeodesicTraits, curves: &[Curve], rng: &mut Rng) -> Globe {
        let mut curves: Vec<Curve> =
            curves.iter().map(|curve| if rng.one_in(3) { curve.swapped() } else { curve.clone() }).collect();
        rng.shuffle(&mut curves);
        let empty = || Arrangement::new(traits.clone(), Sphere);
        match self {
            Self::Shuffled => sweep_with(traits, &curves),
            Self::Halves => {
                let (first, last) = curves.split_at(rng.index(curves.len() + 1));
                let mut globe = sweep_with(traits, first);
                globe.insert_curves(&own(last));
                globe
            }
            Self::Aggregated => {
                let mut globe = empty();
                own(&curves).iter().for_each(|curve| drop(globe.insert_curves([curve])));
                globe
            }
            Self::OneByOne => {
                let mut editor = Editor::new(empty());
                for curve in own(&curves) {
                    editor.insert_curve(&curve);
                }
                editor.finish().0
            }
            Self::OverlayOfTwo => overlay_of(2, traits, &curves, rng),
            Self::OverlayOfThree => overlay_of(3, traits, &curves, rng),
            Self::OverlayOfFour => overlay_of(4, traits, &curves, rng),
        }
    }
}

/// The overlay of so many arrangements of some of the curves each.
fn overlay_of(count: usize, traits: &GeodesicTraits, curves: &[Curve], rng: &mut Rng) -> Globe {
    let mut parts = vec![Vec::new(); count];
    for curve in curves {
        parts[rng.index(count)].push(curve.clone());
    }
    let operands: Vec<Globe> = parts.iter().map(|part| sweep_with(traits, part)).collect();
    overlay_all(&operands.iter().collect::<Vec<_>>()).0
}

/// Checks that both oracles find the same cells, joined in the same way.
fn check_oracles(curves: &[Curve], context: &str) -> Counts {
    let found = Incidences::of_graph(&Graph::new(curves));
    assert_eq!(cube::incidences(curves), found, "{context}: {curves:?}");
    found.counts
}

/// Checks a sweep, and that routes give the same; gives what the sweep made.
pub(crate) fn check(curves: &[Curve], routes: &[Route], rng: &mut Rng, context: &str) -> Globe {
    let context = format!("{context}, seed {}: {curves:?}", rng.state());
    let graph = Graph::new(curves);
    let globe = sweep(curves);
    assert_eq!(globe.check_valid(), [], "{context}");
    Matching::new(&graph, &globe, &context);
    for route in routes {
        let other = route.build(globe.traits(), curves, rng);
        let context = format!("{route:?}, {context}");
        assert_eq!(other.check_valid(), [], "{context}");
        assert_eq!(other.difference(&globe), None, "{context}");
        Matching::new(&graph, &other, &context);
    }
    globe
}

fn counts_of([vertices, edges, faces, isolated, components]: [usize; 5]) -> Counts {
    Counts { vertices, edges, faces, isolated, components }
}

#[test]
fn families_of_the_sphere() {
    let rows = rows();
    assert!(rows.len() > 500, "there are rows");
    let mut rng = Rng::new(1);
    for row in rows {
        let found = check_oracles(&row.curves, &row.name);
        assert_eq!(found, counts_of(row.counts), "{}: {:?}", row.name, row.curves);
        check(&row.curves, &Route::ALL, &mut rng, &row.name);
    }
}

#[test]
fn families_of_the_plane() {
    let mut rng = Rng::new(2);
    let mut count = 0;
    for row in all_rows() {
        let found = check_oracles(&row.curves, &row.name);
        assert_eq!(found, counts_of(row.counts), "{}: {:?}", row.name, row.curves);
        let routes = [*rng.choose(&Route::ALL), *rng.choose(&Route::ALL)];
        check(&row.curves, &routes, &mut rng, &row.name);
        count += 1;
    }
    assert!(count > 400, "{count}");
}

/// Random curves, with one route more than the sweep, and all of them now and then; tells how many faces there were.
fn run(seed: u64, cases: usize, most: usize, ranges: &[i64]) -> usize {
    let mut rng = Rng::new(seed);
    let mut faces = 0;
    for case in 0..cases {
        let range = *rng.choose(ranges);
        let count = 1 + case % most;
        let context = format!("case {case} of seed {seed}, range {range}");
        let curves = random_curves(&mut rng, count, range);
        check_oracles(&curves, &context);
        let one = [*rng.choose(&Route::ALL)];
        let routes = if case % 10 == 0 { &Route::ALL[..] } else { &one };
        faces += check(&curves, routes, &mut rng, &context).counts().faces;
    }
    faces
}

#[test]
fn random_curves_of_small_coordinates() {
    let faces = run(20_261_123, 2000, 16, &[1, 1, 2, 2, 2, 3]);
    assert!(faces > 5_000, "{faces}");
}

#[test]
fn random_curves_of_large_coordinates() {
    let faces = run(20_261_124, 80, 36, &[1000, 1 << 20, 1 << 40, i64::MAX >> 2]);
    assert!(faces > 1_000, "{faces}");
}

/// Each curve, and others that floats cannot tell from it.
#[test]
fn random_curves_that_almost_coincide() {
    let mut rng = Rng::new(20_261_125);
    for case in 0..150 {
        let context = format!("case {case}");
        let curves = random_curves(&mut rng, 5, 2);
        let others: Vec<Curve> =
            curves.iter().flat_map(|curve| [(); 2].map(|()| almost(curve, &mut rng))).collect();
        let mut all = [curves, others].concat();
        rng.shuffle(&mut all);
        check_oracles(&all, &context);
        let one = [*rng.choose(&Route::ALL)];
        check(&all, &one, &mut rng, &context);
    }
}
