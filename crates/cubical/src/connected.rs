//! The arrangement of a side whose vertices and edges are known, without a sweep.

use crate::map::SideArrangement;
use arrangement::models::{Segment, SegmentTraits};
use arrangement::topology::BoundedPlane;
use arrangement::{Arrangement, Parts};
use dcel::{CcbId, CcbKind, Dcel, FaceId, Halfedge, HalfedgeId, RawCcb, RawDcel, VertexId};
use exact::planar::{Point2, compare_xy};
use std::cmp::Ordering;

/// An edge of a side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct KnownEdge {
    /// The position of the segment on which it lies.
    pub(crate) support: u32,
    /// The positions of its ends among the points, the lesser one first.
    pub(crate) ends: [u32; 2],
}

/// Puts the arrangement of a side together. Edges have the ids of their positions; the ids of vertices are given for each point.
///
/// # Preconditions
/// The points are different, the edges meet in common ends only, all are connected, and every point has an edge. Debug builds check it.
///
/// # Complexity
/// Linear, but for the order of the points: O(n log n).
pub(crate) fn of_connected(
    points: Vec<Point2>,
    curves: Vec<Segment>,
    edges: &[KnownEdge],
) -> (SideArrangement, Vec<VertexId>) {
    let (points, ids) = in_order(points);
    let (starts, around) = rotations(points.len(), &curves, edges, &ids);
    let none =
        Halfedge { next: HalfedgeId::NONE, prev: HalfedgeId::NONE, source: VertexId::NONE, ccb: CcbId::NONE };
    let mut halfedges = vec![none; around.len()];
    let mut outgoing = Vec::with_capacity(points.len());
    for (v, range) in starts.windows(2).enumerate() {
        let leaving = &around[range[0] as usize..range[1] as usize];
        let mut before = *leaving.last().expect("every point has an edge");
        outgoing.push(before);
        for &h in leaving {
            halfedges[h.index()].source = VertexId::new(v);
            // What comes to a vertex goes on along the clockwise neighbour.
            halfedges[h.twin().index()].next = before;
            before = h;
        }
    }
    // The last halfedge around the first vertex has nothing but the unbounded face on its left.
    let mut ccbs = vec![trace(&mut halfedges, outgoing[0], 0, CcbKind::Inner)];
    for h in 0..halfedges.len() {
        if halfedges[h].ccb == CcbId::NONE {
            let ccb = trace(&mut halfedges, HalfedgeId::new(h), ccbs.len(), CcbKind::Outer);
            ccbs.push(ccb);
        }
    }
    let parts = Parts {
        is_artificial: vec![false; points.len()],
        points: points.into_iter().map(Some).collect(),
        curves,
        supports: edges.iter().map(|edge| edge.support).collect(),
        corner_face: FaceId(0),
        dcel: Dcel::from_parts(RawDcel {
            face_count: ccbs.len(),
            ccbs,
            isolated: Vec::new(),
            halfedges,
            outgoing,
        }),
    };
    (Arrangement::from_trusted_parts(SegmentTraits, BoundedPlane, parts), ids)
}

/// The points in lexicographic order, which an overlay likes, and for each of them its new position.
fn in_order(points: Vec<Point2>) -> (Vec<Point2>, Vec<VertexId>) {
    let mut order: Vec<(u64, u32)> = (0..).zip(&points).map(|(i, p)| (p.order_key(), i)).collect();
    // Different keys that are not zero tell the order.
    order.sort_unstable_by(|&(a, i), &(b, j)| match a != b && a != 0 && b != 0 {
        true => a.cmp(&b),
        false => compare_xy(&points[i as usize], &points[j as usize]),
    });
    let mut ids = vec![VertexId::NONE; points.len()];
    for (place, &(_, i)) in order.iter().enumerate() {
        ids[i as usize] = VertexId::new(place);
    }
    let mut points: Vec<Option<Point2>> = points.into_iter().map(Some).collect();
    let taken = order.iter().map(|&(_, i)| points[i as usize].take().expect("a point is taken once"));
    (taken.collect(), ids)
}

/// For each vertex where its halfedges begin, and one more at the end; and the halfedges that leave them, counterclockwise, beginning below.
fn rotations(
    vertices: usize,
    curves: &[Segment],
    edges: &[KnownEdge],
    ids: &[VertexId],
) -> (Vec<u32>, Vec<HalfedgeId>) {
    let mut starts = vec![0; vertices + 1];
    let ends = || edges.iter().flat_map(|edge| edge.ends).map(|end| ids[end as usize].index());
    ends().for_each(|v| starts[v] += 1);
    let mut sum = 0;
    for start in &mut starts {
        sum += *start;
        *start = sum;
    }
    let mut around = vec![HalfedgeId::NONE; 2 * edges.len()];
    for (h, v) in ends().enumerate() {
        starts[v] -= 1;
        around[starts[v] as usize] = HalfedgeId::new(h);
    }
    // To the right from below, then to the left from above: both by growing slope, and vertical ones last.
    let slope = |h: HalfedgeId| curves[edges[h.edge()].support as usize].line();
    let compare = |&g: &HalfedgeId, &h: &HalfedgeId| match (g.is_even(), h.is_even()) {
        (true, false) => Ordering::Less,
        (false, true) => Ordering::Greater,
        _ => slope(g).compare_slope(slope(h)),
    };
    for range in starts.windows(2) {
        around[range[0] as usize..range[1] as usize].sort_unstable_by(compare);
    }
    (starts, around)
}

/// Gives a CCB to all halfedges of a cycle. The face has the same number.
fn trace(halfedges: &mut [Halfedge], first: HalfedgeId, number: usize, kind: CcbKind) -> RawCcb {
    let mut h = first;
    loop {
        let halfedge = &mut halfedges[h.index()];
        halfedge.ccb = CcbId::new(number);
        h = halfedge.next;
        if h == first {
            return RawCcb { first, face: FaceId::new(number), kind };
        }
    }
}
