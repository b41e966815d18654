//! A visitor that counts and checks.

use splitstar_arrangement::sweep::{Around, Event, SweepInput, SweepVisitor, sweep};
use splitstar_arrangement::topology::{Site, SiteAt, Topology};
use splitstar_arrangement::traits::{Location, UMonotoneTraits};
use std::cmp::Ordering;
use std::ops::ControlFlow;

/// What there is to count.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Counts {
    /// Different places of points: those on identified sides have several.
    pub(crate) points: usize,
    /// Pieces between points, those of overlapping curves once.
    pub(crate) strands: usize,
    /// Pieces between points, for each curve.
    pub(crate) members: usize,
}

/// Counts, and keeps a status line of its own, with which every event has to agree.
struct Watcher<'a, G: UMonotoneTraits, T> {
    traits: &'a G,
    topology: &'a T,
    curves: &'a [G::UMonotoneCurve],
    counts: Counts,
    status: Vec<u32>,
    last_tag: u32,
    last: Option<(Location, G::Point)>,
}

impl<G: UMonotoneTraits, T: Topology<G>> SweepVisitor<G> for Watcher<'_, G, T> {
    type Tag = u32;

    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, u32>) -> ControlFlow<()> {
        let first = around
            .below
            .map_or(0, |tag| 1 + self.status.iter().position(|&other| other == tag).expect("below is known"));
        let after = first + around.left.len();
        let left: Vec<u32> = around.left.iter().map(|strand| strand.tag).collect();
        assert_eq!(self.status[first..after], left, "what ends lies above what is below");
        assert_eq!(self.status.get(after).copied(), around.above, "what is above follows");
        for i in 0..around.right.len() {
            self.last_tag += 1;
            around.right[i].tag = self.last_tag;
            self.counts.strands += 1;
            self.counts.members += around.curves_of(i).count();
            if let Some(p) = event.site.point() {
                for curve in around.curves_of(i) {
                    assert!(self.traits.is_on_curve(p, &self.curves[curve]), "{p:?} is on what begins there");
                }
            }
        }
        self.status.splice(first..after, around.right.iter().map(|strand| strand.tag));
        if let Some(p) = event.site.point() {
            if let Some((location, last)) = &self.last {
                let last = Site { location: *location, at: SiteAt::Point(last) };
                let order = self.topology.compare_sites(self.traits, &last, &event.site);
                assert_eq!(order, Ordering::Less, "before {p:?}: points come in order");
            }
            self.last = Some((event.site.location, p.clone()));
            self.counts.points += 1;
        }
        ControlFlow::Continue(())
    }
}

pub(crate) fn swept<G: UMonotoneTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    curves: &[G::UMonotoneCurve],
    points: &[G::Point],
) -> Counts {
    let mut watcher = Watcher {
        traits,
        topology,
        curves,
        counts: Counts::default(),
        status: Vec::new(),
        last_tag: 0,
        last: None,
    };
    let input = SweepInput::of_curves(traits, topology, curves, points);
    assert!(sweep(traits, topology, &input, &mut watcher).is_continue());
    assert!(watcher.status.is_empty(), "the status line is empty in the end");
    watcher.counts
}
