//! Fixed-width two's complement integers with products of mixed width: exact evaluation without the heap.
//!
//! The product of A and B limbs has A + B limbs, so no product overflows, and the cheap case (a wide number times a
//! machine word) costs what it must and no more. Sums keep the width of their terms: the bounds in [`crate::tier`]
//! leave room for eight terms, and debug builds check it.

use crate::Sign;
use crate::tier::Ring;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

/// A two's complement integer of `N` limbs of 64 bits, the lowest limb first.
///
/// ```
/// use exact::fixed::Fixed;
/// let square: Fixed<2> = Fixed::<1>::from(i64::MIN) * Fixed::<1>::from(i64::MIN);
/// assert_eq!(square, Fixed::<2>::from(1_i128 << 126));
/// let cube: Fixed<3> = square * Fixed::<1>::from(-1_i64);
/// assert_eq!(cube.to_string(), "-85070591730234615865843651857942052864");
/// ```
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Fixed<const N: usize>(pub(crate) [u64; N]);

impl<const N: usize> Fixed<N> {
    /// Gives the sign.
    #[inline(always)]
    pub fn sign(&self) -> Sign {
        if (self.0[N - 1] as i64) < 0 {
            Sign::Negative
        } else if self.0.iter().fold(0, |all, limb| all | limb) == 0 {
            Sign::Zero
        } else {
            Sign::Positive
        }
    }

    /// All ones if the number is negative, else zero.
    #[inline(always)]
    fn mask(&self) -> u64 {
        ((self.0[N - 1] as i64) >> 63) as u64
    }

    // A limb loop reads two numbers at one index and carries on.
    #[allow(clippy::needless_range_loop)]
    #[inline(always)]
    fn wrapping_add(&self, other: &Self) -> Self {
        let mut out = [0; N];
        let mut carry = false;
        for i in 0..N {
            let (sum, first) = self.0[i].overflowing_add(other.0[i]);
            let (sum, second) = sum.overflowing_add(u64::from(carry));
            out[i] = sum;
            carry = first | second;
        }
        Self(out)
    }

    // A limb loop reads two numbers at one index and carries on.
    #[allow(clippy::needless_range_loop)]
    #[inline(always)]
    fn wrapping_sub(&self, other: &Self) -> Self {
        let mut out = [0; N];
        let mut borrow = false;
        for i in 0..N {
            let (difference, first) = self.0[i].overflowing_sub(other.0[i]);
            let (difference, second) = difference.overflowing_sub(u64::from(borrow));
            out[i] = difference;
            borrow = first | second;
        }
        Self(out)
    }
}

/// Multiplies exactly. The widths are checked when the program is compiled.
#[inline(always)]
pub fn product<const A: usize, const B: usize, const P: usize>(a: &Fixed<A>, b: &Fixed<B>) -> Fixed<P> {
    const { assert!(A >= 1 && B >= 1 && A + B == P, "a product has the limbs of both factors") };
    let mut out = [0_u64; P];
    if A == 1 && B == 1 {
        let value = i128::from(a.0[0] as i64) * i128::from(b.0[0] as i64);
        out[0] = value as u64;
        out[1] = (value >> 64) as u64;
        return Fixed(out);
    }
    for i in 0..A {
        let mut carry = 0_u64;
        for j in 0..B {
            // (2^64-1)^2 + 2 (2^64-1) = 2^128 - 1: no overflow.
            let sum = u128::from(a.0[i]) * u128::from(b.0[j]) + u128::from(out[i + j]) + u128::from(carry);
            out[i + j] = sum as u64;
            carry = (sum >> 64) as u64;
        }
        out[i + B] = carry;
    }
    // Read as unsigned, a negative a is a + 2^(64 A): take 2^(64 A) b off again, and likewise for b. The term
    // 2^(64 (A + B)) of two negative factors is 0 in P limbs.
    subtract_shifted(&mut out, A, &b.0, a.mask());
    subtract_shifted(&mut out, B, &a.0, b.mask());
    Fixed(out)
}

/// out -= (limbs & mask) << (64 shift), modulo 2^(64 P).
#[inline(always)]
fn subtract_shifted<const P: usize, const K: usize>(
    out: &mut [u64; P],
    shift: usize,
    limbs: &[u64; K],
    mask: u64,
) {
    let mut borrow = false;
    for j in 0..K {
        let (difference, first) = out[shift + j].overflowing_sub(limbs[j] & mask);
        let (difference, second) = difference.overflowing_sub(u64::from(borrow));
        out[shift + j] = difference;
        borrow = first | second;
    }
}

impl From<i64> for Fixed<1> {
    #[inline(always)]
    fn from(value: i64) -> Self {
        Self([value as u64])
    }
}

impl From<i128> for Fixed<2> {
    #[inline(always)]
    fn from(value: i128) -> Self {
        Self([value as u64, (value >> 64) as u64])
    }
}

impl From<i64> for Fixed<2> {
    #[inline(always)]
    fn from(value: i64) -> Self {
        Self([value as u64, (value >> 63) as u64])
    }
}

impl<const N: usize> Add for Fixed<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let sum = self.wrapping_add(&other);
        debug_assert!(
            self.mask() != other.mask() || self.mask() == sum.mask(),
            "a sum exceeds the width of its terms"
        );
        sum
    }
}

impl<const N: usize> Sub for Fixed<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let difference = self.wrapping_sub(&other);
        debug_assert!(
            self.mask() == other.mask() || self.mask() == difference.mask(),
            "a difference exceeds the width of its terms"
        );
        difference
    }
}

impl<const N: usize> Neg for Fixed<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self([0; N]) - self
    }
}

impl<const N: usize> Ring for Fixed<N> {
    #[inline(always)]
    fn verdict(&self) -> Option<Sign> {
        Some(self.sign())
    }
}

macro_rules! products {
    ($($a:literal * $b:literal = $p:literal),*) => { $(
        impl Mul<Fixed<$b>> for Fixed<$a> {
            type Output = Fixed<$p>;
            #[inline(always)]
            fn mul(self, other: Fixed<$b>) -> Fixed<$p> { product(&self, &other) }
        }
    )* };
}
products!(
    1 * 1 = 2,
    2 * 1 = 3,
    1 * 2 = 3,
    2 * 2 = 4,
    3 * 1 = 4,
    4 * 1 = 5,
    3 * 2 = 5,
    5 * 1 = 6,
    4 * 2 = 6,
    3 * 3 = 6
);

impl<const N: usize> From<&Fixed<N>> for crate::Integer {
    fn from(value: &Fixed<N>) -> Self {
        let mut limbs = value.0.iter().rev();
        let top = crate::Integer::from(limbs.next().map_or(0, |&limb| limb as i64));
        limbs.fold(top, |high, &limb| (high << 64) + crate::Integer::from(limb))
    }
}

impl<const N: usize> fmt::Display for Fixed<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&crate::Integer::from(self), f)
    }
}

impl<const N: usize> fmt::Debug for Fixed<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests;
