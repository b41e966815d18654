//! The predicates: what the boxes decide.

use super::decide::{self, Order};
use super::{Line2, Point2};
use crate::Sign;
use crate::stage::{Stage, are_boxes_skipped, count, is_forced};
use std::cmp::Ordering;

/// Compares one coordinate of two points by floats and the sum of the errors of both boxes; `None` if it cannot tell.
///
/// # Proof
/// Rounding is monotone. If the floats differ by at most e1 + e2, then fl(x1 - x2) is at most fl(e1 + e2). So a greater one says that
/// they differ by more, and the coordinates, which are within e1 and e2, differ in the same direction. If the sum of the errors is
/// zero, the floats are the coordinates; their difference rounds to zero only if it is. Infinite errors (and the NaN that infinite
/// floats may give) fail both comparisons.
#[inline(always)]
fn compare_boxes(x: f64, other: f64, error: f64) -> Option<Ordering> {
    let difference = x - other;
    if difference.abs() > error {
        count(Stage::Float);
        // The branch is on being decided, which is predictable; a branch on the sign is not.
        Some(if difference > 0.0 { Ordering::Greater } else { Ordering::Less })
    } else if error == 0.0 {
        Some(Ordering::Equal)
    } else {
        None
    }
}

/// Compares the x-coordinates of two points.
///
/// # Complexity
/// About two nanoseconds when the boxes decide, as they do for explicit integers below 2^53 always. Else degree 5 for two crossings,
/// 4 for a crossing and an explicit point.
#[inline]
pub fn compare_x(p: &Point2, q: &Point2) -> Ordering {
    if !are_boxes_skipped()
        && let Some(ordering) = compare_boxes(p.approx[0], q.approx[0], p.error + q.error)
    {
        return ordering;
    }
    decide::compare(p, q, Order::X)
}

/// Compares the y-coordinates of two points.
///
/// # Complexity
/// As [`compare_x`].
#[inline]
pub fn compare_y(p: &Point2, q: &Point2) -> Ordering {
    if !are_boxes_skipped()
        && let Some(ordering) = compare_boxes(p.approx[1], q.approx[1], p.error + q.error)
    {
        return ordering;
    }
    decide::compare(p, q, Order::Y)
}

/// Compares two points lexicographically, first by x, then by y.
///
/// Laws: a total order; `Equal` exactly for equal points, however they are defined.
///
/// # Complexity
/// As [`compare_x`]; degree 4 for crossings that share a line.
///
/// ```
/// use exact::planar::{Point2, compare_xy};
/// use std::cmp::Ordering;
/// let [p, q] = [[1, 5], [1, 7]].map(Point2::from_i64);
/// assert_eq!(compare_xy(&p, &q), Ordering::Less);
/// ```
#[inline]
pub fn compare_xy(p: &Point2, q: &Point2) -> Ordering {
    if !are_boxes_skipped() {
        let error = p.error + q.error;
        match compare_boxes(p.approx[0], q.approx[0], error) {
            None => {}
            // Then the floats are the coordinates, and those of y decide as well.
            Some(Ordering::Equal) => {
                if let Some(ordering) = compare_boxes(p.approx[1], q.approx[1], error) {
                    return ordering;
                }
            }
            Some(ordering) => return ordering,
        }
    }
    decide::compare(p, q, Order::XThenY)
}

/// Half the distance from 1 to the next `f64`.
const UNIT: f64 = f64::EPSILON / 2.0;

/// The sign of a x + b y - c by floats, if the box of the point allows it.
///
/// # Proof
/// u = 2^-53; A, B, C are the floats nearest to the integers a, b, c, so |a - A| <= u |A| and so on; (X, Y) is the middle of the box, e
/// its error, d = 2^-1075 the greatest error of a product that underflows. With S = |A| + |B|, M = |A X| + |B Y| + |C|, in exact
/// arithmetic:
///
/// * |(a x + b y - c) - (A X + B Y - C)| <= (1 + u) (4/5) e S + u M, because |a x - A X| <= |A| |x - X| + |a - A| (|X| + |x - X|).
/// * The value that is computed is off by at most ((1 + u)^3 - 1) M + 3 d: two products, two sums.
/// * Together at most (1 + u) (4/5) e S + 5 u M + 3 d.
///
/// The bound that is compared is t = fl(fl(fl(S) e) + fl(8 u m + r)), where m is M as computed and r = 2^-1022. Each rounding costs a
/// factor of at least 1 - u (or d): fl(S) e loses three on the way to t, 8 u m five. 4/5 and 5/8 leave room for that, and r is greater
/// than all d together. So |value| > t implies that the value has the right sign. Infinite or NaN floats, or an infinite error,
/// make t infinite or NaN, and the comparison fails.
#[inline(always)]
pub(super) fn side_of_box(p: &Point2, [a, b, c]: [f64; 3]) -> Option<Sign> {
    let [x, y] = p.approx;
    let (ax, by) = (a * x, b * y);
    let value = ax + by - c;
    let magnitude = ax.abs() + by.abs() + c.abs();
    let bound = (a.abs() + b.abs()) * p.error + (8.0 * UNIT * magnitude + f64::MIN_POSITIVE);
    if value.abs() > bound {
        count(Stage::Float);
        Some(if value > 0.0 { Sign::Positive } else { Sign::Negative })
    } else {
        None
    }
}

/// Tells on which side of a line a point lies: the sign of a x + b y - c.
///
/// `Positive` means above the line, or left of a vertical one; `Zero` on it.
///
/// # Complexity
/// Degree 2, at once in 128 bits, for an explicit point with integer coordinates; degree 4 for a crossing, after the filter on its box.
///
/// ```
/// use exact::Sign;
/// use exact::planar::{Line2, Point2, side_of_line};
/// let [p, q, left] = [[1, 0], [1, 1], [0, 9]].map(Point2::from_i64);
/// let vertical = Line2::through(&p, &q).expect("two points");
/// assert_eq!(side_of_line(&left, &vertical), Sign::Positive);
/// assert_eq!(side_of_line(&q, &vertical), Sign::Zero);
/// ```
#[inline]
pub fn side_of_line(p: &Point2, line: &Line2) -> Sign {
    if !is_forced()
        && let (Some((line, _)), Some(&[x, y, 1])) = (line.as_narrow(), p.as_narrow())
    {
        return decide::side_of_integers([x, y], line);
    }
    if !are_boxes_skipped()
        && let Some(sign) = side_of_box(p, line.approx_coefficients())
    {
        return sign;
    }
    decide::side(p, line)
}

/// Half the distance from 1 to the next `f32`.
const UNIT_32: f64 = (f32::EPSILON / 2.0) as f64;

/// Tells on which side of a line a point lies by the [side key](Line2::side_key) of the line; `None` if it cannot tell, as it never can
/// for a point on the line.
///
/// # Proof
/// As in `side_of_box`, but A, B, C are `f32`s: rounded to the nearest `f64`, then to the nearest `f32`, which makes a relative error of
/// at most v = 2^-24 (1 + 2^-28), or an absolute one of 2^-150 where the `f32` is subnormal; then the integer was 0, and there is none. In exact
/// arithmetic |(a x + b y - c) - (A X + B Y - C)| <= (1 + v) (4/5) e S + v M (1 + v), and the floating-point evaluation adds at most 4 u M + 3 d with
/// u = 2^-53. The bound has 2 v' M for this, with v' = 2^-24, which leaves room for its own roundings. Infinite coefficients make it
/// infinite or NaN, and the comparison fails.
///
/// ```
/// use exact::planar::{Line2, Point2, side_of_key};
/// let [p, q, above] = [[0, 0], [3, 1], [0, 1]].map(Point2::from_i64);
/// let key = Line2::through(&p, &q).expect("two points").side_key();
/// assert_eq!(side_of_key(&above, &key), Some(exact::Sign::Positive));
/// assert_eq!(side_of_key(&q, &key), None);
/// assert_eq!(side_of_key(&above, &[0; 3]), None);
/// ```
#[inline]
pub fn side_of_key(p: &Point2, key: &[u32; 3]) -> Option<Sign> {
    let [a, b, c] = key.map(|bits| f64::from(f32::from_bits(bits)));
    let [x, y] = p.approx;
    let (ax, by) = (a * x, b * y);
    let value = ax + by - c;
    let magnitude = ax.abs() + by.abs() + c.abs();
    let bound = (a.abs() + b.abs()) * p.error + (2.0 * UNIT_32 * magnitude + f64::MIN_POSITIVE);
    if value.abs() > bound && !are_boxes_skipped() {
        count(Stage::Float);
        Some(if value > 0.0 { Sign::Positive } else { Sign::Negative })
    } else {
        None
    }
}
