//! Location by a scan over all cells in coordinates: no predicate of the library is asked.

use super::straight::Straight;
use dcel::{EdgeId, FaceId, VertexId};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::overlay::Cell;
use std::fmt;

/// Coordinates.
pub(super) type P = [Rational; 2];

/// A straight part of a curve.
#[derive(Clone, PartialEq)]
pub(super) struct Stroke {
    /// Two points of it, the lesser one first.
    ends: [P; 2],
    /// Whether it goes on without end beyond the one and beyond the other.
    is_open: [bool; 2],
}

impl fmt::Debug for Stroke {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [[a, b], [c, d]] = &self.ends;
        write!(f, "{a} {b} .. {c} {d} {:?}", self.is_open)
    }
}

impl Stroke {
    pub(super) fn new(ends: [P; 2], is_open: [bool; 2]) -> Self {
        let mut stroke = Self { ends, is_open };
        if stroke.ends[1] < stroke.ends[0] {
            stroke.ends.reverse();
            stroke.is_open.reverse();
        }
        stroke
    }

    fn way(&self) -> P {
        let [p, q] = &self.ends;
        [&q[0] - &p[0], &q[1] - &p[1]]
    }

    /// The point at so many times the way from the first end to the second one.
    pub(super) fn at(&self, times: &Rational) -> P {
        let way = self.way();
        [0, 1].map(|i| &self.ends[0][i] + times * &way[i])
    }

    fn has_point(&self, p: &P) -> bool {
        let ([dx, dy], [q, r]) = (self.way(), &self.ends);
        let is_on_line = &dx * (&p[1] - &q[1]) == &dy * (&p[0] - &q[0]);
        is_on_line && (self.is_open[0] || q <= p) && (self.is_open[1] || p <= r)
    }

    /// Where it is above a place of the axis, and how steep, if it goes on to the right of that.
    fn above(&self, u: &Rational) -> Option<(Rational, Rational)> {
        let ([dx, dy], [q, r]) = (self.way(), &self.ends);
        let slope = dy.checked_div(&dx)?;
        let goes_on = (self.is_open[0] || q[0] <= *u) && (self.is_open[1] || *u < r[0]);
        goes_on.then(|| (&q[1] + &slope * (u - &q[0]), slope))
    }
}

/// The cells of an arrangement in coordinates.
pub(super) struct Scan {
    vertices: Vec<(VertexId, P)>,
    edges: Vec<(EdgeId, Vec<Stroke>)>,
    /// The face above each edge.
    above: Vec<FaceId>,
    period: Option<P>,
    /// The face beside the left and the bottom side.
    corner: FaceId,
    /// Whether no edge ends at the bottom, and so one face is there.
    has_one_bottom: bool,
}

impl Scan {
    pub(super) fn new<F: Straight>(family: &F, arrangement: &Arrangement<F::Traits, F::Surface>) -> Self {
        let dcel = arrangement.dcel();
        let strokes = |e| (e, family.strokes(&arrangement.make_edge_curve(e)));
        let edges: Vec<_> = dcel.edges().map(strokes).collect();
        let goes_down = |s: &Stroke| s.is_open[0] && s.ends[0][0] == s.ends[1][0];
        Self {
            vertices: arrangement
                .vertices()
                .filter_map(|v| Some((v, arrangement.point(v)?.coordinates())))
                .collect(),
            above: edges.iter().map(|(e, _)| dcel.face(e.halfedge())).collect(),
            has_one_bottom: !edges.iter().flat_map(|(_, strokes)| strokes).any(goes_down),
            edges,
            period: family.period(),
            corner: arrangement.corner_face(),
        }
    }

    /// The cell of a point; `None` if it is in one of several faces that nothing bounds from below.
    pub(super) fn locate(&self, point: &Point2) -> Option<Cell> {
        let p = point.coordinates();
        if let Some((v, _)) = self.vertices.iter().find(|(_, q)| *q == p) {
            return Some(Cell::Vertex(*v));
        }
        // On a torus, an edge may come to a point of the left or bottom side on the opposite one.
        let zero = [Rational::ZERO, Rational::ZERO];
        let [width, height] = self.period.clone().unwrap_or(zero);
        let copies = [0, 1, 2, 3].map(|i| {
            let is = |bit| Rational::from(i64::from(i & bit != 0));
            [&p[0] + is(1) * &width, &p[1] + is(2) * &height]
        });
        let is_on = |strokes: &[Stroke]| strokes.iter().any(|s| copies.iter().any(|q| s.has_point(q)));
        if let Some((e, _)) = self.edges.iter().find(|(_, strokes)| is_on(strokes)) {
            return Some(Cell::Edge(*e));
        }
        // Just to the right of the point, down.
        let hits = self.edges.iter().zip(&self.above).flat_map(|((_, strokes), face)| {
            strokes.iter().filter_map(|stroke| Some((stroke.above(&p[0])?, *face)))
        });
        let hits: Vec<_> = hits.collect();
        let below = hits.iter().filter(|((v, _), _)| *v < p[1]).max();
        let beyond = || hits.iter().max().filter(|_| self.period.is_some());
        match below.or_else(beyond) {
            Some((_, face)) => Some(Cell::Face(*face)),
            None => (self.period.is_none() && self.has_one_bottom).then_some(Cell::Face(self.corner)),
        }
    }
}
