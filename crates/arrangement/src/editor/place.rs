//! Vertices where curves begin, end and meet.

use super::Editor;
use crate::arrangement::CurveId;
use crate::edit::{Edit, Observer};
use crate::topology::{Site, Topology};
use crate::traits::{CurveEnd, Location, UMonotoneTraits};
use crate::trapezoids::{Found, NewSite, RailId, SiteId, side};
use dcel::VertexId;

/// A vertex, at one of its places.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct At {
    pub(super) v: VertexId,
    pub(super) site: SiteId,
}

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// The vertex that stands for the side on which a place lies, if one does.
    pub(super) fn side_vertex(&self, location: Location) -> Option<VertexId> {
        crate::zone::side_vertex(&self.arrangement, location)
    }

    /// The vertex at an end of a stored curve, made if there is none; an edge on which it lies is split. A new one has no edge, and
    /// is soon to get one.
    pub(super) fn vertex_at_end(&mut self, curve: CurveId, end: CurveEnd, is_artificial: bool) -> At {
        let arrangement = &self.arrangement;
        let the_curve = arrangement.curve(curve);
        let location = arrangement.topology().end_location(arrangement.traits(), the_curve, end);
        if let Some(v) = self.side_vertex(location) {
            let place = Site { location, at: crate::topology::SiteAt::End(the_curve, end) };
            let site = match self.trapezoids.find(arrangement, &place) {
                Found::Site(site) => site,
                Found::Within(t) => {
                    self.trapezoids.add_site(&self.arrangement, NewSite::End(v, curve.0, end), location, t)
                }
            };
            if !is_artificial {
                self.make_ordinary(v);
            }
            return At { v, site };
        }
        let point = arrangement.traits().end_point(the_curve, end).cloned();
        let point = point.expect("a curve has an end point on a side that is no vertex");
        self.vertex_at(&point, location, is_artificial)
    }

    /// The vertex at a point, made if there is none; an edge on which it lies is split. A new one has no edge and is in no face yet.
    pub(super) fn vertex_at(&mut self, point: &G::Point, location: Location, is_artificial: bool) -> At {
        let arrangement = &self.arrangement;
        let home = Site::of_point(arrangement.topology(), arrangement.traits(), point);
        let home_location = home.location;
        let at = match self.trapezoids.find(arrangement, &home) {
            Found::Site(site) => {
                let v = self.trapezoids.vertex(site);
                if !is_artificial {
                    self.make_ordinary(v);
                }
                At { v, site }
            }
            Found::Within(t) => {
                let below = self.trapezoids.trapezoid(t).below;
                let is_on = |rail: RailId| {
                    let curve = self.trapezoids.rail(rail).curve;
                    side(arrangement, &home, &arrangement.curves()[curve as usize]).is_eq()
                };
                if !below.is_none() && is_on(below) {
                    self.split_rail(below, point, home_location, is_artificial)
                } else {
                    let v = self.add_vertex(point, is_artificial);
                    At {
                        v,
                        site: self.trapezoids.add_site(
                            &self.arrangement,
                            NewSite::Vertex(v),
                            home_location,
                            t,
                        ),
                    }
                }
            }
        };
        if location == home_location {
            return at;
        }
        At { v: at.v, site: self.site_at(at.v, point, location) }
    }

    /// The site of a vertex at a place that is not its first one, made if there is none.
    pub(super) fn site_at(&mut self, v: VertexId, point: &G::Point, location: Location) -> SiteId {
        if let Some(site) = self.trapezoids.site_at(v, location) {
            return site;
        }
        let place = Site { location, at: crate::topology::SiteAt::Point(point) };
        match self.trapezoids.find(&self.arrangement, &place) {
            Found::Site(site) => site,
            Found::Within(t) => self.trapezoids.add_site(&self.arrangement, NewSite::Vertex(v), location, t),
        }
    }

    /// Adds a vertex without edges that is in no face.
    fn add_vertex(&mut self, point: &G::Point, is_artificial: bool) -> VertexId {
        let edit = Edit::AddVertex { point: point.clone(), is_artificial };
        self.arrangement.apply(edit, &mut self.observers).vertex()
    }

    /// A curve begins, ends or passes at a vertex: it is not there only because another one was cut.
    pub(super) fn make_ordinary(&mut self, v: VertexId) {
        if self.arrangement.is_artificial[v.index()] {
            self.arrangement.apply(Edit::SetArtificial { v, is_artificial: false }, &mut self.observers);
        }
    }

    /// Splits an edge at a point of its interior. The vertex may be artificial if a curve along the edge is cut there.
    pub(super) fn split_rail(
        &mut self,
        rail: RailId,
        point: &G::Point,
        location: Location,
        is_artificial: bool,
    ) -> At {
        let e = self.trapezoids.rail(rail).edge;
        let v = self.add_vertex(point, is_artificial);
        let (site, rails) = self.trapezoids.add_site_on_rail(&self.arrangement, v, location, rail);
        let edit = Edit::SplitEdge { e, v, kept: CurveEnd::Min };
        let new = self.arrangement.apply(edit, &mut self.observers).edge();
        self.trapezoids.set_edge(rails[0], e);
        self.trapezoids.set_edge(rails[1], new);
        At { v, site }
    }
}
