//! The sums of the models with every predicate started at each tier of the cascade.
//!
//! Forcing holds for the whole process: so these tests are a program of their own, and the others run
//! the usual cascade.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

use exact::tier::{Stage, Start, force, thread_counts};
use splitstar_polytope::{Polytope, minkowski_sum, minkowski_sum_by_hull, overlay_counts};
use testkit::{Rng, SumRow, around, assert_same, rotation, wide_hull};

/// Which stages may decide where all predicates start at one.
fn allowed(start: Start, stage: Stage) -> bool {
    match start {
        Start::Usual => true,
        Start::Float => stage != Stage::Narrow,
        Start::Fixed => matches!(stage, Stage::Fixed | Stage::Big),
        Start::Interval => matches!(stage, Stage::Interval | Stage::Big),
        Start::Big => stage == Stage::Big,
    }
}

/// Runs `work` with each tier forced, and checks that only the stages behind it have decided.
fn with_each_tier(mut work: impl FnMut(Start)) {
    for start in Start::FORCED {
        let _guard = force(start);
        let before = thread_counts();
        work(start);
        let decided = thread_counts() - before;
        for stage in Stage::ALL {
            assert!(allowed(start, stage) || decided.of(stage) == 0, "{start:?}: {decided:?}");
        }
        assert!(decided.total() > 10_000, "{start:?}: {decided:?}");
    }
}

/// The sums as they are without forcing.
fn usual(rows: &[SumRow]) -> Vec<Polytope> {
    let _guard = force(Start::Usual);
    rows.iter().map(|row| minkowski_sum(&row.summands.iter().collect::<Vec<_>>())).collect()
}

#[test]
fn every_sum_of_models_by_overlay() {
    let rows = SumRow::all();
    let sums = usual(&rows);
    let turn = rotation([7, -3, 2, 1]);
    with_each_tier(|start| {
        for (row, usual) in rows.iter().zip(&sums) {
            let context = format!("{start:?} forced");
            let mut summands: Vec<&Polytope> = row.summands.iter().collect();
            for _ in 0..2 {
                let sum = minkowski_sum(&summands);
                row.check(&sum, &context);
                assert!(sum.same_set(usual), "{} {context}", row.name());
                if let ([p, q], Some(expected)) = (&summands[..], row.meetings) {
                    let counts = overlay_counts(p, q);
                    let found = [counts.crossings, counts.common_normals, counts.normals_on_arcs];
                    assert_eq!(found, expected, "{} {context}", row.name());
                }
                summands.reverse();
            }
            let turned: Vec<Polytope> = row.summands.iter().map(|p| p.transformed(&turn)).collect();
            let sum = minkowski_sum(&turned.iter().collect::<Vec<_>>());
            assert_eq!(sum.counts().to_array(), row.counts, "{} {context}, turned", row.name());
        }
    });
}

#[test]
fn every_sum_of_models_by_hull() {
    let rows = SumRow::all();
    let sums = usual(&rows);
    with_each_tier(|start| {
        for (row, usual) in rows.iter().zip(&sums) {
            let sum = minkowski_sum_by_hull(&row.summands.iter().collect::<Vec<_>>());
            assert_eq!(sum.counts().to_array(), row.counts, "{} {start:?} forced", row.name());
            assert!(sum.same_set(usual), "{} {start:?} forced", row.name());
        }
    });
}

/// Wide operands never come to the bounded cascade; forcing must not bring them there.
#[test]
fn wide_and_narrow_operands_together() {
    const SEED: u64 = 0x7152_0001;
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    let mut cases = Vec::new();
    {
        let _guard = force(Start::Usual);
        for bits in [20, 60, 64, 128, 1100] {
            for _ in 0..10 {
                let p = wide_hull(&mut rng, 9, bits);
                let q = wide_hull(&mut rng, 9, 20);
                let usual = minkowski_sum_by_hull(&[&p, &q]);
                cases.push((p, q, usual));
            }
        }
    }
    with_each_tier(|start| {
        for (p, q, usual) in &cases {
            assert_same(&minkowski_sum(&[p, q]), usual, format!("{start:?}"));
            assert_same(&around(usual.points()), usual, format!("{start:?}, hull"));
        }
    });
}
