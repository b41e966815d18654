//! Ear clipping.
//!
//! An ear is a corner that turns left and whose triangle, boundary included, holds no other corner of the
//! polygon; it is enough to look at those that do not turn left. Which corners are ears is found once. When an
//! ear of a simple polygon is cut off, what is left is simple and lies in the polygon, so that only the two
//! neighbors can become ears or cease to be ones: 3 k looks at most, each at the r corners that may lie in it.
//!
//! Most of these are outside the triangle by their order along two directions of the plane. The corners are
//! sorted along both (exactly) beforehand, and a look compares small integers before it asks a predicate.

use exact::{Integer, Point3, Sign, Vector3, predicate};
use std::cmp::Ordering;
use std::collections::VecDeque;

/// The corners of a facet, seen along a normal as if in a plane.
pub(super) struct Polygon<'a> {
    points: &'a [Point3],
    cycle: &'a [u32],
    normal: Vector3,
}

/// Which of the corners are left, and what is known of them.
struct Remainder {
    /// The neighbors of each corner.
    before: Vec<usize>,
    next: Vec<usize>,
    turns: Vec<Sign>,
    /// Those which may lie in an ear: the corners that do not turn left, by their first rank.
    blunt: Vec<usize>,
    /// The places of each corner in the two orders; corners at the same place share it.
    ranks: Vec<[u32; 2]>,
}

impl<'a> Polygon<'a> {
    /// The normal must not be zero.
    pub(super) fn new(points: &'a [Point3], cycle: &'a [u32], normal: Vector3) -> Self {
        Self { points, cycle, normal }
    }

    fn corner(&self, i: usize) -> &'a Point3 {
        &self.points[self.cycle[i] as usize]
    }

    /// The turn at corner `b` of the path `a`, `b`, `c`: positive to the left, seen against the normal.
    fn turn(&self, [a, b, c]: [usize; 3]) -> Sign {
        let [a, b, c] = [a, b, c].map(|i| self.corner(i));
        predicate::orientation(&self.normal, &a.direction_to(b), &b.direction_to(c))
    }

    pub(super) fn is_planar(&self) -> bool {
        let off = |i| predicate::plane_side(&self.normal, self.corner(0), self.corner(i));
        (1..self.cycle.len()).all(|i| off(i).is_zero())
    }

    /// Whether all corners turn left, and the cycle winds once.
    pub(super) fn is_strictly_convex(&self) -> bool {
        let n = self.cycle.len();
        let all_left = (0..n).all(|i| self.turn([i, (i + 1) % n, (i + 2) % n]) == Sign::Positive);
        // A locally convex cycle winds as often as it has lowest corners, in any order of the plane.
        // The lexicographic order of space is one for a planar cycle.
        let point = |i: usize| self.corner(i % n);
        let lowest = |&i: &usize| point(i + 1) < point(i) && point(i + 1) < point(i + 2);
        all_left && self.is_planar() && (0..n).filter(lowest).count() == 1
    }

    /// `None` if the polygon is not simple.
    pub(super) fn clip_ears(&self) -> Option<Vec<[u32; 3]>> {
        let n = self.cycle.len();
        let mut rest = self.whole();
        // The last look at a corner is the one that counts: the queue forgets a corner by its number of looks.
        let mut looks = vec![0_u32; n];
        let mut ears: VecDeque<(usize, u32)> =
            (0..n).filter(|&i| self.is_ear(&rest, i)).map(|i| (i, 0)).collect();
        let mut triangles = Vec::with_capacity(n - 2);
        let mut last = 0;
        while triangles.len() < n - 3 {
            let (ear, look) = ears.pop_front()?;
            if look != looks[ear] {
                continue;
            }
            let triangle = rest.triangle(ear);
            triangles.push(triangle);
            let [source, _, target] = triangle;
            rest.next[source] = target;
            rest.before[target] = source;
            for i in [source, target] {
                let turn = self.turn(rest.triangle(i));
                let was = std::mem::replace(&mut rest.turns[i], turn);
                // A corner that has become convex stays so.
                if was != Sign::Positive && turn == Sign::Positive {
                    rest.blunt.retain(|&j| j != i);
                }
            }
            for i in [source, target] {
                // At the end of the queue: ears alternate, and the triangles stay fatter.
                looks[i] += 1;
                if self.is_ear(&rest, i) {
                    ears.push_back((i, looks[i]));
                }
            }
            last = source;
        }
        if rest.turns[last] != Sign::Positive {
            return None;
        }
        triangles.push(rest.triangle(last));
        Some(triangles.iter().map(|triangle| triangle.map(|i| self.cycle[i])).collect())
    }

    /// Nothing is cut off yet.
    fn whole(&self) -> Remainder {
        let n = self.cycle.len();
        let before: Vec<usize> = (0..n).map(|i| (i + n - 1) % n).collect();
        let next: Vec<usize> = (0..n).map(|i| (i + 1) % n).collect();
        let turns: Vec<Sign> = (0..n).map(|i| self.turn([before[i], i, next[i]])).collect();
        let mut ranks = vec![[0; 2]; n];
        for (which, direction) in self.directions().iter().enumerate() {
            self.rank(direction, |i, rank| ranks[i][which] = rank);
        }
        let mut blunt: Vec<usize> = (0..n).filter(|&i| turns[i] != Sign::Positive).collect();
        blunt.sort_by_key(|&i| ranks[i][0]);
        Remainder { before, next, turns, blunt, ranks }
    }

    /// Two independent directions at right angles to the normal: what is behind a triangle along one of them
    /// is outside of it also for a facet that is not planar.
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

    /// Hands out the places of the corners along a direction.
    fn rank(&self, direction: &Vector3, mut put: impl FnMut(usize, u32)) {
        let order = |&i: &usize, &j: &usize| {
            let (from, to) = (self.corner(j), self.corner(i));
            match predicate::same_direction(direction, &from.direction_to(to)) {
                Sign::Negative => Ordering::Less,
                Sign::Zero => Ordering::Equal,
                Sign::Positive => Ordering::Greater,
            }
        };
        let mut sorted: Vec<usize> = (0..self.cycle.len()).collect();
        sorted.sort_by(order);
        let mut rank = 0;
        for (at, i) in sorted.iter().enumerate() {
            if at > 0 && order(&sorted[at - 1], i) == Ordering::Less {
                rank += 1;
            }
            put(*i, rank);
        }
    }

    fn is_ear(&self, rest: &Remainder, i: usize) -> bool {
        let ear = rest.triangle(i);
        rest.turns[i] == Sign::Positive && !rest.near(ear).any(|other| self.is_inside(other, ear))
    }

    /// Whether a corner lies in a triangle of others, or on its boundary. A corner at the place of one
    /// of the three does not count.
    fn is_inside(&self, i: usize, ear: [usize; 3]) -> bool {
        if ear.iter().any(|&j| i == j || self.corner(i) == self.corner(j)) {
            return false;
        }
        let [a, b, c] = ear;
        [(a, b), (b, c), (c, a)].iter().all(|&(s, t)| self.turn([s, t, i]) != Sign::Negative)
    }
}

impl Remainder {
    /// A corner between its neighbors.
    fn triangle(&self, i: usize) -> [usize; 3] {
        [self.before[i], i, self.next[i]]
    }

    /// The blunt corners within the box around a triangle.
    fn near(&self, triangle: [usize; 3]) -> impl Iterator<Item = usize> {
        let [a, b, c] = triangle.map(|i| self.ranks[i]);
        let range = |which: usize| {
            let all = [a[which], b[which], c[which]];
            (all.into_iter().fold(u32::MAX, u32::min), all.into_iter().fold(0, u32::max))
        };
        let ((low, high), (left, right)) = (range(0), range(1));
        let first = self.blunt.partition_point(|&i| self.ranks[i][0] < low);
        let slab = self.blunt[first..].iter().copied().take_while(move |&i| self.ranks[i][0] <= high);
        slab.filter(move |&i| (left..=right).contains(&self.ranks[i][1]))
    }
}
