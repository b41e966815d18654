//! The predicates: what the boxes decide.

use super::boxes::{cross_of_boxes, dot_of_boxes, sign_of_coordinate};
use super::decide::{self, OTHERS};
use super::{Direction, GreatCircle};
use crate::Sign;
use crate::stage::{are_boxes_skipped, is_forced};
use std::cmp::Ordering;

/// Gives the sign of a coordinate of a direction; axes are counted 0, 1, 2.
///
/// # Panics
/// If `axis` is not below 3.
///
/// # Complexity
/// Degree 2 for a crossing, after the filter on its box.
#[inline]
pub fn coordinate_sign(p: &Direction, axis: usize) -> Sign {
    if !are_boxes_skipped()
        && let Some(sign) = sign_of_coordinate(p.approx[axis], p.error)
    {
        return sign;
    }
    decide::coordinate_sign(p, axis)
}

/// The sign of one coordinate of p x q.
#[inline]
pub(super) fn cross_sign(p: &Direction, q: &Direction, axis: usize) -> Sign {
    let [i, j] = OTHERS[axis];
    if !are_boxes_skipped()
        && let Some(sign) =
            cross_of_boxes(([p.approx[i], p.approx[j]], p.error), ([q.approx[i], q.approx[j]], q.error))
    {
        return sign;
    }
    decide::cross_sign(p, q, axis)
}

/// Tells how the meridian of `q` lies to that of `p`: the sign of the z-coordinate of p x q.
///
/// `Positive` means that the way from p to q around the north pole is counterclockwise and shorter than half a turn; `Zero` that both are on one
/// meridian circle, be it on opposite halves, or that one is a pole.
///
/// # Complexity
/// A determinant of three normals for crossings on a common circle, degree 4 for others, after the filter on the boxes. Explicit directions: degree 2.
///
/// ```
/// use exact::Sign;
/// use exact::spherical::{Direction, turn};
/// let [p, q] = [[1, 0, 5], [1, 1, -9]].map(|p| Direction::from_i64(p).expect("not zero"));
/// assert_eq!([turn(&p, &q), turn(&q, &p), turn(&p, &p.opposite())], [Sign::Positive, Sign::Negative, Sign::Zero]);
/// ```
#[inline]
pub fn turn(p: &Direction, q: &Direction) -> Sign {
    cross_sign(p, q, 2)
}

/// Tells on which side of a great circle a point lies: the sign of n . p with the normal n.
///
/// # Complexity
/// Degree 2, at once in 128 bits, for narrow explicit directions; degree 3 for a crossing, after the filter on its box.
#[inline]
pub fn side_of_circle(p: &Direction, circle: &GreatCircle) -> Sign {
    if !is_forced()
        && let (Some((n, _)), Some(p)) = (circle.as_narrow(), p.as_narrow())
    {
        return decide::side_of_explicit(p, n);
    }
    if !are_boxes_skipped()
        && let Some(sign) = dot_of_boxes((p.approx, p.error), circle.approx_box())
    {
        return sign;
    }
    decide::side(p, circle)
}

/// The axis along which a direction has its greatest coordinate, as far as floats know, and the sign of that, which is not zero.
#[inline]
fn pivot(p: &Direction) -> (usize, Sign) {
    let [x, y, z] = p.approx.map(f64::abs);
    let first = if x >= y && x >= z {
        0
    } else if y >= z {
        1
    } else {
        2
    };
    // The greatest float is far beyond the error; a tier that is forced does not know it.
    for axis in [first, OTHERS[first][0], OTHERS[first][1]] {
        let sign = coordinate_sign(p, axis);
        if !sign.is_zero() {
            return (axis, sign);
        }
    }
    unreachable!("a direction is not zero")
}

/// Tells whether q = p (`Positive`) or q = -p (`Negative`).
#[inline]
pub(super) fn is_parallel(p: &Direction, q: &Direction, sense: Sign) -> bool {
    let (axis, sign) = pivot(p);
    let [i, j] = OTHERS[axis];
    coordinate_sign(q, axis) == sign * sense && cross_sign(p, q, j).is_zero() && cross_sign(p, q, i).is_zero()
}

/// Tells whether two points are antipodal.
pub fn is_antipodal(p: &Direction, q: &Direction) -> bool {
    is_parallel(p, q, Sign::Negative)
}

/// Compares the latitudes of two points of one half meridian, of which the poles are part.
///
/// It takes no squares: on a half meridian, the greater latitude is counterclockwise from the other.
///
/// Degenerate: where the points are not on one half meridian, the answer means nothing.
///
/// # Complexity
/// As [`turn`].
///
/// ```
/// use exact::spherical::{Direction, compare_height};
/// let [p, q] = [[1, 1, 1], [2, 2, 3]].map(|p| Direction::from_i64(p).expect("not zero"));
/// assert!(compare_height(&p, &q).is_lt() && compare_height(&p, &Direction::SOUTH).is_gt());
/// ```
pub fn compare_height(p: &Direction, q: &Direction) -> Ordering {
    // An axis along which one of them has a coordinate, and the sign of that, is an axis of the half plane.
    let is_x_greater = p.approx[0].abs() + q.approx[0].abs() >= p.approx[1].abs() + q.approx[1].abs();
    for axis in if is_x_greater { [0, 1] } else { [1, 0] } {
        let sign = match coordinate_sign(p, axis) {
            Sign::Zero => coordinate_sign(q, axis),
            sign => sign,
        };
        if !sign.is_zero() {
            // Of (x, z): the y-coordinate of p x q, reversed. Of (y, z): the x-coordinate.
            let up = if axis == 0 { -cross_sign(p, q, 1) } else { cross_sign(p, q, 0) };
            return (up * sign).ordering().reverse();
        }
    }
    // Two poles.
    coordinate_sign(p, 2).cmp(&coordinate_sign(q, 2))
}

/// Tells, of a point where two circles m and n cross, which of the two it is: `Positive` if it is in the direction of m x n, `Negative` if it is the
/// opposite point; `Zero` if the circles have the same points.
///
/// Law: `Positive` if and only if m goes over to the right side of n there.
///
/// # Panics
/// Perhaps in debug builds, if the point is not on both circles.
///
/// # Complexity
/// Degree 2 in the normals.
///
/// ```
/// use exact::Sign;
/// use exact::spherical::{Direction, GreatCircle, crossing_side};
/// let [m, n] = [[0, 0, 1], [1, 0, 1]].map(|n| GreatCircle::from_i64(n).expect("not zero"));
/// let p = Direction::crossing(&m, &n).expect("two circles");
/// assert_eq!([crossing_side(&m, &n, &p), crossing_side(&n, &m, &p)], [Sign::Positive, Sign::Negative]);
/// assert_eq!(crossing_side(&m, &m, &p), Sign::Zero);
/// ```
#[inline]
pub fn crossing_side(m: &GreatCircle, n: &GreatCircle, p: &Direction) -> Sign {
    let (axis, sign) = pivot(p);
    // m x n is a multiple of p, or zero.
    decide::cross_sign_of_circles(m, n, axis) * sign
}

/// Tells whether a meridian circle, run through in its sense, goes up (`Positive`) or down (`Negative`) at one of its points; `Zero` at a pole.
///
/// So it tells on which of the two half meridians the point lies.
///
/// Degenerate: for a circle that is no meridian, or a point that is not on it, the answer means nothing.
pub fn rises_at(p: &Direction, circle: &GreatCircle) -> Sign {
    // The half that goes up is in the direction z x n = (-n_y, n_x).
    match circle.sign(1) {
        Sign::Zero => coordinate_sign(p, 1) * circle.sign(0),
        sign => coordinate_sign(p, 0) * -sign,
    }
}

/// Tells whether, on the way around a circle that begins at p, r comes before q. All three are on the circle.
///
/// Degenerate: `false` if r is p or q. If q is p, the way is the whole circle.
///
/// ```
/// use exact::spherical::{Direction, GreatCircle, is_between};
/// let equator = GreatCircle::from_i64([0, 0, 1]).expect("not zero");
/// let [p, q, r] = [[1, 0, 0], [0, 1, 0], [-1, 0, 0]].map(|p| Direction::from_i64(p).expect("not zero"));
/// assert!(is_between(&equator, &p, &q, &r) && !is_between(&equator, &p, &r, &q));
/// ```
pub fn is_between(circle: &GreatCircle, p: &Direction, r: &Direction, q: &Direction) -> bool {
    let axis = (0..3).find(|&axis| !circle.sign(axis).is_zero()).expect("a normal is not zero");
    // p x q is a multiple of the normal.
    let turn = |p, q| cross_sign(p, q, axis) * circle.sign(axis);
    if p == r || q == r {
        return false;
    }
    if p == q {
        return true;
    }
    // Points up to half a circle on are before the antipodal one, and that is before the others.
    let (of_r, of_q) = (turn(p, r), turn(p, q));
    if of_r == of_q { turn(r, q).is_positive() } else { of_r > of_q }
}
