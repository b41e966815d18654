//! Integer vectors whose storage follows their size, with a cached float for every coordinate.

use crate::fixed::Fixed;
use crate::gcd::{gcd_u64, gcd_u128};
use crate::{Integer, Sign};
use std::fmt;
use std::hash::{Hash, Hasher};
use std::ops::{Add, Neg, Sub};

/// How large the coordinates of a vector are; every vector has the least width that holds it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Width {
    /// Every coordinate is below 2^62 in magnitude.
    Narrow,
    /// Every coordinate is below 2^126 in magnitude, and one is not below 2^62.
    Double,
    /// A coordinate is 2^126 or more in magnitude.
    Wide,
}

/// An integer vector: an edge, a normal or a direction (then any positive multiple means the same).
///
/// The storage is chosen per vector, so that one wide vector does not slow the others; equality is by value.
///
/// ```
/// use exact::{Integer, Vector3, Width};
/// let a = Vector3::from_i64([1 << 40, 2, 3]);
/// let b = Vector3::from_i64([4, 1 << 40, 6]);
/// assert_eq!(a.cross(&b).width(), Width::Double);
/// assert_eq!(a.cross(&b).dot(&a), Integer::ZERO);
/// assert_eq!(Vector3::from_i64([4, -6, 0]).primitive(), Vector3::from_i64([2, -3, 0]));
/// ```
#[derive(Clone)]
pub struct Vector3 {
    /// The `f64` nearest to each coordinate (infinite beyond the range).
    approx: [f64; 3],
    repr: Repr,
}

#[derive(Clone)]
enum Repr {
    /// With the number of bits of the greatest magnitude.
    Narrow {
        bits: u8,
        coordinates: [i64; 3],
    },
    /// As limbs, so that the vector has the alignment of a machine word.
    Double([Fixed<2>; 3]),
    Wide(Box<[Integer; 3]>),
}

/// Bits below which a coordinate is narrow.
const NARROW_BITS: u32 = 62;
/// Bits below which a coordinate is of double width.
const DOUBLE_BITS: u32 = 126;

#[inline(always)]
fn bits_of_i64(values: &[i64; 3]) -> u32 {
    64 - values.iter().fold(0, |all, value| all | value.unsigned_abs()).leading_zeros()
}

#[inline(always)]
fn bits_of_i128(values: &[i128; 3]) -> u32 {
    128 - values.iter().fold(0, |all, value| all | value.unsigned_abs()).leading_zeros()
}

#[inline(always)]
fn join(value: &Fixed<2>) -> i128 {
    (i128::from(value.0[1] as i64) << 64) | i128::from(value.0[0])
}

impl Vector3 {
    /// Makes a vector.
    pub fn new(coordinates: [Integer; 3]) -> Self {
        let machine = [coordinates[0].to_i128(), coordinates[1].to_i128(), coordinates[2].to_i128()];
        if let [Some(x), Some(y), Some(z)] = machine {
            return Self::from_i128([x, y, z]);
        }
        Self::wide(coordinates)
    }

    fn wide(coordinates: [Integer; 3]) -> Self {
        let approx = [0, 1, 2].map(|axis: usize| coordinates[axis].approx_f64());
        Self { approx, repr: Repr::Wide(Box::new(coordinates)) }
    }

    /// Makes a vector from machine integers.
    #[inline]
    pub fn from_i64(coordinates: [i64; 3]) -> Self {
        let bits = bits_of_i64(&coordinates);
        let repr = if bits <= NARROW_BITS {
            Repr::Narrow { bits: bits as u8, coordinates }
        } else {
            Repr::Double(coordinates.map(Fixed::from))
        };
        Self { approx: coordinates.map(|value| value as f64), repr }
    }

    /// Makes a vector from machine integers of double width.
    #[inline]
    pub fn from_i128(coordinates: [i128; 3]) -> Self {
        let bits = bits_of_i128(&coordinates);
        if bits <= NARROW_BITS {
            let coordinates = coordinates.map(|value| value as i64);
            let approx = coordinates.map(|value| value as f64);
            Self { approx, repr: Repr::Narrow { bits: bits as u8, coordinates } }
        } else if bits <= DOUBLE_BITS {
            let approx = coordinates.map(|value| value as f64);
            Self { approx, repr: Repr::Double(coordinates.map(Fixed::from)) }
        } else {
            Self::wide(coordinates.map(Integer::from))
        }
    }

    /// Gives one coordinate; axes are counted 0, 1, 2.
    ///
    /// # Panics
    /// If `axis` is not below 3.
    pub fn coordinate(&self, axis: usize) -> Integer {
        match &self.repr {
            Repr::Narrow { coordinates, .. } => Integer::from(coordinates[axis]),
            Repr::Double(coordinates) => Integer::from(join(&coordinates[axis])),
            Repr::Wide(coordinates) => coordinates[axis].clone(),
        }
    }

    /// Gives all coordinates.
    pub fn coordinates(&self) -> [Integer; 3] {
        [0, 1, 2].map(|axis| self.coordinate(axis))
    }

    /// Gives the number of bits of the greatest magnitude.
    pub fn bits(&self) -> u32 {
        match &self.repr {
            Repr::Narrow { bits, .. } => u32::from(*bits),
            Repr::Double(coordinates) => bits_of_i128(&coordinates.each_ref().map(join)),
            Repr::Wide(coordinates) => coordinates.iter().map(Integer::bit_len).max().unwrap_or(0),
        }
    }

    /// Gives the width, which is the least that holds the vector.
    #[inline]
    pub fn width(&self) -> Width {
        match self.repr {
            Repr::Narrow { .. } => Width::Narrow,
            Repr::Double(_) => Width::Double,
            Repr::Wide(_) => Width::Wide,
        }
    }

    /// Gives the coordinates as machine integers if the vector is narrow.
    #[inline(always)]
    pub fn as_narrow(&self) -> Option<&[i64; 3]> {
        match &self.repr {
            Repr::Narrow { coordinates, .. } => Some(coordinates),
            _ => None,
        }
    }

    /// Gives the coordinates in machine integers of double width if the vector is not wide.
    #[inline(always)]
    pub fn to_i128(&self) -> Option<[i128; 3]> {
        match &self.repr {
            Repr::Narrow { coordinates, .. } => Some(coordinates.map(i128::from)),
            Repr::Double(coordinates) => Some(coordinates.each_ref().map(join)),
            Repr::Wide(_) => None,
        }
    }

    /// The number of bits if the vector is narrow.
    #[inline(always)]
    pub(crate) fn narrow_bits(&self) -> Option<u32> {
        match self.repr {
            Repr::Narrow { bits, .. } => Some(u32::from(bits)),
            _ => None,
        }
    }

    /// The coordinates as limbs if the vector is not wide.
    #[inline(always)]
    pub(crate) fn to_double(&self) -> Option<[Fixed<2>; 3]> {
        match &self.repr {
            Repr::Narrow { coordinates, .. } => Some(coordinates.map(Fixed::from)),
            Repr::Double(coordinates) => Some(*coordinates),
            Repr::Wide(_) => None,
        }
    }

    /// Tells whether all coordinates are zero.
    #[inline]
    pub fn is_zero(&self) -> bool {
        matches!(self.repr, Repr::Narrow { bits: 0, .. })
    }

    /// Gives the sign of one coordinate.
    ///
    /// # Panics
    /// If `axis` is not below 3.
    #[inline]
    pub fn sign(&self, axis: usize) -> Sign {
        // The cached float is nearest to an integer, so it has its sign.
        self.approx[axis].partial_cmp(&0.0).expect("a rounded integer is not NaN").into()
    }

    /// Divides by the greatest common divisor of the coordinates. The zero vector stays.
    ///
    /// # Complexity
    /// One or two greatest common divisors.
    pub fn primitive(&self) -> Self {
        match &self.repr {
            Repr::Narrow { coordinates, .. } => {
                let [x, y, z] = coordinates.map(i64::unsigned_abs);
                let divisor = gcd_u64(gcd_u64(x, y), z) as i64;
                if divisor <= 1 {
                    self.clone()
                } else {
                    Self::from_i64(coordinates.map(|value| value / divisor))
                }
            }
            Repr::Double(coordinates) => {
                let coordinates = coordinates.each_ref().map(join);
                let [x, y, z] = coordinates.map(i128::unsigned_abs);
                let divisor = gcd_u128(gcd_u128(x, y), z) as i128;
                if divisor <= 1 {
                    self.clone()
                } else {
                    Self::from_i128(coordinates.map(|value| value / divisor))
                }
            }
            Repr::Wide(coordinates) => {
                let [x, y, z] = &**coordinates;
                let divisor = x.gcd(y).gcd(z);
                if divisor == Integer::ONE {
                    self.clone()
                } else {
                    Self::new([x, y, z].map(|value| value.div_exact(&divisor)))
                }
            }
        }
    }

    /// Gives the vector product.
    ///
    /// Exact if it is not wide (always so for narrow vectors). A wide product is made primitive: a positive multiple of it.
    #[inline]
    pub fn cross(&self, other: &Self) -> Self {
        if let (Repr::Narrow { bits: m, coordinates: a }, Repr::Narrow { bits: n, coordinates: b }) =
            (&self.repr, &other.repr)
        {
            return Self::narrow_cross((u32::from(*m), a), (u32::from(*n), b));
        }
        self.cross_wide(other)
    }

    /// Gives the vector product of coordinates below 2^62 in magnitude, those of narrow vectors.
    ///
    /// # Panics
    /// In debug builds, if a coordinate is not below 2^62 in magnitude.
    #[inline]
    pub fn cross_of_i64(a: &[i64; 3], b: &[i64; 3]) -> Self {
        Self::narrow_cross((bits_of_i64(a), a), (bits_of_i64(b), b))
    }

    /// With the numbers of bits.
    #[inline]
    fn narrow_cross((m, a): (u32, &[i64; 3]), (n, b): (u32, &[i64; 3])) -> Self {
        debug_assert!(m.max(n) <= NARROW_BITS);
        if m + n < 62 {
            // |c| < 2 * 2^61: one machine word.
            let ([ax, ay, az], [bx, by, bz]) = (a, b);
            return Self::from_i64([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]);
        }
        let [ax, ay, az] = a.map(i128::from);
        let [bx, by, bz] = b.map(i128::from);
        // |c| <= 2 (2^62 - 1)^2 < 2^125.
        Self::from_i128([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])
    }

    #[inline(never)]
    fn cross_wide(&self, other: &Self) -> Self {
        let product = Self::new(crate::predicate::cross(self.coordinates(), other.coordinates()));
        if product.width() == Width::Wide { product.primitive() } else { product }
    }

    /// Gives the scalar product.
    pub fn dot(&self, other: &Self) -> Integer {
        if let (Some(a), Some(b)) = (self.as_narrow(), other.as_narrow()) {
            // |a . b| < 3 * 2^124.
            return Integer::from((0..3).map(|i| i128::from(a[i]) * i128::from(b[i])).sum::<i128>());
        }
        crate::predicate::dot(self.coordinates(), other.coordinates())
    }

    /// Multiplies by a number.
    pub fn scaled(&self, factor: &Integer) -> Self {
        if let (Some(vector), Some(factor)) = (self.as_narrow(), factor.to_i64()) {
            return Self::from_i128(vector.map(|value| i128::from(value) * i128::from(factor)));
        }
        Self::new(self.coordinates().map(|value| value * factor))
    }

    /// Gives the `f64` nearest to each coordinate; infinite beyond the range of `f64`.
    #[inline(always)]
    pub fn approx_f64(&self) -> [f64; 3] {
        self.approx
    }
}

impl Neg for &Vector3 {
    type Output = Vector3;
    #[inline]
    fn neg(self) -> Vector3 {
        let repr = match &self.repr {
            Repr::Narrow { bits, coordinates } => {
                Repr::Narrow { bits: *bits, coordinates: coordinates.map(|value| -value) }
            }
            Repr::Double(coordinates) => Repr::Double(coordinates.map(|value| -value)),
            Repr::Wide(coordinates) => Repr::Wide(Box::new(coordinates.each_ref().map(|value| -value))),
        };
        // 0 - x keeps the zero of the cache positive.
        Vector3 { approx: self.approx.map(|value| 0.0 - value), repr }
    }
}

impl Neg for Vector3 {
    type Output = Vector3;
    #[inline]
    fn neg(self) -> Vector3 {
        -&self
    }
}

impl Add for &Vector3 {
    type Output = Vector3;
    #[inline]
    fn add(self, other: &Vector3) -> Vector3 {
        if let (Some(a), Some(b)) = (self.as_narrow(), other.as_narrow()) {
            return Vector3::from_i64([a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
        }
        let (a, b) = (self.coordinates(), other.coordinates());
        Vector3::new([0, 1, 2].map(|axis: usize| &a[axis] + &b[axis]))
    }
}

impl Sub for &Vector3 {
    type Output = Vector3;
    #[inline]
    fn sub(self, other: &Vector3) -> Vector3 {
        self + &-other
    }
}

impl PartialEq for Vector3 {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        // Every value has one representation: the least width.
        match (&self.repr, &other.repr) {
            (Repr::Narrow { coordinates: a, .. }, Repr::Narrow { coordinates: b, .. }) => a == b,
            (Repr::Double(a), Repr::Double(b)) => a == b,
            (Repr::Wide(a), Repr::Wide(b)) => a == b,
            _ => false,
        }
    }
}

impl Eq for Vector3 {}

impl Hash for Vector3 {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match &self.repr {
            Repr::Narrow { coordinates, .. } => coordinates.hash(state),
            Repr::Double(coordinates) => coordinates.each_ref().map(join).hash(state),
            Repr::Wide(coordinates) => coordinates.hash(state),
        }
    }
}

impl fmt::Display for Vector3 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.coordinates();
        write!(f, "({x}, {y}, {z})")
    }
}

impl fmt::Debug for Vector3 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests;
