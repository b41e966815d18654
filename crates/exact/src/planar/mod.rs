//! Exact points and lines of the plane, for arrangements of linear curves.
//!
//! | module | role |
//! |---|---|
//! | `line` | [`Line2`]: primitive integer coefficients, in machine words where they fit |
//! | `point` | [`Point2`]: coordinates, or the two lines that cross in it, and a box of floats around it |
//! | `predicates` | [`compare_x`], [`compare_y`], [`compare_xy`], [`side_of_line`]: the boxes first |
//! | `decide` | what the boxes leave open: 128 bits, fixed width, or integers of any size |
//!
//! Degrees. The coefficients a, b of a line have degree 1 in the coordinates of points with weight 1, c has degree 2. Two lines
//! cross in (X/W, Y/W):
//!
//! ```text
//! W = a1 b2 - a2 b1   degree 2        X = c1 b2 - c2 b1,  Y = a1 c2 - a2 c1   degree 3
//! ```
//!
//! so that two crossings compare with degree 5, a crossing and a line with degree 4. Every line knows the least k such that
//! |a|, |b| < 2^k and |c| < 2^(2 k): a term of degree d of such lines is below 2^(d k). That tells which arithmetic suffices.
//!
//! ```
//! use exact::Sign;
//! use exact::planar::{Line2, Point2, compare_xy, side_of_line};
//! use std::cmp::Ordering;
//! let [a, b, c, d] = [[0, 0], [3, 1], [0, 1], [3, 0]].map(Point2::from_i64);
//! let l = Line2::through(&a, &b).expect("two points");
//! let m = Line2::through(&c, &d).expect("two points");
//! let p = Point2::crossing(&l, &m).expect("not parallel");
//! assert_eq!(p.to_string(), "(3/2, 1/2)");
//! assert_eq!(compare_xy(&p, &b), Ordering::Less);
//! assert_eq!([&c, &p, &d].map(|point| side_of_line(point, &l)), [Sign::Positive, Sign::Zero, Sign::Negative]);
//! ```

mod decide;
mod line;
mod point;
mod predicates;
#[cfg(test)]
mod tests;

pub use line::Line2;
pub use point::Point2;
pub use predicates::{compare_x, compare_xy, compare_y, side_of_key, side_of_line};
