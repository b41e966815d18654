//! The status line: the strands that meet the sweep line, from bottom to top.
//!
//! A treap with parent links, threaded as a list. Strands are inserted beside a known node, so the tree compares nothing itself;
//! its shape depends on the order of operations only, never on the outside.

/// No node, no curve.
pub(super) const NIL: u32 = u32::MAX;

/// Curves that run together between two events, and what the visitor attached to them.
#[derive(Clone, Copy, Debug)]
pub(super) struct StrandData<C, T> {
    /// The first curve of the list of those that run here.
    pub(super) head: u32,
    /// That curve itself.
    pub(super) curve: C,
    pub(super) tag: T,
}

#[derive(Clone, Debug)]
struct Node<C, T> {
    parent: u32,
    child: [u32; 2],
    priority: u32,
    prev: u32,
    next: u32,
    mark: u32,
    strand: StrandData<C, T>,
}

#[derive(Debug)]
pub(super) struct Status<C, T> {
    nodes: Vec<Node<C, T>>,
    free: Vec<u32>,
    root: u32,
    first: u32,
    last: u32,
    random: u32,
}

impl<C: Copy, T: Copy> Status<C, T> {
    pub(super) fn new() -> Self {
        Self { nodes: Vec::new(), free: Vec::new(), root: NIL, first: NIL, last: NIL, random: 0x9E37_79B9 }
    }

    pub(super) fn root(&self) -> u32 {
        self.root
    }

    pub(super) fn first(&self) -> u32 {
        self.first
    }

    pub(super) fn last(&self) -> u32 {
        self.last
    }

    /// The lower (0) or upper (1) child in the tree.
    #[inline]
    pub(super) fn child(&self, node: u32, side: usize) -> u32 {
        self.nodes[node as usize].child[side]
    }

    #[inline]
    pub(super) fn prev(&self, node: u32) -> u32 {
        self.nodes[node as usize].prev
    }

    #[inline]
    pub(super) fn next(&self, node: u32) -> u32 {
        self.nodes[node as usize].next
    }

    #[inline]
    pub(super) fn strand(&self, node: u32) -> &StrandData<C, T> {
        &self.nodes[node as usize].strand
    }

    #[inline]
    pub(super) fn set_strand(&mut self, node: u32, strand: StrandData<C, T>) {
        self.nodes[node as usize].strand = strand;
    }

    /// The number of the last event that marked the node.
    #[inline]
    pub(super) fn mark(&self, node: u32) -> u32 {
        self.nodes[node as usize].mark
    }

    #[inline]
    pub(super) fn set_mark(&mut self, node: u32, mark: u32) {
        self.nodes[node as usize].mark = mark;
    }

    /// Inserts a strand above a node, or at the bottom if `below` is `NIL`.
    pub(super) fn insert_above(&mut self, below: u32, strand: StrandData<C, T>) -> u32 {
        let above = if below == NIL { self.first } else { self.next(below) };
        let priority = self.next_priority();
        let node =
            Node { parent: NIL, child: [NIL; 2], priority, prev: below, next: above, mark: NIL, strand };
        let id = match self.free.pop() {
            Some(id) => {
                self.nodes[id as usize] = node;
                id
            }
            None => {
                self.nodes.push(node);
                u32::try_from(self.nodes.len() - 1).expect("fewer than 2^32 curves meet the sweep line")
            }
        };
        match below {
            NIL => self.first = id,
            _ => self.nodes[below as usize].next = id,
        }
        match above {
            NIL => self.last = id,
            _ => self.nodes[above as usize].prev = id,
        }
        // Of two neighbours one has a free place on the side of the other.
        if below != NIL && self.child(below, 1) == NIL {
            self.attach(below, 1, id);
        } else if above != NIL {
            self.attach(above, 0, id);
        } else {
            self.root = id;
        }
        while self.parent(id) != NIL && self.nodes[self.parent(id) as usize].priority < priority {
            self.rotate_up(id);
        }
        id
    }

    /// Takes a node out.
    pub(super) fn remove(&mut self, node: u32) {
        loop {
            let [lower, upper] = self.nodes[node as usize].child;
            let up = match (lower, upper) {
                (NIL, NIL) => break,
                (NIL, child) | (child, NIL) => child,
                (a, b) if self.nodes[a as usize].priority > self.nodes[b as usize].priority => a,
                (_, b) => b,
            };
            self.rotate_up(up);
        }
        let Node { parent, prev, next, .. } = self.nodes[node as usize];
        match parent {
            NIL => self.root = NIL,
            _ => {
                let side = usize::from(self.child(parent, 1) == node);
                self.nodes[parent as usize].child[side] = NIL;
            }
        }
        match prev {
            NIL => self.first = next,
            _ => self.nodes[prev as usize].next = next,
        }
        match next {
            NIL => self.last = prev,
            _ => self.nodes[next as usize].prev = prev,
        }
        self.free.push(node);
    }

    #[inline]
    fn parent(&self, node: u32) -> u32 {
        self.nodes[node as usize].parent
    }

    fn attach(&mut self, parent: u32, side: usize, child: u32) {
        self.nodes[parent as usize].child[side] = child;
        if child != NIL {
            self.nodes[child as usize].parent = parent;
        }
    }

    /// Exchanges a node with its parent, keeping the order.
    fn rotate_up(&mut self, node: u32) {
        let parent = self.parent(node);
        let grandparent = self.parent(parent);
        let side = usize::from(self.child(parent, 1) == node);
        let inner = self.child(node, 1 - side);
        self.attach(parent, side, inner);
        self.attach(node, 1 - side, parent);
        self.nodes[node as usize].parent = grandparent;
        match grandparent {
            NIL => self.root = node,
            _ => {
                let side = usize::from(self.child(grandparent, 1) == parent);
                self.nodes[grandparent as usize].child[side] = node;
            }
        }
    }

    fn next_priority(&mut self) -> u32 {
        // Xorshift: any sequence without a pattern does.
        self.random ^= self.random << 13;
        self.random ^= self.random >> 17;
        self.random ^= self.random << 5;
        self.random
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_and_the_tree_keep_one_order() {
        let mut status = Status::new();
        let mut model: Vec<(u32, u32)> = Vec::new();
        let mut random = 12345_u32;
        let mut draw = |bound: usize| {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (random >> 8) as usize % bound
        };
        for step in 0..5000_u32 {
            if model.len() < 3 || draw(5) < 3 {
                let place = draw(model.len() + 1);
                let below = if place == 0 { NIL } else { model[place - 1].0 };
                let node = status.insert_above(below, StrandData { head: step, curve: (), tag: () });
                model.insert(place, (node, step));
            } else {
                let (node, _) = model.remove(draw(model.len()));
                status.remove(node);
            }
            let mut list = Vec::new();
            let mut node = status.first();
            while node != NIL {
                list.push((node, status.strand(node).head));
                node = status.next(node);
            }
            assert_eq!(list, model, "step {step}");
            assert_eq!(in_order(&status, status.root()), model.iter().map(|m| m.0).collect::<Vec<_>>());
        }
    }

    fn in_order(status: &Status<(), ()>, node: u32) -> Vec<u32> {
        if node == NIL {
            return Vec::new();
        }
        let mut out = in_order(status, status.child(node, 0));
        out.push(node);
        out.extend(in_order(status, status.child(node, 1)));
        out
    }
}
