//! The input of the hull, prepared.

use std::borrow::Cow;

use exact::{Point3, share_weight};

/// Points with the same numbers as the caller's, and what speeds up the work on them.
pub(super) struct Sites<'a> {
    /// All points, with one common weight if there is a small one.
    pub(super) points: Cow<'a, [Point3]>,
    /// For each point an approximation. Heuristics use it, decisions do not.
    pub(super) approx: Vec<[f64; 3]>,
    /// The points to look at: for each value at least one.
    pub(super) distinct: Vec<u32>,
}

impl<'a> Sites<'a> {
    pub(super) fn new(points: &'a [Point3]) -> Self {
        let points = with_common_weight(points);
        let approx: Vec<[f64; 3]> = points.iter().map(Point3::approx_f64).collect();
        let distinct = distinct(&points, &approx);
        Self { points, approx, distinct }
    }

    /// Returns a distinct point for which `score` is largest; one that is not a number counts as smallest.
    pub(super) fn best(&self, score: impl Fn([f64; 3]) -> f64) -> u32 {
        let mut best = (f64::NEG_INFINITY, self.distinct[0]);
        for &p in &self.distinct {
            let value = score(self.approx[p as usize]);
            if value > best.0 {
                best = (value, p);
            }
        }
        best.1
    }
}

fn with_common_weight(points: &[Point3]) -> Cow<'_, [Point3]> {
    let weight = points[0].weight();
    if points.iter().all(|p| p.weight() == weight) {
        return Cow::Borrowed(points);
    }
    let mut points = points.to_vec();
    share_weight(&mut points);
    Cow::Owned(points)
}

/// How many points with one hash are compared before a point is taken for a new one.
const MAX_PROBES: usize = 12;

/// Returns the points without repetitions, the first one of each value, in order.
///
/// The hull is correct without this, but sums of symmetric bodies repeat each point often. So the search may
/// miss a repetition: it hashes approximations, and gives up where many different points have the same one.
///
/// # Complexity
/// O(n).
fn distinct(points: &[Point3], approx: &[[f64; 3]]) -> Vec<u32> {
    const EMPTY: u32 = u32::MAX;
    let bits = (2 * points.len()).next_power_of_two().ilog2().max(4);
    let mask = (1usize << bits) - 1;
    let mut table = vec![EMPTY; 1 << bits];
    let mut distinct = Vec::with_capacity(points.len());
    for (p, point) in points.iter().enumerate() {
        let mut slot = (hash(approx[p]) >> (64 - bits)) as usize;
        let mut probes = 0;
        let is_new = loop {
            let other = table[slot];
            if other == EMPTY {
                table[slot] = p as u32;
                break true;
            }
            if same_bits(approx[other as usize], approx[p]) && points[other as usize] == *point {
                break false;
            }
            probes += 1;
            if probes == MAX_PROBES {
                break true;
            }
            slot = (slot + 1) & mask;
        };
        if is_new {
            distinct.push(p as u32);
        }
    }
    distinct
}

fn same_bits(a: [f64; 3], b: [f64; 3]) -> bool {
    a.map(f64::to_bits) == b.map(f64::to_bits)
}

fn hash(position: [f64; 3]) -> u64 {
    position
        .into_iter()
        .fold(0u64, |state, x| (state ^ x.to_bits()).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(29))
        .wrapping_mul(0xD6E8_FEB8_6659_FD93)
}
