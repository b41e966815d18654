//! Points of the plane, and the boxes of floats around them.

use super::decide;
use super::line::{Line2, NarrowLine, small_integer};
use super::predicates::compare_xy;
use crate::fixed::Fixed;
use crate::rational::approx_quotient;
use crate::{Integer, Rational, Sign};
use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

/// A point with rational coordinates, or the point where two lines cross.
///
/// It holds what defines it and a box of floats around it; coordinates of a crossing are made when somebody asks. Equality and
/// order are those of the points, lexicographic in x and y, however they are defined.
///
/// ```
/// use exact::planar::{Line2, Point2};
/// let third = Point2::from_rationals(&["1/3".parse()?, "0".parse()?]);
/// let [p, q, o] = [[0, 1], [1, -2], [0, 0]].map(Point2::from_i64);
/// let steep = Line2::through(&p, &q).expect("two points");
/// let axis = Line2::through(&o, &third).expect("two points");
/// let crossing = Point2::crossing(&steep, &axis).expect("not parallel");
/// assert_eq!(crossing, third);
/// assert!(!crossing.is_explicit() && third.is_explicit());
/// assert!(Point2::crossing(&axis, &axis).is_none());
/// # Ok::<(), exact::ParseNumberError>(())
/// ```
#[derive(Clone)]
pub struct Point2 {
    /// Near to the coordinates; infinite if they are beyond the range.
    pub(super) approx: [f64; 2],
    /// See [`Point2::new`].
    pub(super) error: f64,
    pub(super) repr: Repr,
}

#[derive(Clone)]
pub(super) enum Repr {
    /// x, y and the positive weight w, below 2^61 in magnitude.
    Explicit([i64; 3]),
    /// Two lines, the one with the lesser slope first, so that W is positive; both have at most `bits` (see [`super`]).
    // In 32 bits, because copies of a byte with the gap after it are slow.
    Crossing { bits: u32, lines: [NarrowLine; 2] },
    /// X, Y and the positive weight W.
    Wide(Arc<[Integer; 3]>),
}

const _: () = assert!(size_of::<Point2>() <= 96);

/// Bits of the coordinates and of the weight of a narrow explicit point.
const NARROW_BITS: u32 = 61;

/// Integers up to this magnitude are exact in `f64`.
const EXACT: u64 = 1 << f64::MANTISSA_DIGITS;

/// Half the distance from 1 to the next `f64`.
const UNIT: f64 = f64::EPSILON / 2.0;

/// The widest lines for which a, b, c and W fit 64 bits, so that X and Y fit 128: c < 2^62, W < 2^63.
const MACHINE_BITS: u32 = 31;

/// A quotient of floats that were rounded to nearest from integers: both boxes around it hold the exact quotients.
///
/// # Proof
/// u = 2^-53. With the integers X and W that the floats P and Q came from, |P - X| <= u |X|, |Q - W| <= u W, and the quotient is
/// rounded by a factor between 1 - u and 1 + u. Nothing is subnormal: X and W are below 2^190, so that a quotient other than
/// zero is above 2^-191. So the exact quotient is the float times a factor between (1-u)/(1+u)^2 and (1+u)/(1-u)^2, and the
/// error is at most 3 u (1 + 2 u) of the float: less than 4/5 of 4 u. The product with 4 u, a power of two, is exact.
#[inline(always)]
fn quotients(x: f64, y: f64, w: f64) -> ([f64; 2], f64) {
    let approx = [x / w, y / w];
    (approx, 4.0 * UNIT * approx[0].abs().max(approx[1].abs()))
}

impl Point2 {
    /// A point from its parts. What every box promises, and the predicates rely on:
    ///
    /// 1. `error` is zero and `approx` is the point; or
    /// 2. `error` is finite and positive, `approx` is finite, and each coordinate differs from it by at most 4/5 of `error`; or
    /// 3. `error` is infinite.
    #[inline(always)]
    fn new(approx: [f64; 2], error: f64, repr: Repr) -> Self {
        Self { approx, error, repr }
    }

    /// Makes a point with integer coordinates.
    #[inline]
    pub fn from_i64([x, y]: [i64; 2]) -> Self {
        let size = x.unsigned_abs() | y.unsigned_abs();
        // The "or" has no more bits than the greater one, so below 2^53 both are exact.
        if size < EXACT {
            return Self::new([x as f64, y as f64], 0.0, Repr::Explicit([x, y, 1]));
        }
        if size >> NARROW_BITS == 0 {
            return Self::explicit([x, y, 1]);
        }
        Self::of_homogeneous([x, y, 1].map(Integer::from))
    }

    /// Narrow coordinates and a positive weight.
    fn explicit([x, y, w]: [i64; 3]) -> Self {
        let (approx, error) = quotients(x as f64, y as f64, w as f64);
        let exact = w == 1 && x.unsigned_abs() <= EXACT && y.unsigned_abs() <= EXACT;
        Self::new(approx, if exact { 0.0 } else { error }, Repr::Explicit([x, y, w]))
    }

    /// Makes a point with rational coordinates.
    pub fn from_rationals([x, y]: &[Rational; 2]) -> Self {
        let weight = x.denominator().lcm(&y.denominator());
        let numerator = |value: &Rational| value.numerator() * weight.div_exact(&value.denominator());
        Self::of_homogeneous([numerator(x), numerator(y), weight.clone()])
    }

    /// Makes the point whose coordinates are these floats, each the dyadic rational that it is; `None` if one is not finite.
    ///
    /// ```
    /// use exact::planar::Point2;
    /// let point = Point2::from_f64s([0.75, -0.0]).expect("the floats are finite");
    /// assert_eq!(point.to_string(), "(3/4, 0)");
    /// assert!(Point2::from_f64s([0.0, f64::NAN]).is_none());
    /// ```
    // tidy: pub f64, because a float comes in through an exact conversion
    pub fn from_f64s(coordinates: [f64; 2]) -> Option<Self> {
        let [Ok(x), Ok(y)] = coordinates.map(Rational::try_from) else {
            return None;
        };
        let mut point = Self::from_rationals(&[x, y]);
        // Adding zero makes the negative zero positive.
        point.approx = coordinates.map(|value| value + 0.0);
        point.error = 0.0;
        Some(point)
    }

    /// Makes the point (x/w, y/w) of machine integers with a positive weight w.
    #[inline]
    pub(crate) fn from_weighted(homogeneous: [i64; 3]) -> Self {
        let [x, y, w] = homogeneous;
        debug_assert!(w > 0, "the weight is positive");
        if (x.unsigned_abs() | y.unsigned_abs() | w.unsigned_abs()) >> NARROW_BITS == 0 {
            return Self::explicit(homogeneous);
        }
        Self::of_homogeneous(homogeneous.map(Integer::from))
    }

    /// Makes the point (x/w, y/w) of integers; `None` if w is zero.
    ///
    /// ```
    /// use exact::planar::Point2;
    /// let point = Point2::from_homogeneous([4, -1, -2].map(Into::into)).expect("a weight that is not zero");
    /// assert_eq!(point.to_string(), "(-2, 1/2)");
    /// assert_eq!(Point2::from_homogeneous([4, -1, 0].map(Into::into)), None);
    /// ```
    pub fn from_homogeneous(homogeneous: [Integer; 3]) -> Option<Self> {
        match homogeneous[2].sign() {
            Sign::Zero => None,
            Sign::Positive => Some(Self::of_homogeneous(homogeneous)),
            Sign::Negative => Some(Self::of_homogeneous(homogeneous.map(|value| -value))),
        }
    }

    /// A point with a positive weight.
    fn of_homogeneous(homogeneous: [Integer; 3]) -> Self {
        let machine = homogeneous.each_ref().map(Integer::to_i64);
        if let [Some(x), Some(y), Some(w)] = machine
            && (x.unsigned_abs() | y.unsigned_abs() | w.unsigned_abs()) >> NARROW_BITS == 0
        {
            return Self::explicit([x, y, w]);
        }
        let [x, y, w] = &homogeneous;
        let approx = [x, y].map(|numerator| {
            let magnitude = approx_quotient(&numerator.abs(), w);
            if numerator.sign() == Sign::Negative { -magnitude } else { magnitude }
        });
        // To nearest: at most u of the float, or half of the least positive float d where that is subnormal. 2 u of the float
        // may itself be rounded by d/2, so 4 d more are enough for what `new` asks. Infinity stays infinite.
        const TINY: f64 = f64::from_bits(4);
        let error = 2.0 * UNIT * approx[0].abs().max(approx[1].abs()) + TINY;
        Self::new(approx, error, Repr::Wide(Arc::new(homogeneous)))
    }

    /// Makes the point where two lines cross; `None` if they are parallel or the same.
    ///
    /// The lines are kept if they are narrow (see [`super`]), so that nothing is allocated. A crossing with integer coordinates is
    /// made explicit where it is cheap to see.
    #[inline]
    pub fn crossing(l: &Line2, m: &Line2) -> Option<Self> {
        match (l.as_narrow(), m.as_narrow()) {
            (Some((l, k)), Some((m, j))) if k.max(j) <= MACHINE_BITS => {
                Self::machine_crossing(l, m, k.max(j))
            }
            (Some((l, k)), Some((m, j))) => Self::narrow_crossing(l, m, k.max(j)),
            _ => Self::wide_crossing(l, m),
        }
    }

    /// In machine words; see [`MACHINE_BITS`].
    #[inline]
    fn machine_crossing(l: &NarrowLine, m: &NarrowLine, bits: u32) -> Option<Self> {
        let w = l.a * m.b - m.a * l.b;
        if w == 0 {
            return None;
        }
        // Two reads instead of an unpredictable branch on the sign.
        let (pair, turn) = ([l, m], usize::from(w < 0));
        let (l, m, w) = (pair[turn], pair[1 - turn], w.abs());
        let product = |a: i64, b: i64| i128::from(a) * i128::from(b);
        let x = product(l.low_c(), m.b) - product(m.low_c(), l.b);
        let y = product(l.a, m.low_c()) - product(m.a, l.low_c());
        let (approx, error) = quotients(nearest(x), nearest(y), w as f64);
        // |X|, |Y| < 2^94 and the rounded quotients are below 2^51: no product overflows.
        if let Some([i, j]) = near_integers(approx, error)
            && product(i, w) == x
            && product(j, w) == y
        {
            return Some(Self::from_i64([i, j]));
        }
        Some(Self::new(approx, error, Repr::Crossing { bits, lines: [*l, *m] }))
    }

    /// In fixed width: W < 2^125, |X|, |Y| < 2^187.
    #[inline(never)]
    fn narrow_crossing(l: &NarrowLine, m: &NarrowLine, bits: u32) -> Option<Self> {
        let product = |a: i64, b: i64| i128::from(a) * i128::from(b);
        let w = product(l.a, m.b) - product(m.a, l.b);
        let lines = match w.signum() {
            0 => return None,
            1 => [*l, *m],
            _ => [*m, *l],
        };
        let (x, y, w) = decide::fixed_crossing(&lines);
        let (approx, error) = quotients(approx_fixed(&x), approx_fixed(&y), approx_fixed(&w));
        if let Some([i, j]) = near_integers(approx, error)
            && w * Fixed::<1>::from(i) == x
            && w * Fixed::<1>::from(j) == y
        {
            return Some(Self::from_i64([i, j]));
        }
        Some(Self::new(approx, error, Repr::Crossing { bits, lines }))
    }

    #[cold]
    fn wide_crossing(l: &Line2, m: &Line2) -> Option<Self> {
        let ([a, b, c], [d, e, f]) = (l.coefficients(), m.coefficients());
        let [x, y, w] = [&c * &e - &f * &b, &a * &f - &d * &c, a * e - d * b];
        match w.sign() {
            Sign::Zero => None,
            Sign::Positive => Some(Self::of_homogeneous([x, y, w])),
            Sign::Negative => Some(Self::of_homogeneous([-x, -y, -w])),
        }
    }

    /// x, y and w of a narrow explicit point.
    #[inline(always)]
    pub(super) fn as_narrow(&self) -> Option<&[i64; 3]> {
        match &self.repr {
            Repr::Explicit(homogeneous) => Some(homogeneous),
            _ => None,
        }
    }

    /// The lines that cross here, if the point is held so.
    pub(crate) fn crossing_lines(&self) -> Option<[Line2; 2]> {
        match &self.repr {
            Repr::Crossing { lines, .. } => Some(lines.each_ref().map(Line2::of_narrow)),
            _ => None,
        }
    }

    /// X, Y and the positive weight W.
    pub(crate) fn homogeneous(&self) -> [Integer; 3] {
        match &self.repr {
            Repr::Explicit(homogeneous) => homogeneous.map(Integer::from),
            Repr::Crossing { lines, .. } => {
                let (x, y, w) = decide::fixed_crossing(lines);
                [Integer::from(&x), Integer::from(&y), Integer::from(&w)]
            }
            Repr::Wide(homogeneous) => <[Integer; 3]>::clone(homogeneous),
        }
    }

    /// Gives the coordinates in lowest terms.
    pub fn coordinates(&self) -> [Rational; 2] {
        let [x, y, w] = self.homogeneous();
        let quotient = |numerator| Rational::new(numerator, w.clone()).expect("a weight is positive");
        [quotient(x), quotient(y)]
    }

    /// Tells whether the point is held by its coordinates and not by two lines.
    ///
    /// Crossings of wide lines are, and those that have integer coordinates.
    #[inline]
    pub fn is_explicit(&self) -> bool {
        !matches!(self.repr, Repr::Crossing { .. })
    }

    /// The image under (x, y) -> (-y, -x).
    pub(crate) fn reflected_at_antidiagonal(&self) -> Self {
        let [x, y] = self.approx;
        // 0 - x keeps zeros positive.
        let approx = [0.0 - y, 0.0 - x];
        let repr = match &self.repr {
            Repr::Explicit([x, y, w]) => Repr::Explicit([-y, -x, *w]),
            Repr::Crossing { bits, lines } => {
                let [l, m] = lines.each_ref().map(NarrowLine::reflected_at_antidiagonal);
                // The slopes become their inverses.
                let is_in_order = i128::from(l.a) * i128::from(m.b) > i128::from(m.a) * i128::from(l.b);
                Repr::Crossing { bits: *bits, lines: if is_in_order { [l, m] } else { [m, l] } }
            }
            Repr::Wide(homogeneous) => {
                let [x, y, w] = &**homogeneous;
                Repr::Wide(Arc::new([-y, -x, w.clone()]))
            }
        };
        Self::new(approx, self.error, repr)
    }

    /// Gives the point moved by a vector.
    pub fn translated(&self, by: &[Rational; 2]) -> Self {
        match (&self.repr, by.each_ref().map(small_integer)) {
            (Repr::Crossing { lines, .. }, _) => {
                let [l, m] = lines.each_ref().map(|line| Line2::of_narrow(line).translated(by));
                Self::crossing(&l, &m).expect("lines that cross still do after a translation")
            }
            // Below 2^62 in magnitude.
            (Repr::Explicit([x, y, 1]), [Some(i), Some(j)]) => Self::from_i64([x + i, y + j]),
            _ => {
                let [x, y] = self.coordinates();
                Self::from_rationals(&[x + &by[0], y + &by[1]])
            }
        }
    }

    /// Gives a number that orders points by x as far as it goes; 0 if it has none.
    ///
    /// Law: if neither key is 0, p is left of q or above or below it only if the key of p is at most that of q, and different keys
    /// have the order of the points. So a different key is a proof, and an equal one tells nothing.
    ///
    /// # Proof
    /// The key of a float is its bits, made monotone, without the ten lowest: a monotone function of the real numbers. A point has a
    /// key if both ends of an interval around x have the same, which is then that of x. The interval is twice the box; so it holds
    /// x although its ends are rounded, by at most half of the error: 2 - 1/2 is still more than the 4/5 that the box promises.
    ///
    /// ```
    /// use exact::planar::Point2;
    /// let [p, q, r] = [[-1, 5], [0, 0], [1 << 40, 0]].map(|p| Point2::from_i64(p).order_key());
    /// assert!(0 < p && p < q && q < r);
    /// ```
    #[inline]
    pub fn order_key(&self) -> u64 {
        let [x, radius] = [self.approx[0], 2.0 * self.error];
        let [low, high] = [x - radius, x + radius].map(|x| ordered_bits(x) >> 10);
        if low == high && radius.is_finite() && x.is_finite() { low } else { 0 }
    }

    /// Gives a number and how much may be added to it, so that the x-coordinate is somewhere in this range of numbers; `u32::MAX` if nothing is known.
    ///
    /// Law: if the ranges of two points, of both of which something is known, have nothing in common, then they have the order of the points.
    /// In contrast to [`Point2::order_key`] there is hardly a point of which nothing is known, but two numbers do not suffice to sort by.
    ///
    /// # Proof
    /// As for the key: the bits of a float, made monotone, of both ends of an interval that has x in it.
    ///
    /// ```
    /// use exact::planar::Point2;
    /// let [(p, spread), (q, _)] = [[-1, 5], [0, 0]].map(|p| Point2::from_i64(p).order_range());
    /// assert!(p + u64::from(spread) < q);
    /// ```
    #[inline]
    pub fn order_range(&self) -> (u64, u32) {
        let [x, radius] = [self.approx[0], 2.0 * self.error];
        let [low, high] = [x - radius, x + radius].map(ordered_bits);
        // An infinite error leads from the least to the greatest number, or there is a NaN.
        let is_known = radius.is_finite() && x.is_finite();
        (low, if is_known { u32::try_from(high - low).unwrap_or(u32::MAX) } else { u32::MAX })
    }

    /// Gives floats near to the coordinates: within 3 units in the last place, infinite beyond the range of `f64`.
    ///
    /// Nearest for explicit points whose numerators and weight are at most 2^53 (integers of that size: the coordinates
    /// themselves), and for wide ones.
    #[inline]
    pub fn approx_f64(&self) -> [f64; 2] {
        self.approx
    }
}

/// The bits of a float in the order of floats: a monotone function.
#[inline(always)]
fn ordered_bits(value: f64) -> u64 {
    const SIGN: u64 = 1 << 63;
    // Adding zero makes -0 to 0.
    let bits = (value + 0.0).to_bits();
    if bits & SIGN == 0 { bits | SIGN } else { !bits }
}

/// The `f64` nearest to an integer; the branch spares the wide conversion.
#[inline(always)]
fn nearest(value: i128) -> f64 {
    match i64::try_from(value) {
        Ok(value) => value as f64,
        Err(_) => value as f64,
    }
}

/// The `f64` nearest to an integer of at most 192 bits.
fn approx_fixed<const N: usize>(value: &Fixed<N>) -> f64 {
    const { assert!(N == 2 || N == 3, "widths of W, X, Y") };
    let is_negative = value.sign() == Sign::Negative;
    let limbs = if is_negative { (-*value).0 } else { value.0 };
    let [low, high] = [u128::from(limbs[0]) | u128::from(limbs[1]) << 64, u128::from(limbs[N - 1])];
    let magnitude = if N == 2 || high == 0 {
        low as f64
    } else {
        // More than 64 bits, so the lowest, which stands for all that are cut off, only breaks ties.
        const SHIFT: f64 = (1_u128 << 64) as f64;
        (high << 64 | low >> 64 | u128::from(low as u64 != 0)) as f64 * SHIFT
    };
    if is_negative { -magnitude } else { magnitude }
}

/// The integers in the box, if both are below 2^50 and the floats are as near to them as the error allows.
#[inline(always)]
fn near_integers(approx: [f64; 2], error: f64) -> Option<[i64; 2]> {
    /// Adding 1.5 * 2^52 and taking it off again rounds what is below 2^51 to an integer.
    const ROUND: f64 = (3_u64 << 51) as f64;
    let [x, y] = approx.map(|value| (value + ROUND) - ROUND);
    // The error is 2^-51 of the greater coordinate.
    let near = (approx[0] - x).abs() <= error && (approx[1] - y).abs() <= error && error < 0.5;
    near.then_some([x as i64, y as i64])
}

impl PartialEq for Point2 {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        compare_xy(self, other) == Ordering::Equal
    }
}

impl Eq for Point2 {}

impl PartialOrd for Point2 {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Point2 {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        compare_xy(self, other)
    }
}

impl fmt::Display for Point2 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y] = self.coordinates();
        write!(f, "({x}, {y})")
    }
}

impl fmt::Debug for Point2 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
