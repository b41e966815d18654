//! The Minkowski sum by linear programming, of all summands at once: Fukuda's method.
//!
//! 1. A vertex of the sum is the sum of one vertex of each summand, and of one such tuple only. The
//!    lexicographically least vertices of the summands make the first (`start`).
//! 2. The edges of the sum at a vertex are the extreme rays of the cone that the edges of all summands
//!    there span. Parallel edges are one ray, along which their summands move together. A ray is extreme
//!    if a plane touches the cone along nothing else: a linear program (`program`), one per ray.
//! 3. At the other end of an edge the summands that have it have moved to the other ends of theirs, and
//!    the rest have stayed: another tuple. A search that knows the tuples it has met finds them all
//!    (`traverse`), because the edges of a polytope connect its vertices.
//! 4. What binds a program is the next edge around the vertex on either side: the mesh needs no sorting
//!    (`assemble`).

mod assemble;
mod directions;
mod program;
#[cfg(test)]
mod tests;

use crate::Polytope;
use directions::Directions;
use exact::{Adder, Point3};
use program::Program;
use std::collections::HashMap;
use std::hash::{BuildHasher, RandomState};

/// The same sum as [`minkowski_sum`](crate::minkowski_sum) by linear programming, all summands at once:
/// the edges at a vertex of the sum are found among the edges of the summands at its vertices, one exact
/// linear program in three variables each, and followed to further vertices.
///
/// Independent of overlays and hulls. The vertices are in the order in which a search in breadth from
/// the lexicographically least one finds them.
///
/// ```
/// use exact::Point3;
/// use splitstar_polytope::{Polytope, minkowski_sum_by_lp};
/// let unit = |p| Polytope::segment(Point3::from_i64([0, 0, 0]), Point3::from_i64(p));
/// let [x, y, z, d] = [unit([1, 0, 0]), unit([0, 1, 0]), unit([0, 0, 1]), unit([1, 1, 1])];
/// let rhombic_dodecahedron = minkowski_sum_by_lp(&[&x, &y, &z, &d]);
/// assert_eq!(rhombic_dodecahedron.counts().to_array(), [14, 24, 12]);
/// ```
///
/// Degenerate: summands and sum may have any dimension from 0 to 3; the sum of no summand is the origin.
///
/// # Panics
/// If the sum has 2^32 halfedges or more.
///
/// # Complexity
/// O(d^2 V) for a sum of V vertices, where d is the greatest number of edges that the summands have
/// together at the vertices that make one of the sum: d programs of d constraints per vertex. Expected
/// constant time per edge of the sum to find its end. Degree 3 in the edge vectors; degree 4 where two
/// constraints of a program are parallel. Memory for k numbers per vertex of the sum of k summands.
///
/// # References
/// K. Fukuda: From the zonotope construction to the Minkowski addition of convex polytopes, Journal of
/// Symbolic Computation 38 (2004); thesis, section 3.6, where the bound is O(d LP(3, d) V). Fukuda's
/// search remembers no vertex; this one does.
pub fn minkowski_sum_by_lp(summands: &[&Polytope]) -> Polytope {
    let mut traversal = Traversal::start(summands);
    traversal.traverse();
    traversal.assemble()
}

/// An edge of the sum, seen from one of its ends.
#[derive(Clone, Copy)]
struct Ray {
    direction: u32,
    /// The vertex at the other end.
    target: u32,
    /// The next ray of the same vertex, counterclockwise seen from outside: its position among them.
    left: u32,
}

/// An edge of a summand at its vertex of the tuple.
#[derive(Clone, Copy)]
struct Candidate {
    direction: u32,
    summand: u32,
    /// The vertex of the summand at the other end.
    target: u32,
}

/// The vertices met so far, and the edges of those that were visited.
struct Traversal<'a> {
    summands: &'a [&'a Polytope],
    directions: Directions,
    /// The tuples of vertices of the summands one after the other, one for each vertex.
    tuples: Vec<u32>,
    hasher: RandomState,
    /// For each hash of a tuple, the last vertex with it: tuples are stored once only.
    met: HashMap<u64, u32>,
    /// For each vertex the one before with the same hash.
    same_hash: Vec<Option<u32>>,
    /// The rays of all visited vertices; those of one vertex by increasing direction.
    rays: Vec<Ray>,
    /// Where the rays of each visited vertex begin, and where the last ones end.
    starts: Vec<usize>,
}

impl<'a> Traversal<'a> {
    fn start(summands: &'a [&'a Polytope]) -> Self {
        let least = |p: &&Polytope| {
            let points = p.points();
            let least = (1..points.len()).fold(0, |v, w| if points[w] < points[v] { w } else { v });
            u32::try_from(least).expect("a polytope has fewer than 2^32 vertices")
        };
        let mut traversal = Self {
            summands,
            directions: Directions::of(summands),
            tuples: Vec::new(),
            hasher: RandomState::new(),
            met: HashMap::new(),
            same_hash: Vec::new(),
            rays: Vec::new(),
            starts: vec![0],
        };
        traversal.meet(&summands.iter().map(least).collect::<Vec<u32>>());
        traversal
    }

    /// Visits every vertex in the order in which they were met.
    fn traverse(&mut self) {
        let mut candidates = Vec::new();
        let mut visited = 0;
        while visited < self.vertex_count() {
            self.visit(visited, &mut candidates);
            visited += 1;
        }
    }

    fn vertex_count(&self) -> usize {
        self.same_hash.len()
    }

    fn tuple(&self, v: usize) -> &[u32] {
        let k = self.summands.len();
        &self.tuples[v * k..(v + 1) * k]
    }

    /// Finds the edges of the sum at a vertex. `candidates` is room to work in.
    fn visit(&mut self, v: usize, candidates: &mut Vec<Candidate>) {
        self.list_candidates(v, candidates);
        // Groups of parallel edges, by increasing direction.
        let groups: Vec<&[Candidate]> = candidates.chunk_by(|a, b| a.direction == b.direction).collect();
        let first_ray = self.rays.len();
        let mut ray_of_group = vec![u32::MAX; groups.len()];
        let mut moved = self.tuple(v).to_vec();
        for (g, group) in groups.iter().enumerate() {
            let left = match self.program(&groups, g) {
                Program::Infeasible => continue,
                Program::Free => g,
                Program::Feasible { left, .. } => left,
            };
            for edge in *group {
                moved[edge.summand as usize] = edge.target;
            }
            let target = self.meet(&moved);
            for edge in *group {
                let summand = edge.summand as usize;
                moved[summand] = self.tuple(v)[summand];
            }
            ray_of_group[g] = (self.rays.len() - first_ray) as u32;
            self.rays.push(Ray { direction: group[0].direction, target, left: left as u32 });
        }
        // What binds a program is extreme itself: it spans a facet of the cone with the axis, and no
        // other ray of this facet is farther from the axis.
        for ray in &mut self.rays[first_ray..] {
            ray.left = ray_of_group[ray.left as usize];
            debug_assert!(ray.left != u32::MAX, "a ray that bounds a facet of the cone is extreme");
        }
        self.starts.push(self.rays.len());
    }

    /// The edges of all summands at the vertices of a tuple, by increasing direction.
    fn list_candidates(&self, v: usize, candidates: &mut Vec<Candidate>) {
        candidates.clear();
        for (s, (p, &at)) in self.summands.iter().zip(self.tuple(v)).enumerate() {
            if p.dimension() == 0 {
                continue;
            }
            candidates.extend(p.mesh().vertex_cycle(dcel::VertexId(at)).map(|h| Candidate {
                direction: self.directions.of_halfedge(s, h),
                summand: s as u32,
                target: p.mesh().target(h).0,
            }));
        }
        candidates.sort_unstable_by_key(|edge| (edge.direction, edge.summand));
    }

    /// Solves the program of a group: the axis is its direction, the constraints those of the others.
    fn program(&self, groups: &[&[Candidate]], axis: usize) -> Program {
        let vector = |g: usize| self.directions.vector(groups[g][0].direction);
        let others = (0..groups.len()).filter(|&g| g != axis);
        program::solve(vector(axis), others.map(|g| (g, vector(g))))
    }

    /// The vertex of a tuple, a new one if it was not met before.
    fn meet(&mut self, tuple: &[u32]) -> u32 {
        let hash = self.hasher.hash_one(tuple);
        let last = self.met.get(&hash).copied();
        let mut candidates = std::iter::successors(last, |&v| self.same_hash[v as usize]);
        if let Some(v) = candidates.find(|&v| self.tuple(v as usize) == tuple) {
            return v;
        }
        let v = u32::try_from(self.vertex_count()).expect("a sum has fewer than 2^32 vertices");
        self.same_hash.push(self.met.insert(hash, v));
        self.tuples.extend_from_slice(tuple);
        v
    }

    /// The rays of a vertex.
    fn rays(&self, v: usize) -> &[Ray] {
        &self.rays[self.starts[v]..self.starts[v + 1]]
    }

    /// The positions of the vertices.
    fn points(&self) -> Vec<Point3> {
        let mut adders = vec![Adder::default(); self.summands.len()];
        let mut point = |v| {
            let vertices = self.summands.iter().zip(self.tuple(v)).map(|(p, &at)| &p.points()[at as usize]);
            let mut terms = vertices.zip(&mut adders);
            let Some((first, _)) = terms.next() else { return Point3::ORIGIN };
            terms.fold(first.clone(), |sum, (point, adder)| adder.sum(&sum, point))
        };
        (0..self.vertex_count()).map(&mut point).collect()
    }
}
