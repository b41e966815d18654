//! Edits cell by cell, each against a sweep.

use crate::arcs::Curve;
use crate::edits::Watched;
use crate::own::{arc_of, direction};
use crate::random::random_curve;
use crate::space::is_pole;
use dcel::{EdgeId, EndFate, VertexId};
use splitstar_arrangement::models::GeodesicArc;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::traits::{
    ArrangementTraits, BasicTraits, CurveEnd, Intersection, Piece, UMonotoneTraits,
};
use splitstar_arrangement::{Pieces, locate_by_sweep};
use testkit::Rng;

pub(crate) fn split(editor: &mut Watched, e: EdgeId, rng: &mut Rng) -> String {
    let inner = arc_of(editor, e).inner_points();
    let point = direction(rng.choose(&inner));
    let mut expected = editor.arrangement().clone();
    expected.insert_points([point.clone()]);
    let parts = editor.split_edge(e, &point);
    assert_eq!(parts.edges[0], e);
    assert_eq!(editor.difference(&expected), None);
    format!("split {e:?} at {point}")
}

/// Replaces a curve by one that covers the edge, and a point by itself.
pub(crate) fn modify(editor: &mut Watched, e: EdgeId, rng: &mut Rng) -> String {
    let whole = rng.one_in(2);
    let curve = if whole { editor.curve_of(e).clone() } else { editor.make_edge_curve(e) };
    editor.modify_edge(e, curve);
    let v = editor.dcel().ends(e)[rng.index(2)];
    let point = editor.point(v).expect("vertices are points").clone();
    editor.modify_vertex(v, point);
    format!("modify {e:?} (whole: {whole}) and {v:?}")
}

pub(crate) fn remove(editor: &mut Watched, edges: &[EdgeId], rng: &mut Rng) -> String {
    if rng.one_in(2) {
        let fates = [0; 2].map(|_| if rng.one_in(2) { EndFate::Isolate } else { EndFate::Remove });
        let e = *rng.choose(edges);
        editor.remove_edge_with(e, fates);
        format!("remove {e:?}, {fates:?}")
    } else {
        let some: Vec<EdgeId> = edges.iter().copied().filter(|_| rng.one_in(3)).collect();
        editor.remove_edges(&some);
        format!("remove {some:?}")
    }
}

/// Inserts a piece of a curve that meets nothing; one of some that are drawn.
pub(crate) fn insert_free(editor: &mut Watched, rng: &mut Rng) -> String {
    for _ in 0..8 {
        let curve: Curve = random_curve(rng, 2);
        let mut pieces = Vec::new();
        editor.traits().make_u_monotone(&curve.own(), &mut pieces);
        for piece in pieces {
            if let Piece::Curve { curve, .. } = piece
                && !meets(editor, &curve)
            {
                return insert_disjoint(editor, curve, rng);
            }
        }
    }
    "insert nothing".into()
}

/// Tells whether the interior of a piece meets something.
fn meets(editor: &Watched, curve: &GeodesicArc) -> bool {
    let traits = editor.traits();
    let is_end = |p: &_| CurveEnd::BOTH.iter().any(|&end| curve.end(end) == p);
    let mut common = Vec::new();
    for e in editor.dcel().edges() {
        traits.intersect(&editor.make_edge_curve(e), curve, &mut common);
    }
    let are_ends = common.iter().all(|part| match part {
        Intersection::Point(p, _) => is_end(p),
        Intersection::Overlap(_) => false,
    });
    let mut points = editor.vertices().filter_map(|v| editor.point(v));
    !are_ends || points.any(|p| traits.is_on_curve(p, curve) && !is_end(p))
}

/// Inserts a piece that meets nothing, in one of the ways in which that can be told. A pole is a vertex whether something is there or not.
fn insert_disjoint(editor: &mut Watched, curve: GeodesicArc, rng: &mut Rng) -> String {
    let ends = CurveEnd::BOTH.map(|end| curve.end(end).clone());
    let cells = ends.each_ref().map(|p| locate_by_sweep(editor, std::slice::from_ref(p))[0]);
    let poles = ends.each_ref().map(|p| is_pole(&p.coordinates()));
    let south = CurveEnd::BOTH.map(|end| VertexId(u32::from(end == CurveEnd::Max)));
    let vertex = [0, 1].map(|i| match cells[i] {
        _ if poles[i] => Some(south[i]),
        Cell::Vertex(v) => Some(v),
        _ => None,
    });
    let may_be_new = [0, 1].map(|i| poles[i] || matches!(cells[i], Cell::Face(_)));
    let face = cells.iter().find_map(|cell| if let Cell::Face(f) = cell { Some(*f) } else { None });
    let is_closed = ends[0] == ends[1];
    let mut expected = editor.arrangement().clone();
    let mut pieces = Pieces::new();
    pieces.push_piece(curve.clone(), [false; 2]);
    expected.insert_pieces(pieces);
    let text = format!("{curve:?}");
    let how = match (vertex, face, rng.below(6)) {
        ([Some(v), Some(w)], _, 0..3) => {
            editor.insert_edge_between([v, w], curve);
            "between"
        }
        ([Some(v), _], _, 1 | 3) if may_be_new[1] && !is_closed => {
            editor.insert_edge_from(v, curve);
            "from"
        }
        ([_, Some(w)], _, 2 | 4) if may_be_new[0] && !is_closed => {
            editor.insert_edge_to(curve, w);
            "to"
        }
        (_, Some(face), 0..5) if may_be_new == [true; 2] && !is_closed => {
            editor.insert_edge_in_face(curve, face);
            "in a face"
        }
        _ => {
            editor.insert_disjoint(curve);
            "anyhow"
        }
    };
    assert_eq!(editor.difference(&expected), None, "{how}: {text}");
    format!("insert {how} {text}")
}
