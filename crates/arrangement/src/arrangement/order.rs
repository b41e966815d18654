//! One order of all cells, which does not depend on how the arrangement was made.

use super::Arrangement;
use crate::topology::{Site, Topology};
use crate::traits::UMonotoneTraits;
use dcel::{EdgeId, FaceId, HalfedgeId, VertexId};

/// The cells of an arrangement in an order that the geometry gives: see [`Arrangement::cell_order`].
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CellOrder {
    /// The vertices that are points.
    pub vertices: Vec<VertexId>,
    /// The edges.
    pub edges: Vec<EdgeId>,
    /// The first halfedge of each CCB.
    pub ccbs: Vec<HalfedgeId>,
    /// The faces.
    pub faces: Vec<FaceId>,
}

impl<G: UMonotoneTraits, T: Topology<G>> Arrangement<G, T> {
    /// Puts all cells in an order that depends on the cells only: not on ids, and not on the order in which curves were inserted.
    ///
    /// Vertices come as a sweep meets them, and each edge with its min vertex, where edges with one min vertex are in counterclockwise
    /// order: those to the right of it from bottom to top. Edges that come from infinity are before all others. Halfedges are in the
    /// order of their edges, the one that runs from the max to the min vertex first; a CCB begins with its first halfedge. The
    /// [corner face](Arrangement::corner_face) is the first one, the others are in the order of their first halfedges.
    ///
    /// # Complexity
    /// O(n log n).
    pub fn cell_order(&self) -> CellOrder {
        let mut vertices: Vec<VertexId> = self.vertices().collect();
        vertices.sort_by(|&v, &w| match [v, w].map(|v| self.point(v)) {
            [Some(p), Some(q)] => {
                let site = |point| Site::of_point(&self.topology, &self.traits, point);
                self.topology.compare_sites(&self.traits, &site(p), &site(q))
            }
            _ => v.cmp(&w),
        });
        let rising = |v: VertexId| self.dcel.around(v).filter(|h| h.is_even());
        let special = self.dcel.vertices().filter(|&v| self.is_at_infinity(v));
        let mut from_sides: Vec<HalfedgeId> = special.flat_map(rising).collect();
        from_sides.sort_by(|&g, &h| {
            self.topology.compare_sites(&self.traits, &self.start_site(g), &self.start_site(h))
        });
        let mut edges: Vec<EdgeId> = from_sides.into_iter().map(HalfedgeId::edge_id).collect();
        let mut around = Vec::new();
        for &v in &vertices {
            around.clear();
            around.extend(rising(v));
            around.sort_by(|&g, &h| self.compare_around(g, h));
            edges.extend(around.iter().map(|h| h.edge_id()));
        }
        let mut is_ccb_seen = vec![false; self.dcel.ccb_bound()];
        let mut is_face_seen = vec![false; self.dcel.face_bound()];
        let mut ccbs = Vec::with_capacity(self.dcel.ccb_count());
        let mut faces = Vec::with_capacity(self.dcel.face_count());
        let corner = self.corner_face();
        is_face_seen[corner.index()] = true;
        faces.push(corner);
        for h in edges.iter().flat_map(|e| [e.halfedge().twin(), e.halfedge()]) {
            let ccb = self.dcel.ccb(h);
            if std::mem::replace(&mut is_ccb_seen[ccb.index()], true) {
                continue;
            }
            ccbs.push(h);
            let face = self.dcel.ccb_face(ccb);
            if !std::mem::replace(&mut is_face_seen[face.index()], true) {
                faces.push(face);
            }
        }
        CellOrder { vertices, edges, ccbs, faces }
    }
}
