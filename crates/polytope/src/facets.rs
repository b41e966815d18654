//! A list of vertex cycles in two flat arrays.

/// The facets of a mesh: one cycle of vertex indices each, counterclockwise seen from outside.
///
/// Stored flat (all indices in one array, and where each cycle starts), so that a mesh of a million
/// facets is two allocations.
///
/// ```
/// use splitstar_polytope::Facets;
/// let mut facets = Facets::new();
/// facets.push(&[0, 1, 2]);
/// facets.push(&[3, 2, 1, 0]);
/// assert_eq!(facets.len(), 2);
/// assert_eq!(facets.get(1), [3, 2, 1, 0]);
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Facets {
    starts: Vec<u32>,
    indices: Vec<u32>,
}

impl Default for Facets {
    fn default() -> Self {
        Self::new()
    }
}

impl Facets {
    /// Makes an empty list.
    pub fn new() -> Self {
        Self { starts: vec![0], indices: Vec::new() }
    }

    /// Makes an empty list with room for `facets` cycles of `corners` indices altogether.
    pub fn with_capacity(facets: usize, corners: usize) -> Self {
        let mut starts = Vec::with_capacity(facets + 1);
        starts.push(0);
        Self { starts, indices: Vec::with_capacity(corners) }
    }

    /// Appends a cycle.
    ///
    /// # Panics
    /// If the list would hold 2^32 indices or more.
    pub fn push(&mut self, cycle: &[u32]) {
        self.indices.extend_from_slice(cycle);
        self.starts.push(u32::try_from(self.indices.len()).expect("a mesh has fewer than 2^32 corners"));
    }

    /// The number of cycles.
    #[inline]
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Whether there is no cycle.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The cycle with index `facet`.
    ///
    /// # Panics
    /// If there is no such cycle.
    #[inline]
    pub fn get(&self, facet: usize) -> &[u32] {
        &self.indices[self.starts[facet] as usize..self.starts[facet + 1] as usize]
    }

    /// The cycles in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> + '_ {
        self.starts.windows(2).map(|w| &self.indices[w[0] as usize..w[1] as usize])
    }

    /// The indices of all cycles, one after the other.
    #[inline]
    pub fn corners(&self) -> &[u32] {
        &self.indices
    }

    /// Where each cycle starts in [`corners`](Self::corners), and behind the last its end.
    #[inline]
    pub fn starts(&self) -> &[u32] {
        &self.starts
    }

    /// Turns every cycle round.
    pub fn reverse(&mut self) {
        for w in self.starts.windows(2) {
            self.indices[w[0] as usize..w[1] as usize].reverse();
        }
    }

    /// Replaces every index by `map[index]`.
    ///
    /// # Panics
    /// If an index is out of the range of `map`.
    pub fn relabel(&mut self, map: &[u32]) {
        for index in &mut self.indices {
            *index = map[*index as usize];
        }
    }
}
