//! Cosine and sine, the same on every machine: by the four operations only, because those of platforms differ in the last bits.

use std::f64::consts::TAU;

/// Cosine and sine of a number of turns, by their series. They are exact at quarters.
pub(crate) fn cos_sin_turns(turns: f64) -> (f64, f64) {
    let turns = turns - turns.floor();
    let quarter = (turns * 4.0).floor();
    let angle = (turns - quarter / 4.0) * TAU;
    let (mut cos, mut sin, mut term) = (0.0, 0.0, 1.0);
    for k in 0..24_u32 {
        match k % 4 {
            0 => cos += term,
            1 => sin += term,
            2 => cos -= term,
            _ => sin -= term,
        }
        term = term * angle / f64::from(k + 1);
    }
    // Just below zero, turns are rounded to a whole one.
    match quarter as u8 % 4 {
        0 => (cos, sin),
        1 => (-sin, cos),
        2 => (-cos, -sin),
        _ => (sin, -cos),
    }
}

/// Cosine and sine of an angle in radians.
pub(crate) fn cos_sin(angle: f64) -> (f64, f64) {
    cos_sin_turns(angle / TAU)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn they_are_those_of_mathematics() {
        for k in -2000..2000 {
            let angle = f64::from(k) / 1000.0 * TAU;
            let (cos, sin) = cos_sin(angle);
            assert!((cos - angle.cos()).abs() < 1e-14 && (sin - angle.sin()).abs() < 1e-14, "{angle}");
        }
        assert!((cos_sin(-1e-300).0 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn quarters_are_exact() {
        let rows = [
            (0.0, [1.0, 0.0]),
            (FRAC_PI_2, [0.0, 1.0]),
            (PI, [-1.0, 0.0]),
            (-FRAC_PI_2, [0.0, -1.0]),
            (TAU, [1.0, 0.0]),
        ];
        for (angle, [cos, sin]) in rows {
            assert_eq!(cos_sin(angle), (cos, sin), "{angle}");
        }
    }
}
