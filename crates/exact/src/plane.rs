//! Oriented planes.

use crate::predicate::dot;
use crate::{Integer, Point3, Rational, Sign, Vector3};
use std::fmt;

/// The oriented plane of the points p with normal . p = offset. The normal is primitive, so equal planes are identical.
///
/// ```
/// use exact::{Plane, Point3, Sign};
/// let [a, b, c] = [[2, 0, 0], [0, 2, 0], [0, 0, 2]].map(Point3::from_i64);
/// let plane = Plane::through(&a, &b, &c).expect("the points are not collinear");
/// assert_eq!(plane.to_string(), "(1, 1, 1) . p = 2");
/// assert_eq!(plane.side(&Point3::from_i64([1, 1, 1])), Sign::Positive);
/// ```
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Plane {
    /// Primitive; positive is the side to which it points.
    pub normal: Vector3,
    /// The value of normal . p on the plane.
    pub offset: Rational,
}

impl Plane {
    /// Makes the plane with a given direction of the normal through a point; `None` if the normal is zero.
    pub fn new(normal: &Vector3, on: &Point3) -> Option<Self> {
        if normal.is_zero() {
            return None;
        }
        let normal = normal.primitive();
        let numerator = dot(normal.coordinates(), [0, 1, 2].map(|axis| on.numerator(axis)));
        let offset = Rational::new(numerator, on.weight()).expect("a weight is positive");
        Some(Self { normal, offset })
    }

    /// Makes the plane through three points, which go counterclockwise seen from the positive side; `None` if they are
    /// collinear.
    pub fn through(a: &Point3, b: &Point3, c: &Point3) -> Option<Self> {
        Self::new(&a.direction_to(b).cross(&a.direction_to(c)), a)
    }

    /// Tells on which side of the plane a point lies: the sign of normal . p - offset.
    ///
    /// For many points of one mesh, [`plane_side`](crate::predicate::plane_side) with a point of the plane is faster.
    pub fn side(&self, p: &Point3) -> Sign {
        let (numerator, weight) = (self.numerator(p), p.weight());
        (numerator * self.offset.denominator() - self.offset.numerator() * weight).sign()
    }

    /// Gives normal . p - offset: proportional to the distance from the plane, with its sign.
    pub fn height(&self, p: &Point3) -> Rational {
        Rational::new(self.numerator(p), p.weight()).expect("a weight is positive") - &self.offset
    }

    /// normal . p, times the weight of p.
    fn numerator(&self, p: &Point3) -> Integer {
        dot(self.normal.coordinates(), [0, 1, 2].map(|axis| p.numerator(axis)))
    }

    /// Gives the same plane with the other orientation.
    pub fn opposite(&self) -> Self {
        Self { normal: -&self.normal, offset: -&self.offset }
    }
}

impl fmt::Display for Plane {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} . p = {}", self.normal, self.offset)
    }
}

#[cfg(test)]
mod tests;
