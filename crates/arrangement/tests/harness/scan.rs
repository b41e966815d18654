//! Location by a scan over all cells, in coordinates: without predicates of the library, and without a sweep.

use crate::curves::P;
use crate::oracle::{Cells, EdgeKey, line_key};
use crate::queries::sample;
use dcel::{EdgeId, FaceId, VertexId};
use exact::Rational;
use exact::planar::Point2;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::{Along, CurveEnd, UMonotoneTraits};

/// The cells of an arrangement in coordinates; on a torus in those of the closed rectangle.
pub(crate) struct Scan {
    vertices: Vec<(VertexId, P)>,
    edges: Vec<(EdgeId, EdgeKey)>,
    /// For each edge the faces above and below; left and right of an edge that goes up.
    faces: Vec<[FaceId; 2]>,
    corner: FaceId,
    is_torus: bool,
}

/// A stretch of an edge as it is met by a ray: where, how it is inclined there, and the faces before and behind.
struct Hit {
    at: Rational,
    slope: Rational,
    faces: [FaceId; 2],
}

impl Scan {
    /// `keys` has the edges in the plane, unless the arrangement is on a torus with given periods.
    pub(crate) fn new<G: UMonotoneTraits<Point = Point2>, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        keys: &Cells,
        period: Option<&P>,
    ) -> Self {
        let dcel = arrangement.dcel();
        let coordinates = |v| arrangement.point(v).map(Point2::coordinates);
        let edge = |e: EdgeId| match period {
            Some(period) => (e, key_on_torus(arrangement, e, period)),
            None => {
                let ends = dcel.ends(e).map(coordinates);
                let curve = arrangement.make_edge_curve(e);
                let is_it = |key: &&EdgeKey| {
                    let middle = Point2::from_rationals(&sample(key));
                    key.0 == ends && arrangement.traits().is_on_curve(&middle, &curve)
                };
                let key = keys.edges.iter().find(is_it).expect("brute force knows every edge");
                (e, key.clone())
            }
        };
        let edges: Vec<(EdgeId, EdgeKey)> = dcel.edges().map(edge).collect();
        let faces = |&(e, _): &(EdgeId, EdgeKey)| {
            let h = e.halfedge();
            [dcel.face(h), dcel.face(h.twin())]
        };
        Self {
            vertices: arrangement.vertices().filter_map(|v| Some((v, coordinates(v)?))).collect(),
            faces: edges.iter().map(faces).collect(),
            edges,
            corner: arrangement.corner_face(),
            is_torus: period.is_some(),
        }
    }

    /// Points of edges, with the edges.
    pub(crate) fn edge_samples(&self) -> impl Iterator<Item = (EdgeId, P)> + '_ {
        self.edges.iter().map(|(e, key)| (*e, sample(key)))
    }

    pub(crate) fn vertices(&self) -> &[(VertexId, P)] {
        &self.vertices
    }

    /// Finds the cell of a point; `None` if it sees no edge in any of four directions, and so its face is not known.
    pub(crate) fn locate(&self, p: &P) -> Option<Cell> {
        if let Some((v, _)) = self.vertices.iter().find(|(_, q)| p == q) {
            return Some(Cell::Vertex(*v));
        }
        if let Some((e, _)) = self.edges.iter().find(|(_, key)| is_on(key, p)) {
            return Some(Cell::Edge(*e));
        }
        let is_bounded = |(_, (ends, _)): &(EdgeId, EdgeKey)| ends.iter().all(Option::is_some);
        let is_plain = self.edges.is_empty() || !self.is_torus && self.edges.iter().all(is_bounded);
        let face = [self.hits_above_or_below(p), self.hits_beside(p)]
            .into_iter()
            .enumerate()
            .find_map(|(axis, hits)| self.nearest(&hits, &p[1 - axis]))
            .or(is_plain.then_some(self.corner));
        face.map(Cell::Face)
    }

    /// The face between hits at a coordinate.
    fn nearest(&self, hits: &[Hit], at: &Rational) -> Option<FaceId> {
        let key = |hit: &&Hit| (hit.at.clone(), hit.slope.clone());
        let before = hits.iter().filter(|hit| hit.at < *at).max_by_key(key);
        let round = || hits.iter().max_by_key(key).filter(|_| self.is_torus);
        let behind = || hits.iter().min_by_key(key).map(|hit| hit.faces[0]);
        before.or_else(round).map(|hit| hit.faces[1]).or_else(behind)
    }

    /// What meets the vertical line immediately to the right of a point; faces below and above.
    fn hits_above_or_below(&self, p: &P) -> Vec<Hit> {
        let mut hits = Vec::new();
        for ((_, ([min, max], (slope, offset))), [above, below]) in self.edges.iter().zip(&self.faces) {
            let Some(slope) = slope else { continue };
            let is_met =
                min.as_ref().is_none_or(|min| min[0] <= p[0]) && max.as_ref().is_none_or(|max| p[0] < max[0]);
            if is_met {
                let at = slope * &p[0] + offset;
                hits.push(Hit { at, slope: slope.clone(), faces: [*below, *above] });
            }
        }
        hits
    }

    /// What meets the horizontal line immediately above a point; faces left and right.
    fn hits_beside(&self, p: &P) -> Vec<Hit> {
        let mut hits = Vec::new();
        for ((_, ([min, max], (slope, offset))), [above, below]) in self.edges.iter().zip(&self.faces) {
            let (at, inverse, is_falling) = match slope {
                None => (offset.clone(), Rational::ZERO, false),
                Some(slope) => match slope.recip() {
                    None => continue,
                    Some(inverse) => ((&p[1] - offset) * &inverse, inverse, *slope < Rational::ZERO),
                },
            };
            let [low, high] = if is_falling { [max, min] } else { [min, max] };
            let is_met = low.as_ref().is_none_or(|low| low[1] <= p[1])
                && high.as_ref().is_none_or(|high| p[1] < high[1]);
            if is_met {
                let faces = if is_falling { [*below, *above] } else { [*above, *below] };
                hits.push(Hit { at, slope: inverse, faces });
            }
        }
        hits
    }
}

/// Tells whether a point is on an edge, ends included.
fn is_on(([min, max], (slope, offset)): &EdgeKey, p: &P) -> bool {
    let is_on_line = match slope {
        Some(slope) => p[1] == slope * &p[0] + offset,
        None => p[0] == *offset,
    };
    is_on_line && min.as_ref().is_none_or(|min| min <= p) && max.as_ref().is_none_or(|max| p <= max)
}

fn key_on_torus<G: UMonotoneTraits<Point = Point2>, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    e: EdgeId,
    period: &P,
) -> EdgeKey {
    let (traits, curve) = (arrangement.traits(), arrangement.make_edge_curve(e));
    let [min, max] = CurveEnd::BOTH.map(|end| {
        let location = arrangement.topology().end_location(traits, &curve, end);
        let [x, y] = traits.end_point(&curve, end).expect("an end on a torus is a point").coordinates();
        let shifted = |value: Rational, along: Along, period: &Rational| {
            if along == Along::High { value + period } else { value }
        };
        [shifted(x, location.u, &period[0]), shifted(y, location.v, &period[1])]
    });
    let line = line_key(&min, &max);
    ([Some(min), Some(max)], line)
}
