//! The table of positions: which vertex is already there.

use crate::base::budget::Budget;
use crate::base::error::Fault;
use std::hash::{BuildHasher, RandomState};

/// A position, in a form in which equal positions are identical.
pub(super) trait Key: Copy + Eq + Default {
    /// A hash that cannot be foreseen without the secret numbers.
    fn hash(&self, secret: &[u64; 4]) -> u64;
}

/// Three 32-bit floats by their bits; zero has no sign.
impl Key for [u32; 3] {
    #[inline]
    fn hash(&self, secret: &[u64; 4]) -> u64 {
        let [x, y, z] = self.map(u64::from);
        // Once more: the floats of a grid have few different bits, and a product keeps some of their pattern.
        mix(mix((x << 32 | y) ^ secret[0], z ^ secret[1]) ^ secret[2], secret[3] | 1)
    }
}

/// The homogeneous coordinates of a narrow canonical point.
impl Key for [i64; 4] {
    #[inline]
    fn hash(&self, secret: &[u64; 4]) -> u64 {
        let [x, y, z, w] = self.map(|value| value as u64);
        let [a, b, c, d] = *secret;
        mix(mix(x ^ a, y ^ b) ^ c, mix(z ^ c, w ^ d) ^ b)
    }
}

/// Both halves of a product of 128 bits: each bit depends on many of both factors.
#[inline]
fn mix(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    product as u64 ^ (product >> 64) as u64
}

/// Positions with the indices of their vertices, in one array with open addressing: the entry of a position is the
/// first free one from the place on that its hash gives.
#[derive(Debug)]
pub(super) struct Welder<K> {
    /// A position with its index plus 1; 0 where there is none. The number of entries is a power of two.
    entries: Vec<(K, u32)>,
    used: usize,
    /// The hash depends on a secret of the process, so that no file can be made to be slow. No result depends on it.
    secret: [u64; 4],
}

/// A place where a position can be entered.
#[derive(Clone, Copy, Debug)]
pub(super) struct Free(usize);

impl<K: Key> Welder<K> {
    /// An empty table, with room for some positions, which the file must really have.
    pub(super) fn new(positions: usize, budget: &mut Budget) -> Result<Self, Fault> {
        let random = RandomState::new();
        let secret = [0, 1, 2, 3].map(|number: u32| random.hash_one(number));
        let count = (positions + positions / 2).max(64).next_power_of_two();
        Ok(Self { entries: Self::free_entries(count, budget)?, used: 0, secret })
    }

    fn free_entries(count: usize, budget: &mut Budget) -> Result<Vec<(K, u32)>, Fault> {
        budget.charge(count as u64 * size_of::<(K, u32)>() as u64)?;
        Ok(vec![(K::default(), 0); count])
    }

    /// The index of a position, or the place where it can be entered before the next is looked for.
    #[inline]
    pub(super) fn find(&self, key: &K) -> Result<u32, Free> {
        let mask = self.entries.len() - 1;
        let mut at = self.hash(key) & mask;
        loop {
            let (there, name) = &self.entries[at];
            match name.checked_sub(1) {
                None => return Err(Free(at)),
                Some(index) if there == key => return Ok(index),
                Some(_) => at = (at + 1) & mask,
            }
        }
    }

    /// Enters a position. The index is below 2^32 - 1.
    #[inline]
    pub(super) fn enter(
        &mut self,
        Free(at): Free,
        key: K,
        index: u32,
        budget: &mut Budget,
    ) -> Result<(), Fault> {
        self.entries[at] = (key, index + 1);
        self.used += 1;
        // A quarter of the entries stays free, so that searches end soon.
        if self.used > self.entries.len() / 4 * 3 { self.grow(budget) } else { Ok(()) }
    }

    #[cold]
    fn grow(&mut self, budget: &mut Budget) -> Result<(), Fault> {
        let free = Self::free_entries(2 * self.entries.len(), budget)?;
        let full = std::mem::replace(&mut self.entries, free);
        for (key, name) in full.into_iter().filter(|&(_, name)| name != 0) {
            if let Err(Free(at)) = self.find(&key) {
                self.entries[at] = (key, name);
            }
        }
        Ok(())
    }

    #[inline]
    fn hash(&self, key: &K) -> usize {
        let hash = key.hash(&self.secret);
        (hash ^ hash >> 32) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    #[test]
    fn the_table_agrees_with_the_one_of_the_library() {
        let mut budget = Budget::of_file(0);
        let mut welder = Welder::new(0, &mut budget).unwrap();
        let mut map = HashMap::new();
        let mut state = 1_u64;
        for _ in 0..20_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let key = [40, 50, 60].map(|shift| ((state >> shift) % 17) as u32);
            let next = map.len() as u32;
            let expected = *map.entry(key).or_insert(next);
            let index = welder.find(&key).unwrap_or_else(|free| {
                welder.enter(free, key, next, &mut budget).unwrap();
                next
            });
            assert_eq!(index, expected);
        }
        assert!(map.len() > 4_000);
    }

    #[test]
    fn regular_positions_are_spread() {
        // A grid of floats has few different bits, and those not in the last places.
        let mut budget = Budget::of_file(1 << 20);
        let mut welder = Welder::new(0, &mut budget).unwrap();
        let (mut count, mut steps) = (0_u32, 0_usize);
        for cell in 0..40_u32.pow(3) {
            let key = [cell % 40, cell / 40 % 40, cell / 1600].map(|step| (step as f32).to_bits());
            let Err(free) = welder.find(&key) else { panic!("all cells are different") };
            let mask = welder.entries.len() - 1;
            steps += free.0.wrapping_sub(welder.hash(&key)) & mask;
            welder.enter(free, key, count, &mut budget).unwrap();
            count += 1;
        }
        assert!(steps < 4 * count as usize, "{steps} steps for {count}");
    }

    #[test]
    fn a_table_takes_no_more_than_the_budget() {
        let mut budget = Budget::of_file(0);
        let mut welder = Welder::new(0, &mut budget).unwrap();
        let failed = (0..4_000_000).find(|&at| match welder.find(&[0, 7, at]) {
            Ok(_) => panic!("all positions are different"),
            Err(free) => welder.enter(free, [0, 7, at], at, &mut budget).is_err(),
        });
        assert!(failed.is_some());
    }
}
