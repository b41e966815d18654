//! Points to doubles.

use crate::base::numerals::{Rounding, TooLarge};
use exact::{Point3, Rational};

/// Rounds the coordinates of a point to the nearest doubles, and keeps the largest rounding. Zero, and what
/// rounds to it, has no sign.
pub(super) fn nearest_doubles(point: &Point3, rounding: &mut Rounding) -> Result<[f64; 3], TooLarge> {
    let doubles = point.approx_f64().map(|double| double + 0.0);
    if doubles.iter().any(|double| !double.is_finite()) {
        return Err(TooLarge);
    }
    if !is_exact(point) {
        for (axis, &double) in doubles.iter().enumerate() {
            let coordinate = point.coordinate(axis);
            let written = Rational::try_from(double).expect("the double is finite");
            if written != coordinate {
                rounding.raise((&written - &coordinate).abs());
            }
        }
    }
    Ok(doubles)
}

/// Whether all coordinates are doubles, as far as machine words tell: numerators over a power of two, each
/// with at most 53 binary digits between its first one and its last. Their exponents lie between -61 and 61.
fn is_exact(point: &Point3) -> bool {
    let Some(&[x, y, z, weight]) = point.as_narrow() else { return false };
    let fits = |value: i64| {
        let magnitude = value.unsigned_abs();
        value == 0 || magnitude >> magnitude.trailing_zeros() < 1 << 53
    };
    weight & (weight - 1) == 0 && fits(x) && fits(y) && fits(z)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rounded(coordinates: [&str; 3]) -> (Option<[f64; 3]>, String) {
        let point = Point3::from_rationals(&coordinates.map(|text| text.parse().unwrap()));
        let mut rounding = Rounding::none();
        let doubles = nearest_doubles(&point, &mut rounding).ok();
        (doubles, rounding.0.to_string())
    }

    #[test]
    fn points_know_what_they_lose() {
        let exact = |doubles: [f64; 3]| (Some(doubles), "0".to_string());
        assert_eq!(rounded(["0", "-3", "9007199254740992"]), exact([0.0, -3.0, 9_007_199_254_740_992.0]));
        assert_eq!(rounded(["1/2", "-1/1152921504606846976", "1e3"]), exact([0.5, -0.5_f64.powi(60), 1e3]));
        // 2^60 and 2^80: not narrow, but doubles.
        assert_eq!(
            rounded(["1152921504606846976", "1208925819614629174706176", "0"]),
            exact([2_f64.powi(60), 2_f64.powi(80), 0.0])
        );
        assert_eq!(rounded(["9007199254740993", "0", "1/2"]).1, "1");
        assert_eq!(rounded(["1/3", "0", "0"]), (Some([1.0 / 3.0, 0.0, 0.0]), "1/54043195528445952".into()));
        assert_eq!(rounded(["0", "1e309", "0"]).0, None);
        let tiny = rounded(["0", "-1e-400", "0"]).0.unwrap();
        assert_eq!(tiny[1].to_bits(), 0);
    }

    #[test]
    fn doubles_come_back() {
        for doubles in [[0.1, -0.0, 1e300], [5e-324, -1.5, f64::MAX], [3.0, 2.0, -7.0], [0.1, 1.0, 8.0]] {
            let point = Point3::from_f64s(doubles).unwrap();
            let mut rounding = Rounding::none();
            assert_eq!(
                nearest_doubles(&point, &mut rounding).unwrap().map(f64::to_bits),
                doubles.map(|double| (double + 0.0).to_bits())
            );
            assert!(rounding.0.is_zero());
        }
    }
}
