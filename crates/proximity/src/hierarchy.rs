//! The facet of M whose plane is nearest to a point inside.
//!
//! The depth below a facet is a linear function of the point, and the least one of all is not unimodal over the facets. So it is
//! searched for by branch and bound in a hierarchy of caps of unit normals with least offsets. All bounds are certified; where the
//! bounds of two facets overlap, the exact depths are compared.

use exact::proximity::{DepthBounds, DepthCap, DepthPlane, DepthPoint, QueryPoint, compare_depths};
use exact::{Point3, Sign, Vector3};
use std::cmp::Ordering;

/// A binary tree over the planes of the facets of M.
#[derive(Clone, Debug)]
pub(crate) struct Hierarchy {
    nodes: Vec<Node>,
    /// In the order of the leaves.
    planes: Vec<DepthPlane>,
    facets: Vec<u32>,
    /// Where each facet is in that order.
    places: Vec<u32>,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: DepthCap,
    /// The planes of a leaf; else the first child follows its parent, and the second one is `second`.
    first: u32,
    count: u32,
    second: u32,
}

/// The greatest number of planes of a leaf.
const LEAF: usize = 4;
/// More than the depth of the tree: halves of 2^32 planes.
const DEPTH: usize = 40;

impl Hierarchy {
    /// That of planes, given by the facet.
    pub(crate) fn new(planes: Vec<DepthPlane>) -> Self {
        // Offsets and coordinates of unit normals are made comparable: both as distances within M.
        let scale = planes.iter().map(|plane| plane.approx_f64()[3].abs()).fold(0.0, f64::max);
        let mut tree = Self {
            nodes: Vec::with_capacity(planes.len()),
            planes: Vec::new(),
            facets: (0..planes.len() as u32).collect(),
            places: vec![0; planes.len()],
        };
        let mut facets = std::mem::take(&mut tree.facets);
        tree.build(&planes, &mut facets, 0, [scale, scale, scale, 1.0]);
        tree.planes = facets.iter().map(|&f| planes[f as usize]).collect();
        for (place, &f) in facets.iter().enumerate() {
            tree.places[f as usize] = place as u32;
        }
        tree.facets = facets;
        tree
    }

    /// The tree over some of the facets, which stand at `first`.
    fn build(&mut self, planes: &[DepthPlane], facets: &mut [u32], first: u32, scales: [f64; 4]) {
        let bounds = DepthCap::of(facets.iter().map(|&f| &planes[f as usize]));
        let node = self.nodes.len();
        self.nodes.push(Node { bounds, first, count: facets.len() as u32, second: 0 });
        if facets.len() <= LEAF {
            return;
        }
        let size = |axis: usize| {
            let values = facets.iter().map(|&f| planes[f as usize].approx_f64()[axis]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (value.min(low), value.max(high))
            });
            (high - low) * scales[axis]
        };
        let axis = (0..4).max_by(|&a, &b| size(a).total_cmp(&size(b))).expect("there are four");
        let value = |f: &u32| planes[*f as usize].approx_f64()[axis];
        let half = facets.len() / 2;
        facets.select_nth_unstable_by(half, |f, g| value(f).total_cmp(&value(g)).then(f.cmp(g)));
        let (low, high) = facets.split_at_mut(half);
        self.nodes[node].count = 0;
        self.build(planes, low, first, scales);
        self.nodes[node].second = self.nodes.len() as u32;
        self.build(planes, high, first + half as u32, scales);
    }

    /// The facet below which a point lies the least deep, the first one of several; `None` if the point is not below all.
    ///
    /// `start` is a facet that may be near; `exact` gives the normal of a facet and a point on it, and `side` the side of its
    /// plane on which the point lies.
    pub(crate) fn nearest<'s>(
        &self,
        s: &QueryPoint,
        start: u32,
        exact: impl Fn(u32) -> (&'s Vector3, &'s Point3),
        side: impl Fn(u32) -> Sign,
    ) -> Option<u32> {
        let point = DepthPoint::new(s);
        let is_below = |facet: u32, depth: &DepthBounds| {
            depth.is_positive() || (!depth.is_negative() && side(facet) == Sign::Negative)
        };
        let mut best = start;
        let mut least = self.planes[self.places[start as usize] as usize].depth(&point);
        if !is_below(best, &least) {
            return None;
        }
        let bound = |node: u32| self.nodes[node as usize].bounds.least_depth(&point);
        let mut stack = [0_u32; DEPTH];
        let mut top = 1;
        while top > 0 {
            top -= 1;
            let mut index = stack[top];
            if least.is_below(&bound(index)) {
                continue;
            }
            // Down to a leaf, by the nearer child first.
            while self.nodes[index as usize].count == 0 {
                let (a, b) = (index + 1, self.nodes[index as usize].second);
                let (low_a, low_b) = (bound(a), bound(b));
                let (near, low, far, high) = if low_b.approx_low() < low_a.approx_low() {
                    (b, low_b, a, low_a)
                } else {
                    (a, low_a, b, low_b)
                };
                if !least.is_below(&high) {
                    stack[top] = far;
                    top += 1;
                }
                index = near;
                if least.is_below(&low) {
                    break;
                }
            }
            let leaf = &self.nodes[index as usize];
            for place in leaf.first..leaf.first + leaf.count {
                let (facet, depth) = (self.facets[place as usize], self.planes[place as usize].depth(&point));
                if facet == best || least.is_below(&depth) {
                    continue;
                }
                if !is_below(facet, &depth) {
                    return None;
                }
                let order = if depth.is_below(&least) {
                    Ordering::Less
                } else {
                    compare_depths(s.point(), exact(facet), exact(best)).then(facet.cmp(&best))
                };
                if order == Ordering::Less {
                    (best, least) = (facet, depth);
                }
            }
        }
        Some(best)
    }
}
