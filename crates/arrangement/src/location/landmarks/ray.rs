//! What a vertical ray meets.

use super::walk::{Ground, Spot};
use crate::arrangement::Arrangement;
use crate::decomposition::{SiteId, TrapezoidId};
use crate::edit::Stale;
use crate::location::VerticalRay;
use crate::overlay::Cell;
use crate::topology::{Site, SiteAt, Topology};
use crate::traits::{Along, BasicTraits, Location, SideKind};
use dcel::{EdgeId, VertexId};
use std::cmp::Ordering;

/// A site as if it were on another side along v.
fn at_v<G: BasicTraits>(site: Site<'_, G>, v: Along) -> Site<'_, G> {
    Site { location: Location { v, ..site.location }, at: site.at }
}

/// A ray that begins at a place.
///
/// In the order of sites, what is straight above a place is just behind it, and what is straight below, just before. So within a
/// trapezoid the ray runs into the site at the right wall if that has the same u, or into the one at the left wall if it goes down; else
/// into the edge above or below.
pub(super) struct Shot<'a, G: BasicTraits, T> {
    pub(super) ground: &'a Ground,
    pub(super) arrangement: &'a Arrangement<G, T>,
    pub(super) place: Site<'a, G>,
    pub(super) ray: VerticalRay,
}

impl<G: BasicTraits, T: Topology<G>> Shot<'_, G, T> {
    /// What the ray meets, from where its place was found.
    pub(super) fn meets(&self, spot: Spot) -> Result<Cell, Stale> {
        let first = match spot {
            Spot::Inside(t) => t,
            Spot::Edge(e, _) if self.is_vertical(e) => return Ok(Cell::Edge(e)),
            Spot::Edge(e, rank) => match self.ray {
                VerticalRay::Up => self.ground.over(Some(e), rank),
                VerticalRay::Down => self.ground.under(Some(e), rank),
            },
            Spot::Site(site) => match self.leave(site) {
                Ok(t) => t,
                Err(vertical) => return Ok(Cell::Edge(vertical)),
            },
        };
        if let Some(cell) = self.meets_within(first) {
            return Ok(cell);
        }
        let last = match self.arrangement.topology().sides().v[self.side()] {
            SideKind::Identified => match self.beyond(spot) {
                Ok(t) => t,
                Err(cell) => return Ok(cell),
            },
            SideKind::Contracted => match self.pole() {
                Some(v) => return Ok(Cell::Vertex(v)),
                None => return self.face(first),
            },
            SideKind::Open | SideKind::Closed => return self.face(first),
        };
        self.meets_within(last).map_or_else(|| self.face(first), Ok)
    }

    fn face(&self, t: TrapezoidId) -> Result<Cell, Stale> {
        self.ground.decomposition.face_of(self.arrangement, t).map(Cell::Face)
    }

    fn is_vertical(&self, e: EdgeId) -> bool {
        self.arrangement.traits().is_vertical(self.arrangement.curve_of(e))
    }

    /// The trapezoid into which the ray leaves a site, or the vertical edge along which.
    ///
    /// A vertical edge is the highest of those that begin at its lower end, and the lowest of those that end at its upper one.
    fn leave(&self, site: SiteId) -> Result<TrapezoidId, EdgeId> {
        let decomposition = &self.ground.decomposition;
        let (walls, t) = match self.ray {
            VerticalRay::Up => (decomposition.right_of(site), decomposition.right_of(site)[1]),
            VerticalRay::Down => (decomposition.left_of(site), decomposition.left_of(site)[0]),
        };
        let trapezoid = decomposition.trapezoid(t);
        let along = match self.ray {
            VerticalRay::Up => trapezoid.below,
            VerticalRay::Down => trapezoid.above,
        };
        match along.filter(|&e| walls[0] != walls[1] && self.is_vertical(e)) {
            Some(vertical) => Err(vertical),
            None => Ok(t),
        }
    }

    /// What the ray meets in a trapezoid, or where it leaves it; `None` at a side of the parameter space.
    fn meets_within(&self, t: TrapezoidId) -> Option<Cell> {
        let trapezoid = self.ground.decomposition.trapezoid(t);
        let (wall, edge) = match self.ray {
            VerticalRay::Up => (trapezoid.right, trapezoid.above),
            VerticalRay::Down => (trapezoid.left, trapezoid.below),
        };
        match wall.filter(|&site| self.compare_u(site).is_eq()) {
            // In an open corner of the left side curves end at which the ray never arrives.
            Some(site) if self.is_on_open_side(site) => None,
            Some(site) => Some(Cell::Vertex(self.ground.decomposition.vertex(site))),
            None => edge.map(Cell::Edge),
        }
    }

    /// Whether a site is on an open side.
    fn is_on_open_side(&self, site: SiteId) -> bool {
        let sides = self.arrangement.topology().sides();
        let is_open = |along, kinds: [SideKind; 2]| match along {
            Along::Low => kinds[0] == SideKind::Open,
            Along::Inside => false,
            Along::High => kinds[1] == SideKind::Open,
        };
        let location = self.ground.decomposition.location(site);
        is_open(location.u, sides.u) || is_open(location.v, sides.v)
    }

    /// Compares the u of the place with that of a site.
    ///
    /// Where one of them is on the bottom or top, it is compared as if it were on either: what has the same u is between.
    fn compare_u(&self, site: SiteId) -> Ordering {
        let (traits, topology) = (self.arrangement.traits(), self.arrangement.topology());
        let (here, there) = (self.place, self.ground.place(self.arrangement, site));
        let by_side = here.location.u.cmp(&there.location.u);
        if by_side.is_ne() || here.location.u != Along::Inside {
            return by_side;
        }
        if let (true, true, SiteAt::Point(p), SiteAt::Point(q)) =
            (here.location.is_interior(), there.location.is_interior(), here.at, there.at)
        {
            return traits.compare_u(p, q);
        }
        let compare = |v: Along| {
            if here.location.v == Along::Inside {
                topology.compare_sites(traits, &here, &at_v(there, v))
            } else if there.location.v == Along::Inside {
                topology.compare_sites(traits, &at_v(here, v), &there)
            } else {
                topology.compare_sites(traits, &at_v(here, there.location.v), &there)
            }
        };
        let [low, high] = [compare(Along::Low), compare(Along::High)];
        if low == high { low } else { Ordering::Equal }
    }

    /// The side to which the ray goes, 0 for the bottom.
    fn side(&self) -> usize {
        match self.ray {
            VerticalRay::Up => 1,
            VerticalRay::Down => 0,
        }
    }

    /// The vertex to which the side is contracted, if something is there.
    fn pole(&self) -> Option<VertexId> {
        let v = VertexId(self.arrangement.topology().side_vertices()[2 + self.side()]?);
        self.arrangement.is_at_contraction(v).then_some(v)
    }

    /// The trapezoid into which the ray runs where it goes on at the opposite side, or what it meets there.
    fn beyond(&self, spot: Spot) -> Result<TrapezoidId, Cell> {
        let (ground, decomposition) = (self.ground, &self.ground.decomposition);
        let (opposite, other_sites) = match self.ray {
            VerticalRay::Up => (Along::Low, Ordering::Less),
            VerticalRay::Down => (Along::High, Ordering::Greater),
        };
        // On the left side the place is in its corner, which lies before or behind all other sites of the side.
        let rank = ground.rank_by(|site| {
            self.compare_u(site).then_with(|| match decomposition.location(site).v == opposite {
                true => Ordering::Equal,
                false => other_sites,
            })
        });
        match (rank, self.ray) {
            (Ok(rank), VerticalRay::Up) => Ok(ground.over(None, rank)),
            (Ok(rank), VerticalRay::Down) => Ok(ground.under(None, rank)),
            (Err(site), VerticalRay::Up) => Err(Cell::Vertex(decomposition.vertex(site))),
            (Err(site), VerticalRay::Down) => {
                // A vertex on the seam was met at the bottom, unless the ray begins there.
                let v = decomposition.vertex(site);
                match spot {
                    Spot::Site(start) if decomposition.vertex(start) == v => {
                        self.leave(site).map_err(Cell::Edge)
                    }
                    _ => Err(Cell::Vertex(v)),
                }
            }
        }
    }
}
