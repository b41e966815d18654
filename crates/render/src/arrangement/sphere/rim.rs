//! The part of a face within a disc or a rectangle, closed along the rim.
//!
//! A CCB has its face on the left. Where it leaves what is shown, the boundary of the part that is shown goes on counterclockwise
//! along the rim, up to where the next CCB of the face comes in. Which one that is, only the order along the rim tells.
//!
//! What is decided with doubles may be wrong where two places on the rim are as good as one. Then the area of the part is wrong by
//! that of everything, which is noticed and mended.

use crate::frame::Point;
use std::collections::VecDeque;

/// Parts of CCBs of one face, which is on the left of all of them.
#[derive(Clone, Default, Debug)]
pub(super) struct Boundary {
    /// Those that are inside as a whole: closed.
    pub(super) loops: Vec<Vec<Point>>,
    /// From the rim to the rim.
    pub(super) chains: Vec<Vec<Point>>,
}

impl Boundary {
    /// The area on the left of the loops, up to a multiple of the area of everything.
    pub(super) fn loop_area(&self) -> f64 {
        self.loops.iter().map(|ring| area(ring)).sum()
    }
}

/// The boundary of what is shown, a convex polygon or a circle.
#[derive(Debug)]
pub(super) struct Rim {
    centre: Point,
    /// Counterclockwise, by their keys.
    corners: Vec<Point>,
    keys: Vec<f64>,
    area: f64,
}

impl Rim {
    /// The convex polygon with these corners, which stand counterclockwise around `centre`.
    pub(super) fn new(centre: Point, mut corners: Vec<Point>) -> Self {
        corners.sort_by(|&p, &q| key(centre, p).total_cmp(&key(centre, q)));
        let keys = corners.iter().map(|&corner| key(centre, corner)).collect();
        let area = area(&corners);
        Self { centre, corners, keys, area }
    }

    pub(super) fn corners(&self) -> &[Point] {
        &self.corners
    }

    /// Whether parts of faces that should make up everything do not: then places that are different are as good as one for doubles.
    pub(super) fn is_missed_by(&self, areas: f64) -> bool {
        (areas / self.area - 1.0).abs() > 0.01
    }

    /// The rings that enclose the part of a face. Without chains, the rim is a part of its boundary or not.
    pub(super) fn rings(&self, boundary: Boundary, holds_rim: bool) -> Vec<Vec<Point>> {
        let has_chains = !boundary.chains.is_empty();
        let mut rings = self.joined(boundary.chains);
        rings.extend(boundary.loops);
        if has_chains {
            let filled = rings.iter().map(|ring| area(ring)).sum::<f64>() / self.area;
            if filled > 1.01 {
                rings.push(self.corners.iter().rev().copied().collect());
            } else if filled < -0.01 {
                rings.push(self.corners.clone());
            }
        } else if holds_rim {
            rings.push(self.corners.clone());
        }
        rings
    }

    /// Joins chains to rings along the rim.
    fn joined(&self, chains: Vec<Vec<Point>>) -> Vec<Vec<Point>> {
        let chains: Vec<Vec<Point>> = chains.into_iter().filter(|chain| !chain.is_empty()).collect();
        let ends: Vec<[f64; 2]> = chains
            .iter()
            .map(|chain| [chain[0], chain[chain.len() - 1]].map(|end| key(self.centre, end)))
            .collect();
        let next = partners(&ends);
        let mut is_used = vec![false; chains.len()];
        let mut rings = Vec::new();
        for start in 0..chains.len() {
            let mut ring = Vec::new();
            let mut at = start;
            while !is_used[at] {
                is_used[at] = true;
                ring.extend_from_slice(&chains[at]);
                ring.extend(self.between(ends[at][1], ends[next[at]][0]));
                at = next[at];
            }
            if !ring.is_empty() {
                rings.push(ring);
            }
        }
        rings
    }

    /// The corners between two places, counterclockwise; from a place to itself, all around.
    fn between(&self, from: f64, to: f64) -> Vec<Point> {
        let after = self.keys.partition_point(|&key| key <= from);
        let before = self.keys.partition_point(|&key| key < to);
        if from < to {
            self.corners[after..before.max(after)].to_vec()
        } else {
            [&self.corners[after..], &self.corners[..before]].concat()
        }
    }
}

/// For each chain, given as the places of its ends, the one that begins next along the rim after its end.
fn partners(ends: &[[f64; 2]]) -> Vec<usize> {
    let mut events: Vec<(f64, bool, usize)> = Vec::with_capacity(2 * ends.len());
    for (chain, &[first, last]) in ends.iter().enumerate() {
        events.extend([(first, false, chain), (last, true, chain)]);
    }
    // The face is on both sides of a place at which it ends and begins: there it ends first.
    events.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| (a.1, a.2).cmp(&(b.1, b.2))));
    let mut next: Vec<usize> = (0..ends.len()).collect();
    let mut waiting = VecDeque::new();
    let mut early = Vec::new();
    for (_, is_last, chain) in events {
        if is_last {
            waiting.push_back(chain);
        } else if let Some(before) = waiting.pop_front() {
            next[before] = chain;
        } else {
            early.push(chain);
        }
    }
    // As many begin as end.
    for (before, chain) in waiting.into_iter().zip(early) {
        next[before] = chain;
    }
    next
}

/// A number that increases with the direction from `centre`, from 0 along the axis of `x` up to 4.
fn key(centre: Point, [x, y]: Point) -> f64 {
    let (x, y) = (x - centre[0], y - centre[1]);
    let size = x.abs() + y.abs();
    if size == 0.0 {
        return 0.0;
    }
    match (x >= 0.0, y >= 0.0) {
        (true, true) => y / size,
        (false, true) => 1.0 - x / size,
        (false, false) => 2.0 - y / size,
        (true, false) => 3.0 + x / size,
    }
}

/// The area of a part of a face.
pub(super) fn area_of(rings: &[Vec<Point>]) -> f64 {
    rings.iter().map(|ring| area(ring)).sum()
}

/// The area that a ring encloses counterclockwise; accurate also if the ring is small.
pub(super) fn area(ring: &[Point]) -> f64 {
    let Some(&[x, y]) = ring.first() else { return 0.0 };
    let twice = |pair: &[Point]| {
        let [p, q] = [pair[0], pair[1]].map(|[px, py]| [px - x, py - y]);
        p[0] * q[1] - p[1] * q[0]
    };
    ring.windows(2).map(twice).sum::<f64>() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The square [-1, 1] x [-1, 1].
    fn square() -> Rim {
        Rim::new([0.0, 0.0], vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    }

    fn filled(chains: &[&[Point]]) -> f64 {
        let chains = chains.iter().map(|chain| chain.to_vec()).collect();
        let rings = square().rings(Boundary { loops: Vec::new(), chains }, false);
        rings.iter().map(|ring| area(ring)).sum()
    }

    #[test]
    fn places_go_round_once() {
        let rim = square();
        assert_eq!(rim.corners(), [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]);
        let [a, b] = [[1.0, 0.25], [1.0, 0.5]].map(|p| key([0.0; 2], p));
        assert_eq!(rim.between(a, b), [] as [Point; 0]);
        assert_eq!(rim.between(b, a), rim.corners());
        assert_eq!(rim.between(a, a), rim.corners());
    }

    #[test]
    fn chains_leave_what_is_on_their_left() {
        assert!((filled(&[&[[1.0, 0.0], [-1.0, 0.0]]]) - 2.0).abs() < 1e-12);
        assert!((filled(&[&[[-1.0, 0.5], [1.0, 0.5]]]) - 1.0).abs() < 1e-12);
        // Between two chains; and what two chains leave on both sides.
        let (up, down): ([Point; 2], [Point; 2]) = ([[0.5, -1.0], [0.5, 1.0]], [[-0.5, 1.0], [-0.5, -1.0]]);
        assert!((filled(&[&up, &down]) - 2.0).abs() < 1e-12);
        let [left, right] = [[down[1], down[0]], [up[1], up[0]]];
        assert!((filled(&[&left, &right]) - 2.0).abs() < 1e-12);
        // A corner only.
        assert!((filled(&[&[[1.0, 0.0], [0.0, 0.0], [0.0, 1.0]]]) - 3.0).abs() < 1e-12);
        assert!((filled(&[&[[0.0, 1.0], [0.0, 0.0], [1.0, 0.0]]]) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn an_edge_with_one_face_on_both_sides_leaves_everything() {
        for end in [[1.0, 0.25], [-1.0, -0.5], [0.0, 1.0], [1.0, 1.0], [-1.0, 1.0]] {
            assert!((filled(&[&[end, [0.0, 0.0], end]]) - 4.0).abs() < 1e-12, "{end:?}");
        }
        let across: [Point; 2] = [[-1.0, 0.0], [1.0, 0.0]];
        assert!((filled(&[&across, &[across[1], across[0]]]) - 4.0).abs() < 1e-12);
    }

    #[test]
    fn without_chains_the_rim_is_there_or_not() {
        let hole = [[0.0, 0.0], [0.0, 0.5], [0.5, 0.5]];
        let rest =
            || Boundary { loops: vec![hole.iter().copied().chain([hole[0]]).collect()], chains: Vec::new() };
        assert!(rest().loop_area() < 0.0);
        let rings = square().rings(rest(), true);
        assert_eq!(rings.len(), 2);
        assert!(square().rings(Boundary::default(), false).is_empty());
        assert_eq!(square().rings(Boundary::default(), true).len(), 1);
    }

    #[test]
    fn places_in_the_wrong_order_do_no_harm() {
        // Two halves, one of which ends a little after the other one begins.
        let near = 1e-12;
        let halves: [&[Point]; 2] = [&[[1.0, 0.0], [-1.0, near]], &[[-1.0, 0.0], [1.0, near]]];
        assert!((filled(&halves) - 4.0).abs() < 1e-9);
    }
}
