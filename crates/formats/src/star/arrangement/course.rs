//! The curves of a text: edges that go straight on from vertex to vertex, joined, whatever curves they come from.
//!
//! So what stands in a text depends on the cells alone. Which of several curves that overlap an edge has as its support, where a curve
//! ends in the middle of another one, and whether a line was given as a whole or in parts, does not show.

use super::family::{Base, Family};
use arrangement::Arrangement;
use arrangement::traits::CurveEnd;
use dcel::{EdgeId, VertexId};
use std::collections::HashMap;
use std::iter::successors;

/// The number of the piece of a curve that comes to a point from the left (`Max`), or leaves it to the right (`Min`), and whether that
/// point is this end of the curve. The point is on the curve.
pub(super) fn piece_at<B: Base>(
    base: &B,
    pieces: &[B::UMonotoneCurve],
    p: &B::Point,
    end: CurveEnd,
) -> (usize, bool) {
    let last = last_piece(pieces, end);
    // The end may be on another side of the parameter space.
    if base.end_point(&pieces[last], end) == Some(p) {
        return (last, true);
    }
    let ends_before = |piece: &B::UMonotoneCurve| {
        let order = B::place(piece, CurveEnd::Max).map(|joint| base.compare_uv(joint, p));
        order.is_some_and(|order| order.is_lt() || (order.is_eq() && end == CurveEnd::Min))
    };
    (pieces[..pieces.len() - 1].partition_point(ends_before), false)
}

/// The number of the piece with an end of a curve.
fn last_piece<C>(pieces: &[C], end: CurveEnd) -> usize {
    match end {
        CurveEnd::Min => 0,
        CurveEnd::Max => pieces.len() - 1,
    }
}

/// An end of an edge.
struct End<'a, B: Base> {
    /// The piece of the support.
    piece: usize,
    line: &'a B::Line,
    /// Where it is: see [`Base::place`].
    place: Option<&'a B::Point>,
    /// See [`Base::goes_on`].
    goes_on: bool,
}

fn end_of<B: Base, G: Family<B>>(
    arrangement: &Arrangement<G, G::Surface>,
    e: EdgeId,
    v: VertexId,
    end: CurveEnd,
) -> End<'_, B> {
    let base = arrangement.traits().base();
    let pieces = G::pieces(arrangement.curve(arrangement.support(e)));
    let point = arrangement.point(v);
    let at_infinity = (last_piece(pieces, end), true);
    let (piece, is_end) = point.map_or(at_infinity, |point| piece_at(base, pieces, point, end));
    let curve = &pieces[piece];
    let (place, goes_on) = match is_end {
        true => (B::place(curve, end), base.goes_on(curve, end)),
        false => (point, true),
    };
    End { piece, line: B::line(curve), place, goes_on }
}

/// What a text says of a curve.
pub(super) struct Course<'a, B: Base> {
    /// The vertex where it begins.
    pub(super) start: Option<&'a B::Point>,
    /// Its ends: see [`Base::place`].
    pub(super) places: [Option<&'a B::Point>; 2],
    /// Its first line.
    pub(super) line: &'a B::Line,
    /// The points between its ends where its direction changes, and the lines that begin there.
    pub(super) bends: Vec<(&'a B::Point, &'a B::Line)>,
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
    pub(super) fn new<B: Base, G: Family<B>>(
        arrangement: &Arrangement<G, G::Surface>,
        vertices: &[VertexId],
    ) -> Self {
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
                if found.goes_on {
                    list.push((found.line, h.edge_id()));
                }
            }
            if coming.len() * leaving.len() <= FEW_PAIRS {
                for (line, e) in &coming {
                    let on = leaving.iter().find(|(other, _)| other == line);
                    on.into_iter().for_each(|&(_, on)| links.join(*e, on));
                }
            } else {
                let leaving: HashMap<&B::Line, EdgeId> = leaving.iter().copied().collect();
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
pub(super) fn course_of<B: Base, G: Family<B>>(
    arrangement: &Arrangement<G, G::Surface>,
    run: impl Iterator<Item = EdgeId>,
) -> Option<Course<'_, B>> {
    let mut course: Option<Course<'_, B>> = None;
    for e in run {
        let [v, w] = arrangement.dcel().ends(e);
        let [min, max] =
            [(v, CurveEnd::Min), (w, CurveEnd::Max)].map(|(v, end)| end_of(arrangement, e, v, end));
        let course = course.get_or_insert_with(|| Course {
            start: arrangement.point(v),
            places: [min.place, max.place],
            line: min.line,
            bends: Vec::new(),
        });
        let pieces = &G::pieces(arrangement.curve(arrangement.support(e)))[min.piece..=max.piece];
        let bends = pieces.windows(2).filter(|pair| B::line(&pair[0]) != B::line(&pair[1]));
        let bends =
            bends.filter_map(|pair| B::place(&pair[1], CurveEnd::Min).map(|bend| (bend, B::line(&pair[1]))));
        course.bends.extend(bends);
        course.places[1] = max.place;
    }
    course
}
