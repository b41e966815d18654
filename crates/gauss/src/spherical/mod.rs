//! Gaussian maps as arrangements of geodesic arcs on the sphere.
//!
//! | file | role |
//! |---|---|
//! | this one | the map, and what it knows |
//! | `build` | maps of polytopes; maps with another identification |
//! | `dual` | the map of a solid, read off its mesh |
//! | `sum` | Minkowski sums by overlay, reflections |
//! | `convert` | polytopes of maps |
//! | `validity` | what a map promises |

mod build;
mod convert;
mod dual;
mod sum;
mod validity;

pub use validity::GaussianViolation;

use arrangement::Arrangement;
use arrangement::models::GeodesicTraits;
use arrangement::topology::Sphere;
use dcel::FaceId;
use exact::Point3;
use polytope::Counts;

/// The Gaussian map of a polytope of dimension 0 to 3, as an arrangement of geodesic arcs on the sphere.
///
/// | polytope | arrangement |
/// |---|---|
/// | facet | vertex: the outer normal |
/// | edge from p to q | arc around the vector q - p, with the face of q on its left and that of p on its right |
/// | vertex | face, which knows it: [`SphericalGaussianMap::point`] |
///
/// The polygon has two antipodal vertices, front and back, and a half circle for each edge; a segment has a great circle without a vertex of its own, a
/// point has nothing but one face. Arcs are cut at the identification and at the poles, where they have
/// [artificial vertices](Arrangement::is_artificial); [`SphericalGaussianMap::counts`] does not count these.
///
/// # Examples
/// The cube, and the sum of it and its reflection, which is a cube again:
///
/// ```
/// use exact::Point3;
/// use polytope::convex_hull;
/// use splitstar_gauss::SphericalGaussianMap;
/// let corners: Vec<_> = (0..8).map(|i| Point3::from_i64([i & 1, i >> 1 & 1, i >> 2])).collect();
/// let cube = convex_hull(&corners).expect("there are points");
/// let map = SphericalGaussianMap::of_polytope(&cube);
/// assert_eq!(map.counts().to_array(), [8, 12, 6]);
/// let sum = map.minkowski_sum(&map.reflected());
/// assert_eq!(sum.make_polytope().volume().to_string(), "8");
/// ```
///
/// # References
/// Thesis, sections 3.1 and 3.2.
#[derive(Clone, Debug)]
pub struct SphericalGaussianMap {
    arrangement: Arrangement<GeodesicTraits, Sphere>,
    /// For each face, the vertex of the polytope.
    points: Vec<Point3>,
}

impl SphericalGaussianMap {
    /// The arrangement.
    pub fn arrangement(&self) -> &Arrangement<GeodesicTraits, Sphere> {
        &self.arrangement
    }

    /// The vertex of the polytope that is extreme in the directions of a face. That of a face that is not there means nothing.
    ///
    /// # Panics
    /// If there are not so many faces.
    #[inline]
    pub fn point(&self, f: FaceId) -> &Point3 {
        &self.points[f.index()]
    }

    /// For each face, by its id, the vertex of the polytope.
    pub fn points(&self) -> &[Point3] {
        &self.points
    }

    /// Takes the map apart: the arrangement, and for each of its faces the vertex of the polytope.
    pub fn into_parts(self) -> (Arrangement<GeodesicTraits, Sphere>, Vec<Point3>) {
        (self.arrangement, self.points)
    }

    /// The dimension of the polytope: 0 to 3.
    ///
    /// # Complexity
    /// Linear.
    pub fn dimension(&self) -> u8 {
        match self.arrangement.dcel().face_count() {
            1 => 0,
            2 => 1,
            _ => match self.real_vertices().nth(2) {
                None => 2,
                Some(_) => 3,
            },
        }
    }

    /// How many vertices, edges and facets the polytope has. Vertices of the map at which arcs were only cut are left out.
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

    /// How many vertices, edges and faces the arrangement has, with those at which arcs were cut. The tables of the thesis count so, but halfedges.
    ///
    /// # Complexity
    /// Linear.
    pub fn counts_with_splits(&self) -> arrangement::Counts {
        self.arrangement.counts_with_splits()
    }

    /// The vertices of the arrangement that are normals of facets: not artificial.
    fn real_vertices(&self) -> impl Iterator<Item = dcel::VertexId> + '_ {
        self.arrangement.vertices().filter(|&v| !self.arrangement.is_artificial(v))
    }
}
