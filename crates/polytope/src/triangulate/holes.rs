//! Facets with holes, cut into triangles.

use super::outline::Outline;
use super::sweep::{self, Fault};
use super::{area_vector, off_plane};
use crate::mesh::squared_distance;
use exact::{Point3, Rational};
use std::fmt;

/// Why a facet with holes cannot be cut into triangles.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum HoleError {
    /// The corners do not lie in one plane.
    NotPlanar {
        /// A corner off the plane of the outer cycle.
        vertex: u32,
        /// The square of its distance from that plane.
        squared_distance: Rational,
    },
    /// The outer cycle encloses no area.
    NoArea,
    /// Two edges of the boundary cross or overlap, or one touches the other elsewhere than at a vertex of
    /// both.
    Tangled {
        /// The ends of both, in the directions of their cycles.
        edges: [[u32; 2]; 2],
    },
    /// The facet is not on the left of the edge only: a hole is outside of the outer cycle, or in another
    /// hole, or runs the wrong way round.
    Astray {
        /// The ends of the edge.
        edge: [u32; 2],
    },
}

impl fmt::Display for HoleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotPlanar { vertex, squared_distance } => write!(
                f,
                "vertex {vertex} is off the plane of the facet, the square of the distance is {squared_distance}"
            ),
            Self::NoArea => write!(f, "the facet encloses no area"),
            Self::Tangled { edges: [[a, b], [c, d]] } => write!(
                f,
                "the boundary of the facet crosses or touches itself, at the edges of vertices {a} and {b} and of \
                 vertices {c} and {d}"
            ),
            Self::Astray { edge: [a, b] } => write!(
                f,
                "the facet is not on one side of its boundary at the edge of vertices {a} and {b}: a hole is not \
                 inside, or runs the wrong way round"
            ),
        }
    }
}

impl std::error::Error for HoleError {}

/// Cuts a planar facet with holes into triangles of its vertices, exactly. They are counterclockwise seen
/// from the front, cover the facet once, and have each edge of a cycle as an edge.
///
/// The cycles are lists of indices into `points`; the outer one is counterclockwise and holes are clockwise,
/// both seen from the front. For c corners and h holes, none of one corner and none touching another cycle,
/// there are c + 2 h - 2 triangles.
///
/// Degenerate: cycles may touch one another and themselves at vertices, have straight corners, and run
/// through an edge both ways. A hole of two corners is such an edge, and a hole of one corner a vertex
/// inside: both are in the triangulation, but a hole of one corner that is not inside the facet is ignored.
/// Different vertices at one place are told apart; where a piece of the facet has its corner at both, the
/// boundary is tangled.
///
/// ```
/// use exact::Point3;
/// use splitstar_polytope::triangulate_with_holes;
/// let points = [[0, 0, 0], [9, 0, 0], [0, 9, 0], [1, 1, 0], [1, 2, 0], [2, 1, 0]].map(Point3::from_i64);
/// let triangles = triangulate_with_holes(&points, &[0, 1, 2], &[&[3, 4, 5]])?;
/// assert_eq!(triangles.len(), 6 + 2 - 2);
/// # Ok::<(), splitstar_polytope::HoleError>(())
/// ```
///
/// # Errors
/// See [`HoleError`]; vertices are named by their index in `points`.
///
/// # Panics
/// If an index is out of the range of `points`.
///
/// # Complexity
/// `c log c` tests, each a polynomial of degree 4 in the coordinates of the input, and up to `c^1.5` moves of
/// a number in memory.
pub fn triangulate_with_holes(
    points: &[Point3],
    outer: &[u32],
    holes: &[&[u32]],
) -> Result<Vec<[u32; 3]>, HoleError> {
    if outer.len() < 3 {
        return Err(HoleError::NoArea);
    }
    let normal = area_vector(points, outer);
    if normal.is_zero() {
        return Err(HoleError::NoArea);
    }
    let cycles = || std::iter::once(outer).chain(holes.iter().copied());
    if let Some(vertex) = cycles().find_map(|cycle| off_plane(points, cycle, &normal, outer[0])) {
        let [on, off] = [outer[0], vertex].map(|v| &points[v as usize]);
        return Err(HoleError::NotPlanar { vertex, squared_distance: squared_distance(&normal, on, off) });
    }
    let outline = Outline::new(points, normal, true, cycles())
        .map_err(|ends| HoleError::Tangled { edges: [ends, ends] })?;
    sweep::triangles(&outline).map_err(|fault| match fault {
        Fault::Crossing(edges) => HoleError::Tangled { edges },
        Fault::Astray(edge) => HoleError::Astray { edge },
    })
}
