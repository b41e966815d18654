//! The boundary of a facet in its plane: corners in an order of the plane, edges, and where three corners
//! turn.

use exact::{Integer, Point3, Sign, Vector3, predicate};
use std::cmp::Ordering;

/// The corners of all cycles of a facet, one after the other, seen against a normal.
pub(super) struct Outline<'a> {
    points: &'a [Point3],
    normal: Vector3,
    /// The vertex of each corner.
    pub(super) vertices: Vec<u32>,
    /// The place of each corner in the order of the plane; corners at the same place share it.
    pub(super) ranks: Vec<u32>,
    pub(super) edges: Vec<Edge>,
    /// Of planar cycles the order of the corners in a second coordinate, as that of [`Self::ranks`], and the
    /// sign of its direction upwards. It spares most tests of what is above what.
    heights: Vec<u32>,
    upwards: Sign,
}

/// An edge of the boundary, between two corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    /// The end that comes first in the order of the plane.
    pub(super) low: u32,
    pub(super) high: u32,
    /// Whether it runs from `low` to `high`; the facet lies above it then, and below it otherwise.
    pub(super) forward: bool,
}

impl Edge {
    pub(super) fn source(&self) -> u32 {
        if self.forward { self.low } else { self.high }
    }

    pub(super) fn target(&self) -> u32 {
        if self.forward { self.high } else { self.low }
    }
}

impl<'a> Outline<'a> {
    /// From cycles in the plane with that normal, or, if they are not planar, from their projection along it.
    /// The normal must not be zero.
    ///
    /// # Errors
    /// Two vertices that follow each other at the same place.
    pub(super) fn new<'c>(
        points: &'a [Point3],
        normal: Vector3,
        planar: bool,
        cycles: impl IntoIterator<Item = &'c [u32]>,
    ) -> Result<Self, [u32; 2]> {
        let (mut vertices, mut pairs) = (Vec::new(), Vec::new());
        for cycle in cycles {
            let first = vertices.len() as u32;
            vertices.extend_from_slice(cycle);
            let end = vertices.len() as u32;
            if cycle.len() > 1 {
                pairs.extend((first..end).map(|c| [c, if c + 1 < end { c + 1 } else { first }]));
            }
        }
        let (ranks, heights, edges) = (Vec::new(), Vec::new(), Vec::with_capacity(pairs.len()));
        let mut outline = Self { points, normal, vertices, ranks, edges, heights, upwards: Sign::Zero };
        outline.ranks = outline.ranked(planar);
        if planar {
            outline.raise();
        }
        for [source, target] in pairs {
            let forward = match outline.rank(source).cmp(&outline.rank(target)) {
                Ordering::Less => true,
                Ordering::Greater => false,
                Ordering::Equal => return Err([source, target].map(|c| outline.vertex(c))),
            };
            let (low, high) = if forward { (source, target) } else { (target, source) };
            outline.edges.push(Edge { low, high, forward });
        }
        Ok(outline)
    }

    fn ranked(&self, planar: bool) -> Vec<u32> {
        let directions = (!planar).then(|| self.directions());
        let order = |&a: &u32, &b: &u32| {
            let (a, b) = (self.point(a), self.point(b));
            match &directions {
                // The lexicographic order of space is one of any plane.
                None => a.cmp(b),
                Some([u, v]) => {
                    let step = b.direction_to(a);
                    predicate::same_direction(u, &step)
                        .cmp(&Sign::Zero)
                        .then_with(|| predicate::same_direction(v, &step).cmp(&Sign::Zero))
                }
            }
        };
        self.places(order)
    }

    /// The place of each corner in an order; equal ones share it.
    fn places(&self, order: impl Fn(&u32, &u32) -> Ordering) -> Vec<u32> {
        let mut sorted: Vec<u32> = (0..self.vertices.len() as u32).collect();
        sorted.sort_by(&order);
        let mut places = vec![0; sorted.len()];
        for pair in sorted.windows(2) {
            let step = u32::from(order(&pair[0], &pair[1]) == Ordering::Less);
            places[pair[1] as usize] = places[pair[0] as usize] + step;
        }
        places
    }

    /// Finds the heights. The first coordinate of the lexicographic order is the first that is not constant in
    /// the plane; the second is the next that is not a function of it. Upwards is the normal times the first.
    fn raise(&mut self) {
        let (axis, upwards) = match [0, 1, 2].map(|axis| self.normal.sign(axis)) {
            [x, Sign::Zero, Sign::Zero] => (2, x),
            [_, y, Sign::Zero] => (2, -y),
            [_, _, z] => (1, z),
        };
        self.heights = self.places(|&a, &b| self.point(a).compare_coordinate(self.point(b), axis));
        self.upwards = upwards;
    }

    /// Two independent directions at right angles to the normal.
    fn directions(&self) -> [Vector3; 2] {
        let [x, y, z] = self.normal.coordinates();
        let zero = Integer::from(0);
        if !z.is_zero() {
            [Vector3::new([z.clone(), zero.clone(), -x]), Vector3::new([zero, z, -y])]
        } else if !y.is_zero() {
            [Vector3::new([y, -x, zero.clone()]), Vector3::new([zero.clone(), zero, 1.into()])]
        } else {
            [Vector3::from_i64([0, 1, 0]), Vector3::from_i64([0, 0, 1])]
        }
    }

    fn point(&self, corner: u32) -> &'a Point3 {
        &self.points[self.vertices[corner as usize] as usize]
    }

    pub(super) fn vertex(&self, corner: u32) -> u32 {
        self.vertices[corner as usize]
    }

    pub(super) fn rank(&self, corner: u32) -> u32 {
        self.ranks[corner as usize]
    }

    pub(super) fn edge(&self, edge: u32) -> &Edge {
        &self.edges[edge as usize]
    }

    /// Visits the places of corners in the order of the plane, each with one corner and the edges that start
    /// there.
    pub(super) fn visit_corners<E>(
        &self,
        mut visit: impl FnMut(u32, &mut [u32]) -> Result<(), E>,
    ) -> Result<(), E> {
        let start = |edge: u32| self.rank(self.edge(edge).low);
        let mut starting: Vec<u32> = (0..self.edges.len() as u32).collect();
        starting.sort_unstable_by_key(|&edge| (start(edge), edge));
        let mut corners: Vec<u32> = (0..self.vertices.len() as u32).collect();
        corners.sort_unstable_by_key(|&corner| (self.rank(corner), corner));
        let mut starting = &mut starting[..];
        for group in corners.chunk_by(|&a, &b| self.rank(a) == self.rank(b)) {
            let count = starting.partition_point(|&edge| start(edge) == self.rank(group[0]));
            let (now, later) = starting.split_at_mut(count);
            visit(group[0], now)?;
            starting = later;
        }
        Ok(())
    }

    /// Sorts edges that start at one place from bottom to top.
    pub(super) fn sort_starting(&self, starting: &mut [u32]) {
        starting.sort_by(|&a, &b| match self.turn_between(a, b) {
            Sign::Positive => Ordering::Less,
            Sign::Negative => Ordering::Greater,
            Sign::Zero => self.length_and_way(a).cmp(&self.length_and_way(b)),
        });
    }

    /// Whether the second of two edges that start at one place is above the first (positive), or in line.
    pub(super) fn turn_between(&self, a: u32, b: u32) -> Sign {
        self.turn(self.edge(a).low, self.edge(a).high, self.edge(b).high)
    }

    /// What tells edges apart that start at one place and are in line.
    pub(super) fn length_and_way(&self, edge: u32) -> (u32, bool) {
        (self.rank(self.edge(edge).high), self.edge(edge).forward)
    }

    /// The vertices of an edge, in the direction of its cycle.
    pub(super) fn ends(&self, edge: u32) -> [u32; 2] {
        let edge = self.edge(edge);
        [edge.source(), edge.target()].map(|c| self.vertex(c))
    }

    /// The turn at corner `b` of the path `a`, `b`, `c`: positive to the left.
    pub(super) fn turn(&self, a: u32, b: u32, c: u32) -> Sign {
        let [a, b, c] = [a, b, c].map(|corner| self.point(corner));
        predicate::orientation(&self.normal, &a.direction_to(b), &b.direction_to(c))
    }

    /// Where a corner lies of an edge that begins before it and does not end before it: positive above.
    pub(super) fn side(&self, edge: u32, corner: u32) -> Sign {
        let Edge { low, high, .. } = *self.edge(edge);
        if self.rank(high) == self.rank(corner) {
            return Sign::Zero;
        }
        if let Some(&height) = self.heights.get(corner as usize) {
            let ends = [low, high].map(|corner| self.heights[corner as usize]);
            if ends.iter().all(|&end| end < height) {
                return self.upwards;
            }
            if ends.iter().all(|&end| end > height) {
                return -self.upwards;
            }
        }
        self.turn(low, high, corner)
    }
}
