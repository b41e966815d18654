//! What the steps of a script do.

use super::check::{Identities, assert_alike, face_of};
use super::draw::Draw;
use super::drawn::{CurveOf, Drawn, Made, PieceOf};
use crate::swept_again::swept_again;
use dcel::{EdgeId, EndFate, FaceId, VertexId};
use splitstar_arrangement::edit::{Mirror, Undo};
use splitstar_arrangement::location::TrapezoidalMap;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::traits::{
    ArrangementTraits, BasicTraits, CurveEnd, Intersection, Piece, UMonotoneTraits,
};
use splitstar_arrangement::{Arrangement, Editor, Pieces, locate_by_sweep};

type Watched<F> =
    (Undo<<F as Drawn>::Traits>, Mirror<<F as Drawn>::Traits>, TrapezoidalMap<<F as Drawn>::Traits>);

/// Who writes down what is done.
pub(crate) type Log<'a> = &'a mut dyn FnMut(String);

/// How a curve is inserted that meets nothing.
#[derive(Debug)]
enum How {
    Between([VertexId; 2]),
    From(VertexId),
    To(VertexId),
    In(FaceId),
    Anyhow,
}

/// Above so many edges, nothing is inserted.
const MOST_EDGES: usize = 40;

/// An arrangement that is edited, and what it was before each operation that can be taken back.
pub(super) struct World<F: Drawn> {
    pub(super) family: F,
    pub(super) editor: Editor<F::Traits, F::Surface, Watched<F>>,
    past: Vec<Made<F>>,
}

impl<F: Drawn> World<F> {
    pub(super) fn new(family: F) -> Self {
        let empty = Arrangement::new(family.traits(), family.surface());
        let observers = (Undo::new(&empty), Mirror::new(&empty), TrapezoidalMap::new(&empty));
        let editor = Editor::with_observers(empty, observers).expect("the observers have just begun");
        Self { family, editor, past: Vec::new() }
    }

    pub(super) fn vertices(&self) -> Vec<VertexId> {
        self.editor.arrangement().vertices().collect()
    }

    pub(super) fn edges(&self) -> Vec<EdgeId> {
        self.editor.arrangement().dcel().edges().collect()
    }

    /// A vertex that stands for a pole stays, though nothing is there.
    fn has_vertex(&self, v: VertexId) -> bool {
        let arrangement = self.editor.arrangement();
        arrangement.dcel().has_vertex(v) && !arrangement.is_absent(v)
    }

    /// Does one step.
    pub(super) fn step(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        let is_full = self.edges().len() > MOST_EDGES;
        match draw.below(32) {
            0..8 if !is_full => self.insert_curve(draw, log),
            8..10 if !is_full => self.insert_point(draw, log),
            10 if !is_full => self.insert_many(draw, log),
            11..14 if !is_full => self.insert_free(draw, log),
            14..16 if !is_full => self.split(draw, log),
            0..20 => self.remove_edge(draw, log),
            20 => self.remove_vertex(draw, log),
            21 => self.remove_vertex_with_edges(draw, log),
            22..25 => self.merge(draw, log),
            25..27 => self.modify(draw, log),
            27 => self.compact(draw, log),
            28 => self.clear(draw, log),
            _ => self.take_back(1 + draw.below(4), log),
        }
    }

    /// Does an operation that can be taken back.
    fn operate<R>(&mut self, operate: impl FnOnce(&mut Self) -> R) -> R {
        let before = self.editor.arrangement().clone();
        let count = self.editor.observers().0.operation_count();
        let result = operate(self);
        match self.editor.observers().0.operation_count() - count {
            0 => {
                let now = Identities::of(&self.family, self.editor.arrangement());
                assert_eq!(now, Identities::of(&self.family, &before), "no operation was recorded");
            }
            1 => self.past.push(before),
            other => panic!("{other} operations were recorded"),
        }
        assert_eq!(self.past.len(), self.editor.observers().0.operation_count());
        result
    }

    /// What there was can be taken back no more.
    fn forget(&mut self) {
        self.past.clear();
        assert_eq!(self.editor.observers().0.operation_count(), 0);
    }

    fn insert_curve(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        let Some(curve) = self.family.curve(draw) else { return };
        log(format!("insert {}", self.text(&curve)));
        let mut expected = self.editor.arrangement().clone();
        expected.insert_curves([&curve]);
        let edges = self.operate(|world| world.editor.insert_curve(&curve));
        let arrangement = self.editor.arrangement();
        assert!(edges.iter().all(|&e| arrangement.dcel().has_edge(e)), "{edges:?}");
        assert_alike(&self.family, arrangement, &expected);
    }

    /// The pieces of a curve in coordinates.
    fn text(&self, curve: &CurveOf<F>) -> String {
        let mut pieces = Vec::new();
        self.family.traits().make_u_monotone(curve, &mut pieces);
        let texts = pieces.iter().map(|piece| match piece {
            Piece::Curve { curve, is_artificial } => format!("{} {is_artificial:?}", self.piece_text(curve)),
            Piece::Point(point) => format!("{point}"),
        });
        texts.collect::<Vec<_>>().join(", ")
    }

    fn piece_text(&self, piece: &PieceOf<F>) -> String {
        let strokes = self.family.strokes(piece);
        let texts = strokes.iter().map(|stroke| format!("{stroke:?}"));
        format!("[{}] {:?}", texts.collect::<Vec<_>>().join("; "), self.family.labels(piece))
    }

    fn insert_point(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        let point = self.family.point(draw);
        log(format!("insert point {point}"));
        let mut expected = self.editor.arrangement().clone();
        expected.insert_points([point.clone()]);
        let v = self.operate(|world| world.editor.insert_point(&point));
        let arrangement = self.editor.arrangement();
        assert_eq!(self.editor.locate(&point), Cell::Vertex(v));
        assert_alike(&self.family, arrangement, &expected);
    }

    fn insert_many(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        let curves: Vec<_> = (0..1 + draw.below(3)).filter_map(|_| self.family.curve(draw)).collect();
        let point = self.family.point(draw);
        let texts: Vec<String> = curves.iter().map(|curve| self.text(curve)).collect();
        log(format!("insert at once {texts:?} and {point}"));
        self.editor.insert_curves_and_points(&curves, [point]);
        self.forget();
    }

    /// Inserts u-monotone curves that meet nothing: the pieces of one of some that are drawn.
    fn insert_free(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        for _ in 0..8 {
            let mut pieces = Vec::new();
            if let Some(curve) = self.family.curve(draw) {
                self.family.traits().make_u_monotone(&curve, &mut pieces);
            }
            let mut was_free = false;
            for piece in pieces {
                let Piece::Curve { curve, .. } = piece else { continue };
                if !self.meets(&curve) {
                    self.insert_disjoint(curve, draw, log);
                    was_free = true;
                }
            }
            if was_free {
                break;
            }
        }
    }

    /// Inserts a u-monotone curve that meets nothing, in one of the ways in which that can be told.
    fn insert_disjoint(&mut self, curve: PieceOf<F>, draw: &mut Draw<'_>, log: Log<'_>) {
        let arrangement = self.editor.arrangement();
        let traits = arrangement.traits();
        // A curve without an end is not at the vertex of a side with it, for those who insert it.
        let cells = CurveEnd::BOTH.map(|end| {
            let point = traits.end_point(&curve, end)?;
            Some(locate_by_sweep(arrangement, std::slice::from_ref(point))[0])
        });
        let is_closed = match CurveEnd::BOTH.map(|end| traits.end_point(&curve, end)) {
            [Some(p), Some(q)] => traits.is_same_point(p, q),
            _ => false,
        };
        let mut expected = arrangement.clone();
        let mut pieces = Pieces::new();
        pieces.push_piece(curve.clone(), [false; 2]);
        expected.insert_pieces(pieces);
        let vertex = cells.map(|cell| match cell {
            Some(Cell::Vertex(v)) => Some(v),
            _ => None,
        });
        let is_new = cells.map(|cell| cell.is_none_or(|cell| matches!(cell, Cell::Face(_))));
        let face = cells.iter().flatten().find_map(|&cell| face_of(cell));
        let text = self.piece_text(&curve);
        let knows = draw.below(4) > 0;
        let how = match (vertex, face) {
            ([Some(v), Some(w)], _) if knows => How::Between([v, w]),
            ([Some(v), None], _) if knows && is_new[1] => How::From(v),
            ([None, Some(v)], _) if knows && is_new[0] => How::To(v),
            ([None, None], Some(face)) if knows && is_new == [true; 2] && !is_closed => How::In(face),
            _ => How::Anyhow,
        };
        log(format!("insert {how:?} {text}"));
        self.operate(|world| {
            let editor = &mut world.editor;
            match how {
                How::Between(ends) => editor.insert_edge_between(ends, curve),
                How::From(v) => editor.insert_edge_from(v, curve),
                How::To(v) => editor.insert_edge_to(curve, v),
                How::In(face) => editor.insert_edge_in_face(curve, face),
                How::Anyhow => editor.insert_disjoint(curve),
            }
        });
        assert_alike(&self.family, self.editor.arrangement(), &expected);
    }

    /// Tells whether the interior of a curve meets something.
    fn meets(&self, curve: &PieceOf<F>) -> bool {
        let arrangement = self.editor.arrangement();
        let traits = arrangement.traits();
        let is_end = |p: &_| {
            let mut ends = CurveEnd::BOTH.iter().filter_map(|&end| traits.end_point(curve, end));
            ends.any(|end| traits.is_same_point(end, p))
        };
        let mut common = Vec::new();
        for e in arrangement.dcel().edges() {
            traits.intersect(&arrangement.make_edge_curve(e), curve, &mut common);
        }
        let are_ends = common.iter().all(|part| match part {
            Intersection::Point(p, _) => is_end(p),
            Intersection::Overlap(_) => false,
        });
        let mut points = arrangement.vertices().filter_map(|v| arrangement.point(v));
        !are_ends || points.any(|p| traits.is_on_curve(p, curve) && !is_end(p))
    }

    fn split(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        let Some(e) = draw.choose(&self.edges()) else { return };
        let Some(point) = self.inner_point(e, draw) else { return };
        log(format!("split {} at {point}", e.0));
        let mut expected = self.editor.arrangement().clone();
        expected.insert_points([point.clone()]);
        let parts = self.operate(|world| world.editor.split_edge(e, &point));
        assert_eq!(parts.edges[0], e);
        let [min, max] = parts.edges.map(|e| self.editor.arrangement().dcel().ends(e));
        assert_eq!([min[1], max[0]], [parts.vertex; 2]);
        assert_alike(&self.family, self.editor.arrangement(), &expected);
    }

    fn remove_edge(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        let Some(e) = draw.choose(&self.edges()) else { return };
        let fates = [0; 2].map(|_| if draw.one_in(4) { EndFate::Isolate } else { EndFate::Remove });
        log(format!("remove edge {} {fates:?}", e.0));
        self.operate(|world| world.editor.remove_edge_with(e, fates));
        self.check_swept();
    }

    fn remove_vertex(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        let Some(v) = draw.choose(&self.vertices()) else { return };
        log(format!("remove vertex {}", v.0));
        let result = self.operate(|world| world.editor.remove_vertex(v));
        assert_eq!(result.is_err(), self.has_vertex(v));
        self.check_swept();
    }

    fn remove_vertex_with_edges(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        let Some(v) = draw.choose(&self.vertices()) else { return };
        log(format!("remove vertex {} with edges", v.0));
        let result = self.operate(|world| world.editor.remove_vertex_with_edges(v));
        assert_eq!(result.is_err(), self.has_vertex(v));
        self.check_swept();
    }

    fn merge(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        let vertices = self.vertices();
        let mergeable: Vec<VertexId> =
            vertices.iter().copied().filter(|&v| self.editor.check_mergeable(v).is_ok()).collect();
        let Some(v) = draw.choose(&mergeable).or_else(|| draw.choose(&vertices)) else { return };
        log(format!("merge at {}", v.0));
        let result = self.operate(|world| world.editor.merge_edges(v));
        assert_eq!(result.is_ok(), mergeable.contains(&v));
        self.check_swept();
    }

    /// Replaces a curve by one that covers the edge, or a point by itself.
    fn modify(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        let arrangement = self.editor.arrangement();
        if draw.one_in(4) {
            let Some(v) = draw.choose(&self.vertices()) else { return };
            let Some(point) = arrangement.point(v).cloned() else { return };
            log(format!("modify vertex {}", v.0));
            self.operate(|world| world.editor.modify_vertex(v, point));
        } else {
            let Some(e) = draw.choose(&self.edges()) else { return };
            let curve =
                if draw.one_in(2) { arrangement.make_edge_curve(e) } else { arrangement.curve_of(e).clone() };
            let label = draw.below(4) as u32;
            let curve = self.family.relabeled(curve, label);
            log(format!("modify edge {} to {}", e.0, self.piece_text(&curve)));
            self.operate(|world| world.editor.modify_edge(e, curve));
        }
        self.check_swept();
    }

    fn compact(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        // Else there never is much to take back.
        if draw.one_in(2) {
            log("compact".into());
            let before = self.editor.arrangement().clone();
            self.editor.compact();
            self.forget();
            assert_alike(&self.family, self.editor.arrangement(), &before);
        }
    }

    fn clear(&mut self, draw: &mut Draw<'_>, log: Log<'_>) {
        if draw.one_in(4) {
            log("clear".into());
            self.editor.clear();
            self.forget();
            let empty = Arrangement::new(self.family.traits(), self.family.surface());
            assert_alike(&self.family, self.editor.arrangement(), &empty);
        }
    }

    fn take_back(&mut self, count: u64, log: Log<'_>) {
        for _ in 0..count {
            log("take back".into());
            self.take_one_back();
        }
    }

    fn take_one_back(&mut self) {
        let recorded = self.editor.observers_mut().0.pop();
        assert_eq!(recorded.is_some(), !self.past.is_empty());
        let (Some(recorded), Some(before)) = (recorded, self.past.pop()) else { return };
        self.editor.take_back(recorded).expect("it is the last operation");
        let arrangement = self.editor.arrangement();
        assert_eq!(Identities::of(&self.family, arrangement), Identities::of(&self.family, &before));
        assert_alike(&self.family, arrangement, &before);
    }

    pub(super) fn take_all_back(&mut self) {
        while !self.past.is_empty() {
            self.take_one_back();
            assert_eq!(self.editor.arrangement().check_valid(), []);
        }
        assert_eq!(self.editor.observers().0.operation_count(), 0);
    }

    /// Checks that a sweep of what is there gives the same.
    fn check_swept(&self) {
        let arrangement = self.editor.arrangement();
        assert_alike(&self.family, arrangement, &swept_again(arrangement));
    }
}
