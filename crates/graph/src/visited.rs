//! Sets of nodes, and of pairs of nodes.

use crate::Cells;
use petgraph::visit::VisitMap;
use std::collections::HashSet;
use std::fmt::{Debug, Formatter, Result};
use std::marker::PhantomData;

const BITS: usize = u64::BITS as usize;

/// A set of nodes: a bit for each id below a bound, and more if larger ones come.
pub struct NodeSet<C> {
    words: Vec<u64>,
    cells: PhantomData<fn() -> C>,
}

impl<C: Cells> NodeSet<C> {
    /// The empty set, with room for `bound` nodes.
    pub(crate) fn new(bound: usize) -> Self {
        Self { words: vec![0; bound.div_ceil(BITS)], cells: PhantomData }
    }

    /// Takes all nodes out, and makes room for `bound` of them.
    pub(crate) fn reset(&mut self, bound: usize) {
        self.words.clear();
        self.words.resize(bound.div_ceil(BITS), 0);
    }

    fn place(id: C::Id) -> (usize, u64) {
        let i = C::index(id);
        (i / BITS, 1 << (i % BITS))
    }
}

impl<C: Cells> VisitMap<C::Id> for NodeSet<C> {
    fn visit(&mut self, id: C::Id) -> bool {
        let (word, bit) = Self::place(id);
        if word >= self.words.len() {
            self.words.resize(word + 1, 0);
        }
        let is_new = self.words[word] & bit == 0;
        self.words[word] |= bit;
        is_new
    }

    fn is_visited(&self, &id: &C::Id) -> bool {
        let (word, bit) = Self::place(id);
        self.words.get(word).is_some_and(|bits| bits & bit != 0)
    }

    fn unvisit(&mut self, id: C::Id) -> bool {
        let was_visited = self.is_visited(&id);
        let (word, bit) = Self::place(id);
        if was_visited {
            self.words[word] &= !bit;
        }
        was_visited
    }
}

impl<C> Clone for NodeSet<C> {
    fn clone(&self) -> Self {
        Self { words: self.words.clone(), cells: PhantomData }
    }
}

impl<C> Debug for NodeSet<C> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let nodes = (0..self.words.len() * BITS).filter(|i| self.words[i / BITS] >> (i % BITS) & 1 == 1);
        f.debug_set().entries(nodes).finish()
    }
}

/// Which nodes are adjacent: a hash table of pairs, linear in the number of edges. Arrangements are too large for a matrix of bits.
#[derive(Clone, Debug)]
pub struct Adjacency<Id> {
    pub(crate) pairs: HashSet<(Id, Id)>,
}
