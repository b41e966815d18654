//! Vertices and edges come.

use super::search::side;
use super::structure::{Branch, Node};
use super::{Rail, RailId, Side, SiteId, SiteKind, SiteRecord, Trapezoid, TrapezoidId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::{BasicTraits, CurveEnd, Location};
use dcel::VertexId;

/// What a new site is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum NewSite {
    /// A place of a vertex that is a point.
    Vertex(VertexId),
    /// The end of a curve on a side for which the vertex stands.
    End(VertexId, u32, CurveEnd),
}

/// A rail that came, and the trapezoids below and above it where it begins and where it ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NewRail {
    pub(crate) rail: RailId,
    pub(crate) first: [TrapezoidId; 2],
    pub(crate) last: [TrapezoidId; 2],
}

impl<G: BasicTraits> Trapezoids<G> {
    /// Adds a site in the interior of a trapezoid.
    pub(crate) fn add_site<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        at: NewSite,
        location: Location,
        t: TrapezoidId,
    ) -> SiteId {
        let site = self.new_site(arrangement, at, location);
        if let NewSite::End(..) = at {
            self.add_end(arrangement, site);
        }
        let [l, r] = self.split_by_wall(arrangement, t, site);
        let record = &mut self.sites[site.index()];
        record.left = [l; 2];
        record.right = [r; 2];
        site
    }

    /// Adds a site on a rail, in the interior of the edge; finds the trapezoids there.
    ///
    /// Gives the site, and the rails of the two parts, of which one is the old one: both belong to the old edge still.
    pub(crate) fn add_site_on_rail<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        v: VertexId,
        location: Location,
        rail: RailId,
    ) -> (SiteId, [RailId; 2]) {
        let site = self.new_site(arrangement, NewSite::Vertex(v), location);
        let traps = [Side::Below, Side::Above].map(|side| self.beside(arrangement, rail, side, site));
        debug_assert_eq!(self.trapezoid(traps[0]).above, rail, "the site is on the rail");
        debug_assert_eq!(self.trapezoid(traps[1]).below, rail, "the site is on the rail");
        let [[bl, br], [al, ar]] = traps.map(|t| self.split_by_wall(arrangement, t, site));
        let record = &mut self.sites[site.index()];
        record.left = [bl, al];
        record.right = [br, ar];
        (site, self.split_rail(rail, site))
    }

    fn new_site<T: Topology<G>>(&mut self, _: &Arrangement<G, T>, at: NewSite, location: Location) -> SiteId {
        let site = SiteId::new(self.sites.len());
        let none = [TrapezoidId::NONE; 2];
        let (vertex, at, kind) = match at {
            NewSite::Vertex(v) => (v, u32::MAX, SiteKind::Vertex),
            NewSite::End(v, curve, end) => (v, curve, SiteKind::End(end)),
        };
        let mut next = SiteId::NONE;
        if kind == SiteKind::Vertex {
            if vertex.index() >= self.first_site.len() {
                self.first_site.resize(vertex.index() + 1, SiteId::NONE);
            }
            next = std::mem::replace(&mut self.first_site[vertex.index()], site);
        }
        let record = SiteRecord { left: none, right: none, at, vertex, kind, location, next };
        self.sites.push(record);
        site
    }

    /// Cuts a trapezoid by the wall of a site in it, or by one of the walls of a site on its boundary.
    fn split_by_wall<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        t: TrapezoidId,
        site: SiteId,
    ) -> [TrapezoidId; 2] {
        let old = self.trapezoids[t.index()];
        let l = self.new_trapezoid(Trapezoid { right: site, ..old });
        let r = self.new_trapezoid(Trapezoid { left: site, ..old });
        self.replace_right_of(old.left, t, l);
        self.replace_left_of(old.right, t, r);
        for side in [Side::Below, Side::Above] {
            self.note_first(l, side, old.left);
        }
        let node = self.split_at(arrangement, site, [l, r].map(Branch::leaf));
        let node = self.structure.add_node(node);
        self.end_trapezoid(t, node);
        [l, r]
    }

    /// The trapezoid `old` to the left of a site is `new` now.
    #[inline]
    pub(super) fn replace_left_of(&mut self, site: SiteId, old: TrapezoidId, new: TrapezoidId) {
        if !site.is_none() {
            for t in self.sites[site.index()].left.iter_mut().filter(|t| **t == old) {
                *t = new;
            }
        }
    }

    /// The trapezoid `old` to the right of a site is `new` now.
    #[inline]
    pub(super) fn replace_right_of(&mut self, site: SiteId, old: TrapezoidId, new: TrapezoidId) {
        if !site.is_none() {
            for t in self.sites[site.index()].right.iter_mut().filter(|t| **t == old) {
                *t = new;
            }
        }
    }

    /// Adds a rail from one site to another along a curve, on which between them no site and no rail is. `first` is the trapezoid in
    /// which it begins.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids through which it runs.
    pub(crate) fn insert_rail<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        curve: u32,
        ends: [SiteId; 2],
        first: TrapezoidId,
    ) -> NewRail {
        let rail = self.new_rail(Rail { curve, ends, ..Rail::FREE });
        let [a, b] = ends;
        let the_curve = &arrangement.curves()[curve as usize];
        let key = arrangement.traits().side_key(the_curve);
        let mut t = first;
        let mut old = self.trapezoids[t.index()];
        let mut parts = [Side::Below, Side::Above].map(|part| self.new_part(&old, part, rail, a));
        let first_parts = parts;
        self.rails[rail.index()].first = parts;
        for (right, part) in self.sites[a.index()].right.iter_mut().zip(parts) {
            if *right == t {
                *right = part;
            }
        }
        loop {
            let node = self.structure.add_node(Node::curve(curve, key, parts.map(Branch::leaf)));
            self.end_trapezoid(t, node);
            let r = old.right;
            if r == b || r.is_none() {
                debug_assert!(r == b, "a rail ends at a site");
                break;
            }
            // The wall that is cut off is the one on the side of the curve on which the site lies not.
            let order = side(arrangement, &self.place(arrangement, r), the_curve);
            debug_assert!(order.is_ne(), "no site is on a new rail");
            let (part, wall) = if order.is_gt() { (Side::Above, 0) } else { (Side::Below, 1) };
            let next = self.sites[r.index()].right[wall];
            let i = part as usize;
            self.trapezoids[parts[i].index()].right = r;
            self.replace_left_of(r, t, parts[i]);
            t = next;
            old = self.trapezoids[t.index()];
            parts[i] = self.new_part(&old, part, rail, r);
            self.replace_right_of(r, t, parts[i]);
        }
        for part in parts {
            self.trapezoids[part.index()].right = b;
        }
        for (left, part) in self.sites[b.index()].left.iter_mut().zip(parts) {
            if *left == t {
                *left = part;
            }
        }
        NewRail { rail, first: first_parts, last: parts }
    }

    /// The part of a trapezoid below or above a rail, to the right of a site.
    fn new_part(&mut self, old: &Trapezoid, part: Side, rail: RailId, left: SiteId) -> TrapezoidId {
        let mut trapezoid = Trapezoid { left, right: SiteId::NONE, ..*old };
        *trapezoid.rail_mut(part.opposite()) = rail;
        let t = self.new_trapezoid(trapezoid);
        self.note_first(t, part, left);
        t
    }

    /// Tells the rail on one side of a trapezoid if that is the first one along it.
    #[inline]
    pub(super) fn note_first(&mut self, t: TrapezoidId, side: Side, left: SiteId) {
        let rail = self.trapezoids[t.index()].rail(side);
        if !rail.is_none() {
            let rail = &mut self.rails[rail.index()];
            if rail.ends[0] == left {
                rail.first[side.opposite() as usize] = t;
            }
        }
    }
}
