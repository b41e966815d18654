//! Exact rotations: integer quaternions, and the one for an axis and an angle.

use crate::trigonometry::{BITS, Scaled, pi, sine_cosine, times};
use crate::{Integer, Point3, Rational, Sign};
use std::fmt;

/// A rotation as a quaternion w + x i + y j + z k with coprime integer components, not all zero.
///
/// A quaternion and its multiples are the same rotation; the first component that is not zero is positive, so that equal
/// rotations are equal quaternions.
///
/// ```
/// use exact::{Quaternion, Rational};
/// let axis = ["0", "0", "1"].map(|text| text.parse::<Rational>().expect("a number"));
/// let quarter = Quaternion::nearest(axis, Rational::from(90))?;
/// assert_eq!(quarter.to_string(), "1,0,0,1");
/// # Ok::<(), exact::ZeroAxis>(())
/// ```
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Quaternion([Integer; 4]);

/// An axis of rotation without a direction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ZeroAxis;

impl fmt::Display for ZeroAxis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the axis of a rotation must not be the zero vector")
    }
}

impl std::error::Error for ZeroAxis {}

/// The greatest number of bits of an axis component; beyond it the axis is rounded.
const AXIS_BITS: u32 = 42;

impl Quaternion {
    /// Makes the rotation of w, x, y, z, divided by their greatest common divisor; `None` if all are zero.
    pub fn new(components: [Integer; 4]) -> Option<Self> {
        let divisor = components.iter().fold(Integer::ZERO, |divisor, value| divisor.gcd(value));
        let first = components.iter().find(|value| !value.is_zero())?;
        let divisor = if first.sign() == Sign::Negative { -divisor } else { divisor };
        Some(Self(components.map(|value| value.div_exact(&divisor))))
    }

    /// Makes the rotation of rational w, x, y, z; `None` if all are zero.
    pub fn from_rationals(components: &[Rational; 4]) -> Option<Self> {
        let weight = components.iter().fold(Integer::ONE, |weight, value| weight.lcm(&value.denominator()));
        Self::new(
            components.each_ref().map(|value| value.numerator() * weight.div_exact(&value.denominator())),
        )
    }

    /// Gives the rotation that changes nothing.
    pub fn identity() -> Self {
        Self([1, 0, 0, 0].map(Integer::from))
    }

    /// Gives an exact rotation within 1e-12 radians of the one about `axis` (of any length) by an angle in degrees,
    /// counterclockwise seen from the tip of the axis.
    ///
    /// The rule of rounding:
    /// 1. The axis becomes a coprime integer vector a. Only if a component has more than 42 bits, a is scaled so that its
    ///    greatest component is 2^42, and rounded to nearest: a change of direction of less than 2e-13.
    /// 2. The quaternion is (q, p a), where p/q is the simplest fraction (least p and q) for which the angle,
    ///    2 arctan(|a| p/q), is within 5e-13 of the asked one. The axis is not changed any more.
    ///
    /// So an angle whose quaternion is that simple is exact: all multiples of 90 degrees about the coordinate axes, of 120 about
    /// (1,1,1), of 180 about any axis that is not rounded. Angles below 5e-13 become no rotation.
    ///
    /// About a coordinate axis p and q have about 22 bits, so that 20-bit coordinates stay narrow; only right beside a simple
    /// fraction (90.000001 degrees) they need more, up to 42. An axis of length l adds log2(l)/2 bits, so write short ones: (1,2,3),
    /// not its decimals.
    ///
    /// # Errors
    /// [`ZeroAxis`] if the axis is zero.
    ///
    /// # Complexity
    /// Well below a millisecond.
    pub fn nearest(axis: [Rational; 3], degrees: Rational) -> Result<Self, ZeroAxis> {
        let mut axis = integer_axis(&axis).ok_or(ZeroAxis)?;
        let mut degrees = within_half_turn(degrees);
        if degrees.sign() == Sign::Negative {
            degrees = -degrees;
            axis = axis.map(|value| -value);
        }
        let square: Integer = axis.iter().map(|value| value * value).sum();
        let length: Scaled = (square << (2 * BITS)).sqrt_floor().expect("a sum of squares is not negative");
        let half = times(&fraction(1, 360), &times(&degrees, &pi()));
        // Half of 5e-13, because these are half angles.
        let slack = times(&fraction(25, 100_000_000_000_000), &(Integer::ONE << BITS));
        let (below, above) = (sine_cosine(&(&half - &slack)), sine_cosine(&(&half + &slack)));
        let (w, factor) = if degrees <= Rational::from(90) {
            // Bounds of p/q = tan(half) / |a|.
            let ratio = |(sine, cosine): (Scaled, Scaled)| {
                Rational::new(sine << BITS, cosine * &length).expect("the half angle is at most 45 degrees")
            };
            let (p, q) = simplest_between(ratio(below), ratio(above));
            (q, p)
        } else {
            // Bounds of q/p = |a| / tan(half), which is zero at half a turn.
            let ratio = |(sine, cosine): (Scaled, Scaled)| {
                Rational::new(cosine * &length, sine << BITS).expect("the half angle is at least 45 degrees")
            };
            simplest_between(ratio(above), ratio(below))
        };
        let [x, y, z] = axis.map(|value| value * &factor);
        Ok(Self::new([w, x, y, z]).expect("numerator and denominator of a fraction are not both zero"))
    }

    /// Gives w, x, y, z.
    pub fn components(&self) -> &[Integer; 4] {
        &self.0
    }

    /// Gives the number of bits of the greatest component.
    pub fn bits(&self) -> u32 {
        self.0.iter().map(Integer::bit_len).max().unwrap_or(0)
    }

    /// The rows of the matrix of the rotation, times the squared length; and the squared length.
    pub(crate) fn matrix(&self) -> ([[Integer; 3]; 3], Integer) {
        let [w, x, y, z] = &self.0;
        let double = |a: Integer| a * Integer::from(2);
        let (ww, xx, yy, zz) = (w * w, x * x, y * y, z * z);
        let rows = [
            [&ww + &xx - &yy - &zz, double(x * y - w * z), double(x * z + w * y)],
            [double(x * y + w * z), &ww - &xx + &yy - &zz, double(y * z - w * x)],
            [double(x * z - w * y), double(y * z + w * x), &ww - &xx - &yy + &zz],
        ];
        (rows, ww + xx + yy + zz)
    }
}

impl fmt::Display for Quaternion {
    /// Writes w,x,y,z.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [w, x, y, z] = &self.0;
        write!(f, "{w},{x},{y},{z}")
    }
}

fn fraction(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator.into(), denominator.into()).expect("a literal denominator is not zero")
}

/// The axis as coprime integers of at most [`AXIS_BITS`] bits (and one, for a power of two); `None` for zero.
fn integer_axis(axis: &[Rational; 3]) -> Option<[Integer; 3]> {
    let numerators = Point3::from_rationals(axis);
    let numerators = [0, 1, 2].map(|axis| numerators.numerator(axis));
    let coprime = |vector: [Integer; 3]| {
        let divisor = vector.iter().fold(Integer::ZERO, |divisor, value| divisor.gcd(value));
        vector.map(|value| value.div_exact(&divisor))
    };
    let greatest = numerators.iter().map(Integer::abs).max()?;
    if greatest.is_zero() {
        return None;
    }
    let axis = coprime(numerators);
    let greatest = axis.iter().map(Integer::abs).max()?;
    if greatest.bit_len() <= AXIS_BITS {
        return Some(axis);
    }
    Some(coprime(axis.map(|value| (value << AXIS_BITS).div_round(&greatest))))
}

/// The angle modulo 360 that lies above -180 and not above 180.
fn within_half_turn(degrees: Rational) -> Rational {
    let turn = Rational::from(360);
    let turns = (Rational::from(180) - &degrees) * fraction(1, 360);
    degrees + turn * Rational::from(turns.floor())
}

/// Numerator and denominator of the simplest fraction in a closed interval: no other one in it has a smaller numerator or a
/// smaller denominator.
///
/// # References
/// The continued fractions of both bounds agree up to the wanted one: descent in the Stern-Brocot tree.
fn simplest_between(low: Rational, high: Rational) -> (Integer, Integer) {
    if low.sign() != Sign::Positive {
        debug_assert!(high.sign() != Sign::Negative, "the half angle is not negative");
        return (Integer::ZERO, Integer::ONE);
    }
    let (mut low, mut high) = (low, high);
    // The last two convergents.
    let (mut previous, mut last) = ((Integer::ZERO, Integer::ONE), (Integer::ONE, Integer::ZERO));
    loop {
        let floor = low.floor();
        let is_integer = low.is_integer();
        let whole = Rational::from(&floor);
        let (term, done) = if is_integer {
            (floor, true)
        } else if Rational::from(&floor) + Rational::ONE <= high {
            (floor + Integer::ONE, true)
        } else {
            (floor, false)
        };
        let next = (&term * &last.0 + previous.0, &term * &last.1 + previous.1);
        (previous, last) = (last, next);
        if done {
            return last;
        }
        let inverse =
            |value: Rational| (value - &whole).recip().expect("an integer bound has ended the descent");
        (low, high) = (inverse(high), inverse(low));
    }
}

#[cfg(test)]
mod tests;
