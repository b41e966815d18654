//! Where curves meet, the pieces into which they cut each other, and whether they meet at all.

use crate::insert::Pieces;
use crate::sweep::{Around, Event, SweepInput, SweepVisitor, sweep};
use crate::topology::{SiteAt, Topology};
use crate::traits::{ArrangementTraits, BasicTraits, Piece, UMonotoneTraits};
use std::ops::ControlFlow;

/// Whether a point that is an end of every curve through it counts as a meeting of these curves.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum CommonEnds {
    /// It does.
    Count,
    /// It does not.
    Ignore,
}

/// Gives the points that at least two of the curves have in common, in lexicographic order.
///
/// Where curves overlap, only the points are given at which the set of curves that run together changes. Isolated points of the
/// input count as curves. A place where a curve was cut into pieces is no meeting.
///
/// # Complexity
/// That of [`sweep`].
pub fn intersections<G: UMonotoneTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    pieces: &Pieces<G>,
    ends: CommonEnds,
) -> Vec<G::Point> {
    struct Collector<'a, P> {
        ends: CommonEnds,
        is_artificial: &'a [[bool; 2]],
        count: usize,
        points: Vec<P>,
    }
    impl<P> Collector<'_, P> {
        /// Whether a site is where a curve was cut.
        fn is_cut(&self, site: u32) -> bool {
            let (site, curves) = (site as usize, self.is_artificial.len());
            site < 2 * curves && self.is_artificial[site % curves][site / curves]
        }
    }
    impl<G: BasicTraits> SweepVisitor<G> for Collector<'_, G::Point> {
        type Tag = ();

        fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, ()>) -> ControlFlow<()> {
            let given = event.input_sites.iter().filter(|&&site| (site as usize) < self.count).count();
            let (left, right) = (around.left.len(), around.right.len());
            let is_joint =
                given == 2 && left + right == 2 && event.input_sites.iter().all(|&site| self.is_cut(site));
            if is_joint && !event.is_meeting {
                return ControlFlow::Continue(());
            }
            let passes = (0..right).any(|i| around.is_overlap(i)) || event.is_meeting;
            // A curve that passes through runs on to the right and does not begin here; in an overlap it may share its strands with
            // curves that end here. Counting no further than needed, the whole sweep counts each end once.
            let begins =
                event.input_sites.iter().filter(|&&site| (site as usize) < self.is_artificial.len()).count();
            let run_on = || (0..right).flat_map(|i| around.curves_of(i)).take(begins + 1).count();
            let through = passes || run_on() > begins;
            let counts = match self.ends {
                CommonEnds::Count => given > 1 || given == 1 && through || event.is_meeting,
                CommonEnds::Ignore => through && (given > 0 || event.is_meeting),
            };
            if let (true, SiteAt::Point(point)) = (counts, event.site.at) {
                self.points.push(point.clone());
            }
            ControlFlow::Continue(())
        }
    }
    let input = SweepInput::of_curves(traits, topology, &pieces.curves, &pieces.points);
    let count = 2 * pieces.curves.len() + pieces.points.len();
    let is_artificial = &pieces.is_artificial;
    let mut collector = Collector { ends, is_artificial, count, points: Vec::new() };
    let _ = sweep(traits, topology, &input, &mut collector);
    collector.points
}

/// Cuts curves wherever they meet, and gives the pieces: u-monotone curves with disjoint interiors.
///
/// Where curves overlap, the common piece is given once, as a piece of one of them.
///
/// # Complexity
/// That of [`sweep`], and of cutting each piece from its curve.
pub fn subcurves<G: UMonotoneTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    pieces: &Pieces<G>,
) -> Vec<G::UMonotoneCurve> {
    struct Cutter<'a, G: BasicTraits> {
        traits: &'a G,
        curves: &'a [G::UMonotoneCurve],
        /// The point where each piece that is under way began.
        starts: Vec<Option<G::Point>>,
        free: Vec<u32>,
        pieces: Vec<G::UMonotoneCurve>,
    }
    impl<G: UMonotoneTraits> SweepVisitor<G> for Cutter<'_, G> {
        type Tag = u32;

        fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, u32>) -> ControlFlow<()> {
            let point = match event.site.at {
                SiteAt::Point(point) => Some(point),
                SiteAt::End(..) => None,
            };
            // On a side, the curve ends by itself.
            let cut = point.filter(|_| event.site.location.is_interior());
            for strand in around.left {
                let start = self.starts[strand.tag as usize].take();
                self.free.push(strand.tag);
                self.pieces.push(self.traits.trim(&self.curves[strand.curve()], start.as_ref(), cut));
            }
            for strand in around.right.iter_mut() {
                strand.tag = self.free.pop().unwrap_or_else(|| {
                    self.starts.push(None);
                    self.starts.len() as u32 - 1
                });
                self.starts[strand.tag as usize] = cut.cloned();
            }
            ControlFlow::Continue(())
        }
    }
    let input = SweepInput::of_curves(traits, topology, &pieces.curves, &pieces.points);
    let mut cutter =
        Cutter { traits, curves: &pieces.curves, starts: Vec::new(), free: Vec::new(), pieces: Vec::new() };
    let _ = sweep(traits, topology, &input, &mut cutter);
    cutter.pieces
}

/// Tells whether any two of the curves have a point in common. The sweep stops as soon as it is known.
///
/// A curve that meets itself does not count.
///
/// # Complexity
/// That of [`sweep`] up to the first meeting: O(n log n) predicates at most.
pub fn do_any_meet<'a, G: ArrangementTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    curves: impl IntoIterator<Item = &'a G::Curve>,
    ends: CommonEnds,
) -> bool
where
    G::Curve: 'a,
{
    /// The input curve of a subcurve, by the number of its piece.
    struct Watcher {
        ends: CommonEnds,
        owner: Vec<u32>,
        /// For each site: whose it is, and whether it is a true end of it.
        sites: Vec<(u32, bool)>,
        meet: bool,
    }
    impl<G: BasicTraits> SweepVisitor<G> for Watcher {
        type Tag = ();

        fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, ()>) -> ControlFlow<()> {
            let sites = || event.input_sites.iter().filter_map(|&site| self.sites.get(site as usize));
            let left = around.left.iter().map(|strand| self.owner[strand.curve()]);
            let right =
                (0..around.right.len()).flat_map(|i| around.curves_of(i)).map(|curve| self.owner[curve]);
            let mut owners: Vec<u32> = left.chain(right).chain(sites().map(|&(owner, _)| owner)).collect();
            owners.sort_unstable();
            owners.dedup();
            let overlap = (0..around.right.len()).any(|i| around.is_overlap(i));
            let are_all_ends =
                || !overlap && owners.iter().all(|owner| sites().any(|&(o, is_end)| o == *owner && is_end));
            if owners.len() > 1 && (self.ends == CommonEnds::Count || !are_all_ends()) {
                self.meet = true;
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        }
    }
    let mut pieces = Pieces::<G>::new();
    let (mut curve_owner, mut point_owner) = (Vec::new(), Vec::new());
    let mut buffer = Vec::new();
    for (owner, curve) in (0..).zip(curves) {
        traits.make_u_monotone(curve, &mut buffer);
        for piece in buffer.drain(..) {
            match piece {
                Piece::Curve { curve, is_artificial } => {
                    pieces.push_piece(curve, is_artificial);
                    curve_owner.push(owner);
                }
                Piece::Point(point) => {
                    pieces.push_point(point);
                    point_owner.push(owner);
                }
            }
        }
    }
    let input = SweepInput::of_curves(traits, topology, &pieces.curves, &pieces.points);
    let ends_of =
        |end: usize| curve_owner.iter().zip(&pieces.is_artificial).map(move |(&owner, is)| (owner, !is[end]));
    let sites = ends_of(0).chain(ends_of(1)).chain(point_owner.iter().map(|&owner| (owner, true))).collect();
    let mut watcher = Watcher { ends, owner: curve_owner, sites, meet: false };
    let _ = sweep(traits, topology, &input, &mut watcher);
    watcher.meet
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::{Segment, SegmentTraits};
    use crate::topology::BoundedPlane;
    use exact::planar::Point2;

    #[test]
    fn overlaps_meet_where_their_curves_change() {
        let ends = [[[0, 0], [6, 0]], [[2, 0], [8, 0]], [[4, 0], [6, 0]], [[8, 0], [9, 1]]];
        let mut pieces = Pieces::<SegmentTraits>::new();
        for ends in ends {
            pieces.push_curve(Segment::from_i64(ends).expect("the ends are different"));
        }
        let found = |ends| intersections(&SegmentTraits, &BoundedPlane, &pieces, ends);
        let points = |at: &[[i64; 2]]| at.iter().map(|&at| Point2::from_i64(at)).collect::<Vec<_>>();
        assert_eq!(found(CommonEnds::Count), points(&[[2, 0], [4, 0], [6, 0], [8, 0]]));
        assert_eq!(found(CommonEnds::Ignore), points(&[[2, 0], [4, 0], [6, 0]]));
    }
}
