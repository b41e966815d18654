//! The decomposition against the one that is kept under edits.

use super::*;
use crate::random::{Numbers, Scene, random_cylinder, random_lines, random_paths, random_segments};
use crate::traits::{ArrangementTraits, BasicTraits};
use crate::trapezoids::Trapezoids;
use exact::planar::Point2;
use std::collections::BTreeMap;

/// Runs a test on arrangements made from seeds on a surface.
fn on<G: ArrangementTraits<Point = Point2> + Clone, T: Topology<G>>(
    seeds: u64,
    most: i64,
    make: impl Fn(&mut Numbers, i64) -> Scene<G, T>,
) {
    for seed in 1..=seeds {
        let mut numbers = Numbers::of_seed(seed);
        let arrangement = make(&mut numbers, most).arrangement();
        agrees(&arrangement, seed);
    }
}

fn agrees<G: UMonotoneTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>, seed: u64) {
    let kept = Trapezoids::of(arrangement);
    let made = VerticalDecomposition::new(arrangement);
    assert_eq!(made.trapezoid_count(), kept.count(), "seed {seed}");
    let topology = arrangement.topology();
    // Sites of the one by those of the other.
    let mut sites: Vec<_> = kept.all_sites().collect();
    sites.sort_by(|&a, &b| {
        let [a, b] = [a, b].map(|site| kept.place(arrangement, site));
        topology.compare_sites(arrangement.traits(), &a, &b)
    });
    let of_site = |s: SiteId| sites[s.index()];
    assert_eq!(sites.len(), made.site_count(), "seed {seed}");
    for s in made.sites() {
        let of = (kept.vertex(of_site(s)), kept.location(of_site(s)));
        assert_eq!((made.vertex(s), made.location(s)), of, "seed {seed}, {s:?}");
    }
}
