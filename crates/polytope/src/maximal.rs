//! Polytopes whose Minkowski sums have the greatest possible number of facets.
//!
//! The bound is that of thesis, chapter 4. The family that reaches it has the shape of the one there,
//! flat solids with m - 2 facets below and two above; but the coordinates come from a rule, so that
//! nothing has to be searched for, and the rule is proved for any number of summands.
//!
//! # The polytope
//!
//! Put N = m - 3, M = k^2, T = k + 1 (k at least 2), and d(j) = M + 2 N - 2 j. Before it is sheared the
//! polytope has these 2 N + 2 vertices, for j from -N to N:
//!
//! * c(j) = (s j - j^2, j, min(0, j) / W), where s = M + 2 N - 1 and W is d(1) T / 2 rounded up;
//! * l = (-(E + N^2), 0, 0), where E = (s + 2 M) N.
//!
//! From above one sees a convex polygon: a chain c(-N), ..., c(N) that turns left, because its steps
//! c(j) - c(j - 1) are (d(j), 1) for j > 0 and longer for j <= 0; and l far to the left of it. Above are
//! two facets, v in the plane z = 0 (where y >= 0) and w in the plane W z = y (where y <= 0): a roof with
//! the ridge from l to c(0). Below are N + 1: the chords from c(j) to c(-j) are parallel, so the
//! quadrilateral x(j) between two consecutive ones is plane (x(1) is a triangle with the corner c(0)), and
//! the triangle u joins the last chord to l. They are convex below: c(j + 1) lies above the plane of
//! x(j), because d(j + 1) < d(j), and so does l. So there are m = N + 3 facets, and three meet at every
//! vertex.
//!
//! Last, y is replaced by x + y, and everything is multiplied by W: integers.
//!
//! # Its Gaussian map
//!
//! Project the half of the sphere with y < 0 from the centre to the plane y = -1, and that with y > 0 to
//! the plane y = 1: great circles become lines, and a turn about the y axis becomes a turn of the plane
//! about the origin. Let K = 1 / M. There
//!
//! * x(j) is the point (1 + 1 / d(j), -2 (2 j - 1) W / d(j)), of which the first coordinate lies between 1
//!   and 1 + K and the second is at most -T; w is (1, W), and W >= T; v is the pole (0, 0, 1), where
//!   vertical rays end;
//! * so the arcs v x(j) and w x(j) run within the strip from 1 - K to 1 + K, through all heights from
//!   -T to T; and so does the arc w u, which runs from w at 1 to x = 1 - (1 + T / W) N / (E - s N) at the
//!   height -T, and that is at least 1 - 2 N / (2 M N): these are 2 N + 1 = 2 m - 5 arcs;
//! * in the upper half the arc u v is the vertical ray at x = -1 - N / (E + s N), between -1 - K and -1,
//!   from the height -2 E W / (E + s N) <= -T up;
//! * all else, the vertices and the other arcs, is farther than T from the origin.
//!
//! # The sum
//!
//! Summand i of k, i from 0, is turned about the y axis by twice the angle a(i) of the vector (k - i, i).
//! The cross product of consecutive vectors is k and their lengths are at most k, so the sine of
//! a(i + 1) - a(i) is at least 1 / k, and that from the last to the right angle too.
//!
//! * *Every pair crosses.* Two strips, whose directions enclose an angle of at least 2 g with sin g >= 1 / k
//!   on either side, meet in a parallelogram whose points are at most (1 + K) / sin g <= k + 1 / k < T from
//!   the origin. Each arc of one strip runs through it from side to side, and so does each of the other:
//!   they cross once, (2 m - 5) (2 n - 5) times together; and the arcs u v once, in the upper half.
//! * *No two crossings coincide.* Within one pair of summands they are on different arcs. A third summand
//!   stays away: the middle lines of the strips are tangents of the unit circle, of which no three
//!   meet. If h < i < j, the unit normal of strip i is a n(h) + b n(j) with a, b > 0 and
//!   a + b >= 1 / cos 2 g; so at a point of strips h and j it has a product of at least (1 - K) (a + b),
//!   which is above 1 + K, because tan^2 g > 1 / k^2 = K.
//! * *No normals coincide* with each other: they lie in their strips, farther than T from the origin.
//!
//! So the sum has at least as many facets as the bound allows, and therefore exactly as many.
//!
//! # References
//! Thesis, chapter 4.

use crate::{Facets, Polytope};
use exact::{Affine3, Integer, Point3, Quaternion};
use std::fmt;

/// The greatest number of facets together, and of summands, of the family: what is made takes less than some GiB.
const LIMIT: usize = 1 << 20;

/// Why there is no such polytope of the maximal family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MaximalError {
    /// A solid with this number of facets was asked for; it has at least four.
    TooFewFacets(usize),
    /// More than 2^20 facets were asked for, of one solid or of all summands together.
    TooManyFacets(usize),
    /// The family was asked for more than 2^20 summands.
    TooManySummands(usize),
}

impl fmt::Display for MaximalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewFacets(facets) => write!(f, "a solid has at least 4 facets, not {facets}"),
            Self::TooManyFacets(facets) => write!(f, "{facets} facets are more than 2^20"),
            Self::TooManySummands(summands) => write!(f, "{summands} summands are more than 2^20"),
        }
    }
}

impl std::error::Error for MaximalError {}

/// The greatest number of facets that a sum of solids with so many facets each can have:
/// the sum of (2 m - 5) (2 n - 5) + 1 over all pairs, and of m over all. `None` if one of them is below
/// 4, or the result is beyond a `usize`.
///
/// Laws:
/// 1. For two solids it is 4 m n - 9 m - 9 n + 26; for k tetrahedra 5 k^2 - k.
/// 2. [`maximal_summands`] reach it, for all m.
///
/// ```
/// use splitstar_polytope::max_facets;
/// assert_eq!(max_facets(&[5, 5]), Some(36));
/// assert_eq!(max_facets(&[4, 4, 4]), Some(42));
/// assert_eq!(max_facets(&[4, 3]), None);
/// ```
///
/// Degenerate: one solid has as many facets as it has; no solid has none.
///
/// # References
/// Thesis, theorem 4.1.
pub fn max_facets(facets: &[usize]) -> Option<usize> {
    if facets.iter().any(|&m| m < 4) {
        return None;
    }
    let arcs = |m: usize| (m - 3).checked_mul(2)?.checked_add(1);
    // The products of all pairs, each number with the sum of those before it. Without a pair nothing is multiplied, so that only
    // a sum that is too large overflows.
    let (mut total, mut before) = (*facets.first().unwrap_or(&0), 0_usize);
    for (i, pair) in facets.windows(2).enumerate() {
        before = before.checked_add(arcs(pair[0])?)?;
        let crossings = arcs(pair[1])?.checked_mul(before)?.checked_add(i + 1)?;
        total = total.checked_add(crossings)?.checked_add(pair[1])?;
    }
    Some(total)
}

/// The polytope with so many facets that, turned about the y axis, makes sums of up to so many summands
/// with the greatest number of facets: see [`maximal_summands`].
///
/// It is simple, with 2 m - 4 vertices for m facets, and flat, the flatter the more summands are
/// planned. The coordinates are integers of about 5 log2(k) + 3 log2(m) bits.
///
/// ```
/// let p = splitstar_polytope::maximal_polytope(7, 2)?;
/// assert_eq!(p.counts().to_array(), [10, 15, 7]);
/// # Ok::<(), splitstar_polytope::MaximalError>(())
/// ```
///
/// # Errors
/// [`MaximalError`] if `facets` is below 4, or one of the numbers above 2^20.
///
/// # Complexity
/// Linear.
///
/// # References
/// Thesis, section 4.2.
pub fn maximal_polytope(facets: usize, summands: usize) -> Result<Polytope, MaximalError> {
    check_numbers(&[facets], summands)?;
    let n = (facets - 3) as u32;
    Ok(Polytope::from_convex_facets(vertices(n, summands.max(2) as u32), &cycles(n)))
}

/// Checks that there are polytopes with so many facets each, for so many summands, and that they are not too large together.
fn check_numbers(facets: &[usize], summands: usize) -> Result<(), MaximalError> {
    if let Some(&few) = facets.iter().find(|&&m| m < 4) {
        return Err(MaximalError::TooFewFacets(few));
    }
    if let Some(&many) = facets.iter().find(|&&m| m > LIMIT) {
        return Err(MaximalError::TooManyFacets(many));
    }
    if summands > LIMIT {
        return Err(MaximalError::TooManySummands(summands));
    }
    // No overflow: there are at most 2^20, of at most 2^20 each.
    let together: u64 = facets.iter().map(|&m| m as u64).sum();
    if together > LIMIT as u64 {
        return Err(MaximalError::TooManyFacets(usize::try_from(together).unwrap_or(usize::MAX)));
    }
    Ok(())
}

/// The vertices l, c(-n), ..., c(n).
fn vertices(n: u32, k: u32) -> Vec<Point3> {
    let [one, two] = [1, 2].map(Integer::from);
    let (chords, k) = (Integer::from(n), Integer::from(k));
    let m = &k * &k;
    let s = &m + &two * &chords - &one;
    let scale = ((&s - &one) * (&k + &one) + &one).div_floor(&two);
    let e = (&s + &two * &m) * &chords;
    let vertex = |x: Integer, y: Integer| {
        let z = if y < Integer::ZERO { y.clone() } else { Integer::ZERO };
        let sheared = (&x + &y) * &scale;
        Point3::new([x * &scale, sheared, z], one.clone()).expect("one is positive")
    };
    let l = vertex(-(e + &chords * &chords), Integer::ZERO);
    let n = i64::from(n);
    let chain = (-n..=n).map(Integer::from).map(|j| vertex((&s - &j) * &j, j));
    std::iter::once(l).chain(chain).collect()
}

/// The facets v, w, x(1), ..., x(n), u as cycles of vertices: l is 0, c(j) is 1 + n + j.
fn cycles(n: u32) -> Facets {
    let corner = 1 + n;
    let mut facets = Facets::with_capacity(n as usize + 3, 6 * n as usize + 6);
    let fan = |chain: std::ops::RangeInclusive<u32>| std::iter::once(0).chain(chain).collect::<Vec<_>>();
    facets.push(&fan(corner..=corner + n));
    facets.push(&fan(1..=corner));
    facets.push(&[corner + 1, corner, corner - 1]);
    for j in 2..=n {
        facets.push(&[corner + j, corner + j - 1, corner + 1 - j, corner - j]);
    }
    facets.push(&[corner + n, corner - n, 0]);
    facets
}

/// Polytopes with so many facets each, of which the sum has the greatest number of facets that such
/// summands can have, [`max_facets`].
///
/// They are [`maximal_polytope`]s, number i of k (from 0) turned about the y axis by twice the angle of
/// which the tangent is i / (k - i): exact rotations, by about 180 i / k degrees.
///
/// ```
/// use splitstar_polytope::{max_facets, maximal_summands, minkowski_sum};
/// let summands = maximal_summands(&[4, 6, 5])?;
/// let sum = minkowski_sum(&summands.iter().collect::<Vec<_>>());
/// assert_eq!(Some(sum.counts().facets), max_facets(&[4, 6, 5]));
/// # Ok::<(), splitstar_polytope::MaximalError>(())
/// ```
///
/// # Errors
/// [`MaximalError`] if one of the numbers is below 4, or all together, or the number of summands, are above 2^20.
///
/// # Complexity
/// Linear in the numbers of facets. The module's source has the proof.
///
/// # References
/// Thesis, section 4.3.
pub fn maximal_summands(facets: &[usize]) -> Result<Vec<Polytope>, MaximalError> {
    let k = facets.len();
    check_numbers(facets, k)?;
    let summand = |(i, &m): (usize, &usize)| {
        let half_turn = [k - i, 0, i, 0].map(Integer::from);
        let turn = Quaternion::new(half_turn).expect("i is below k");
        Ok(maximal_polytope(m, k)?.transformed(&Affine3::rotation(&turn)))
    };
    facets.iter().enumerate().map(summand).collect()
}
