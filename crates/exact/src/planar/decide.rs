//! What the boxes leave open, exactly.
//!
//! Bounds, with k bits of the wider line: a, b < 2^k and c < 2^(2 k), k <= 62, so that W < 2^(2 k + 1) and X, Y < 2^(3 k + 1).
//! Explicit coordinates and weights are below 2^61. In the tier `Fixed` a term of degree d is below 2^(62 d), and no polynomial here
//! has more than eight when it is multiplied out: below 2^(62 d + 3), which 64 d bits hold.

use super::line::{Line2, NarrowLine};
use super::point::{Point2, Repr};
use crate::stage::{Stage, count, is_big_forced, is_forced};
use crate::tier::{Fixed, Narrow, Ring, Tier};
use crate::{Integer, Sign, fixed};
use std::cmp::Ordering;
use std::sync::Arc;

/// By which coordinates to compare.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    X,
    Y,
    XThenY,
}

impl Order {
    #[inline(always)]
    fn decide(self, axis: impl Fn(usize) -> Ordering) -> Ordering {
        match self {
            Self::X => axis(0),
            Self::Y => axis(1),
            Self::XThenY => axis(0).then_with(|| axis(1)),
        }
    }
}

/// A tier that reads machine integers of degree 1 and 2.
trait Reads: Tier {
    const STAGE: Stage;

    /// An integer below 2^62 in magnitude.
    #[inline(always)]
    fn one(value: i64) -> Self::D1 {
        let [value, _, _] = Self::small(&[value, 0, 0]);
        value
    }

    /// An integer below 2^124 in magnitude, in the tier `Narrow` 2^62.
    fn two(value: i128) -> Self::D2;
}

impl Reads for Narrow {
    const STAGE: Stage = Stage::Narrow;

    #[inline(always)]
    fn two(value: i128) -> Self::D2 {
        debug_assert!(value.unsigned_abs() >> 62 == 0, "the bits of a line decide whether it may come here");
        Self::one(value as i64)
    }
}

impl Reads for Fixed {
    const STAGE: Stage = Stage::Fixed;

    #[inline(always)]
    fn two(value: i128) -> Self::D2 {
        fixed::Fixed::from(value)
    }
}

/// The widest lines for each polynomial in 128 bits, where c must be below 2^62 too. Two crossings: 8 terms of 5 k bits,
/// 5 * 24 + 3 < 127.
const NARROW_COMPARE: u32 = 24;
/// A crossing and a line: 6 terms of 4 k bits, 6 * 2^124 < 2^127.
const NARROW_SIDE: u32 = 31;
/// The bits of the crossing three times (of a line twice) and those of the explicit point: 4 terms, 120 + 2 < 127. With k <= 31 too.
const NARROW_MIXED: u32 = 120;

#[inline(always)]
fn coefficients<T: Reads>(line: &NarrowLine) -> (T::D1, T::D1, T::D2) {
    (T::one(line.a), T::one(line.b), T::two(line.c()))
}

/// X, Y and W.
#[inline(always)]
fn crossing<T: Reads>([l, m]: &[NarrowLine; 2]) -> (T::D3, T::D3, T::D2) {
    let ((a, b, c), (d, e, f)) = (coefficients::<T>(l), coefficients::<T>(m));
    let x = c.clone() * e.clone() - f.clone() * b.clone();
    let y = f * a.clone() - c * d.clone();
    (x, y, a * e - d * b)
}

/// X, Y and W of two narrow lines.
#[inline]
pub(super) fn fixed_crossing(lines: &[NarrowLine; 2]) -> (fixed::Fixed<3>, fixed::Fixed<3>, fixed::Fixed<2>) {
    crossing::<Fixed>(lines)
}

#[inline(always)]
fn sign_of<T: Reads>(value: &impl Ring) -> Sign {
    count(T::STAGE);
    value.verdict().expect("an exact tier always decides")
}

/// The order of two crossings: X1 W2 - X2 W1.
#[inline(always)]
fn compare_crossings<T: Reads>(p: &[NarrowLine; 2], q: &[NarrowLine; 2], order: Order) -> Ordering {
    let ((x, y, w), (other_x, other_y, other_w)) = (crossing::<T>(p), crossing::<T>(q));
    let (own, other) = ([x, y], [other_x, other_y]);
    order.decide(|axis| {
        let difference = own[axis].clone() * other_w.clone() - other[axis].clone() * w.clone();
        sign_of::<T>(&difference).ordering()
    })
}

/// The order of an explicit point and a crossing: x W - X w.
#[inline(always)]
fn compare_mixed<T: Reads>(&[x, y, w]: &[i64; 3], q: &[NarrowLine; 2], order: Order) -> Ordering {
    let (other_x, other_y, other_w) = crossing::<T>(q);
    let (own, other, w) = ([x, y].map(T::one), [other_x, other_y], T::one(w));
    order.decide(|axis| {
        // The factor 1 lifts the product to the degree of the other.
        let product = own[axis].clone() * other_w.clone() * T::one(1);
        sign_of::<T>(&(product - other[axis].clone() * w.clone())).ordering()
    })
}

/// a X + b Y - c W for a crossing.
#[inline(always)]
fn side_of_crossing<T: Reads>(p: &[NarrowLine; 2], line: &NarrowLine) -> Sign {
    let ((x, y, w), (a, b, c)) = (crossing::<T>(p), coefficients::<T>(line));
    sign_of::<T>(&(x * a + y * b - c * w))
}

/// a x + b y - c w for an explicit point.
#[inline(always)]
fn side_of_explicit<T: Reads>(&[x, y, w]: &[i64; 3], line: &NarrowLine) -> Sign {
    let (a, b, c) = coefficients::<T>(line);
    sign_of::<T>(&((a * T::one(x) + b * T::one(y)) * T::one(1) - c * T::one(w)))
}

/// The side of a narrow point with integer coordinates: |a x|, |b y| < 2^123 and |c| < 2^124.
#[inline(always)]
pub(super) fn side_of_integers([x, y]: [i64; 2], line: &NarrowLine) -> Sign {
    count(Stage::Narrow);
    let product = |a: i64, b: i64| i128::from(a) * i128::from(b);
    Sign::of_i128(product(line.a, x) + product(line.b, y) - line.c())
}

#[inline(always)]
fn bits_of_explicit([x, y, w]: &[i64; 3]) -> u32 {
    64 - (x.unsigned_abs() | y.unsigned_abs() | w.unsigned_abs()).leading_zeros()
}

/// Compares two points that the boxes leave open.
#[inline(never)]
pub(super) fn compare(p: &Point2, q: &Point2, order: Order) -> Ordering {
    if is_big_forced() {
        return compare_big(p, q, order);
    }
    match (&p.repr, &q.repr) {
        (Repr::Explicit(p), Repr::Explicit(q)) => order.decide(|axis| {
            count(Stage::Narrow);
            (i128::from(p[axis]) * i128::from(q[2])).cmp(&(i128::from(q[axis]) * i128::from(p[2])))
        }),
        (Repr::Crossing { bits, lines: p }, Repr::Crossing { bits: other_bits, lines: q }) => {
            let bits = *bits.max(other_bits);
            if !is_forced() {
                if order == Order::XThenY
                    && let Some(ordering) = compare_on_shared_line(p, q, bits)
                {
                    return ordering;
                }
                if bits <= NARROW_COMPARE {
                    return compare_crossings::<Narrow>(p, q, order);
                }
            }
            compare_crossings::<Fixed>(p, q, order)
        }
        (Repr::Explicit(p), Repr::Crossing { bits, lines }) => compare_to_crossing(p, (*bits, lines), order),
        (Repr::Crossing { bits, lines }, Repr::Explicit(q)) => {
            compare_to_crossing(q, (*bits, lines), order).reverse()
        }
        (Repr::Wide(p), Repr::Wide(q)) if !is_forced() && Arc::ptr_eq(p, q) => {
            count(Stage::Big);
            Ordering::Equal
        }
        _ => compare_big(p, q, order),
    }
}

fn compare_to_crossing(p: &[i64; 3], (bits, q): (u32, &[NarrowLine; 2]), order: Order) -> Ordering {
    if !is_forced() && bits <= NARROW_SIDE && 3 * bits + bits_of_explicit(p) <= NARROW_MIXED {
        compare_mixed::<Narrow>(p, q, order)
    } else {
        compare_mixed::<Fixed>(p, q, order)
    }
}

/// The lexicographic order of two crossings on one line; `None` if they share none.
///
/// The direction (b, -a) of a line l goes up in this order, because b is positive, or b is zero and a negative. Along l, the value
/// of the other line n of q is zero in q and grows at the rate a_n b_l - b_n a_l, which is positive if l has the greater slope: if it
/// is the second line of q. So the value of n in p, of degree 4, tells on which side of q it lies.
#[inline(always)]
fn compare_on_shared_line(p: &[NarrowLine; 2], q: &[NarrowLine; 2], bits: u32) -> Option<Ordering> {
    let shared = [1, 0].into_iter().find(|&index: &usize| p.contains(&q[index]))?;
    let sign = side_in_machine(p, &q[1 - shared], bits);
    Some(if shared == 1 { sign } else { -sign }.ordering())
}

#[inline(always)]
fn side_in_machine(p: &[NarrowLine; 2], line: &NarrowLine, bits: u32) -> Sign {
    if p.contains(line) {
        count(Stage::Narrow);
        Sign::Zero
    } else if bits <= NARROW_SIDE {
        side_of_crossing::<Narrow>(p, line)
    } else {
        side_of_crossing::<Fixed>(p, line)
    }
}

/// Tells the side of a point that its box leaves open.
#[inline(never)]
pub(super) fn side(p: &Point2, line: &Line2) -> Sign {
    let (Some((narrow, line_bits)), true) = (line.as_narrow(), !is_big_forced()) else {
        return side_big(p, line);
    };
    match &p.repr {
        Repr::Explicit(p) => {
            let fits = line_bits <= NARROW_SIDE && 2 * line_bits + bits_of_explicit(p) <= NARROW_MIXED;
            if !is_forced() && fits {
                side_of_explicit::<Narrow>(p, narrow)
            } else {
                side_of_explicit::<Fixed>(p, narrow)
            }
        }
        Repr::Crossing { bits, lines } if !is_forced() => {
            side_in_machine(lines, narrow, line_bits.max(*bits))
        }
        Repr::Crossing { lines, .. } => side_of_crossing::<Fixed>(lines, narrow),
        Repr::Wide(_) => side_big(p, line),
    }
}

#[cold]
fn compare_big(p: &Point2, q: &Point2, order: Order) -> Ordering {
    let ([x, y, w], [other_x, other_y, other_w]) = (p.homogeneous(), q.homogeneous());
    let (own, other): ([Integer; 2], [Integer; 2]) = ([x, y], [other_x, other_y]);
    order.decide(|axis| {
        count(Stage::Big);
        (&own[axis] * &other_w).cmp(&(&other[axis] * &w))
    })
}

#[cold]
fn side_big(p: &Point2, line: &Line2) -> Sign {
    count(Stage::Big);
    let ([x, y, w], [a, b, c]) = (p.homogeneous(), line.coefficients());
    (a * x + b * y - c * w).sign()
}
