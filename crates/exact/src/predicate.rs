//! Predicates: signs of integer polynomials, each written once and run through a cascade of tiers.
//!
//! Two cascades, chosen by the widths that the arguments have at run time ([`Class`]):
//!
//! * *bounded*: 128 bits at once where they suffice; else the float filter, then fixed-width integers. No interval step: it
//!   would cost more than the exact one.
//! * *open*: the same filter on the cached floats, then intervals around them, then integers of any size. The filter costs a tenth
//!   of the intervals and decides nearly all; the intervals are tighter where terms cancel, and see zeros.
//!
//! A new predicate is a struct with its arguments and an implementation of [`Predicate`]:
//!
//! ```
//! use exact::predicate::{Class, Predicate, cross, dot, sign};
//! use exact::tier::Tier;
//! use exact::{Sign, Vector3, Width};
//!
//! /// The sign of (a x b) . (c x d), degree 4: on which side the fourth edge turns.
//! struct Turn<'a>([&'a Vector3; 4]);
//!
//! impl Predicate for Turn<'_> {
//!     type Value<T: Tier> = T::D4;
//!     fn eval<T: Tier>(&self) -> T::D4 {
//!         let [a, b, c, d] = self.0.map(T::d1);
//!         dot(cross(a, b), cross(c, d))
//!     }
//!     fn class(&self) -> Class {
//!         if self.0.iter().all(|v| v.width() == Width::Narrow) { Class::Bounded } else { Class::Open }
//!     }
//! }
//!
//! let [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Vector3::from_i64);
//! assert_eq!(sign(&Turn([&x, &y, &y, &x])), Sign::Negative);
//! assert_eq!(sign(&Turn([&x, &y, &y, &z])), Sign::Zero);
//! ```

use crate::filter::Filtered;
use crate::stage::{Stage, count};
use crate::tier::{Big, Boxes, Fixed, Float, Narrow, Ring, Tier};
use crate::{Point3, Sign, Vector3, Width};
use std::ops::Mul;

/// What the widths of the arguments allow; decides which cascade runs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Class {
    /// Every intermediate value stays below 2^127: exact in 128 bits, no filter.
    Narrow,
    /// The arguments keep the bounds of the tier [`Fixed`]: filter, then fixed width.
    Bounded,
    /// Anything else: filter, intervals, big integers.
    Open,
}

/// The sign of a polynomial in integer arguments.
pub trait Predicate {
    /// The type of the polynomial's value: `T::Dk` for degree k.
    type Value<T: Tier>: Ring;

    /// Evaluates the polynomial over the types of a tier.
    fn eval<T: Tier>(&self) -> Self::Value<T>;

    /// Tells which cascade the widths of the arguments allow.
    fn class(&self) -> Class;
}

/// Decides a predicate: the exact sign, from the cheapest tier that can tell.
///
/// # Complexity
/// A few nanoseconds when the filter decides. Else some ten nanoseconds and no allocation for bounded arguments; for open ones an
/// evaluation with intervals, and perhaps one with big integers.
#[inline]
pub fn sign<P: Predicate>(predicate: &P) -> Sign {
    #[cfg(any(test, feature = "force-tiers"))]
    if let Some(sign) = forced(predicate) {
        return sign;
    }
    let class = predicate.class();
    if class == Class::Narrow {
        return exact::<P, Narrow>(predicate, Stage::Narrow);
    }
    // One copy of the filter for both cascades keeps the inlined code small.
    match filtered::<P, Float>(predicate, Stage::Float) {
        Some(sign) => sign,
        None if class == Class::Bounded => bounded(predicate),
        None => open(predicate),
    }
}

/// The cascade of bounded input, after the filter: fixed width. Kept out of line, so that the filter stays small where it is
/// inlined.
#[inline(never)]
fn bounded<P: Predicate>(predicate: &P) -> Sign {
    exact::<P, Fixed>(predicate, Stage::Fixed)
}

/// The cascade of open input, after the filter: intervals, then big integers.
#[inline(never)]
fn open<P: Predicate>(predicate: &P) -> Sign {
    filtered::<P, Boxes>(predicate, Stage::Interval).unwrap_or_else(|| exact::<P, Big>(predicate, Stage::Big))
}

#[inline(always)]
fn filtered<P: Predicate, T: Tier>(predicate: &P, stage: Stage) -> Option<Sign> {
    let verdict = predicate.eval::<T>().verdict();
    if verdict.is_some() {
        count(stage);
    }
    verdict
}

#[inline(always)]
fn exact<P: Predicate, T: Tier>(predicate: &P, stage: Stage) -> Sign {
    filtered::<P, T>(predicate, stage).expect("an exact tier always decides")
}

#[cfg(any(test, feature = "force-tiers"))]
fn forced<P: Predicate>(predicate: &P) -> Option<Sign> {
    use crate::stage::{Start, start};
    let is_open = predicate.class() == Class::Open;
    Some(match start() {
        Start::Usual => return None,
        Start::Float => match filtered::<P, Float>(predicate, Stage::Float) {
            Some(sign) => sign,
            None if is_open => open(predicate),
            None => bounded(predicate),
        },
        Start::Fixed if !is_open => bounded(predicate),
        Start::Interval => open(predicate),
        Start::Fixed | Start::Big => exact::<P, Big>(predicate, Stage::Big),
    })
}

/// The scalar product, for coordinates of any two degrees.
#[inline(always)]
pub fn dot<A: Mul<B>, B>([ax, ay, az]: [A; 3], [bx, by, bz]: [B; 3]) -> A::Output
where
    A::Output: Ring,
{
    ax * bx + ay * by + az * bz
}

/// The vector product, for coordinates of any two degrees.
#[inline(always)]
pub fn cross<A: Mul<B> + Clone, B: Clone>([ax, ay, az]: [A; 3], [bx, by, bz]: [B; 3]) -> [A::Output; 3]
where
    A::Output: Ring,
{
    [ay.clone() * bz.clone() - az.clone() * by.clone(), az * bx.clone() - ax.clone() * bz, ax * by - ay * bx]
}

/// a . b with a of degree 2 (up to double width) and b of degree 1 (narrow).
struct Dot21<'a>(&'a Vector3, &'a Vector3);

impl Predicate for Dot21<'_> {
    type Value<T: Tier> = T::D3;

    #[inline(always)]
    fn eval<T: Tier>(&self) -> T::D3 {
        dot(T::d2(self.0), T::d1(self.1))
    }

    #[inline(always)]
    fn class(&self) -> Class {
        match (self.0.width(), self.1.width()) {
            // 3 * 2^62 * 2^62 < 2^126.
            (Width::Narrow, Width::Narrow) => Class::Narrow,
            (Width::Double, Width::Narrow) => Class::Bounded,
            _ => Class::Open,
        }
    }
}

/// a . b with both of degree 2.
struct Dot22<'a>(&'a Vector3, &'a Vector3);

impl Predicate for Dot22<'_> {
    type Value<T: Tier> = T::D4;

    #[inline(always)]
    fn eval<T: Tier>(&self) -> T::D4 {
        dot(T::d2(self.0), T::d2(self.1))
    }

    #[inline(always)]
    fn class(&self) -> Class {
        if self.0.width() == Width::Wide || self.1.width() == Width::Wide {
            Class::Open
        } else {
            Class::Bounded
        }
    }
}

#[inline(always)]
fn sign_of_dot(a: &Vector3, b: &Vector3) -> Sign {
    if b.width() == Width::Narrow {
        sign(&Dot21(a, b))
    } else if a.width() == Width::Narrow {
        sign(&Dot21(b, a))
    } else {
        sign(&Dot22(a, b))
    }
}

/// det(a, b, c), all of degree 1.
struct Det111<'a>(&'a Vector3, &'a Vector3, &'a Vector3);

impl Predicate for Det111<'_> {
    type Value<T: Tier> = T::D3;

    #[inline(always)]
    fn eval<T: Tier>(&self) -> T::D3 {
        dot(cross(T::d1(self.0), T::d1(self.1)), T::d1(self.2))
    }

    #[inline(always)]
    fn class(&self) -> Class {
        narrow_determinant([self.0, self.1, self.2]).unwrap_or(Class::Open)
    }
}

/// det(a, b, c) with a of degree 1, b and c of degree 2.
struct Det122<'a>(&'a Vector3, &'a Vector3, &'a Vector3);

impl Predicate for Det122<'_> {
    type Value<T: Tier> = T::D5;

    #[inline(always)]
    fn eval<T: Tier>(&self) -> T::D5 {
        dot(cross(T::d2(self.1), T::d2(self.2)), T::d1(self.0))
    }

    #[inline(always)]
    fn class(&self) -> Class {
        if self.0.width() != Width::Narrow {
            return Class::Open;
        }
        narrow_determinant([self.0, self.1, self.2]).unwrap_or_else(|| no_wide([self.1, self.2]))
    }
}

/// det(a, b, c), all of degree 2.
struct Det222<'a>(&'a Vector3, &'a Vector3, &'a Vector3);

impl Predicate for Det222<'_> {
    type Value<T: Tier> = T::D6;

    #[inline(always)]
    fn eval<T: Tier>(&self) -> T::D6 {
        dot(cross(T::d2(self.0), T::d2(self.1)), T::d2(self.2))
    }

    #[inline(always)]
    fn class(&self) -> Class {
        no_wide([self.0, self.1, self.2])
    }
}

/// The class of a determinant of narrow vectors; `None` if one is not narrow.
#[inline(always)]
fn narrow_determinant(vectors: [&Vector3; 3]) -> Option<Class> {
    let [a, b, c] = vectors.map(Vector3::narrow_bits);
    // The sum of 6 products below 2^k is below 2^(k+3).
    Some(if a? + b? + c? + 3 <= 127 { Class::Narrow } else { Class::Bounded })
}

#[inline(always)]
fn no_wide<const N: usize>(vectors: [&Vector3; N]) -> Class {
    if vectors.iter().any(|vector| vector.width() == Width::Wide) { Class::Open } else { Class::Bounded }
}

/// Tells on which side of the great circle with the given normal the direction of an edge lies.
///
/// The sign of normal . edge; `Zero` means on the circle, or that one of the two is the zero vector.
///
/// # Complexity
/// Degree 3 when the normal is the cross product of two edges. Exact in 128 bits at once when both are narrow; filter and fixed
/// width when none is wide.
///
/// ```
/// use exact::{Sign, Vector3, predicate::side_of_circle};
/// let normal = Vector3::from_i64([0, 0, 2]);
/// assert_eq!(side_of_circle(&normal, &Vector3::from_i64([5, 5, -1])), Sign::Negative);
/// ```
#[inline]
pub fn side_of_circle(normal: &Vector3, edge: &Vector3) -> Sign {
    sign_of_dot(normal, edge)
}

/// The cached floats of a vector, apart from it: what [`side_of_floats`] reads.
///
/// An algorithm that asks for the sides of many vectors in no order keeps them in an array of its own, a third as large as the
/// vectors, so that it waits for less memory.
#[derive(Clone, Copy, Debug)]
pub struct Floats3([f64; 3]);

impl Floats3 {
    /// Takes the floats of a vector.
    #[inline]
    pub fn of(vector: &Vector3) -> Self {
        Self(vector.approx_f64())
    }
}

/// The filter of [`side_of_circle`] alone: the exact sign, or `None` where the floats cannot tell; then ask with the vectors.
#[inline]
pub fn side_of_floats(normal: &Floats3, edge: &Floats3) -> Option<Sign> {
    #[cfg(any(test, feature = "force-tiers"))]
    if !matches!(crate::stage::start(), crate::stage::Start::Usual | crate::stage::Start::Float) {
        return None;
    }
    let verdict = dot(normal.0.map(Filtered::of_nearest), edge.0.map(Filtered::of_nearest)).verdict();
    if verdict.is_some() {
        count(Stage::Float);
    }
    verdict
}

/// Tells how three edge vectors are oriented: the sign of their determinant.
///
/// Law: exchanging two arguments turns the sign. `Zero` means that they are linearly dependent.
///
/// # Complexity
/// Degree 3 for edges.
#[inline]
pub fn orientation(a: &Vector3, b: &Vector3, c: &Vector3) -> Sign {
    if [a, b, c].iter().all(|vector| vector.width() == Width::Narrow) {
        sign(&Det111(a, b, c))
    } else {
        sign(&Det222(a, b, c))
    }
}

/// Tells whether two vectors enclose an angle below (`Positive`) or above (`Negative`) a right one: the sign of a . b.
///
/// For parallel vectors this tells whether they point the same way. `Zero`: perpendicular, or one is the zero vector.
///
/// # Complexity
/// Degree 2 for edges, 4 for normals.
#[inline]
pub fn same_direction(a: &Vector3, b: &Vector3) -> Sign {
    sign_of_dot(a, b)
}

/// Tells how two normals follow each other around an axis: the sign of det(axis, a, b).
///
/// `Positive` means that b lies counterclockwise of a, by less than half a turn, seen from the tip of the axis. `Zero`: the same
/// or the opposite half-plane, or an argument that has none.
///
/// # Complexity
/// Degree 5 for an edge and two normals.
#[inline]
pub fn circle_order(axis: &Vector3, a: &Vector3, b: &Vector3) -> Sign {
    if axis.width() == Width::Narrow { sign(&Det122(axis, a, b)) } else { sign(&Det222(axis, a, b)) }
}

/// normal . (p - on) for narrow points of equal weight, whose difference is given.
struct SideOfDifference<'a>(&'a Vector3, [i64; 3]);

impl Predicate for SideOfDifference<'_> {
    type Value<T: Tier> = T::D3;

    #[inline(always)]
    fn eval<T: Tier>(&self) -> T::D3 {
        dot(T::d2(self.0), T::small(&self.1))
    }

    #[inline(always)]
    fn class(&self) -> Class {
        match self.0.width() {
            Width::Narrow => Class::Narrow,
            Width::Double => Class::Bounded,
            Width::Wide => Class::Open,
        }
    }
}

/// normal . (p - on), multiplied by both weights.
struct SideOfPoints<'a>(&'a Vector3, &'a Point3, &'a Point3);

impl Predicate for SideOfPoints<'_> {
    type Value<T: Tier> = T::D4;

    #[inline(always)]
    fn eval<T: Tier>(&self) -> T::D4 {
        let [x, y, z, w] = T::point(self.1);
        let [px, py, pz, pw] = T::point(self.2);
        let difference = [px * w.clone() - x * pw.clone(), py * w.clone() - y * pw.clone(), pz * w - z * pw];
        dot(T::d2(self.0), difference)
    }

    #[inline(always)]
    fn class(&self) -> Class {
        // The difference is below 2 * 2^61 * 2^61: less than a leaf of degree 2.
        let narrow = self.1.as_narrow().is_some() && self.2.as_narrow().is_some();
        if narrow && self.0.width() != Width::Wide { Class::Bounded } else { Class::Open }
    }
}

/// Tells on which side of the plane through `on` with the given normal the point `p` lies.
///
/// The sign of normal . (p - on), whatever the weights: `Positive` on the side to which the normal points, `Zero` in the plane
/// (everywhere if the normal is zero).
///
/// # Complexity
/// Degree 3 for points of equal weight and a normal of degree 2; degree 4 if the weights differ.
///
/// ```
/// use exact::{Point3, Rational, Sign, Vector3, predicate::plane_side};
/// let up = Vector3::from_i64([0, 0, 1]);
/// let third = Point3::from_rationals(&["0".parse()?, "0".parse()?, "1/3".parse()?]);
/// assert_eq!(plane_side(&up, &Point3::from_i64([7, 7, 0]), &third), Sign::Positive);
/// # Ok::<(), exact::ParseNumberError>(())
/// ```
#[inline]
pub fn plane_side(normal: &Vector3, on: &Point3, p: &Point3) -> Sign {
    if let (Some(a), Some(b)) = (on.as_narrow(), p.as_narrow())
        && a[3] == b[3]
    {
        return sign(&SideOfDifference(normal, [b[0] - a[0], b[1] - a[1], b[2] - a[2]]));
    }
    sign(&SideOfPoints(normal, on, p))
}

#[cfg(test)]
mod tests;
