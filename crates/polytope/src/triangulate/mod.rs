//! Polygons cut into triangles, convex or not: the facets of a mesh, one by one. `ears` cuts those that are not convex.

mod ears;

use crate::{Facets, PolygonMesh};
use ears::Polygon;
use exact::{Integer, Point3, Vector3, predicate};
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
    /// Linear in the corners of strictly convex facets; `k (r + log k)` for a facet of k corners of which
    /// r are reflex or straight.
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
            let polygon = Polygon::new(&self.points, cycle, normal);
            let made = facets.len();
            if polygon.is_strictly_convex() {
                fan(cycle, &mut facets);
            } else if let Some(triangles) = polygon.clip_ears() {
                triangles.iter().for_each(|triangle| facets.push(triangle));
            } else if polygon.is_planar() {
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

#[cfg(test)]
mod tests;
