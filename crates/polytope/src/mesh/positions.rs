//! Points at equal positions found.

use exact::Point3;
use std::hash::{BuildHasher, Hash, Hasher, RandomState};

const NONE: u32 = u32::MAX;

/// For each point the first one at the same position.
///
/// # Complexity
/// Expected linear, and up to twelve bytes a point beside the answer. What is hashed is mixed with a number
/// that no input knows.
pub(super) fn first_at_position(points: &[Point3]) -> Vec<u32> {
    // Indices of points; at most three of four slots are taken.
    let mut slots = vec![NONE; (points.len() + points.len() / 3 + 1).next_power_of_two()];
    let mask = slots.len() - 1;
    let seed = RandomState::new().hash_one(0_u64);
    let mut first = Vec::with_capacity(points.len());
    for (v, point) in points.iter().enumerate() {
        let mut mixer = Mixer(seed);
        point.canonical_key().hash(&mut mixer);
        let mut slot = mixer.finish() as usize & mask;
        while slots[slot] != NONE && points[slots[slot] as usize] != *point {
            slot = (slot + 1) & mask;
        }
        if slots[slot] == NONE {
            slots[slot] = v as u32;
        }
        first.push(slots[slot]);
    }
    first
}

/// Folded products: of all bits of a word each changes about half of the result.
struct Mixer(u64);

impl Mixer {
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;

    fn mix(&mut self, word: u64) {
        let product = u128::from(self.0 ^ word) * u128::from(Self::FACTOR);
        self.0 = (product >> 64) as u64 ^ product as u64;
    }
}

impl Hasher for Mixer {
    fn write(&mut self, bytes: &[u8]) {
        let (words, rest) = bytes.as_chunks();
        words.iter().for_each(|word| self.mix(u64::from_le_bytes(*word)));
        if !rest.is_empty() {
            let mut last = [0; 8];
            last[..rest.len()].copy_from_slice(rest);
            self.mix(u64::from_le_bytes(last));
        }
    }

    fn write_u64(&mut self, word: u64) {
        self.mix(word);
    }

    fn finish(&self) -> u64 {
        let mut last = Self(self.0);
        last.mix(Self::FACTOR);
        last.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use exact::Rational;
    use std::collections::HashMap;

    /// As with a table of exact texts, for points of all widths and weights.
    #[test]
    fn finds_the_first() {
        assert!(first_at_position(&[]).is_empty());
        let coordinates: Vec<Rational> = ["0", "1", "-1", "1/3", "2/7", "1e-30", "123456789012345678901/3"]
            .iter()
            .map(|text| text.parse().expect("a number"))
            .collect();
        let pick = |i: usize| coordinates[i % coordinates.len()].clone();
        let mut points: Vec<Point3> =
            (0..2000).map(|i| Point3::from_rationals(&[pick(i), pick(i * i / 5), pick(i / 49)])).collect();
        points.extend((0..500).map(|i| Point3::from_i64([i, 0, 0])));
        exact::share_weight(&mut points[..1000]);
        let mut known = HashMap::new();
        let expected: Vec<u32> =
            (0..).zip(&points).map(|(v, point)| *known.entry(point.to_string()).or_insert(v)).collect();
        assert_eq!(first_at_position(&points), expected);
        assert!(known.len() > 600 && known.len() < points.len() - 600, "{} positions", known.len());
    }
}
