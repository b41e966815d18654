//! The map reflected through the center.

use crate::map::{At, CubicalArrangement, CubicalFaceId, SideArrangement};
use crate::stitch::{Patch, stitch};
use arrangement::models::{Segment, SegmentTraits};
use arrangement::topology::BoundedPlane;
use arrangement::{Arrangement, Pieces};
use dcel::{EdgeId, HalfedgeId, VertexId};
use exact::gnomonic::CubeSide;
use exact::planar::Point2;

impl CubicalArrangement {
    /// Makes the map in which every direction has become its antipodal one, and tells for each of its faces of which it is the image.
    ///
    /// The arrangement of a side comes to the opposite side, where (u, v) becomes (-v, -u).
    ///
    /// # Complexity
    /// That of six sweeps over edges that do not meet: O(n log n).
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
    /// let (reflected, images) = map.reflected();
    /// let inside = Direction::from_i64([1, 1, 1]).expect("not zero");
    /// let (CubicalCell::Face(before), CubicalCell::Face(after)) = (map.locate(&inside), reflected.locate(&inside.opposite())) else { panic!("it is inside") };
    /// assert_eq!(images[after.index()], before);
    /// assert!(matches!(reflected.locate(&r.opposite()), CubicalCell::Vertex(_)));
    /// # Ok::<(), arrangement::models::GeodesicError>(())
    /// ```
    pub fn reflected(&self) -> (Self, Vec<CubicalFaceId>) {
        let images = CubeSide::ALL.map(|side| self.image_on(side));
        // For each edge of a new side, its halfedge and the old one of which that is the image.
        let old_halfedges = images.each_ref().map(|(patch, sources)| {
            let edges = 0..patch.arrangement.dcel().edge_bound();
            edges
                .map(|e| sources[patch.arrangement.support(EdgeId::new(e)).index()])
                .collect::<Vec<HalfedgeId>>()
        });
        let map = stitch(images.map(|(patch, _)| patch));
        let faces = map
            .faces()
            .map(|face| {
                let part = map.part(face);
                let dcel = map.side(part.side).dcel();
                let ccb = dcel.first_ccb(part.id).expect("a face of a side has a boundary");
                let h = dcel.ccb_halfedge(ccb);
                let old = old_halfedges[part.side.index()][h.edge()];
                let old = if h.is_even() { old } else { old.twin() };
                // What was on the right is on the left.
                self.face(At { side: part.side.opposite(), id: old.twin() })
            })
            .collect();
        (map, faces)
    }

    /// The image of the opposite side on this one; and for each of its curves, which are as many as edges, the halfedge of which the one to the right
    /// along it is the image.
    fn image_on(&self, side: CubeSide) -> (Patch, Vec<HalfedgeId>) {
        let from = side.opposite();
        let own = &self.sides[from.index()];
        let dcel = own.arrangement.dcel();
        let points: Vec<Option<Point2>> = (0..dcel.vertex_bound())
            .map(|v| own.arrangement.point(VertexId::new(v)).map(CubeSide::antipodal_point))
            .collect();
        let point =
            |v: VertexId| points[v.index()].clone().expect("an opposite point lies on the opposite side");
        let mut pieces = Pieces::new();
        let mut sources = Vec::with_capacity(dcel.edge_count());
        for e in dcel.edges() {
            let [min, max] = dcel.ends(e);
            let line = CubeSide::antipodal_line(own.arrangement.curve_of(e).line());
            let segment = Segment::on_line(line, point(min), point(max)).expect("ends are different");
            sources.push(if segment.is_directed_right() { e.halfedge() } else { e.halfedge().twin() });
            pieces.push_curve(segment);
        }
        dcel.faces().flat_map(|f| dcel.isolated_vertices(f)).for_each(|v| pieces.push_point(point(v)));
        let arrangement: SideArrangement = Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces);
        let image = arrangement.dcel();
        let mut is_real_edge = vec![false; image.edge_bound()];
        let mut is_given = vec![false; image.vertex_bound()];
        for e in image.edges() {
            let old = sources[arrangement.support(e).index()];
            is_real_edge[e.index()] = own.is_real_edge[old.edge()];
            let old_ends = [dcel.source(old), dcel.target(old)];
            for (v, old) in image.ends(e).into_iter().zip(old_ends) {
                is_given[v.index()] = own.is_real_vertex[old.index()];
            }
        }
        (Patch { arrangement, is_real_edge, is_given }, sources)
    }
}
