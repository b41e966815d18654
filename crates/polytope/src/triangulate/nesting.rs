//! Which cycle of a facet is around which.
//!
//! The corners are visited from left to right, as in [`super::sweep`]. At the first corner of a hole, the edge
//! next below the hole is that of the outer cycle around it, or that of another hole inside the same one: which
//! has been visited, for edges that begin at one corner are looked at from bottom to top.

use super::outline::Outline;
use super::status::Status;
use exact::{Point3, Sign, Vector3};

const NONE: u32 = u32::MAX;

/// Cycles cross, or have an edge without length.
struct Crossing;

/// The outer cycle next around each hole. The outer cycles come first; all are in a plane with that normal, have
/// two corners or more, and may touch one another and themselves at vertices, and run through an edge both ways.
///
/// Degenerate: of a hole that is in no outer cycle, or where cycles overlap, any is given. `None` if cycles are
/// found to cross, or have an edge without length.
///
/// # Complexity
/// `k log k` tests for k corners.
pub(crate) fn outer_cycles(
    points: &[Point3],
    normal: Vector3,
    cycles: &[&[u32]],
    outers: usize,
) -> Option<Vec<usize>> {
    let outline = Outline::new(points, normal, true, cycles.iter().copied()).ok()?;
    // Each corner has an edge, in the same order.
    let cycle_of: Vec<u32> =
        (0..).zip(cycles).flat_map(|(c, cycle)| std::iter::repeat_n(c, cycle.len())).collect();
    // How many edges end at each place.
    let mut ends = vec![0_usize; outline.vertices.len()];
    outline.edges.iter().for_each(|edge| ends[outline.rank(edge.high) as usize] += 1);
    // Of each cycle the outer one that it is, or that is around it.
    let mut outer_of: Vec<u32> =
        (0..cycles.len()).map(|c| if c < outers { c as u32 } else { NONE }).collect();
    let mut status = Status::new(outline.edges.len());
    let swept = outline.visit_corners(|at, starting| {
        let place = status.search(|edge| outline.side(edge, at) == Sign::Positive);
        let ends_here = |edge: &u32| outline.rank(outline.edge(*edge).high) == outline.rank(at);
        let count = status.from(place).take_while(ends_here).count();
        let passes = status.from(place).nth(count).is_some_and(|edge| outline.side(edge, at) == Sign::Zero);
        if passes || count != ends[outline.rank(at) as usize] {
            return Err(Crossing);
        }
        outline.sort_starting(starting);
        let mut below = status.below(place);
        for &edge in &*starting {
            let around = below.map_or(0, |below| outer_of[cycle_of[below as usize] as usize]);
            let outer = &mut outer_of[cycle_of[edge as usize] as usize];
            if *outer == NONE {
                *outer = around;
            }
            below = Some(edge);
        }
        status.replace(place, count, starting);
        Ok(())
    });
    swept.ok()?;
    Some(outer_of[outers..].iter().map(|&outer| outer as usize).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nested(points: &[[i64; 3]], cycles: &[&[u32]], outers: usize) -> Option<Vec<usize>> {
        let points: Vec<Point3> = points.iter().copied().map(Point3::from_i64).collect();
        // Seen from the front and from the back, and along another axis.
        let found = outer_cycles(&points, Vector3::from_i64([0, 0, 1]), cycles, outers);
        let turned: Vec<Vec<u32>> = cycles.iter().map(|c| c.iter().rev().copied().collect()).collect();
        let turned: Vec<&[u32]> = turned.iter().map(|cycle| &cycle[..]).collect();
        assert_eq!(outer_cycles(&points, Vector3::from_i64([0, 0, -1]), &turned, outers), found);
        found
    }

    #[test]
    fn rows() {
        // Two squares that touch at a corner, and two small ones in each.
        let squares = |list: &[[i64; 3]]| -> Vec<[i64; 3]> {
            list.iter()
                .flat_map(|&[x, y, size]| {
                    [[x, y, 0], [x + size, y, 0], [x + size, y + size, 0], [x, y + size, 0]]
                })
                .collect()
        };
        let points = squares(&[[0, 0, 9], [9, 9, 9], [1, 1, 2], [10, 10, 2], [4, 1, 2], [10, 13, 2]]);
        let outers: [&[u32]; 2] = [&[0, 1, 2, 3], &[4, 5, 6, 7]];
        let holes: [&[u32]; 4] = [&[8, 11, 10, 9], &[12, 15, 14, 13], &[16, 19, 18, 17], &[20, 23, 22, 21]];
        let all = [&outers[..], &holes].concat();
        assert_eq!(nested(&points, &all, 2), Some(vec![0, 1, 0, 1]));
        // Holes of two corners, inside and from the boundary.
        let all = [&outers[..], &[&[10, 0], &[13, 7], &[9, 2]]].concat();
        assert_eq!(nested(&points, &all, 2), Some(vec![0, 1, 0]));
        // A hole inside an island in a hole.
        let points = squares(&[[0, 0, 9], [3, 3, 4], [4, 4, 2]]);
        let all: [&[u32]; 4] = [&[0, 1, 2, 3], &[8, 9, 10, 11], &[4, 7, 6, 5], &[8, 10]];
        assert_eq!(nested(&points, &all, 2), Some(vec![0, 1]));
        // Holes that touch at their first corners, also at that of an outer cycle inside another one.
        let points = [
            [0, 0, 0],
            [9, 0, 0],
            [9, 9, 0],
            [0, 9, 0],
            [2, 4, 0],
            [4, 3, 0],
            [4, 4, 0],
            [4, 5, 0],
            [5, 8, 0],
            [3, 4, 0],
        ];
        let all: [&[u32]; 4] = [&[0, 1, 2, 3], &[4, 6, 5], &[4, 7, 6], &[4, 8]];
        assert_eq!(nested(&points, &all, 1), Some(vec![0; 3]));
        let all: [&[u32]; 4] = [&[0, 1, 2, 3], &[4, 5, 7], &[4, 7, 5], &[4, 9]];
        assert_eq!(nested(&points, &all, 2), Some(vec![0, 1]));
        // Crossing cycles, and an edge without length.
        let points = squares(&[[0, 0, 4], [2, 2, 4], [2, 2, 1]]);
        let all: [&[u32]; 3] = [&[0, 1, 2, 3], &[4, 5, 6, 7], &[8, 10]];
        assert_eq!(nested(&points, &all, 2), None);
        assert_eq!(nested(&points, &[&[0, 1, 2, 3], &[4, 8, 6, 7]], 1), None);
    }
}
