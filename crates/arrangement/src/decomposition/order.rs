//! Trapezoids numbered along edges.

use super::records::{TrapezoidRecord, key};
use dcel::EdgeId;
use std::ops::Range;

/// Puts numbers into groups by a key, within a group in the order given: for each key the place of its first one, and one more.
pub(super) fn firsts(keys: impl Iterator<Item = u32>, edge_bound: usize) -> Vec<u32> {
    let mut firsts = vec![0; edge_bound + 2];
    for edge in keys {
        firsts[key(edge)] += 1;
    }
    let mut sum = 0;
    for first in &mut firsts {
        sum += std::mem::replace(first, sum);
    }
    firsts
}

/// The places of the group of an edge, or of none; empty for an edge that is not there.
#[inline]
pub(super) fn row(firsts: &[u32], e: Option<EdgeId>) -> Range<u32> {
    // The greatest id is not to be taken for none.
    let key = e.map_or(0, |e| e.index().saturating_add(1));
    match firsts.get(key..) {
        Some(&[first, end, ..]) => first..end,
        _ => 0..0,
    }
}

/// Undoes that each first place was moved to behind the last.
pub(super) fn shift_back(firsts: &mut [u32]) {
    firsts.copy_within(..firsts.len() - 1, 1);
    firsts[0] = 0;
}

/// For trapezoids from left to right their numbers by the edge below, and the first number of each edge.
pub(super) fn number_by_below(raw: &[TrapezoidRecord], edge_bound: usize) -> (Vec<u32>, Vec<u32>) {
    let mut firsts = firsts(raw.iter().map(|t| t.below), edge_bound);
    let numbers = raw
        .iter()
        .map(|t| {
            let next = &mut firsts[key(t.below)];
            *next += 1;
            *next - 1
        })
        .collect();
    shift_back(&mut firsts);
    (numbers, firsts)
}
