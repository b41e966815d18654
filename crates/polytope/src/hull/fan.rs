//! Which triangle of a large cone sees a point.

use exact::predicate::orientation;
use exact::{Sign, Vector3};

use super::quickhull::Builder;

/// The cone of the latest insertion, prepared for searching.
///
/// Let p be the apex and v_0, ..., v_{k-1} the other vertices in cyclic order; triangle i of the cone has the
/// corners v_i, v_{i+1} and p. The planes through p, v_0 and one other vertex cut the cone into k - 2
/// sectors.
///
/// Without this, a large cone would cost the product of its size and the number of orphans. An example is a
/// flat dome over a polygon of many vertices: its top comes before all its other points.
pub(super) struct Fan {
    apex: u32,
    /// From the apex to v_0.
    spoke: Vector3,
}

impl Fan {
    /// Rotates the cone so that its first and its last triangle, which meet in the edge p v_0, are not
    /// coplanar.
    ///
    /// # Complexity
    /// O(1) side tests, or O(k) if many neighbours are coplanar.
    pub(super) fn new(builder: &mut Builder<'_>) -> Self {
        let cone = &builder.cone;
        let is_sharp = |&at: &usize| {
            let before = cone[if at == 0 { cone.len() - 1 } else { at - 1 }];
            let [_, following, _] = builder.corners(cone[at]);
            builder.side(before, following) != Sign::Zero
        };
        let start = (0..cone.len()).find(is_sharp).expect("a hull has a corner at its new vertex");
        builder.cone.rotate_left(start);
        let [first, _, apex] = builder.corners(builder.cone[0]);
        Self { apex, spoke: builder.direction(apex, first) }
    }

    /// Finds a triangle of the cone that sees `q`.
    ///
    /// If neither triangle at v_0 sees q, then q lies in a sector: q - p = a (v_0 - p) + b (v_i - p) + c
    /// (v_{i+1} - p) with b, c >= 0, and i is found by halving. For a >= 0, q is in the cone. For a < 0,
    /// triangle i sees q, unless v_0 is in the plane of this triangle. That happens only in the planes of the
    /// first and of the last triangle, if these contain further triangles; a point q in one of the two planes
    /// is therefore taken to the first sector that is not in it.
    ///
    /// # Complexity
    /// O(log k) signs of degree 3.
    pub(super) fn find(&self, builder: &Builder<'_>, q: u32) -> Option<u32> {
        let cone = &builder.cone;
        let (first, last) = (cone[0], cone[cone.len() - 1]);
        if builder.sees(first, q) {
            return Some(first);
        }
        if builder.sees(last, q) {
            return Some(last);
        }
        let to_q = builder.direction(self.apex, q);
        let (mut low, mut high) = (1, cone.len() - 1);
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            let [v, ..] = builder.corners(cone[middle]);
            let is_before = match orientation(&self.spoke, &builder.direction(self.apex, v), &to_q) {
                Sign::Negative => false,
                Sign::Positive => true,
                // Out of the plane of the first triangle, or out of that of the last. Elsewhere both sectors
                // will do.
                Sign::Zero => builder.side(first, v) != Sign::Zero,
            };
            if is_before {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some(cone[low]).filter(|&t| builder.sees(t, q))
    }
}
