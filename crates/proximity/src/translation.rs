//! How far the second polytope is moved.

use exact::proximity::QueryPoint;
use exact::{Point3, Rational};

/// A vector of rationals by which Q is moved, relative to P.
///
/// ```
/// use exact::Rational;
/// use splitstar_proximity::Translation;
/// let half = Translation::from_f64([0.5, 0.0, -2.0]).expect("the numbers are finite");
/// assert_eq!(half.coordinates().map(|c| c.to_string()), ["1/2", "0", "-2"]);
/// assert!(Translation::from_f64([f64::NAN, 0.0, 0.0]).is_none());
/// ```
#[derive(Clone, Debug)]
pub struct Translation(pub(crate) QueryPoint);

impl Translation {
    /// Makes the translation by a vector of rationals.
    pub fn new(coordinates: &[Rational; 3]) -> Self {
        Self(QueryPoint::new(Point3::from_rationals(coordinates)))
    }

    /// Makes the translation by a vector of integers.
    pub fn from_i64(coordinates: [i64; 3]) -> Self {
        Self(QueryPoint::new(Point3::from_i64(coordinates)))
    }

    /// Makes the translation by a vector of floats, each the dyadic rational that it is; `None` if one is not finite.
    #[inline]
    // tidy: pub f64, because a float comes in through an exact conversion
    pub fn from_f64(coordinates: [f64; 3]) -> Option<Self> {
        QueryPoint::from_f64(coordinates).map(Self)
    }

    /// Gives the exact coordinates.
    pub fn coordinates(&self) -> [Rational; 3] {
        self.0.point().coordinates()
    }

    pub(crate) fn point(&self) -> &Point3 {
        self.0.point()
    }
}
