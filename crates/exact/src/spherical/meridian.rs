//! Half meridians from which longitudes are counted, and the order of directions by longitude and latitude.

use super::predicates::{compare_height, coordinate_sign, rises_at, side_of_circle, turn};
use super::{Direction, GreatCircle, approx_angle};
use crate::stage::are_boxes_skipped;
use crate::{Integer, Sign};
use std::cmp::Ordering;

/// A half great circle from the south to the north pole, from which longitudes are counted, counterclockwise seen from the north: zero on the meridian
/// itself, and below a full turn everywhere else.
///
/// ```
/// use exact::spherical::{Direction, Meridian};
/// use std::cmp::Ordering;
/// let [p, q] = [[1, 1, 0], [1, -1, 9]].map(|p| Direction::from_i64(p).expect("not zero"));
/// // Counted from -x, q comes first; counted from x, p does.
/// assert_eq!(Meridian::default().compare_u(&p, &q), Ordering::Greater);
/// let other = Meridian::new([1.into(), 0.into()]).expect("not zero");
/// assert_eq!(other.compare_u(&p, &q), Ordering::Less);
/// ```
#[derive(Clone, Debug)]
pub struct Meridian {
    /// On the equator.
    direction: Direction,
    /// Goes up along the meridian.
    circle: GreatCircle,
    /// The one through (-1, 0, 0).
    is_default: bool,
}

impl Default for Meridian {
    /// The one through (-1, 0, 0).
    fn default() -> Self {
        Self::new([(-1).into(), 0.into()]).expect("the direction is not zero")
    }
}

impl PartialEq for Meridian {
    fn eq(&self, other: &Self) -> bool {
        self.circle == other.circle
    }
}

impl Eq for Meridian {}

/// Where a point lies, in the order of points.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Part {
    South,
    /// On the meridian.
    On,
    /// At less than half a turn.
    First,
    /// On the opposite half meridian.
    Opposite,
    /// At more than half a turn.
    Second,
    North,
}

impl Part {
    /// From the turn from the meridian to a point, and for a turn of zero from whether they are on the same half.
    #[inline(always)]
    fn new(turn: Sign, same_half: impl FnOnce() -> Sign) -> Option<Self> {
        match turn {
            Sign::Positive => Some(Self::First),
            Sign::Negative => Some(Self::Second),
            Sign::Zero => match same_half() {
                Sign::Positive => Some(Self::On),
                Sign::Negative => Some(Self::Opposite),
                Sign::Zero => None,
            },
        }
    }
}

impl Meridian {
    /// Makes the half meridian through the direction (x, y, 0); `None` if that is zero.
    pub fn new([x, y]: [Integer; 2]) -> Option<Self> {
        let direction = Direction::new([x, y, Integer::ZERO])?;
        let [x, y, _] = direction.coordinates();
        let is_default = y.is_zero() && x.sign() == Sign::Negative;
        let circle = GreatCircle::of_integers([y, -x, Integer::ZERO])?;
        Some(Self { direction, circle, is_default })
    }

    /// The point of the meridian on the equator.
    #[inline]
    pub fn direction(&self) -> &Direction {
        &self.direction
    }

    /// The circle that goes up along the meridian.
    #[inline]
    pub fn circle(&self) -> &GreatCircle {
        &self.circle
    }

    /// The turn from the meridian to a point.
    #[inline(always)]
    fn turn_to(&self, p: &Direction) -> Sign {
        if self.is_default { -coordinate_sign(p, 1) } else { -side_of_circle(p, &self.circle) }
    }

    #[inline]
    fn part(&self, p: &Direction) -> Part {
        Part::new(self.turn_to(p), || rises_at(p, &self.circle))
            .unwrap_or_else(|| if coordinate_sign(p, 2).is_negative() { Part::South } else { Part::North })
    }

    /// The part of the half meridian along which a meridian circle goes up.
    fn part_of_half(&self, circle: &GreatCircle) -> Part {
        Part::new(side_of_circle(&self.direction, circle), || rises_at(&self.direction, circle))
            .expect("a direction of the equator is no pole")
    }

    /// Tells whether a point lies on the meridian. The poles do not.
    #[inline]
    pub fn contains(&self, p: &Direction) -> bool {
        self.turn_to(p).is_zero() && rises_at(p, &self.circle).is_positive()
    }

    /// Compares two points by their longitudes.
    ///
    /// Laws: points of the meridian are before all others but the south pole, which is before all; the north pole is after all.
    ///
    /// # Complexity
    /// Two sides and a [`turn`] at most. From the default meridian, the sides are signs of coordinates.
    #[inline]
    pub fn compare_u(&self, p: &Direction, q: &Direction) -> Ordering {
        let (here, there) = (self.part(p), self.part(q));
        here.cmp(&there).then_with(|| match here {
            // The turn from p to q is less than half a turn.
            Part::First | Part::Second => turn(p, q).ordering().reverse(),
            _ => Ordering::Equal,
        })
    }

    /// Compares two points by their longitudes, then by their latitudes.
    ///
    /// Laws: a total order; `Equal` exactly for equal points, however they are defined. The south pole is before all points, the north pole after all.
    ///
    /// # Complexity
    /// As [`Meridian::compare_u`], and a comparison of heights for points of one half meridian.
    #[inline]
    pub fn compare_uv(&self, p: &Direction, q: &Direction) -> Ordering {
        self.compare_u(p, q).then_with(|| compare_height(p, q))
    }

    /// Compares the longitude of a point with that of the half meridian along which a meridian circle goes up.
    #[inline]
    pub fn compare_u_to_half(&self, p: &Direction, circle: &GreatCircle) -> Ordering {
        let (here, there) = (self.part(p), self.part_of_half(circle));
        here.cmp(&there).then_with(|| match here {
            // With m = z x n, the turn from m to p is -n . p.
            Part::First | Part::Second => side_of_circle(p, circle).ordering().reverse(),
            _ => Ordering::Equal,
        })
    }

    /// Compares the longitudes of the half meridians along which two meridian circles go up.
    pub fn compare_u_of_halves(&self, m: &GreatCircle, n: &GreatCircle) -> Ordering {
        let (here, there) = (self.part_of_half(m), self.part_of_half(n));
        here.cmp(&there).then_with(|| match here {
            Part::First | Part::Second => super::decide::cross_sign_of_circles(m, n, 2).ordering().reverse(),
            _ => Ordering::Equal,
        })
    }

    /// A number between 0 and 4 that grows with the longitude, by floats, and a bound of its error; `None` if they cannot tell, as they cannot on the
    /// meridian and at the poles.
    ///
    /// # Proof
    /// Let c be the component of p along d, the direction of the meridian, and s that along z x d. The number is 1 - c/r where s > 0 and 3 + c/r where
    /// s < 0, with r = |c| + |s|; at s = 0, c < 0 both are 2. It has the derivatives |s|/r^2 and |c|/r^2 in magnitude, of the sum 1/r. c and s are
    /// computed with errors of at most k: 4/5 e D + 4/5 f P + 2 (4/5)^2 e f from both boxes, where D = |d0| + |d1|, P = |p0| + |p1|, and
    /// ((1 + u)^2 - 1) D P at most from the evaluation. k as computed is e (D + 2 f) + f P + 4 u D P, greater by 5/4.
    ///
    /// If r, as computed, is at least 2^10 k, it is at least 2^9 k all along the way from the computed c, s to the exact ones, and the number changes by
    /// at most k/r (1 + 2^-7). That way does not pass the meridian, where s = 0 and c > 0, because |s| > k or c < -k. The evaluation of the number adds at
    /// most 4 u (1 + 3): a sum, a quotient of two, a difference below 4. So the error is at most 2 k/r + 16 u.
    #[inline]
    fn pseudo_angle(&self, p: &Direction) -> Option<(f64, f64)> {
        const UNIT: f64 = f64::EPSILON / 2.0;
        let [x, y, _] = p.approx;
        let (cosine, sine, error) = if self.is_default {
            (-x, -y, p.error)
        } else {
            let ([a, b, _], f) = (self.direction.approx, self.direction.error);
            let (d, sum) = (a.abs() + b.abs(), x.abs() + y.abs());
            let spread = p.error * (d + 2.0 * f) + f * sum + 4.0 * UNIT * d * sum;
            (a * x + b * y, a * y - b * x, spread)
        };
        let size = cosine.abs() + sine.abs();
        if (sine.abs() > error || cosine < -error) && size >= 1024.0 * error && !are_boxes_skipped() {
            let ratio = cosine / size;
            let angle = if sine > 0.0 { 1.0 - ratio } else { 3.0 + ratio };
            Some((angle, 2.0 * (error / size) + 16.0 * UNIT))
        } else {
            None
        }
    }

    /// Gives a number that orders points by longitude as far as it goes; 0 if it has none.
    ///
    /// Law: if neither key is 0 and they are different, they have the order of the points by [`Meridian::compare_uv`]. So a different key is a proof, and an
    /// equal one tells nothing.
    ///
    /// # Proof
    /// The bits of positive floats, without the ten lowest, are a monotone function. A point has a key if both ends of an interval around its
    /// pseudo-angle, plus 4, have the same, which is then that of the angle. The ends are rounded by 4 u at most where they are below 8, and the interval is
    /// wider by 8 u than the error.
    ///
    /// ```
    /// use exact::spherical::{Direction, Meridian};
    /// let meridian = Meridian::default();
    /// let [p, q, on] = [[1, -3, 0], [1, 3, 7], [-2, 0, 5]].map(|p| Direction::from_i64(p).expect("not zero"));
    /// assert!(0 < meridian.order_key(&p) && meridian.order_key(&p) < meridian.order_key(&q));
    /// assert_eq!(meridian.order_key(&on), 0);
    /// ```
    #[inline]
    pub fn order_key(&self, p: &Direction) -> u64 {
        match self.angle_range(p) {
            Some([low, high]) if low >> 10 == high >> 10 => low >> 10,
            _ => 0,
        }
    }

    /// Gives a number and how much may be added to it, so that the longitude is somewhere in this range of numbers; `u32::MAX` if nothing is known.
    ///
    /// Law: if the ranges of two points, of both of which something is known, have nothing in common, then they have the order of the points.
    #[inline]
    pub fn order_range(&self, p: &Direction) -> (u64, u32) {
        match self.angle_range(p) {
            Some([low, high]) => (low, u32::try_from(high - low).unwrap_or(u32::MAX)),
            None => (0, u32::MAX),
        }
    }

    /// Bits of floats below and above the pseudo-angle, plus 4 and a little: simple fractions are not where keys change.
    #[inline(always)]
    fn angle_range(&self, p: &Direction) -> Option<[u64; 2]> {
        let (angle, error) = self.pseudo_angle(p)?;
        /// Half of the distance between keys.
        const OFFSET: f64 = 4.0 + 512.0 * 4.0 * f64::EPSILON;
        let radius = error + 4.0 * f64::EPSILON;
        Some([angle - radius, angle + radius].map(|angle| (OFFSET + angle).to_bits()))
    }

    /// Gives floats near to the longitude, from 0 to 2 pi, and the latitude of a point, in radians. The longitude of points on the meridian and of the
    /// poles is zero.
    pub fn approx_f64(&self, p: &Direction) -> [f64; 2] {
        let [angle, height] = self.approx_of_floats(p.approx_f64());
        let is_on = matches!(self.part(p), Part::On | Part::South | Part::North);
        [if is_on { 0.0 } else { angle }, height]
    }

    /// Gives floats near to the longitude, from 0 to 2 pi, and the latitude of a vector of floats, in radians. The same on every machine.
    pub fn approx_of_floats(&self, [x, y, z]: [f64; 3]) -> [f64; 2] {
        let [a, b, _] = self.direction.approx_f64();
        let angle = approx_angle([a * x + b * y, a * y - b * x]);
        let height = approx_angle([(x * x + y * y).sqrt(), z]);
        [if angle < 0.0 { angle + std::f64::consts::TAU } else { angle }, height]
    }
}
