//! What is straight above and below each vertex.

use super::records::{NONE, TrapezoidRecord};
use super::{SiteId, VerticalDecomposition};
use crate::traits::{Along, Location};
use dcel::{EdgeId, VertexId};

/// What a wall meets first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum WallEnd {
    /// A vertex of the same u.
    Vertex(VertexId),
    /// An edge, in its interior.
    Edge(EdgeId),
    /// A side of the parameter space, where no site is.
    Side,
    /// Nothing, because the wall has no length: a vertical edge goes the same way, or the site is on the side to which the wall would go.
    Nothing,
}

/// What is straight above or below a site.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Step {
    /// Another site, at the end of a wall.
    Site(SiteId),
    /// An edge in its interior, at the end of a wall.
    Edge(EdgeId),
    /// A side, at the end of a wall.
    Side,
    /// A vertical edge, and the site at its other end.
    Along(EdgeId, SiteId),
    /// Nothing: the site is on the side itself, or on the left or right one.
    Out,
}

impl VerticalDecomposition {
    /// What the walls of a site meet: the one that goes down, and the one that goes up. Sites on the left and right side have no walls.
    ///
    /// # Panics
    /// If there is no such site.
    ///
    /// # Complexity
    /// Constant.
    pub fn walls(&self, site: SiteId) -> [WallEnd; 2] {
        [self.step_down(site), self.step_up(site)].map(|step| match step {
            Step::Site(site) => WallEnd::Vertex(self.vertex(site)),
            Step::Edge(e) => WallEnd::Edge(e),
            Step::Side => WallEnd::Side,
            Step::Along(..) | Step::Out => WallEnd::Nothing,
        })
    }

    /// What is straight below and above a vertex; where it has several sites, below the first and above the last that is not on the
    /// left or right side. `Nothing` for a vertex that has no such site.
    ///
    /// # Complexity
    /// Linear in the number of sites of the vertex.
    pub fn walls_of(&self, v: VertexId) -> [WallEnd; 2] {
        let mut walls = [WallEnd::Nothing; 2];
        for site in self.sites_of(v) {
            for (wall, end) in walls.iter_mut().zip(self.walls(site)) {
                if *wall == WallEnd::Nothing {
                    *wall = end;
                }
            }
        }
        walls
    }

    pub(super) fn step_down(&self, site: SiteId) -> Step {
        let Location { u, v } = self.location(site);
        if u != Along::Inside || v == Along::Low {
            return Step::Out;
        }
        let t = self.left_of(site)[0];
        let TrapezoidRecord { left, below, above, .. } = self.trapezoids[t.index()];
        if !self.has_one_u(t) {
            return end_at(below);
        }
        // A vertical edge would be between the upper wall of the other site and the lower one of this.
        let other = SiteId(left);
        if self.right_of(other)[1] == t { Step::Site(other) } else { Step::Along(EdgeId(above), other) }
    }

    pub(super) fn step_up(&self, site: SiteId) -> Step {
        let Location { u, v } = self.location(site);
        if u != Along::Inside || v == Along::High {
            return Step::Out;
        }
        let t = self.right_of(site)[1];
        let TrapezoidRecord { right, below, above, .. } = self.trapezoids[t.index()];
        if !self.has_one_u(t) {
            return end_at(above);
        }
        let other = SiteId(right);
        if self.left_of(other)[0] == t { Step::Site(other) } else { Step::Along(EdgeId(below), other) }
    }
}

fn end_at(edge: u32) -> Step {
    if edge == NONE { Step::Side } else { Step::Edge(EdgeId(edge)) }
}
