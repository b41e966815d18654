//! Every broken promise of a decomposition, for tests.

use super::faces::Visits;
use super::search::side;
use super::structure::Branch;
use super::{Found, RailId, Side, SiteId, SiteKind, Toward, TrapezoidId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::{Site, Topology};
use crate::traits::{Along, BasicTraits};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

impl<G: BasicTraits> Trapezoids<G> {
    /// Finds what is wrong, as text.
    pub(crate) fn find_faults<T: Topology<G>>(&self, arrangement: &Arrangement<G, T>) -> Vec<String> {
        let mut faults = self.find_faults_of_places(arrangement);
        self.check_cells(arrangement, &mut faults);
        self.check_faces(arrangement, &mut faults);
        faults
    }

    /// Finds what is wrong with trapezoids, sites, rails and searches, whatever edges and faces the arrangement has.
    pub(crate) fn find_faults_of_places<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
    ) -> Vec<String> {
        let mut faults = Vec::new();
        for t in self.all_trapezoids() {
            self.check_trapezoid(arrangement, t, &mut faults);
        }
        let rails: Vec<RailId> = (0..self.rails.len())
            .map(RailId::new)
            .filter(|&rail| !self.rail(rail).ends[0].is_none())
            .collect();
        for &rail in &rails {
            for side in [Side::Below, Side::Above] {
                if self.along(rail, side).any(|t| self.trapezoid(t).rail(side.opposite()) != rail) {
                    faults.push(format!("what is {side:?} {rail:?}"));
                }
            }
        }
        let sites: Vec<SiteId> =
            (0..self.sites.len()).map(SiteId::new).filter(|&site| !self.is_gone(site)).collect();
        for &site in &sites {
            self.check_site(arrangement, site, &mut faults);
        }
        // Each site in a trapezoid cuts it in two, as does each rail; a site on a rail cuts two, and the rail.
        if self.count() != 1 + sites.len() + rails.len() {
            let [sites, rails] = [sites.len(), rails.len()];
            faults.push(format!("{} trapezoids of {sites} sites and {rails} rails", self.count()));
        }
        faults
    }

    /// Checks that a search lands in a trapezoid that has the place in it, or finds the site there.
    pub(crate) fn check_search<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        place: &Site<'_, G>,
        toward: &Toward<'_, G>,
        faults: &mut Vec<String>,
    ) {
        let (traits, topology) = (arrangement.traits(), arrangement.topology());
        let compare = |site| topology.compare_sites(traits, &self.place(arrangement, site), place);
        let is_here = matches!(toward, Toward::Here);
        let t = match self.search(arrangement, place, toward).0 {
            Found::Site(site) => {
                if !is_here || self.is_gone(site) || compare(site).is_ne() {
                    faults.push(format!("{site:?} found at a place {:?}", place.location));
                }
                return;
            }
            Found::Within(t) => t,
        };
        let trapezoid = self.trapezoid(t);
        let fault = |what: &str| format!("{t:?} found at a place {:?}: {what}", place.location);
        if self.trapezoid(t).became != Branch::NONE {
            faults.push(fault("it is no more"));
        }
        if !trapezoid.left.is_none() {
            let order = compare(trapezoid.left);
            if order.is_gt() || (is_here && order.is_eq()) {
                faults.push(fault("it is behind the place"));
            }
        }
        if !trapezoid.right.is_none() && compare(trapezoid.right).is_le() {
            faults.push(fault("it is before the place"));
        }
        for s in [Side::Below, Side::Above] {
            if trapezoid.rail(s).is_none() {
                continue;
            }
            let curve = &arrangement.curves()[self.rail(trapezoid.rail(s)).curve as usize];
            let order = side(arrangement, place, curve).then_with(|| match toward {
                Toward::Here => Ordering::Greater,
                Toward::Straight(side) => side.order(),
                Toward::Right(other, side) => {
                    let right = |p| traits.compare_v_at_u_right(other, curve, p);
                    place.point().map_or(Ordering::Equal, right).then(side.order())
                }
            });
            if order != s.opposite().order() {
                faults.push(fault("it is beyond a rail"));
            }
        }
    }

    /// Edges have their rails, from vertex to vertex, and vertices their sites.
    fn check_cells<T: Topology<G>>(&self, arrangement: &Arrangement<G, T>, faults: &mut Vec<String>) {
        for e in arrangement.dcel().edges() {
            let rail = self.rail_of(e);
            if self.rail(rail).edge != e || self.rail(rail).curve != arrangement.support(e).0 {
                faults.push(format!("rail of {e:?}"));
            }
            let ends = self.rail(rail).ends.map(|site| self.vertex(site));
            if ends != arrangement.dcel().ends(e) {
                faults.push(format!("the rail of {e:?} ends at {ends:?}"));
            }
        }
        for v in arrangement.vertices() {
            // At a pole the ends of edges have sites, each its own.
            if !arrangement.stands_for_side(v) && self.sites_of(v).next().is_none() {
                faults.push(format!("no site of {v:?}"));
            }
        }
    }

    /// Trapezoids that are connected are a face.
    fn check_faces<T: Topology<G>>(&self, arrangement: &Arrangement<G, T>, faults: &mut Vec<String>) {
        let mut visits = Visits::default();
        let mut part_of = BTreeMap::new();
        for t in self.all_trapezoids() {
            if part_of.contains_key(&t) {
                continue;
            }
            self.visit(arrangement, t, &mut visits);
            let face = self.face_of(arrangement, t);
            for &other in &visits.found[0] {
                if self.face_of(arrangement, other) != face {
                    faults.push(format!("{t:?} and {other:?} are of two faces"));
                }
                if part_of.insert(other, t).is_some() {
                    faults.push(format!("one may step from {t:?} to {other:?}, and not back"));
                }
            }
        }
        let mut parts_of_face: BTreeMap<_, BTreeSet<TrapezoidId>> = BTreeMap::new();
        for (&t, &part) in &part_of {
            if self.is_on_surface(t) {
                parts_of_face.entry(self.face_of(arrangement, t)).or_default().insert(part);
            }
        }
        for f in arrangement.dcel().faces() {
            match parts_of_face.get(&f).map_or(0, BTreeSet::len) {
                1 => {}
                n => faults.push(format!("{f:?} has {n} parts")),
            }
        }
    }

    /// Tells whether a trapezoid is more than a piece of the left or right side.
    fn is_on_surface(&self, t: TrapezoidId) -> bool {
        let trapezoid = self.trapezoid(t);
        let is_at = |site: SiteId, along| !site.is_none() && self.location(site).u == along;
        !is_at(trapezoid.right, Along::Low) && !is_at(trapezoid.left, Along::High)
    }

    fn all_trapezoids(&self) -> impl Iterator<Item = TrapezoidId> + '_ {
        (0..self.trapezoids.len()).map(TrapezoidId::new).filter(|&t| self.trapezoid(t).became == Branch::NONE)
    }

    /// The trapezoids at a site know it, and a search finds it.
    fn check_site<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        site: SiteId,
        faults: &mut Vec<String>,
    ) {
        let [left, right] = [self.left_of(site), self.right_of(site)];
        if left.iter().any(|&t| self.trapezoid(t).right != site)
            || right.iter().any(|&t| self.trapezoid(t).left != site)
        {
            faults.push(format!("{site:?} is not known by trapezoids next to it"));
        }
        let place = self.place(arrangement, site);
        let found = self.search(arrangement, &place, &Toward::Here).0;
        if found != Found::Site(site) {
            faults.push(format!("{site:?} is not found, but {found:?}"));
        }
        if self.sites[site.index()].kind == SiteKind::Vertex
            && !self.sites_of(self.vertex(site)).any(|other| other == site)
        {
            faults.push(format!("{site:?} is not known by its vertex"));
        }
    }

    fn check_trapezoid<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        t: TrapezoidId,
        faults: &mut Vec<String>,
    ) {
        let trapezoid = self.trapezoid(t);
        let compare = |p, q| {
            let [p, q] = [p, q].map(|site| self.place(arrangement, site));
            arrangement.topology().compare_sites(arrangement.traits(), &p, &q)
        };
        let [left, right] = [trapezoid.left, trapezoid.right];
        if !left.is_none() && !right.is_none() && !compare(left, right).is_lt() {
            faults.push(format!("{t:?} is turned round"));
        }
        for s in [Side::Below, Side::Above] {
            let rail = trapezoid.rail(s);
            if rail.is_none() {
                continue;
            }
            let rail = self.rail(rail);
            let curve = &arrangement.curves()[rail.curve as usize];
            for site in [left, right] {
                if site.is_none() {
                    faults.push(format!("{t:?} reaches the side beyond a rail"));
                    continue;
                }
                if !compare(rail.ends[0], site).is_le() || !compare(site, rail.ends[1]).is_le() {
                    faults.push(format!("{t:?} reaches beyond its rail {s:?}"));
                    continue;
                }
                if rail.ends.contains(&site) {
                    continue;
                }
                let order = side(arrangement, &self.place(arrangement, site), curve);
                if order != s.opposite().order() {
                    faults.push(format!("{t:?} has a site on the wrong side of its rail {s:?}"));
                }
            }
        }
        let touches = |traps: [TrapezoidId; 2], site: SiteId, is_start: bool| {
            traps.contains(&t)
                || [trapezoid.below, trapezoid.above]
                    .into_iter()
                    .all(|rail| !rail.is_none() && self.rail(rail).ends[usize::from(!is_start)] == site)
        };
        if !left.is_none() && !touches(self.right_of(left), left, true) {
            faults.push(format!("{t:?} is not known at its left site"));
        }
        if !right.is_none() && !touches(self.left_of(right), right, false) {
            faults.push(format!("{t:?} is not known at its right site"));
        }
    }
}
