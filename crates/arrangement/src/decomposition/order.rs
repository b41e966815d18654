//! Trapezoids numbered along edges.

use super::records::{TrapezoidRecord, key};

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
