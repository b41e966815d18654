//! Exact affine maps.

use crate::Rng;
use exact::{Affine3, Integer, Quaternion, Rational};

/// The rotation of an integer quaternion.
///
/// # Panics
/// If all components are zero.
pub fn quaternion(components: [i64; 4]) -> Quaternion {
    Quaternion::new(components.map(Integer::from)).expect("a quaternion is not zero")
}

/// The same as a map.
///
/// # Panics
/// If all components are zero.
pub fn rotation(components: [i64; 4]) -> Affine3 {
    Affine3::rotation(&quaternion(components))
}

/// A random exact rotation with quaternion components from `-range` to `range`; once in four times one
/// that maps the axes to axes.
pub fn random_rotation(rng: &mut Rng, range: i64) -> Affine3 {
    const TURNS: [[i64; 4]; 6] =
        [[1, 1, 0, 0], [1, 0, 1, 0], [1, 0, 0, 1], [0, 1, 0, 0], [1, 1, 1, 1], [0, 1, 1, 0]];
    if rng.one_in(4) {
        return rotation(*rng.choose(&TURNS));
    }
    loop {
        let components = [0; 4].map(|_: i64| rng.within(range));
        if components != [0; 4] {
            return rotation(components);
        }
    }
}

/// The scaling by a fraction.
///
/// # Panics
/// If `denominator` is zero.
pub fn scaling(numerator: i64, denominator: i64) -> Affine3 {
    let factor = Rational::new(numerator.into(), denominator.into());
    Affine3::scaling(&factor.expect("a denominator is not zero"))
}

/// The translation by a vector of fractions over one denominator.
///
/// # Panics
/// If `denominator` is zero.
pub fn translation(numerators: [i64; 3], denominator: i64) -> Affine3 {
    let vector =
        numerators.map(|n| Rational::new(n.into(), denominator.into()).expect("a denominator is not zero"));
    Affine3::translation(&vector)
}
