//! Searching along the ring of a face.

use dcel::HalfedgeId;

/// The first index, from `first` on and at most `limit` steps further around the ring, at which the
/// condition holds; the last one if it holds nowhere before. The condition must stay true once it is.
#[inline]
pub(super) fn first_where(
    ring: &[HalfedgeId],
    first: usize,
    limit: usize,
    mut condition: impl FnMut(HalfedgeId) -> bool,
) -> usize {
    let wrap = |i: usize| if i >= ring.len() { i - ring.len() } else { i };
    let first = wrap(first);
    // Step, then gallop: `low` is the number of steps known to be too few.
    let (mut low, mut step) = (0, 0);
    while step < limit && !condition(ring[wrap(first + step)]) {
        low = step + 1;
        step += if step < 4 { 1 } else { step };
    }
    let mut high = step.min(limit);
    while low < high {
        let middle = low + (high - low) / 2;
        if condition(ring[wrap(first + middle)]) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    wrap(first + high)
}

/// The first index from `first` on at which the condition holds, `last` if there is none before it.
#[inline]
pub(super) fn first_between(
    ring: &[HalfedgeId],
    first: u32,
    last: u32,
    condition: impl FnMut(HalfedgeId) -> bool,
) -> usize {
    let (first, last) = (first as usize, last as usize);
    let steps = if last >= first { last - first } else { last + ring.len() - first };
    first_where(ring, first, steps, condition)
}
