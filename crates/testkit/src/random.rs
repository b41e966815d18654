//! Random numbers that are the same on every machine.

/// The generator splitmix64: its state is its seed, so that a printed state repeats a case.
///
/// ```
/// use splitstar_testkit::Rng;
/// let mut rng = Rng::new(7);
/// let seed = rng.state();
/// let value = rng.below(100);
/// assert_eq!(Rng::new(seed).below(100), value);
/// ```
///
/// # References
/// G. L. Steele, D. Lea, C. H. Flood: Fast splittable pseudorandom number generators, OOPSLA 2014.
#[derive(Clone, Debug)]
pub struct Rng(u64);

impl Rng {
    /// Starts with a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The seed that goes on from here.
    pub fn state(&self) -> u64 {
        self.0
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number below `bound`.
    ///
    /// # Panics
    /// If `bound` is zero.
    pub fn below(&mut self, bound: u64) -> u64 {
        self.bits() % bound
    }

    /// An index below `bound`, or 0.
    pub fn index(&mut self, bound: usize) -> usize {
        (self.bits() % bound.max(1) as u64) as usize
    }

    /// A number from `-range` to `range`.
    pub fn within(&mut self, range: i64) -> i64 {
        self.below(2 * range.unsigned_abs() + 1) as i64 - range
    }

    /// A number from `low` to `high`, both included.
    ///
    /// # Panics
    /// If `high` is below `low`.
    pub fn between(&mut self, low: u64, high: u64) -> u64 {
        low + self.below(high - low + 1)
    }

    /// True once in `n` times.
    pub fn one_in(&mut self, n: u64) -> bool {
        self.below(n) == 0
    }

    /// One of the items.
    ///
    /// # Panics
    /// If there is none.
    pub fn choose<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        &items[self.below(items.len() as u64) as usize]
    }

    /// Puts the items in a random order.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i as u64 + 1) as usize);
        }
    }
}

/// Changes a file at a random place: a bit, a byte, a word of `splices` put in or written over what is there, a piece left
/// out, said twice, or all that follows cut off.
pub fn mutate(file: &mut Vec<u8>, splices: &[&[u8]], rng: &mut Rng) {
    let at = rng.index(file.len() + 1);
    let end = (at + rng.index(40)).min(file.len());
    let splice = rng.choose(splices).iter().copied();
    match rng.below(8) {
        0 if at < file.len() => file[at] ^= 1 << rng.below(8),
        1 if at < file.len() => file[at] = rng.bits() as u8,
        2 => drop(file.splice(at..at, splice)),
        3 => drop(file.splice(at..end, splice)),
        4 => {
            // Over a whole word.
            let is_blank = |byte: &u8| byte.is_ascii_whitespace();
            let end = file[at..].iter().position(is_blank).map_or(file.len(), |length| at + length);
            let start = file[..at].iter().rposition(is_blank).map_or(0, |before| before + 1);
            drop(file.splice(start..end, splice));
        }
        5 => drop(file.drain(at..end)),
        6 => {
            let copy = file[at..end].to_vec();
            let to = rng.index(file.len() + 1);
            drop(file.splice(to..to, copy));
        }
        _ if rng.one_in(8) => file.truncate(at),
        _ => {}
    }
}
