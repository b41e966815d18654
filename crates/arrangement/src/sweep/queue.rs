//! The meetings that lie ahead of the sweep line: a heap with four children a node, whose order the caller supplies.
//!
//! `std`'s heap compares by `Ord`, which cannot reach the traits object that compares points.

use crate::traits::Multiplicity;
use std::cmp::Ordering;

/// A common point of two curves, found and not yet reached.
#[derive(Debug)]
pub(super) struct Ahead<P> {
    pub(super) point: P,
    /// The order key of the point; 0 if it has none.
    pub(super) key: u64,
    pub(super) curves: [u32; 2],
    pub(super) multiplicity: Multiplicity,
}

#[derive(Debug)]
pub(super) struct Queue<P> {
    slots: Vec<Option<Ahead<P>>>,
    free: Vec<u32>,
    /// Keys beside slots, so that the points are rarely looked at.
    heap: Vec<(u64, u32)>,
}

impl<P> Queue<P> {
    pub(super) fn new() -> Self {
        Self { slots: Vec::new(), free: Vec::new(), heap: Vec::new() }
    }

    /// The first meeting.
    #[inline]
    pub(super) fn first(&self) -> Option<&Ahead<P>> {
        self.heap.first().map(|&(_, slot)| self.at(slot))
    }

    pub(super) fn push(&mut self, ahead: Ahead<P>, is_less: impl Fn(&P, &P) -> bool) {
        let key = ahead.key;
        let slot = match self.free.pop() {
            Some(slot) => {
                self.slots[slot as usize] = Some(ahead);
                slot
            }
            None => {
                self.slots.push(Some(ahead));
                u32::try_from(self.slots.len() - 1).expect("fewer than 2^32 meetings lie ahead")
            }
        };
        let place = self.heap.len();
        self.heap.push((key, slot));
        self.rise(place, (key, slot), is_less);
    }

    pub(super) fn pop(&mut self, is_less: impl Fn(&P, &P) -> bool) -> Option<Ahead<P>> {
        let &(_, first) = self.heap.first()?;
        let moved = self.heap.pop()?;
        if !self.heap.is_empty() {
            self.sink(moved, is_less);
        }
        self.free.push(first);
        self.slots[first as usize].take()
    }

    /// Puts an entry at the root, and lets it sink to its place: all the way down along the least children, then up again, which
    /// compares less, because what comes from the end of the heap belongs near it.
    fn sink(&mut self, entry: (u64, u32), is_less: impl Fn(&P, &P) -> bool) {
        let mut place = 0;
        loop {
            let first_child = 4 * place + 1;
            if first_child >= self.heap.len() {
                break;
            }
            let mut least = first_child;
            for child in first_child + 1..(first_child + 4).min(self.heap.len()) {
                if self.is_before(self.heap[child], self.heap[least], &is_less) {
                    least = child;
                }
            }
            self.heap[place] = self.heap[least];
            place = least;
        }
        self.rise(place, entry, is_less);
    }

    /// Puts an entry at a free place, and lets it rise.
    fn rise(&mut self, mut place: usize, entry: (u64, u32), is_less: impl Fn(&P, &P) -> bool) {
        while place > 0 {
            let parent = (place - 1) / 4;
            if !self.is_before(entry, self.heap[parent], &is_less) {
                break;
            }
            self.heap[place] = self.heap[parent];
            place = parent;
        }
        self.heap[place] = entry;
    }

    #[inline]
    fn is_before(&self, a: (u64, u32), b: (u64, u32), is_less: impl Fn(&P, &P) -> bool) -> bool {
        match compare_keys(a.0, b.0) {
            Some(order) => order.is_lt(),
            None => is_less(&self.at(a.1).point, &self.at(b.1).point),
        }
    }

    #[inline]
    fn at(&self, slot: u32) -> &Ahead<P> {
        self.slots[slot as usize].as_ref().expect("a slot in the heap is filled")
    }
}

/// The order of two points, if their keys tell it.
#[inline]
pub(super) fn compare_keys(a: u64, b: u64) -> Option<Ordering> {
    (a != b && a != 0 && b != 0).then(|| a.cmp(&b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meetings_come_in_order() {
        let mut random = 1_u64;
        let mut queue = Queue::new();
        let mut model = Vec::new();
        let less = |a: &u32, b: &u32| a < b;
        for step in 0..3000 {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let value = (random >> 40) as u32 % 500;
            if step % 3 == 2 {
                model.sort_unstable_by(|a: &u32, b| b.cmp(a));
                assert_eq!(queue.first().map(|ahead| ahead.point), model.last().copied());
                assert_eq!(queue.pop(less).map(|ahead| ahead.point), model.pop());
            } else {
                let (key, curves) = (u64::from(value / 16 * (value % 2)), [0, 1]);
                queue.push(Ahead { point: value, key, curves, multiplicity: Multiplicity::Odd }, less);
                model.push(value);
            }
        }
    }
}
