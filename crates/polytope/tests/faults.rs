//! Do the oracles see mistakes? Six faults are injected, and each must be caught: by a panic inside, by
//! `check_valid`, or by comparison with the hull of all pairwise vertex sums.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

use splitstar_polytope::fault::{Fault, with_fault};
use splitstar_polytope::{Polytope, Violation, minkowski_sum, minkowski_sum_by_hull};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use testkit::{Rng, SumRow, difference, facet_planes, hull, hull_of_dimension, isomorphic, segment};

const SEED: u64 = 0xfa17_0001;

/// What looks at a result. Each is asked by itself; the comparisons have the right sum.
const ORACLES: [&str; 8] =
    ["check_valid", "dimension", "counts", "vertices", "volume", "planes", "cycles", "panic"];

/// The oracles that object to a result (`None` if computing it has panicked).
fn objections(found: Option<&Polytope>, right: &Polytope) -> Vec<&'static str> {
    let Some(found) = found else { return vec!["panic"] };
    // In a mesh with broken links the others could go round for ever.
    let broken = |violation: &Violation| matches!(violation, Violation::Mesh(_) | Violation::Sizes);
    if found.check_valid().iter().any(broken) {
        return vec!["check_valid"];
    }
    // A wrong mesh may make an oracle panic: then it has seen it.
    let objects = |oracle: &dyn Fn() -> bool| catch_unwind(AssertUnwindSafe(oracle)).unwrap_or(true);
    let answers: [&dyn Fn() -> bool; 7] = [
        &|| !found.check_valid().is_empty(),
        &|| found.dimension() != right.dimension(),
        &|| found.counts() != right.counts(),
        &|| !found.same_set(right),
        &|| found.volume() != right.volume(),
        &|| facet_planes(found) != facet_planes(right),
        &|| !isomorphic(found, right),
    ];
    let verdicts = answers.map(objects);
    ORACLES.iter().zip(verdicts).filter(|(_, objects)| *objects).map(|(&oracle, _)| oracle).collect()
}

/// Pairs of all dimensions, with coplanar facets, long arcs and common normals among them.
fn pairs() -> Vec<[Polytope; 2]> {
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    let mut pairs = Vec::new();
    for i in 0..240 {
        let range = [1, 2, 5][i % 3];
        let dimensions = if i < 120 { [3, 3] } else { [rng.between(1, 3) as u8, rng.between(1, 3) as u8] };
        pairs.push(dimensions.map(|dimension| hull_of_dimension(&mut rng, dimension, range)));
    }
    let square = hull(&[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]);
    pairs.push([square.clone(), segment([0, 0, 1])]);
    pairs.push([square.clone(), square]);
    for row in SumRow::all() {
        if let ([p, q], true) = (&row.summands[..], row.vertex_sums() < 300) {
            pairs.push([p.clone(), q.clone()]);
        }
    }
    pairs
}

/// Runs one way to add over all pairs with a fault; gives how often each oracle has objected, how many
/// results were wrong, and how many right, because the fault was not reached.
fn census(
    fault: Fault,
    add: fn(&[&Polytope]) -> Polytope,
    pairs: &[([Polytope; 2], Polytope)],
) -> (BTreeMap<&'static str, usize>, usize, usize) {
    let mut seen_by = BTreeMap::new();
    let (mut caught, mut right) = (0, 0);
    for ([p, q], sum) in pairs {
        let found = catch_unwind(AssertUnwindSafe(|| with_fault(fault, || add(&[p, q]))));
        let objections = objections(found.as_ref().ok(), sum);
        if objections.is_empty() {
            right += 1;
        } else {
            caught += 1;
        }
        objections.into_iter().for_each(|oracle| *seen_by.entry(oracle).or_insert(0) += 1);
    }
    (seen_by, caught, right)
}

/// The method that a fault is in, the least number of pairs in which it must be caught, and oracles that
/// must be among those that see it.
type Row = (Fault, fn(&[&Polytope]) -> Polytope, usize, &'static [&'static str]);

#[test]
fn every_fault_is_caught() {
    const ROWS: &[Row] = &[
        (Fault::FlippedNormal, minkowski_sum, 100, &["check_valid", "planes"]),
        (Fault::DroppedEdge, minkowski_sum, 200, &["panic"]),
        (Fault::ZeroAsPositive, minkowski_sum, 50, &[]),
        (Fault::WrongVertex, minkowski_sum, 150, &["check_valid", "vertices", "volume"]),
        (Fault::SkippedDigons, minkowski_sum, 60, &["check_valid", "counts"]),
        (Fault::SkippedMerge, minkowski_sum_by_hull, 100, &["check_valid", "counts", "cycles"]),
    ];
    let pairs: Vec<_> = pairs()
        .into_iter()
        .map(|pair| {
            let sum = minkowski_sum_by_hull(&pair.each_ref());
            (pair, sum)
        })
        .collect();
    // Without a fault nothing objects.
    for ([p, q], sum) in &pairs {
        assert_eq!(difference(&minkowski_sum(&[p, q]), sum), None);
        assert_eq!(objections(Some(&minkowski_sum(&[p, q])), sum), Vec::<&str>::new());
        assert_eq!(objections(Some(&minkowski_sum_by_hull(&[p, q])), sum), Vec::<&str>::new());
    }
    // Hundreds of panics are wanted here: not their messages.
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let results: Vec<_> = ROWS.iter().map(|&(fault, add, ..)| census(fault, add, &pairs)).collect();
    std::panic::set_hook(hook);
    for ((fault, _, least, oracles), (seen_by, caught, right)) in ROWS.iter().zip(&results) {
        println!(
            "{fault:?}: caught in {caught} of {} pairs, not reached in {right}; by {seen_by:?}",
            pairs.len()
        );
        assert!(caught >= least, "{fault:?}: caught in {caught} pairs, at least {least} are wanted");
        for oracle in *oracles {
            assert!(seen_by.contains_key(oracle), "{fault:?} was not seen by {oracle}");
        }
    }
}

/// The fault ends with the call, even if the work panics.
#[test]
fn faults_end() {
    // No edge of the triangle is perpendicular to an axis: the cuts of the segment's circle stay digons.
    let triangle = hull(&[[0, 0, 0], [2, 1, 0], [1, 3, 0]]);
    let up = segment([0, 0, 1]);
    let prism = minkowski_sum(&[&triangle, &up]);
    let wrong = with_fault(Fault::SkippedDigons, || minkowski_sum(&[&triangle, &up]));
    assert_ne!(wrong.counts(), prism.counts());
    let work = || with_fault(Fault::SkippedDigons, || std::panic::resume_unwind(Box::new(())));
    assert!(catch_unwind(work).is_err());
    assert_eq!(difference(&minkowski_sum(&[&triangle, &up]), &prism), None);
}
