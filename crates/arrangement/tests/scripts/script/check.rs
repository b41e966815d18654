//! What has to hold after each step.

use super::draw::Draw;
use super::drawn::{Drawn, PieceOf};
use super::scan::{P, Scan, Stroke};
use super::steps::World;
use crate::family::Family;
use dcel::{EdgeId, FaceId, HalfedgeId, VertexId};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::{Arrangement, locate_by_sweep};

pub(super) type Made<F> = Arrangement<<F as Family>::Traits, <F as Family>::Surface>;

impl<F: Drawn> World<F> {
    /// Checks the arrangement, the mirror, and where some points are found.
    pub(super) fn check(&self, draw: &mut Draw<'_>) {
        let arrangement = self.editor.arrangement();
        assert_eq!(arrangement.check_valid(), []);
        let is_same = |a: &PieceOf<F>, b: &PieceOf<F>| {
            self.family.strokes(a) == self.family.strokes(b) && self.family.labels(a) == self.family.labels(b)
        };
        assert_eq!(self.editor.observers().1.difference(arrangement, is_same), None, "the mirror");
        let scan = Scan::new(&self.family, arrangement);
        let half = Rational::ONE.checked_div(&Rational::from(2)).expect("2 is not zero");
        let mut points: Vec<Point2> = (0..3).map(|_| self.family.point(draw)).collect();
        for _ in 0..2 {
            let vertices: Vec<VertexId> = arrangement.vertices().collect();
            points.extend(draw.choose(&vertices).and_then(|v| arrangement.point(v).cloned()));
            let strokes = draw.choose(&scan.edges).map(|(_, strokes)| strokes);
            let place = strokes.and_then(|strokes| Some(draw.choose(&strokes)?.at(&half)));
            points.extend(place.map(|place| self.family.at(&place)));
        }
        let cells = locate_by_sweep(arrangement, &points);
        for (point, &cell) in points.iter().zip(&cells) {
            assert_eq!(self.editor.locate(point), cell, "at {point}, against one sweep");
            if let Some(expected) = scan.locate(point) {
                assert_eq!(cell, expected, "at {point}, one sweep against a scan");
            }
        }
        self.check_rays(&points, &cells);
    }

    /// A place in the interior of an edge.
    pub(super) fn inner_point(&self, e: EdgeId, draw: &mut Draw<'_>) -> Option<Point2> {
        let strokes = self.family.strokes(&self.editor.arrangement().make_edge_curve(e));
        let stroke = draw.choose(&strokes)?;
        let times = Rational::from(1 + draw.below(3) as i64).checked_div(&Rational::from(4));
        Some(self.family.at(&stroke.at(&times.expect("4 is not zero"))))
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
type EndsOf = [Option<P>; 2];

/// What the edges carry, with their ends.
fn labels<F: Drawn>(family: &F, arrangement: &Made<F>) -> Vec<(EndsOf, Vec<u32>)> {
    let of = |e: EdgeId| {
        let ends = arrangement.dcel().ends(e).map(|v| arrangement.point(v).map(Point2::coordinates));
        (ends, family.labels(arrangement.curve_of(e)))
    };
    let mut all: Vec<_> = arrangement.dcel().edges().map(of).collect();
    all.sort();
    all
}

/// All that must come back with its id if operations are taken back.
#[derive(PartialEq, Debug)]
pub(super) struct Identities {
    points: Vec<(VertexId, Option<P>)>,
    vertices: Vec<(VertexId, bool, Option<FaceId>)>,
    halfedges: Vec<(HalfedgeId, [HalfedgeId; 2], VertexId, FaceId)>,
    edges: Vec<(EdgeId, Vec<Stroke>, Vec<u32>)>,
    faces: Vec<(FaceId, usize)>,
}

impl Identities {
    pub(super) fn of<F: Drawn>(family: &F, arrangement: &Made<F>) -> Self {
        let dcel = arrangement.dcel();
        let point = |v| (v, arrangement.point(v).map(Point2::coordinates));
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
