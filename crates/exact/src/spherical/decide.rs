//! What the boxes leave open, exactly.
//!
//! Bounds, with k <= 62 bits of the widest normal: a crossing a x b has coordinates below 2^(2 k + 1). Explicit coordinates are below 2^62. In the tier
//! `Fixed` a term of degree d is below 2^(62 d), and no polynomial here has more than eight when it is multiplied out: below 2^(62 d + 3), which 64 d
//! bits hold.

use super::circle::bits_of;
use super::direction::Repr;
use super::{Direction, GreatCircle};
use crate::predicate::{cross, dot};
use crate::stage::{Stage, count, is_big_forced, is_forced};
use crate::tier::{Fixed, Narrow, Ring, Tier};
use crate::{Integer, Sign};
use std::sync::Arc;

/// A tier of machine integers.
trait Reads: Tier {
    const STAGE: Stage;
}

impl Reads for Narrow {
    const STAGE: Stage = Stage::Narrow;
}

impl Reads for Fixed {
    const STAGE: Stage = Stage::Fixed;
}

/// The widest normals for which the determinant of three fits 128 bits: 6 terms of 3 k bits, 123 + 3 < 127.
const NARROW_SIDE: u32 = 41;
/// The widest normals for which two crossings compare in 128 bits: 8 terms of 4 k bits, 120 + 3 < 127.
const NARROW_TURN: u32 = 30;
/// The bits of the normals twice and those of the explicit coordinates, for which they compare in 128 bits: 4 terms, 124 + 2 < 127.
const NARROW_MIXED: u32 = 124;

/// The vector product of narrow vectors: below 2^125.
#[inline(always)]
pub(super) fn cross_i128(a: &[i64; 3], b: &[i64; 3]) -> [i128; 3] {
    [0, 1, 2].map(|axis| minor_i128(a, b, axis))
}

/// One coordinate of the vector product of narrow vectors.
#[inline(always)]
fn minor_i128(a: &[i64; 3], b: &[i64; 3], axis: usize) -> i128 {
    let [i, j] = OTHERS[axis];
    i128::from(a[i]) * i128::from(b[j]) - i128::from(a[j]) * i128::from(b[i])
}

/// The axes after each one, in a circle.
pub(super) const OTHERS: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

#[inline(always)]
fn sign_of<T: Reads>(value: &impl Ring) -> Sign {
    count(T::STAGE);
    value.verdict().expect("an exact tier always decides")
}

#[inline(always)]
fn counted(value: i128) -> Sign {
    count(Stage::Narrow);
    Sign::of_i128(value)
}

/// det(a, b, n) for a crossing of a and b.
#[inline(always)]
fn side_of_crossing<T: Reads>([a, b]: &[[i64; 3]; 2], n: &[i64; 3]) -> Sign {
    sign_of::<T>(&dot(cross(T::small(a), T::small(b)), T::small(n)))
}

#[inline(always)]
fn side_in_machine(p: &[[i64; 3]; 2], n: &[i64; 3], bits: u32) -> Sign {
    if is_forced() {
        return side_of_crossing::<Fixed>(p, n);
    }
    if p.contains(n) {
        count(Stage::Narrow);
        Sign::Zero
    } else if bits <= NARROW_SIDE {
        side_of_crossing::<Narrow>(p, n)
    } else {
        side_of_crossing::<Fixed>(p, n)
    }
}

/// The sign of n . p in 128 bits: three terms below 2^124.
#[inline(always)]
pub(super) fn side_of_explicit(p: &[i64; 3], n: &[i64; 3]) -> Sign {
    counted((0..3).map(|axis| i128::from(n[axis]) * i128::from(p[axis])).sum())
}

/// Tells the side of a point that its box leaves open.
#[inline(never)]
pub(super) fn side(p: &Direction, circle: &GreatCircle) -> Sign {
    if let (Some((n, line_bits)), false) = (circle.as_narrow(), is_big_forced()) {
        match &p.repr {
            Repr::Explicit(p) if is_forced() => {
                return sign_of::<Fixed>(&dot(Fixed::small(p), Fixed::small(n)));
            }
            Repr::Explicit(p) => return side_of_explicit(p, n),
            Repr::Crossing { bits, normals } => {
                return side_in_machine(normals, n, line_bits.max(u32::from(*bits)));
            }
            Repr::Wide(_) => {}
        }
    }
    count(Stage::Big);
    dot(p.multiple(), circle.coordinates()).sign()
}

/// One coordinate of p x q for two crossings.
#[inline(always)]
fn cross_of_crossings<T: Reads>([a, b]: &[[i64; 3]; 2], [c, d]: &[[i64; 3]; 2], axis: usize) -> Sign {
    let [i, j] = OTHERS[axis];
    let p = cross(T::small(a), T::small(b));
    let q = cross(T::small(c), T::small(d));
    sign_of::<T>(&(p[i].clone() * q[j].clone() - p[j].clone() * q[i].clone()))
}

/// One coordinate of p x q for an explicit direction and a crossing.
#[inline(always)]
fn cross_of_mixed<T: Reads>(p: &[i64; 3], [c, d]: &[[i64; 3]; 2], axis: usize) -> Sign {
    let [i, j] = OTHERS[axis];
    let p = T::small(p);
    let q = cross(T::small(c), T::small(d));
    sign_of::<T>(&(p[i].clone() * q[j].clone() - p[j].clone() * q[i].clone()))
}

fn cross_to_crossing(p: &[i64; 3], (bits, q): (u8, &[[i64; 3]; 2]), axis: usize) -> Sign {
    if !is_forced() && 2 * u32::from(bits) + bits_of(p) <= NARROW_MIXED {
        cross_of_mixed::<Narrow>(p, q, axis)
    } else {
        cross_of_mixed::<Fixed>(p, q, axis)
    }
}

/// One coordinate of p x q for two crossings on one circle; `None` if they share none.
///
/// p x q = (a x b) x (c x d) = c det(a, b, d) - d det(a, b, c), and a determinant with two equal normals is zero.
#[inline(always)]
fn cross_on_shared_circle(p: &[[i64; 3]; 2], [c, d]: &[[i64; 3]; 2], bits: u32, axis: usize) -> Option<Sign> {
    let of_shared = |shared: &[i64; 3], other| match Sign::of_i64(shared[axis]) {
        Sign::Zero => Sign::Zero,
        sign => sign * side_in_machine(p, other, bits),
    };
    if p.contains(c) {
        Some(of_shared(c, d))
    } else if p.contains(d) {
        Some(-of_shared(d, c))
    } else {
        None
    }
}

/// Gives the sign of one coordinate of p x q, which their boxes leave open.
#[inline(never)]
pub(super) fn cross_sign(p: &Direction, q: &Direction, axis: usize) -> Sign {
    if is_big_forced() {
        return cross_sign_big(p, q, axis);
    }
    match (&p.repr, &q.repr) {
        (Repr::Explicit(p), Repr::Explicit(q)) if is_forced() => {
            let [i, j] = OTHERS[axis];
            let (p, q) = (Fixed::small(p), Fixed::small(q));
            sign_of::<Fixed>(&(p[i] * q[j] - p[j] * q[i]))
        }
        (Repr::Explicit(p), Repr::Explicit(q)) => counted(minor_i128(p, q, axis)),
        (Repr::Crossing { bits: j, normals: p }, Repr::Crossing { bits: k, normals: q }) => {
            let bits = u32::from(*j.max(k));
            if !is_forced() {
                if let Some(sign) = cross_on_shared_circle(p, q, bits, axis) {
                    return sign;
                }
                if bits <= NARROW_TURN {
                    return cross_of_crossings::<Narrow>(p, q, axis);
                }
            }
            cross_of_crossings::<Fixed>(p, q, axis)
        }
        (Repr::Explicit(p), Repr::Crossing { bits, normals }) => cross_to_crossing(p, (*bits, normals), axis),
        (Repr::Crossing { bits, normals }, Repr::Explicit(q)) => {
            -cross_to_crossing(q, (*bits, normals), axis)
        }
        (Repr::Wide(p), Repr::Wide(q)) if !is_forced() && Arc::ptr_eq(p, q) => {
            count(Stage::Big);
            Sign::Zero
        }
        _ => cross_sign_big(p, q, axis),
    }
}

#[cold]
fn cross_sign_big(p: &Direction, q: &Direction, axis: usize) -> Sign {
    count(Stage::Big);
    let [i, j] = OTHERS[axis];
    let (p, q) = (p.multiple(), q.multiple());
    (&p[i] * &q[j] - &p[j] * &q[i]).sign()
}

/// Gives the sign of one coordinate, which the box leaves open.
#[inline(never)]
pub(super) fn coordinate_sign(p: &Direction, axis: usize) -> Sign {
    match &p.repr {
        Repr::Explicit(p) => {
            count(Stage::Narrow);
            Sign::of_i64(p[axis])
        }
        Repr::Crossing { normals: [m, n], .. } => counted(minor_i128(m, n, axis)),
        Repr::Wide(p) => {
            count(Stage::Big);
            p[axis].sign()
        }
    }
}

/// Gives the sign of one coordinate of the vector product of two normals.
#[inline]
pub(super) fn cross_sign_of_circles(m: &GreatCircle, n: &GreatCircle, axis: usize) -> Sign {
    if let (Some((m, _)), Some((n, _)), false) = (m.as_narrow(), n.as_narrow(), is_big_forced()) {
        return counted(minor_i128(m, n, axis));
    }
    let [i, j] = OTHERS[axis];
    let (m, n): ([Integer; 3], [Integer; 3]) = (m.coordinates(), n.coordinates());
    count(Stage::Big);
    (&m[i] * &n[j] - &m[j] * &n[i]).sign()
}
