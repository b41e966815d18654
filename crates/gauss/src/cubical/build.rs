//! Maps of polytopes, and polytopes of maps.

use super::CubicalGaussianMap;
use crate::normals::{circle_of, normal_of};
use cubical::{ArcEnd, At, CubeSide, CubicalArrangement, CubicalPieces};
use exact::Point3;
use exact::spherical::GreatCircle;
use polytope::{Facets, Polytope, convex_hull};

impl CubicalGaussianMap {
    /// Makes the Gaussian map of a polytope.
    ///
    /// # Complexity
    /// O(n log n) for n edges.
    ///
    /// # References
    /// Thesis, section 3.3.1.
    pub fn of_polytope(polytope: &Polytope) -> Self {
        let mesh = polytope.mesh();
        let circles: Vec<GreatCircle> = mesh.edges().map(|h| circle_of(polytope, h)).collect();
        let mut pieces = CubicalPieces::with_capacity(mesh.facet_count(), circles.len());
        let normals: Vec<ArcEnd> = match polytope.dimension() {
            0 | 1 => Vec::new(),
            _ => {
                let normals = mesh.facets().map(|f| normal_of(mesh, &circles, mesh.boundary(f)));
                normals.map(|normal| pieces.add_end(&normal)).collect()
            }
        };
        let mut ends = Vec::with_capacity(circles.len());
        for (h, circle) in mesh.edges().zip(&circles) {
            match polytope.dimension() {
                1 => pieces.push_circle(circle),
                _ => {
                    let [source, target] = [h, h.twin()].map(|h| normals[mesh.facet(h).index()]);
                    pieces.push_arc_between(circle, source, target);
                }
            }
            ends.push([mesh.target(h), mesh.source(h)].map(|v| &polytope.points()[v.index()]));
        }
        // Arcs meet in normals of facets only; a circle has none.
        let (arrangement, arcs) = match polytope.dimension() {
            1 => CubicalArrangement::of_pieces_with_arcs(pieces),
            _ => CubicalArrangement::of_connected_pieces_with_arcs(pieces),
        };
        // Without arcs there is one face, and one point.
        let mut points: Vec<Option<&Point3>> = vec![None; arrangement.face_count()];
        for side in CubeSide::ALL {
            let own = arrangement.side(side);
            for id in own.dcel().faces() {
                let Some(face) = arrangement.face_of(At { side, id }) else { continue };
                let point = &mut points[face.index()];
                if let (None, Some(ccb)) = (&point, own.dcel().first_ccb(id)) {
                    *point = own.dcel().ccb_cycle(ccb).find_map(|h| {
                        let arc = arcs[side.index()][h.edge()]?;
                        let is_along = own.curve_of(h.edge_id()).is_directed_right() == h.is_even();
                        Some(ends[arc as usize][usize::from(!is_along)])
                    });
                }
            }
        }
        let points = points.into_iter().map(|point| point.unwrap_or(&polytope.points()[0]).clone()).collect();
        Self { arrangement, points }
    }

    /// Makes the polytope: the inverse of [`CubicalGaussianMap::of_polytope`]. Its vertices are in the order of the faces, its facets in the order of the real vertices
    /// that are their normals.
    ///
    /// # Complexity
    /// Linear for dimension 3; O(n log n) below.
    pub fn make_polytope(&self) -> Polytope {
        if self.dimension() < 3 {
            return convex_hull(&self.points).expect("a polytope has a vertex");
        }
        let mut facets = Facets::with_capacity(self.points.len(), 6 * self.points.len());
        let mut cycle = Vec::new();
        for v in self.arrangement.real_vertices() {
            cycle.clear();
            let face = |h| self.arrangement.face(h).0;
            let side = v.side;
            match self.arrangement.next_copy(v) {
                // Within its side, there is nothing artificial.
                None => {
                    let around = self.arrangement.side(side).dcel().around(v.id);
                    cycle.extend(around.map(|id| face(At { side, id })));
                }
                Some(_) => cycle.extend(self.arrangement.real_around(v).map(face)),
            }
            facets.push(&cycle);
        }
        Polytope::from_trusted_facets(self.points.clone(), &facets)
    }
}
