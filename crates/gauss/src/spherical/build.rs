//! Maps of polytopes, and maps with another identification.

use super::{SphericalGaussianMap, dual};
use crate::normals::{circle_of, normal_of};
use arrangement::models::{Geodesic, GeodesicArc, GeodesicTraits};
use arrangement::topology::Sphere;
use arrangement::traits::ArrangementTraits;
use arrangement::{Arrangement, Pieces};
use dcel::HalfedgeId;
use exact::Point3;
use exact::spherical::GreatCircle;
use polytope::Polytope;

/// An arc of a map, with the numbers of the vertices that are extreme on its left and on its right.
struct MapArc {
    geodesic: Geodesic,
    sides: [u32; 2],
}

impl SphericalGaussianMap {
    /// Makes the Gaussian map of a polytope. The identification passes through (-1, 0, 0).
    ///
    /// # Complexity
    /// O(n log n) for n edges.
    pub fn of_polytope(polytope: &Polytope) -> Self {
        Self::of_polytope_with(polytope, GeodesicTraits::new())
    }

    /// Makes the Gaussian map of a polytope on a sphere with any identification.
    ///
    /// To be overlaid without more work, maps need the same identification; the [reflection](Self::reflected) of a map has the opposite one.
    ///
    /// # Complexity
    /// O(n log n) for n edges. The map of a solid is read off its halfedges, without a sweep; only its vertices are sorted.
    ///
    /// ```
    /// use arrangement::models::GeodesicTraits;
    /// use exact::Point3;
    /// use polytope::convex_hull;
    /// use splitstar_gauss::SphericalGaussianMap;
    /// let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Point3::from_i64);
    /// let tetrahedron = convex_hull(&corners).expect("there are points");
    /// let usual = SphericalGaussianMap::of_polytope(&tetrahedron);
    /// let opposite = GeodesicTraits::with_identification([1.into(), 0.into()]).expect("not zero");
    /// let other = SphericalGaussianMap::of_polytope_with(&tetrahedron, opposite);
    /// // Vertices at which arcs were cut are told apart.
    /// assert_eq!(usual.counts(), other.counts());
    /// // The difference body: no map has to be identified anew.
    /// let difference = usual.minkowski_sum(&other.reflected());
    /// assert_eq!(difference.counts().to_array(), [12, 24, 14]);
    /// ```
    pub fn of_polytope_with(polytope: &Polytope, traits: GeodesicTraits) -> Self {
        let mesh = polytope.mesh();
        let circles: Vec<GreatCircle> = mesh.edges().map(|h| circle_of(polytope, h)).collect();
        let normals = match polytope.dimension() {
            0 | 1 => Vec::new(),
            _ => mesh.facets().map(|f| normal_of(mesh, &circles, mesh.boundary(f))).collect(),
        };
        let geodesics = mesh.edges().zip(&circles).map(|(h, circle)| match polytope.dimension() {
            1 => Geodesic::circle(circle.clone()),
            _ => {
                let [source, target] = [h, h.twin()].map(|h| normals[mesh.facet(h).index()].clone());
                Geodesic::arc_around(source, target, circle.clone())
                    .expect("an edge is orthogonal to the normals of its facets")
            }
        });
        if polytope.dimension() == 3 {
            let arrangement = dual::arrangement_of_solid(polytope, traits, &normals, geodesics);
            return Self { arrangement, points: polytope.points().to_vec() };
        }
        let sides = |h| [mesh.target(h), mesh.source(h)].map(|v| v.0);
        let arcs = mesh.edges().zip(geodesics).map(|(h, geodesic)| MapArc { geodesic, sides: sides(h) });
        Self::of_arcs(traits, arcs, polytope.points(), 0)
    }

    /// Gives the same map on a sphere with another identification: its arcs, put together where they were cut, are cut and swept over again.
    ///
    /// # Complexity
    /// O(n log n) for n edges.
    pub fn reidentified(&self, traits: GeodesicTraits) -> Self {
        if traits == *self.arrangement.traits() {
            return self.clone();
        }
        let (view, dcel) = (self.arrangement.user_view(), self.arrangement.dcel());
        let arcs = view.edges().map(|edge| {
            let [first, last] = view.end_halfedges(edge);
            let [source, target] = [first, last].map(|h| dcel.source(h));
            let circle = self.arrangement.curve_of(first.edge_id()).circle();
            let circle = if first.is_even() { circle.clone() } else { circle.opposite() };
            let point = |v| self.arrangement.point(v).expect("on a sphere every vertex has a point").clone();
            let geodesic = if self.arrangement.is_artificial(source) {
                Geodesic::circle(circle)
            } else {
                Geodesic::arc_around(point(source), point(target), circle)
                    .expect("the ends of an edge are on its circle")
            };
            MapArc { geodesic, sides: [first, first.twin()].map(|h| dcel.face(h).0) }
        });
        // Edits of an arrangement leave numbers free: that of the only face need not be 0.
        let only = dcel.faces().next().expect("an arrangement has a face");
        Self::of_arcs(traits, arcs, &self.points, only.0)
    }

    /// The map of arcs that are known to meet in ends only; `only` is the number of the point of the only face, if there is no arc.
    fn of_arcs(
        traits: GeodesicTraits,
        arcs: impl Iterator<Item = MapArc>,
        points: &[Point3],
        only: u32,
    ) -> Self {
        let mut pieces = Pieces::new();
        // For each piece, the sides of its arc.
        let mut sides: Vec<[u32; 2]> = Vec::new();
        let mut buffer = Vec::new();
        for arc in arcs {
            traits.make_u_monotone(&arc.geodesic, &mut buffer);
            sides.resize(sides.len() + buffer.len(), arc.sides);
            pieces.extend(buffer.drain(..));
        }
        let arrangement = Arrangement::of_pieces(traits, Sphere, pieces);
        let dcel = arrangement.dcel();
        let mut extreme = vec![only; dcel.face_bound()];
        for e in dcel.edges() {
            // Pieces are supports, because they do not overlap.
            let support = arrangement.support(e);
            let [left, right] = sides[support.index()];
            let is_right = GeodesicArc::is_directed_right(arrangement.curve(support));
            let along: HalfedgeId = if is_right { e.halfedge() } else { e.halfedge().twin() };
            extreme[dcel.face(along).index()] = left;
            extreme[dcel.face(along.twin()).index()] = right;
        }
        let points = extreme.into_iter().map(|point| points[point as usize].clone()).collect();
        Self { arrangement, points }
    }
}
