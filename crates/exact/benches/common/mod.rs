//! Random numbers, and a timer.

use std::hint::black_box;
use std::time::Instant;

/// So many inputs that the branch predictor does not learn the answers by heart, few enough for the cache.
pub(crate) const INPUTS: usize = 4096;
const PASSES: u32 = 20;

/// splitmix64
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}

/// The least time of a pass, in nanoseconds per call.
pub(crate) fn time<T, R>(inputs: &[T], mut call: impl FnMut(&T) -> R) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..PASSES {
        let start = Instant::now();
        for input in inputs {
            black_box(call(black_box(input)));
        }
        least = least.min(start.elapsed().as_nanos() as f64);
    }
    least / inputs.len() as f64
}
