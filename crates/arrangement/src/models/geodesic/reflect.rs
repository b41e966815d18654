//! Arrangements on the sphere, reflected through its center.

use super::{GeodesicArc, GeodesicTraits};
use crate::Arrangement;
use crate::arrangement::Parts;
use crate::topology::Sphere;
use dcel::{FaceId, HalfedgeId, VertexId};
use exact::spherical::{Direction, Meridian};
use std::cmp::Ordering;

const SOUTH: VertexId = VertexId(0);
const NORTH: VertexId = VertexId(1);

impl GeodesicTraits {
    /// The traits with the opposite identification.
    pub fn reflected(&self) -> Self {
        let [x, y, _] = self.identification().opposite().coordinates();
        Self { meridian: Meridian::new([x, y]).expect("an identification has a direction") }
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
        let corner_face = self.face_before_identification(NORTH);
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

    /// The face at a pole that is met last before the identification, counterclockwise seen from the north.
    fn face_before_identification(&self, pole: VertexId) -> FaceId {
        let dcel = self.dcel();
        if let Some(face) = dcel.isolated_face(pole) {
            return face;
        }
        let last = dcel.around(pole).max_by(|&a, &b| self.compare_meridians(a, b));
        let last = last.expect("a pole that is not isolated has edges");
        // Counterclockwise seen from outside is counterclockwise seen from the north at the north pole only.
        if pole == NORTH { dcel.face(last) } else { dcel.face(last.twin()) }
    }

    /// Compares the longitudes of edges that leave a pole.
    fn compare_meridians(&self, a: HalfedgeId, b: HalfedgeId) -> Ordering {
        let circle = |h: HalfedgeId| self.curve_of(h.edge_id()).circle();
        self.traits().meridian().compare_u_of_halves(circle(a), circle(b))
    }
}
