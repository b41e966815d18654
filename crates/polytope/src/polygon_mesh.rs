//! A mesh as a file has it: points and polygons, not yet checked.

use crate::Facets;
use exact::{Affine3, Point3, Sign};

/// Points and polygons over them, as read from a file: nothing about them is checked but the range
/// of the indices.
///
/// Without facets it is a point set. Facets are cycles of indices into `points`, counterclockwise
/// seen from outside.
#[derive(Clone, Debug, Default)]
pub struct PolygonMesh {
    /// The vertices, with exact coordinates.
    pub points: Vec<Point3>,
    /// The polygons.
    pub facets: Facets,
}

impl PolygonMesh {
    /// The mesh under an affine map; polygons are turned round if the map reflects.
    pub fn transformed(&self, map: &Affine3) -> Self {
        let mut facets = self.facets.clone();
        if map.determinant_sign() == Sign::Negative {
            facets.reverse();
        }
        Self { points: self.points.iter().map(|p| map.apply(p)).collect(), facets }
    }
}
