//! Vertices and edges go.

use super::structure::Branch;
use super::{RailId, Side, SiteId, SiteKind, Trapezoid, TrapezoidId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;
use dcel::VertexId;

impl<G: BasicTraits> Trapezoids<G> {
    /// Removes a rail. The sites at its ends stay.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids on both sides.
    pub(crate) fn remove_rail<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, rail: RailId) {
        let [a, b] = self.rail(rail).ends;
        // On each side the old trapezoid that is walked along, and the first of the new ones in it.
        let mut old = self.rail(rail).first;
        let mut first_in = [0; 2];
        let mut new = Vec::new();
        let mut left = a;
        // What lies to the right of the last wall, and is to be replaced.
        let mut behind_wall = old.to_vec();
        loop {
            let [below, above] = old.map(|t| self.trapezoids[t.index()]);
            let joined = Trapezoid { left, right: b, below: below.below, ..above };
            let t = self.new_trapezoid(joined);
            self.note_first(t, Side::Below, left);
            self.note_first(t, Side::Above, left);
            new.push(t);
            for old in behind_wall.drain(..) {
                self.replace_right_of(left, old, t);
            }
            let rights = [below.right, above.right];
            let i = match rights.map(|right| right == b) {
                [true, true] => break,
                [true, false] => 1,
                [false, true] => 0,
                [false, false] => {
                    let [p, q] = rights.map(|right| self.place(arrangement, right));
                    let order = arrangement.topology().compare_sites(arrangement.traits(), &p, &q);
                    usize::from(order.is_gt())
                }
            };
            // Here a wall ended at the rail, and reaches on now.
            let site = rights[i];
            let after = self.sites[site.index()].right[1 - i];
            self.trapezoids[t.index()].right = site;
            self.replace_left_of(site, old[i], t);
            self.divide(arrangement, old[i], &new[first_in[i]..]);
            behind_wall.push(after);
            (old[i], first_in[i], left) = (after, new.len(), site);
        }
        for i in [0, 1] {
            self.replace_left_of(b, old[i], new[new.len() - 1]);
            self.divide(arrangement, old[i], &new[first_in[i]..]);
        }
        self.free_rail(rail);
    }

    /// Removes a site at which no edge begins or ends.
    pub(crate) fn remove_site<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, site: SiteId) {
        let SiteId(_) = site;
        let record = self.sites[site.index()];
        self.join_at_wall(record.left[0], record.right[0]);
        self.forget(arrangement, site);
    }

    /// Removes a site between two edges, which become one: gives its rail, which is to get its edge and curve.
    pub(crate) fn remove_site_on_rail<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        site: SiteId,
    ) -> RailId {
        let rail = self.join_rails(site);
        let record = self.sites[site.index()];
        for (l, r) in record.left.into_iter().zip(record.right) {
            self.join_at_wall(l, r);
        }
        self.forget(arrangement, site);
        rail
    }

    /// Takes away the wall between two trapezoids.
    fn join_at_wall(&mut self, l: TrapezoidId, r: TrapezoidId) {
        let Trapezoid { right, .. } = self.trapezoids[r.index()];
        self.trapezoids[l.index()].right = right;
        self.replace_left_of(right, r, l);
        self.end_trapezoid(r, Branch::leaf(l));
    }

    /// Only the search structure knows the site from now on.
    fn forget<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, site: SiteId) {
        let record = self.sites[site.index()];
        match record.kind {
            SiteKind::Vertex => {
                let v = record.vertex;
                let point =
                    arrangement.inner_point(v).expect("a vertex with sites by its name is a point").clone();
                let record = &mut self.sites[site.index()];
                record.kind = SiteKind::Gone;
                record.at = u32::try_from(self.gone.len()).expect("an arrangement has fewer than 2^32 cells");
                self.gone.push(point);
                self.unlink(v, site);
            }
            SiteKind::End(end) => {
                self.remove_end(arrangement, site);
                self.sites[site.index()].kind = SiteKind::GoneEnd(end);
            }
            SiteKind::Gone | SiteKind::GoneEnd(_) => {}
        }
    }

    /// Takes a site out of the list of its vertex.
    fn unlink(&mut self, v: VertexId, site: SiteId) {
        let next = self.sites[site.index()].next;
        if self.first_site[v.index()] == site {
            self.first_site[v.index()] = next;
            return;
        }
        let before = self.sites_of(v).find(|&other| self.sites[other.index()].next == site);
        if let Some(before) = before {
            self.sites[before.index()].next = next;
        }
    }

    /// A trapezoid is no more: others are there now, from left to right.
    fn divide<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        old: TrapezoidId,
        new: &[TrapezoidId],
    ) {
        let root = self.tree(arrangement, new);
        self.end_trapezoid(old, root);
    }

    /// A balanced tree of the walls between trapezoids.
    fn tree<T: Topology<G>>(&mut self, arrangement: &Arrangement<G, T>, new: &[TrapezoidId]) -> Branch {
        if let [single] = new {
            return Branch::leaf(*single);
        }
        let (left, right) = new.split_at(new.len() / 2);
        let site = self.trapezoids[right[0].index()].left;
        let node = self.structure.add_node(self.split_at(arrangement, site, [Branch::NONE; 2]));
        let branches = [left, right].map(|new| self.tree(arrangement, new));
        self.structure.set_branches(node, branches);
        node
    }
}
