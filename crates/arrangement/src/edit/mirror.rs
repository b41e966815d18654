//! A copy of an arrangement that is kept by what an observer is told, and by nothing else.

use super::apply::Cells;
use super::{Done, EditOf, Observer, Stale, Stamp};
use crate::arrangement::{Arrangement, CurveId, Parts};
use crate::topology::Topology;
use crate::traits::BasicTraits;
use dcel::{CcbId, Dcel, EdgeId, FaceId, HalfedgeId, VertexId};

/// Keeps a copy of the cells of an arrangement, and all changes of it.
///
/// Cells are read from the arrangement only where that is meant: when the mirror is made, and when all was replaced. So a difference
/// shows that something was changed and not told.
///
/// # Complexity
/// That of the edits; linear when all is replaced.
#[derive(Clone, Debug)]
pub struct Mirror<G: BasicTraits> {
    parts: Parts<G>,
    stamp: Stamp,
    has_lost_track: bool,
}

/// In what a mirror differs from the arrangement.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum MirrorDifference {
    /// The mirror missed a change, or an edit made another cell there than here.
    Track,
    /// A vertex: it is on one side only, or differs in its point, what it is attached to, or its mark.
    Vertex(VertexId),
    /// A halfedge: it is on one side only, or has other neighbours.
    Halfedge(HalfedgeId),
    /// An edge: its support.
    Support(EdgeId),
    /// A CCB: it is on one side only, or has another kind or face.
    Ccb(CcbId),
    /// A face: it is on one side only, or has other CCBs or isolated vertices, or in another order.
    Face(FaceId),
    /// A curve: it is on one side only, or is another one.
    Curve(CurveId),
    /// Another face is the corner face.
    CornerFace,
}

impl<G: BasicTraits> Mirror<G> {
    /// Copies an arrangement.
    pub fn new<T: Topology<G>>(arrangement: &Arrangement<G, T>) -> Self {
        Self { parts: copy(arrangement), stamp: arrangement.stamp(), has_lost_track: false }
    }

    /// The copy.
    pub fn parts(&self) -> &Parts<G> {
        &self.parts
    }

    /// Tells whether the copy is what the arrangement is, ids and order of lists included.
    ///
    /// # Complexity
    /// Linear.
    pub fn equals<T: Topology<G>>(&self, arrangement: &Arrangement<G, T>) -> bool
    where
        G::UMonotoneCurve: PartialEq,
    {
        self.difference(arrangement, |a, b| a == b).is_none()
    }

    /// Tells in what the copy differs from the arrangement; `None` if it is the same. `is_same_curve` compares curves.
    ///
    /// # Complexity
    /// Linear.
    pub fn difference<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        is_same_curve: impl Fn(&G::UMonotoneCurve, &G::UMonotoneCurve) -> bool,
    ) -> Option<MirrorDifference> {
        use MirrorDifference as D;
        if self.has_lost_track || self.stamp != arrangement.stamp() {
            return Some(D::Track);
        }
        let (mine, theirs) = (&self.parts, arrangement);
        if let Some(difference) = difference_of_cells(&mine.dcel, &theirs.dcel) {
            return Some(difference);
        }
        if mine.corner_face != theirs.corner_face {
            return Some(D::CornerFace);
        }
        let is_same_vertex = |v: VertexId| {
            let is_same_point = match (&mine.points[v.index()], &theirs.points[v.index()]) {
                (Some(p), Some(q)) => theirs.traits.is_same_point(p, q),
                (None, None) => true,
                _ => false,
            };
            is_same_point && mine.is_artificial[v.index()] == theirs.is_artificial[v.index()]
        };
        if let Some(v) = mine.dcel.vertices().find(|&v| !is_same_vertex(v)) {
            return Some(D::Vertex(v));
        }
        if let Some(e) = mine.dcel.edges().find(|e| mine.supports[e.index()] != theirs.supports[e.index()]) {
            return Some(D::Support(e));
        }
        let (few, many) =
            (mine.curves.len().min(theirs.curves.len()), mine.curves.len().max(theirs.curves.len()));
        let is_same = |i: &usize| *i < few && is_same_curve(&mine.curves[*i], &theirs.curves[*i]);
        let other = (0..many).find(|i| !is_same(i));
        other.map(|i| D::Curve(CurveId(u32::try_from(i).expect("there are fewer than 2^32 curves"))))
    }
}

fn copy<G: BasicTraits, T>(arrangement: &Arrangement<G, T>) -> Parts<G> {
    let Arrangement { dcel, points, is_artificial, curves, supports, corner_face, .. } = arrangement;
    Parts {
        dcel: dcel.clone(),
        points: points.clone(),
        is_artificial: is_artificial.clone(),
        curves: curves.clone(),
        supports: supports.clone(),
        corner_face: *corner_face,
    }
}

/// The first difference between two structures.
pub(super) fn difference_of_cells(a: &Dcel, b: &Dcel) -> Option<MirrorDifference> {
    use MirrorDifference as D;
    let up_to = |bound: fn(&Dcel) -> usize| 0..bound(a).max(bound(b));
    let vertex = |d: &Dcel, v| d.has_vertex(v).then(|| (d.outgoing(v), d.isolated_face(v)));
    let halfedge = |d: &Dcel, h| d.has_halfedge(h).then(|| (d.next(h), d.prev(h), d.source(h), d.ccb(h)));
    let ccb = |d: &Dcel, c| d.has_ccb(c).then(|| (d.ccb_kind(c), d.ccb_face(c), d.ccb_halfedge(c)));
    let face = |d: &Dcel, f| {
        let has = d.has_face(f);
        has.then(|| (d.face_ccbs(f).collect::<Vec<_>>(), d.isolated_vertices(f).collect::<Vec<_>>()))
    };
    let vertices = up_to(Dcel::vertex_bound).map(VertexId::new);
    let halfedges = up_to(Dcel::halfedge_bound).map(HalfedgeId::new);
    let ccbs = up_to(Dcel::ccb_bound).map(CcbId::new);
    let faces = up_to(Dcel::face_bound).map(FaceId::new);
    vertices
        .into_iter()
        .find(|&v| vertex(a, v) != vertex(b, v))
        .map(D::Vertex)
        .or_else(|| halfedges.into_iter().find(|&h| halfedge(a, h) != halfedge(b, h)).map(D::Halfedge))
        .or_else(|| ccbs.into_iter().find(|&c| ccb(a, c) != ccb(b, c)).map(D::Ccb))
        .or_else(|| faces.into_iter().find(|&f| face(a, f) != face(b, f)).map(D::Face))
}

impl<G: BasicTraits, T: Topology<G>> Observer<G, T> for Mirror<G> {
    fn before(&mut self, arrangement: &Arrangement<G, T>, _: &EditOf<G>) {
        self.has_lost_track |= self.stamp != arrangement.stamp();
    }

    fn after(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
        if !self.has_lost_track {
            self.has_lost_track = Cells::of(&mut self.parts).change(edit) != *done;
            self.stamp = arrangement.stamp();
        }
    }

    fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
        *self = Self::new(arrangement);
    }

    fn check_stamp(&self, stamp: Stamp) -> Result<(), Stale> {
        Stale::check(self.stamp, stamp)
    }
}
