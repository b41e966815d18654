//! What a map promises.

use super::CubicalGaussianMap;
use cubical::{At, CubeSide, CubicalArrangement, CubicalViolation};
use dcel::{EdgeId, VertexId};
use exact::{Point3, Sign, predicate};
use std::fmt;

/// Why six arrangements with a point for each face are not the Gaussian map of a polytope.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum CubicalGaussianViolation {
    /// The arrangements do not keep what they promise.
    Arrangement(CubicalViolation),
    /// There are not as many points as faces.
    Points,
    /// The way from the point of the face on the right of the real edge to that on its left is not a positive multiple of the normal of its circle.
    Edge(At<EdgeId>),
    /// The real vertex does not join three arcs.
    Vertex(At<VertexId>),
}

impl fmt::Display for CubicalGaussianViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Arrangement(violation) => violation.fmt(f),
            Self::Points => write!(f, "there are not as many points as faces"),
            Self::Edge(e) => write!(
                f,
                "side {}: the points of the faces beside edge {} do not differ by a positive multiple of its normal",
                e.side, e.id.0
            ),
            Self::Vertex(v) => write!(f, "side {}: vertex {} does not join three arcs", v.side, v.id.0),
        }
    }
}

impl std::error::Error for CubicalGaussianViolation {}

impl CubicalGaussianMap {
    /// Makes a map of six arrangements and, for each of their faces, a vertex of a polytope.
    ///
    /// # Errors
    /// What [`CubicalGaussianMap::check_valid`] finds.
    ///
    /// # Complexity
    /// O(n log n) for n edges.
    ///
    /// ```
    /// use exact::Point3;
    /// use polytope::Polytope;
    /// use splitstar_gauss::CubicalGaussianMap;
    /// let segment = Polytope::segment(Point3::ORIGIN, Point3::from_i64([1, 2, 3]));
    /// let (arrangement, mut points) = CubicalGaussianMap::of_polytope(&segment).into_parts();
    /// assert!(CubicalGaussianMap::try_from_parts(arrangement.clone(), points.clone()).is_ok());
    /// points.swap(0, 1);
    /// assert!(CubicalGaussianMap::try_from_parts(arrangement, points).is_err());
    /// ```
    pub fn try_from_parts(
        arrangement: CubicalArrangement,
        points: Vec<Point3>,
    ) -> Result<Self, Vec<CubicalGaussianViolation>> {
        let map = Self { arrangement, points };
        let violations = map.check_valid();
        if violations.is_empty() { Ok(map) } else { Err(violations) }
    }

    /// Lists every violation of what a map promises; none for a valid one.
    ///
    /// What it promises: the arrangement is [valid](CubicalArrangement::check_valid); each face has a point; across a real edge, from right to left, the point moves
    /// by a positive multiple of the normal of its circle; and every real vertex joins three arcs at least. That is enough, as it is on the sphere: the
    /// scalar product of a direction with the point of its face is continuous and convex across all arcs, so it is the support function of the hull
    /// of the points.
    ///
    /// # Complexity
    /// O(n log n) for n edges.
    pub fn check_valid(&self) -> Vec<CubicalGaussianViolation> {
        let map = &self.arrangement;
        let found: Vec<_> =
            map.check_valid().into_iter().map(CubicalGaussianViolation::Arrangement).collect();
        if !found.is_empty() {
            return found;
        }
        if self.points.len() != map.face_count() {
            return vec![CubicalGaussianViolation::Points];
        }
        let all_edges = CubeSide::ALL
            .into_iter()
            .flat_map(|side| map.side(side).dcel().edges().map(move |id| At { side, id }));
        let is_broken = |&e: &At<EdgeId>| {
            let h = At { side: e.side, id: map.inner_halfedge(e) };
            let [left, right] = [h, map.twin(h)].map(|h| self.point(map.face(h)));
            let (way, normal) = (right.direction_to(left), map.circle(h).normal());
            !way.cross(&normal).is_zero() || predicate::same_direction(&way, &normal) != Sign::Positive
        };
        let edges =
            all_edges.filter(|&e| map.is_real_edge(e)).filter(is_broken).map(CubicalGaussianViolation::Edge);
        let joins_three = |&v: &At<VertexId>| map.real_around(v).nth(2).is_some();
        let vertices = map.real_vertices().filter(|v| !joins_three(v)).map(CubicalGaussianViolation::Vertex);
        edges.chain(vertices).collect()
    }
}
