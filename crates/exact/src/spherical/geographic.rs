//! Longitude and latitude: the rational points of the unit sphere that stand for them.
//!
//! The sine of a latitude is hardly ever rational, and so a place on a globe has no exact direction in general. But points with rational
//! coordinates lie densely *on* the unit sphere: stereographic projection from a pole takes a grid of the plane to them. So a place
//! becomes one of these, and from then on everything is exact, distances along the sphere included.
//!
//! # How it works
//! 1. Reflections in the coordinate planes, and in the plane x = y, take every place to one of the northern hemisphere whose longitude is
//!    from 0 to 45 degrees. Reflections are exact, and so antipodal places get antipodal directions.
//! 2. Of what is left, with longitude `l` and latitude `b`, the projection from the south pole is tan(45 - b/2) (cos l, sin l), in
//!    the unit disc. It is rounded to the grid of multiples of 1/q, q = 2^30 - 1; the projection of (i, j)/q comes from the direction
//!    (2 q i, 2 q j, q^2 - i^2 - j^2), whose length is q^2 + i^2 + j^2.
//! 3. On the equator, that would leave the equator. So there the circle is projected, and not the sphere: tan(l/2) is rounded, and i/q
//!    comes from (q^2 - i^2, 2 q i, 0).
//!
//! Sines and cosines are evaluated in integers, with bounds; no floating-point number is involved.

use super::Direction;
use crate::trigonometry::{BITS, pi, sine_cosine, times};
use crate::{Integer, Rational, Sign};

/// The grid has this many steps from 0 to 1. Twice its square is below 2^61, and so are all coordinates.
const STEPS: i64 = (1 << 30) - 1;

/// Gives the point of the unit sphere that stands for a place: a direction whose integer coordinates have an integer length. `None`
/// if the latitude is not within -90 and 90 degrees.
///
/// Longitudes are counted from the x-axis counterclockwise, seen from the north pole (0, 0, 1), and may be any numbers: what matters is the
/// rest modulo 360.
///
/// Laws:
/// 1. The angle between the direction and the true one is less than 1.5e-9 radians (10 mm on the Earth).
/// 2. Coordinates are below 2^61 in magnitude, and the sum of their squares is a square; see [`exact_length`].
/// 3. A longitude that is a multiple of 90 degrees is exact: the direction lies in that half plane. So is latitude 0: it lies on the
///    equator. The poles are exact, whatever the longitude.
///    No place is rounded to the other side of the equator.
/// 4. Reflections of places in the three coordinate planes reflect their directions. So antipodal places get antipodal directions.
///
/// # Complexity
/// O(1) for numbers of a bounded length: machine words decide, but for one place in about two million.
///
/// ```
/// use exact::spherical::geographic::{exact_length, from_degrees};
///
/// let [longitude, latitude] = ["2.3522".parse()?, "48.8566".parse()?];
/// let paris = from_degrees(&longitude, &latitude).expect("a latitude");
/// assert!(exact_length(&paris).is_some());
/// let [x, y, z] = paris.approx_f64();
/// assert!((z.asin().to_degrees() - 48.8566).abs() < 1e-7 && (y.atan2(x).to_degrees() - 2.3522).abs() < 1e-7);
///
/// let date_line = from_degrees(&(-180).into(), &0.into()).expect("a latitude");
/// assert_eq!(date_line.to_string(), "(-1, 0, 0)");
/// assert!(from_degrees(&0.into(), &"90.5".parse()?).is_none());
/// # Ok::<(), exact::ParseNumberError>(())
/// ```
pub fn from_degrees(longitude: &Rational, latitude: &Rational) -> Option<Direction> {
    let coordinates = coordinates(longitude, latitude)?;
    Some(
        Direction::from_i64(coordinates)
            .expect("the sum of the squares is that of the length, which is positive"),
    )
}

/// Gives the length of the primitive integer coordinates of a direction, if it is an integer: if the unit vector of the direction has
/// rational coordinates. So have those of [`from_degrees`].
///
/// ```
/// use exact::spherical::{Direction, geographic::exact_length};
///
/// let [rational, irrational] = [[2, 4, 4], [1, 1, 0]].map(|v| Direction::from_i64(v).expect("not zero"));
/// assert_eq!(exact_length(&rational), Some(3.into())); // of (1, 2, 2)
/// assert_eq!(exact_length(&irrational), None);
/// ```
pub fn exact_length(direction: &Direction) -> Option<Integer> {
    let square: Integer = direction.coordinates().iter().map(|value| value * value).sum();
    let root = square.sqrt_floor()?;
    (&root * &root == square).then_some(root)
}

/// Coordinates that may have a common factor.
fn coordinates(longitude: &Rational, latitude: &Rational) -> Option<[i64; 3]> {
    let north = latitude.abs();
    if north > Rational::from(90) {
        return None;
    }
    let turns = longitude.numerator().div_floor(&(longitude.denominator() * Integer::from(360)));
    let (east, is_west) = folded(longitude - &Rational::from(turns * Integer::from(360)), 360);
    let (front, is_back) = folded(east, 180);
    let (around, is_side) = folded(front, 90);
    let half = half();
    let [x, y, z] = if north.is_zero() {
        let [i, _] = grid_place(&(around * half), &Rational::ZERO);
        [STEPS * STEPS - i * i, 2 * STEPS * i, 0]
    } else {
        let [i, j] = below_equator(grid_place(&((Rational::from(90) - north) * half), &around));
        [2 * STEPS * i, 2 * STEPS * j, STEPS * STEPS - i * i - j * j]
    };
    let [x, y] = if is_side { [y, x] } else { [x, y] };
    let signed = |value: i64, is_negative: bool| if is_negative { -value } else { value };
    Some([signed(x, is_back), signed(y, is_west), signed(z, latitude.sign() == Sign::Negative)])
}

/// Takes a place of the grid that rounding moved out of the unit disc, beyond the equator, back into it.
///
/// The place before rounding, q (x, y) with x >= y, is in the disc. So one less along x is (x q - 1/2)^2 + (y q + 1/2)^2 <= q^2 + 1/2 at most, and an
/// integer. The roundings were d along x and e along y, with x d + y e >= 0, so d >= -e, and the place is sqrt(1.5^2 + 0.5^2) < 1.59 steps away at
/// most. Near the equator a step is an angle of as many radians: less than 1.5e-9.
fn below_equator([i, j]: [i64; 2]) -> [i64; 2] {
    if i * i + j * j <= STEPS * STEPS {
        return [i, j];
    }
    // On the diagonal, both, so that reflections stay exact.
    [i - 1, j.min(i - 1)]
}

/// The lesser of an angle and what is left of `whole`; and whether that is the second.
fn folded(angle: Rational, whole: i64) -> (Rational, bool) {
    let rest = Rational::from(whole) - &angle;
    if rest < angle { (rest, true) } else { (angle, false) }
}

fn half() -> Rational {
    Rational::new(Integer::ONE, Integer::from(2)).expect("two is not zero")
}

/// Rounds tan(`radial`) (cos(`around`), sin(`around`)), both from 0 to 45 degrees, to the grid.
fn grid_place(radial: &Rational, around: &Rational) -> [i64; 2] {
    certain_place(radial, around).unwrap_or_else(|| wide_place(radial, around))
}

/// By sines and cosines with an error below 2^-240 each; what is rounded has one below 2^-200 steps. So it is the nearest point of the grid
/// unless two are as near as that.
fn wide_place(radial: &Rational, around: &Rational) -> [i64; 2] {
    let pi = pi();
    let radians = |degrees: &Rational| {
        let half_turns = Rational::new(degrees.numerator(), degrees.denominator() * Integer::from(180));
        times(&half_turns.expect("a denominator is positive"), &pi)
    };
    let (tangent_sine, tangent_cosine) = sine_cosine(&radians(radial));
    let divisor = tangent_cosine << BITS;
    let (sine, cosine) = sine_cosine(&radians(around));
    [cosine, sine].map(|along| {
        let steps = (&tangent_sine * along * Integer::from(STEPS)).div_round(&divisor);
        steps.to_i64().expect("a tangent of at most 45 degrees is at most 1")
    })
}

/// Fractional bits of machine words.
const SHORT_BITS: u32 = 62;

/// Bounds the error of what [`certain_place`] rounds, in units of 2^-62.
///
/// Let e = 2^-62. An angle x, at most pi/4, is a quotient and a product, each rounded down: its error is below 2 e. A term of a series is the term
/// before it times x, rounded down, and divided, rounded down. If the error of the one before is t e, that of the next is at most
/// (0.8 t + 2 + 1)/n + 1 in units of e for the divisor n, so never more than 5; there are at most 24 terms, so a sine or cosine has an error
/// below 120 e. A tangent, at most 1, of a cosine of at least 0.7, has at most (120 + 120)/0.7 + 1 < 350. The product with a sine or
/// cosine has at most 350 + 120 + 1. What [`wide_place`] finds differs from the truth by less than one more.
const SHORT_ERROR: i128 = 512;

/// The same place by machine words, where their error decides nothing.
fn certain_place(radial: &Rational, around: &Rational) -> Option<[i64; 2]> {
    let (tangent_sine, tangent_cosine) = short_sine_cosine(short_radians(radial)?);
    let tangent = (tangent_sine << SHORT_BITS) / tangent_cosine;
    let (sine, cosine) = short_sine_cosine(short_radians(around)?);
    let round = |along: i128| {
        let steps = ((tangent * along) >> SHORT_BITS) * i128::from(STEPS);
        let half = 1 << (SHORT_BITS - 1);
        let rest = steps & ((1 << SHORT_BITS) - 1);
        let is_certain = (rest - half).abs() > SHORT_ERROR * i128::from(STEPS);
        let nearest = (steps + half) >> SHORT_BITS;
        is_certain.then(|| i64::try_from(nearest).expect("a tangent of at most 45 degrees is at most 1"))
    };
    Some([round(cosine)?, round(sine)?])
}

/// An angle from 0 to 45 degrees, in units of 2^-62 radians.
fn short_radians(degrees: &Rational) -> Option<i128> {
    /// Pi/4 times 2^62, rounded down.
    const EIGHTH: i128 = 0x3243_F6A8_885A_308D;
    let part = (degrees.numerator() << SHORT_BITS).div_floor(&(degrees.denominator() * Integer::from(45)));
    Some((part.to_i128()? * EIGHTH) >> SHORT_BITS)
}

/// As [`sine_cosine`], of an angle from 0 to pi/4.
fn short_sine_cosine(angle: i128) -> (i128, i128) {
    let mut sums = [1_i128 << SHORT_BITS, 0];
    let mut term = sums[0];
    let mut degree = 0;
    while term != 0 {
        degree += 1;
        term = ((term * angle) >> SHORT_BITS) / degree;
        let sum = &mut sums[(degree % 2) as usize];
        if degree % 4 >= 2 {
            *sum -= term;
        } else {
            *sum += term;
        }
    }
    let [cosine, sine] = sums;
    (sine, cosine)
}

#[cfg(test)]
mod tests;
