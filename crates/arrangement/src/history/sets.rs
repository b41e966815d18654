//! For each edge, or vertex, a small set of pieces.

/// No piece.
pub(super) const NONE: u32 = u32::MAX;

/// Marks the number of a set that has several pieces.
const MANY: u32 = 1 << 31;

/// Sets of pieces, by the index of the cell that has them. A set of one piece, as almost all are, takes four bytes.
#[derive(Clone, Debug, Default)]
pub(super) struct Sets {
    /// For each cell, the only piece, or the marked place of the set; [`NONE`] if it has none.
    slots: Vec<u32>,
    many: Vec<Vec<u32>>,
    free: Vec<u32>,
}

impl Sets {
    /// Makes place for a cell that comes, and has no piece yet.
    #[inline]
    pub(super) fn begin(&mut self, cell: usize) {
        if cell >= self.slots.len() {
            self.slots.resize(cell + 1, NONE);
        }
        debug_assert_eq!(self.slots[cell], NONE, "the set of a cell that went was cleared");
    }

    /// The pieces of a cell, in the order of their keys.
    #[inline]
    pub(super) fn get(&self, cell: usize) -> &[u32] {
        match self.slots.get(cell) {
            None | Some(&NONE) => &[],
            Some(slot) if slot & MANY == 0 => std::slice::from_ref(slot),
            Some(slot) => &self.many[(slot & !MANY) as usize],
        }
    }

    /// Adds a piece that a cell does not have yet.
    pub(super) fn add<K: Ord>(&mut self, cell: usize, piece: u32, key: impl Fn(u32) -> K) {
        debug_assert!(piece < MANY, "there are fewer than 2^31 pieces");
        if cell >= self.slots.len() {
            self.slots.resize(cell + 1, NONE);
        }
        let slot = self.slots[cell];
        if slot == NONE {
            self.slots[cell] = piece;
        } else if slot & MANY == 0 {
            let pieces = if key(slot) < key(piece) { [slot, piece] } else { [piece, slot] };
            self.slots[cell] = self.store(pieces.to_vec());
        } else {
            let set = &mut self.many[(slot & !MANY) as usize];
            let at = set.partition_point(|&other| key(other) < key(piece));
            set.insert(at, piece);
        }
    }

    /// Takes a piece from a cell, and tells whether none is left.
    pub(super) fn take<K: Ord>(&mut self, cell: usize, piece: u32, key: impl Fn(u32) -> K) -> bool {
        let slot = self.slots[cell];
        if slot & MANY == 0 {
            debug_assert_eq!(slot, piece, "only a piece that is there is taken");
            self.slots[cell] = NONE;
            return true;
        }
        if slot == NONE {
            return true;
        }
        let set = &mut self.many[(slot & !MANY) as usize];
        if let Ok(at) = set.binary_search_by(|&other| key(other).cmp(&key(piece))) {
            set.remove(at);
        }
        if let [last] = set[..] {
            set.clear();
            self.free.push(slot & !MANY);
            self.slots[cell] = last;
        }
        false
    }

    /// Tells whether a cell has a piece.
    #[inline]
    pub(super) fn has<K: Ord>(&self, cell: usize, piece: u32, key: impl Fn(u32) -> K) -> bool {
        match self.get(cell) {
            [] => false,
            [only] => *only == piece,
            set => set.binary_search_by(|&other| key(other).cmp(&key(piece))).is_ok(),
        }
    }

    /// Gives a cell without pieces those that another one has.
    #[inline]
    pub(super) fn copy(&mut self, from: usize, to: usize) {
        self.begin(to);
        let slot = self.slots[from];
        self.slots[to] = if slot == NONE || slot & MANY == 0 {
            slot
        } else {
            let set = self.many[(slot & !MANY) as usize].clone();
            self.store(set)
        };
    }

    /// Takes all pieces from a cell.
    pub(super) fn clear(&mut self, cell: usize) {
        let slot = std::mem::replace(&mut self.slots[cell], NONE);
        if slot != NONE && slot & MANY != 0 {
            self.many[(slot & !MANY) as usize].clear();
            self.free.push(slot & !MANY);
        }
    }

    /// Gives the cells that have pieces new indices.
    pub(super) fn renumber(&mut self, to: impl Fn(usize) -> usize) {
        let old = std::mem::take(&mut self.slots);
        for (cell, slot) in old.into_iter().enumerate().filter(|(_, slot)| *slot != NONE) {
            let cell = to(cell);
            self.begin(cell);
            self.slots[cell] = slot;
        }
    }

    /// Stores a set, and gives the slot of a cell that has it.
    fn store(&mut self, set: Vec<u32>) -> u32 {
        let place = match self.free.pop() {
            Some(place) => {
                self.many[place as usize] = set;
                place
            }
            None => {
                self.many.push(set);
                self.many.len() as u32 - 1
            }
        };
        place | MANY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_grow_and_shrink() {
        let mut sets = Sets::default();
        let key = |piece: u32| u32::MAX - piece;
        for piece in [3, 5, 4] {
            sets.add(2, piece, key);
        }
        sets.copy(2, 4);
        assert_eq!(
            (sets.get(2), sets.get(4), sets.get(0), sets.get(9)),
            (&[5, 4, 3][..], &[5, 4, 3][..], &[][..], &[][..])
        );
        assert!(!sets.take(2, 5, key));
        assert!(!sets.take(2, 3, key));
        assert_eq!(sets.get(2), [4]);
        assert!(sets.has(2, 4, key) && !sets.has(2, 3, key) && sets.has(4, 3, key));
        assert!(sets.take(2, 4, key));
        sets.clear(4);
        assert!(sets.get(2).is_empty() && sets.get(4).is_empty());
        sets.add(1, 7, key);
        sets.add(1, 8, key);
        assert_eq!(sets.get(1), [8, 7]);
        assert_eq!(sets.many.len(), 2, "places of sets are used again");
    }
}
