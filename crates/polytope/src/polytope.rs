//! The polytope.

use crate::vectors::{LazyVectors, VectorList, Vectors};
use crate::{Facets, PolygonMesh, hull};
use dcel::{Edge, FacetId, HalfedgeId, Mesh, VertexId};
use exact::{Affine3, Plane, Point3, Sign, Vector3, predicate};

/// A convex polytope of dimension 0 to 3 in space, with exact coordinates.
///
/// Facets are maximal (no two are coplanar), edges are maximal (no two are collinear), vertices are
/// the extreme points. A polygon is stored as two facets, front and back, a segment as one edge, a
/// point as one vertex without edges; [`counts`](Self::counts) gives the numbers of cells as usual.
///
/// ```
/// use exact::Point3;
/// use splitstar_polytope::convex_hull;
/// let corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 1, 0]].map(Point3::from_i64);
/// let tetrahedron = convex_hull(&corners).expect("there are points");
/// assert_eq!(tetrahedron.counts().to_array(), [4, 6, 4]);
/// assert_eq!(tetrahedron.volume().to_string(), "4/3");
/// ```
#[derive(Clone, Debug)]
pub struct Polytope {
    pub(crate) dimension: u8,
    pub(crate) points: Vec<Point3>,
    /// Dimension 3: the boundary. Dimension 2: front (facet 0) and back. Dimension 1: one edge with
    /// the same facet on both sides. Dimension 0: nothing.
    pub(crate) mesh: Mesh,
    pub(crate) vectors: LazyVectors,
}

/// How many vertices, edges and facets there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Counts {
    /// The number of vertices.
    pub vertices: usize,
    /// The number of edges.
    pub edges: usize,
    /// The number of facets: one for a polygon, none for a segment or a point.
    pub facets: usize,
}

impl Counts {
    /// Vertices, edges, facets.
    pub fn to_array(self) -> [usize; 3] {
        [self.vertices, self.edges, self.facets]
    }
}

/// The convex hull of a finite set of points: any points, repeated, collinear or coplanar ones too;
/// `None` for no point.
///
/// # Panics
/// If there are 2^28 points or more.
///
/// # Complexity
/// That of a quickhull: about `n log n` for points in general, `n^2 log n` at worst.
pub fn convex_hull(points: &[Point3]) -> Option<Polytope> {
    use hull::HullFacets::{Point, Polygon, Segment, Solid};
    Some(match hull::hull(points)? {
        Point(p) => Polytope::point(points[p as usize].clone()),
        Segment([p, q]) => Polytope::segment(points[p as usize].clone(), points[q as usize].clone()),
        Polygon(cycle) => Polytope::polygon(cycle.iter().map(|&p| points[p as usize].clone()).collect()),
        Solid(mut facets) => {
            // Vertices in the order of the input.
            let mut index = vec![u32::MAX; points.len()];
            facets.corners().iter().for_each(|&p| index[p as usize] = 0);
            let mut vertices = Vec::new();
            for (p, slot) in index.iter_mut().enumerate().filter(|(_, slot)| **slot == 0) {
                *slot = vertices.len() as u32;
                vertices.push(points[p].clone());
            }
            facets.relabel(&index);
            Polytope::from_convex_facets(vertices, &facets)
        }
    })
}

impl Polytope {
    /// A single point.
    pub fn point(point: Point3) -> Self {
        let mesh = Mesh::from_edges(0, 0, &[]);
        Self {
            dimension: 0,
            points: vec![point],
            mesh,
            vectors: LazyVectors::given(VectorList::Narrow(Vec::new()), Vec::new()),
        }
    }

    /// The segment between two points; a single point if they are equal.
    pub fn segment(source: Point3, target: Point3) -> Self {
        if source == target {
            return Self::point(source);
        }
        let edges = VectorList::from_iter([source.direction_to(&target)]);
        let mesh = Mesh::from_edges(2, 1, &[Edge { source: 0, target: 1, left: 0, right: 0 }]);
        Self {
            dimension: 1,
            points: vec![source, target],
            mesh,
            vectors: LazyVectors::given(edges, Vec::new()),
        }
    }

    /// A polygon from its vertices in order, in strictly convex position in one plane.
    pub(crate) fn polygon(points: Vec<Point3>) -> Self {
        let n = points.len() as u32;
        let edge = |i| Edge { source: i, target: (i + 1) % n, left: 0, right: 1 };
        let mesh = Mesh::from_edges(points.len(), 2, &(0..n).map(edge).collect::<Vec<_>>());
        let edges = edge_vectors(&points, &mesh);
        let front = edges.cross(0, 1);
        let normals = vec![front.clone(), -front];
        Self { dimension: 2, points, mesh, vectors: LazyVectors::given(edges, normals) }
    }

    /// Makes a polytope of dimension 3 of facets of which the caller knows that they bound a convex solid: strictly convex cycles, counterclockwise seen
    /// from outside, no two coplanar, and all points on them. A mesh from anywhere else is for [`Polytope::from_mesh`].
    ///
    /// # Panics
    /// If the facets do not form a closed surface with all points on it; in debug builds, if they are not those of a convex solid. In others the
    /// polytope is not [valid](Polytope::check_valid) then.
    ///
    /// # Complexity
    /// Linear; in debug builds that of [`Polytope::check_valid`].
    ///
    /// ```
    /// use exact::Point3;
    /// use splitstar_polytope::{Facets, Polytope};
    /// let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Point3::from_i64);
    /// let mut facets = Facets::new();
    /// [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]].iter().for_each(|cycle| facets.push(cycle));
    /// let tetrahedron = Polytope::from_trusted_facets(points.to_vec(), &facets);
    /// assert_eq!(tetrahedron.volume().to_string(), "1/6");
    /// ```
    pub fn from_trusted_facets(points: Vec<Point3>, facets: &Facets) -> Self {
        let polytope = Self::from_convex_facets(points, facets);
        debug_assert_eq!(polytope.check_valid(), [], "the facets bound a convex solid");
        polytope
    }

    /// From facets that bound a convex solid: strictly convex cycles, counterclockwise seen from
    /// outside, no two coplanar.
    pub(crate) fn from_convex_facets(points: Vec<Point3>, facets: &Facets) -> Self {
        let mesh = Mesh::from_cycles(points.len(), facets.starts(), facets.corners())
            .expect("the facets of a convex solid form a closed surface");
        Self::from_convex_mesh(points, mesh)
    }

    /// The same from a mesh.
    pub(crate) fn from_convex_mesh(points: Vec<Point3>, mesh: Mesh) -> Self {
        let edges = edge_vectors(&points, &mesh);
        let normals = mesh.facets().map(|f| corner_normal(&mesh, &edges, mesh.boundary(f))).collect();
        Self { dimension: 3, points, mesh, vectors: LazyVectors::given(edges, normals) }
    }

    /// The dimension of the affine hull: 0 to 3.
    pub fn dimension(&self) -> u8 {
        self.dimension
    }

    /// The vertices.
    pub fn points(&self) -> &[Point3] {
        &self.points
    }

    /// How many vertices, edges and facets there are.
    pub fn counts(&self) -> Counts {
        let facets = match self.dimension {
            3 => self.mesh.facet_count(),
            2 => 1,
            _ => 0,
        };
        Counts { vertices: self.points.len(), edges: self.mesh.edge_count(), facets }
    }

    /// The connectivity. A polygon has two facets there, front and back; a segment has one edge with
    /// the same facet on both sides; a point has no cell at all.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The vertices of a facet, counterclockwise seen from outside.
    pub fn facet_cycle(&self, facet: FacetId) -> impl Iterator<Item = VertexId> + '_ {
        self.mesh.facet_cycle(facet).map(|h| self.mesh.source(h))
    }

    /// An outer normal of a facet: an integer vector, some positive multiple of the primitive one.
    ///
    /// # Panics
    /// If the dimension is below 2 or there is no such facet.
    pub fn facet_normal(&self, facet: FacetId) -> &Vector3 {
        &self.vectors().normals[facet.index()]
    }

    /// The plane of a facet, its normal outwards and primitive.
    ///
    /// # Panics
    /// If the dimension is below 2 or there is no such facet.
    pub fn facet_plane(&self, facet: FacetId) -> Plane {
        let on = &self.points[self.mesh.source(self.mesh.boundary(facet)).index()];
        Plane::new(self.facet_normal(facet), on).expect("a normal is not zero")
    }

    /// A positive multiple of target minus source of a halfedge, as an integer vector.
    pub fn edge_vector(&self, h: HalfedgeId) -> Vector3 {
        self.vectors().of_halfedge(h)
    }

    /// All edge vectors and normals.
    pub(crate) fn vectors(&self) -> &Vectors {
        self.vectors.get()
    }

    /// The polytope as a mesh: facets in order; one polygon in dimension 2, one cycle of two vertices
    /// in dimension 1, no facet in dimension 0.
    pub fn to_mesh(&self) -> PolygonMesh {
        let mut facets = Facets::with_capacity(self.mesh.facet_count(), self.mesh.halfedge_count());
        let shown = match self.dimension {
            3 => self.mesh.facet_count(),
            0 => 0,
            _ => 1,
        };
        let mut cycle = Vec::new();
        for f in (0..shown).map(FacetId::new) {
            cycle.clear();
            cycle.extend(self.facet_cycle(f).map(|v| v.0));
            facets.push(&cycle);
        }
        PolygonMesh { points: self.points.clone(), facets }
    }

    /// The polytope under an affine map: rotated, scaled, reflected, moved.
    ///
    /// Degenerate: a map that is not invertible gives the image, of a lower dimension perhaps.
    ///
    /// # Complexity
    /// Linear; that of a convex hull if the map is not invertible.
    pub fn transformed(&self, map: &Affine3) -> Self {
        let points: Vec<Point3> = self.points.iter().map(|p| map.apply(p)).collect();
        let sign = map.determinant_sign();
        if sign == Sign::Zero {
            return convex_hull(&points).expect("a polytope has a vertex");
        }
        match self.dimension {
            3 => {
                let mut facets = self.to_mesh().facets;
                if sign == Sign::Negative {
                    facets.reverse();
                }
                Self::from_convex_facets(points, &facets)
            }
            // In order around the front: a sum has its vertices in any order.
            2 => Self::polygon(self.facet_cycle(FacetId(0)).map(|v| points[v.index()].clone()).collect()),
            1 => {
                let [source, target] = <[Point3; 2]>::try_from(points).expect("a segment has two vertices");
                Self::segment(source, target)
            }
            _ => Self::point(points.into_iter().next().expect("a point has one vertex")),
        }
    }

    /// The reflection through the origin.
    pub fn reflected(&self) -> Self {
        self.transformed(&Affine3::reflection())
    }

    /// The widest integer, in bits, among the coordinates and weights of the vertices.
    pub fn width_bits(&self) -> u32 {
        self.points.iter().map(Point3::bits).max().unwrap_or(0)
    }

    /// Whether two polytopes are the same set.
    ///
    /// # Complexity
    /// `n log n` for the vertices; polytopes with the same vertices are the same set.
    pub fn same_set(&self, other: &Self) -> bool {
        let sorted = |p: &Self| {
            let mut points = p.points.clone();
            points.sort_unstable();
            points
        };
        self.points.len() == other.points.len() && sorted(self) == sorted(other)
    }
}

/// The vector of the even halfedge of every edge.
pub(crate) fn edge_vectors(points: &[Point3], mesh: &Mesh) -> VectorList {
    mesh.edges()
        .map(|h| points[mesh.source(h).index()].direction_to(&points[mesh.target(h).index()]))
        .collect()
}

/// The cross product of a halfedge and the next one: a normal of their facet, outwards if the corner
/// between them is strictly convex, zero if it is straight.
pub(crate) fn corner_normal(mesh: &Mesh, edges: &VectorList, h: HalfedgeId) -> Vector3 {
    let next = mesh.next(h);
    let (a, b) = (h.edge(), next.edge());
    if (h.0 ^ next.0) & 1 == 0 { edges.cross(a, b) } else { edges.cross(b, a) }
}

/// The first axis along which a vector other than zero is not zero: what lies in a plane with that
/// normal can be projected along it.
pub(crate) fn nonzero_axis(vector: &Vector3) -> usize {
    (0..3).find(|&axis| vector.sign(axis) != Sign::Zero).expect("the vector is not zero")
}

/// The side of the circle with normal `h` on which `normal` lies, for a halfedge of either parity.
#[inline]
pub(crate) fn side(edges: &VectorList, normal: &Vector3, h: HalfedgeId) -> Sign {
    let sign = predicate::side_of_circle(normal, &edges.get(h.edge()));
    if h.0 & 1 == 0 { sign } else { -sign }
}
