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
