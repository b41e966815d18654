//! Which edges are sides of facets, and which are said twice.

use super::{Complex, Edge, Facet};
use exact::{Point3, PointKey, Sign, Vector3};

/// Finds edges by their ends, and lines by where they lie too.
///
/// An edge that is said twice is found by its first index. [`Complex::check`] refuses it; other methods take any
/// complex.
pub(super) struct EdgeIndex<'a> {
    complex: &'a Complex,
    /// Edges with an end that is a point: sorted ends, index.
    by_ends: Vec<([u32; 2], u32)>,
    /// Lines: sorted ends, one of its points, index.
    lines: Vec<([u32; 2], PointKey, u32)>,
}

impl<'a> EdgeIndex<'a> {
    /// Of those edges that the condition holds for.
    pub(super) fn new(complex: &'a Complex, condition: impl Fn(&Edge) -> bool) -> Self {
        let (mut by_ends, mut lines) = (Vec::new(), Vec::new());
        for (edge, index) in complex.edges.iter().zip(0_u32..).filter(|(edge, _)| condition(edge)) {
            match complex.line_key(edge.ends, edge.through.as_ref()) {
                Some(key) => lines.push((sorted(edge.ends), key, index)),
                None => by_ends.push((sorted(edge.ends), index)),
            }
        }
        by_ends.sort_unstable();
        lines.sort_unstable();
        Self { complex, by_ends, lines }
    }

    /// The first edge that is this side of the facet.
    pub(super) fn find(&self, facet: &Facet, side: [u32; 2]) -> Option<usize> {
        let ends = sorted(side);
        let index = match self.complex.line_key(ends, facet.through.as_ref()) {
            Some(key) => {
                let at = self.lines.partition_point(|line| (&line.0, &line.1) < (&ends, &key));
                self.lines.get(at).filter(|line| line.0 == ends && line.1 == key).map(|line| line.2)
            }
            None => {
                let at = self.by_ends.partition_point(|edge| edge.0 < ends);
                self.by_ends.get(at).filter(|edge| edge.0 == ends).map(|edge| edge.1)
            }
        };
        index.map(|index| index as usize)
    }

    /// Pairs of edges that are the same and follow each other in the lists, the lower index first.
    fn repeated(&self) -> impl Iterator<Item = [u32; 2]> {
        let same_ends = self.by_ends.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        let same_line =
            self.lines.windows(2).filter(|pair| (pair[0].0, &pair[0].1) == (pair[1].0, &pair[1].1));
        same_ends.map(|pair| [pair[0].1, pair[1].1]).chain(same_line.map(|pair| [pair[0].2, pair[1].2]))
    }
}

/// The first segment that has the ends of one before it, and that one.
pub(crate) fn repeated_segment(ends: impl Iterator<Item = [u32; 2]>) -> Option<[usize; 2]> {
    let mut by_ends: Vec<([u32; 2], u32)> = ends.map(sorted).zip(0..).collect();
    by_ends.sort_unstable();
    let repeated = by_ends.windows(2).filter(|pair| pair[0].0 == pair[1].0);
    first(repeated.map(|pair| [pair[0].1, pair[1].1]))
}

/// The pair whose second edge comes first. Its first one then is the only one before.
fn first(pairs: impl Iterator<Item = [u32; 2]>) -> Option<[usize; 2]> {
    pairs.min_by_key(|pair| pair[1]).map(|pair| pair.map(|edge| edge as usize))
}

impl Complex {
    /// For each edge whether it is a side of some facet.
    ///
    /// # Complexity
    /// O((e + n) log e) for e edges and n corners of facets.
    pub(crate) fn are_sides(&self) -> Vec<bool> {
        let mut are_sides = vec![false; self.edges.len()];
        if self.edges.is_empty() {
            return are_sides;
        }
        let index = EdgeIndex::new(self, |_| true);
        for facet in &self.facets {
            for edge in self.edges_of(facet).filter_map(|side| index.find(facet, side)) {
                are_sides[edge] = true;
            }
        }
        for [first, again] in index.repeated() {
            are_sides[again as usize] = are_sides[first as usize];
        }
        are_sides
    }

    /// The first edge that is the same as one before it, and that one: the same ends, and for lines the same line.
    ///
    /// # Complexity
    /// O(e log e) for e edges.
    pub(crate) fn repeated_edge(&self) -> Option<[usize; 2]> {
        first(EdgeIndex::new(self, |_| true).repeated())
    }

    /// The edges around a facet. A piece of the circle at infinity is none.
    pub(crate) fn edges_of<'a>(&'a self, facet: &'a Facet) -> impl Iterator<Item = [u32; 2]> + 'a {
        facet.cycles().flat_map(sides_of).filter(|&[a, b]| {
            self.direction(a).is_none() || self.direction(b).is_none() || self.is_line([a, b])
        })
    }

    /// Whether an edge or a side of a facet is a line: it runs between opposite directions.
    pub(super) fn is_line(&self, [a, b]: [u32; 2]) -> bool {
        matches!((self.direction(a), self.direction(b)), (Some(a), Some(b)) if are_opposite(a, b))
    }

    /// What is the same for all points of a line; `None` for a segment, a ray, and a line that no point is known of.
    fn line_key(&self, ends: [u32; 2], through: Option<&Point3>) -> Option<PointKey> {
        let point = through.filter(|_| self.is_line(ends))?;
        self.direction(ends[0]).map(|along| where_zero(point, along).canonical_key())
    }
}

/// Where the line through a point has the coordinate zero, along the first axis that it is not parallel to.
fn where_zero(point: &Point3, along: &Vector3) -> Point3 {
    let axis = (0..3).find(|&axis| !along.sign(axis).is_zero()).expect("no line runs along zero");
    let [x, y, z, weight] = point.homogeneous();
    let (numerators, step) = ([x, y, z], along.coordinates());
    let zeroed = [0, 1, 2].map(|i| &(&numerators[i] * &step[axis]) - &(&numerators[axis] * &step[i]));
    let weight = &weight * &step[axis];
    let (zeroed, weight) =
        if weight.sign() == Sign::Negative { (zeroed.map(|n| -n), -weight) } else { (zeroed, weight) };
    Point3::new(zeroed, weight).expect("the weight is positive")
}

pub(super) fn are_opposite(a: &Vector3, b: &Vector3) -> bool {
    a.cross(b).is_zero() && a.dot(b).sign() == Sign::Negative
}

pub(super) fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// The pairs of vertices that follow each other in a cycle: none for one vertex, one for two.
pub(super) fn sides_of(cycle: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    let closing = match cycle {
        [first, _, .., last] => Some([*last, *first]),
        _ => None,
    };
    cycle.windows(2).map(|pair| [pair[0], pair[1]]).chain(closing)
}
