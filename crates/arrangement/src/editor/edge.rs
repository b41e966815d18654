//! An edge comes, and what becomes of the face.

use super::Editor;
use super::place::At;
use super::rotation::Corners;
use crate::arrangement::CurveId;
use crate::edit::{Edit, Observer, SettledInsertion};
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use crate::trapezoids::{NewRail, TrapezoidId};
use dcel::{CcbKind, EdgeId, Side};

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Inserts an edge along a curve from one vertex to another. Between them it meets nothing; `first` is the trapezoid in which
    /// it begins.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids through which the edge runs, and in the length of the shorter CCB that arises. If a face is
    /// split that has other CCBs or isolated vertices besides, or the corner, also linear in the number of trapezoids of the smaller part.
    pub(super) fn insert_edge(
        &mut self,
        support: CurveId,
        [min, max]: [At; 2],
        first: TrapezoidId,
    ) -> EdgeId {
        // A vertex may have been made in it since it was found.
        let first = self.trapezoids.first_part(first);
        let dcel = self.arrangement.dcel();
        let is_alone = [min, max].iter().all(|at| dcel.outgoing(at.v).is_none());
        let face = is_alone.then(|| self.trapezoids.face_of(&self.arrangement, first));
        let sites = [min.site, max.site];
        let new = self.trapezoids.insert_rail(&self.arrangement, support.0, sites, first);
        let Corners { prevs, is_reversed } = self.corners(&new, [min.v, max.v]);
        let (dcel, kind) = (self.arrangement.dcel(), CcbKind::Inner);
        let edit = match (prevs, face) {
            ([None, None], Some(face)) if min.v == max.v => {
                Edit::InsertLoop { v: min.v, face, kinds: [kind; 2], support }
            }
            ([None, None], Some(face)) => {
                Edit::InsertEdgeInFace { ends: [min.v, max.v], face, kind, support }
            }
            ([None, None], None) => unreachable!("a vertex with edges has a corner for another one"),
            ([Some(prev), None], _) => Edit::InsertEdgeFrom { prev, v: max.v, support },
            ([None, Some(prev)], _) => Edit::InsertEdgeTo { v: min.v, prev, support },
            ([Some(a), Some(b)], _) if dcel.ccb(a) == dcel.ccb(b) => {
                Edit::InsertEdgeBetween { prevs: [a, b], is_reversed, support }
            }
            ([Some(a), Some(b)], _) => {
                let kind = self.arrangement.joined_kind([a, b]);
                Edit::InsertEdgeJoining { prevs: [a, b], kind, support }
            }
        };
        let e = self.arrangement.apply(edit, &mut self.observers).edge();
        self.trapezoids.set_edge(new.rail, e);
        let settled = self.arrangement.settle_insertion(e, &mut self.observers);
        if settled.splits_face {
            self.split_face(e, &new, settled);
        }
        e
    }

    /// Splits the face at a new edge, and moves what lies in the smaller part, which becomes the new face.
    fn split_face(&mut self, e: EdgeId, new: &NewRail, settled: SettledInsertion) {
        let dcel = self.arrangement.dcel();
        let face = dcel.face(e.halfedge());
        let has_more = dcel.face_ccbs(face).nth(2).is_some() || dcel.isolated_vertices(face).next().is_some();
        let sides = [Side::Odd, Side::Even];
        let is_corner = face == self.arrangement.corner_face();
        let (side, part) = if !has_more && !is_corner {
            (settled.shorter, Vec::new())
        } else {
            let (smaller, part) = self.trapezoids.smaller_part(&self.arrangement, new.first);
            (sides[smaller], part)
        };
        let is_at_corner = |t: &TrapezoidId| self.trapezoids.trapezoid(*t).left.is_none();
        let takes_corner = is_corner && part.iter().any(is_at_corner);
        let ccbs = [Side::Even, Side::Odd].map(|side| dcel.ccb(e.half(side)));
        let ccb = dcel.ccb(e.half(side));
        let contents = self.trapezoids.contents(&self.arrangement, &part);
        let face = self.arrangement.apply(Edit::SplitFace { ccb }, &mut self.observers).face();
        if takes_corner {
            self.arrangement.apply(Edit::SetCornerFace { face }, &mut self.observers);
        }
        for ccb in contents.ccbs.into_iter().filter(|ccb| !ccbs.contains(ccb)) {
            self.arrangement.apply(Edit::MoveCcb { ccb, face }, &mut self.observers);
        }
        for v in contents.isolated {
            self.arrangement.apply(Edit::MoveIsolatedVertex { v, face }, &mut self.observers);
        }
    }
}
