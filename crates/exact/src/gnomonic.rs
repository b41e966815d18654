//! The central projection of the sphere to the sides of a cube.
//!
//! The six planes x, y, z = -1, 1 touch the unit sphere. Seen from the center, the square of each between the others, one side of the cube
//! [-1, 1]^3, covers a sixth of all directions. A direction becomes a point of the plane, a great circle a line; the coefficients of the line
//! are the coordinates of the normal of the circle, and so as narrow as these.
//!
//! Every side has axes u and v of its own, turned such that each is seen counterclockwise from outside. Sides are numbered as in the thesis:
//!
//! | side | plane | u | v |
//! |---|---|---|---|
//! | 0 | x = -1 | z | y |
//! | 1 | y = -1 | x | z |
//! | 2 | z = -1 | y | x |
//! | 3 | x = 1 | y | z |
//! | 4 | y = 1 | z | x |
//! | 5 | z = 1 | x | y |
//!
//! ```
//! use exact::gnomonic::CubeSide;
//! use exact::spherical::{Direction, GreatCircle};
//! let p = Direction::from_i64([3, 4, -2]).expect("not zero");
//! let side = CubeSide::of(&p).first();
//! assert_eq!((side.index(), side.point_of(&p).expect("it is on the side").to_string()), (4, "(-1/2, 3/4)".to_owned()));
//! let circle = GreatCircle::from_i64([2, 0, 3]).expect("not zero");
//! assert_eq!(side.line_of(&circle).expect("it crosses the plane").to_string(), "3 x + 2 y = 0");
//! ```
//!
//! # References
//! Thesis, section 3.3.1, table 3.1.

mod exit;
#[cfg(test)]
mod tests;

pub use exit::Exit;

use crate::planar::{Line2, Point2};
use crate::spherical::{Direction, GreatCircle, coordinate_sign};
use crate::{Integer, Sign};
use std::cmp::Ordering;
use std::fmt;

/// A side of the cube [-1, 1]^3.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CubeSide(u8);

impl CubeSide {
    /// All sides, in order.
    pub const ALL: [Self; 6] = [Self(0), Self(1), Self(2), Self(3), Self(4), Self(5)];

    /// Gives the side that an axis, counted 0, 1, 2, crosses at -1 or at 1.
    ///
    /// # Panics
    /// If `axis` is not below 3.
    #[inline]
    pub fn new(axis: usize, is_positive: bool) -> Self {
        assert!(axis < 3, "axes are counted 0, 1, 2");
        Self(axis as u8 + 3 * u8::from(is_positive))
    }

    /// The number of the side, below 6.
    #[inline]
    pub fn index(self) -> usize {
        usize::from(self.0)
    }

    /// The axis that crosses the side: 0, 1 or 2.
    #[inline]
    pub fn axis(self) -> usize {
        usize::from(self.0 % 3)
    }

    /// Tells whether the axis crosses the side at 1.
    #[inline]
    pub fn is_positive(self) -> bool {
        self.0 >= 3
    }

    /// The sign of the coordinate along the axis.
    #[inline]
    pub fn sign(self) -> Sign {
        if self.is_positive() { Sign::Positive } else { Sign::Negative }
    }

    /// The opposite side.
    #[inline]
    pub fn opposite(self) -> Self {
        Self((self.0 + 3) % 6)
    }

    /// The axes of space along which u and v of the side grow.
    #[inline]
    pub fn axes(self) -> [usize; 2] {
        let [next, last] = [(self.axis() + 1) % 3, (self.axis() + 2) % 3];
        if self.is_positive() { [next, last] } else { [last, next] }
    }

    /// The sides on which a direction lies: one, two if it is on an edge of the cube, three at a corner.
    ///
    /// # Complexity
    /// Degree 2 in the normals for a crossing, 1 for an explicit direction.
    ///
    /// ```
    /// use exact::gnomonic::CubeSide;
    /// use exact::spherical::Direction;
    /// let sides = |p| CubeSide::of(&Direction::from_i64(p).expect("not zero")).map(CubeSide::index).collect::<Vec<_>>();
    /// assert_eq!([sides([1, 0, -7]), sides([-2, 1, 2]), sides([-1, 1, 1])], [vec![2], vec![0, 5], vec![0, 4, 5]]);
    /// ```
    pub fn of(p: &Direction) -> SideSet {
        let (mut greatest, mut axes) = (0, 1_u8);
        for axis in 1..3 {
            match p.compare_magnitudes(axis, greatest) {
                Ordering::Greater => (greatest, axes) = (axis, 1 << axis),
                Ordering::Equal => axes |= 1 << axis,
                Ordering::Less => {}
            }
        }
        let side = |axis| Self::new(axis, coordinate_sign(p, axis).is_positive());
        (0..3).filter(|axis| axes >> axis & 1 == 1).map(side).collect()
    }

    /// The point at which the ray of a direction meets the plane of the side; `None` if it does not.
    ///
    /// A crossing of two circles becomes a crossing of two lines.
    pub fn point_of(self, p: &Direction) -> Option<Point2> {
        if let Some(normals) = p.crossing_normals() {
            if coordinate_sign(p, self.axis()) != self.sign() {
                return None;
            }
            let [l, m] = normals.each_ref().map(|normal| self.line_of_coprime(normal));
            return Point2::crossing(&l?, &m?);
        }
        let [u, v] = self.axes();
        if let Some(p) = p.as_narrow() {
            let weight = if self.is_positive() { p[self.axis()] } else { -p[self.axis()] };
            return (weight > 0).then(|| Point2::from_weighted([p[u], p[v], weight]));
        }
        let p = p.coordinates();
        let weight = if self.is_positive() { p[self.axis()].clone() } else { -&p[self.axis()] };
        (weight.sign() == Sign::Positive)
            .then(|| Point2::from_homogeneous([p[u].clone(), p[v].clone(), weight]))?
    }

    /// The line in which the plane of a great circle cuts that of the side; `None` if they are parallel.
    #[inline]
    pub fn line_of(self, circle: &GreatCircle) -> Option<Line2> {
        if let Some(normal) = circle.narrow_normal() {
            return self.line_of_coprime(normal);
        }
        let ([u, v], normal) = (self.axes(), circle.coordinates());
        let c = if self.is_positive() { -&normal[self.axis()] } else { normal[self.axis()].clone() };
        Line2::from_integers([normal[u].clone(), normal[v].clone(), c])
    }

    #[inline]
    fn line_of_coprime(self, normal: &[i64; 3]) -> Option<Line2> {
        let [u, v] = self.axes();
        let c = if self.is_positive() { -normal[self.axis()] } else { normal[self.axis()] };
        Line2::from_coprime([normal[u], normal[v], c])
    }

    /// The direction of a point of the plane of the side.
    ///
    /// Law: the inverse of [`point_of`](Self::point_of).
    pub fn direction_of(self, p: &Point2) -> Direction {
        if let Some([l, m]) = p.crossing_lines() {
            let [l, m] = [l, m].map(|line| self.circle_of(&line));
            let direction = Direction::crossing(&l, &m).expect("lines that cross are different");
            let is_turned = coordinate_sign(&direction, self.axis()) != self.sign();
            return if is_turned { direction.opposite() } else { direction };
        }
        let ([u, v], [x, y, w]) = (self.axes(), p.homogeneous());
        let mut coordinates = [Integer::ZERO, Integer::ZERO, Integer::ZERO];
        coordinates[self.axis()] = if self.is_positive() { w } else { -w };
        (coordinates[u], coordinates[v]) = (x, y);
        Direction::new(coordinates).expect("a weight is not zero")
    }

    /// The antipodal point of one on any side, on the opposite side.
    ///
    /// That is (-v, -u) for (u, v), whatever the side is.
    ///
    /// ```
    /// use exact::gnomonic::CubeSide;
    /// use exact::planar::Point2;
    /// let (side, point) = (CubeSide::new(1, true), Point2::from_i64([3, 5]));
    /// let antipodal = CubeSide::antipodal_point(&point);
    /// assert_eq!(side.opposite().direction_of(&antipodal), side.direction_of(&point).opposite());
    /// ```
    pub fn antipodal_point(p: &Point2) -> Point2 {
        p.reflected_at_antidiagonal()
    }

    /// The line of the antipodal points of one on any side, on the opposite side.
    ///
    /// Law: both are projections of the same great circle.
    pub fn antipodal_line(line: &Line2) -> Line2 {
        line.reflected_at_antidiagonal()
    }

    /// The great circle of which a line is the projection; what is above the line is on its positive side.
    pub fn circle_of(self, line: &Line2) -> GreatCircle {
        let ([u, v], [a, b, c]) = (self.axes(), line.coefficients());
        let mut normal = [Integer::ZERO, Integer::ZERO, Integer::ZERO];
        normal[self.axis()] = if self.is_positive() { -c } else { c };
        (normal[u], normal[v]) = (a, b);
        GreatCircle::of_integers(normal).expect("a line has a normal")
    }
}

impl fmt::Debug for CubeSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// Writes the equation of the plane.
impl fmt::Display for CubeSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.is_positive() { "" } else { "-" };
        write!(f, "{} = {sign}1", ["x", "y", "z"][self.axis()])
    }
}

/// Some sides of the cube; an iterator over them, in order.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct SideSet(u8);

impl SideSet {
    /// Tells whether a side is one of them.
    #[inline]
    pub fn contains(self, side: CubeSide) -> bool {
        self.0 >> side.0 & 1 == 1
    }

    /// How many there are.
    #[inline]
    pub fn count_sides(self) -> usize {
        self.0.count_ones() as usize
    }

    /// The first of them.
    ///
    /// # Panics
    /// If there is none; a direction has at least one.
    #[inline]
    pub fn first(self) -> CubeSide {
        assert!(self.0 != 0, "there is a side");
        CubeSide(self.0.trailing_zeros() as u8)
    }
}

impl FromIterator<CubeSide> for SideSet {
    fn from_iter<I: IntoIterator<Item = CubeSide>>(sides: I) -> Self {
        Self(sides.into_iter().fold(0, |all, side| all | 1 << side.0))
    }
}

impl Iterator for SideSet {
    type Item = CubeSide;

    #[inline]
    fn next(&mut self) -> Option<CubeSide> {
        if self.0 == 0 {
            return None;
        }
        let side = self.first();
        self.0 &= self.0 - 1;
        Some(side)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.count_sides(), Some(self.count_sides()))
    }
}

impl ExactSizeIterator for SideSet {}

/// The great circle whose points are as far along the axis of one side as along that of another, which is not opposite; the first side is on its positive
/// side. The edge of the cube between both lies on it.
///
/// # Panics
/// If the sides are the same or opposite.
///
/// ```
/// use exact::gnomonic::{CubeSide, diagonal};
/// let circle = diagonal(CubeSide::new(0, true), CubeSide::new(1, false));
/// assert_eq!(circle.to_string(), "(1, 1, 0)");
/// ```
pub fn diagonal(side: CubeSide, other: CubeSide) -> GreatCircle {
    assert!(side.axis() != other.axis(), "the sides have an edge in common");
    let mut normal = [0; 3];
    normal[side.axis()] = if side.is_positive() { 1 } else { -1 };
    normal[other.axis()] = if other.is_positive() { -1 } else { 1 };
    GreatCircle::from_i64(normal).expect("not zero")
}
