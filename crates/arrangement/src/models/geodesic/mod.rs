//! Geodesic arcs on the sphere.
//!
//! | traits | point | u-monotone curve | curve | refinements |
//! |---|---|---|---|---|
//! | [`GeodesicTraits`] | [`Direction`] | [`GeodesicArc`] | [`Geodesic`] | identified left to right; contracted bottom and top |
//!
//! | file | role |
//! |---|---|
//! | `curve` | arcs of great circles, whole great circles and points, as a user gives them |
//! | `cut` | how they are cut at the identification and at the poles |
//! | `arc` | the pieces: u-monotone arcs |
//! | `meet` | intersections, and what a sweep asks |
//! | `boundary` | ends on sides of the parameter space |
//! | `reflect` | arrangements reflected through the center |
//! | `approx` | floats, for pictures and landmarks |
//! | this one | the traits and their predicates |
//!
//! The parameter u is the longitude, counted counterclockwise seen from the north, from the *identification*: a half great circle from the south to
//! the north pole, through (-1, 0, 0) if nothing else is said. v is the latitude. So left and right side are identified, bottom and top are contracted to
//! the poles (0, 0, -1) and (0, 0, 1). A curve along the identification belongs to the left side.
//!
//! Every arc keeps its circle, oriented to the right, or upwards if it is a meridian. So what is on the positive side of the circle is above a
//! curve that is not vertical, everywhere on the sphere: a point of the identification is compared with an arc that comes to it from the left as with one
//! that comes from the right.
//!
//! # References
//! Thesis, section 2.6.

mod approx;
mod arc;
mod boundary;
mod curve;
mod cut;
mod meet;
mod reflect;
#[cfg(test)]
mod tests;

pub use arc::GeodesicArc;
pub use curve::{Geodesic, GeodesicError};

use crate::traits::{Along, BasicTraits, CurveEnd, DirectionalTraits};
use exact::spherical::{
    Direction, Meridian, compare_height, crossing_side, rises_at, side_of_circle, side_of_key,
};
use exact::{Integer, Sign};
use std::cmp::Ordering;

/// Traits of geodesic arcs on the sphere, with an identification that can be chosen when the program runs.
///
/// Curves as users give them, and points, know nothing of the identification; the arcs into which the curves are cut do.
///
/// ```
/// use exact::spherical::Direction;
/// use splitstar_arrangement::models::{Geodesic, GeodesicTraits};
/// use splitstar_arrangement::traits::ArrangementTraits;
/// let [p, q] = [[-1, -1, 0], [-1, 1, 1]].map(|p| Direction::from_i64(p).expect("not zero"));
/// let arc = Geodesic::arc(p, q)?;
/// // The shorter way crosses the identification, which is at -x.
/// let mut pieces = Vec::new();
/// GeodesicTraits::new().make_u_monotone(&arc, &mut pieces);
/// assert_eq!(pieces.len(), 2);
/// let other = GeodesicTraits::with_identification([0.into(), (-1).into()]).expect("not zero");
/// pieces.clear();
/// other.make_u_monotone(&arc, &mut pieces);
/// assert_eq!(pieces.len(), 1);
/// # Ok::<(), splitstar_arrangement::models::GeodesicError>(())
/// ```
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct GeodesicTraits {
    meridian: Meridian,
}

impl GeodesicTraits {
    /// The identification passes through (-1, 0, 0).
    pub fn new() -> Self {
        Self::default()
    }

    /// The identification passes through the direction (x, y, 0); `None` if that is zero.
    pub fn with_identification(horizontal: [Integer; 2]) -> Option<Self> {
        Some(Self { meridian: Meridian::new(horizontal)? })
    }

    /// The point of the identification on the equator.
    #[inline]
    pub fn identification(&self) -> &Direction {
        self.meridian.direction()
    }

    /// The identification.
    #[inline]
    pub fn meridian(&self) -> &Meridian {
        &self.meridian
    }

    /// Tells whether a point lies neither on the identification nor on a pole.
    #[inline]
    pub(in crate::models) fn is_interior(&self, p: &Direction) -> bool {
        p.pole_sign().is_zero() && !self.meridian.contains(p)
    }

    /// Tells whether a point of the circle of a curve, which is no meridian, lies between its ends.
    fn is_within(&self, p: &Direction, curve: &GeodesicArc) -> bool {
        let [starts_left, ends_right] = curve.ends_on_sides();
        if self.meridian.contains(p) {
            return starts_left || ends_right;
        }
        (starts_left || self.meridian.compare_u(curve.end(CurveEnd::Min), p).is_le())
            && (ends_right || self.meridian.compare_u(p, curve.end(CurveEnd::Max)).is_le())
    }
}

impl BasicTraits for GeodesicTraits {
    type Point = Direction;
    type UMonotoneCurve = GeodesicArc;

    // Two great circles cross twice.
    const MEET_ONCE: bool = false;
    const OVERLAPS_ARE_PLAIN: bool = true;

    /// Points of the identification are before all others but the south pole, which is before all; the north pole is after all.
    #[inline]
    fn compare_u(&self, p: &Direction, q: &Direction) -> Ordering {
        self.meridian.compare_u(p, q)
    }

    /// Points of the identification are before all others but the south pole, which is before all; the north pole is after all.
    #[inline]
    fn compare_uv(&self, p: &Direction, q: &Direction) -> Ordering {
        self.meridian.compare_uv(p, q)
    }

    #[inline]
    fn order_key(&self, p: &Direction) -> u64 {
        self.meridian.order_key(p)
    }

    #[inline]
    fn order_range(&self, p: &Direction) -> (u64, u32) {
        self.meridian.order_range(p)
    }

    #[inline]
    fn side_key(&self, curve: &GeodesicArc) -> [u32; 3] {
        // What is beside a vertical arc is told by its ends.
        if curve.is_meridian() { [0; 3] } else { curve.circle().side_key() }
    }

    #[inline]
    fn compare_v_at_u_by_key(&self, p: &Direction, key: &[u32; 3]) -> Option<Ordering> {
        side_of_key(p, key).map(Sign::ordering)
    }

    /// The arc was cut at this identification.
    fn is_own_curve(&self, curve: &GeodesicArc) -> bool {
        let is_located = CurveEnd::BOTH.into_iter().all(|end| {
            let location = curve.location(end);
            let is_on = self.meridian.contains(curve.end(end));
            match location.v {
                Along::Inside => {
                    let side =
                        if curve.is_meridian() || end == CurveEnd::Min { Along::Low } else { Along::High };
                    location.u == if is_on { side } else { Along::Inside }
                }
                // At a pole, the whole half meridian is on the identification, or is not.
                _ => {
                    let is_along = curve.circle() == self.meridian.circle();
                    location.u == if is_along { Along::Low } else { Along::Inside }
                }
            }
        });
        let [starts_left, ends_right] = curve.ends_on_sides();
        is_located
            && (curve.is_meridian()
                || starts_left
                || ends_right
                || self.compare_u(curve.end(CurveEnd::Min), curve.end(CurveEnd::Max)).is_lt())
    }

    #[inline]
    fn end_point<'a>(&self, curve: &'a GeodesicArc, end: CurveEnd) -> Option<&'a Direction> {
        Some(curve.end(end))
    }

    #[inline]
    fn is_vertical(&self, curve: &GeodesicArc) -> bool {
        curve.is_meridian()
    }

    /// Answers for points of the identification and for the poles as for others.
    #[inline]
    fn compare_v_at_u(&self, p: &Direction, curve: &GeodesicArc) -> Ordering {
        if curve.is_meridian() {
            compare_with_ends(p, curve)
        } else {
            side_of_circle(p, curve.circle()).ordering()
        }
    }

    #[inline]
    fn compare_v_at_u_right(&self, a: &GeodesicArc, b: &GeodesicArc, p: &Direction) -> Ordering {
        // Where a goes over to the right side of b, it is below.
        crossing_side(a.circle(), b.circle(), p).ordering().reverse()
    }

    #[inline]
    fn compare_v_at_u_left(&self, a: &GeodesicArc, b: &GeodesicArc, p: &Direction) -> Ordering {
        crossing_side(a.circle(), b.circle(), p).ordering()
    }

    #[inline]
    fn is_same_point(&self, p: &Direction, q: &Direction) -> bool {
        p == q
    }

    fn is_in_u_range(&self, p: &Direction, curve: &GeodesicArc) -> bool {
        match p.pole_sign() {
            Sign::Negative => return curve.location(CurveEnd::Min).v == Along::Low,
            Sign::Positive => return curve.location(CurveEnd::Max).v == Along::High,
            Sign::Zero => {}
        }
        if curve.is_meridian() {
            return side_of_circle(p, curve.circle()).is_zero() && rises_at(p, curve.circle()).is_positive();
        }
        self.is_within(p, curve)
    }

    fn is_on_curve(&self, p: &Direction, curve: &GeodesicArc) -> bool {
        side_of_circle(p, curve.circle()).is_zero()
            && self.is_in_u_range(p, curve)
            && (!curve.is_meridian() || compare_with_ends(p, curve).is_eq())
    }
}

/// Compares the height of a point with a piece of its half meridian.
#[inline(never)]
fn compare_with_ends(p: &Direction, curve: &GeodesicArc) -> Ordering {
    let is_inside = |end| curve.location(end).v == Along::Inside;
    if is_inside(CurveEnd::Min) && compare_height(p, curve.end(CurveEnd::Min)).is_lt() {
        Ordering::Less
    } else if is_inside(CurveEnd::Max) && compare_height(p, curve.end(CurveEnd::Max)).is_gt() {
        Ordering::Greater
    } else {
        Ordering::Equal
    }
}

impl DirectionalTraits for GeodesicTraits {
    #[inline]
    fn is_directed_right(&self, curve: &GeodesicArc) -> bool {
        curve.is_directed_right()
    }

    fn opposite(&self, curve: &GeodesicArc) -> GeodesicArc {
        curve.reversed()
    }
}
