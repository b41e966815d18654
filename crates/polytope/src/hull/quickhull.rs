//! The surface of a hull of dimension 3, as triangles.
//!
//! # Invariant
//! Between two insertions the triangles are a triangulation of the boundary of the hull C of the points
//! inserted so far: none has area zero, their interiors are disjoint, each edge belongs to two of them, and
//! all are counterclockwise seen from outside. A plane may have several triangles; vertices inside a facet or
//! inside an edge of C are allowed.
//!
//! # Why an insertion keeps it
//!
//! Let p lie outside C. A triangle *sees* p if p lies strictly on the outer side of its plane; a triangle
//! with p in its plane does not. Some triangle sees p. The triangles of one facet of C all see p, or none
//! does.
//!
//! *The triangles that see p form a disc, bounded by one cycle, the horizon, that visits no vertex twice.* A
//! ray from p has at most one point in seen triangles: if it meets C first in x and then in y, and n is the
//! outer normal of a triangle at y, then n . (x - y) <= 0 since x is in C, hence n . (p - y) <= 0, and the
//! triangle does not see p. So the rays from p map the seen part one-to-one, and continuously, into a sphere
//! around p. Move p a little towards an inner point of C, so little that every facet that saw p, or had it
//! strictly inside, does so still; the facets with p in their planes now have it strictly inside. The seen
//! triangles are the same, and the moved point is in no plane of a facet. From there, the first point of C on
//! a ray into the interior of C is on a seen triangle, and a ray that only touches C meets it in one point,
//! since an edge along the ray would put the moved point in the planes of two facets. So the seen part is
//! mapped to all rays that meet C: a convex cone without a line, and a plane cuts it in a disc.
//!
//! *A new triangle, of p and an edge of the horizon, has positive area.* The edge belongs to a triangle that
//! sees p. If p were on the line of the edge, it would be in the plane of that triangle, which then would not
//! see p.
//!
//! *The new surface bounds the hull of C and p.* This boundary has the facets of C that do not see p, the
//! cone over the horizon, and nothing else. Where p lies in the plane of a facet G, the facet grows by the
//! triangles of p and the edges of G between p and G; across such an edge lies a facet that sees p, and
//! across no other edge of G, so that exactly these edges are in the horizon.
//!
//! *A point in the list of a removed triangle that no triangle of the cone sees is in the new hull, and can
//! be dropped.* Let q be outside the new hull and above a removed triangle. The triangles of the old surface
//! that see q are connected. Either p sees all of them; then only triangles of the cone are left to see q,
//! and one does. Or two of them meet in an edge of the horizon, one removed and one not. The plane of the new
//! triangle at this edge is between their planes (or that of the one that stays), so it also has q strictly
//! outside.
//!
//! # Termination
//!
//! A point stands in a list only while a triangle sees it, an insertion takes one point out of all lists, and
//! none comes back. Hence there are fewer insertions than points.
//!
//! # Order
//!
//! The point that looks farthest from the triangle of its list goes first, over all lists. Depth first would
//! be quadratic for a prism with many sides: with one end complete and the other filled from left to right,
//! each new vertex takes over half of the sides.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use exact::predicate::plane_side;
use exact::{Point3, Sign, Vector3};

use super::affine::{dot, sub};
use super::fan::Fan;
use super::sites::Sites;
use crate::fault::{Fault, injected};

/// No triangle, no point, or no halfedge.
const NONE: u32 = u32::MAX;

/// A closed surface of triangles. Halfedges 3t, 3t + 1 and 3t + 2 are the sides of triangle t, in this order.
pub(super) struct Surface {
    /// For each halfedge the point where it starts.
    pub(super) source: Vec<u32>,
    /// For each halfedge the one that runs the other way in the next triangle.
    pub(super) twin: Vec<u32>,
    /// For each halfedge whether its triangle and the next one lie in one plane.
    pub(super) is_flat: Vec<bool>,
}

/// Returns the halfedge after `h` in its triangle.
pub(super) fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

/// Returns the halfedge before `h` in its triangle.
fn prev(h: u32) -> u32 {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}

/// Triangulates the boundary of the hull of `sites`; `corners` are four of them that are not coplanar.
///
/// Vertices need not be extreme, and triangles of one plane are left apart: see [`super::merge`]. Cones of
/// more than `scanned` triangles are searched by halving, others triangle by triangle; the hull is the same.
///
/// # Complexity
/// See [`super::hull`].
pub(super) fn surface(sites: &Sites<'_>, corners: [u32; 4], scanned: usize) -> Surface {
    let mut builder = Builder::new(sites, corners, scanned);
    while let Some(Waiting { triangle, .. }) = builder.queue.pop() {
        // A triangle can wait twice, as its place is used again after its removal: then its list may be
        // empty.
        let p = builder.triangles[triangle as usize].farthest;
        if p != NONE {
            builder.insert(p, triangle);
        }
    }
    builder.finish()
}

/// What is known of a triangle beside its sides.
struct Triangle {
    /// An outer normal of the plane; the plane contains the source of halfedge 3t.
    normal: Vector3,
    /// The list of points that the triangle sees: its head, then by `Builder::behind`.
    first: u32,
    /// The point of the list that looks farthest from the plane, and how far; `NONE` if the list is empty.
    farthest: u32,
    height: f64,
    /// When the triangle was last tested, and whether it saw the point then: see `Builder::stamp`.
    mark: u32,
}

pub(super) struct Builder<'a> {
    points: &'a [Point3],
    approx: &'a [[f64; 3]],
    triangles: Vec<Triangle>,
    source: Vec<u32>,
    twin: Vec<u32>,
    /// For each point the next one in its list.
    behind: Vec<u32>,
    /// Every triangle with a list, and some that were removed.
    queue: BinaryHeap<Waiting>,
    /// Twice the number of insertions. A triangle has the mark `stamp` if it does not see the point that is
    /// being inserted, and `stamp + 1` if it does.
    stamp: u32,
    /// Places of removed triangles.
    free: Vec<u32>,
    /// For each point the new triangle whose first halfedge starts there.
    cone_at: Vec<u32>,
    scanned: usize,
    // Buffers of `insert`.
    seen: Vec<u32>,
    horizon: Vec<u32>,
    /// The triangles of the latest insertion, in cyclic order around its point: the second corner of each is
    /// the first of the next.
    pub(super) cone: Vec<u32>,
    orphans: Vec<u32>,
}

impl<'a> Builder<'a> {
    fn new(sites: &'a Sites<'_>, [a, b, c, d]: [u32; 4], scanned: usize) -> Self {
        let count = sites.points.len();
        let mut builder = Builder {
            points: &sites.points,
            approx: &sites.approx,
            triangles: Vec::new(),
            source: Vec::new(),
            twin: Vec::new(),
            behind: vec![NONE; count],
            queue: BinaryHeap::new(),
            stamp: 0,
            free: Vec::new(),
            cone_at: vec![NONE; count],
            scanned,
            seen: Vec::new(),
            horizon: Vec::new(),
            cone: Vec::new(),
            orphans: Vec::new(),
        };
        builder.add([a, b, c]);
        let (b, c) = if builder.sees(0, d) { (c, b) } else { (b, c) };
        builder.triangles.clear();
        builder.source.clear();
        builder.twin.clear();
        let cone = [[a, b, c], [b, a, d], [c, b, d], [a, c, d]].map(|corners| builder.add(corners));
        // The sides of the first triangle meet the first sides of the others; these meet one another around
        // d.
        for (h, g) in [(0, 3), (1, 6), (2, 9), (4, 11), (7, 5), (10, 8)] {
            builder.link(h, g);
        }
        builder.cone.extend(cone);
        builder.orphans.extend(sites.distinct.iter().filter(|p| ![a, b, c, d].contains(p)));
        builder.distribute(None);
        builder
    }

    /// Adds the triangle with these corners, without neighbours and with an empty list.
    fn add(&mut self, corners: [u32; 3]) -> u32 {
        let [a, b, c] = corners.map(|p| &self.points[p as usize]);
        let triangle = Triangle {
            normal: a.direction_to(b).cross(&a.direction_to(c)),
            first: NONE,
            farthest: NONE,
            height: f64::NEG_INFINITY,
            mark: 0,
        };
        if let Some(t) = self.free.pop() {
            let at = 3 * t as usize;
            self.source[at..at + 3].copy_from_slice(&corners);
            self.triangles[t as usize] = triangle;
            t
        } else {
            self.source.extend(corners);
            self.twin.extend([NONE; 3]);
            self.triangles.push(triangle);
            self.triangles.len() as u32 - 1
        }
    }

    fn link(&mut self, h: u32, g: u32) {
        self.twin[h as usize] = g;
        self.twin[g as usize] = h;
    }

    pub(super) fn corners(&self, t: u32) -> [u32; 3] {
        let at = 3 * t as usize;
        [self.source[at], self.source[at + 1], self.source[at + 2]]
    }

    pub(super) fn direction(&self, from: u32, to: u32) -> Vector3 {
        self.points[from as usize].direction_to(&self.points[to as usize])
    }

    pub(super) fn sees(&self, t: u32, p: u32) -> bool {
        self.side(t, p) == Sign::Positive
    }

    pub(super) fn side(&self, t: u32, p: u32) -> Sign {
        let on = self.source[3 * t as usize];
        plane_side(&self.triangles[t as usize].normal, &self.points[on as usize], &self.points[p as usize])
    }

    /// Inserts `p`, which stands in the list of `triangle`.
    fn insert(&mut self, p: u32, triangle: u32) {
        self.stamp += 2;
        self.find_horizon(p, triangle);
        self.remove_seen(p);
        self.add_cone(p);
        let fan = (self.cone.len() > self.scanned).then(|| Fan::new(self));
        self.distribute(fan.as_ref());
    }

    /// Collects all triangles that see `p`, beginning with `start`, and the halfedges of the others along the
    /// horizon.
    fn find_horizon(&mut self, p: u32, start: u32) {
        let (hidden, visible) = (self.stamp, self.stamp + 1);
        self.triangles[start as usize].mark = visible;
        self.seen.clear();
        self.seen.push(start);
        self.horizon.clear();
        let mut at = 0;
        while at < self.seen.len() {
            let t = self.seen[at];
            at += 1;
            for h in 3 * t..3 * t + 3 {
                let outer = self.twin[h as usize];
                let other = outer / 3;
                if self.triangles[other as usize].mark < hidden {
                    let sees = self.sees(other, p);
                    self.triangles[other as usize].mark = if sees { visible } else { hidden };
                    if sees {
                        self.seen.push(other);
                    }
                }
                if self.triangles[other as usize].mark == hidden {
                    self.horizon.push(outer);
                }
            }
        }
    }

    /// Removes the triangles that see `p` and collects the other points of their lists.
    fn remove_seen(&mut self, p: u32) {
        self.orphans.clear();
        for &t in &self.seen {
            let removed = &mut self.triangles[t as usize];
            let mut q = removed.first;
            removed.first = NONE;
            removed.farthest = NONE;
            while q != NONE {
                if q != p {
                    self.orphans.push(q);
                }
                q = self.behind[q as usize];
            }
        }
        self.free.append(&mut self.seen);
    }

    /// Closes the hole with triangles of `p` and the edges of the horizon.
    fn add_cone(&mut self, p: u32) {
        self.cone.clear();
        for at in 0..self.horizon.len() {
            let outer = self.horizon[at];
            let (a, b) = (self.source[next(outer) as usize], self.source[outer as usize]);
            let t = self.add([a, b, p]);
            self.link(3 * t, outer);
            self.cone_at[a as usize] = t;
            self.cone.push(t);
        }
        // The horizon visits no vertex twice, so the neighbour is known by the vertex alone. Beside linking,
        // this brings the cone into cyclic order.
        let mut t = self.cone[0];
        for at in 0..self.cone.len() {
            self.cone[at] = t;
            let [_, b, _] = self.corners(t);
            let following = self.cone_at[b as usize];
            self.link(3 * t + 1, 3 * following + 2);
            t = following;
        }
    }

    /// Puts each orphan in the list of a triangle of the cone that sees it, and drops it if there is none.
    fn distribute(&mut self, fan: Option<&Fan>) {
        for at in 0..self.orphans.len() {
            let q = self.orphans[at];
            let home = match fan {
                Some(fan) => fan.find(self, q),
                None => self.cone.iter().copied().find(|&t| self.sees(t, q)),
            };
            if let Some(t) = home {
                self.put(t, q);
            }
        }
        for &t in &self.cone {
            if self.triangles[t as usize].farthest != NONE {
                self.queue.push(self.waiting(t));
            }
        }
    }

    /// Puts `q` in the list of `t`. Only the choice of the farthest point depends on rounded numbers, and any
    /// is correct.
    fn put(&mut self, t: u32, q: u32) {
        let on = self.source[3 * t as usize];
        let triangle = &mut self.triangles[t as usize];
        let [near, base] = [q, on].map(|p| self.approx[p as usize]);
        let height = number_or_least(dot(triangle.normal.approx_f64(), sub(near, base)));
        let order = if triangle.farthest == NONE {
            Ordering::Greater
        } else {
            height.total_cmp(&triangle.height).then_with(|| tie(self.approx, q, triangle.farthest))
        };
        if order.is_gt() {
            triangle.farthest = q;
            triangle.height = height;
        }
        self.behind[q as usize] = triangle.first;
        triangle.first = q;
    }

    fn waiting(&self, t: u32) -> Waiting {
        let triangle = &self.triangles[t as usize];
        let length = triangle.normal.approx_f64().map(f64::abs).into_iter().fold(0.0, f64::max);
        let distance = number_or_least(triangle.height / length);
        Waiting { distance, tie: mix(triangle.farthest), triangle: t }
    }

    /// Writes down the surface without the places that are free.
    fn finish(self) -> Surface {
        let mut number = vec![0; self.triangles.len()];
        for &t in &self.free {
            number[t as usize] = NONE;
        }
        let mut count = 0;
        for n in number.iter_mut().filter(|n| **n != NONE) {
            *n = count;
            count += 1;
        }
        let size = 3 * count as usize;
        let mut surface = Surface {
            source: Vec::with_capacity(size),
            twin: Vec::with_capacity(size),
            is_flat: vec![false; size],
        };
        for t in (0..self.triangles.len() as u32).filter(|&t| number[t as usize] != NONE) {
            for h in 3 * t..3 * t + 3 {
                let g = self.twin[h as usize];
                surface.source.push(self.source[h as usize]);
                let (new, new_twin) = (3 * number[t as usize] + h % 3, 3 * number[(g / 3) as usize] + g % 3);
                surface.twin.push(new_twin);
                if h < g {
                    let opposite = self.source[prev(g) as usize];
                    let is_flat = self.side(t, opposite) == Sign::Zero && !injected(Fault::SkippedMerge);
                    surface.is_flat[new as usize] = is_flat;
                    surface.is_flat[new_twin as usize] = is_flat;
                }
            }
        }
        surface
    }
}

/// A triangle with a list, ordered by how far its farthest point looks from its plane, up to a factor below
/// 2.
#[derive(Debug)]
struct Waiting {
    distance: f64,
    tie: u32,
    triangle: u32,
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        let rest = |w: &Self| (w.tie, w.triangle);
        self.distance.total_cmp(&other.distance).then_with(|| rest(self).cmp(&rest(other)))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Waiting {}

/// Where approximations overflow, the rounded numbers know nothing.
fn number_or_least(x: f64) -> f64 {
    if x.is_nan() { f64::NEG_INFINITY } else { x }
}

/// Chooses between points of the same height. The last one in lexicographic order is extreme among all points
/// of a plane parallel to the triangle; between points that look equal the choice is as good as random.
fn tie(approx: &[[f64; 3]], p: u32, q: u32) -> Ordering {
    let (near_p, near_q) = (approx[p as usize], approx[q as usize]);
    (0..3)
        .map(|axis| near_p[axis].total_cmp(&near_q[axis]))
        .find(|order| order.is_ne())
        .unwrap_or_else(|| mix(p).cmp(&mix(q)))
}

/// Scatters indices: an order that has nothing to do with the order of the input.
fn mix(p: u32) -> u32 {
    p.wrapping_mul(0x9E37_79B1)
}
