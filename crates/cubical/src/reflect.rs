//! The map reflected through the center.

use crate::connected::{KnownEdge, of_connected};
use crate::map::{At, CubicalArrangement, CubicalFaceId, SideArrangement};
use crate::stitch::{Patch, stitch};
use arrangement::models::{Segment, SegmentTraits};
use arrangement::topology::BoundedPlane;
use arrangement::{Arrangement, Pieces};
use dcel::{EdgeId, FaceId, HalfedgeId, VertexId};
use exact::gnomonic::CubeSide;

impl CubicalArrangement {
    /// Makes the map in which every direction has become its antipodal one, and tells for each of its faces of which it is the image.
    ///
    /// The arrangement of a side comes to the opposite side, where (u, v) becomes (-v, -u).
    ///
    /// # Complexity
    /// O(n log n); six sweeps only where something is not connected with the edges of the cube.
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
        // For each edge of a new side, the halfedge of the old one of which that to the right along it is the image.
        let (patches, old_halfedges): (Vec<Patch>, Vec<Vec<HalfedgeId>>) = images.into_iter().unzip();
        let patches = <[Patch; 6]>::try_from(patches).expect("a cube has six sides");
        let map = stitch(patches);
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

    /// The image of the opposite side on this one; and for each of its edges the halfedge of which the one to the right along it is the image.
    fn image_on(&self, side: CubeSide) -> (Patch, Vec<HalfedgeId>) {
        let own = &self.sides[side.opposite().index()];
        let (arrangement, old_halfedges) = match is_connected(&own.arrangement) {
            true => connected_image(&own.arrangement),
            false => swept_image(&own.arrangement),
        };
        let (dcel, image) = (own.arrangement.dcel(), arrangement.dcel());
        let is_real_edge = old_halfedges.iter().map(|h| own.is_real_edge[h.edge()]).collect();
        let mut is_given = vec![false; image.vertex_bound()];
        for e in image.edges() {
            let old = old_halfedges[e.index()];
            let old_ends = [dcel.source(old), dcel.target(old)];
            for (v, old) in image.ends(e).into_iter().zip(old_ends) {
                is_given[v.index()] = own.is_real_vertex[old.index()];
            }
        }
        (Patch { arrangement, is_real_edge, is_given }, old_halfedges)
    }
}

/// Tells whether there are no gaps in the numbers of vertices and edges, and all edges are connected.
fn is_connected(arrangement: &SideArrangement) -> bool {
    let dcel = arrangement.dcel();
    let has_one_component = |f: FaceId| {
        let holes = usize::from(f == arrangement.corner_face());
        dcel.inner_ccbs(f).count() == holes && dcel.isolated_vertices(f).next().is_none()
    };
    dcel.vertex_count() == dcel.vertex_bound()
        && dcel.edge_count() == dcel.edge_bound()
        && dcel.faces().all(has_one_component)
}

/// The image of a segment, directed from the image of its lesser end.
fn image_of(segment: &Segment) -> Segment {
    let [min, max] = [segment.min(), segment.max()].map(CubeSide::antipodal_point);
    let line = CubeSide::antipodal_line(segment.line());
    Segment::on_line(line, min, max).expect("ends are different")
}

/// The image of an arrangement, read off its cells.
fn connected_image(own: &SideArrangement) -> (SideArrangement, Vec<HalfedgeId>) {
    let dcel = own.dcel();
    let point = |v| own.point(v).expect("in the bounded plane every vertex has a point");
    let points =
        (0..dcel.vertex_bound()).map(|v| CubeSide::antipodal_point(point(VertexId::new(v)))).collect();
    let curves: Vec<Segment> = own.curves().iter().map(image_of).collect();
    let mut edges = Vec::with_capacity(dcel.edge_count());
    let mut old_halfedges = Vec::with_capacity(dcel.edge_count());
    for e in dcel.edges() {
        let support = own.support(e);
        let is_right = curves[support.index()].is_directed_right();
        let h = if is_right { e.halfedge() } else { e.halfedge().twin() };
        edges.push(KnownEdge { support: support.0, ends: [dcel.source(h).0, dcel.target(h).0] });
        old_halfedges.push(h);
    }
    (of_connected(points, curves, &edges).0, old_halfedges)
}

/// The image of an arrangement, by a sweep.
fn swept_image(own: &SideArrangement) -> (SideArrangement, Vec<HalfedgeId>) {
    let dcel = own.dcel();
    let point = |v: VertexId| {
        CubeSide::antipodal_point(own.point(v).expect("in the bounded plane every vertex has a point"))
    };
    let mut pieces = Pieces::new();
    let mut sources = Vec::with_capacity(dcel.edge_count());
    for e in dcel.edges() {
        let [min, max] = dcel.ends(e);
        let line = CubeSide::antipodal_line(own.curve_of(e).line());
        let segment = Segment::on_line(line, point(min), point(max)).expect("ends are different");
        sources.push(if segment.is_directed_right() { e.halfedge() } else { e.halfedge().twin() });
        pieces.push_curve(segment);
    }
    dcel.faces().flat_map(|f| dcel.isolated_vertices(f)).for_each(|v| pieces.push_point(point(v)));
    let image: SideArrangement = Arrangement::of_pieces(SegmentTraits, BoundedPlane, pieces);
    let edges = 0..image.dcel().edge_bound();
    let old_halfedges = edges.map(|e| sources[image.support(EdgeId::new(e)).index()]).collect();
    (image, old_halfedges)
}
