//! The pieces into which curves cut each other.

use super::owners::Owned;
use crate::sweep::{Around, Event, SweepVisitor, sweep};
use crate::topology::{SiteAt, Topology};
use crate::traits::{ArrangementTraits, CurveEnd, UMonotoneTraits};
use std::ops::ControlFlow;

/// Cuts curves wherever they meet, themselves and each other, and wherever one of the points lies on them, and gives the pieces:
/// u-monotone curves with disjoint interiors.
///
/// Where curves overlap, the common piece is given once, as a piece of one of them. A curve along an identified side is cut where
/// another one comes to it from either side.
///
/// # Complexity
/// That of [`sweep`], and of cutting each piece from its curve.
pub fn subcurves<'a, G: ArrangementTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    curves: impl IntoIterator<Item = &'a G::Curve>,
    points: &[G::Point],
) -> Vec<G::UMonotoneCurve>
where
    G::Curve: 'a,
{
    let owned = Owned::new(traits, curves, points);
    let mut cutter = Cutter {
        traits,
        topology,
        curves: &owned.curves,
        starts: Vec::new(),
        free: Vec::new(),
        pieces: Vec::new(),
    };
    let _ = sweep(traits, topology, &owned.input(traits, topology), &mut cutter);
    cutter.pieces
}

struct Cutter<'a, G: UMonotoneTraits, T> {
    traits: &'a G,
    topology: &'a T,
    curves: &'a [G::UMonotoneCurve],
    /// The point where each piece that is under way was cut off.
    starts: Vec<Option<G::Point>>,
    free: Vec<u32>,
    pieces: Vec<G::UMonotoneCurve>,
}

impl<G: UMonotoneTraits, T: Topology<G>> Cutter<'_, G, T> {
    /// The point where a curve has to be cut at an event; `None` if it ends there by itself, on a side.
    fn cut<'e>(&self, event: &Event<'e, G>, curve: usize, end: CurveEnd) -> Option<&'e G::Point> {
        let (curve, location) = (&self.curves[curve], event.site.location);
        let SiteAt::Point(point) = event.site.at else { return None };
        let ends_here = || {
            self.topology.end_location(self.traits, curve, end) == location
                && self.traits.end_point(curve, end).is_some_and(|p| self.traits.is_same_point(p, point))
        };
        // In the interior a point that is the end cuts nothing. On a side, it may also be the point of the other end.
        if !location.is_interior() && ends_here() { None } else { Some(point) }
    }
}

impl<G: UMonotoneTraits, T: Topology<G>> SweepVisitor<G> for Cutter<'_, G, T> {
    type Tag = u32;

    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, u32>) -> ControlFlow<()> {
        for strand in around.left {
            let start = self.starts[strand.tag as usize].take();
            self.free.push(strand.tag);
            let max = self.cut(event, strand.curve(), CurveEnd::Max);
            self.pieces.push(self.traits.trim(&self.curves[strand.curve()], start.as_ref(), max));
        }
        for strand in around.right.iter_mut() {
            strand.tag = self.free.pop().unwrap_or_else(|| {
                self.starts.push(None);
                self.starts.len() as u32 - 1
            });
            self.starts[strand.tag as usize] = self.cut(event, strand.curve(), CurveEnd::Min).cloned();
        }
        ControlFlow::Continue(())
    }
}
