//! The decomposition of arrangements that a sweep made.
//!
//! | file | role |
//! |---|---|
//! | this one | faults of decompositions |
//! | `parts` | what is connected, and what lies in it |
//! | `edits` | rails and sites go and come back |

mod edits;
mod parts;

use super::*;
use crate::random::{
    Numbers, Scene, random_cylinder, random_globe, random_lines, random_paths, random_segments,
};
use crate::traits::{ArrangementTraits, UMonotoneTraits};

/// Runs a test on arrangements made from seeds on a surface.
fn on<G: ArrangementTraits + Clone, T: Topology<G>>(
    seeds: u64,
    most: i64,
    make: impl Fn(&mut Numbers, i64) -> Scene<G, T>,
    test: impl Fn(&Arrangement<G, T>, &mut Numbers, u64),
) {
    for seed in 1..=seeds {
        let mut numbers = Numbers::of_seed(seed);
        let arrangement = make(&mut numbers, most).arrangement();
        test(&arrangement, &mut numbers, seed);
    }
}

fn has_no_faults<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    _: &mut Numbers,
    seed: u64,
) {
    let faults = Trapezoids::of(arrangement).find_faults(arrangement);
    assert_eq!(faults, Vec::<String>::new(), "seed {seed}");
}

#[test]
fn segments() {
    on(300, 12, random_segments, has_no_faults);
}

#[test]
fn lines_and_rays() {
    on(300, 10, random_lines, has_no_faults);
}

#[test]
fn paths_on_a_torus() {
    on(1000, 6, random_paths, has_no_faults);
}

#[test]
fn paths_on_a_cylinder() {
    on(500, 6, random_cylinder, has_no_faults);
}

#[test]
fn arcs_on_a_sphere() {
    on(600, 9, random_globe, has_no_faults);
}

/// The figures of `docs/arrangement.md`.
#[test]
fn records_are_small() {
    let sizes = [size_of::<Trapezoid>(), size_of::<SiteRecord>(), size_of::<Rail>(), size_of::<Node>()];
    assert_eq!(sizes, [20, 32, 24, 24]);
}
