//! The vertical line through a point: what of an arrangement is on it, in which order, and which face is in between.
//!
//! Everything is decided from the sites of vertices and the supports of edges, without any structure.

use super::VerticalRay;
use crate::arrangement::Arrangement;
use crate::overlay::Cell;
use crate::topology::{Site, SiteAt, Topology};
use crate::traits::{Along, BasicTraits, Location, SideKind, UMonotoneTraits};
use crate::trapezoids::{compare_right, side};
use dcel::{EdgeId, FaceId, HalfedgeId, VertexId};
use std::cmp::Ordering;

const BOTTOM: Location = Location { u: Along::Inside, v: Along::Low };

/// What may lie across a vertical line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Bar {
    /// A vertex on the line.
    Vertex(VertexId),
    /// An edge that is not vertical and passes from the left of the line to the right.
    Edge(EdgeId),
}

impl Bar {
    pub(super) fn cell(self) -> Cell {
        match self {
            Self::Vertex(v) => Cell::Vertex(v),
            Self::Edge(e) => Cell::Edge(e),
        }
    }
}

/// How an edge comes to a vertical line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Reach {
    /// It does not, or only with an end.
    Beside,
    /// It passes from the left to the right.
    Across,
    /// It lies on the line.
    Along,
}

/// The vertical line through a point.
///
/// If the point is on the left side of the parameter space, so is the line: a seam, which is met on the left only. Along the line,
/// what is on the bottom side comes first; if this is glued to the top side, it is not met there again.
#[derive(Debug)]
pub(super) struct Column<'a, G: BasicTraits, T> {
    arrangement: &'a Arrangement<G, T>,
    pub(super) place: Site<'a, G>,
}

impl<'a, G: UMonotoneTraits, T: Topology<G>> Column<'a, G, T> {
    pub(super) fn new(arrangement: &'a Arrangement<G, T>, point: &'a G::Point) -> Self {
        let place = Site::of_point(arrangement.topology(), arrangement.traits(), point);
        Self { arrangement, place }
    }

    /// The cell, if the point is one to which a side is contracted.
    pub(super) fn at_contraction(&self) -> Option<Cell> {
        self.arrangement.cell_at_contraction(self.place.location)
    }

    fn compare_sites(&self, a: &Site<'_, G>, b: &Site<'_, G>) -> Ordering {
        self.arrangement.topology().compare_sites(self.arrangement.traits(), a, b)
    }

    /// The least site of a vertex; `None` if it stands for a side.
    fn home(&self, v: VertexId) -> Option<Site<'a, G>> {
        let (traits, topology) = (self.arrangement.traits(), self.arrangement.topology());
        self.arrangement.inner_point(v).map(|point| Site::of_point(topology, traits, point))
    }

    fn ends(&self, e: EdgeId) -> [Site<'a, G>; 2] {
        [e.halfedge(), e.halfedge().twin()].map(|h| self.arrangement.start_site(h))
    }

    /// Compares a site with the line, by u.
    pub(super) fn beside(&self, site: &Site<'_, G>) -> Ordering {
        let (here, there) = (site.location, self.place.location);
        let by_side = here.u.cmp(&there.u);
        if by_side.is_ne() || there.u != Along::Inside {
            return by_side;
        }
        match (site.at, self.place.at) {
            (SiteAt::Point(p), SiteAt::Point(q)) if here.v == Along::Inside && there.v == Along::Inside => {
                self.arrangement.traits().compare_u(p, q)
            }
            (SiteAt::Point(_), _) => {
                // One of them is on the bottom or top: the other is taken straight down.
                let [site, place] = [site.at, self.place.at].map(|at| Site { location: BOTTOM, at });
                self.compare_sites(&site, &place)
            }
            (SiteAt::End(..), _) => self.compare_sites(site, &self.place),
        }
    }

    /// Tells whether a vertex is on the line.
    pub(super) fn has_vertex(&self, v: VertexId) -> bool {
        self.home(v).is_some_and(|site| self.beside(&site).is_eq())
    }

    /// How an edge comes to the line.
    pub(super) fn reach(&self, e: EdgeId) -> Reach {
        let [start, end] = self.ends(e);
        let (from, to) = (self.beside(&start), self.beside(&end));
        // A vertical edge may have ends without points, which are before or behind all points of one u.
        match self.arrangement.traits().is_vertical(self.arrangement.curve_of(e)) {
            true if from.is_le() && to.is_ge() => Reach::Along,
            false if from.is_lt() && to.is_gt() => Reach::Across,
            _ => Reach::Beside,
        }
    }

    /// Tells whether an edge passes from the left of the line to the right.
    pub(super) fn has_edge(&self, e: EdgeId) -> bool {
        self.reach(e) == Reach::Across
    }

    /// Tells whether the point is that of a vertex.
    pub(super) fn is_at(&self, v: VertexId) -> bool {
        self.home(v).is_some_and(|site| self.compare_sites(&site, &self.place).is_eq())
    }

    /// Tells whether the point is in the interior of an edge.
    pub(super) fn is_on(&self, e: EdgeId) -> bool {
        let [start, end] = self.ends(e);
        self.compare_sites(&start, &self.place).is_lt()
            && self.compare_sites(&self.place, &end).is_lt()
            && side(self.arrangement, &self.place, self.arrangement.curve_of(e)).is_eq()
    }

    /// Compares a bar with the point: below, there or above it.
    pub(super) fn compare_with_point(&self, bar: Bar) -> Ordering {
        match bar {
            Bar::Vertex(v) => {
                let site = self.home(v).expect("a vertex on a vertical line is a point");
                self.compare_sites(&site, &self.place)
            }
            Bar::Edge(e) => side(self.arrangement, &self.place, self.arrangement.curve_of(e)).reverse(),
        }
    }

    /// Compares two bars along the line.
    pub(super) fn compare(&self, a: Bar, b: Bar) -> Ordering {
        let curve = |e| self.arrangement.curve_of(e);
        let home = |v| self.home(v).expect("a vertex on a vertical line is a point");
        match (a, b) {
            (Bar::Vertex(v), Bar::Vertex(w)) => self.compare_sites(&home(v), &home(w)),
            (Bar::Vertex(v), Bar::Edge(e)) => side(self.arrangement, &home(v), curve(e)),
            (Bar::Edge(e), Bar::Vertex(v)) => side(self.arrangement, &home(v), curve(e)).reverse(),
            (Bar::Edge(e), Bar::Edge(f)) => {
                // They do not cross: where the later one begins, they are ordered as on the line.
                let [start, other] = [e, f].map(|e| self.ends(e)[0]);
                match self.compare_sites(&start, &other) {
                    Ordering::Less => side(self.arrangement, &other, curve(e)).reverse(),
                    Ordering::Equal => compare_right(self.arrangement, curve(e), curve(f), &start),
                    Ordering::Greater => side(self.arrangement, &start, curve(f)),
                }
            }
        }
    }

    /// Tells whether the line goes on through the bottom and top side.
    pub(super) fn is_round(&self) -> bool {
        self.arrangement.topology().sides().is_v_identified()
    }

    /// The bar that a ray from the point meets first, but for one at the point, if it is among those given.
    pub(super) fn first(&self, bars: impl Iterator<Item = Bar>, ray: VerticalRay) -> Option<Bar> {
        let ahead = match ray {
            VerticalRay::Up => Ordering::Greater,
            VerticalRay::Down => Ordering::Less,
        };
        // What is ahead comes before what is only ahead on the other side.
        let mut first: Option<(bool, Bar)> = None;
        for bar in bars {
            let order = self.compare_with_point(bar);
            if order.is_eq() || (order != ahead && !self.is_round()) {
                continue;
            }
            let is_ahead = order == ahead;
            let is_first = first.is_none_or(|(is_other_ahead, other)| match (is_ahead, is_other_ahead) {
                (true, false) => true,
                (false, true) => false,
                _ => self.is_before(bar, other, ray),
            });
            if is_first {
                first = Some((is_ahead, bar));
            }
        }
        first.map(|(_, bar)| bar)
    }

    /// Tells whether one bar is met before another by a ray that meets both before it comes to a side.
    fn is_before(&self, a: Bar, b: Bar, ray: VerticalRay) -> bool {
        match ray {
            VerticalRay::Up => self.compare(a, b).is_lt(),
            VerticalRay::Down => self.compare(a, b).is_gt(),
        }
    }

    /// The vertical edge along which a ray leaves a vertex.
    pub(super) fn along(&self, v: VertexId, ray: VerticalRay) -> Option<EdgeId> {
        let traits = self.arrangement.traits();
        let is_even = ray == VerticalRay::Up;
        let mut around = self.arrangement.dcel().around(v);
        let leaves = |h: &HalfedgeId| {
            h.is_even() == is_even && traits.is_vertical(self.arrangement.curve_of(h.edge_id()))
        };
        around.find(leaves).map(HalfedgeId::edge_id)
    }

    /// The face straight above or below a cell on the line, or the cell itself if it is a face. An edge is not vertical, and no vertical
    /// edge leaves a vertex there.
    pub(super) fn face_beside(&self, cell: Cell, ray: VerticalRay) -> FaceId {
        let dcel = self.arrangement.dcel();
        match (cell, ray) {
            (Cell::Face(f), _) => f,
            (Cell::Edge(e), VerticalRay::Up) => dcel.face(e.halfedge()),
            (Cell::Edge(e), VerticalRay::Down) => dcel.face(e.halfedge().twin()),
            (Cell::Vertex(v), _) => dcel.isolated_face(v).unwrap_or_else(|| self.face_at_corner(v, ray)),
        }
    }

    /// The face that is straight above or below a vertex with edges.
    fn face_at_corner(&self, v: VertexId, ray: VerticalRay) -> FaceId {
        let dcel = self.arrangement.dcel();
        let rays = dcel.around(v).map(|h| (h, self.arrangement.ray(h)));
        // Counterclockwise from below: the halfedges to the right, straight above, then those to the left.
        let before = rays.max_by(|(g, a), (h, b)| {
            let is_passed = |h: &HalfedgeId| ray == VerticalRay::Up && h.is_even();
            is_passed(g).cmp(&is_passed(h)).then_with(|| self.arrangement.compare_rays(a, b))
        });
        let (before, _) = before.expect("a vertex that is not isolated has a halfedge");
        dcel.face(before)
    }

    /// The face at the bottom side on the line, on which nothing is below the point. Where bottom and top are identified, nothing else is
    /// on the line at all.
    pub(super) fn bottom_face(&self) -> FaceId {
        let dcel = self.arrangement.dcel();
        let location = Location { u: self.place.location.u, v: Along::Low };
        let place = if self.is_round() { Site { location, at: self.place.at } } else { self.place };
        let is_before =
            |site: &Site<'_, G>| site.location == location && self.compare_sites(site, &place).is_lt();
        let rays = dcel.halfedges().map(|h| (h, self.arrangement.start_site(h)));
        let last = rays.filter(|(_, site)| is_before(site)).max_by(|(g, a), (h, b)| {
            // Of those at one vertex the one that is the first on the right, or else the last on the left.
            self.compare_sites(a, b).then_with(|| self.arrangement.compare_around(*h, *g))
        });
        let isolated = dcel.vertices().filter_map(|v| Some((dcel.isolated_face(v)?, self.home(v)?)));
        let isolated =
            isolated.filter(|(_, site)| is_before(site)).max_by(|(_, a), (_, b)| self.compare_sites(a, b));
        match (last, isolated) {
            (Some((_, site)), Some((face, other))) if self.compare_sites(&site, &other).is_lt() => face,
            (None, Some((face, _))) => face,
            // Along the left side, what is behind an end is above it.
            (Some((h, _)), _) if location.u == Along::Low => dcel.face(h),
            (Some((h, _)), _) => dcel.face(h.twin()),
            (None, None) => self.arrangement.corner_face(),
        }
    }

    /// The answer of [`locate`](super::PointLocation::locate), given what is at the point, or else what a ray downwards meets.
    pub(super) fn cell(&self, at: Option<Cell>, below: impl FnOnce() -> Option<Bar>) -> Cell {
        at.unwrap_or_else(|| {
            let face = below().map(|bar| self.face_beside(bar.cell(), VerticalRay::Up));
            Cell::Face(face.unwrap_or_else(|| self.bottom_face()))
        })
    }

    /// The answer of [`shoot`](super::PointLocation::shoot), given the cell of the point, and bars among which are all of the boundary of
    /// the face into which the ray goes.
    pub(super) fn shoot<I: Iterator<Item = Bar>>(
        &self,
        cell: Cell,
        bars: impl FnOnce(FaceId) -> I,
        ray: VerticalRay,
    ) -> Cell {
        let arrangement = self.arrangement;
        if self.at_contraction().is_some() {
            return cell;
        }
        match cell {
            Cell::Edge(e) if arrangement.traits().is_vertical(arrangement.curve_of(e)) => return cell,
            Cell::Vertex(v) => {
                if let Some(e) = self.along(v, ray) {
                    return Cell::Edge(e);
                }
            }
            _ => {}
        }
        let face = self.face_beside(cell, ray);
        if let Some(bar) = self.first(bars(face), ray) {
            return bar.cell();
        }
        if self.is_round() {
            return cell;
        }
        self.beyond(ray).unwrap_or(Cell::Face(face))
    }

    /// The vertex of the contracted side at which a ray ends, if curves end there too.
    pub(super) fn beyond(&self, ray: VerticalRay) -> Option<Cell> {
        let topology = self.arrangement.topology();
        let side = usize::from(ray == VerticalRay::Up);
        let is_contracted = topology.sides().v[side] == SideKind::Contracted;
        let vertex = topology.side_vertices()[2 + side].map(VertexId).filter(|_| is_contracted)?;
        self.arrangement.is_at_contraction(vertex).then_some(Cell::Vertex(vertex))
    }
}
