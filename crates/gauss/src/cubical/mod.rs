//! Gaussian maps on the sides of a cube.
//!
//! | file | role |
//! |---|---|
//! | this one | the map, and what it knows |
//! | `build` | maps of polytopes, and polytopes of maps |
//! | `sum` | Minkowski sums by six overlays, reflections |
//! | `validity` | what a map promises |

mod build;
mod sum;
mod validity;

pub use validity::CubicalGaussianViolation;

use cubical::{CubicalArrangement, CubicalFaceId};
use exact::Point3;
use polytope::Counts;

/// The Gaussian map of a polytope of dimension 0 to 3, as six planar arrangements on the sides of a cube.
///
/// | polytope | map |
/// |---|---|
/// | facet | real vertex: the outer normal |
/// | edge from p to q | chain of real edges around the vector q - p, with the face of q on its left and that of p on its right |
/// | vertex | face of the sphere, which knows it: [`CubicalGaussianMap::point`] |
///
/// A polygon has two antipodal vertices, front and back, and a half circle for each edge; a segment has a great circle without a vertex of its own, a
/// point has nothing but one face. An edge that has the coordinates (a, b, c) lies, on the side x = 1, on the line a + b y + c z = 0: so all is computed in
/// the plane, with numbers as narrow as edge vectors are.
///
/// # Examples
/// The octahedron, whose normals are the corners of the cube, and the sum of it and itself:
///
/// ```
/// use exact::Point3;
/// use polytope::convex_hull;
/// use splitstar_gauss::CubicalGaussianMap;
/// let corners = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]].map(Point3::from_i64);
/// let octahedron = convex_hull(&corners).expect("there are points");
/// let map = CubicalGaussianMap::of_polytope(&octahedron);
/// assert_eq!(map.counts().to_array(), [6, 12, 8]);
/// // The edges of the cube are real now, and nothing else is there: table 3.3 of the thesis.
/// let stored = map.arrangement().counts_with_artificial();
/// assert_eq!((stored.vertices, stored.edges, stored.faces), (24, 24, 12));
/// let sum = map.minkowski_sum(&map);
/// assert_eq!(sum.make_polytope().volume(), octahedron.volume() * exact::Rational::from(8));
/// ```
///
/// # References
/// Thesis, sections 3.1 and 3.3.
#[derive(Clone, Debug)]
pub struct CubicalGaussianMap {
    arrangement: CubicalArrangement,
    /// For each face, the vertex of the polytope.
    points: Vec<Point3>,
}

impl CubicalGaussianMap {
    /// The six arrangements.
    pub fn arrangement(&self) -> &CubicalArrangement {
        &self.arrangement
    }

    /// The vertex of the polytope that is extreme in the directions of a face.
    ///
    /// # Panics
    /// If there are not so many faces.
    #[inline]
    pub fn point(&self, face: CubicalFaceId) -> &Point3 {
        &self.points[face.index()]
    }

    /// For each face, the vertex of the polytope.
    pub fn points(&self) -> &[Point3] {
        &self.points
    }

    /// Takes the map apart: the arrangements, and for each of their faces the vertex of the polytope.
    pub fn into_parts(self) -> (CubicalArrangement, Vec<Point3>) {
        (self.arrangement, self.points)
    }

    /// The dimension of the polytope: 0 to 3.
    ///
    /// # Complexity
    /// Linear.
    pub fn dimension(&self) -> u8 {
        match self.arrangement.face_count() {
            1 => 0,
            2 => 1,
            _ => match self.arrangement.real_vertices().nth(2) {
                None => 2,
                Some(_) => 3,
            },
        }
    }

    /// How many vertices, edges and facets the polytope has. What is artificial is left out.
    ///
    /// # Complexity
    /// Linear.
    pub fn counts(&self) -> Counts {
        let counts = self.arrangement.counts();
        let facets = match self.dimension() {
            3 => counts.vertices,
            2 => 1,
            _ => 0,
        };
        Counts { vertices: counts.faces, edges: counts.edges, facets }
    }
}
