//! Polygons cut into triangles, convex or not.

use crate::{Facets, PolygonMesh};
use exact::{Integer, Point3, Sign, Vector3, predicate};
use std::fmt;

/// Why a facet cannot be cut into triangles.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum TriangulateError {
    /// The facet encloses no area: its corners are collinear, or its parts cancel.
    NoArea {
        /// The facet.
        facet: usize,
    },
    /// The boundary of the facet crosses or touches itself.
    Tangled {
        /// The facet.
        facet: usize,
    },
}

impl TriangulateError {
    /// The facet at fault.
    pub fn facet(&self) -> usize {
        match *self {
            Self::NoArea { facet } | Self::Tangled { facet } => facet,
        }
    }
}

impl fmt::Display for TriangulateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoArea { facet } => write!(f, "facet {facet} encloses no area"),
            Self::Tangled { facet } => write!(f, "the boundary of facet {facet} crosses or touches itself"),
        }
    }
}

impl std::error::Error for TriangulateError {}

impl PolygonMesh {
    /// The same mesh with every facet of four or more corners cut into triangles. No vertex is added
    /// and none is left out; the triangles of a facet take its place in the list.
    ///
    /// A planar facet is cut exactly, convex or not. A facet that is not planar is cut as its
    /// projection along its area vector, and fanned from its first corner if that projection crosses
    /// itself: any way to cut it is a choice. Facets of two or three corners are kept as they are.
    ///
    /// Degenerate: straight corners are cut into triangles with positive area.
    ///
    /// # Errors
    /// The first facet that encloses no area, or is planar and crosses or touches itself.
    ///
    /// # Complexity
    /// Linear in the corners of strictly convex facets; `k (r + 1)` for a facet of k corners of which r
    /// are reflex or straight.
    ///
    /// # References
    /// Ear clipping: G. H. Meisters, "Polygons have ears", 1975.
    pub fn triangulated(&self) -> Result<Self, TriangulateError> {
        let mut facets = Facets::with_capacity(self.facets.corners().len(), 3 * self.facets.corners().len());
        for (facet, cycle) in self.facets.iter().enumerate() {
            if cycle.len() <= 3 {
                facets.push(cycle);
                continue;
            }
            let normal = area_vector(&self.points, cycle);
            if normal.is_zero() {
                return Err(TriangulateError::NoArea { facet });
            }
            let polygon = Polygon { points: &self.points, normal };
            let made = facets.len();
            if polygon.is_strictly_convex(cycle) {
                fan(cycle, &mut facets);
            } else if let Some(triangles) = polygon.clip_ears(cycle) {
                triangles.iter().for_each(|triangle| facets.push(triangle));
            } else if polygon.is_planar(cycle) {
                return Err(TriangulateError::Tangled { facet });
            } else {
                fan(cycle, &mut facets);
            }
            debug_assert_eq!(facets.len() - made, cycle.len() - 2);
        }
        Ok(Self { points: self.points.clone(), facets })
    }
}

fn fan(cycle: &[u32], facets: &mut Facets) {
    for pair in cycle[1..].windows(2) {
        facets.push(&[cycle[0], pair[0], pair[1]]);
    }
}

/// A positive multiple of the sum of the cross products of consecutive corners (Newell): twice the
/// area times the unit normal, for a planar polygon.
fn area_vector(points: &[Point3], cycle: &[u32]) -> Vector3 {
    let corners: Vec<[Integer; 4]> = cycle.iter().map(|&v| points[v as usize].homogeneous()).collect();
    let common = corners.iter().fold(Integer::from(1), |weight, corner| weight.lcm(&corner[3]));
    let scaled = |corner: &[Integer; 4]| {
        let factor = common.div_exact(&corner[3]);
        [0, 1, 2].map(|axis| &corner[axis] * &factor)
    };
    let first = scaled(&corners[0]);
    let arm = |corner: &[Integer; 4]| {
        let corner = scaled(corner);
        [0, 1, 2].map(|axis| &corner[axis] - &first[axis])
    };
    let mut sum = [Integer::from(0), Integer::from(0), Integer::from(0)];
    let mut before = arm(&corners[1]);
    for corner in &corners[2..] {
        let after = arm(corner);
        for (total, term) in sum.iter_mut().zip(predicate::cross(before, after.clone())) {
            *total = &*total + &term;
        }
        before = after;
    }
    Vector3::new(sum).primitive()
}

/// Corners seen along a normal, as if in a plane.
struct Polygon<'a> {
    points: &'a [Point3],
    normal: Vector3,
}

impl Polygon<'_> {
    /// The turn at `b` of the path `a`, `b`, `c`: positive to the left, seen against the normal.
    fn turn(&self, a: u32, b: u32, c: u32) -> Sign {
        let [a, b, c] = [a, b, c].map(|v| &self.points[v as usize]);
        predicate::orientation(&self.normal, &a.direction_to(b), &b.direction_to(c))
    }

    fn is_planar(&self, cycle: &[u32]) -> bool {
        let on = &self.points[cycle[0] as usize];
        cycle.iter().all(|&v| predicate::plane_side(&self.normal, on, &self.points[v as usize]).is_zero())
    }

    /// Whether all corners turn left, and the cycle winds once.
    fn is_strictly_convex(&self, cycle: &[u32]) -> bool {
        let n = cycle.len();
        let corner = |i: usize| cycle[i % n];
        let all_left = (0..n).all(|i| self.turn(corner(i), corner(i + 1), corner(i + 2)) == Sign::Positive);
        // A locally convex cycle winds as often as it has lowest corners, in any order of the plane.
        // The lexicographic order of space is one for a planar cycle.
        let point = |i: usize| &self.points[corner(i) as usize];
        let lowest = |&i: &usize| point(i + 1) < point(i) && point(i + 1) < point(i + 2);
        all_left && self.is_planar(cycle) && (0..n).filter(lowest).count() == 1
    }

    /// `None` if the polygon is not simple.
    fn clip_ears(&self, cycle: &[u32]) -> Option<Vec<[u32; 3]>> {
        let n = cycle.len();
        let mut next: Vec<usize> = (0..n).map(|i| (i + 1) % n).collect();
        let mut before: Vec<usize> = (0..n).map(|i| (i + n - 1) % n).collect();
        let turn_at = |before: &[usize], next: &[usize], i: usize| {
            self.turn(cycle[before[i]], cycle[i], cycle[next[i]])
        };
        let mut turns: Vec<Sign> = (0..n).map(|i| turn_at(&before, &next, i)).collect();
        // Only these may lie in an ear. A corner that has become convex stays so.
        let mut blunt: Vec<usize> = (0..n).filter(|&i| turns[i] != Sign::Positive).collect();
        let mut triangles = Vec::with_capacity(n - 2);
        let (mut at, mut left, mut failed) = (0, n, 0);
        while left > 3 {
            let ear = [before[at], at, next[at]];
            if turns[at] == Sign::Positive && !blunt.iter().any(|&i| self.is_inside(cycle, i, ear)) {
                triangles.push(ear.map(|i| cycle[i]));
                let [source, _, target] = ear;
                next[source] = target;
                before[target] = source;
                for i in [source, target] {
                    turns[i] = turn_at(&before, &next, i);
                }
                blunt.retain(|&i| turns[i] != Sign::Positive && i != at);
                // On to the one after the next: ears alternate, and the triangles stay fatter.
                at = next[target];
                left -= 1;
                failed = 0;
            } else {
                at = next[at];
                failed += 1;
                if failed > left {
                    return None;
                }
            }
        }
        if turns[at] != Sign::Positive {
            return None;
        }
        triangles.push([before[at], at, next[at]].map(|i| cycle[i]));
        Some(triangles)
    }

    /// Whether a corner lies in a triangle of others, or on its boundary. A corner at the place of one
    /// of the three does not count.
    fn is_inside(&self, cycle: &[u32], corner: usize, ear: [usize; 3]) -> bool {
        let p = cycle[corner];
        let ear = ear.map(|i| cycle[i]);
        if ear.iter().any(|&v| v == p || self.points[v as usize] == self.points[p as usize]) {
            return false;
        }
        let [a, b, c] = ear;
        [(a, b), (b, c), (c, a)].iter().all(|&(s, t)| self.turn(s, t, p) != Sign::Negative)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A facet in the plane `x + 2 y + 5 z = 0`, over points of the plane.
    fn tilted(corners: &[[i64; 2]]) -> PolygonMesh {
        let lift = |&[x, y]: &[i64; 2]| Point3::from_i64([5 * x, 5 * y, -x - 2 * y]);
        let mut facets = Facets::new();
        facets.push(&(0..corners.len() as u32).collect::<Vec<_>>());
        PolygonMesh { points: corners.iter().map(lift).collect(), facets }
    }

    fn doubled_area(corners: &[[i64; 2]], cycle: &[u32]) -> i64 {
        let [first, rest @ ..] = cycle else { return 0 };
        let corner = |v: u32| corners[v as usize];
        let [x, y] = corner(*first);
        let cross = |a: [i64; 2], b: [i64; 2]| (a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x);
        rest.windows(2).map(|pair| cross(corner(pair[0]), corner(pair[1]))).sum()
    }

    /// Cuts the polygon from every first corner and in both orientations.
    fn check(name: &str, corners: &[[i64; 2]]) {
        let n = corners.len();
        for turn in 0..n {
            let mut corners: Vec<[i64; 2]> = (0..n).map(|i| corners[(i + turn) % n]).collect();
            for _ in 0..2 {
                let cut = tilted(&corners).triangulated().unwrap_or_else(|e| panic!("{name}: {e}"));
                let whole = doubled_area(&corners, &(0..n as u32).collect::<Vec<_>>());
                let parts: Vec<i64> = cut.facets.iter().map(|t| doubled_area(&corners, t)).collect();
                assert_eq!(parts.len(), n - 2, "{name}");
                // Parts of the same sign that add up cover the polygon without overlap.
                assert!(parts.iter().all(|part| part.signum() == whole.signum()), "{name}: {parts:?}");
                assert_eq!(parts.iter().sum::<i64>(), whole, "{name}");
                assert!(cut.facets.iter().all(|cycle| cycle.len() == 3), "{name}");
                corners.reverse();
            }
        }
    }

    #[test]
    fn simple_polygons() {
        check("square", &[[0, 0], [1, 0], [1, 1], [0, 1]]);
        check("L", &[[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]);
        check("arrow", &[[0, 0], [2, 1], [0, 2], [1, 1]]);
        check("straight corners", &[[0, 0], [1, 0], [2, 0], [3, 0], [3, 3], [2, 2], [1, 1]]);
        check(
            "straight corners all round",
            &[[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]],
        );
        check(
            "cross",
            &[[1, 0], [2, 0], [2, 1], [3, 1], [3, 2], [2, 2], [2, 3], [1, 3], [1, 2], [0, 2], [0, 1], [1, 1]],
        );
        check(
            "spiral",
            &[
                [0, 0],
                [7, 0],
                [7, 7],
                [2, 7],
                [2, 3],
                [4, 3],
                [4, 5],
                [5, 5],
                [5, 2],
                [1, 2],
                [1, 8],
                [8, 8],
                [8, -1],
                [0, -1],
            ],
        );
        let comb: Vec<[i64; 2]> =
            (0..40).map(|i| [i, if i % 2 == 0 { 0 } else { 9 }]).chain([[39, -1], [0, -1]]).collect();
        check("comb", &comb);
        // The lexicographic order of the corners has one lowest, and still a corner is reflex.
        check("dart", &[[0, 0], [9, 1], [4, 2], [9, 9]]);
    }

    #[test]
    fn what_winds_twice_is_not_convex() {
        // A pentagram turns left at every corner.
        let star = tilted(&[[0, 10], [6, -8], [-10, 3], [10, 3], [-6, -8]]);
        assert_eq!(star.triangulated().map(|_| ()), Err(TriangulateError::Tangled { facet: 0 }));
    }

    #[test]
    fn no_area() {
        let flat = tilted(&[[0, 0], [1, 1], [2, 2], [3, 3]]);
        assert_eq!(flat.triangulated().map(|_| ()), Err(TriangulateError::NoArea { facet: 0 }));
        let balanced = tilted(&[[0, 0], [2, 2], [2, 0], [0, 2]]);
        assert_eq!(balanced.triangulated().map(|_| ()), Err(TriangulateError::NoArea { facet: 0 }));
    }

    #[test]
    fn a_facet_that_is_almost_planar_is_cut_by_its_outline() {
        let mut mesh = tilted(&[[0, 0], [30, 0], [30, 10], [10, 10], [10, 20], [0, 20]]);
        mesh.points[3] = Point3::from_rationals(
            &["50", "50", "-30.0000000000000003"].map(|text| text.parse().expect("a number")),
        );
        let cut = mesh.triangulated().unwrap();
        let corners = [[0, 0], [30, 0], [30, 10], [10, 10], [10, 20], [0, 20]];
        assert!(cut.facets.iter().all(|triangle| doubled_area(&corners, triangle) > 0));
        assert_eq!(cut.facets.iter().map(|triangle| doubled_area(&corners, triangle)).sum::<i64>(), 800);
    }
}
