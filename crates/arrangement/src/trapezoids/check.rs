//! Every broken promise of a decomposition, for tests.

use super::search::side;
use super::{Found, Side, SiteId, Toward, TrapezoidId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;
use std::collections::BTreeMap;

impl<G: BasicTraits> Trapezoids<G> {
    /// Finds what is wrong, as text.
    pub(crate) fn find_faults<T: Topology<G>>(&self, arrangement: &Arrangement<G, T>) -> Vec<String> {
        let mut faults = Vec::new();
        let free: std::collections::HashSet<_> = self.free_trapezoids.iter().copied().collect();
        let all: Vec<TrapezoidId> =
            (0..self.trapezoids.len()).map(TrapezoidId::new).filter(|t| !free.contains(t)).collect();
        for &t in &all {
            self.check_trapezoid(arrangement, t, &mut faults);
        }
        let dcel = arrangement.dcel();
        for e in dcel.edges() {
            let rail = self.rail_of(e);
            if self.rail(rail).edge != e || self.rail(rail).curve != arrangement.support(e).0 {
                faults.push(format!("rail of {e:?}"));
            }
            for side in [Side::Below, Side::Above] {
                if self.along(rail, side).any(|t| self.trapezoid(t).rail(side.opposite()) != rail) {
                    faults.push(format!("{side:?} {e:?}"));
                }
            }
        }
        for v in arrangement.vertices() {
            if self.sites_of(v).next().is_none() {
                faults.push(format!("no site of {v:?}"));
            }
            for site in self.sites_of(v) {
                let place = self.place(arrangement, site);
                if self.search(arrangement, &place, &Toward::Here).0 != Found::Site(site) {
                    faults.push(format!("{site:?} of {v:?} is not found"));
                }
            }
        }
        // Trapezoids that are connected are a face.
        let mut part_of = BTreeMap::new();
        for &t in &all {
            if part_of.contains_key(&t) {
                continue;
            }
            let part = self.part(arrangement, t);
            let face = self.face_of(arrangement, t);
            for other in part {
                if self.face_of(arrangement, other) != face {
                    faults.push(format!("{t:?} and {other:?} are of two faces"));
                }
                part_of.insert(other, t);
            }
        }
        let mut parts_of_face: BTreeMap<_, std::collections::BTreeSet<TrapezoidId>> = BTreeMap::new();
        for (&t, &part) in &part_of {
            if self.is_real(arrangement, t) {
                parts_of_face.entry(self.face_of(arrangement, t)).or_default().insert(part);
            }
        }
        for f in dcel.faces() {
            match parts_of_face.get(&f).map_or(0, |parts| parts.len()) {
                1 => {}
                n => faults.push(format!("{f:?} has {n} parts")),
            }
        }
        faults
    }

    /// Tells whether a trapezoid is more than a piece of a side.
    fn is_real<T: Topology<G>>(&self, _: &Arrangement<G, T>, t: TrapezoidId) -> bool {
        use crate::traits::Along;
        let Self { .. } = self;
        let trapezoid = self.trapezoid(t);
        let is_at = |site: SiteId, along| !site.is_none() && self.location(site).u == along;
        !is_at(trapezoid.right, Along::Low) && !is_at(trapezoid.left, Along::High)
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
                if order
                    != if s == Side::Below { std::cmp::Ordering::Greater } else { std::cmp::Ordering::Less }
                {
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
