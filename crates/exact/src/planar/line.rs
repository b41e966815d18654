//! Oriented lines of the plane.

use super::Point2;
use crate::filter::Filtered;
use crate::gcd::{gcd_u64, gcd_u128};
use crate::stage::{Stage, are_boxes_skipped, count};
use crate::tier::Ring;
use crate::{Integer, Rational, Sign};
use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// A line a x + b y = c with coprime integers a, b, c, of which b is positive, or b is zero and a negative.
///
/// So every line has one representation, its positive side is the one above it, and the positive side of a vertical line is the
/// one left of it: a vertical line counts as the steepest of all.
///
/// ```
/// use exact::planar::{Line2, Point2};
/// let [p, q, r] = [[4, 0], [0, 6], [2, 3]].map(Point2::from_i64);
/// let line = Line2::through(&p, &q).expect("two points");
/// assert_eq!(line.to_string(), "3 x + 2 y = 12");
/// assert_eq!(Line2::through(&r, &p), Some(line));
/// assert_eq!(Line2::through(&r, &r), None);
/// ```
#[derive(Clone)]
pub struct Line2 {
    /// The `f64` nearest to c. Those nearest to a and b are one instruction away.
    approx_c: f64,
    repr: Repr,
}

#[derive(Clone)]
enum Repr {
    // In 32 bits, because copies of a byte with the gap after it are slow.
    Narrow { bits: u32, line: NarrowLine },
    Wide(Arc<WideLine>),
}

/// The coefficients of a line with |a|, |b| < 2^62 and |c| < 2^124.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct NarrowLine {
    pub(super) a: i64,
    pub(super) b: i64,
    /// The low and the high word: an `i128` would align every point to 16 bytes.
    c: [u64; 2],
}

struct WideLine {
    coefficients: [Integer; 3],
    /// The `f64` nearest to a and b.
    approx: [f64; 2],
}

const _: () = assert!(size_of::<NarrowLine>() == 32 && size_of::<Line2>() <= 48);

/// Bits of a and b in a narrow line; c has twice as many.
const NARROW_BITS: u32 = 62;

impl NarrowLine {
    #[inline(always)]
    fn new(a: i64, b: i64, c: i128) -> Self {
        Self { a, b, c: [c as u64, (c >> 64) as u64] }
    }

    /// The image under (x, y) -> (-y, -x), as narrow as the line.
    pub(super) fn reflected_at_antidiagonal(&self) -> Self {
        let (a, b, c) = (-self.b, -self.a, self.c());
        if b < 0 || (b == 0 && a > 0) { Self::new(-a, -b, -c) } else { Self::new(a, b, c) }
    }

    #[inline(always)]
    pub(super) fn c(&self) -> i128 {
        i128::from(self.c[1] as i64) << 64 | i128::from(self.c[0])
    }

    /// The low word of c: all of it if it is below 2^63 in magnitude.
    #[inline(always)]
    pub(super) fn low_c(&self) -> i64 {
        self.c[0] as i64
    }
}

/// The least k with |a|, |b| < 2^k and |c| < 2^(2 k).
#[inline]
fn bits_of(a: u128, b: u128, c: u128) -> u32 {
    (128 - (a | b).leading_zeros()).max((128 - c.leading_zeros()).div_ceil(2))
}

impl Line2 {
    /// Makes the line through two points; `None` if they are equal.
    ///
    /// # Complexity
    /// For points with narrow coordinates, one greatest common divisor of machine integers.
    pub fn through(p: &Point2, q: &Point2) -> Option<Self> {
        let (Some(&[px, py, pw]), Some(&[qx, qy, qw])) = (p.as_narrow(), q.as_narrow()) else {
            let ([px, py, pw], [qx, qy, qw]) = (p.homogeneous(), q.homogeneous());
            return Self::from_integers([
                &py * &qw - &qy * &pw,
                &qx * &pw - &px * &qw,
                &py * &qx - &px * &qy,
            ]);
        };
        // Narrow numerators and weights are below 2^61.
        let c = i128::from(py) * i128::from(qx) - i128::from(px) * i128::from(qy);
        if pw == 1 && qw == 1 {
            let (a, b) = (py - qy, qx - px);
            // With integer points, what divides a and b divides c.
            return match gcd_u64(a.unsigned_abs(), b.unsigned_abs()) as i64 {
                0 => None,
                1 => Some(Self::of_coprime(a.into(), b.into(), c)),
                divisor => {
                    let c = match i64::try_from(c) {
                        Ok(c) => i128::from(c / divisor),
                        Err(_) => c / i128::from(divisor),
                    };
                    Some(Self::of_coprime((a / divisor).into(), (b / divisor).into(), c))
                }
            };
        }
        let (pw, qw) = (i128::from(pw), i128::from(qw));
        let a = i128::from(py) * qw - i128::from(qy) * pw;
        let b = i128::from(qx) * pw - i128::from(px) * qw;
        let divisor = match gcd_u128(a.unsigned_abs(), b.unsigned_abs()) {
            0 => return None,
            // All three are below 2^123.
            divisor => gcd_u128(divisor, c.unsigned_abs()) as i128,
        };
        Some(Self::of_coprime(a / divisor, b / divisor, c / divisor))
    }

    /// Makes the line a x + b y = c; `None` if a and b are zero.
    ///
    /// ```
    /// use exact::Rational;
    /// use exact::planar::Line2;
    /// let [zero, half, two] = ["0", "1/2", "2"].map(|text| text.parse().expect("a number"));
    /// let line = Line2::from_coefficients(&half, &zero, &two).expect("not all are zero");
    /// assert_eq!(line.to_string(), "-1 x + 0 y = -4");
    /// assert_eq!(Line2::from_coefficients(&zero, &zero, &two), None);
    /// ```
    pub fn from_coefficients(a: &Rational, b: &Rational, c: &Rational) -> Option<Self> {
        let weight = a.denominator().lcm(&b.denominator()).lcm(&c.denominator());
        Self::from_integers([a, b, c].map(|value| value.numerator() * weight.div_exact(&value.denominator())))
    }

    /// Makes the line a x + b y = c with any integers; `None` if a and b are zero.
    ///
    /// ```
    /// use exact::planar::Line2;
    /// assert_eq!(Line2::from_integers([4, -6, 2].map(Into::into)).expect("not all are zero").to_string(), "-2 x + 3 y = -1");
    /// assert_eq!(Line2::from_integers([0, 0, 2].map(Into::into)), None);
    /// ```
    pub fn from_integers([a, b, c]: [Integer; 3]) -> Option<Self> {
        let divisor = a.gcd(&b);
        if divisor.is_zero() {
            return None;
        }
        let divisor = divisor.gcd(&c);
        let [a, b, c] = if divisor == Integer::ONE {
            [a, b, c]
        } else {
            [a, b, c].map(|value| value.div_exact(&divisor))
        };
        if let (Some(a), Some(b), Some(c)) = (a.to_i128(), b.to_i128(), c.to_i128()) {
            // The least i128 has no magnitude in i128, and is not narrow either.
            if [a, b, c].iter().all(|&value| value != i128::MIN) {
                return Some(Self::of_coprime(a, b, c));
            }
        }
        Some(Self::wide([a, b, c]))
    }

    /// Coprime machine integers; `None` if a and b are zero.
    #[inline]
    pub(crate) fn from_coprime(coefficients: [i64; 3]) -> Option<Self> {
        let [a, b, c] = coefficients.map(i128::from);
        (a != 0 || b != 0).then(|| Self::of_coprime(a, b, c))
    }

    /// Coprime integers above -2^127, a and b not both zero.
    #[inline]
    fn of_coprime(a: i128, b: i128, c: i128) -> Self {
        let [a, b, c] = if b < 0 || (b == 0 && a > 0) { [-a, -b, -c] } else { [a, b, c] };
        let bits = bits_of(a.unsigned_abs(), b.unsigned_abs(), c.unsigned_abs());
        if bits > NARROW_BITS {
            return Self::wide([a, b, c].map(Integer::from));
        }
        let line = NarrowLine::new(a as i64, b as i64, c);
        Self { approx_c: c as f64, repr: Repr::Narrow { bits, line } }
    }

    /// Coprime integers that are not all narrow, with any sign.
    #[cold]
    fn wide([a, b, c]: [Integer; 3]) -> Self {
        let turn = b.sign() == Sign::Negative || (b.is_zero() && a.sign() == Sign::Positive);
        let coefficients = if turn { [-a, -b, -c] } else { [a, b, c] };
        let [a, b, c] = coefficients.each_ref().map(Integer::approx_f64);
        Self { approx_c: c, repr: Repr::Wide(Arc::new(WideLine { coefficients, approx: [a, b] })) }
    }

    /// The image under (x, y) -> (-y, -x).
    pub(crate) fn reflected_at_antidiagonal(&self) -> Self {
        match &self.repr {
            Repr::Narrow { bits, line } => {
                let line = line.reflected_at_antidiagonal();
                Self { approx_c: line.c() as f64, repr: Repr::Narrow { bits: *bits, line } }
            }
            Repr::Wide(line) => {
                let [a, b, c] = &line.coefficients;
                Self::wide([-b, -a, c.clone()])
            }
        }
    }

    /// The line of narrow coefficients in normal form.
    pub(super) fn of_narrow(line: &NarrowLine) -> Self {
        Self::of_coprime(line.a.into(), line.b.into(), line.c())
    }

    /// The coefficients, and the least k with |a|, |b| < 2^k and |c| < 2^(2 k); `None` if they are not narrow.
    #[inline(always)]
    pub(super) fn as_narrow(&self) -> Option<(&NarrowLine, u32)> {
        match &self.repr {
            Repr::Narrow { bits, line } => Some((line, *bits)),
            Repr::Wide(_) => None,
        }
    }

    /// The `f64` nearest to a, b, c, each; infinite beyond their range.
    #[inline(always)]
    pub(super) fn approx_coefficients(&self) -> [f64; 3] {
        match &self.repr {
            Repr::Narrow { line, .. } => [line.a as f64, line.b as f64, self.approx_c],
            Repr::Wide(line) => [line.approx[0], line.approx[1], self.approx_c],
        }
    }

    /// Gives three words by which [`side_of_key`](super::side_of_key) may tell a side of the line.
    ///
    /// They are the bits of `f32`s near to a, b and c. Three zeros belong to no line, and tell nothing.
    #[inline]
    pub fn side_key(&self) -> [u32; 3] {
        self.approx_coefficients().map(|coefficient| (coefficient as f32).to_bits())
    }

    /// Gives a, b, c.
    pub fn coefficients(&self) -> [Integer; 3] {
        match &self.repr {
            Repr::Narrow { line, .. } => [line.a.into(), line.b.into(), line.c().into()],
            Repr::Wide(line) => line.coefficients.clone(),
        }
    }

    /// Tells whether b is zero.
    #[inline]
    pub fn is_vertical(&self) -> bool {
        match &self.repr {
            Repr::Narrow { line, .. } => line.b == 0,
            Repr::Wide(line) => line.coefficients[1].is_zero(),
        }
    }

    /// Tells whether a is zero.
    #[inline]
    pub fn is_horizontal(&self) -> bool {
        match &self.repr {
            Repr::Narrow { line, .. } => line.a == 0,
            Repr::Wide(line) => line.coefficients[0].is_zero(),
        }
    }

    /// Compares the slopes -a/b; that of a vertical line is the greatest, `Equal` means parallel or the same.
    ///
    /// Law: right of the point where two lines cross, the one with the greater slope is above (or is vertical).
    ///
    /// # Complexity
    /// Degree 2; exact in 128 bits for narrow lines, for others after a filter.
    #[inline]
    pub fn compare_slope(&self, other: &Self) -> Ordering {
        if let (Some((l, _)), Some((m, _))) = (self.as_narrow(), other.as_narrow()) {
            count(Stage::Narrow);
            // -a1/b1 against -a2/b2, times b1 b2; a vertical line has b = 0 and a < 0, and comes out above the others.
            return (i128::from(m.a) * i128::from(l.b)).cmp(&(i128::from(l.a) * i128::from(m.b)));
        }
        self.compare_wide_slope(other)
    }

    #[inline(never)]
    fn compare_wide_slope(&self, other: &Self) -> Ordering {
        let [[a, b, _], [c, d, _]] =
            [self, other].map(|line| line.approx_coefficients().map(Filtered::of_nearest));
        if !are_boxes_skipped()
            && let Some(sign) = (c * b - a * d).verdict()
        {
            count(Stage::Float);
            return sign.ordering();
        }
        count(Stage::Big);
        let ([a, b, _], [c, d, _]) = (self.coefficients(), other.coefficients());
        (c * b).cmp(&(a * d))
    }

    /// Tells whether both lines have the same points.
    #[inline]
    pub fn is_same(&self, other: &Self) -> bool {
        self == other
    }

    /// Gives the line moved by a vector.
    pub fn translated(&self, by: &[Rational; 2]) -> Self {
        if let (Repr::Narrow { line, .. }, [Some(x), Some(y)]) =
            (&self.repr, by.each_ref().map(small_integer))
        {
            // |c| < 2^124 and |a x|, |b y| < 2^123. Whole steps leave the coefficients coprime.
            let (a, b) = (i128::from(line.a), i128::from(line.b));
            return Self::of_coprime(a, b, line.c() + a * i128::from(x) + b * i128::from(y));
        }
        let [a, b, c] = self.coefficients().map(Rational::from);
        let c = c + &a * &by[0] + &b * &by[1];
        Self::from_coefficients(&a, &b, &c).expect("a line has a normal")
    }
}

/// An integer below 2^61 in magnitude.
pub(super) fn small_integer(value: &Rational) -> Option<i64> {
    if !value.is_integer() {
        return None;
    }
    value.numerator().to_i64().filter(|value| value.unsigned_abs() >> 61 == 0)
}

impl PartialEq for Line2 {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        // Every line has one representation: narrow if it fits.
        match (&self.repr, &other.repr) {
            (Repr::Narrow { line: l, .. }, Repr::Narrow { line: m, .. }) => l == m,
            (Repr::Wide(l), Repr::Wide(m)) => Arc::ptr_eq(l, m) || l.coefficients == m.coefficients,
            _ => false,
        }
    }
}

impl Eq for Line2 {}

impl Hash for Line2 {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match &self.repr {
            Repr::Narrow { line, .. } => line.hash(state),
            Repr::Wide(line) => line.coefficients.hash(state),
        }
    }
}

impl fmt::Display for Line2 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b, c] = self.coefficients();
        write!(f, "{a} x + {b} y = {c}")
    }
}

impl fmt::Debug for Line2 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
