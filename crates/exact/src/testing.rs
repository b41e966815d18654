//! Generated vectors for the tests of this crate.

use crate::{Integer, Rational, Sign, Vector3};

/// The widths in bits that every differential test runs through; 1100 bits overflow `f64`.
pub(crate) const WIDTHS: [u32; 16] = [5, 20, 31, 32, 33, 53, 61, 62, 63, 64, 100, 126, 127, 128, 256, 1100];

/// A small generator (splitmix64). Its seed is printed, so that a failing test can be repeated.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        eprintln!("seed {seed}");
        Self(seed)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Below `bound`.
    pub(crate) fn below(&mut self, bound: u64) -> u64 {
        self.next() % bound
    }

    /// From -bound to bound.
    pub(crate) fn around_zero(&mut self, bound: i64) -> i64 {
        self.below(2 * bound as u64 + 1) as i64 - bound
    }

    /// Exactly this many bits at most, of either sign; now and then an extreme, zero or small value.
    pub(crate) fn integer(&mut self, bits: u32) -> Integer {
        let limit = Integer::ONE << bits;
        let value = match self.below(16) {
            0 => limit - Integer::ONE,
            1 => Integer::ZERO,
            2 => Integer::from(self.below(4)),
            3 => Integer::ONE << (bits - 1),
            _ => {
                let mut value = Integer::ZERO;
                for _ in 0..bits.div_ceil(64) {
                    value = (value << 64) + Integer::from(self.next());
                }
                value.div_rem(&limit).1
            }
        };
        if self.below(2) == 0 { -value } else { value }
    }

    pub(crate) fn vector(&mut self, bits: u32) -> Vector3 {
        Vector3::new([(); 3].map(|()| self.integer(bits)))
    }
}

/// What is hidden in generated vectors.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    Random,
    /// A combination of the others, off by at most one in each coordinate.
    Near,
    /// A combination of the others.
    Degenerate,
}

pub(crate) const KINDS: [Kind; 3] = [Kind::Random, Kind::Near, Kind::Degenerate];

/// Three vectors of about this many bits; linearly dependent, nearly so, or random.
pub(crate) fn triple(random: &mut Random, bits: u32, kind: Kind) -> [Vector3; 3] {
    if kind == Kind::Random {
        return [(); 3].map(|()| random.vector(bits));
    }
    let small = bits.saturating_sub(3).max(1);
    let (a, b) = (random.vector(small), random.vector(small));
    let (k, l) = (Integer::from(random.around_zero(3)), Integer::from(random.around_zero(3)));
    let mut c = &a.scaled(&k) + &b.scaled(&l);
    if kind == Kind::Near {
        c = &c + &Vector3::from_i64([(); 3].map(|()| random.around_zero(1)));
    }
    let mut all = [a, b, c];
    all.rotate_left(random.below(3) as usize);
    all
}

/// Checks that a finite float is the one nearest to a value, ties to even; infinity only beyond the last tie.
pub(crate) fn assert_nearest(value: &Rational, float: f64) {
    let exact = |float: f64| Rational::try_from(float).expect("a finite float");
    if float.is_infinite() {
        let tie = Rational::from((Integer::ONE << 1024) - (Integer::ONE << 970));
        assert!(
            value.abs() >= tie && (value.sign() == Sign::Positive) == (float > 0.0),
            "{value} is not {float}"
        );
        return;
    }
    let error = (value - &exact(float)).abs();
    for neighbour in [float.next_down(), float.next_up()] {
        if neighbour.is_finite() {
            let other = (value - &exact(neighbour)).abs();
            let is_even = float.to_bits() & 1 == 0;
            assert!(error < other || (error == other && is_even), "{value}: {float:e} or {neighbour:e}");
        }
    }
}
