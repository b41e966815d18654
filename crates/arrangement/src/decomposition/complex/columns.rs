//! Sites of one u, and the vertices to which sides are closed.

use super::super::records::NONE;
use super::super::{SiteId, Trapezoid, VerticalDecomposition};
use crate::topology::Topology;
use crate::traits::{Along, BasicTraits, SideKind, Sides};

/// The left side.
pub(super) const LEFT: u32 = 0;
/// The right side.
pub(super) const RIGHT: u32 = NONE;

/// For each site the number of its u, from left to right.
#[derive(Debug)]
pub(super) struct Columns(Vec<u32>);

impl Columns {
    pub(super) fn new(decomposition: &VerticalDecomposition) -> Self {
        let mut last = LEFT;
        let column = |record: &super::super::records::SiteRecord| match record.location.u {
            Along::Low => LEFT,
            Along::High => RIGHT,
            Along::Inside => {
                last += u32::from(last == LEFT || !record.has_last_u);
                last
            }
        };
        Self(decomposition.sites.iter().map(column).collect())
    }

    /// A number above those of all columns but the right side.
    pub(super) fn bound(&self) -> usize {
        self.0.iter().rev().find(|&&column| column != RIGHT).map_or(1, |&column| column as usize + 1)
    }

    #[inline]
    pub(super) fn of(&self, site: SiteId) -> u32 {
        self.0[site.index()]
    }

    /// Where a trapezoid begins and ends.
    #[inline]
    pub(super) fn of_trapezoid(&self, t: &Trapezoid) -> [u32; 2] {
        [t.left.map_or(LEFT, |site| self.of(site)), t.right.map_or(RIGHT, |site| self.of(site))]
    }
}

/// What stands for a side that is not identified.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Closure {
    /// The vertex of the arrangement with this number.
    Vertex(u32),
    /// A new one, with a number from 0.
    New(u32),
    /// Nothing: it is identified.
    None,
}

/// The vertices that stand for sides, left, right, bottom and top.
pub(super) fn closures<G: BasicTraits, T: Topology<G>>(topology: &T) -> [Closure; 4] {
    let Sides { u, v } = topology.sides();
    let given = topology.side_vertices();
    let is_identified = |kinds: [SideKind; 2]| kinds[0] == SideKind::Identified;
    // Sides that meet in corners are closed together.
    let is_one = !is_identified(u) && !is_identified(v);
    let shared = given.into_iter().flatten().next();
    let mut next = 0;
    let mut closures = [Closure::None; 4];
    for (i, kind) in [u[0], u[1], v[0], v[1]].into_iter().enumerate() {
        closures[i] = match (kind, given[i]) {
            (SideKind::Identified, _) => Closure::None,
            (_, Some(v)) => Closure::Vertex(v),
            (_, None) if is_one => shared.map_or(Closure::New(0), Closure::Vertex),
            (_, None) => {
                next += 1;
                Closure::New(next - 1)
            }
        };
    }
    closures
}
