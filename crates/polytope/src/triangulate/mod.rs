//! Facets cut into triangles, convex or not, with holes or without. `sweep` cuts those that are not convex.

mod holes;
mod nesting;
mod outline;
mod status;
mod sweep;

pub(crate) use nesting::outer_cycles;

pub use holes::{HoleError, triangulate_with_holes};

use crate::{Facets, PolygonMesh};
use exact::{Integer, Point3, Sign, Vector3, predicate};
use outline::Outline;
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
    /// Degenerate: straight corners are cut into triangles with positive area. A facet may run through an
    /// edge both ways, and touch itself at a vertex from within: so some files have facets with holes.
    ///
    /// # Errors
    /// The first facet that encloses no area, or is planar and crosses itself, or touches itself in another
    /// way.
    ///
    /// # Complexity
    /// Linear in the corners of strictly convex facets; `k log k` tests for another facet of k corners, and up
    /// to `k^1.5` moves of a number in memory.
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
            if is_strictly_convex(&self.points, cycle, &normal) {
                fan(cycle, &mut facets);
            } else {
                let planar = off_plane(&self.points, cycle, &normal, cycle[0]).is_none();
                match cut(&self.points, cycle, normal, planar) {
                    Some(triangles) => triangles.iter().for_each(|triangle| facets.push(triangle)),
                    None if planar => return Err(TriangulateError::Tangled { facet }),
                    None => fan(cycle, &mut facets),
                }
            }
        }
        Ok(Self { points: self.points.clone(), facets })
    }
}

/// `None` if the cycle does not enclose one piece.
fn cut(points: &[Point3], cycle: &[u32], normal: Vector3, planar: bool) -> Option<Vec<[u32; 3]>> {
    let outline = Outline::new(points, normal, planar, [cycle]).ok()?;
    let triangles = sweep::triangles(&outline).ok()?;
    // Fewer if the facet touches itself from outside: then it is several.
    (triangles.len() == cycle.len() - 2).then_some(triangles)
}

/// Whether a cycle is planar, turns left at all corners, seen against the normal, and winds once.
fn is_strictly_convex(points: &[Point3], cycle: &[u32], normal: &Vector3) -> bool {
    let n = cycle.len();
    let point = |i: usize| &points[cycle[i % n] as usize];
    let turn = |i: usize| {
        let (a, b, c) = (point(i), point(i + 1), point(i + 2));
        predicate::orientation(normal, &a.direction_to(b), &b.direction_to(c))
    };
    // A locally convex cycle winds as often as it has lowest corners, in any order of the plane.
    // The lexicographic order of space is one for a planar cycle.
    let lowest = |&i: &usize| point(i + 1) < point(i) && point(i + 1) < point(i + 2);
    (0..n).all(|i| turn(i) == Sign::Positive)
        && off_plane(points, cycle, normal, cycle[0]).is_none()
        && (0..n).filter(lowest).count() == 1
}

/// The first vertex of a cycle that is not in the plane through another one.
fn off_plane(points: &[Point3], cycle: &[u32], normal: &Vector3, on: u32) -> Option<u32> {
    let off =
        |&&v: &&u32| !predicate::plane_side(normal, &points[on as usize], &points[v as usize]).is_zero();
    cycle.iter().find(off).copied()
}

fn fan(cycle: &[u32], facets: &mut Facets) {
    for pair in cycle[1..].windows(2) {
        facets.push(&[cycle[0], pair[0], pair[1]]);
    }
}

/// A positive multiple of the sum of the cross products of consecutive corners (Newell): twice the
/// area times the unit normal, for a planar polygon.
fn area_vector(points: &[Point3], cycle: &[u32]) -> Vector3 {
    // Not kept: the facet may have more corners than the mesh has vertices.
    let corner = |v: u32| points[v as usize].homogeneous();
    let common = cycle.iter().fold(Integer::from(1), |weight, &v| weight.lcm(&corner(v)[3]));
    let scaled = |v: u32| {
        let [x, y, z, weight] = corner(v);
        let factor = common.div_exact(&weight);
        [x, y, z].map(|entry| entry * &factor)
    };
    let first = scaled(cycle[0]);
    let arm = |v: u32| {
        let corner = scaled(v);
        [0, 1, 2].map(|axis| &corner[axis] - &first[axis])
    };
    let mut sum = [Integer::from(0), Integer::from(0), Integer::from(0)];
    let mut before = arm(cycle[1]);
    for &v in &cycle[2..] {
        let after = arm(v);
        for (total, term) in sum.iter_mut().zip(predicate::cross(before, after.clone())) {
            *total = &*total + &term;
        }
        before = after;
    }
    Vector3::new(sum).primitive()
}

#[cfg(test)]
mod tests;
