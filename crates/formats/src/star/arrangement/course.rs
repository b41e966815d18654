//! The curves of a text: edges that go straight on from vertex to vertex, joined, whatever curves they come from.
//!
//! So what stands in a text depends on the cells alone. Which of several curves that overlap an edge has as its support, where a curve
//! ends in the middle of another one, and whether a line was given as a whole or in parts, does not show.

use super::family::{Family, Straight};
use arrangement::Arrangement;
use arrangement::traits::CurveEnd;
use dcel::{EdgeId, VertexId};
use exact::planar::{Line2, Point2, compare_xy};
use std::collections::HashMap;
use std::iter::successors;

/// The number of the piece of a curve that comes to a point from the left (`Max`), or leaves it to the right (`Min`). The point is on
/// the curve, and not an end of it on a side of the rectangle.
pub(super) fn piece_beside<S: Straight>(pieces: &[S], p: &Point2, end: CurveEnd) -> usize {
    let ends_before = |piece: &S| {
        let order = piece.place(CurveEnd::Max).map(|max| compare_xy(max, p));
        order.is_some_and(|order| order.is_lt() || (order.is_eq() && end == CurveEnd::Min))
    };
    pieces.partition_point(ends_before).min(pieces.len() - 1)
}

/// An end of an edge.
struct End<'a> {
    /// The piece of the support.
    piece: usize,
    line: &'a Line2,
    /// Where it is, in the closed rectangle of a torus; `None` at infinity.
    place: Option<&'a Point2>,
}

fn end_of<G: Family>(
    arrangement: &Arrangement<G, G::Surface>,
    e: EdgeId,
    v: VertexId,
    end: CurveEnd,
) -> End<'_> {
    let support = arrangement.curve(arrangement.support(e));
    let pieces = G::pieces(support);
    let last = match end {
        CurveEnd::Min => 0,
        CurveEnd::Max => pieces.len() - 1,
    };
    let point = arrangement.point(v);
    let (piece, place) = match point {
        // The curve may end on the other side of the rectangle.
        Some(point) if arrangement.traits().end_point(support, end) != Some(point) => {
            (piece_beside(pieces, point, end), Some(point))
        }
        _ => (last, pieces[last].place(end)),
    };
    End { piece, line: pieces[piece].line(), place }
}

/// What a text says of a curve.
pub(super) struct Course<'a> {
    /// The vertex where it begins.
    pub(super) start: Option<&'a Point2>,
    /// Its ends, in the closed rectangle of a torus; `None` at infinity.
    pub(super) places: [Option<&'a Point2>; 2],
    /// The points between them where its direction changes.
    pub(super) bends: Vec<&'a Point2>,
    /// Its first and its last line.
    pub(super) lines: [&'a Line2; 2],
}

/// Which edges go straight on in which.
pub(super) struct Links {
    /// For each edge the one before it, and the one after it, or none.
    before: Vec<EdgeId>,
    after: Vec<EdgeId>,
}

impl Links {
    /// # Complexity
    /// Linear, with a hash of lines at vertices of many edges.
    pub(super) fn new<G: Family>(arrangement: &Arrangement<G, G::Surface>, vertices: &[VertexId]) -> Self {
        /// So many pairs are compared without a hash.
        const FEW_PAIRS: usize = 64;
        let dcel = arrangement.dcel();
        let none = vec![EdgeId::NONE; dcel.edge_bound()];
        let mut links = Self { before: none.clone(), after: none };
        let (mut coming, mut leaving) = (Vec::new(), Vec::new());
        for &v in vertices {
            coming.clear();
            leaving.clear();
            for h in dcel.around(v) {
                let (end, list) = match h.is_even() {
                    true => (CurveEnd::Min, &mut leaving),
                    false => (CurveEnd::Max, &mut coming),
                };
                let found = end_of(arrangement, h.edge_id(), v, end);
                // What ends on the right or the upper side is not continued on the other.
                if found.place == arrangement.point(v) {
                    list.push((found.line, h.edge_id()));
                }
            }
            if coming.len() * leaving.len() <= FEW_PAIRS {
                for (line, e) in &coming {
                    let on = leaving.iter().find(|(other, _)| other == line);
                    on.into_iter().for_each(|&(_, on)| links.join(*e, on));
                }
            } else {
                let leaving: HashMap<&Line2, EdgeId> = leaving.iter().copied().collect();
                for (line, e) in &coming {
                    leaving.get(line).into_iter().for_each(|&on| links.join(*e, on));
                }
            }
        }
        links
    }

    fn join(&mut self, e: EdgeId, on: EdgeId) {
        self.after[e.index()] = on;
        self.before[on.index()] = e;
    }

    /// The edges of the curve of one of them, from the first to the last.
    pub(super) fn run(&self, e: EdgeId) -> impl Iterator<Item = EdgeId> + '_ {
        let follow = |links: &[EdgeId], e: &EdgeId| Some(links[e.index()]).filter(|&e| e != EdgeId::NONE);
        let first = successors(Some(e), move |e| follow(&self.before, e)).last();
        successors(first, move |e| follow(&self.after, e))
    }
}

/// The curve that joined edges make up.
pub(super) fn course_of<G: Family>(
    arrangement: &Arrangement<G, G::Surface>,
    run: impl Iterator<Item = EdgeId>,
) -> Option<Course<'_>> {
    let mut course: Option<Course<'_>> = None;
    for e in run {
        let [v, w] = arrangement.dcel().ends(e);
        let [min, max] =
            [(v, CurveEnd::Min), (w, CurveEnd::Max)].map(|(v, end)| end_of(arrangement, e, v, end));
        let course = course.get_or_insert_with(|| Course {
            start: arrangement.point(v),
            places: [min.place, max.place],
            bends: Vec::new(),
            lines: [min.line, max.line],
        });
        let pieces = &G::pieces(arrangement.curve(arrangement.support(e)))[min.piece..=max.piece];
        let bends = pieces.windows(2).filter(|pair| pair[0].line() != pair[1].line());
        course.bends.extend(bends.filter_map(|pair| pair[1].place(CurveEnd::Min)));
        course.places[1] = max.place;
        course.lines[1] = max.line;
    }
    course
}
