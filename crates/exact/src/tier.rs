//! The tiers at which a predicate can be evaluated, and the types that each tier has for every degree.
//!
//! A predicate is written once, over the types of a [`Tier`]: `D1` holds expressions of degree 1 in the input edges, `D2`
//! those of degree 2 (and the coordinates of normals), and so on; a product of `Di` and `Dj` is a `D(i+j)`. Five tiers:
//!
//! | tier | all of `D1` to `D6` | decides | used for |
//! |---|---|---|---|
//! | [`Narrow`] | 128 bits | always | widths that allow it, known at run time |
//! | [`Float`] | [`Filtered`] | when far enough from zero | all wider input |
//! | [`Fixed`] | 64, 128, 192, 256, 320, 384 bits | always | bounded input |
//! | [`Boxes`] | [`Interval`] | when zero is outside, or exact | open input |
//! | [`Big`] | [`Integer`] | always | open input |
//!
//! Bounds of the tier [`Fixed`]: the leaves of `D1` are below 2^62, those of `D2` below 2^126. Then a product of degree d is below
//! 2^(64 d - 4), and the sum of eight of them, or of two leaves, fits the type (in a product of sums count all terms that
//! arise when it is multiplied out; the determinant of three vectors has 6). Debug builds check every sum.

use crate::filter::Filtered;
use crate::fixed;
use crate::interval::Interval;
use crate::{Integer, Point3, Sign, Vector3};
use std::ops::{Add, Mul, Neg, Sub};

pub use crate::stage::Stage;
#[cfg(any(test, feature = "count-tiers"))]
pub use crate::stage::{Counts, counts, thread_counts};
#[cfg(any(test, feature = "force-tiers"))]
pub use crate::stage::{Guard, Start, force};

/// A number as a tier sees it: it can be added, subtracted and negated, and may know its sign.
pub trait Ring: Clone + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> {
    /// Gives the sign of the exact value, or `None` if this tier cannot tell.
    fn verdict(&self) -> Option<Sign>;
}

/// One way to evaluate predicates: a type for each degree, and how the coordinates of the arguments are read.
pub trait Tier {
    /// Degree 1: coordinates of edges.
    type D1: Ring + Mul<Self::D1, Output = Self::D2> + Mul<Self::D2, Output = Self::D3>;
    /// Degree 2: coordinates of normals.
    type D2: Ring + Mul<Self::D1, Output = Self::D3> + Mul<Self::D2, Output = Self::D4>;
    /// Degree 3.
    type D3: Ring
        + Mul<Self::D1, Output = Self::D4>
        + Mul<Self::D2, Output = Self::D5>
        + Mul<Self::D3, Output = Self::D6>;
    /// Degree 4.
    type D4: Ring + Mul<Self::D1, Output = Self::D5> + Mul<Self::D2, Output = Self::D6>;
    /// Degree 5.
    type D5: Ring + Mul<Self::D1, Output = Self::D6>;
    /// Degree 6.
    type D6: Ring;

    /// Reads machine integers below 2^62 in magnitude.
    fn small(values: &[i64; 3]) -> [Self::D1; 3];

    /// Reads the coordinates of an edge.
    ///
    /// # Panics
    /// In the tiers `Narrow` and `Fixed`, if the vector is not of width `Narrow`.
    fn d1(vector: &Vector3) -> [Self::D1; 3];

    /// Reads the coordinates of a normal.
    ///
    /// # Panics
    /// In the tier `Fixed`, if the vector is of width `Wide`; in the tier `Narrow`, if it is not of width `Narrow`.
    fn d2(vector: &Vector3) -> [Self::D2; 3];

    /// Reads the homogeneous coordinates x, y, z, w of a point.
    ///
    /// # Panics
    /// In the tiers `Narrow` and `Fixed`, if the point is not narrow.
    fn point(point: &Point3) -> [Self::D1; 4];
}

const NARROW: &str = "only predicates with narrow arguments are of a class that comes here";
const DOUBLE: &str = "only predicates without wide arguments are of a class that comes here";

/// 128 bits for everything.
#[derive(Clone, Copy, Debug)]
pub enum Narrow {}

/// The semi-static float filter.
#[derive(Clone, Copy, Debug)]
pub enum Float {}

/// Fixed-width integers that grow with the degree.
#[derive(Clone, Copy, Debug)]
pub enum Fixed {}

/// Intervals around the cached floats.
#[derive(Clone, Copy, Debug)]
pub enum Boxes {}

/// Integers of any size.
#[derive(Clone, Copy, Debug)]
pub enum Big {}

/// A number of the tier [`Narrow`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Small(i128);

impl Add for Small {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Small {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Small {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Neg for Small {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Ring for Small {
    #[inline(always)]
    fn verdict(&self) -> Option<Sign> {
        Some(Sign::of_i128(self.0))
    }
}

impl Tier for Narrow {
    type D1 = Small;
    type D2 = Small;
    type D3 = Small;
    type D4 = Small;
    type D5 = Small;
    type D6 = Small;

    #[inline(always)]
    fn small(values: &[i64; 3]) -> [Small; 3] {
        values.map(|value| Small(i128::from(value)))
    }

    #[inline(always)]
    fn d1(vector: &Vector3) -> [Small; 3] {
        Self::small(vector.as_narrow().expect(NARROW))
    }

    #[inline(always)]
    fn d2(vector: &Vector3) -> [Small; 3] {
        Self::d1(vector)
    }

    #[inline(always)]
    fn point(point: &Point3) -> [Small; 4] {
        point.as_narrow().expect(NARROW).map(|value| Small(i128::from(value)))
    }
}

impl Tier for Float {
    type D1 = Filtered;
    type D2 = Filtered;
    type D3 = Filtered;
    type D4 = Filtered;
    type D5 = Filtered;
    type D6 = Filtered;

    #[inline(always)]
    fn small(values: &[i64; 3]) -> [Filtered; 3] {
        values.map(|value| Filtered::of_nearest(value as f64))
    }

    #[inline(always)]
    fn d1(vector: &Vector3) -> [Filtered; 3] {
        vector.approx_f64().map(Filtered::of_nearest)
    }

    #[inline(always)]
    fn d2(vector: &Vector3) -> [Filtered; 3] {
        Self::d1(vector)
    }

    #[inline(always)]
    fn point(point: &Point3) -> [Filtered; 4] {
        point.approx_homogeneous().map(Filtered::of_nearest)
    }
}

impl Tier for Fixed {
    type D1 = fixed::Fixed<1>;
    type D2 = fixed::Fixed<2>;
    type D3 = fixed::Fixed<3>;
    type D4 = fixed::Fixed<4>;
    type D5 = fixed::Fixed<5>;
    type D6 = fixed::Fixed<6>;

    #[inline(always)]
    fn small(values: &[i64; 3]) -> [Self::D1; 3] {
        values.map(fixed::Fixed::from)
    }

    #[inline(always)]
    fn d1(vector: &Vector3) -> [Self::D1; 3] {
        Self::small(vector.as_narrow().expect(NARROW))
    }

    #[inline(always)]
    fn d2(vector: &Vector3) -> [Self::D2; 3] {
        vector.to_double().expect(DOUBLE)
    }

    #[inline(always)]
    fn point(point: &Point3) -> [Self::D1; 4] {
        point.as_narrow().expect(NARROW).map(fixed::Fixed::from)
    }
}

impl Tier for Boxes {
    type D1 = Interval;
    type D2 = Interval;
    type D3 = Interval;
    type D4 = Interval;
    type D5 = Interval;
    type D6 = Interval;

    #[inline]
    fn small(values: &[i64; 3]) -> [Interval; 3] {
        values.map(|value| Interval::of_nearest(value as f64))
    }

    #[inline]
    fn d1(vector: &Vector3) -> [Interval; 3] {
        vector.approx_f64().map(Interval::of_nearest)
    }

    #[inline]
    fn d2(vector: &Vector3) -> [Interval; 3] {
        Self::d1(vector)
    }

    #[inline]
    fn point(point: &Point3) -> [Interval; 4] {
        point.approx_homogeneous().map(Interval::of_nearest)
    }
}

impl Tier for Big {
    type D1 = Integer;
    type D2 = Integer;
    type D3 = Integer;
    type D4 = Integer;
    type D5 = Integer;
    type D6 = Integer;

    fn small(values: &[i64; 3]) -> [Integer; 3] {
        values.map(Integer::from)
    }

    fn d1(vector: &Vector3) -> [Integer; 3] {
        vector.coordinates()
    }

    fn d2(vector: &Vector3) -> [Integer; 3] {
        vector.coordinates()
    }

    fn point(point: &Point3) -> [Integer; 4] {
        point.homogeneous()
    }
}
