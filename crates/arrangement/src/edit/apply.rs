//! The one place where cells of an arrangement change.

use super::{Done, Edit, EditOf, Observer, Stamp};
use crate::arrangement::{Arrangement, CurveId, Parts};
use crate::topology::Topology;
use crate::traits::{BasicTraits, CurveEnd};
use dcel::{CcbKind, CcbSplit, Dcel, EdgeId, EndFate, FaceId, Side, VertexId};

impl<G: BasicTraits, T: Topology<G>> Arrangement<G, T> {
    /// Makes a primitive change, and tells the observer before and after.
    ///
    /// # Panics
    /// If the cells that the edit names are not as it says.
    ///
    /// # Complexity
    /// That of the same change of a [`Dcel`].
    pub(crate) fn apply<O: Observer<G, T> + ?Sized>(&mut self, edit: EditOf<G>, observer: &mut O) -> Done {
        observer.before(self, &edit);
        let cells = Cells {
            dcel: &mut self.dcel,
            points: &mut self.points,
            is_artificial: &mut self.is_artificial,
            curves: &mut self.curves,
            supports: &mut self.supports,
            corner_face: &mut self.corner_face,
        };
        let done = cells.change(&edit);
        self.stamp = Stamp::fresh();
        observer.after(self, &edit, &done);
        done
    }

    /// Replaces all, and tells the observer before and after.
    pub(crate) fn apply_global<O: Observer<G, T> + ?Sized, R>(
        &mut self,
        observer: &mut O,
        change: impl FnOnce(&mut Self) -> R,
    ) -> R {
        observer.before_global(self);
        let result = change(self);
        self.stamp = Stamp::fresh();
        observer.after_global(self);
        result
    }
}

/// What changes, wherever it is kept.
pub(super) struct Cells<'a, P, C> {
    dcel: &'a mut Dcel,
    points: &'a mut Vec<Option<P>>,
    is_artificial: &'a mut Vec<bool>,
    curves: &'a mut Vec<C>,
    supports: &'a mut Vec<u32>,
    corner_face: &'a mut FaceId,
}

impl<'a, P: Clone, C: Clone> Cells<'a, P, C> {
    pub(super) fn of<G: BasicTraits<Point = P, UMonotoneCurve = C>>(parts: &'a mut Parts<G>) -> Self {
        let Parts { dcel, points, is_artificial, curves, supports, corner_face } = parts;
        Self { dcel, points, is_artificial, curves, supports, corner_face }
    }

    /// Makes a primitive change.
    pub(super) fn change(mut self, edit: &Edit<P, C>) -> Done {
        match *edit {
            Edit::AddVertex { ref point, is_artificial } => {
                let v = self.dcel.add_vertex();
                self.set_vertex(v, point, is_artificial)
            }
            Edit::AddIsolatedVertex { ref point, is_artificial, face } => {
                let v = self.dcel.add_isolated_vertex(face);
                self.set_vertex(v, point, is_artificial)
            }
            Edit::SetPoint { v, ref point } => {
                self.points[v.index()] = Some(point.clone());
                Done::Changed
            }
            Edit::SetArtificial { v, is_artificial } => {
                self.is_artificial[v.index()] = is_artificial;
                Done::Changed
            }
            Edit::AddCurve { ref curve } => {
                let id = u32::try_from(self.curves.len()).expect("there are fewer than 2^32 curves");
                self.curves.push(curve.clone());
                Done::Curve(CurveId(id))
            }
            Edit::SetSupport { e, curve } => {
                self.supports[e.index()] = curve.0;
                Done::Changed
            }
            Edit::SplitEdge { e, v, kept } => {
                let new = self.split_edge(e, v, kept);
                self.set_support(new, CurveId(self.supports[e.index()]))
            }
            Edit::MergeEdges { kept, v } => Done::Merged(self.merge_edges(kept, v)),
            Edit::RemoveEdge { e, ends, survivor } => {
                for (v, fate) in self.dcel.ends(e).into_iter().zip(ends) {
                    let stays = fate == EndFate::Isolate || self.points[v.index()].is_some();
                    assert!(stays, "a vertex that stands for a side is not removed");
                }
                let faces = [Side::Even, Side::Odd].map(|side| self.dcel.face(e.half(side)));
                let (kept, gone) = match survivor {
                    Side::Even => (faces[0], faces[1]),
                    Side::Odd => (faces[1], faces[0]),
                };
                self.check_gone(kept, gone);
                Done::Removed(self.dcel.remove_edge(e, ends, survivor))
            }
            Edit::InsertEdgeInFace { support, .. }
            | Edit::InsertLoop { support, .. }
            | Edit::InsertEdgeFrom { support, .. }
            | Edit::InsertEdgeTo { support, .. }
            | Edit::InsertEdgeBetween { support, .. }
            | Edit::InsertEdgeJoining { support, .. } => {
                let e = self.insert_edge(edit);
                self.set_support(e, support)
            }
            Edit::RemoveIsolatedVertex { .. }
            | Edit::SplitFace { .. }
            | Edit::MergeFaces { .. }
            | Edit::MoveCcb { .. }
            | Edit::MoveIsolatedVertex { .. }
            | Edit::SetCornerFace { .. }
            | Edit::SetCcbKind { .. } => self.change_lists(edit),
        }
    }

    fn set_vertex(&mut self, v: VertexId, point: &P, is_artificial: bool) -> Done {
        let bound = self.points.len().max(self.dcel.vertex_bound());
        self.points.resize(bound, None);
        self.is_artificial.resize(bound, false);
        self.points[v.index()] = Some(point.clone());
        self.is_artificial[v.index()] = is_artificial;
        Done::Vertex(v)
    }

    fn set_support(&mut self, e: EdgeId, support: CurveId) -> Done {
        self.supports.resize(self.supports.len().max(self.dcel.edge_bound()), 0);
        self.supports[e.index()] = support.0;
        Done::Edge(e)
    }

    fn insert_edge(&mut self, edit: &Edit<P, C>) -> EdgeId {
        match *edit {
            Edit::InsertEdgeInFace { ends: [min, max], face, kind, .. } => {
                self.dcel.insert_edge_in_face(min, max, face, kind)
            }
            Edit::InsertLoop { v, face, kinds, .. } => self.dcel.insert_loop(v, face, unsplit(kinds)),
            Edit::InsertEdgeFrom { prev, v, .. } => self.dcel.insert_edge_from(prev, v),
            Edit::InsertEdgeTo { v, prev, .. } => self.dcel.insert_edge_to(v, prev),
            Edit::InsertEdgeBetween { prevs, is_reversed, .. } => {
                let kind = self.dcel.ccb_kind(self.dcel.ccb(prevs[0]));
                let e = self.dcel.insert_edge_between(prevs[0], prevs[1], unsplit([kind; 2]));
                if is_reversed {
                    self.dcel.reverse_edge(e);
                }
                e
            }
            Edit::InsertEdgeJoining { prevs, kind, .. } => {
                self.dcel.insert_edge_joining(prevs[0], prevs[1], kind)
            }
            _ => unreachable!("no other edit inserts an edge"),
        }
    }

    fn change_lists(&mut self, edit: &Edit<P, C>) -> Done {
        match *edit {
            Edit::RemoveIsolatedVertex { v } => {
                let is_point = self.points[v.index()].is_some();
                assert!(is_point, "a vertex that stands for a side is not removed");
                self.dcel.remove_isolated_vertex(v);
            }
            Edit::SplitFace { ccb } => return Done::Face(self.dcel.split_face(ccb)),
            Edit::MergeFaces { kept, gone } => {
                self.check_gone(kept, gone);
                self.dcel.merge_faces(kept, gone);
            }
            Edit::SetCornerFace { face } => {
                assert!(self.dcel.has_face(face), "only a face becomes the corner face");
                *self.corner_face = face;
            }
            Edit::MoveCcb { ccb, face } => self.dcel.move_ccb(ccb, face),
            Edit::MoveIsolatedVertex { v, face } => self.dcel.move_isolated_vertex(v, face),
            Edit::SetCcbKind { ccb, kind } => self.dcel.set_ccb_kind(ccb, kind),
            _ => unreachable!("no other edit changes lists only"),
        }
        Done::Changed
    }

    fn check_gone(&self, kept: FaceId, gone: FaceId) {
        assert!(kept == gone || gone != *self.corner_face, "the corner face does not go");
    }

    /// Splits an edge; the part at the end `kept` keeps the id.
    fn split_edge(&mut self, e: EdgeId, v: VertexId, kept: CurveEnd) -> EdgeId {
        if kept == CurveEnd::Min {
            return self.dcel.split_edge(e, v);
        }
        self.dcel.reverse_edge(e);
        let new = self.dcel.split_edge(e, v);
        self.dcel.reverse_edge(e);
        self.dcel.reverse_edge(new);
        new
    }

    fn merge_edges(&mut self, kept: EdgeId, v: VertexId) -> EdgeId {
        let h = kept.halfedge();
        let h = if self.dcel.target(h) == v { h } else { h.twin() };
        assert!(self.dcel.next(h).is_even() == h.is_even(), "u grows from one edge to the other");
        self.dcel.merge_edges(kept, v)
    }
}

/// Two CCBs of one face.
fn unsplit(kinds: [CcbKind; 2]) -> CcbSplit {
    CcbSplit { kinds, new_face: None }
}
