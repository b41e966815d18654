//! Minkowski sums.

use crate::{OverlayCounts, Polytope, convex_hull, overlay};
use exact::{Point3, Sign, predicate};

/// The Minkowski sum of any number of polytopes of any dimension 0 to 3: the set of all `a + b + ...`
/// with `a` in the first, `b` in the second and so on. The sum of no summand is the origin.
///
/// The Gaussian maps of two summands are overlaid by walking both at once; more summands are added
/// in pairs, smaller ones first, the pairs in parallel with the feature `parallel`. The vertices
/// are in the same order whatever the number of threads.
///
/// ```
/// use exact::Point3;
/// use splitstar_polytope::{Polytope, minkowski_sum};
/// let unit = |p| Polytope::segment(Point3::from_i64([0, 0, 0]), Point3::from_i64(p));
/// let [x, y, z] = [unit([1, 0, 0]), unit([0, 1, 0]), unit([0, 0, 1])];
/// let cube = minkowski_sum(&[&x, &y, &z]);
/// assert_eq!(cube.counts().to_array(), [8, 12, 6]);
/// assert_eq!(cube.volume().to_string(), "1");
/// ```
///
/// # Panics
/// If two summands or their sum have 2^30 facets or more: more than memory holds, on most machines.
///
/// # Complexity
/// For two summands linear in the numbers of their cells and of those of the sum, if vertices have a
/// bounded number of edges; in general a step from arc to arc costs the logarithm of that number.
/// All decisions are signs of scalar products of a normal of one summand and an edge vector of the
/// other: degree 3 in the edge vectors of solids. The cuts in the long arcs of polygons and segments
/// are normals of degree 3 themselves; where an arc runs along another one past such a cut, a
/// determinant of an edge vector and two normals decides.
///
/// # References
/// Thesis, section 3.1; `ARCHITECTURE.md`, "How a sum is computed".
pub fn minkowski_sum(summands: &[&Polytope]) -> Polytope {
    merge(summands, &|p, q| sum_of_two(p, q).0)
}

/// The same sum as the convex hull of all sums of one vertex of each summand, two summands at a time:
/// slower by far, and independent of the overlay.
///
/// ```
/// use exact::Point3;
/// use splitstar_polytope::{convex_hull, minkowski_sum, minkowski_sum_by_hull};
/// let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Point3::from_i64);
/// let p = convex_hull(&points).expect("there are points");
/// let q = p.reflected();
/// assert!(minkowski_sum(&[&p, &q]).same_set(&minkowski_sum_by_hull(&[&p, &q])));
/// ```
///
/// # Panics
/// If two summands have 2^28 pairs of vertices or more.
///
/// # Complexity
/// That of the convex hull of `n m` points for `n` and `m` vertices.
pub fn minkowski_sum_by_hull(summands: &[&Polytope]) -> Polytope {
    merge(summands, &|p, q| {
        let sums: Vec<Point3> = p.points.iter().flat_map(|a| q.points.iter().map(|b| a.plus(b))).collect();
        convex_hull(&sums).expect("a polytope has a vertex")
    })
}

/// How the Gaussian maps of two polytopes meet; all zero if one of them is a point, or both are
/// parallel segments.
///
/// The arcs of a polygon or a segment are counted as they are cut for the overlay: in the middle of
/// each half circle, and every quarter turn.
///
/// ```
/// use exact::Point3;
/// use splitstar_polytope::{convex_hull, overlay_counts};
/// let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Point3::from_i64);
/// let p = convex_hull(&points).expect("there are points");
/// assert_eq!(overlay_counts(&p, &p).common_normals, 4);
/// ```
///
/// # Complexity
/// That of the sum.
pub fn overlay_counts(p: &Polytope, q: &Polytope) -> OverlayCounts {
    sum_of_two(p, q).1
}

fn sum_of_two(p: &Polytope, q: &Polytope) -> (Polytope, OverlayCounts) {
    let none = OverlayCounts::default();
    match (p.dimension, q.dimension) {
        (0, _) => (translated(q, &p.points[0]), none),
        (_, 0) => (translated(p, &q.points[0]), none),
        (1, 1) if p.vectors().edges.get(0).cross(&q.vectors().edges.get(0)).is_zero() => {
            (sum_of_parallel_segments(p, q), none)
        }
        _ => overlay::sum(p, q),
    }
}

/// Translation changes no edge vector and no normal.
fn translated(p: &Polytope, by: &Point3) -> Polytope {
    let mut sum = p.clone();
    for point in &mut sum.points {
        *point = point.plus(by);
    }
    sum
}

fn sum_of_parallel_segments(p: &Polytope, q: &Polytope) -> Polytope {
    let (a, b) = match predicate::same_direction(&p.vectors().edges.get(0), &q.vectors().edges.get(0)) {
        Sign::Negative => (1, 0),
        _ => (0, 1),
    };
    Polytope::segment(p.points[0].plus(&q.points[a]), p.points[1].plus(&q.points[b]))
}

/// Adds in pairs: a balanced tree over the summands in increasing size, so that a large summand is
/// added late and a sum of many small ones grows evenly.
fn merge(summands: &[&Polytope], add: &(impl Fn(&Polytope, &Polytope) -> Polytope + Sync)) -> Polytope {
    let mut sorted = summands.to_vec();
    sorted.sort_by_key(|p| p.points.len());
    match sorted[..] {
        [] => Polytope::point(Point3::from_i64([0, 0, 0])),
        [p] => p.clone(),
        _ => merge_sorted(&sorted, add),
    }
}

fn merge_sorted(
    summands: &[&Polytope],
    add: &(impl Fn(&Polytope, &Polytope) -> Polytope + Sync),
) -> Polytope {
    match summands {
        [p, q] => add(p, q),
        [p, q, r] => add(&add(p, q), r),
        _ => {
            let (low, high) = summands.split_at(summands.len() / 2);
            let (a, b) = join(|| merge_sorted(low, add), || merge_sorted(high, add));
            add(&a, &b)
        }
    }
}

#[cfg(feature = "parallel")]
fn join<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    rayon::join(a, b)
}

#[cfg(not(feature = "parallel"))]
fn join<A, B>(a: impl FnOnce() -> A, b: impl FnOnce() -> B) -> (A, B) {
    (a(), b())
}
