//! Following edits that others make: those of an arrangement that go through its one place for changes.

use super::{Rail, SiteId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::edit::{Done, Edit, EditOf, Observer};
use crate::topology::Topology;
use crate::traits::{CurveEnd, UMonotoneTraits};
use dcel::{EdgeId, EndFate, VertexId};

/// Keeps a decomposition up to date with an arrangement that somebody else edits.
///
/// Every edge that comes is looked for: whoever knows where it is does better.
#[derive(Debug)]
pub(crate) struct Follower<'a, G: UMonotoneTraits>(pub(crate) &'a mut Trapezoids<G>);

impl<G: UMonotoneTraits, T: Topology<G>> Observer<G, T> for Follower<'_, G> {
    fn before(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>) {
        match *edit {
            Edit::RemoveEdge { e, ends, .. } => self.0.remove_edge(arrangement, e, ends),
            Edit::RemoveIsolatedVertex { v } => self.0.remove_sites_of(arrangement, v),
            Edit::MergeEdges { kept, v } => self.0.merge_edges(arrangement, kept, v),
            _ => {}
        }
    }

    fn after(&mut self, arrangement: &Arrangement<G, T>, edit: &EditOf<G>, done: &Done) {
        match (edit, *done) {
            (&Edit::SplitEdge { e, v, kept }, Done::Edge(new)) => {
                let parts = if kept == CurveEnd::Min { [e, new] } else { [new, e] };
                self.0.split_edge(arrangement, e, v, parts);
            }
            (_, Done::Edge(e)) => self.0.add_edge(arrangement, e),
            (Edit::AddIsolatedVertex { .. }, Done::Vertex(v)) => self.0.add_home(arrangement, v),
            (&Edit::SetSupport { e, curve }, _) => self.0.set_curve(e, curve.0),
            _ => {}
        }
    }

    fn after_global(&mut self, arrangement: &Arrangement<G, T>) {
        *self.0 = Trapezoids::of(arrangement);
    }
}

impl<G: UMonotoneTraits> Trapezoids<G> {
    /// Removes the rail of an edge that is going to be removed, and the sites that nobody needs then; `fates` says what becomes of its
    /// ends if they have no other edge. Vertices without a point stay in any case.
    pub(crate) fn remove_edge<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        e: EdgeId,
        fates: [EndFate; 2],
    ) {
        let rail = self.rail_of(e);
        let sites = self.rail(rail).ends;
        self.remove_rail(arrangement, rail);
        for site in sites {
            self.remove_site_if_empty(arrangement, site);
        }
        for (v, fate) in arrangement.dcel().ends(e).into_iter().zip(fates) {
            let is_last = || arrangement.dcel().around(v).all(|h| h.edge_id() == e);
            if fate == EndFate::Remove && is_last() {
                self.remove_sites_of(arrangement, v);
            }
        }
    }

    /// Removes the site where an edge ended, if it is there for edges only and no other one has it: the end of a curve on a side, or a
    /// place of a vertex that is not its first one.
    fn remove_site_if_empty<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, site: SiteId) {
        let is_empty = [self.left_of(site), self.right_of(site)].iter().all(|[below, above]| below == above);
        let point = arrangement.inner_point(self.vertex(site));
        let is_home = point.is_some_and(|point| {
            arrangement.topology().point_location(arrangement.traits(), point) == self.location(site)
        });
        if is_empty && !is_home && !self.is_gone(site) {
            self.remove_site(arrangement, site);
        }
    }

    /// Removes all sites of a vertex that has no edges, or is to have none.
    pub(crate) fn remove_sites_of<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, v: VertexId) {
        let sites: Vec<SiteId> = self.sites_of(v).collect();
        for site in sites {
            self.remove_site(arrangement, site);
        }
    }

    /// Joins the rails of two edges that are going to be merged at a vertex.
    pub(crate) fn merge_edges<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        kept: EdgeId,
        v: VertexId,
    ) {
        let [min, _] = arrangement.dcel().ends(kept);
        let Rail { ends: [first, last], curve, .. } = *self.rail(self.rail_of(kept));
        let site = if min == v { first } else { last };
        let others: Vec<SiteId> = self.sites_of(v).filter(|&other| other != site).collect();
        for other in others {
            self.remove_site(arrangement, other);
        }
        let rail = self.remove_site_on_rail(arrangement, site);
        self.set_edge(rail, kept);
        self.rails[rail.index()].curve = curve;
    }

    /// Splits the rail of an edge that was split at a vertex.
    fn split_edge<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        e: EdgeId,
        v: VertexId,
        parts: [EdgeId; 2],
    ) {
        let point = arrangement.inner_point(v).expect("an edge is split at a point");
        let location = arrangement.topology().point_location(arrangement.traits(), point);
        let (_, rails) = self.add_site_on_rail(arrangement, v, location, self.rail_of(e));
        for (rail, part) in rails.into_iter().zip(parts) {
            self.set_edge(rail, part);
        }
    }
}
