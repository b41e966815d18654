//! Location on the sphere by a scan over all cells in integers: no predicate of the library is asked.

use super::drawn::{Drawn, Made};
use dcel::{EdgeId, FaceId, VertexId};
use exact::{Integer, Sign};
use splitstar_arrangement::overlay::Cell;
use std::cmp::Ordering;
use std::fmt;

/// A vector.
pub(super) type V = [Integer; 3];

fn dot(a: &V, b: &V) -> Integer {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &V, b: &V) -> V {
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn turn(a: &V, b: &V, c: &V) -> Sign {
    dot(a, &cross(b, c)).sign()
}

fn is_zero(a: &V) -> bool {
    a.iter().all(Integer::is_zero)
}

fn opposite(a: &V) -> V {
    a.each_ref().map(|x| -x)
}

/// Without a common factor.
pub(super) fn primitive(a: &V) -> V {
    let factor = a[0].gcd(&a[1]).gcd(&a[2]);
    a.each_ref().map(|x| x.div_exact(&factor))
}

fn is_same(a: &V, b: &V) -> bool {
    is_zero(&cross(a, b)) && dot(a, b).sign() == Sign::Positive
}

/// How far a direction is, counterclockwise round a normal from a start: in the first half turn, opposite, in the second.
fn quarter(normal: &V, start: &V, a: &V) -> u8 {
    match turn(normal, start, a) {
        Sign::Positive => 1,
        Sign::Negative => 3,
        Sign::Zero if dot(start, a).sign() == Sign::Positive => 0,
        Sign::Zero => 2,
    }
}

/// Which of two directions of a circle comes first, counterclockwise round its normal from a start.
fn compare_way(normal: &V, start: &V, a: &V, b: &V) -> Ordering {
    let [of_a, of_b] = [a, b].map(|x| quarter(normal, start, x));
    of_a.cmp(&of_b).then_with(|| match turn(normal, a, b) {
        Sign::Positive => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Negative => Ordering::Greater,
    })
}

/// An arc counterclockwise round a normal from one end to the other; all round, if the ends are the same.
#[derive(Clone, PartialEq)]
pub(super) struct Stroke {
    pub(super) normal: V,
    pub(super) ends: [V; 2],
}

impl fmt::Debug for Stroke {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { normal, ends: [a, b] } = self;
        let [a, b, normal] = [a, b, normal].map(|[x, y, z]| format!("{x} {y} {z}"));
        write!(f, "{a} .. {b} round {normal}")
    }
}

impl Stroke {
    fn has(&self, p: &V) -> bool {
        let [a, b] = &self.ends;
        dot(&self.normal, p).is_zero() && (is_same(a, b) || compare_way(&self.normal, a, p, b).is_le())
    }

    /// Some points between the ends.
    pub(super) fn inner_points(&self) -> Vec<V> {
        let [a, b] = &self.ends;
        let ahead = cross(&self.normal, a);
        let sum = |p: &V, q: &V| [0, 1, 2].map(|i| &p[i] + &q[i]);
        let mut points = vec![opposite(a), ahead.clone(), opposite(&ahead)];
        points.extend([sum(a, &ahead), sum(a, &opposite(&ahead)), sum(a, b), opposite(&sum(a, b))]);
        points.retain(|p| !is_zero(p) && self.has(p) && !self.ends.iter().any(|end| is_same(end, p)));
        points.iter().map(primitive).collect()
    }
}

/// The cells of an arrangement in coordinates.
pub(super) struct Scan {
    vertices: Vec<(VertexId, V)>,
    strokes: Vec<(EdgeId, Stroke)>,
    /// The faces to the left and to the right of each stroke.
    faces: Vec<[FaceId; 2]>,
    /// The only face, if there is no edge.
    corner: FaceId,
}

impl Scan {
    pub(super) fn new<F: Drawn<Place = V, Stroke = Stroke>>(family: &F, arrangement: &Made<F>) -> Self {
        let dcel = arrangement.dcel();
        let of_edge = |e| family.strokes(&arrangement.make_edge_curve(e)).into_iter().map(move |s| (e, s));
        let strokes: Vec<(EdgeId, Stroke)> = dcel.edges().flat_map(of_edge).collect();
        let beside = |e: EdgeId| [e.halfedge(), e.halfedge().twin()].map(|h| dcel.face(h));
        let vertex = |v| Some((v, family.place(arrangement.point(v)?)));
        Self {
            vertices: arrangement.vertices().filter_map(vertex).collect(),
            faces: strokes.iter().map(|&(e, _)| beside(e)).collect(),
            strokes,
            corner: arrangement.corner_face(),
        }
    }

    /// The cell of a point; `None` if no way from it to an edge is found that passes beside all vertices.
    pub(super) fn locate(&self, p: &V) -> Option<Cell> {
        if let Some((v, _)) = self.vertices.iter().find(|(_, q)| is_same(q, p)) {
            return Some(Cell::Vertex(*v));
        }
        if let Some((e, _)) = self.strokes.iter().find(|(_, stroke)| stroke.has(p)) {
            return Some(Cell::Edge(*e));
        }
        if self.strokes.is_empty() {
            return Some(Cell::Face(self.corner));
        }
        let targets = self.strokes.iter().flat_map(|(_, stroke)| stroke.inner_points());
        targets.take(12).find_map(|q| self.first_face(p, &q)).map(Cell::Face)
    }

    /// The face in which the shorter arc from a point of no edge to one of an edge begins; `None` if something on the way is degenerate.
    fn first_face(&self, p: &V, q: &V) -> Option<FaceId> {
        let normal = cross(p, q);
        if is_zero(&normal) {
            return None;
        }
        let is_ahead = |a: &V, b: &V| turn(&normal, a, b) == Sign::Positive;
        // All that is considered is less than half a circle away.
        let is_on_way = |x: &V| dot(&normal, x).is_zero() && is_ahead(p, x) && !is_ahead(q, x);
        let corners = self.strokes.iter().flat_map(|(_, stroke)| &stroke.ends);
        if self.vertices.iter().map(|(_, x)| x).chain(corners).any(is_on_way) {
            return None;
        }
        let mut first: Option<(V, FaceId)> = None;
        for ((_, stroke), [left, right]) in self.strokes.iter().zip(&self.faces) {
            let axis = cross(&normal, &stroke.normal);
            if is_zero(&axis) {
                continue;
            }
            for x in [opposite(&axis), axis] {
                let is_first = first.as_ref().is_none_or(|(other, _)| is_ahead(&x, other));
                if is_first && is_on_way(&x) && stroke.has(&x) {
                    let is_left = dot(&stroke.normal, p).sign() == Sign::Positive;
                    first = Some((x, if is_left { *left } else { *right }));
                }
            }
        }
        first.map(|(_, face)| face)
    }
}
