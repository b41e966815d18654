//! Cells of Gaussian maps, counted as the thesis does: vertices, halfedges and faces, with what is artificial.

use cubical::CubeSide;
use gauss::{CubicalGaussianMap, SphericalGaussianMap};
use polytope::Polytope;

/// Vertices, halfedges and faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct MapCounts {
    pub(crate) vertices: usize,
    pub(crate) halfedges: usize,
    pub(crate) faces: usize,
}

impl MapCounts {
    pub(crate) const fn new([vertices, halfedges, faces]: [usize; 3]) -> Self {
        Self { vertices, halfedges, faces }
    }

    /// How far apart two are: the differences, added.
    pub(crate) fn distance(self, other: Self) -> usize {
        self.vertices.abs_diff(other.vertices)
            + self.halfedges.abs_diff(other.halfedges)
            + self.faces.abs_diff(other.faces)
    }
}

impl std::fmt::Display for MapCounts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}/{}", self.vertices, self.halfedges, self.faces)
    }
}

/// The cells of the spherical map of the sum of polytopes, by overlay: with the vertices where arcs are cut at the poles and at the
/// identification, as CGAL counts.
pub(crate) fn spherical_counts(polytopes: &[Polytope]) -> MapCounts {
    let maps: Vec<_> = polytopes.iter().map(SphericalGaussianMap::of_polytope).collect();
    let counts =
        SphericalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>()).counts_with_splits();
    MapCounts { vertices: counts.vertices, halfedges: 2 * counts.edges, faces: counts.faces }
}

/// The cells of the cubical map of the sum of polytopes, on all six sides, by overlays: with those along the edges of the cube, and
/// the unbounded face of each side.
pub(crate) fn cubical_counts(polytopes: &[Polytope]) -> MapCounts {
    let counts = cubical_sum(polytopes).arrangement().counts_with_artificial();
    MapCounts { vertices: counts.vertices, halfedges: 2 * counts.edges, faces: counts.faces }
}

/// The same for each side, with its equation.
pub(crate) fn cubical_side_counts(polytopes: &[Polytope]) -> Vec<(String, MapCounts)> {
    let sum = cubical_sum(polytopes);
    let of_side = |side: CubeSide| {
        let counts = sum.arrangement().side(side).counts_with_splits();
        (
            side.to_string(),
            MapCounts { vertices: counts.vertices, halfedges: 2 * counts.edges, faces: counts.faces },
        )
    };
    CubeSide::ALL.map(of_side).into()
}

fn cubical_sum(polytopes: &[Polytope]) -> CubicalGaussianMap {
    let maps: Vec<_> = polytopes.iter().map(CubicalGaussianMap::of_polytope).collect();
    CubicalGaussianMap::minkowski_sum_all(&maps.iter().collect::<Vec<_>>())
}
