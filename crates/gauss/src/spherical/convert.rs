//! Polytopes of maps.

use super::SphericalGaussianMap;
use exact::Point3;
use polytope::{Facets, Polytope, convex_hull};

impl SphericalGaussianMap {
    /// Makes the polytope: the inverse of [`SphericalGaussianMap::of_polytope`]. Its vertices are in the order of the faces, its facets in the order of
    /// the vertices that are their normals.
    ///
    /// # Complexity
    /// Linear for dimension 3; O(n log n) below.
    pub fn make_polytope(&self) -> Polytope {
        let dcel = self.arrangement.dcel();
        let mut points: Vec<Point3> = Vec::with_capacity(dcel.face_count());
        // Edits of an arrangement leave numbers free.
        let mut number_of = vec![0; dcel.face_bound()];
        for f in dcel.faces() {
            number_of[f.index()] = points.len() as u32;
            points.push(self.point(f).clone());
        }
        if self.dimension() < 3 {
            return convex_hull(&points).expect("a polytope has a vertex");
        }
        let mut facets = Facets::with_capacity(dcel.vertex_count(), dcel.halfedge_count());
        let mut cycle = Vec::new();
        for v in self.real_vertices() {
            cycle.clear();
            cycle.extend(dcel.around(v).map(|h| number_of[dcel.face(h).index()]));
            facets.push(&cycle);
        }
        Polytope::from_trusted_facets(points, &facets)
    }
}
