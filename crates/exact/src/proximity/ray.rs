//! Rays from a point and edges.

use crate::predicate::{Class, Predicate, cross, dot, sign};
use crate::tier::Tier;
use crate::{Point3, Sign, Vector3, Width};

/// ((on - apex) x edge) . ray, multiplied by both weights.
struct SideOfRay<'a> {
    apex: &'a Point3,
    ray: &'a Vector3,
    edge: &'a Vector3,
    on: &'a Point3,
}

impl Predicate for SideOfRay<'_> {
    type Value<T: Tier> = T::D4;

    #[inline(always)]
    fn eval<T: Tier>(&self) -> T::D4 {
        let [x, y, z, w] = T::point(self.apex);
        let [px, py, pz, pw] = T::point(self.on);
        let difference = [px * w.clone() - x * pw.clone(), py * w.clone() - y * pw.clone(), pz * w - z * pw];
        dot(cross(T::d1(self.edge), T::d1(self.ray)), difference)
    }

    fn class(&self) -> Class {
        let narrow = |v: &Vector3| v.width() == Width::Narrow;
        let is_narrow = self.apex.as_narrow().is_some() && self.on.as_narrow().is_some();
        if is_narrow && narrow(self.ray) && narrow(self.edge) { Class::Bounded } else { Class::Open }
    }
}

/// Tells on which side of the plane through a point `apex` and an edge a ray from that point runs.
///
/// The sign of ((on - apex) x edge) . ray, for an edge through the point `on`: for an edge of a facet with the apex below it,
/// counterclockwise seen from outside, `Positive` is the side of the facet.
///
/// # Complexity
/// Degree 4; 3 if weights are not counted.
///
/// ```
/// use exact::proximity::side_of_ray;
/// use exact::{Point3, Sign, Vector3};
/// // An edge of a facet in the plane z = 1, which has its facet at smaller x.
/// let (edge, on) = (Vector3::from_i64([0, 1, 0]), Point3::from_i64([1, 0, 1]));
/// let side = |ray| side_of_ray(&Point3::ORIGIN, &Vector3::from_i64(ray), &edge, &on);
/// assert_eq!(side([0, 0, 1]), Sign::Positive);
/// assert_eq!(side([1, 5, 1]), Sign::Zero);
/// assert_eq!(side([2, 0, 1]), Sign::Negative);
/// ```
pub fn side_of_ray(apex: &Point3, ray: &Vector3, edge: &Vector3, on: &Point3) -> Sign {
    sign(&SideOfRay { apex, ray, edge, on })
}
