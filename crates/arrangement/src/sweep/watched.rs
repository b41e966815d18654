//! A visitor that tells how far the sweep has come.

use super::visitor::{Around, Event, SweepVisitor};
use crate::traits::BasicTraits;
use std::ops::ControlFlow;

/// How far a sweep has come.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Progress {
    /// How many sites of the input were met: ends of curves, and points.
    pub sites_met: usize,
    /// How many there are.
    pub sites: usize,
    /// How many events there were, meetings of curves included.
    pub events: usize,
}

/// How many events pass between two calls.
const STRIDE: usize = 1024;

/// A visitor around another one.
#[derive(Debug)]
pub struct Watched<V, F> {
    inner: V,
    watch: F,
    progress: Progress,
}

impl<V, F: FnMut(Progress) -> ControlFlow<()>> Watched<V, F> {
    /// Puts `watch` beside a visitor of a sweep over so many sites.
    pub fn new(inner: V, sites: usize, watch: F) -> Self {
        Self { inner, watch, progress: Progress { sites_met: 0, sites, events: 0 } }
    }

    /// Gives the visitor back.
    pub fn into_inner(self) -> V {
        self.inner
    }
}

impl<G: BasicTraits, V: SweepVisitor<G>, F: FnMut(Progress) -> ControlFlow<()>> SweepVisitor<G>
    for Watched<V, F>
{
    type Tag = V::Tag;

    #[inline]
    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, V::Tag>) -> ControlFlow<()> {
        self.progress.events += 1;
        self.progress.sites_met += event.input_sites.len();
        if self.progress.events.is_multiple_of(STRIDE) {
            (self.watch)(self.progress)?;
        }
        self.inner.event(event, around)
    }
}
