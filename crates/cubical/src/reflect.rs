//! The map reflected through the center.

use crate::map::{At, CubicalArrangement, Side};
use arrangement::models::{Segment, SegmentTraits};
use arrangement::topology::BoundedPlane;
use arrangement::{Arrangement, Parts};
use dcel::VertexId;
use exact::gnomonic::CubeSide;

impl CubicalArrangement {
    /// Makes the map in which every direction has become its antipodal one, without a sweep.
    ///
    /// The arrangement of a side comes to the opposite side, where (u, v) becomes (-v, -u). All ids stay as they are, those of the faces of the sphere, too.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// ```
    /// use arrangement::models::Geodesic;
    /// use exact::spherical::Direction;
    /// use splitstar_cubical::{CubicalArrangement, CubicalCell, CubicalPieces};
    /// let [p, q, r] = [[3, 1, 0], [1, 3, 0], [1, 1, 9]].map(|p| Direction::from_i64(p).expect("not zero"));
    /// let mut pieces = CubicalPieces::new();
    /// for (p, q) in [(&p, &q), (&q, &r), (&r, &p)] {
    ///     pieces.push_geodesic(&Geodesic::arc(p.clone(), q.clone())?);
    /// }
    /// let map = CubicalArrangement::of_pieces(pieces);
    /// let reflected = map.reflected();
    /// let inside = Direction::from_i64([1, 1, 1]).expect("not zero");
    /// let (CubicalCell::Face(before), CubicalCell::Face(after)) = (map.locate(&inside), reflected.locate(&inside.opposite())) else { panic!("it is inside") };
    /// assert_eq!(after, before);
    /// assert!(matches!(reflected.locate(&r.opposite()), CubicalCell::Vertex(_)));
    /// # Ok::<(), arrangement::models::GeodesicError>(())
    /// ```
    pub fn reflected(&self) -> Self {
        let first_part = self.first_part.iter().map(|&part| opposite(part)).collect();
        let sides = CubeSide::ALL.map(|side| self.image_on(side));
        Self { sides, face_count: self.face_count, first_part }
    }

    /// The image of the opposite side on this one.
    fn image_on(&self, side: CubeSide) -> Side {
        let from = side.opposite();
        let own = &self.sides[from.index()];
        let next_copy = (0..own.next_copy.len()).map(|v| {
            // What was clockwise is counterclockwise.
            let v = At { side: from, id: VertexId::new(v) };
            self.next_copy(v)?;
            self.copies(v).last().map(opposite)
        });
        let [low, left, right, high] = own.corners;
        Side {
            arrangement: image_of(&own.arrangement),
            is_real_vertex: own.is_real_vertex.clone(),
            is_real_edge: own.is_real_edge.clone(),
            next_copy: next_copy.collect(),
            across: own.across.iter().map(|across| across.map(opposite)).collect(),
            corners: [high, left, right, low],
            faces: own.faces.clone(),
        }
    }
}

fn opposite<T>(cell: At<T>) -> At<T> {
    At { side: cell.side.opposite(), id: cell.id }
}

/// The image of the arrangement of a side, on the opposite side.
fn image_of(own: &crate::SideArrangement) -> crate::SideArrangement {
    let parts = own.clone().into_parts();
    let curves: Vec<Segment> = parts.curves.iter().map(image_of_segment).collect();
    let mut dcel = parts.dcel.mirrored();
    // The segments are directed from the images of what were their lesser ends.
    dcel.turn_edges(|e| {
        parts.supports.get(e.index()).is_some_and(|&support| !curves[support as usize].is_directed_right())
    });
    let points = parts.points.into_iter().map(|p| p.as_ref().map(CubeSide::antipodal_point)).collect();
    let parts = Parts { dcel, points, curves, ..parts };
    Arrangement::from_trusted_parts(SegmentTraits, BoundedPlane, parts)
}

/// The image of a segment, directed from the image of its lesser end.
fn image_of_segment(segment: &Segment) -> Segment {
    let [min, max] = [segment.min(), segment.max()].map(CubeSide::antipodal_point);
    let line = CubeSide::antipodal_line(segment.line());
    Segment::on_line(line, min, max).expect("ends are different")
}
