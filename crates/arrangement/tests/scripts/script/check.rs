//! What has to hold after each step.

use super::draw::Draw;
use super::drawn::{Drawn, Made, PieceOf, PointOf};
use super::steps::World;
use dcel::{EdgeId, FaceId, HalfedgeId, VertexId};
use splitstar_arrangement::locate_by_sweep;
use splitstar_arrangement::overlay::Cell;

impl<F: Drawn> World<F> {
    /// Checks the arrangement, the mirror, and where some points are found.
    pub(super) fn check(&self, draw: &mut Draw<'_>) {
        let arrangement = self.editor.arrangement();
        assert_eq!(arrangement.check_valid(), []);
        let is_same = |a: &PieceOf<F>, b: &PieceOf<F>| {
            self.family.strokes(a) == self.family.strokes(b) && self.family.labels(a) == self.family.labels(b)
        };
        assert_eq!(self.editor.observers().1.difference(arrangement, is_same), None, "the mirror");
        let mut points: Vec<PointOf<F>> = (0..3).map(|_| self.family.point(draw)).collect();
        for _ in 0..2 {
            points.extend(draw.choose(&self.vertices()).and_then(|v| arrangement.point(v).cloned()));
            points.extend(draw.choose(&self.edges()).and_then(|e| self.inner_point(e, draw)));
        }
        let cells = locate_by_sweep(arrangement, &points);
        let scanned = self.family.scan(arrangement, &points);
        for ((point, &cell), expected) in points.iter().zip(&cells).zip(scanned) {
            assert_eq!(self.editor.locate(point), cell, "at {point}, against one sweep");
            if let Some(expected) = expected {
                assert_eq!(cell, expected, "at {point}, one sweep against a scan");
            }
        }
        self.check_rays(&points, &cells);
    }

    /// A place in the interior of an edge.
    pub(super) fn inner_point(&self, e: EdgeId, draw: &mut Draw<'_>) -> Option<PointOf<F>> {
        self.family.inner_point(&self.editor.arrangement().make_edge_curve(e), draw)
    }
}

/// Checks that two arrangements are the same, but for ids; and that their edges carry the same.
pub(super) fn assert_alike<F: Drawn>(family: &F, found: &Made<F>, expected: &Made<F>) {
    assert_eq!(found.difference(expected), None);
    assert_eq!(found.counts(), expected.counts());
    assert_eq!(found.counts_with_splits(), expected.counts_with_splits());
    if found.dcel().edges().any(|e| !family.labels(found.curve_of(e)).is_empty()) {
        assert_eq!(labels(family, found), labels(family, expected));
    }
}

/// The ends of an edge; `None` where it has none.
type EndsOf<F> = [Option<<F as Drawn>::Place>; 2];

/// What the edges carry, with their ends.
fn labels<F: Drawn>(family: &F, arrangement: &Made<F>) -> Vec<(EndsOf<F>, Vec<u32>)> {
    let of = |e: EdgeId| {
        let ends = arrangement.dcel().ends(e).map(|v| arrangement.point(v).map(|p| family.place(p)));
        (ends, family.labels(arrangement.curve_of(e)))
    };
    let mut all: Vec<_> = arrangement.dcel().edges().map(of).collect();
    all.sort();
    all
}

/// All that must come back with its id if operations are taken back.
#[derive(PartialEq, Debug)]
pub(super) struct Identities<P, S> {
    points: Vec<(VertexId, Option<P>)>,
    vertices: Vec<(VertexId, bool, Option<FaceId>)>,
    halfedges: Vec<(HalfedgeId, [HalfedgeId; 2], VertexId, FaceId)>,
    edges: Vec<(EdgeId, Vec<S>, Vec<u32>)>,
    faces: Vec<(FaceId, usize)>,
}

impl<P, S> Identities<P, S> {
    pub(super) fn of<F: Drawn<Place = P, Stroke = S>>(family: &F, arrangement: &Made<F>) -> Self {
        let dcel = arrangement.dcel();
        let point = |v| (v, arrangement.point(v).map(|p| family.place(p)));
        let vertex = |v| (v, arrangement.is_artificial(v), dcel.isolated_face(v));
        let edge = |e| {
            let curve = arrangement.make_edge_curve(e);
            (e, family.strokes(&curve), family.labels(&curve))
        };
        let halfedge = |h: HalfedgeId| (h, [dcel.next(h), dcel.prev(h)], dcel.source(h), dcel.face(h));
        Self {
            points: dcel.vertices().map(point).collect(),
            vertices: dcel.vertices().map(vertex).collect(),
            halfedges: dcel.edges().flat_map(|e| [e.halfedge(), e.halfedge().twin()]).map(halfedge).collect(),
            edges: dcel.edges().map(edge).collect(),
            faces: dcel.faces().map(|f| (f, dcel.face_ccbs(f).count())).collect(),
        }
    }
}

/// The face in which a cell is, if it is one.
pub(super) fn face_of(cell: Cell) -> Option<FaceId> {
    match cell {
        Cell::Face(face) => Some(face),
        _ => None,
    }
}
