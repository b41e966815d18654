//! The edges of any list of facets, and disjoint sets of what they connect.

use crate::Facets;

/// The corners of all facets, each standing for the edge from it to the next corner of its cycle, sorted by
/// the ends of these edges.
pub(super) struct EdgeTable<'f> {
    facets: &'f Facets,
    /// The facet of each corner.
    facet_of: Vec<u32>,
    sorted: Vec<u32>,
}

impl<'f> EdgeTable<'f> {
    /// # Complexity
    /// A counting sort by the lower ends, and sorts of the edges that share theirs; three numbers a corner.
    pub(super) fn new(vertices: usize, facets: &'f Facets) -> Self {
        let corners = facets.corners();
        let mut facet_of = Vec::with_capacity(corners.len());
        for (f, cycle) in facets.iter().enumerate() {
            facet_of.extend(std::iter::repeat_n(f as u32, cycle.len()));
        }
        let mut table = Self { facets, facet_of, sorted: vec![0; corners.len()] };
        // Counted two places up, so that filling moves each start to where it belongs.
        let mut starts = vec![0_u32; vertices + 2];
        for corner in 0..corners.len() as u32 {
            starts[table.ends(corner)[0] as usize + 2] += 1;
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        for corner in 0..corners.len() as u32 {
            let slot = &mut starts[table.ends(corner)[0] as usize + 1];
            table.sorted[*slot as usize] = corner;
            *slot += 1;
        }
        let mut sorted = std::mem::take(&mut table.sorted);
        for range in starts.windows(2) {
            let group = &mut sorted[range[0] as usize..range[1] as usize];
            group.sort_unstable_by_key(|&corner| (table.ends(corner)[1], corner));
        }
        table.sorted = sorted;
        table
    }

    pub(super) fn facet(&self, corner: u32) -> usize {
        self.facet_of[corner as usize] as usize
    }

    pub(super) fn source(&self, corner: u32) -> u32 {
        self.facets.corners()[corner as usize]
    }

    pub(super) fn target(&self, corner: u32) -> u32 {
        self.source(self.next(corner))
    }

    /// The corner after a corner, around its facet.
    pub(super) fn next(&self, corner: u32) -> u32 {
        let facet = self.facet(corner);
        let [start, end] = [0, 1].map(|i| self.facets.starts()[facet + i]);
        if corner + 1 < end { corner + 1 } else { start }
    }

    /// Both ends of the edge of a corner, the lower first.
    pub(super) fn ends(&self, corner: u32) -> [u32; 2] {
        let [a, b] = [self.source(corner), self.target(corner)];
        [a.min(b), a.max(b)]
    }

    /// The edges: the corners of each, at least one.
    pub(super) fn edges(&self) -> impl Iterator<Item = &[u32]> {
        self.sorted.chunk_by(|&c, &d| self.ends(c) == self.ends(d))
    }

    /// Whether as many facets run through each edge in one direction as in the other: then they enclose a
    /// volume.
    pub(super) fn is_balanced(&self) -> bool {
        let up = |&&corner: &&u32| self.source(corner) < self.target(corner);
        self.edges().all(|edge| 2 * edge.iter().filter(up).count() == edge.len())
    }

    /// The number of pieces that hang together along edges of any number of facets.
    pub(super) fn pieces(&self) -> usize {
        let mut groups = Groups::new(self.facets.len());
        for edge in self.edges() {
            edge.windows(2).for_each(|pair| groups.join(self.facet(pair[0]), self.facet(pair[1])));
        }
        groups.count()
    }
}

/// Disjoint sets of facets or vertices.
pub(super) struct Groups {
    parent: Vec<u32>,
    count: usize,
}

impl Groups {
    /// Each in a set of its own.
    pub(super) fn new(size: usize) -> Self {
        Self { parent: (0..size as u32).collect(), count: size }
    }

    /// The lowest element of a set.
    pub(super) fn find(&mut self, element: usize) -> usize {
        let mut at = element as u32;
        while self.parent[at as usize] != at {
            let up = self.parent[self.parent[at as usize] as usize];
            self.parent[at as usize] = up;
            at = up;
        }
        at as usize
    }

    pub(super) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        if a != b {
            self.parent[a.max(b)] = a.min(b) as u32;
            self.count -= 1;
        }
    }

    pub(super) fn count(&self) -> usize {
        self.count
    }
}
