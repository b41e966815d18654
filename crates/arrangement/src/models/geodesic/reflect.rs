//! Arrangements on the sphere, reflected through its center.

use super::{GeodesicArc, GeodesicTraits};
use crate::Arrangement;
use crate::arrangement::Parts;
use crate::topology::Sphere;
use crate::traits::CurveEnd;
use dcel::{Dcel, EdgeId, FaceId, HalfedgeId, VertexId};
use exact::spherical::{Direction, Meridian};

const SOUTH: VertexId = VertexId(0);
const NORTH: VertexId = VertexId(1);

impl GeodesicTraits {
    /// The traits with the opposite identification.
    pub fn reflected(&self) -> Self {
        let [x, y, _] = self.identification().opposite().coordinates();
        Self { meridian: Meridian::new([x, y]).expect("an identification has a direction") }
    }

    /// Gives the face of cells on the sphere that is at the lower corner of the rectangle of parameters, at the south pole along the identification, or at
    /// the upper one at the north pole. If an edge runs there, it is the face on that side of it where longitudes are small.
    ///
    /// For the south pole it is the [corner face](Arrangement::corner_face), for somebody who makes an arrangement of [`Parts`].
    ///
    /// # Panics
    /// If vertices 0 and 1 are not there: they are the poles.
    ///
    /// # Complexity
    /// Linear in the number of edges at the pole.
    ///
    /// ```
    /// use exact::spherical::GreatCircle;
    /// use splitstar_arrangement::models::{Geodesic, GeodesicTraits};
    /// use splitstar_arrangement::{Arrangement, topology::Sphere, traits::CurveEnd};
    /// let traits = GeodesicTraits::new();
    /// let equator = Geodesic::circle(GreatCircle::from_i64([0, 0, 1]).expect("not zero"));
    /// let halves = Arrangement::of_curves(traits.clone(), Sphere, [&equator]);
    /// let corners = [CurveEnd::Min, CurveEnd::Max].map(|pole| traits.corner_face(halves.dcel(), |e| halves.curve_of(e), pole));
    /// assert!(corners[0] == halves.corner_face() && corners[0] != corners[1]);
    /// ```
    pub fn corner_face<'c>(
        &self,
        dcel: &Dcel,
        curve_of: impl Fn(EdgeId) -> &'c GeodesicArc,
        pole: CurveEnd,
    ) -> FaceId {
        let v = match pole {
            CurveEnd::Min => SOUTH,
            CurveEnd::Max => NORTH,
        };
        if let Some(face) = dcel.isolated_face(v) {
            return face;
        }
        let compare = |a: HalfedgeId, b: HalfedgeId| {
            let [a, b] = [a, b].map(|h| curve_of(h.edge_id()));
            let by_longitude = || self.meridian.compare_u_of_halves(a.circle(), b.circle());
            a.is_along_side().cmp(&b.is_along_side()).then_with(by_longitude)
        };
        let last = dcel.around(v).max_by(|&a, &b| compare(a, b));
        let last = last.expect("a pole that is not isolated has edges");
        // Longitudes grow counterclockwise around the north pole, and clockwise around the south pole.
        dcel.face(if pole == CurveEnd::Max { last } else { last.twin() })
    }
}

impl Arrangement<GeodesicTraits, Sphere> {
    /// Gives the arrangement reflected through the center of the sphere: every point becomes the antipodal one. The identification becomes
    /// [the opposite](GeodesicTraits::reflected), so all curves are cut where they were.
    ///
    /// Ids of faces and edges stay as they are, and so do those of vertices, but for the two poles, which are exchanged. A halfedge has on its left what
    /// it had on its right; those of meridians are exchanged besides, because they run upwards from their min vertex.
    ///
    /// Law: reflected twice, it is the same arrangement.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// ```
    /// use exact::spherical::Direction;
    /// use splitstar_arrangement::models::{Geodesic, GeodesicTraits};
    /// use splitstar_arrangement::{Arrangement, topology::Sphere};
    /// let ends = [[1, 0, 1], [0, 2, 3]].map(|p| Direction::from_i64(p).expect("not zero"));
    /// let [p, q] = ends.clone();
    /// let arc = Geodesic::arc(p, q)?;
    /// let reflected = Arrangement::of_curves(GeodesicTraits::new(), Sphere, [&arc]).reflected();
    /// assert_eq!(reflected.traits().identification().to_string(), "(1, 0, 0)");
    /// let points: Vec<_> = reflected.vertices().filter_map(|v| reflected.point(v)).collect();
    /// assert!(ends.iter().all(|p| points.contains(&&p.opposite())));
    /// # Ok::<(), splitstar_arrangement::models::GeodesicError>(())
    /// ```
    pub fn reflected(&self) -> Self {
        let corner_face = self.traits().corner_face(self.dcel(), |e| self.curve_of(e), CurveEnd::Max);
        let mut dcel = self.dcel().mirrored();
        dcel.exchange_vertices(SOUTH, NORTH);
        for e in self.dcel().edges().filter(|&e| self.curve_of(e).is_meridian()) {
            dcel.reverse_edge(e);
        }
        let antipodal = |point: &Option<Direction>| point.as_ref().map(Direction::opposite);
        let mut is_artificial = self.is_artificial.clone();
        is_artificial.swap(SOUTH.index(), NORTH.index());
        let parts = Parts {
            dcel,
            points: self.points.iter().map(antipodal).collect(),
            is_artificial,
            curves: self.curves().iter().map(GeodesicArc::antipodal).collect(),
            supports: self.supports.clone(),
            corner_face,
        };
        Self::of_valid_parts(self.traits().reflected(), Sphere, parts)
    }
}
