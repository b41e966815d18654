//! What a sweep tells, and to whom.

use crate::topology::Site;
use crate::traits::BasicTraits;
use std::ops::ControlFlow;

/// One who watches a sweep, and may stop it.
///
/// # References
/// Thesis, section 2.4.1, `SweepLineVisitor`.
pub trait SweepVisitor<G: BasicTraits> {
    /// What the visitor attaches to a subcurve when it begins, and gets back when it ends.
    type Tag: Copy + Default;

    /// An event: subcurves end here, others begin, or a point lies here by itself.
    ///
    /// Every tag of `around.right` is to be set; they begin as the default.
    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, Self::Tag>) -> ControlFlow<()>;
}

/// Where an event is, and why.
#[derive(Debug)]
pub struct Event<'e, G: BasicTraits> {
    /// The place.
    pub site: Site<'e, G>,
    /// The sites of the input that are there, by their numbers; empty if curves only meet.
    pub input_sites: &'e [u32],
    /// Whether curves that are no neighbours in the input meet: one of them passes through.
    pub is_meeting: bool,
}

/// A subcurve: what runs between two consecutive events of one curve, or of several that overlap.
#[derive(Clone, Copy, Debug)]
pub struct Strand<T> {
    pub(super) head: u32,
    /// What the visitor attached.
    pub tag: T,
}

impl<T> Strand<T> {
    /// The number of one of the curves that run here.
    #[inline]
    pub fn curve(&self) -> usize {
        self.head as usize
    }
}

/// Where a curve is on the status line: the curves of a strand are a list.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    /// The first curve of the list; one that has ended leads on to another.
    pub(super) leader: u32,
    /// For the first curve, the node of the strand.
    pub(super) node: u32,
    pub(super) prev: u32,
    pub(super) next: u32,
}

impl Link {
    /// A curve that is not on the status line.
    pub(super) fn alone(curve: u32) -> Self {
        let none = super::status::NIL;
        Self { leader: curve, node: none, prev: none, next: none }
    }
}

/// What is around an event.
#[derive(Debug)]
pub struct Around<'s, T> {
    /// The tag of the subcurve next below, if there is one.
    pub below: Option<T>,
    /// The tag of the subcurve next above.
    pub above: Option<T>,
    /// The subcurves that end here, from bottom to top.
    pub left: &'s [Strand<T>],
    /// The subcurves that begin here, from bottom to top.
    pub right: &'s mut [Strand<T>],
    pub(super) links: &'s [Link],
}

impl<T> Around<'_, T> {
    /// The numbers of all curves that run along a subcurve that begins here.
    pub fn curves_of(&self, right: usize) -> Members<'_> {
        Members { links: self.links, next: self.right[right].head }
    }

    /// Tells whether several curves overlap in a subcurve that begins here.
    #[inline]
    pub fn is_overlap(&self, right: usize) -> bool {
        self.links[self.right[right].head as usize].next != super::status::NIL
    }
}

/// The curves of a subcurve.
#[derive(Clone, Debug)]
pub struct Members<'s> {
    links: &'s [Link],
    next: u32,
}

impl Iterator for Members<'_> {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        if self.next == super::status::NIL {
            return None;
        }
        let curve = self.next as usize;
        self.next = self.links[curve].next;
        Some(curve)
    }
}
