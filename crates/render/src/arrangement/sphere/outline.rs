//! Edges as chains of points in the parameter space.

use ::arrangement::Arrangement;
use ::arrangement::topology::Topology;
use ::arrangement::traits::{Along, ApproxTraits, CurveEnd, Location};
use dcel::{EdgeId, HalfedgeId};
use std::array::from_fn;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::error::{RenderError, finite};
use crate::frame::{Frame, Point};

/// The edge of the parameter space, in radians: least and greatest u, least and greatest v.
pub(super) const SIDES: [[f64; 2]; 2] = [[0.0, TAU], [-FRAC_PI_2, FRAC_PI_2]];

/// The rectangle that stands for the sphere.
pub(super) fn rectangle() -> Result<Frame, RenderError> {
    let [[left, right], [bottom, top]] = SIDES;
    Frame::new([left, bottom], [right, top])
}

/// An edge.
#[derive(Clone, Default, Debug)]
pub(super) struct Outline {
    /// At least two points of the rectangle, from the min to the max vertex. Both ends are where their vertex is, to the last
    /// bit, but for the side on which it is drawn.
    pub(super) points: Vec<Point>,
    /// On which side they are.
    pub(super) ends: [Location; 2],
    /// Whether it runs along the identification; then it is drawn at the left.
    pub(super) is_along_seam: bool,
}

/// All edges.
pub(super) struct Outlines {
    edges: Vec<Outline>,
}

impl Outlines {
    /// # Errors
    /// If a parameter is not finite.
    pub(super) fn new<G: ApproxTraits, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
    ) -> Result<Self, RenderError> {
        let mut edges = vec![Outline::default(); arrangement.dcel().edge_bound()];
        for e in arrangement.dcel().edges() {
            edges[e.index()] = outline(arrangement, e)?;
        }
        Ok(Self { edges })
    }

    pub(super) fn edge(&self, e: EdgeId) -> &Outline {
        &self.edges[e.index()]
    }

    /// The points along a halfedge. Along the identification they are at the right if it goes up, and at the left if it goes down:
    /// so the face on its left is in the rectangle.
    pub(super) fn along(&self, h: HalfedgeId) -> Vec<Point> {
        let edge = self.edge(h.edge_id());
        let mut points = edge.points.clone();
        if !h.is_even() {
            points.reverse();
        } else if edge.is_along_seam {
            points = at_right(&points);
        }
        points
    }

    /// On which side the source and the target of a halfedge are, when it is drawn as by [`Outlines::along`].
    pub(super) fn ends_along(&self, h: HalfedgeId) -> [Location; 2] {
        let edge = self.edge(h.edge_id());
        let [min, max] = edge.ends;
        match (h.is_even(), edge.is_along_seam) {
            (true, true) => [min, max].map(|end| Location { u: Along::High, ..end }),
            (true, false) => [min, max],
            (false, _) => [max, min],
        }
    }
}

/// A chain along the left side, moved to the right side.
pub(super) fn at_right(points: &[Point]) -> Vec<Point> {
    points.iter().map(|&[_, v]| [SIDES[0][1], v]).collect()
}

fn outline<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    e: EdgeId,
) -> Result<Outline, RenderError> {
    let (traits, topology) = (arrangement.traits(), arrangement.topology());
    let curve = arrangement.curve_of(e);
    let of_curve = CurveEnd::BOTH.map(|end| topology.end_location(traits, curve, end));
    let is_along_seam = of_curve[0].u == of_curve[1].u && of_curve[0].u != Along::Inside;
    let vertices = arrangement.dcel().ends(e).map(|v| arrangement.point(v));
    let ends: [Location; 2] = from_fn(|k| {
        let v = vertices[k].map_or(of_curve[k], |point| topology.point_location(traits, point)).v;
        let is_on_seam =
            || vertices[k].is_some_and(|p| topology.point_location(traits, p).u != Along::Inside);
        match v {
            _ if is_along_seam => Location { u: Along::Low, v },
            Along::Inside if is_on_seam() => Location { u: of_curve[k].u, v },
            _ => Location { u: Along::Inside, v },
        }
    });

    // A vertex on the seam is one point for both sides: which one this edge reaches, only its curve knows; at a pole likewise.
    let point_of = |k: usize| {
        let is_plain = ends[k].v == Along::Inside && (is_along_seam || ends[k].u == Along::Inside);
        vertices[k].filter(|_| is_plain)
    };
    let [[left, right], [bottom, top]] = SIDES;
    let mut points = Vec::new();
    traits.approx_curve(curve, point_of(0), point_of(1), [left, bottom, right, top], &mut points);
    for point in &mut points {
        finite("a parameter", point)?;
        *point = [point[0].clamp(left, right), point[1].clamp(bottom, top)];
    }
    if points.len() < 2 {
        let any = points.first().copied().unwrap_or([PI, 0.0]);
        points = vec![any; 2];
    }
    let last = points.len() - 1;
    for (k, index) in [(0, 0), (1, last)] {
        let of_vertex = vertices[k].map_or(points[index], |point| traits.approx_point(point));
        finite("a parameter", &of_vertex)?;
        let is_pole = ends[k].v != Along::Inside;
        let inside = [if is_pole { points[index] } else { of_vertex }[0], of_vertex[1]];
        points[index] = from_fn(|axis| match [ends[k].u, ends[k].v][axis] {
            Along::Low => SIDES[axis][0],
            Along::Inside => inside[axis].clamp(SIDES[axis][0], SIDES[axis][1]),
            Along::High => SIDES[axis][1],
        });
    }
    if is_along_seam {
        points.iter_mut().for_each(|point| point[0] = left);
    }
    Ok(Outline { points, ends, is_along_seam })
}
