//! Exact directions and great circles of the sphere, for arrangements of geodesic arcs.
//!
//! | module | role |
//! |---|---|
//! | `circle` | [`GreatCircle`]: a primitive integer normal, in machine words where it fits |
//! | `direction` | [`Direction`]: coordinates, or the two great circles that cross in it, and a box of floats around a multiple of it |
//! | `meridian` | [`Meridian`]: a half circle from which longitudes are counted; the order of directions, and keys for it |
//! | `predicates` | sides, turns, heights: the boxes first |
//! | `angle` | angles by floats, for pictures |
//! | `boxes` | what floats can tell, with proofs |
//! | [`geographic`] | directions of longitudes and latitudes in degrees |
//! | `decide` | what they leave open: 128 bits, fixed width, or integers of any size |
//!
//! A point of the sphere is a direction: any positive multiple of a vector is the same point. So all that is asked is a sign, and no
//! square root is ever taken.
//!
//! Degrees. With k bits of a coordinate, a great circle through two points has a normal of 2 k bits. Two great circles m and n cross
//! in m x n and in the opposite point. In normals,
//!
//! ```text
//! the side of a circle on which a crossing lies     det(l, m, n)             degree 3
//! the turn of two crossings of one circle n         n_z det(n, a, b)         degree 1 and 3
//! the turn of two crossings                         z of (a x b) x (c x d)   degree 4
//! ```
//!
//! Every circle knows the least k such that its coordinates are below 2^k. That tells which arithmetic suffices.
//!
//! ```
//! use exact::Sign;
//! use exact::spherical::{Direction, GreatCircle, side_of_circle, turn};
//! let [x, y, p] = [[1, 0, 0], [0, 1, 0], [1, 1, 1]].map(|p| Direction::from_i64(p).expect("not zero"));
//! let equator = GreatCircle::through(&x, &y).expect("neither equal nor antipodal");
//! let meridian = GreatCircle::through(&p, &Direction::NORTH).expect("neither equal nor antipodal");
//! let foot = Direction::crossing(&meridian, &equator).expect("two circles");
//! assert_eq!(foot.to_string(), "(-1, -1, 0)");
//! assert_eq!([&p, &x, &Direction::SOUTH].map(|p| side_of_circle(p, &equator)), [Sign::Positive, Sign::Zero, Sign::Negative]);
//! assert_eq!(turn(&x, &p), Sign::Positive);
//! ```

mod angle;
mod boxes;
mod circle;
mod decide;
mod direction;
pub mod geographic;
mod meridian;
mod predicates;
#[cfg(test)]
mod tests;

pub use angle::approx_angle;
pub use boxes::side_of_key;
pub use circle::GreatCircle;
pub use direction::Direction;
pub use meridian::Meridian;
pub use predicates::{
    compare_height, coordinate_sign, crossing_side, is_antipodal, is_between, rises_at, side_of_circle, turn,
};

/// Bits of the coordinates of narrow directions and normals.
const NARROW_BITS: u32 = 62;
