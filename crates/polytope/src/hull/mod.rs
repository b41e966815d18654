//! The convex hull of a finite set of points, exactly.
//!
//! | file | role |
//! |---|---|
//! | `mod.rs` | [`hull`] and its answer |
//! | `sites.rs` | the input as the algorithm sees it: one weight, repeated points left out, approximations |
//! | `affine.rs` | the dimension of the set, by an affinely independent subset |
//! | `planar.rs` | dimension 2: monotone chain |
//! | `quickhull.rs` | dimension 3: a triangulated surface grows point by point |
//! | `fan.rs` | dimension 3: which triangle around the new vertex sees a point |
//! | `merge.rs` | dimension 3: coplanar triangles become facets |
//!
//! Outline:
//!
//! 1. Bring the points to a common weight and leave repeated ones out.
//! 2. Find one, two, three or four affinely independent points. With fewer than four the set is a point, a
//!    segment or a polygon, and the answer comes at once.
//! 3. Begin with the tetrahedron of the four. Each triangle of the surface has a list of points that it
//!    separates from the inside; each point stands in at most one list. Take the point that looks farthest
//!    from the triangle of its list, replace the triangles that it sees by the cone over their boundary, and
//!    distribute the points of their lists to the triangles of the cone. A point that none of these sees is
//!    in the hull so far, and is dropped for good.
//! 4. Join neighbouring triangles of one plane and write down the boundary cycles without the vertices inside
//!    edges.
//!
//! Every decision is the exact sign of a predicate. Floating point chooses only *which* point comes next,
//! where any choice is correct and a good one is fast.

use exact::Point3;

use crate::facets::Facets;

mod affine;
mod fan;
mod merge;
mod planar;
mod quickhull;
mod sites;
#[cfg(test)]
mod tests;

use affine::Frame;
use sites::Sites;

/// The convex hull of a point set, by its dimension. All numbers are indices into the points that were given.
///
/// Only extreme points occur. When several points are equal, one of them stands for all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum HullFacets {
    /// All points are equal to this one.
    Point(u32),
    /// All points lie on the segment between these two, which are different.
    Segment([u32; 2]),
    /// All points lie in a plane: a strictly convex polygon with three or more vertices, counterclockwise for
    /// one of the two normals of the plane.
    Polygon(Vec<u32>),
    /// The facets, four or more: no two in one plane, each a strictly convex polygon, counterclockwise seen
    /// from outside.
    Solid(Facets),
}

/// Computes the convex hull of `points`; `None` if there is no point.
///
/// Exact for every finite set: points may be repeated, collinear or coplanar, and have any coordinates and
/// weights. The same points in the same order give the same answer.
///
/// # Panics
/// If there are 2^28 points or more.
///
/// # Complexity
/// For n points, of which h are vertices of the hull: O(n) space. Dimension 2: O(n log n) comparisons and
/// O(n) orientations. Dimension 3: O(n^2 log n) side tests in the worst case, as an insertion can replace all
/// triangles and move all points. Measured on points on a sphere, bipyramids, prisms with 10^4 sides, grids
/// and pairwise sums, it grows like n log h. A side test has degree 3 in the coordinates (6 when the weights
/// differ and no common one is small).
///
/// # References
/// C. B. Barber, D. P. Dobkin, H. Huhdanpaa: The quickhull algorithm for convex hulls, ACM TOMS 22 (1996).
/// A. M. Andrew: Another efficient algorithm for convex hulls in two dimensions, IPL 9 (1979).
pub(crate) fn hull(points: &[Point3]) -> Option<HullFacets> {
    hull_with(points, SCANNED)
}

/// Cones of more triangles are searched by halving. Around this size both ways cost the same.
const SCANNED: usize = 8;

fn hull_with(points: &[Point3], scanned: usize) -> Option<HullFacets> {
    assert!(points.len() < 1 << 28, "the hull takes fewer than 2^28 points");
    if points.is_empty() {
        return None;
    }
    let sites = Sites::new(points);
    Some(match affine::frame(&sites) {
        Frame::Point(a) => HullFacets::Point(a),
        Frame::Line => HullFacets::Segment(planar::segment(&sites)),
        Frame::Plane(normal) => HullFacets::Polygon(planar::polygon(&sites, &normal)),
        Frame::Space(corners) => {
            HullFacets::Solid(merge::facets(&quickhull::surface(&sites, corners, scanned)))
        }
    })
}
