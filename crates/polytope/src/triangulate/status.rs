//! The status of a sweep: a long list with edits in the middle.

/// The least number of edges at which a block is cut.
const LEAST_CUT: usize = 512;

/// The edges on the sweep line, from bottom to top, in blocks. No block is empty.
///
/// A change moves the edges of one block, and where a block is cut or goes, the list of blocks. Both have at
/// most the order of the root of the number of edges in all, so that none is ever long.
pub(super) struct Status {
    blocks: Vec<Vec<u32>>,
    /// A block of more edges is cut.
    most: usize,
}

/// A place between edges: before the edge with that index in that block, or behind the last block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    block: usize,
    index: usize,
}

impl Status {
    /// An empty status for a boundary of that many edges.
    pub(super) fn new(edges: usize) -> Self {
        Self { blocks: Vec::new(), most: edges.isqrt().max(LEAST_CUT) }
    }

    /// The place behind the edges for which the test holds, which come first.
    pub(super) fn search(&self, mut before: impl FnMut(u32) -> bool) -> Place {
        let blocks = self.blocks.partition_point(|block| before(block[0]));
        let Some(block) = blocks.checked_sub(1) else { return Place { block: 0, index: 0 } };
        let index = self.blocks[block].partition_point(|&edge| before(edge));
        if index < self.blocks[block].len() {
            Place { block, index }
        } else {
            Place { block: blocks, index: 0 }
        }
    }

    /// The edge before a place.
    pub(super) fn below(&self, place: Place) -> Option<u32> {
        match place.index.checked_sub(1) {
            Some(index) => Some(self.blocks[place.block][index]),
            None => self.blocks[..place.block].last()?.last().copied(),
        }
    }

    /// The edges behind a place.
    pub(super) fn from(&self, place: Place) -> impl Iterator<Item = u32> + '_ {
        let here = self.blocks.get(place.block).map_or(&[][..], |block| &block[place.index..]);
        let later = self.blocks.get(place.block + 1..).unwrap_or_default();
        here.iter().chain(later.iter().flatten()).copied()
    }

    /// Replaces that many edges behind a place by others.
    pub(super) fn replace(&mut self, place: Place, count: usize, edges: &[u32]) {
        if count == 0 && edges.is_empty() {
            return;
        }
        let Place { mut block, mut index } = place;
        if block == self.blocks.len() {
            // At the end, the last block grows.
            if self.blocks.is_empty() {
                self.blocks.push(Vec::new());
            }
            block = self.blocks.len() - 1;
            index = self.blocks[block].len();
        }
        let here = count.min(self.blocks[block].len() - index);
        self.blocks[block].splice(index..index + here, edges.iter().copied());
        let mut left = count - here;
        let mut end = block + 1;
        while left > 0 {
            let next = &mut self.blocks[end];
            if left < next.len() {
                next.drain(..left);
                break;
            }
            left -= next.len();
            end += 1;
        }
        let start = block + usize::from(!self.blocks[block].is_empty());
        if start < end {
            self.blocks.drain(start..end);
        }
        if start > block && self.blocks[block].len() > self.most {
            let half = self.most.div_ceil(2);
            let parts: Vec<Vec<u32>> = self.blocks[block].chunks(half).map(<[u32]>::to_vec).collect();
            self.blocks.splice(block..=block, parts);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever is replaced, the list is that of a plain one.
    #[test]
    fn as_a_plain_list() {
        let mut state = 0x5eed_u64;
        let mut random = |below: usize| {
            state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            (state >> 33) as usize % below
        };
        for most in [1, 2, 3, 7] {
            let mut status = Status { blocks: Vec::new(), most };
            let mut plain: Vec<u32> = Vec::new();
            for step in 0..2000 {
                let at = random(plain.len() + 1);
                // It grows first, and shrinks then.
                let count = random(if step < 1000 { 3 } else { 9 }).min(plain.len() - at);
                let edges: Vec<u32> =
                    (0..random(if step < 1000 { 6 } else { 3 })).map(|_| random(1000) as u32).collect();
                let (mut block, mut index) = (0, at);
                while let Some(edges) = status.blocks.get(block).filter(|edges| edges.len() <= index) {
                    (block, index) = (block + 1, index - edges.len());
                }
                let place = Place { block, index };
                assert_eq!(status.below(place), at.checked_sub(1).map(|under| plain[under]));
                assert_eq!(status.from(place).collect::<Vec<u32>>(), plain[at..]);
                status.replace(place, count, &edges);
                plain.splice(at..at + count, edges);
                assert_eq!(status.blocks.concat(), plain);
                assert!(status.blocks.iter().all(|block| (1..=most).contains(&block.len())));
            }
        }
    }

    #[test]
    fn searches_sorted_edges() {
        let mut status = Status { blocks: Vec::new(), most: 4 };
        for edge in 0..100 {
            let place = status.search(|other| other < 2 * edge);
            status.replace(place, 0, &[2 * edge]);
        }
        for edge in 0..201 {
            let place = status.search(|other| other < edge);
            assert_eq!(status.from(place).next(), Some(edge.div_ceil(2) * 2).filter(|&e| e < 200));
            assert_eq!(status.below(place), (edge.min(199).div_ceil(2) * 2).checked_sub(2));
        }
    }
}
