//! Where a great circle leaves a side of the cube.

use super::CubeSide;
use crate::planar::Point2;
use crate::spherical::{Direction, GreatCircle};
use crate::{Integer, Sign};

/// The place where a great circle leaves a side of the cube.
#[derive(Clone, Debug)]
pub enum Exit {
    /// Through an edge of the cube, without its ends.
    Edge {
        /// The side on which the circle goes on.
        to: CubeSide,
        /// The place, as a point of the side that is left.
        here: Point2,
        /// The place, as a point of the side on which the circle goes on.
        there: Point2,
    },
    /// At this corner of the cube.
    Corner(Direction),
}

impl CubeSide {
    /// Finds where a great circle, run through in its sense, leaves the square of the side.
    ///
    /// `None` if the circle does not meet the plane of the side.
    ///
    /// Degenerate: the answer means nothing if the circle passes through no inner point of the square.
    ///
    /// # Complexity
    /// Two signs of degree 1 in the normal. The coordinates of the place are quotients of degree 1.
    ///
    /// ```
    /// use exact::gnomonic::{CubeSide, Exit};
    /// use exact::spherical::GreatCircle;
    /// let [front, top] = [CubeSide::new(0, true), CubeSide::new(2, true)];
    /// let rising = GreatCircle::from_i64([1, -3, 0]).expect("not zero");
    /// assert!(front.exit(&rising).is_some_and(|exit| matches!(exit, Exit::Edge { to, .. } if to == top)));
    /// let diagonal = GreatCircle::from_i64([0, -1, 1]).expect("not zero");
    /// assert!(front.exit(&diagonal).is_some_and(|exit| matches!(exit, Exit::Corner(_))));
    /// assert!(front.exit(&GreatCircle::from_i64([-1, 0, 0]).expect("not zero")).is_none());
    /// ```
    pub fn exit(self, circle: &GreatCircle) -> Option<Exit> {
        let [u, v] = self.axes();
        // The side faces outwards, so that the circle runs in the direction (n_v, -n_u), and its positive side is on the left.
        let (of_u, of_v) = (circle.sign(v), -circle.sign(u));
        let leaves_through_u = match (of_u.is_zero(), of_v.is_zero()) {
            (true, true) => return None,
            (true, false) => false,
            (false, true) => true,
            (false, false) => {
                let corner = self.corner_towards(of_u, of_v);
                match corner_sign(circle, corner) {
                    Sign::Zero => {
                        return Some(Exit::Corner(Direction::from_i64(corner).expect("not zero")));
                    }
                    // Seen from the corner, the edge on which u does not change is on the right if u and v both grow or both fall.
                    sign => sign == of_u * of_v,
                }
            }
        };
        let (axis, sign, free) = if leaves_through_u { (u, of_u, v) } else { (v, of_v, u) };
        let to = Self::new(axis, sign.is_positive());
        // s n_a + t n_b + n_f x = 0 with the signs s and t of both sides.
        let (numerator, weight) = match circle.narrow_normal() {
            Some(n) => {
                let turned = |value: i64, is_positive: bool| if is_positive { value } else { -value };
                let sum = i128::from(turned(n[self.axis()], self.is_positive()))
                    + i128::from(turned(n[axis], to.is_positive()));
                let numerator = if n[free] > 0 { -sum } else { sum };
                match i64::try_from(numerator) {
                    Ok(numerator) => {
                        let point = |side: Self, other: Self| {
                            side.border_point(other, free, numerator, n[free].abs())
                        };
                        return Some(Exit::Edge { to, here: point(self, to), there: point(to, self) });
                    }
                    Err(_) => (Integer::from(numerator), Integer::from(n[free]).abs()),
                }
            }
            None => {
                let n = circle.coordinates();
                let turned = |side: Self| {
                    if side.is_positive() { n[side.axis()].clone() } else { -&n[side.axis()] }
                };
                let sum = turned(self) + turned(to);
                (if n[free].sign() == Sign::Positive { -sum } else { sum }, n[free].abs())
            }
        };
        let point = |side: Self, other: Self| side.wide_border_point(other, free, &numerator, &weight);
        Some(Exit::Edge { to, here: point(self, to), there: point(to, self) })
    }

    /// The corner of the side at which u and v have these signs.
    fn corner_towards(self, of_u: Sign, of_v: Sign) -> [i64; 3] {
        let [u, v] = self.axes();
        let mut corner = [0; 3];
        for (axis, sign) in [(self.axis(), self.sign()), (u, of_u), (v, of_v)] {
            corner[axis] = if sign.is_positive() { 1 } else { -1 };
        }
        corner
    }

    /// The point on the edge to another side at which the coordinate along the third axis is a quotient.
    fn border_point(self, other: Self, free: usize, numerator: i64, weight: i64) -> Point2 {
        let at_other = if other.is_positive() { weight } else { -weight };
        let is_u_free = self.axes()[0] == free;
        Point2::from_weighted(if is_u_free {
            [numerator, at_other, weight]
        } else {
            [at_other, numerator, weight]
        })
    }

    fn wide_border_point(self, other: Self, free: usize, numerator: &Integer, weight: &Integer) -> Point2 {
        let at_other = if other.is_positive() { weight.clone() } else { -weight };
        let (numerator, is_u_free) = (numerator.clone(), self.axes()[0] == free);
        let [x, y] = if is_u_free { [numerator, at_other] } else { [at_other, numerator] };
        Point2::from_homogeneous([x, y, weight.clone()]).expect("the circle is not parallel to the edge")
    }
}

/// The side of a circle on which a corner of the cube lies.
fn corner_sign(circle: &GreatCircle, corner: [i64; 3]) -> Sign {
    match circle.narrow_normal() {
        Some(n) => Sign::of_i128((0..3).map(|axis| i128::from(n[axis]) * i128::from(corner[axis])).sum()),
        None => {
            let n = circle.coordinates();
            (0..3).map(|axis| &n[axis] * &Integer::from(corner[axis])).sum::<Integer>().sign()
        }
    }
}
