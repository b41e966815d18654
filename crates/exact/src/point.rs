//! Exact rational points in homogeneous integer coordinates.

use crate::gcd::{gcd_u64, gcd_u128};
use crate::rational::approx_quotient;
use crate::{Integer, Rational, Sign, Vector3, Width};
use std::cmp::Ordering;
use std::fmt;

/// A point (x/w, y/w, z/w) with integer numerators x, y, z and a positive integer weight w.
///
/// Equality and order are those of the points, whatever their weights; points of one mesh share a weight
/// ([`share_weight`]), so that differences and comparisons are those of integers.
///
/// ```
/// use exact::{Point3, Rational};
/// let p = Point3::from_rationals(&["1/2".parse()?, "0.25".parse()?, "-3".parse()?]);
/// assert_eq!(p.to_string(), "(1/2, 1/4, -3)");
/// assert_eq!(p.weight(), 4.into());
/// assert_eq!(p.plus(&p), Point3::from_rationals(&["1".parse()?, ".5".parse()?, "-6".parse()?]));
/// # Ok::<(), exact::ParseNumberError>(())
/// ```
#[derive(Clone)]
pub struct Point3(Repr);

#[derive(Clone)]
enum Repr {
    /// x, y, z, w, each below 2^61 in magnitude.
    Narrow([i64; 4]),
    Wide(Box<Wide>),
}

#[derive(Clone)]
struct Wide {
    /// x, y, z, w.
    homogeneous: [Integer; 4],
    /// The `f64` nearest to each of them.
    approx: [f64; 4],
}

/// The canonical coordinates of a point: equal exactly for equal points, and fit for hashing.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct PointKey(Key);

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
enum Key {
    Narrow([i64; 4]),
    Wide(Box<[Integer; 4]>),
}

/// Bits below which a homogeneous coordinate is narrow: differences of two are narrow vectors.
const NARROW_BITS: u32 = 61;

#[inline(always)]
fn bits(values: &[i64; 4]) -> u32 {
    64 - values.iter().fold(0, |all, value| all | value.unsigned_abs()).leading_zeros()
}

/// A finite float as an odd number times a power of two; (0, 0) for zero.
#[inline]
fn dyadic(value: f64) -> (i64, i32) {
    const FRACTION: u32 = f64::MANTISSA_DIGITS - 1;
    let bits = value.to_bits();
    let fraction = (bits & ((1 << FRACTION) - 1)) as i64;
    // The weight of the last bit.
    let (digits, exponent) = match ((bits >> FRACTION) & 0x7ff) as i32 {
        0 if fraction == 0 => return (0, 0),
        0 => (fraction, -1074),
        exponent => (fraction | 1 << FRACTION, exponent - 1075),
    };
    let even = digits.trailing_zeros();
    let odd = digits >> even;
    (if value < 0.0 { -odd } else { odd }, exponent + even as i32)
}

#[inline(always)]
fn fits(values: &[i128; 4]) -> bool {
    values.iter().fold(0, |all, value| all | value.unsigned_abs()) >> NARROW_BITS == 0
}

impl Point3 {
    /// The point (0, 0, 0).
    pub const ORIGIN: Self = Self(Repr::Narrow([0, 0, 0, 1]));

    /// Makes a point from numerators and their common weight; `None` if the weight is not positive.
    pub fn new([x, y, z]: [Integer; 3], weight: Integer) -> Option<Self> {
        (weight.sign() == Sign::Positive).then(|| Self::of_homogeneous([x, y, z, weight]))
    }

    /// Makes a point with integer coordinates.
    #[inline]
    pub fn from_i64([x, y, z]: [i64; 3]) -> Self {
        Self::of_machine([x, y, z, 1])
    }

    /// Makes a point with rational coordinates. The weight is the least common multiple of their denominators.
    pub fn from_rationals(coordinates: &[Rational; 3]) -> Self {
        if coordinates.iter().all(Rational::is_integer) {
            let [x, y, z] = coordinates.each_ref().map(Rational::numerator);
            return Self::of_homogeneous([x, y, z, Integer::ONE]);
        }
        let denominators = coordinates.each_ref().map(Rational::denominator);
        let weight = denominators[0].lcm(&denominators[1]).lcm(&denominators[2]);
        let [x, y, z] = [0, 1, 2]
            .map(|axis: usize| coordinates[axis].numerator() * weight.div_exact(&denominators[axis]));
        Self::of_homogeneous([x, y, z, weight])
    }

    /// Makes the point whose coordinates are these floats, each the dyadic rational that it is; `None` if one is not
    /// finite.
    ///
    /// The weight is the least power of two, so that the point is canonical.
    ///
    /// ```
    /// use exact::Point3;
    /// let point = Point3::from_f64s([0.75, -2.0, -0.0]).expect("the floats are finite");
    /// assert_eq!(point.to_string(), "(3/4, -2, 0)");
    /// assert_eq!(point.weight(), 4.into());
    /// assert!(Point3::from_f64s([0.0, f64::NAN, 0.0]).is_none());
    /// ```
    #[inline]
    // tidy: pub f64, because a float comes in through an exact conversion
    pub fn from_f64s(coordinates: [f64; 3]) -> Option<Self> {
        if !coordinates.iter().all(|value| value.is_finite()) {
            return None;
        }
        let [x, y, z] = coordinates.map(dyadic);
        let lowest = x.1.min(y.1).min(z.1).min(0);
        let narrow = |(digits, exponent): (i64, i32)| {
            let shift = (exponent - lowest) as u32;
            let bits = 64 - digits.unsigned_abs().leading_zeros();
            (bits + shift <= NARROW_BITS).then(|| digits << shift)
        };
        if lowest > -(NARROW_BITS as i32)
            && let (Some(x), Some(y), Some(z)) = (narrow(x), narrow(y), narrow(z))
        {
            return Some(Self(Repr::Narrow([x, y, z, 1 << -lowest])));
        }
        Some(Self::wide_dyadic([x, y, z], lowest))
    }

    #[cold]
    fn wide_dyadic(coordinates: [(i64, i32); 3], lowest: i32) -> Self {
        let [x, y, z] =
            coordinates.map(|(digits, exponent)| Integer::from(digits) << (exponent - lowest).unsigned_abs());
        Self::of_homogeneous([x, y, z, Integer::ONE << lowest.unsigned_abs()])
    }

    /// The weight must be positive.
    pub(crate) fn of_homogeneous(homogeneous: [Integer; 4]) -> Self {
        let machine = homogeneous.each_ref().map(Integer::to_i64);
        if let [Some(x), Some(y), Some(z), Some(w)] = machine
            && bits(&[x, y, z, w]) <= NARROW_BITS
        {
            return Self(Repr::Narrow([x, y, z, w]));
        }
        let approx = homogeneous.each_ref().map(Integer::approx_f64);
        Self(Repr::Wide(Box::new(Wide { homogeneous, approx })))
    }

    #[inline(always)]
    pub(crate) fn fits_narrow(homogeneous: &[i128; 4]) -> bool {
        fits(homogeneous)
    }

    /// The weight must be positive.
    #[inline]
    fn of_machine(homogeneous: [i64; 4]) -> Self {
        if bits(&homogeneous) <= NARROW_BITS {
            Self(Repr::Narrow(homogeneous))
        } else {
            Self::of_homogeneous(homogeneous.map(Integer::from))
        }
    }

    /// The weight must be positive.
    #[inline]
    pub(crate) fn of_i128(homogeneous: [i128; 4]) -> Self {
        if fits(&homogeneous) {
            Self(Repr::Narrow(homogeneous.map(|value| value as i64)))
        } else {
            Self::of_homogeneous(homogeneous.map(Integer::from))
        }
    }

    /// Gives x, y, z, w as machine integers below 2^61 in magnitude, if they all are.
    #[inline(always)]
    pub fn as_narrow(&self) -> Option<&[i64; 4]> {
        match &self.0 {
            Repr::Narrow(homogeneous) => Some(homogeneous),
            Repr::Wide(_) => None,
        }
    }

    /// Gives x, y, z, w.
    pub fn homogeneous(&self) -> [Integer; 4] {
        match &self.0 {
            Repr::Narrow(homogeneous) => homogeneous.map(Integer::from),
            Repr::Wide(wide) => wide.homogeneous.clone(),
        }
    }

    /// The `f64` nearest to x, y, z, w.
    #[inline(always)]
    pub(crate) fn approx_homogeneous(&self) -> [f64; 4] {
        match &self.0 {
            Repr::Narrow(homogeneous) => homogeneous.map(|value| value as f64),
            Repr::Wide(wide) => wide.approx,
        }
    }

    fn entry(&self, index: usize) -> Integer {
        match &self.0 {
            Repr::Narrow(homogeneous) => Integer::from(homogeneous[index]),
            Repr::Wide(wide) => wide.homogeneous[index].clone(),
        }
    }

    /// Gives one numerator: the coordinate times the weight.
    ///
    /// # Panics
    /// If `axis` is not below 3.
    pub fn numerator(&self, axis: usize) -> Integer {
        assert!(axis < 3, "axes are 0, 1, 2");
        self.entry(axis)
    }

    /// Gives the weight, a positive number.
    pub fn weight(&self) -> Integer {
        self.entry(3)
    }

    /// Gives one coordinate.
    ///
    /// # Panics
    /// If `axis` is not below 3.
    pub fn coordinate(&self, axis: usize) -> Rational {
        Rational::new(self.numerator(axis), self.weight()).expect("a weight is positive")
    }

    /// Gives all coordinates.
    pub fn coordinates(&self) -> [Rational; 3] {
        [0, 1, 2].map(|axis| self.coordinate(axis))
    }

    /// Gives the number of bits of the greatest magnitude among numerators and weight.
    pub fn bits(&self) -> u32 {
        match &self.0 {
            Repr::Narrow(homogeneous) => bits(homogeneous),
            Repr::Wide(wide) => wide.homogeneous.iter().map(Integer::bit_len).max().unwrap_or(0),
        }
    }

    /// Gives a positive integer multiple of `other - self`; the zero vector if the points are equal.
    ///
    /// For equal weights w it is the difference of the numerators: w (other - self). It is made primitive when it is not narrow.
    #[inline]
    pub fn direction_to(&self, other: &Self) -> Vector3 {
        if let (Some(a), Some(b)) = (self.as_narrow(), other.as_narrow()) {
            if a[3] == b[3] {
                return Vector3::from_i64([b[0] - a[0], b[1] - a[1], b[2] - a[2]]);
            }
            let (v, w) = (i128::from(a[3]), i128::from(b[3]));
            let difference = [0, 1, 2].map(|axis: usize| i128::from(b[axis]) * v - i128::from(a[axis]) * w);
            let direction = Vector3::from_i128(difference);
            return if direction.width() == Width::Narrow { direction } else { direction.primitive() };
        }
        self.wide_direction_to(other)
    }

    fn wide_direction_to(&self, other: &Self) -> Vector3 {
        let (a, b) = (self.homogeneous(), other.homogeneous());
        let direction = Vector3::new([0, 1, 2].map(|axis: usize| {
            if a[3] == b[3] { &b[axis] - &a[axis] } else { &b[axis] * &a[3] - &a[axis] * &b[3] }
        }));
        if direction.width() == Width::Narrow { direction } else { direction.primitive() }
    }

    /// Gives the sum of the position vectors. Its weight is the least common multiple of the two.
    #[inline]
    pub fn plus(&self, other: &Self) -> Self {
        if let (Some(a), Some(b)) = (self.as_narrow(), other.as_narrow()) {
            if a[3] == b[3] {
                return Self::of_machine([a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3]]);
            }
            return Adder::default().narrow_sum(a, b);
        }
        let (a, b) = (self.homogeneous(), other.homogeneous());
        let weight = a[3].lcm(&b[3]);
        let (v, w) = (weight.div_exact(&a[3]), weight.div_exact(&b[3]));
        let [x, y, z] = [0, 1, 2].map(|axis: usize| &a[axis] * &v + &b[axis] * &w);
        Self::of_homogeneous([x, y, z, weight])
    }

    /// Gives the same point with coprime x, y, z, w; equal points become identical.
    pub fn canonical(&self) -> Self {
        match &self.0 {
            Repr::Narrow(homogeneous) => {
                let divisor = homogeneous.iter().fold(homogeneous[3].unsigned_abs(), |divisor, value| {
                    if divisor == 1 { 1 } else { gcd_u64(divisor, value.unsigned_abs()) }
                });
                Self(Repr::Narrow(homogeneous.map(|value| value / divisor as i64)))
            }
            Repr::Wide(wide) => {
                let machine = wide.homogeneous.each_ref().map(Integer::to_i128);
                if let [Some(x), Some(y), Some(z), Some(w)] = machine {
                    return Self::reduced_i128([x, y, z, w]);
                }
                let divisor =
                    wide.homogeneous.iter().fold(Integer::ZERO, |divisor, value| divisor.gcd(value));
                if divisor == Integer::ONE {
                    return self.clone();
                }
                Self::of_homogeneous(wide.homogeneous.each_ref().map(|value| value.div_exact(&divisor)))
            }
        }
    }

    /// The canonical point of machine integers; the weight must be positive.
    pub(crate) fn reduced_i128(homogeneous: [i128; 4]) -> Self {
        let divisor = homogeneous
            .iter()
            .rev()
            .fold(0, |divisor, value| if divisor == 1 { 1 } else { gcd_u128(divisor, value.unsigned_abs()) });
        if divisor == 1 {
            return Self::of_i128(homogeneous);
        }
        // A divisor of a positive i128 is one.
        Self::of_i128(homogeneous.map(|value| value / divisor as i128))
    }

    /// Gives a key for hashing and for sorting in some fixed order: equal points, and only those, have equal keys.
    pub fn canonical_key(&self) -> PointKey {
        PointKey(match self.canonical().0 {
            Repr::Narrow(homogeneous) => Key::Narrow(homogeneous),
            Repr::Wide(wide) => Key::Wide(Box::new(wide.homogeneous)),
        })
    }

    /// Gives the `f64` nearest to each coordinate, ties to even; infinite beyond the range of `f64`.
    pub fn approx_f64(&self) -> [f64; 3] {
        const EXACT: u64 = 1 << 53;
        if let Some(homogeneous) = self.as_narrow() {
            let weight = homogeneous[3];
            if weight == 1 {
                return [0, 1, 2].map(|axis: usize| homogeneous[axis] as f64);
            }
            if homogeneous.iter().all(|value| value.unsigned_abs() <= EXACT) {
                // Both are exact, so the quotient is rounded once.
                return [0, 1, 2].map(|axis: usize| homogeneous[axis] as f64 / weight as f64);
            }
        }
        let weight = self.weight();
        [0, 1, 2].map(|axis| {
            let numerator = self.entry(axis);
            let magnitude = approx_quotient(&numerator.abs(), &weight);
            if numerator.sign() == Sign::Negative { -magnitude } else { magnitude }
        })
    }

    /// Compares one coordinate of two points.
    ///
    /// # Panics
    /// If `axis` is not below 3.
    #[inline]
    pub fn compare_coordinate(&self, other: &Self, axis: usize) -> Ordering {
        assert!(axis < 3, "axes are 0, 1, 2");
        if let (Some(a), Some(b)) = (self.as_narrow(), other.as_narrow()) {
            if a[3] == b[3] {
                return a[axis].cmp(&b[axis]);
            }
            return (i128::from(a[axis]) * i128::from(b[3])).cmp(&(i128::from(b[axis]) * i128::from(a[3])));
        }
        let (v, w) = (self.weight(), other.weight());
        if v == w {
            self.entry(axis).cmp(&other.entry(axis))
        } else {
            (self.entry(axis) * w).cmp(&(other.entry(axis) * v))
        }
    }
}

impl PartialEq for Point3 {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Point3 {}

impl PartialOrd for Point3 {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Point3 {
    /// Lexicographic: by x, then y, then z.
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        self.compare_coordinate(other, 0)
            .then_with(|| self.compare_coordinate(other, 1))
            .then_with(|| self.compare_coordinate(other, 2))
    }
}

impl fmt::Display for Point3 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.coordinates();
        write!(f, "({x}, {y}, {z})")
    }
}

impl fmt::Debug for Point3 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// Adds points one pair after the other, and remembers how the last two weights were brought together: in a sum of two objects
/// they are nearly always the same.
///
/// ```
/// use exact::{Adder, Point3};
/// let mut adder = Adder::default();
/// let [a, b] = [["1/2", "0", "1"], ["1/3", "1", "2"]].map(|p| p.map(|c| c.parse().expect("a number")));
/// let (a, b) = (Point3::from_rationals(&a), Point3::from_rationals(&b));
/// assert_eq!(adder.sum(&a, &b), a.plus(&b));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Adder {
    weights: [i64; 2],
    /// What brings each of the weights to the least common multiple.
    factors: [i64; 2],
}

impl Adder {
    /// Gives the sum of the position vectors: the same as [`Point3::plus`].
    #[inline]
    pub fn sum(&mut self, a: &Point3, b: &Point3) -> Point3 {
        match (a.as_narrow(), b.as_narrow()) {
            (Some(a), Some(b)) => self.narrow_sum(a, b),
            _ => a.plus(b),
        }
    }

    #[inline]
    fn narrow_sum(&mut self, a: &[i64; 4], b: &[i64; 4]) -> Point3 {
        if self.weights != [a[3], b[3]] {
            let divisor = gcd_u64(a[3] as u64, b[3] as u64) as i64;
            self.weights = [a[3], b[3]];
            self.factors = [b[3] / divisor, a[3] / divisor];
        }
        let [v, w] = self.factors.map(i128::from);
        let [x, y, z] = [0, 1, 2].map(|axis: usize| i128::from(a[axis]) * v + i128::from(b[axis]) * w);
        Point3::of_i128([x, y, z, i128::from(a[3]) * v])
    }
}

/// Gives all points one common weight if all then stay narrow; otherwise makes each canonical.
///
/// Narrow points that have equal weights already are left as they are; else the weight becomes the least common multiple of
/// the weights, or of the canonical weights where only these stay narrow.
///
/// # Complexity
/// A comparison per point if the weights are equal; else a greatest common divisor and a product per point.
pub fn share_weight(points: &mut [Point3]) {
    let weight = |point: &Point3| point.as_narrow().map(|homogeneous| homogeneous[3]);
    let Some(first) = points.first().map(weight) else { return };
    if first.is_some() && points.iter().all(|point| weight(point) == first) {
        return;
    }
    if try_share(points) {
        return;
    }
    for point in points.iter_mut() {
        *point = point.canonical();
    }
    try_share(points);
}

/// Gives all points their least common weight if all then stay narrow, and tells whether it did.
fn try_share(points: &mut [Point3]) -> bool {
    let Some(common) = common_weight(points) else { return false };
    // Runs of points have the same weight: one division a run.
    let (mut weight, mut factor) = (common, 1);
    let scaled = |point: &Point3| {
        let homogeneous = point.as_narrow()?;
        if homogeneous[3] != weight {
            (weight, factor) = (homogeneous[3], i128::from(common / homogeneous[3]));
        }
        let scaled = homogeneous.map(|value| i128::from(value) * factor);
        fits(&scaled).then(|| Point3(Repr::Narrow(scaled.map(|value| value as i64))))
    };
    let Some(scaled) = points.iter().map(scaled).collect::<Option<Vec<_>>>() else { return false };
    points.iter_mut().zip(scaled).for_each(|(point, scaled)| *point = scaled);
    true
}

/// The least common multiple of the weights of narrow points; `None` if a point or the result is not narrow.
fn common_weight(points: &[Point3]) -> Option<i64> {
    points.iter().try_fold(1_i64, |common, point| {
        let weight = point.as_narrow()?[3];
        if common == weight || common % weight == 0 {
            return Some(common);
        }
        let divisor = gcd_u64(common.unsigned_abs(), weight.unsigned_abs()) as i64;
        let multiple = i128::from(common / divisor) * i128::from(weight);
        (multiple >> NARROW_BITS == 0).then_some(multiple as i64)
    })
}

#[cfg(test)]
mod tests;
