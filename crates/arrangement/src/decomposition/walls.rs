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
    ///
    /// # Examples
    /// A vertical segment, and a point above it:
    ///
    /// ```
    /// use exact::planar::Point2;
    /// use splitstar_arrangement::decomposition::{VerticalDecomposition, WallEnd};
    /// use splitstar_arrangement::models::{Segment, SegmentTraits};
    /// use splitstar_arrangement::{Arrangement, topology::BoundedPlane};
    ///
    /// let segment = Segment::from_i64([[1, 0], [1, 2]]).expect("the ends are different");
    /// let mut arrangement = Arrangement::of_curves(SegmentTraits, BoundedPlane, [&segment]);
    /// arrangement.insert_points([Point2::from_i64([1, 5])]);
    /// let decomposition = VerticalDecomposition::new(&arrangement);
    /// // Sites of one u come from bottom to top.
    /// let sites: Vec<_> = decomposition.sites().collect();
    /// let [end, point] = [sites[1], sites[2]].map(|site| WallEnd::Vertex(decomposition.vertex(site)));
    /// assert_eq!(decomposition.walls(sites[0]), [WallEnd::Side, WallEnd::Nothing]);
    /// assert_eq!(decomposition.walls(sites[1]), [WallEnd::Nothing, point]);
    /// assert_eq!(decomposition.walls(sites[2]), [end, WallEnd::Side]);
    /// ```
    pub fn walls(&self, site: SiteId) -> [WallEnd; 2] {
        [self.step_down(site), self.step_up(site)].map(|step| match step {
            Step::Site(site) => WallEnd::Vertex(self.vertex(site)),
            Step::Edge(e) => WallEnd::Edge(e),
            Step::Side => WallEnd::Side,
            Step::Along(..) | Step::Out => WallEnd::Nothing,
        })
    }

    /// What is straight below and above a vertex. Where it has several sites, each of the two is what [`walls`](Self::walls) gives for the
    /// first site, as a sweep meets them, whose wall that way has a length; `Nothing` if there is none, or no such vertex.
    ///
    /// Degenerate:
    /// - A vertex on identified bottom and top sides has its upper wall from its site on the bottom, and its lower one from its site on the
    ///   top. It has this only if an edge ends there: else nothing is said to be below, as walls do not go on beyond a side. So a ray
    ///   downwards, which does, may meet something where this is `Nothing` or a `Side`.
    /// - A vertex on identified left and right sides has no walls.
    /// - One that stands for a side has a site for each end of an edge there, each with its own walls: what is given is of one of them. So
    ///   a point that was given on a contracted side has none.
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
