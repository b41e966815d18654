//! What a map promises.

use super::SphericalGaussianMap;
use arrangement::models::GeodesicTraits;
use arrangement::topology::Sphere;
use arrangement::{Arrangement, Violation};
use dcel::{EdgeId, VertexId};
use exact::{Point3, Sign, Vector3, predicate};
use std::fmt;

/// Why an arrangement with a point for each face is not the Gaussian map of a polytope.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum GaussianViolation {
    /// The arrangement does not keep what it promises.
    Arrangement(Violation),
    /// There are not as many points as faces.
    Points,
    /// The way from the point of the face on the right of the edge to that on its left is not a positive multiple of the normal of its circle.
    Edge(EdgeId),
    /// The vertex does not join three arcs, and is not a place where an arc was only cut.
    Vertex(VertexId),
}

impl fmt::Display for GaussianViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Arrangement(violation) => violation.fmt(f),
            Self::Points => write!(f, "there are not as many points as faces"),
            Self::Edge(e) => write!(
                f,
                "the points of the faces beside edge {} do not differ by a positive multiple of its normal",
                e.0
            ),
            Self::Vertex(v) => write!(f, "vertex {} does not join three arcs", v.0),
        }
    }
}

impl std::error::Error for GaussianViolation {}

impl SphericalGaussianMap {
    /// Makes a map of an arrangement and, for each of its faces, a vertex of a polytope.
    ///
    /// # Errors
    /// What [`SphericalGaussianMap::check_valid`] finds.
    ///
    /// # Complexity
    /// O(n log n) for n edges.
    ///
    /// ```
    /// use exact::Point3;
    /// use polytope::Polytope;
    /// use splitstar_gauss::SphericalGaussianMap;
    /// let segment = Polytope::segment(Point3::ORIGIN, Point3::from_i64([1, 2, 3]));
    /// let (arrangement, mut points) = SphericalGaussianMap::of_polytope(&segment).into_parts();
    /// assert!(SphericalGaussianMap::try_from_parts(arrangement.clone(), points.clone()).is_ok());
    /// points.swap(0, 1);
    /// assert!(SphericalGaussianMap::try_from_parts(arrangement, points).is_err());
    /// ```
    pub fn try_from_parts(
        arrangement: Arrangement<GeodesicTraits, Sphere>,
        points: Vec<Point3>,
    ) -> Result<Self, Vec<GaussianViolation>> {
        let map = Self { arrangement, points };
        let violations = map.check_valid();
        if violations.is_empty() { Ok(map) } else { Err(violations) }
    }

    /// Lists every violation of what a map promises; none for a valid one.
    ///
    /// What it promises: the arrangement is [valid](Arrangement::check_valid); each face has a point; across an arc, from right to left, the point moves
    /// by a positive multiple of the normal of the arc; and every vertex that is not artificial joins three arcs at least. That is enough: the
    /// scalar product of a direction with the point of its face is continuous and convex across all arcs, so it is the support function of the hull
    /// of the points, and faces are where it is linear.
    ///
    /// # Complexity
    /// O(n log n) for n edges.
    pub fn check_valid(&self) -> Vec<GaussianViolation> {
        let dcel = self.arrangement.dcel();
        let found: Vec<_> =
            self.arrangement.check_valid().into_iter().map(GaussianViolation::Arrangement).collect();
        if !found.is_empty() {
            return found;
        }
        if self.points.len() < dcel.face_bound() {
            return vec![GaussianViolation::Points];
        }
        let is_broken = |&e: &EdgeId| {
            let [left, right] = [e.halfedge(), e.halfedge().twin()].map(|h| self.point(dcel.face(h)));
            !is_positive_multiple(&right.direction_to(left), &self.arrangement.curve_of(e).circle().normal())
        };
        let edges = dcel.edges().filter(is_broken).map(GaussianViolation::Edge);
        let vertices = self.real_vertices().filter(|&v| dcel.degree(v) < 3).map(GaussianViolation::Vertex);
        edges.chain(vertices).collect()
    }
}

fn is_positive_multiple(vector: &Vector3, of: &Vector3) -> bool {
    vector.cross(of).is_zero() && predicate::same_direction(vector, of) == Sign::Positive
}
