//! Hulls of collinear and of coplanar points.

use exact::{Sign, Vector3};

use super::sites::Sites;

/// Returns the two ends of a set of collinear points that are not all equal.
///
/// # Complexity
/// O(n) comparisons.
pub(super) fn segment(sites: &Sites<'_>) -> [u32; 2] {
    let at = |p: u32| &sites.points[p as usize];
    let mut ends = [sites.distinct[0]; 2];
    for &p in &sites.distinct[1..] {
        if at(p) < at(ends[0]) {
            ends[0] = p;
        } else if at(p) > at(ends[1]) {
            ends[1] = p;
        }
    }
    ends
}

/// Returns the vertices of the hull of coplanar points that are not all collinear, counterclockwise for
/// `normal`.
///
/// Andrew's chain, in lexicographic order of all three coordinates. In a plane this is the lexicographic
/// order for two independent coordinates of the plane, whatever its position, and that is all the chain
/// needs.
///
/// # Complexity
/// O(n log n) comparisons, O(n) orientations; an orientation is one coordinate of a cross product of two
/// edges.
pub(super) fn polygon(sites: &Sites<'_>, normal: &Vector3) -> Vec<u32> {
    let at = |p: u32| &sites.points[p as usize];
    // The projection along this axis is one-to-one on the plane, and the sign says whether it keeps the
    // orientation.
    let (axis, up) = (0..3)
        .map(|axis| (axis, normal.coordinate(axis).sign()))
        .find(|&(_, sign)| sign != Sign::Zero)
        .expect("a normal is not zero");
    let turns_left = |a: u32, b: u32, c: u32| {
        at(a).direction_to(at(b)).cross(&at(b).direction_to(at(c))).coordinate(axis).sign() == up
    };

    let mut order = sites.distinct.clone();
    order.sort_unstable_by(|&p, &q| at(p).cmp(at(q)).then(p.cmp(&q)));
    // What the search by hash has missed.
    order.dedup_by(|q, p| at(*q) == at(*p));

    let mut cycle: Vec<u32> = Vec::new();
    let mut half = |points: &mut dyn Iterator<Item = u32>| {
        let start = cycle.len();
        for p in points {
            while let [.., a, b] = cycle[start..]
                && !turns_left(a, b, p)
            {
                cycle.pop();
            }
            cycle.push(p);
        }
        // The last point of one half is the first one of the other.
        cycle.pop();
    };
    half(&mut order.iter().copied());
    half(&mut order.iter().rev().copied());
    cycle
}
