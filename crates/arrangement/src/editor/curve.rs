//! A curve comes, wherever it runs.

use super::Editor;
use super::place::At;
use crate::arrangement::{CurveId, assemble::covers};
use crate::edit::{Edit, Observer, Operation};
use crate::topology::{Site, Topology};
use crate::traits::{ArrangementTraits, CurveEnd, Intersection, Location, Piece, UMonotoneTraits};
use crate::trapezoids::{SiteId, TrapezoidId};
use crate::zone::{self, Hit, On, Walk, next};
use dcel::{EdgeId, VertexId};

/// What to do next with a curve.
pub(super) enum Next<P> {
    /// It runs along an edge to its end, or to a point of its interior.
    Along(EdgeId, Option<P>),
    /// It runs through a face from a trapezoid on.
    Through(TrapezoidId, Hit<P>),
}

impl<G: ArrangementTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Inserts a general curve, and gives the edges that run along it: piece by piece as [`ArrangementTraits::make_u_monotone`] gives them,
    /// each from its min to its max end.
    ///
    /// Edges that it crosses are split; the part at the min end keeps the id.
    ///
    /// Degenerate: an edge along which several pieces of the curve run comes several times. If a piece crosses one that came before it, the
    /// edge of that is named as it was when it came: of its two parts, only the one that kept the id is among the answer. Isolated
    /// points of the curve become vertices, and are not in the answer. [`ArrangementWithHistory`](crate::history::ArrangementWithHistory)
    /// knows all edges of a curve at any time.
    ///
    /// # Complexity
    /// For each edge, vertex and face that the curve meets, expected O(log n) if curves come in random order, and what the splitting of
    /// faces costs: see [`Editor`]. Through a face, linear in the trapezoids on the way, as for [`Editor::zone`]: a long curve that passes
    /// above or below many small holes meets as many walls.
    ///
    /// # References
    /// Thesis, section 2.4.3.
    pub fn insert_curve(&mut self, curve: &G::Curve) -> Vec<EdgeId> {
        let mut pieces = Vec::new();
        self.arrangement.traits().make_u_monotone(curve, &mut pieces);
        self.operate(Operation::InsertCurve, |editor| {
            let mut edges = Vec::new();
            for piece in pieces {
                match piece {
                    Piece::Curve { curve, is_artificial } => editor.run(curve, is_artificial, &mut edges),
                    Piece::Point(point) => {
                        editor.add_point(&point);
                    }
                }
            }
            edges
        })
    }
}

impl<G: UMonotoneTraits, T: Topology<G>, O: Observer<G, T>> Editor<G, T, O> {
    /// Inserts a u-monotone curve, and appends the edges that run along it, as they are when they are made.
    pub(super) fn run(
        &mut self,
        curve: G::UMonotoneCurve,
        is_artificial: [bool; 2],
        edges: &mut Vec<EdgeId>,
    ) {
        let edit = Edit::AddCurve { curve };
        let id = self.arrangement.apply(edit, &mut self.observers).curve();
        let mut at = self.vertex_at_end(id, CurveEnd::Min, is_artificial[0]);
        loop {
            let (next, is_end) = match self.next_of(id, at.site) {
                Next::Along(e, until) => {
                    let next = self.run_along(e, until, is_artificial[1], edges);
                    let is_end = self.is_end(id, next.site);
                    self.share_support(edges[edges.len() - 1], id);
                    (next, is_end)
                }
                Next::Through(first, hit) => {
                    let (next, is_end) = match hit {
                        Hit::Site { site, is_end } => (self.vertex_of(site), is_end),
                        Hit::Edge { rail, point } => {
                            (self.split_rail(rail, &point, Location::INTERIOR, false), false)
                        }
                        Hit::End { .. } => (self.vertex_at_end(id, CurveEnd::Max, is_artificial[1]), true),
                    };
                    edges.push(self.insert_edge(id, [at, next], first));
                    (next, is_end)
                }
            };
            self.make_ordinary_if_shared(at.v);
            at = next;
            if is_end {
                break;
            }
        }
        self.make_ordinary_if_shared(at.v);
        if !is_artificial[1] {
            self.make_ordinary(at.v);
        }
    }

    /// Where a curve was cut and others are cut too or pass, something happens; but not if they run along both edges there.
    fn make_ordinary_if_shared(&mut self, v: VertexId) {
        if self.arrangement.dcel().around(v).nth(2).is_some() {
            self.make_ordinary(v);
        }
    }

    /// The vertex of a site to which a curve has come.
    fn vertex_of(&self, site: SiteId) -> At {
        At { v: self.trapezoids.vertex(site), site }
    }

    fn is_end(&self, curve: CurveId, site: SiteId) -> bool {
        let arrangement = &self.arrangement;
        let (traits, topology) = (arrangement.traits(), arrangement.topology());
        let end = Site::of_end(topology, traits, arrangement.curve(curve), CurveEnd::Max);
        topology.compare_sites(traits, &self.trapezoids.place(arrangement, site), &end).is_eq()
    }

    /// Looks where a curve goes from a site on it.
    fn next_of(&mut self, id: CurveId, site: SiteId) -> Next<G::Point> {
        let first = self.first_of(id, site);
        self.next_from(id, site, first)
    }

    /// The trapezoid through which a curve goes from a site on it: the one above, if it runs along an edge.
    pub(super) fn first_of(&mut self, id: CurveId, site: SiteId) -> TrapezoidId {
        self.trapezoids.first_of(&self.arrangement, site, self.arrangement.curve(id))
    }

    /// Looks where a curve goes from a site on it through a trapezoid.
    pub(super) fn next_from(&self, id: CurveId, site: SiteId, first: TrapezoidId) -> Next<G::Point> {
        let arrangement = &self.arrangement;
        let curve = arrangement.curve(id);
        let place = self.trapezoids.place(arrangement, site);
        match next(arrangement, &self.trapezoids, curve, (&place, On::Site(site)), first) {
            zone::Next::Along(rail, until) => Next::Along(self.trapezoids.rail(rail).edge, until),
            zone::Next::Through => {
                let hit = Walk::new(arrangement, &self.trapezoids, curve, &place, first).run();
                Next::Through(first, hit)
            }
        }
    }

    /// Goes along an edge, which is split where the curve leaves it or ends; then the vertex may be artificial.
    fn run_along(
        &mut self,
        e: EdgeId,
        until: Option<G::Point>,
        is_artificial: bool,
        edges: &mut Vec<EdgeId>,
    ) -> At {
        edges.push(e);
        let rail = self.trapezoids.rail_of(e);
        match until {
            Some(point) => {
                let arrangement = &self.arrangement;
                let location = arrangement.topology().point_location(arrangement.traits(), &point);
                self.split_rail(rail, &point, location, is_artificial)
            }
            None => {
                let site = self.trapezoids.rail(rail).ends[1];
                At { v: self.arrangement.dcel().ends(e)[1], site }
            }
        }
    }

    /// Where another curve runs along an edge too, the edge gets what they have in common as its support, if that matters.
    fn share_support(&mut self, e: EdgeId, curve: CurveId) {
        if G::OVERLAPS_ARE_PLAIN {
            return;
        }
        let arrangement = &self.arrangement;
        let traits = arrangement.traits();
        let mut common = Vec::new();
        traits.intersect(arrangement.curve_of(e), arrangement.curve(curve), &mut common);
        let overlaps = common.into_iter().filter_map(|intersection| match intersection {
            Intersection::Overlap(overlap) => Some(overlap),
            Intersection::Point(..) => None,
        });
        let overlap = overlaps.into_iter().find(|overlap| {
            let ends = arrangement.dcel().ends(e).map(|v| arrangement.inner_point(v));
            covers(traits, arrangement.topology(), overlap, ends)
        });
        // They overlap along the edge, because the curve was found to.
        if let Some(overlap) = overlap {
            let edit = Edit::AddCurve { curve: overlap };
            let curve = self.arrangement.apply(edit, &mut self.observers).curve();
            self.arrangement.apply(Edit::SetSupport { e, curve }, &mut self.observers);
            self.trapezoids.set_curve(e, curve.0);
        }
    }
}
