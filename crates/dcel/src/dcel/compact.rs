//! Making ids dense again.

use super::{CcbKind, Dcel, Face, Isolated, VertexCell, VertexState};
use crate::{CcbId, EdgeId, FaceId, HalfedgeId, VertexId};

/// The new ids that [`Dcel::compact`] gave.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Compaction {
    vertices: Vec<u32>,
    edges: Vec<u32>,
    ccbs: Vec<u32>,
    faces: Vec<u32>,
}

/// The new id of a cell; none for one that had been removed.
impl Compaction {
    /// The new id of a vertex.
    pub fn vertex(&self, old: VertexId) -> Option<VertexId> {
        look_up(&self.vertices, old.0).map(VertexId)
    }

    /// The new id of an edge.
    pub fn edge(&self, old: EdgeId) -> Option<EdgeId> {
        look_up(&self.edges, old.0).map(EdgeId)
    }

    /// The new id of a halfedge, even if the old one is.
    pub fn halfedge(&self, old: HalfedgeId) -> Option<HalfedgeId> {
        self.edge(old.edge_id()).map(|e| HalfedgeId(2 * e.0 + (old.0 & 1)))
    }

    /// The new id of a CCB.
    pub fn ccb(&self, old: CcbId) -> Option<CcbId> {
        look_up(&self.ccbs, old.0).map(CcbId)
    }

    /// The new id of a face.
    pub fn face(&self, old: FaceId) -> Option<FaceId> {
        look_up(&self.faces, old.0).map(FaceId)
    }
}

const REMOVED: u32 = u32::MAX;

fn look_up(map: &[u32], old: u32) -> Option<u32> {
    map.get(old as usize).copied().filter(|&new| new != REMOVED)
}

/// Numbers those that stay, in order.
fn number(stays: impl Iterator<Item = bool>) -> Vec<u32> {
    let mut count = 0;
    stays
        .map(|stays| {
            count += u32::from(stays);
            if stays { count - 1 } else { REMOVED }
        })
        .collect()
}

/// The new index of what an index, or none, names.
fn renamed(map: &[u32], old: u32) -> u32 {
    look_up(map, old).unwrap_or(u32::MAX)
}

fn keep<T>(cells: &mut Vec<T>, map: &[u32]) {
    let mut old = map.iter();
    cells.retain(|_| old.next().is_some_and(|&new| new != REMOVED));
    cells.shrink_to_fit();
}

impl Dcel {
    /// Makes the ids of each kind dense again, in the order that they have, and gives the memory of the
    /// removed cells back. Cells keep the order that they have in lists.
    ///
    /// # Complexity
    /// Linear.
    pub fn compact(&mut self) -> Compaction {
        let maps = Compaction {
            vertices: number((0..self.vertex_bound()).map(|v| self.has_vertex(VertexId::new(v)))),
            edges: number((0..self.edge_bound()).map(|e| self.has_edge(EdgeId::new(e)))),
            ccbs: number((0..self.ccb_bound()).map(|c| self.has_ccb(CcbId::new(c)))),
            faces: number((0..self.face_bound()).map(|f| self.has_face(FaceId::new(f)))),
        };
        let places = number(self.isolated.iter().map(|place| *place != Isolated::FREE));
        let halfedge = |h: HalfedgeId| maps.halfedge(h).unwrap_or(HalfedgeId::NONE);
        let face = |f: FaceId| FaceId(renamed(&maps.faces, f.0));

        let mut old = 0;
        self.halfedges.retain(|_| {
            old += 1;
            maps.edges[(old - 1) / 2] != REMOVED
        });
        self.halfedges.shrink_to_fit();
        for record in &mut self.halfedges {
            record.next = halfedge(record.next);
            record.prev = halfedge(record.prev);
            record.source = VertexId(renamed(&maps.vertices, record.source.0));
            record.ccb = CcbId(renamed(&maps.ccbs, record.ccb.0));
        }
        keep(&mut self.vertices, &maps.vertices);
        for cell in &mut self.vertices {
            match cell.state() {
                VertexState::Attached(h) => *cell = VertexCell(halfedge(h).0),
                VertexState::Isolated(place) => *cell = VertexCell::isolated(places[place as usize]),
                VertexState::Bare | VertexState::Free => {}
            }
        }
        keep(&mut self.ccbs, &maps.ccbs);
        for ccb in &mut self.ccbs {
            let links = ccb.links;
            *ccb = super::Ccb::new(halfedge(ccb.first), face(ccb.face()), ccb.kind());
            ccb.links.prev = renamed(&maps.ccbs, links.prev);
            ccb.links.next = renamed(&maps.ccbs, links.next);
        }
        keep(&mut self.isolated, &places);
        for place in &mut self.isolated {
            place.vertex = VertexId(renamed(&maps.vertices, place.vertex.0));
            place.face = face(place.face);
            place.links.prev = renamed(&places, place.links.prev);
            place.links.next = renamed(&places, place.links.next);
        }
        keep(&mut self.faces, &maps.faces);
        for face in &mut self.faces {
            for kind in [CcbKind::Outer, CcbKind::Inner] {
                *face.head_mut(kind) = renamed(&maps.ccbs, *face.head_mut(kind));
            }
            face.isolated = renamed(&places, face.isolated);
            debug_assert!(*face != Face::FREE, "free faces are gone");
        }
        for free in [
            &mut self.free_edges,
            &mut self.free_vertices,
            &mut self.free_ccbs,
            &mut self.free_faces,
            &mut self.free_isolated,
        ] {
            *free = Vec::new();
        }
        maps
    }
}
