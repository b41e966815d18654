//! Choices that bytes make.

use exact::Rational;
use exact::planar::Point2;

/// The bytes of one step; after the last one, they come again.
pub(super) struct Draw<'a> {
    bytes: &'a [u8],
    next: usize,
    size: u64,
    denominator: i64,
}

impl<'a> Draw<'a> {
    pub(super) fn new(bytes: &'a [u8], size: u64, denominator: i64) -> Self {
        Self { bytes, next: 0, size, denominator }
    }

    pub(super) fn below(&mut self, bound: u64) -> u64 {
        let byte = self.bytes[self.next % self.bytes.len()];
        // The second time round, other numbers.
        let turn = self.next / self.bytes.len();
        self.next += 1;
        u64::from(byte.wrapping_add((turn as u8).wrapping_mul(101))) % bound
    }

    pub(super) fn one_in(&mut self, chances: u64) -> bool {
        self.below(chances) == 0
    }

    /// One of some items, if there are any.
    pub(super) fn choose<X: Clone>(&mut self, items: &[X]) -> Option<X> {
        let bound = u64::try_from(items.len()).ok().filter(|&n| n > 0)?;
        // More than a byte tells apart there never are many of.
        Some(items[self.below(bound) as usize].clone())
    }

    /// From 0 on, on the grid.
    pub(super) fn coordinate(&mut self) -> Rational {
        self.fraction(0)
    }

    /// On the grid, from a lowest number on.
    pub(super) fn fraction(&mut self, lowest: i64) -> Rational {
        let bound = (self.size as i64 - lowest + 1) as u64;
        let numerator = Rational::from(self.below(bound) as i64 + lowest);
        numerator.checked_div(&Rational::from(self.denominator)).expect("a denominator is not zero")
    }

    pub(super) fn point(&mut self) -> Point2 {
        let [u, v] = [self.coordinate(), self.coordinate()];
        Point2::from_rationals(&[u, v])
    }

    /// A vector in any direction.
    pub(super) fn vector(&mut self) -> [Rational; 2] {
        let lowest = -(self.size as i64);
        [self.fraction(lowest), self.fraction(lowest)]
    }

    /// A direction in space: often a pole, or on one of two half meridians.
    pub(super) fn direction(&mut self) -> [i64; 3] {
        let range = self.size.div_ceil(3);
        let mut coordinate = || self.below(2 * range + 1) as i64 - range as i64;
        let [x, y, z] = [coordinate(), coordinate(), coordinate()];
        match self.below(8) {
            0 => [0, 0, if z < 0 { -1 } else { 1 }],
            1 => [-1 - x.abs(), 0, z],
            2 => [1, 0, z],
            _ if [x, y, z] == [0; 3] => [0, 0, 1],
            _ => [x, y, z],
        }
    }
}
