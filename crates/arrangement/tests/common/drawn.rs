//! Points and curves drawn at random, of small coordinates, so that everything degenerate happens.

use exact::planar::Point2;
use splitstar_arrangement::models::Linear;
use testkit::Rng;

/// A point of the grid whose coordinates are at least zero and below the size.
pub(crate) fn grid_point(rng: &mut Rng, size: u64) -> Point2 {
    Point2::from_i64([(); 2].map(|()| rng.below(size) as i64))
}

/// A line, a ray or a segment, each as likely; `None` if the points are the same.
pub(crate) fn linear(rng: &mut Rng, [p, q]: [Point2; 2]) -> Option<Linear> {
    match rng.below(3) {
        0 => Linear::line(&p, &q),
        1 => Linear::ray(p, &q),
        _ => Linear::segment(p, q),
    }
}
