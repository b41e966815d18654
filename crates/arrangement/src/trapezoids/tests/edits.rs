//! Rails and sites go and come back in random order, while the arrangement stays as it is.
//!
//! A rail may cover several edges of a curve one after the other: then there are no sites between them.

use super::super::insert::NewSite;
use super::*;
use dcel::HalfedgeId;

struct Edits<'a, G: BasicTraits, T> {
    arrangement: &'a Arrangement<G, T>,
    trapezoids: Trapezoids<G>,
    edges: Vec<EdgeId>,
    /// For each edge, the one behind it on its curve, and the rail that covers it.
    next: Vec<Option<EdgeId>>,
    rails: Vec<Option<RailId>>,
}

impl<'a, G: UMonotoneTraits, T: Topology<G>> Edits<'a, G, T> {
    fn new(arrangement: &'a Arrangement<G, T>) -> Self {
        let dcel = arrangement.dcel();
        let trapezoids = Trapezoids::of(arrangement);
        let edges: Vec<EdgeId> = dcel.edges().collect();
        let next = edges.iter().map(|&e| {
            let end = arrangement.start_site(e.halfedge().twin());
            let follows = |&f: &EdgeId| {
                arrangement.support(f) == arrangement.support(e)
                    && dcel.ends(f)[0] == dcel.ends(e)[1]
                    && arrangement.start_site(f.halfedge()).location == end.location
            };
            end.point().and_then(|_| edges.iter().copied().find(follows))
        });
        let next = next.collect();
        let rails = edges.iter().map(|&e| Some(trapezoids.rail_of(e))).collect();
        Self { arrangement, trapezoids, edges, next, rails }
    }

    fn rail(&self, e: EdgeId) -> Option<RailId> {
        self.edges.iter().position(|&f| f == e).and_then(|i| self.rails[i])
    }

    fn next(&self, e: EdgeId) -> Option<EdgeId> {
        self.edges.iter().position(|&f| f == e).and_then(|i| self.next[i])
    }

    /// Gives a rail to the edges that are told.
    fn set_rail(&mut self, rail: Option<RailId>, is_of: impl Fn(EdgeId, Option<RailId>) -> bool) {
        for (&e, old) in self.edges.iter().zip(&mut self.rails) {
            if is_of(e, *old) {
                *old = rail;
            }
        }
    }

    /// Edges one after the other on a curve, and the vertex between them.
    fn consecutive(&self) -> impl Iterator<Item = (EdgeId, EdgeId, VertexId)> + '_ {
        let pairs = self.edges.iter().zip(&self.next);
        pairs.filter_map(|(&e, next)| next.map(|next| (e, next, self.arrangement.dcel().ends(e)[1])))
    }

    /// The edges between which a vertex lies without a site, on a rail of both.
    fn covering(&self, v: VertexId) -> Option<(EdgeId, EdgeId)> {
        let covers = |&(e, f, at): &(EdgeId, EdgeId, VertexId)| {
            at == v && self.rail(e).is_some() && self.rail(e) == self.rail(f)
        };
        self.consecutive().find(covers).map(|(e, f, _)| (e, f))
    }

    /// Whether a rail begins or ends at a site.
    fn is_used(&self, site: SiteId) -> bool {
        let ends = |i: usize| self.trapezoids.rails[i].ends.contains(&site);
        (0..self.trapezoids.rails.len()).any(ends)
    }

    fn remove_rail(&mut self, numbers: &mut Numbers) -> bool {
        let present: Vec<RailId> = self.rails.iter().copied().flatten().collect();
        let Some(rail) = pick(&present, numbers) else { return false };
        self.trapezoids.remove_rail(self.arrangement, rail);
        self.set_rail(None, |_, old| old == Some(rail));
        true
    }

    /// Removes a site between two rails of a curve.
    fn join(&mut self, numbers: &mut Numbers) -> bool {
        let candidates: Vec<_> = self
            .consecutive()
            .filter(|&(e, f, v)| {
                let (Some(l), Some(r)) = (self.rail(e), self.rail(f)) else { return false };
                let is_end = |rail: &&Rail| self.trapezoids.sites_of(v).any(|s| rail.ends.contains(&s));
                l != r
                    && self.trapezoids.sites_of(v).count() == 1
                    && self.trapezoids.rails.iter().filter(is_end).count() == 2
            })
            .collect();
        let Some((e, f, v)) = pick(&candidates, numbers) else { return false };
        let site = self.trapezoids.sites_of(v).next().expect("it has one site");
        let old = [self.rail(e), self.rail(f)];
        let kept = self.trapezoids.remove_site_on_rail(self.arrangement, site);
        assert!(old.contains(&Some(kept)));
        self.trapezoids.set_edge(kept, e);
        self.set_rail(Some(kept), |_, rail| old.contains(&rail));
        true
    }

    /// Removes a site without rails.
    fn remove_site(&mut self, numbers: &mut Numbers) -> bool {
        let candidates: Vec<SiteId> = (0..self.trapezoids.sites.len())
            .map(SiteId::new)
            .filter(|&site| !self.trapezoids.is_gone(site) && !self.is_used(site))
            .filter(|&site| {
                let v = self.trapezoids.vertex(site);
                self.home(v).is_none_or(|home| {
                    self.trapezoids.location(site) != home.location
                        || self.trapezoids.sites_of(v).count() == 1
                })
            })
            .collect();
        let Some(site) = pick(&candidates, numbers) else { return false };
        self.trapezoids.remove_site(self.arrangement, site);
        true
    }

    /// Inserts a rail along an edge, and perhaps along those that follow it.
    fn insert(&mut self, numbers: &mut Numbers, is_single: bool) -> bool {
        let absent: Vec<EdgeId> = self.edges.iter().copied().filter(|&e| self.rail(e).is_none()).collect();
        let Some(first) = pick(&absent, numbers) else { return false };
        let dcel = self.arrangement.dcel();
        let mut run = vec![first];
        let mut last = first;
        while let Some(next) = self.next(last).filter(|&next| !is_single && self.rail(next).is_none()) {
            let v = dcel.ends(next)[0];
            let is_free = self.trapezoids.sites_of(v).next().is_none() && self.covering(v).is_none();
            if !is_free || numbers.below(4) == 0 {
                break;
            }
            run.push(next);
            last = next;
        }
        let ends = [first.halfedge(), last.halfedge().twin()];
        if ends.iter().any(|&h| self.covering(dcel.source(h)).is_some()) {
            return false;
        }
        let ends = ends.map(|h| self.site_of_start(h));
        let place = self.trapezoids.place(self.arrangement, ends[0]);
        let toward = Toward::Right(self.arrangement.curve_of(first), Side::Above);
        let Found::Within(t) = self.trapezoids.search(self.arrangement, &place, &toward).0 else {
            panic!("only the place itself is looked for at a site")
        };
        let curve = self.arrangement.support(first).0;
        self.trapezoids.insert_rail(self.arrangement, curve, ends, t);
        let is_new = |rail: &Rail| rail.edge == EdgeId::NONE && rail.ends == ends;
        let rail = RailId::new(self.trapezoids.rails.iter().position(is_new).expect("it was inserted"));
        self.trapezoids.set_edge(rail, first);
        self.set_rail(Some(rail), |e, _| run.contains(&e));
        true
    }

    /// The site where a halfedge begins, added if it is not there.
    fn site_of_start(&mut self, h: HalfedgeId) -> SiteId {
        let place = self.arrangement.start_site(h);
        if place.point().is_some() {
            let v = self.arrangement.dcel().source(h);
            self.add_home(v);
            return self.vertex_site(v, &place);
        }
        let end = if h.is_even() { CurveEnd::Min } else { CurveEnd::Max };
        let curve = self.arrangement.support(h.edge_id()).0;
        match self.trapezoids.search(self.arrangement, &place, &Toward::Here).0 {
            Found::Site(site) => site,
            Found::Within(t) => {
                let v = self.arrangement.dcel().source(h);
                self.trapezoids.add_site(self.arrangement, NewSite::End(v, curve, end), place.location, t)
            }
        }
    }

    fn vertex_site(&mut self, v: VertexId, place: &Site<'_, G>) -> SiteId {
        if let Some(site) = self.trapezoids.site_at(v, place.location) {
            return site;
        }
        match self.trapezoids.search(self.arrangement, place, &Toward::Here).0 {
            Found::Within(t) => {
                self.trapezoids.add_site(self.arrangement, NewSite::Vertex(v), place.location, t)
            }
            Found::Site(site) => panic!("{site:?} is not known by {v:?}"),
        }
    }

    /// Where the site of a vertex is, whatever edges it has; none at infinity and at a pole, where only ends of edges have sites.
    fn home(&self, v: VertexId) -> Option<Site<'a, G>> {
        let (traits, topology) = (self.arrangement.traits(), self.arrangement.topology());
        let point = self.arrangement.point(v).filter(|_| !self.arrangement.stands_for_side(v));
        point.map(|point| Site::of_point(topology, traits, point))
    }

    fn add_home(&mut self, v: VertexId) {
        if let Some(home) = self.home(v) {
            self.vertex_site(v, &home);
        }
    }

    /// Adds the site of a vertex, on a rail if it lies on one.
    fn add_site(&mut self, numbers: &mut Numbers) -> bool {
        let is_bare = |v: &VertexId| self.home(*v).is_some() && self.trapezoids.sites_of(*v).next().is_none();
        let candidates: Vec<VertexId> = self.arrangement.vertices().filter(is_bare).collect();
        let Some(v) = pick(&candidates, numbers) else { return false };
        let Some((e, f)) = self.covering(v) else {
            self.add_home(v);
            return true;
        };
        let rail = self.rail(e).expect("it covers a vertex");
        let location = self.arrangement.start_site(f.halfedge()).location;
        let (_, rails) = self.trapezoids.add_site_on_rail(self.arrangement, v, location, rail);
        assert!(rails.contains(&rail));
        let mut behind = vec![f];
        while let Some(next) = self.next(behind[behind.len() - 1]).filter(|&e| self.rail(e) == Some(rail)) {
            behind.push(next);
        }
        self.set_rail(Some(rails[0]), |e, old| old == Some(rail) && !behind.contains(&e));
        self.set_rail(Some(rails[1]), |e, _| behind.contains(&e));
        self.trapezoids.set_edge(rails[0], e);
        self.trapezoids.set_edge(rails[1], f);
        true
    }

    fn check(&self, context: &str) {
        let (arrangement, trapezoids) = (self.arrangement, &self.trapezoids);
        let mut faults = trapezoids.find_faults_of_places(arrangement);
        for home in arrangement.vertices().filter_map(|v| self.home(v)) {
            let straight = [Side::Below, Side::Above].map(Toward::Straight);
            trapezoids.check_search(arrangement, &home, &Toward::Here, &mut faults);
            for toward in straight {
                trapezoids.check_search(arrangement, &home, &toward, &mut faults);
            }
        }
        for &e in &self.edges {
            let place = arrangement.start_site(e.halfedge());
            trapezoids.check_search(arrangement, &place, &Toward::Here, &mut faults);
            for side in [Side::Below, Side::Above] {
                let toward = Toward::Right(arrangement.curve_of(e), side);
                trapezoids.check_search(arrangement, &place, &toward, &mut faults);
            }
            let end = arrangement.start_site(e.halfedge().twin());
            trapezoids.check_search(arrangement, &end, &Toward::Here, &mut faults);
        }
        assert_eq!(faults, Vec::<String>::new(), "{context}");
    }
}

fn pick<I: Copy>(items: &[I], numbers: &mut Numbers) -> Option<I> {
    (!items.is_empty()).then(|| items[numbers.below(items.len() as i64) as usize])
}

/// Takes all away in random order, and puts all back.
fn all_go_and_come_back<G: UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    numbers: &mut Numbers,
    seed: u64,
) {
    let mut edits = Edits::new(arrangement);
    edits.check(&format!("seed {seed}, at first"));
    for round in 0..2 {
        let mut step = 0;
        loop {
            let is_done = match numbers.below(3) {
                0 => edits.remove_rail(numbers),
                1 => edits.join(numbers),
                _ => edits.remove_site(numbers),
            } || edits.join(numbers)
                || edits.remove_site(numbers)
                || edits.remove_rail(numbers);
            if !is_done {
                break;
            }
            edits.check(&format!("seed {seed}, round {round}, removal {step}"));
            step += 1;
        }
        assert_eq!(edits.trapezoids.count(), 1, "seed {seed}, round {round}");
        for step in 0..30 {
            match numbers.below(10) {
                0 => edits.remove_rail(numbers),
                1 => edits.join(numbers),
                2 => edits.remove_site(numbers),
                3 | 4 => edits.add_site(numbers),
                _ => edits.insert(numbers, false),
            };
            edits.check(&format!("seed {seed}, round {round}, change {step}"));
        }
        while edits.add_site(numbers) {}
        while edits.insert(numbers, true) {}
        edits.check(&format!("seed {seed}, round {round}, at last"));
        let faults = edits.trapezoids.find_faults(arrangement);
        assert_eq!(faults, Vec::<String>::new(), "seed {seed}, round {round}");
    }
}

#[test]
fn segments_go_and_come_back() {
    on(40, 7, random_segments, all_go_and_come_back);
}

#[test]
fn lines_go_and_come_back() {
    on(40, 5, random_lines, all_go_and_come_back);
}

#[test]
fn paths_on_a_torus_go_and_come_back() {
    on(60, 4, random_paths, all_go_and_come_back);
}

#[test]
fn arcs_on_a_sphere_go_and_come_back() {
    on(60, 4, random_globe, all_go_and_come_back);
}

#[test]
fn paths_on_a_cylinder_go_and_come_back() {
    on(40, 4, random_cylinder, all_go_and_come_back);
}
