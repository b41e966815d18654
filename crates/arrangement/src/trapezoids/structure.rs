//! The search structure: comparisons that lead to trapezoids.
//!
//! A node compares with a site or a curve, and has two branches, to nodes or trapezoids. A trapezoid that is no more leads on to the node
//! that cut it, or to another trapezoid. So nodes are only added, and several may lead to one trapezoid. When all is built, nodes are put
//! in an order in which a path finds those that come next near, and such detours are left out.

use super::{SiteId, Trapezoid, TrapezoidId};
use crate::topology::Site;
use crate::traits::BasicTraits;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Where a path goes on: a node or a trapezoid.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Branch(u32);

/// The bit of a number that tells trapezoids from nodes, and curves from sites.
const MARK: u32 = 1 << 31;

impl Branch {
    #[inline]
    fn node(index: usize) -> Self {
        Self(number(index))
    }

    /// No branch.
    pub(super) const NONE: Self = Self(u32::MAX);

    /// The end of a path.
    #[inline]
    pub(super) fn leaf(t: TrapezoidId) -> Self {
        Self(MARK | number(t.index()))
    }

    /// The trapezoid, or the number of a node.
    #[inline]
    fn place(self) -> Result<TrapezoidId, usize> {
        let index = self.0 & !MARK;
        if self.0 & MARK == 0 { Err(index as usize) } else { Ok(TrapezoidId(index)) }
    }
}

#[inline]
fn number(index: usize) -> u32 {
    u32::try_from(index).ok().filter(|&number| number < MARK - 1).expect("there are fewer than 2^31 nodes")
}

/// A comparison, in 24 bytes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// The number of a site, or with the highest bit that of a curve.
    what: u32,
    key: [u32; 3],
    branches: [Branch; 2],
}

/// Numbers that order places as far as they go: see [`BasicTraits::order_range`].
#[derive(Clone, Copy, Debug)]
pub(super) struct OrderRange {
    least: u64,
    spread: u32,
}

impl OrderRange {
    /// That of a place; nothing is known of those on sides.
    #[inline]
    pub(super) fn of<G: BasicTraits>(traits: &G, place: &Site<'_, G>) -> Self {
        let inside = place.point().filter(|_| place.location.is_interior());
        let (least, spread) = inside.map_or((0, u32::MAX), |point| traits.order_range(point));
        Self { least, spread }
    }

    /// Tells whether all of a range is above all of another one; `None` if they meet, or nothing is known.
    #[inline]
    pub(super) fn is_behind(self, other: Self) -> Option<bool> {
        let is_known = self.spread != u32::MAX && other.spread != u32::MAX;
        if self.least > other.least {
            (is_known && self.least - other.least > u64::from(other.spread)).then_some(true)
        } else {
            (is_known && other.least - self.least > u64::from(self.spread)).then_some(false)
        }
    }
}

/// What a node compares with.
#[derive(Clone, Copy, Debug)]
pub(super) enum Comparison {
    /// What is before a site in the lexicographic order, and what is behind; the range of its place, so that most comparisons look no
    /// farther.
    Site(SiteId, OrderRange),
    /// What is below a curve, and what is above; the [side key](crate::traits::BasicTraits::side_key) of the curve.
    Curve(u32, [u32; 3]),
}

impl Node {
    /// Makes a node that compares with a site.
    pub(super) fn split(site: SiteId, range: OrderRange, branches: [Branch; 2]) -> Self {
        let OrderRange { least, spread } = range;
        Self { what: number(site.index()), key: [least as u32, (least >> 32) as u32, spread], branches }
    }

    /// Makes a node that compares with a curve.
    pub(super) fn curve(curve: u32, key: [u32; 3], branches: [Branch; 2]) -> Self {
        Self { what: MARK | number(curve as usize), key, branches }
    }

    /// What it compares with.
    #[inline]
    pub(super) fn comparison(&self) -> Comparison {
        let [low, high, spread] = self.key;
        if self.what & MARK == 0 {
            let least = u64::from(high) << 32 | u64::from(low);
            Comparison::Site(SiteId(self.what), OrderRange { least, spread })
        } else {
            Comparison::Curve(self.what & !MARK, self.key)
        }
    }

    /// Where to go on before the site or below the curve, and where else.
    #[inline]
    pub(super) fn branches(&self) -> [Branch; 2] {
        self.branches
    }
}

/// What is found where a path goes on.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step<'a> {
    Node(&'a Node),
    End(TrapezoidId),
}

/// The search structure of a decomposition.
#[derive(Debug)]
pub(super) struct Structure {
    nodes: Vec<Node>,
    root: Branch,
    /// How many nodes it had when it was built.
    built: usize,
    /// The length of its longest path then.
    longest: u32,
    /// Steps of searches beyond the logarithm since it was built. Searches that only read count as well.
    excess: AtomicU64,
}

impl Clone for Structure {
    fn clone(&self) -> Self {
        Self { nodes: self.nodes.clone(), excess: self.excess.load(Relaxed).into(), ..*self }
    }
}

impl Structure {
    /// One trapezoid, and no comparison.
    pub(super) fn new(t: TrapezoidId) -> Self {
        Self { nodes: Vec::new(), root: Branch::leaf(t), built: 0, longest: 0, excess: 0.into() }
    }

    /// Where all paths begin.
    #[inline]
    pub(super) fn root(&self) -> Branch {
        self.root
    }

    /// The length of the longest path when it was built.
    pub(super) fn longest_path(&self) -> u32 {
        self.longest
    }

    /// What is found at a branch: the node, or the trapezoid.
    #[inline]
    pub(super) fn at(&self, mut branch: Branch, trapezoids: &[Trapezoid]) -> Step<'_> {
        loop {
            let t = match branch.place() {
                Err(node) => return Step::Node(&self.nodes[node]),
                Ok(t) => t,
            };
            match trapezoids[t.index()].became {
                Branch::NONE => return Step::End(t),
                other => branch = other,
            }
        }
    }

    /// Adds a node.
    pub(super) fn add_node(&mut self, node: Node) -> Branch {
        self.nodes.push(node);
        Branch::node(self.nodes.len() - 1)
    }

    /// Says where a node leads.
    pub(super) fn set_branches(&mut self, node: Branch, branches: [Branch; 2]) {
        if let Err(node) = node.place() {
            self.nodes[node].branches = branches;
        }
    }

    /// Notes how many steps a search took among a number of trapezoids.
    #[inline]
    pub(super) fn note_steps(&self, steps: u32, trapezoids: usize) {
        let usual = 6 * (trapezoids.max(1).ilog2() + 1);
        if steps > usual {
            self.excess.fetch_add(u64::from(steps - usual), Relaxed);
        }
    }

    /// Tells whether searches took so long, for a number of trapezoids, that it pays to build all anew.
    pub(super) fn is_worn(&self, trapezoids: usize) -> bool {
        // Dead nodes count too: they are memory. But what was built anew just now is not worn, however unlucky its order was.
        let size = trapezoids as u64;
        let nodes = self.nodes.len().saturating_sub(self.built) as u64;
        self.excess.load(Relaxed) > 64 + 8 * size || nodes > 64 + (8 * size).max(self.built as u64)
    }

    /// Puts nodes in an order in which a path finds those that come next near, and leaves out trapezoids that are no more.
    /// These are numbered anew as well: the answer has their old numbers in the new order. To be done once, when all is built.
    ///
    /// Nodes from which there are about as many paths to trapezoids are together, and the others behind, in groups of which each is below
    /// one of them, and in order itself: so a path is in few places of memory, however large the places are that are read at once.
    ///
    /// # Complexity
    /// Linear in the number of nodes.
    ///
    /// # References
    /// Prokop, Cache-oblivious algorithms, 1999, section 10.2: the layout of van Emde Boas, for trees.
    pub(super) fn tidy(&mut self, trapezoids: &[Trapezoid]) -> Vec<TrapezoidId> {
        debug_assert!(self.built == 0, "the order of nodes is that in which they came");
        let weights = self.weights(trapezoids);
        let weight = |branch: Branch| branch.place().err().map_or((0, 1), |node| weights[node]);
        let mut nodes: Vec<Node> = Vec::with_capacity(self.nodes.len());
        let mut places = vec![Branch::NONE; self.nodes.len()];
        let mut leaves = Vec::with_capacity(trapezoids.len() / 2);
        let mut leaf_places = vec![Branch::NONE; trapezoids.len()];
        let old_root = resolve(self.root, trapezoids);
        let mut root = old_root;
        // Branches to be followed: of which new node, which one, and where it led. First those of a group, then later groups.
        let (mut open, mut later) = (Vec::new(), vec![(None, old_root)]);
        let mut least = 0;
        loop {
            let (of, old) = match open.pop() {
                Some(next) => next,
                None => match later.pop() {
                    Some(next) => {
                        least = weight(next.1).1 >> 6;
                        next
                    }
                    None => break,
                },
            };
            let new = match old.place() {
                Ok(t) => {
                    let place = &mut leaf_places[t.index()];
                    if *place == Branch::NONE {
                        *place = Branch::leaf(TrapezoidId::new(leaves.len()));
                        leaves.push(t);
                    }
                    *place
                }
                Err(node) => {
                    if places[node] == Branch::NONE {
                        let place = nodes.len();
                        places[node] = Branch::node(place);
                        let [first, second] =
                            self.nodes[node].branches.map(|branch| resolve(branch, trapezoids));
                        nodes.push(self.nodes[node]);
                        // The longer way is on top of the stack, and so comes next.
                        let [mut short, mut long] = [(0, first), (1, second)];
                        if weight(short.1).1 > weight(long.1).1 {
                            std::mem::swap(&mut short, &mut long);
                        }
                        for (i, branch) in [short, long] {
                            let group = if weight(branch).1 > least { &mut open } else { &mut later };
                            group.push((Some((place, i)), branch));
                        }
                    }
                    places[node]
                }
            };
            match of {
                Some((node, i)) => nodes[node].branches[i] = new,
                None => root = new,
            }
        }
        self.built = nodes.len();
        (self.nodes, self.root) = (nodes, root);
        self.excess = 0.into();
        self.longest = weight(old_root).0;
        leaves
    }

    /// For each node the length of the longest path from there, and the number of all paths.
    fn weights(&self, trapezoids: &[Trapezoid]) -> Vec<(u32, u64)> {
        let mut weights = vec![(0, 0); self.nodes.len()];
        // A trapezoid that is no more leads on to nodes that came later than the one that leads to it.
        for node in (0..self.nodes.len()).rev() {
            let [first, second] =
                self.nodes[node].branches.map(|branch| match resolve(branch, trapezoids).place() {
                    Ok(_) => (0u32, 1u64),
                    Err(later) => weights[later],
                });
            weights[node] = (1 + first.0.max(second.0), first.1.saturating_add(second.1));
        }
        weights
    }
}

/// A branch without detours.
#[inline]
fn resolve(mut branch: Branch, trapezoids: &[Trapezoid]) -> Branch {
    while let Ok(t) = branch.place()
        && trapezoids[t.index()].became != Branch::NONE
    {
        branch = trapezoids[t.index()].became;
    }
    branch
}

const _: () = assert!(size_of::<Node>() == 24);
