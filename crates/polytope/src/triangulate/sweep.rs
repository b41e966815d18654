//! A facet with holes, cut into triangles by a sweep.
//!
//! The corners are visited in an order of the plane, which we imagine from left to right; above and below are
//! as seen then, and of two corners on one vertical line the lower comes first. The *status* has the edges
//! that begin before the sweep line and do not end before it, from bottom to top. A *gap* is a part of the
//! facet between two consecutive edges of the status; everything to the left of its *chain* has been cut into
//! triangles. The chain runs from the last visited corner of the lower edge up to that of the upper edge. It
//! has no corner that could be cut off: seen from the right, none is less than half a turn.
//!
//! At a corner:
//! 1. The edges that end there are found in the status by halving. They close the gaps between them: what is
//!    left of such a gap is seen from the corner, and becomes a fan.
//! 2. The corner becomes the end of the chain in the gap below and in the gap above them, as soon as the part
//!    of the chain that it sees is cut off. If no edge ends there, but the corner lies in a gap, it sees the
//!    corner that was the last one visited in this gap; the chain is cut in two there.
//! 3. The edges that begin there take their place in the status. The gaps between them begin with the corner
//!    alone. If none begins, the gaps below and above become one.
//!
//! Any number of edges may meet at a corner, in any direction: touching cycles, edges that are run through
//! both ways, and corners on no edge at all are no special cases.
//!
//! Nothing is assumed about the input. Edges that become neighbors in the status are checked for a crossing,
//! which finds the first one (Shamos and Hoey), and edges around a corner must in turn have the facet on
//! their one and on their other side. So the boundary winds once around what is cut and not at all around the
//! rest.

use super::outline::Outline;
use super::status::Status;
use exact::Sign;
use std::cmp::Ordering;

/// Why a boundary does not enclose a facet.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Fault {
    /// Two edges, as vertices, that cross, overlap, or touch elsewhere than at vertices.
    Crossing([[u32; 2]; 2]),
    /// An edge that has the facet, or its outside, on both sides.
    Astray([u32; 2]),
}

const NONE: u32 = u32::MAX;

/// A corner in a chain.
#[derive(Clone, Copy)]
struct Node {
    corner: u32,
    below: u32,
    above: u32,
}

/// A part of the facet between two edges of the status: the ends of its chain, and its last visited corner.
#[derive(Clone, Copy)]
struct Gap {
    bottom: u32,
    top: u32,
    recent: u32,
}

struct Sweep<'o, 'p> {
    outline: &'o Outline<'p>,
    /// The edges on the sweep line, from bottom to top.
    status: Status,
    /// For each forward edge of the status: the gap above it.
    gaps: Vec<Gap>,
    nodes: Vec<Node>,
    triangles: Vec<[u32; 3]>,
}

/// Cuts the facet with that boundary into triangles of its vertices, each counterclockwise.
///
/// # Complexity
/// `k log k` tests for k corners, and for each corner moving a part of the status that has at most the root of
/// k, or 512, edges.
///
/// # References
/// S. Hertel and K. Mehlhorn, "Fast triangulation of the plane with respect to simple polygons", 1985.
/// M. I. Shamos and D. Hoey, "Geometric intersection problems", 1976.
pub(super) fn triangles(outline: &Outline<'_>) -> Result<Vec<[u32; 3]>, Fault> {
    let none = Gap { bottom: NONE, top: NONE, recent: NONE };
    let mut sweep = Sweep {
        outline,
        status: Status::new(outline.edges.len()),
        gaps: vec![none; outline.edges.len()],
        nodes: Vec::new(),
        triangles: Vec::new(),
    };
    outline.visit_corners(|at, starting| sweep.visit(at, starting))?;
    let vertices = |triangle: &[u32; 3]| triangle.map(|corner| outline.vertex(corner));
    Ok(sweep.triangles.iter().map(vertices).collect())
}

impl Sweep<'_, '_> {
    /// Visits a corner at which edges start.
    fn visit(&mut self, at: u32, starting: &mut [u32]) -> Result<(), Fault> {
        let outline = self.outline;
        let place = self.status.search(|edge| outline.side(edge, at) == Sign::Positive);
        let ends_here = |edge: &u32| outline.side(*edge, at) == Sign::Zero;
        let ending: Vec<u32> = self.status.from(place).take_while(ends_here).collect();
        let over = self.status.from(place).nth(ending.len());
        self.sort(starting)?;
        let passing = ending.iter().find(|&&e| outline.rank(outline.edge(e).high) != outline.rank(at));
        if let Some(&edge) = passing {
            return Err(match starting.iter().chain(&ending).find(|&&other| other != edge) {
                Some(&other) => self.crossing(edge, other),
                None => Fault::Astray(outline.ends(edge)),
            });
        }
        let below = self.status.below(place);
        let inside = below.is_some_and(|edge| outline.edge(edge).forward);
        self.check_ring(&ending, starting, inside)?;

        // The corners of the gaps below and above: each has the vertex of the edges that bound it.
        let (low, high) = match (&*starting, &ending[..]) {
            ([bottom, .., top], _) => (outline.edge(*bottom).low, outline.edge(*top).low),
            ([only], _) => (outline.edge(*only).low, outline.edge(*only).low),
            (_, [bottom, .., top]) => (outline.edge(*bottom).high, outline.edge(*top).high),
            (_, [only]) => (outline.edge(*only).high, outline.edge(*only).high),
            _ => (at, at),
        };
        let gap_below = below.filter(|_| inside).map(|edge| self.gaps[edge as usize]);
        let (lower, upper) = match (&ending[..], gap_below) {
            ([], None) => (None, None),
            ([], Some(gap)) => {
                let (lower, upper) = self.divide(gap, low, high);
                (Some(lower), Some(upper))
            }
            ([.., top], gap) => {
                let lower = gap.map(|gap| self.extend_top(gap, low));
                for pair in ending.windows(2).filter(|pair| outline.edge(pair[0]).forward) {
                    self.close(pair, outline.edge(pair[0]).high)?;
                }
                let above = outline.edge(*top).forward.then(|| self.gaps[*top as usize]);
                (lower, above.map(|gap| self.extend_bottom(gap, high)))
            }
        };
        for &edge in starting.iter().filter(|&&edge| outline.edge(edge).forward) {
            let node = self.node(Node { corner: outline.edge(edge).low, below: NONE, above: NONE });
            self.gaps[edge as usize] = Gap { bottom: node, top: node, recent: node };
        }
        match (below, starting.last(), lower, upper) {
            (Some(edge), None, Some(lower), Some(upper)) => {
                self.gaps[edge as usize] = self.unite(lower, upper)
            }
            (below, last, lower, upper) => {
                if let (Some(edge), Some(lower)) = (below, lower) {
                    self.gaps[edge as usize] = lower;
                }
                if let (Some(&edge), Some(upper)) = (last, upper) {
                    self.gaps[edge as usize] = upper;
                }
            }
        }
        self.status.replace(place, ending.len(), starting);
        match (starting.first(), starting.last()) {
            (Some(&first), Some(&last)) => {
                self.check_seam(below, Some(first))?;
                self.check_seam(Some(last), over)
            }
            _ => self.check_seam(below, over),
        }
    }

    /// Sorts edges that start at one place from bottom to top. Where two run through the same edge, the facet
    /// is on both sides of them.
    fn sort(&self, starting: &mut [u32]) -> Result<(), Fault> {
        let outline = self.outline;
        outline.sort_starting(starting);
        for pair in starting.windows(2) {
            let [a, b] = [0, 1].map(|i| outline.length_and_way(pair[i]));
            if outline.turn_between(pair[0], pair[1]) == Sign::Zero && (a.0 != b.0 || a.1 == b.1) {
                return Err(self.crossing(pair[0], pair[1]));
            }
        }
        Ok(())
    }

    /// Checks the edges around a corner, counterclockwise from straight down: in turn one must leave the
    /// corner, so that the facet is behind it, and the next arrive there, at the same vertex.
    fn check_ring(&self, ending: &[u32], starting: &[u32], inside: bool) -> Result<(), Fault> {
        let outline = self.outline;
        if let Some(&edge) = starting.first()
            && outline.edge(edge).forward == inside
        {
            return Err(Fault::Astray(outline.ends(edge)));
        }
        // With the corner of each edge here, and whether it leaves.
        let right = starting.iter().map(|&e| (e, outline.edge(e).low, outline.edge(e).forward));
        let left = ending.iter().rev().map(|&e| (e, outline.edge(e).high, !outline.edge(e).forward));
        let ring: Vec<(u32, u32, bool)> = right.chain(left).collect();
        for (i, &(edge, corner, leaves)) in ring.iter().enumerate() {
            let (next, arrival, next_leaves) = ring[(i + 1) % ring.len()];
            if leaves == next_leaves {
                return Err(Fault::Astray(outline.ends(edge)));
            }
            if leaves && outline.vertex(corner) != outline.vertex(arrival) {
                return Err(self.crossing(edge, next));
            }
        }
        Ok(())
    }

    /// Checks that two edges that have become neighbors in the status do not cross.
    fn check_seam(&self, lower: Option<u32>, upper: Option<u32>) -> Result<(), Fault> {
        let outline = self.outline;
        let (Some(lower), Some(upper)) = (lower, upper) else { return Ok(()) };
        let ends = [lower, upper].map(|edge| outline.edge(edge).high);
        let apart = match outline.rank(ends[0]).cmp(&outline.rank(ends[1])) {
            Ordering::Less => outline.side(upper, ends[0]) == Sign::Negative,
            Ordering::Equal => true,
            Ordering::Greater => outline.side(lower, ends[1]) == Sign::Positive,
        };
        if apart { Ok(()) } else { Err(self.crossing(lower, upper)) }
    }

    fn crossing(&self, a: u32, b: u32) -> Fault {
        Fault::Crossing([a, b].map(|edge| self.outline.ends(edge)))
    }

    fn node(&mut self, node: Node) -> u32 {
        self.nodes.push(node);
        self.nodes.len() as u32 - 1
    }

    fn corner(&self, node: u32) -> u32 {
        self.nodes[node as usize].corner
    }

    /// Cuts off the chain below a node as far as a corner on its right sees it, and gives the last node seen.
    fn cut_down(&mut self, mut node: u32, at: u32) -> u32 {
        loop {
            let below = self.nodes[node as usize].below;
            if below == NONE || !self.cut(below, node, at) {
                return node;
            }
            node = below;
        }
    }

    /// The same with the chain above.
    fn cut_up(&mut self, mut node: u32, at: u32) -> u32 {
        loop {
            let above = self.nodes[node as usize].above;
            if above == NONE || !self.cut(node, above, at) {
                return node;
            }
            node = above;
        }
    }

    /// Makes a triangle if its corner on the right of two nodes sees them.
    fn cut(&mut self, lower: u32, upper: u32, at: u32) -> bool {
        let [lower, upper] = [lower, upper].map(|node| self.corner(node));
        let seen = self.outline.turn(lower, at, upper) == Sign::Positive;
        if seen {
            self.triangles.push([lower, at, upper]);
        }
        seen
    }

    /// The upper edge of a gap ends.
    fn extend_top(&mut self, gap: Gap, at: u32) -> Gap {
        let seen = self.cut_down(gap.top, at);
        let top = self.node(Node { corner: at, below: seen, above: NONE });
        self.nodes[seen as usize].above = top;
        Gap { bottom: gap.bottom, top, recent: top }
    }

    /// The lower edge of a gap ends.
    fn extend_bottom(&mut self, gap: Gap, at: u32) -> Gap {
        let seen = self.cut_up(gap.bottom, at);
        let bottom = self.node(Node { corner: at, below: NONE, above: seen });
        self.nodes[seen as usize].below = bottom;
        Gap { bottom, top: gap.top, recent: bottom }
    }

    /// Both edges of a gap end.
    fn close(&mut self, edges: &[u32], at: u32) -> Result<(), Fault> {
        let gap = self.gaps[edges[0] as usize];
        if self.cut_up(gap.bottom, at) == gap.top { Ok(()) } else { Err(self.crossing(edges[0], edges[1])) }
    }

    /// A corner lies in a gap; it is at once the top of the gap below and the bottom of the gap above.
    fn divide(&mut self, gap: Gap, low: u32, high: u32) -> (Gap, Gap) {
        let down = self.cut_down(gap.recent, low);
        let mut up = self.cut_up(gap.recent, low);
        let mut last = gap.top;
        if up == down {
            // No edge of the chain is seen, only a corner: it belongs to both parts.
            let Node { corner, above, .. } = self.nodes[down as usize];
            up = self.node(Node { corner, below: NONE, above });
            if above == NONE {
                last = up;
            } else {
                self.nodes[above as usize].below = up;
            }
        }
        let top = self.node(Node { corner: low, below: down, above: NONE });
        let bottom = self.node(Node { corner: high, below: NONE, above: up });
        self.nodes[down as usize].above = top;
        self.nodes[up as usize].below = bottom;
        (Gap { bottom: gap.bottom, top, recent: top }, Gap { bottom, top: last, recent: bottom })
    }

    /// Two gaps that end in the same corner go on as one.
    fn unite(&mut self, lower: Gap, upper: Gap) -> Gap {
        let above = self.nodes[upper.bottom as usize].above;
        self.nodes[lower.top as usize].above = above;
        self.nodes[above as usize].below = lower.top;
        Gap { bottom: lower.bottom, top: upper.top, recent: lower.top }
    }
}
