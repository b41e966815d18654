//! Angles by floats, for pictures.

use std::f64::consts::{FRAC_PI_2, PI};

/// Gives a float near to the angle from the x-axis to the vector (x, y), counterclockwise, between -pi and pi, in radians; 0 for the zero
/// vector.
///
/// It is made of the four operations and square roots only, so it is the same on every machine, as the arc tangent of a platform need not
/// be. Multiples of a quarter turn are as exact as can be.
///
/// ```
/// use exact::spherical::approx_angle;
/// assert_eq!(approx_angle([0.0, 2.0]), std::f64::consts::FRAC_PI_2);
/// assert!((approx_angle([-1.0, -3.0]) - (-3.0_f64).atan2(-1.0)).abs() < 1e-14);
/// ```
pub fn approx_angle([x, y]: [f64; 2]) -> f64 {
    let (low, high) = (x.abs().min(y.abs()), x.abs().max(y.abs()));
    let mut tangent = if high > 0.0 { low / high } else { 0.0 };
    // Two halvings of the angle: the tangent is below 0.2 then, and few terms of the series do.
    for _ in 0..2 {
        tangent /= 1.0 + (1.0 + tangent * tangent).sqrt();
    }
    let square = tangent * tangent;
    let series = (0..14_u32).rev().fold(0.0, |sum, k| 1.0 / f64::from(2 * k + 1) - square * sum);
    let acute = 4.0 * tangent * series;
    let quarter = if y.abs() > x.abs() { FRAC_PI_2 - acute } else { acute };
    let half = if x < 0.0 { PI - quarter } else { quarter };
    if y < 0.0 { -half } else { half }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_arc_tangent() {
        for i in -40..=40 {
            for j in -40..=40 {
                let [x, y] = [i, j].map(|k| f64::from(k) / 7.0);
                let error = (approx_angle([x, y]) - y.atan2(x)).abs();
                assert!(error < 4e-15, "{x} {y}: {error}");
            }
        }
        for exponent in -300..300 {
            let y = 2.0_f64.powi(exponent);
            assert!((approx_angle([1.0, y]) / y.atan2(1.0) - 1.0).abs() < 4e-15, "{exponent}");
        }
    }
}
