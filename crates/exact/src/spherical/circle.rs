//! Oriented great circles.

use super::{Direction, NARROW_BITS, decide};
use crate::gcd::{gcd_u64, gcd_u128};
use crate::rational::{approx_quotient, power_of_two};
use crate::{Integer, Quaternion, Sign, Vector3};
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// A great circle, run through counterclockwise around its normal, a primitive integer vector.
///
/// Its positive side is the hemisphere around the normal, the one on the left. Equal circles have the same normal; a circle and its
/// [opposite](GreatCircle::opposite) have the same points.
///
/// ```
/// use exact::spherical::{Direction, GreatCircle};
/// let [p, q] = [[2, 0, 0], [1, 1, 0]].map(|p| Direction::from_i64(p).expect("not zero"));
/// let equator = GreatCircle::through(&p, &q).expect("neither equal nor antipodal");
/// assert_eq!(equator.to_string(), "(0, 0, 1)");
/// assert_eq!(GreatCircle::through(&q, &p), Some(equator.opposite()));
/// assert_eq!(GreatCircle::through(&p, &p.opposite()), None);
/// ```
#[derive(Clone)]
pub struct GreatCircle(Repr);

#[derive(Clone)]
enum Repr {
    /// Coordinates below 2^`bits`, at most [`NARROW_BITS`].
    Narrow {
        bits: u8,
        normal: [i64; 3],
    },
    Wide(Arc<WideNormal>),
}

struct WideNormal {
    normal: [Integer; 3],
    /// See [`approx_scaled`].
    approx: [f64; 3],
}

const _: () = assert!(size_of::<GreatCircle>() <= 32);

/// Half the distance from 1 to the next `f64`.
const UNIT: f64 = f64::EPSILON / 2.0;

/// The floats nearest to a vector that is not zero, divided by a power of two, and a bound of their errors, of which 4/5 are kept.
///
/// Every float is the nearest one to its own coordinate, however small that is beside the others: so floats tell where a point is beside a
/// pole. Only below 2^-1022 precision is lost, and below 2^-1075 all of it.
///
/// # Proof
/// With b bits of the greatest coordinate, b > 62, all are divided by 2^(b - 62). The greatest is at least 2^61 then, and all are below 2^62. With
/// u = 2^-53, rounding changes one by u 2^62 = 512 at most, and the bound is 2 u 2^62 = 1024.
pub(super) fn approx_scaled(vector: &[Integer; 3]) -> ([f64; 3], f64) {
    let bits = vector.iter().map(Integer::bit_len).max().unwrap_or(0);
    let shift = bits.saturating_sub(NARROW_BITS);
    let scaled = if bits < f64::MAX_EXP.unsigned_abs() {
        // No integer is infinite then, nor is a quotient below 2^-1022: so dividing is exact.
        let unit = power_of_two(-i64::from(shift));
        vector.each_ref().map(|value| value.approx_f64() * unit)
    } else {
        let unit = Integer::ONE << shift;
        vector.each_ref().map(|value| {
            let magnitude = approx_quotient(&value.abs(), &unit);
            if value.sign() == Sign::Negative { -magnitude } else { magnitude }
        })
    };
    (scaled, 2.0 * UNIT * (1_u64 << NARROW_BITS) as f64)
}

/// The number of bits of the greatest magnitude, or one more.
#[inline(always)]
pub(super) fn bits_of(vector: &[i64; 3]) -> u32 {
    let all = vector.iter().fold(0, |all, value| all | value.unsigned_abs());
    64 - all.leading_zeros()
}

/// Machine integers in lowest terms; `None` for the zero vector.
pub(super) fn reduced(vector: [i64; 3]) -> Option<[i64; 3]> {
    let [x, y, z] = vector.map(i64::unsigned_abs);
    match gcd_u64(gcd_u64(x, y), z) {
        0 => None,
        1 => Some(vector),
        // Only for coordinates that are all zero or the least i64.
        divisor => match i64::try_from(divisor) {
            Ok(divisor) => Some(vector.map(|value| value / divisor)),
            Err(_) => Some(vector.map(i64::signum)),
        },
    }
}

impl GreatCircle {
    /// Makes the circle around a normal; `None` if that is zero.
    pub fn new(normal: &Vector3) -> Option<Self> {
        match normal.as_narrow() {
            Some(&normal) => reduced(normal).map(Self::narrow),
            None => Self::of_integers(normal.coordinates()),
        }
    }

    /// Makes the circle around a normal of machine integers; `None` if that is zero.
    pub fn from_i64(normal: [i64; 3]) -> Option<Self> {
        Self::new(&Vector3::from_i64(normal))
    }

    /// Makes the circle that runs from a point to another one by the shorter way; `None` if they are equal or antipodal.
    ///
    /// # Complexity
    /// For narrow explicit points, one or two greatest common divisors of machine integers.
    pub fn through(p: &Direction, q: &Direction) -> Option<Self> {
        match (p.as_narrow(), q.as_narrow()) {
            (Some(p), Some(q)) => Self::narrow_cross(p, q),
            _ => {
                let [p, q] = [p, q].map(Direction::multiple);
                Self::of_integers(crate::predicate::cross(p, q))
            }
        }
    }

    /// The circle around a x b.
    fn narrow_cross(a: &[i64; 3], b: &[i64; 3]) -> Option<Self> {
        if bits_of(a) + bits_of(b) <= NARROW_BITS {
            // Two terms below 2^62.
            let ([ax, ay, az], [bx, by, bz]) = (a, b);
            let product = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
            return reduced(product).map(Self::of_reduced);
        }
        // Below 2^125.
        let [x, y, z] = decide::cross_i128(a, b);
        let divisor = gcd_u128(gcd_u128(x.unsigned_abs(), y.unsigned_abs()), z.unsigned_abs()) as i128;
        if divisor == 0 {
            return None;
        }
        let normal = [x, y, z].map(|value| if divisor == 1 { value } else { value / divisor });
        Some(match normal.map(i64::try_from) {
            [Ok(x), Ok(y), Ok(z)] => Self::of_reduced([x, y, z]),
            _ => Self::wide(normal.map(Integer::from)),
        })
    }

    /// Any integers; `None` if all are zero.
    pub(crate) fn of_integers([x, y, z]: [Integer; 3]) -> Option<Self> {
        let divisor = x.gcd(&y).gcd(&z);
        if divisor.is_zero() {
            return None;
        }
        let normal = [x, y, z].map(|value| value.div_exact(&divisor));
        Some(match normal.each_ref().map(Integer::to_i64) {
            [Some(x), Some(y), Some(z)] => Self::of_reduced([x, y, z]),
            _ => Self::wide(normal),
        })
    }

    /// Coprime integers.
    #[inline]
    fn of_reduced(normal: [i64; 3]) -> Self {
        if bits_of(&normal) > NARROW_BITS {
            Self::wide(normal.map(Integer::from))
        } else {
            Self::narrow(normal)
        }
    }

    /// Coprime narrow integers.
    #[inline]
    fn narrow(normal: [i64; 3]) -> Self {
        Self(Repr::Narrow { bits: bits_of(&normal) as u8, normal })
    }

    /// Coprime integers that are not all narrow.
    #[cold]
    fn wide(normal: [Integer; 3]) -> Self {
        let (approx, _) = approx_scaled(&normal);
        Self(Repr::Wide(Arc::new(WideNormal { normal, approx })))
    }

    /// The normal, if it is narrow.
    #[inline(always)]
    pub(crate) fn narrow_normal(&self) -> Option<&[i64; 3]> {
        self.as_narrow().map(|(normal, _)| normal)
    }

    /// The normal, if it is narrow, and the least k such that its coordinates are below 2^k.
    #[inline(always)]
    pub(super) fn as_narrow(&self) -> Option<(&[i64; 3], u32)> {
        match &self.0 {
            Repr::Narrow { bits, normal } => Some((normal, u32::from(*bits))),
            Repr::Wide(_) => None,
        }
    }

    /// Floats near to a positive multiple of the normal, and a bound of their errors, of which 4/5 are kept; zero if they are exact.
    ///
    /// A narrow coordinate below 2^k is off by at most u 2^k.
    #[inline(always)]
    pub(super) fn approx_box(&self) -> ([f64; 3], f64) {
        match &self.0 {
            Repr::Narrow { bits, normal } => {
                let error = if u32::from(*bits) <= f64::MANTISSA_DIGITS {
                    0.0
                } else {
                    2.0 * UNIT * (1_u64 << *bits) as f64
                };
                (normal.map(|value| value as f64), error)
            }
            Repr::Wide(wide) => (wide.approx, 2.0 * UNIT * (1_u64 << NARROW_BITS) as f64),
        }
    }

    /// The coordinates of the normal.
    pub fn coordinates(&self) -> [Integer; 3] {
        match &self.0 {
            Repr::Narrow { normal, .. } => normal.map(Integer::from),
            Repr::Wide(wide) => wide.normal.clone(),
        }
    }

    /// The normal.
    pub fn normal(&self) -> Vector3 {
        match &self.0 {
            Repr::Narrow { normal, .. } => Vector3::from_i64(*normal),
            Repr::Wide(wide) => Vector3::new(wide.normal.clone()),
        }
    }

    /// Gives the sign of a coordinate of the normal; axes are counted 0, 1, 2.
    ///
    /// # Panics
    /// If `axis` is not below 3.
    #[inline]
    pub fn sign(&self, axis: usize) -> Sign {
        match &self.0 {
            Repr::Narrow { normal, .. } => Sign::of_i64(normal[axis]),
            Repr::Wide(wide) => wide.normal[axis].sign(),
        }
    }

    /// Tells whether the circle passes through the poles.
    #[inline]
    pub fn is_meridian(&self) -> bool {
        self.sign(2).is_zero()
    }

    /// Gives the circle in the other sense.
    #[inline]
    pub fn opposite(&self) -> Self {
        match &self.0 {
            Repr::Narrow { bits, normal } => {
                Self(Repr::Narrow { bits: *bits, normal: normal.map(|value| -value) })
            }
            Repr::Wide(wide) => Self::wide(wide.normal.each_ref().map(|value| -value)),
        }
    }

    /// Tells whether two circles have the same points.
    pub fn is_same_set(&self, other: &Self) -> bool {
        self == other || *self == other.opposite()
    }

    /// Gives the point where the circle comes to the equator from the south, or a meridian from the south pole; `None` for the equator.
    ///
    /// It is z x n, with the normal n.
    ///
    /// ```
    /// use exact::spherical::GreatCircle;
    /// let circle = GreatCircle::from_i64([3, -2, 7]).expect("not zero");
    /// assert_eq!(circle.ascending_node().expect("not the equator").to_string(), "(2, 3, 0)");
    /// ```
    pub fn ascending_node(&self) -> Option<Direction> {
        match &self.0 {
            Repr::Narrow { normal: [x, y, _], .. } => Direction::from_i64([-y, *x, 0]),
            Repr::Wide(wide) => {
                let [x, y, _] = &wide.normal;
                Direction::new([-y, x.clone(), Integer::ZERO])
            }
        }
    }

    /// Gives the normal as a direction: the pole of the circle on its positive side.
    pub fn pole(&self) -> Direction {
        Direction::new(self.coordinates()).expect("a normal is not zero")
    }

    /// Gives the circle turned by a rotation.
    pub fn turned(&self, rotation: &Quaternion) -> Self {
        let (rows, _) = rotation.matrix();
        Self::of_integers(product(&rows, &self.coordinates())).expect("a rotation keeps lengths")
    }

    /// Gives three words by which [`side_of_key`](super::side_of_key) may tell a side of the circle.
    ///
    /// They are the bits of `f32`s near to a positive multiple of the normal. Three zeros belong to no circle, and tell nothing.
    #[inline]
    pub fn side_key(&self) -> [u32; 3] {
        let (approx, _) = self.approx_box();
        approx.map(|coordinate| (coordinate as f32).to_bits())
    }
}

/// A matrix times a vector.
pub(super) fn product(rows: &[[Integer; 3]; 3], vector: &[Integer; 3]) -> [Integer; 3] {
    let row = |row: &[Integer; 3]| row.iter().zip(vector).map(|(entry, value)| entry * value).sum();
    rows.each_ref().map(row)
}

impl PartialEq for GreatCircle {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        // Every circle has one representation: narrow if it fits.
        match (&self.0, &other.0) {
            (Repr::Narrow { normal: m, .. }, Repr::Narrow { normal: n, .. }) => m == n,
            (Repr::Wide(m), Repr::Wide(n)) => Arc::ptr_eq(m, n) || m.normal == n.normal,
            _ => false,
        }
    }
}

impl Eq for GreatCircle {}

impl Hash for GreatCircle {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match &self.0 {
            Repr::Narrow { normal, .. } => normal.hash(state),
            Repr::Wide(wide) => wide.normal.hash(state),
        }
    }
}

impl fmt::Display for GreatCircle {
    /// Writes the normal.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.coordinates();
        write!(f, "({x}, {y}, {z})")
    }
}

impl fmt::Debug for GreatCircle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
