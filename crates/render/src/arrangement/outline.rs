//! Edges as chains of points.

use ::arrangement::Arrangement;
use ::arrangement::topology::Topology;
use ::arrangement::traits::{Along, ApproxTraits, CurveEnd, Location};
use dcel::{EdgeId, HalfedgeId};

use crate::error::{RenderError, finite};
use crate::frame::{Frame, Point};

/// All edges as chains, and the rectangles.
pub(super) struct Outlines {
    /// What the picture shows.
    pub(super) shown: Frame,
    /// All vertices are inside, every edge meets it, and unbounded edges end on its boundary. On a torus: the rectangle.
    pub(super) window: Frame,
    /// Whether what happens is too small against its distance from the origin for doubles to show it.
    pub(super) is_collapsed: bool,
    chains: Vec<Vec<Point>>,
    /// On a torus, the axes along whose sides edges run.
    sides: Vec<(EdgeId, usize)>,
}

/// Below this part of the largest coordinate, an extent has few doubles in it.
const COARSE: f64 = 1e-9;

impl Outlines {
    pub(super) fn new<G: ApproxTraits, T: Topology<G>>(
        arrangement: &Arrangement<G, T>,
        shown: Option<Frame>,
        is_torus: bool,
    ) -> Result<Self, RenderError> {
        let bounds = bounds(arrangement)?;
        let has_extent =
            arrangement.vertices().nth(1).is_some() || arrangement.dcel().edges().next().is_some();
        let is_collapsed = has_extent && !is_torus && bounds.is_some_and(|bounds| is_coarse(&bounds));
        let around = bounds.map(|bounds| bounds.with_margin(0.08));
        let shown = shown.or(around).unwrap_or(Frame::UNIT);
        let window = if is_torus { shown } else { around.map_or(shown, |around| around.union(shown)) };
        let mut chains = vec![Vec::new(); arrangement.dcel().edge_bound()];
        let mut sides = Vec::new();
        for e in arrangement.dcel().edges() {
            let chain = make_chain(arrangement, e, &window);
            for point in &chain {
                finite("a coordinate", point)?;
            }
            chains[e.index()] = chain;
            if is_torus {
                sides.extend(axis_of_side(end_locations(arrangement, e)).map(|axis| (e, axis)));
            }
        }
        Ok(Self { shown, window, is_collapsed, chains, sides })
    }

    /// An edge wherever it is drawn: on a torus, one along a side is drawn along the opposite one, too.
    pub(super) fn edge_copies(&self, e: EdgeId) -> Vec<Vec<Point>> {
        let chain = self.chain(e);
        if chain.is_empty() {
            return Vec::new();
        }
        let mut copies = vec![chain.to_vec()];
        // Edges are in the order of their ids.
        if let Ok(index) = self.sides.binary_search_by_key(&e, |&(e, _)| e) {
            let axis = self.sides[index].1;
            let [low, high] = [self.window.min()[axis], self.window.max()[axis]];
            let is_low = chain[0][axis] - low < high - chain[0][axis];
            let move_by = if is_low { high - low } else { low - high };
            let moved = chain.iter().map(|&point| {
                let mut point = point;
                point[axis] += move_by;
                point
            });
            copies.push(moved.collect());
        }
        copies
    }

    /// The points along an edge, from its min to its max vertex.
    pub(super) fn chain(&self, e: EdgeId) -> &[Point] {
        &self.chains[e.index()]
    }

    /// The points along a halfedge.
    pub(super) fn along(&self, h: HalfedgeId) -> Vec<Point> {
        let mut chain = self.chain(h.edge_id()).to_vec();
        if !h.is_even() {
            chain.reverse();
        }
        chain
    }

    /// A vertex wherever it is drawn: on a torus, a point on a seam is drawn on both of its sides.
    pub(super) fn copies(&self, at: Point, location: Location, is_torus: bool) -> Vec<Point> {
        let (min, max) = (self.window.min(), self.window.max());
        let along = |axis: usize, along: Along| match along {
            Along::Inside => vec![at[axis]],
            _ if is_torus => vec![min[axis], max[axis]],
            _ => vec![at[axis]],
        };
        let (us, vs) = (along(0, location.u), along(1, location.v));
        us.iter().flat_map(|&u| vs.iter().map(move |&v| [u, v])).collect()
    }
}

/// Whether a rectangle is small against its distance from the origin.
fn is_coarse(bounds: &Frame) -> bool {
    let size = bounds.min().iter().chain(&bounds.max()).fold(0.0_f64, |size, c| size.max(c.abs()));
    let [width, height] = bounds.half_extent();
    2.0 * width.max(height) < COARSE * size
}

/// Where the ends of an edge's curve are.
fn end_locations<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    e: EdgeId,
) -> [Location; 2] {
    let (traits, curve) = (arrangement.traits(), arrangement.curve_of(e));
    CurveEnd::BOTH.map(|end| arrangement.topology().end_location(traits, curve, end))
}

/// The axis whose side a curve runs along, if it does: 0 for the sides at the left and at the right.
fn axis_of_side([min_end, max_end]: [Location; 2]) -> Option<usize> {
    let runs_along_side = |a: Along, b: Along| a == b && a != Along::Inside;
    [runs_along_side(min_end.u, max_end.u), runs_along_side(min_end.v, max_end.v)]
        .iter()
        .position(|&runs| runs)
}

/// A rectangle around all vertices and bounded edges that every unbounded edge meets.
fn bounds<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
) -> Result<Option<Frame>, RenderError> {
    let (traits, dcel) = (arrangement.traits(), arrangement.dcel());
    let mut bounds: Option<Frame> = None;
    let mut add = |point: Point| -> Result<(), RenderError> {
        finite("a coordinate", &point)?;
        bounds = bounds.into_iter().chain(Frame::around([point])).reduce(Frame::union);
        Ok(())
    };
    for v in dcel.vertices() {
        if let Some(point) = arrangement.point(v) {
            add(traits.approx_point(point))?;
        }
    }
    for e in dcel.edges() {
        let ends = dcel.ends(e).map(|v| arrangement.is_at_infinity(v));
        if ends == [true, true] {
            nearest_chain(arrangement, e).into_iter().try_for_each(&mut add)?;
        } else if ends == [false, false] {
            make_chain(arrangement, e, &Frame::UNIT).into_iter().try_for_each(&mut add)?;
        }
    }
    Ok(bounds)
}

/// A part of an edge without vertices near the origin: that within the least of some squares that it meets.
fn nearest_chain<G: ApproxTraits, T: Topology<G>>(arrangement: &Arrangement<G, T>, e: EdgeId) -> Vec<Point> {
    let mut half = 1.0;
    while half < 1e300 {
        if let Ok(window) = Frame::new([-half, -half], [half, half]) {
            let chain = make_chain(arrangement, e, &window);
            if chain.iter().any(|&point| window.contains(point)) {
                return chain.into_iter().map(|point| window.clamp(point)).collect();
            }
        }
        half *= 4.0;
    }
    Vec::new()
}

fn make_chain<G: ApproxTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    e: EdgeId,
    window: &Frame,
) -> Vec<Point> {
    let (traits, topology) = (arrangement.traits(), arrangement.topology());
    let curve = arrangement.curve_of(e);
    let [min_end, max_end] = end_locations(arrangement, e);
    let is_along = axis_of_side([min_end, max_end]).is_some();
    // A vertex on a seam is one point for both sides: which one this edge reaches, only its curve knows.
    let point_of = |k: usize, end: Location| {
        let point = arrangement.point(arrangement.dcel().ends(e)[k])?;
        let is_on_side = !topology.point_location(traits, point).is_interior();
        (is_along || !is_on_side || end.is_interior()).then_some(point)
    };
    let mut chain = Vec::new();
    let [min, max] = [window.min(), window.max()];
    let (first, last) = (point_of(0, min_end), point_of(1, max_end));
    traits.approx_curve(curve, first, last, [min[0], min[1], max[0], max[1]], &mut chain);
    chain
}
