//! Exact linear and affine maps with rational entries.

use crate::predicate::{cross, dot};
use crate::{Integer, Point3, Quaternion, Rational, Sign, Vector3};

/// A linear map: an integer matrix over one positive denominator, in lowest terms.
///
/// ```
/// use exact::{Linear3, Rational, Sign, Vector3};
/// let map = Linear3::scaling(&"-2/3".parse()?);
/// assert_eq!(map.determinant_sign(), Sign::Negative);
/// assert_eq!(map.apply(&Vector3::from_i64([3, 0, 1])), Vector3::from_i64([-6, 0, -2]));
/// # Ok::<(), exact::ParseNumberError>(())
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Linear3 {
    rows: [[Integer; 3]; 3],
    denominator: Integer,
}

impl Linear3 {
    /// Makes the map of a rational matrix, given by rows.
    pub fn from_rationals(rows: &[[Rational; 3]; 3]) -> Self {
        let denominator =
            rows.iter().flatten().fold(Integer::ONE, |common, value| common.lcm(&value.denominator()));
        let numerator = |value: &Rational| value.numerator() * denominator.div_exact(&value.denominator());
        let rows = rows.each_ref().map(|row| row.each_ref().map(numerator));
        Self { rows, denominator }
    }

    /// The denominator must be positive.
    fn reduced(rows: [[Integer; 3]; 3], denominator: Integer) -> Self {
        let divisor = rows.iter().flatten().fold(denominator.clone(), |divisor, value| divisor.gcd(value));
        let rows = rows.map(|row| row.map(|value| value.div_exact(&divisor)));
        Self { rows, denominator: denominator.div_exact(&divisor) }
    }

    /// Gives the map that changes nothing.
    pub fn identity() -> Self {
        Self::scaling(&Rational::ONE)
    }

    /// Gives the map that multiplies by a factor, which may be negative or zero.
    pub fn scaling(factor: &Rational) -> Self {
        let rows = [0, 1, 2].map(|row| {
            [0, 1, 2].map(|column| if row == column { factor.numerator() } else { Integer::ZERO })
        });
        Self { rows, denominator: factor.denominator() }
    }

    /// Gives a rotation about the origin.
    pub fn rotation(quaternion: &Quaternion) -> Self {
        let (rows, denominator) = quaternion.matrix();
        Self::reduced(rows, denominator)
    }

    /// Gives the reflection in the origin: x to -x.
    pub fn reflection() -> Self {
        Self::scaling(&Rational::from(-1))
    }

    /// Gives the map that applies `self` first and `next` then.
    pub fn then(&self, next: &Self) -> Self {
        let column = |index: usize| self.rows.each_ref().map(|row| row[index].clone());
        let rows = next.rows.each_ref().map(|row| [0, 1, 2].map(|index| dot(row.clone(), column(index))));
        Self::reduced(rows, &self.denominator * &next.denominator)
    }

    /// Gives the image of a vector times the denominator of the map: a positive multiple of the image.
    pub fn apply(&self, vector: &Vector3) -> Vector3 {
        Vector3::new(self.rows.each_ref().map(|row| dot(row.clone(), vector.coordinates())))
    }

    /// Gives the entry of a row and a column.
    ///
    /// # Panics
    /// If one of them is not below 3.
    pub fn entry(&self, row: usize, column: usize) -> Rational {
        Rational::new(self.rows[row][column].clone(), self.denominator.clone())
            .expect("the denominator is positive")
    }

    /// Gives the sign of the determinant: negative if the map reverses orientation, zero if it flattens.
    pub fn determinant_sign(&self) -> Sign {
        let [a, b, c] = self.rows.clone();
        dot(cross(a, b), c).sign()
    }
}

/// An affine map: a linear map, then a translation. Exact on every point, and fast on narrow ones.
///
/// ```
/// use exact::{Affine3, Point3, Rational};
/// let shift = Affine3::translation(&["1/2".parse()?, "0".parse()?, "-1".parse()?]);
/// let map = Affine3::scaling(&Rational::from(3)).then(&shift);
/// assert_eq!(map.apply(&Point3::from_i64([1, 2, 3])).to_string(), "(7/2, 6, 8)");
/// # Ok::<(), exact::ParseNumberError>(())
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Affine3 {
    linear: Linear3,
    translation: [Rational; 3],
    /// Rows of the homogeneous matrix, the translation last, over one denominator.
    rows: [[Integer; 4]; 3],
    denominator: Integer,
    /// The same as machine integers, if all are below 2^62 in magnitude.
    machine: Option<([[i64; 4]; 3], i64)>,
}

impl From<Linear3> for Affine3 {
    fn from(linear: Linear3) -> Self {
        Self::new(linear, [Rational::ZERO, Rational::ZERO, Rational::ZERO])
    }
}

impl Affine3 {
    /// Makes the map that applies a linear map and adds a vector.
    pub fn new(linear: Linear3, translation: [Rational; 3]) -> Self {
        let common = translation
            .iter()
            .fold(linear.denominator.clone(), |common, value| common.lcm(&value.denominator()));
        let factor = common.div_exact(&linear.denominator);
        let rows = [0, 1, 2].map(|row: usize| {
            let [a, b, c] = linear.rows[row].each_ref().map(|value| value * &factor);
            let last = &translation[row];
            [a, b, c, last.numerator() * common.div_exact(&last.denominator())]
        });
        let small = |value: &Integer| value.to_i64().filter(|value| value.unsigned_abs() >> 62 == 0);
        let machine = || {
            let mut machine = [[0; 4]; 3];
            for (to, from) in machine.iter_mut().flatten().zip(rows.iter().flatten()) {
                *to = small(from)?;
            }
            Some((machine, small(&common)?))
        };
        let machine = machine();
        Self { linear, translation, rows, denominator: common, machine }
    }

    /// Gives the map that changes nothing.
    pub fn identity() -> Self {
        Linear3::identity().into()
    }

    /// Gives the map that multiplies by a factor, which may be negative or zero.
    pub fn scaling(factor: &Rational) -> Self {
        Linear3::scaling(factor).into()
    }

    /// Gives a rotation about the origin.
    pub fn rotation(quaternion: &Quaternion) -> Self {
        Linear3::rotation(quaternion).into()
    }

    /// Gives the reflection in the origin: x to -x.
    pub fn reflection() -> Self {
        Linear3::reflection().into()
    }

    /// Gives the map that adds a vector.
    pub fn translation(vector: &[Rational; 3]) -> Self {
        Self::new(Linear3::identity(), vector.clone())
    }

    /// Gives the linear part.
    pub fn linear(&self) -> &Linear3 {
        &self.linear
    }

    /// Gives the map that applies `self` first and `next` then.
    pub fn then(&self, next: &Self) -> Self {
        let translation = [0, 1, 2].map(|row: usize| {
            let moved: Rational =
                (0..3).map(|column| next.linear.entry(row, column) * &self.translation[column]).sum();
            moved + &next.translation[row]
        });
        Self::new(self.linear.then(&next.linear), translation)
    }

    /// Gives the image of a point.
    ///
    /// Narrow images of points of equal weight have equal weights again; others are canonical.
    pub fn apply(&self, point: &Point3) -> Point3 {
        if let (Some((rows, denominator)), Some(point)) = (&self.machine, point.as_narrow()) {
            let point = point.map(i128::from);
            // |sum| < 4 * 2^62 * 2^61 = 2^125.
            let image = |row: &[i64; 4]| -> i128 { (0..4).map(|i| i128::from(row[i]) * point[i]).sum() };
            let [x, y, z] = rows.each_ref().map(image);
            let image = [x, y, z, i128::from(*denominator) * point[3]];
            return if Point3::fits_narrow(&image) {
                Point3::of_i128(image)
            } else {
                Point3::reduced_i128(image)
            };
        }
        let from = point.homogeneous();
        let image = |row: &[Integer; 4]| -> Integer { (0..4).map(|i| &row[i] * &from[i]).sum() };
        let [x, y, z] = self.rows.each_ref().map(image);
        Point3::of_homogeneous([x, y, z, &self.denominator * &from[3]]).canonical()
    }

    /// Gives the sign of the determinant: negative if the map reverses orientation, zero if it flattens.
    pub fn determinant_sign(&self) -> Sign {
        self.linear.determinant_sign()
    }
}

#[cfg(test)]
mod tests;
