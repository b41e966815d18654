//! Points made of floats.

use super::ApproxTraits;

/// Points that can be put near given parameters: for places from which to start, wherever they are exactly.
///
/// Landmarks of a grid, or at random, are such points.
pub trait LandmarkTraits: ApproxTraits {
    /// Makes a point of the surface near parameters u and v; `None` if there is none, or none that is cheap.
    ///
    /// Laws:
    /// 1. What is given is a point as the traits know it: where sides are identified, it has the coordinates of its home, and on an open
    ///    or contracted side it does not lie.
    /// 2. Parameters that are not finite give `None`.
    ///
    /// Nothing is promised about the distance. But if [`approx_point`](ApproxTraits::approx_point) is far from what was asked, the point
    /// is of little use.
    fn approx_to_point(&self, parameters: [f64; 2]) -> Option<Self::Point>;
}
