//! Which trapezoid has a place in it.

use super::structure::{Branch, Comparison, Node, OrderRange, Step};
use super::{RailId, Side, SiteId, TrapezoidId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::{Site, Topology};
use crate::traits::{Along, BasicTraits, CurveEnd};
use dcel::EdgeId;
use std::cmp::Ordering;

/// What to look for at a place.
#[derive(Debug)]
pub(crate) enum Toward<'a, G: BasicTraits> {
    /// The place itself.
    Here,
    /// What is next to it along a curve that passes through it or begins there; on the side given, if an edge runs there.
    Right(&'a G::UMonotoneCurve, Side),
    /// What is next to it straight below or above.
    Straight(Side),
}

/// What was found at a place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Found {
    /// A site is there.
    Site(SiteId),
    /// The place is within a trapezoid, or on its boundary.
    Within(TrapezoidId),
}

/// Compares a place with a curve that begins before it and ends behind it: below, on or above it.
pub(crate) fn side<G: BasicTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    place: &Site<'_, G>,
    curve: &G::UMonotoneCurve,
) -> Ordering {
    let (traits, topology) = (arrangement.traits(), arrangement.topology());
    match place.point() {
        Some(point) if place.location.is_interior() => traits.compare_v_at_u(point, curve),
        _ => {
            let start = Site::of_end(topology, traits, curve, CurveEnd::Min);
            let begins_here =
                start.location == place.location && topology.compare_sites(traits, &start, place).is_eq();
            let end = topology.end_location(traits, curve, CurveEnd::Max);
            match (place.location.u, place.location.v) {
                _ if begins_here => Ordering::Equal,
                // What begins on a side and does not run along it has left it.
                (Along::Low, _) if end.u == Along::Low => Ordering::Equal,
                (Along::Low, _) => Ordering::Greater,
                (Along::High, _) => Ordering::Less,
                // One that begins and ends on the bottom runs along it, or leaves it in between.
                (_, Along::Low) if start.location.v == Along::Low && end.v == Along::Low => {
                    place.point().map_or(Ordering::Less, |point| traits.compare_v_at_u(point, curve))
                }
                (_, Along::Low) => Ordering::Less,
                (..) => Ordering::Greater,
            }
        }
    }
}

/// Compares two curves immediately to the right of a place of both.
pub(crate) fn compare_right<G: BasicTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    a: &G::UMonotoneCurve,
    b: &G::UMonotoneCurve,
    place: &Site<'_, G>,
) -> Ordering {
    match place.point() {
        Some(point) => arrangement.traits().compare_v_at_u_right(a, b, point),
        // Ends without points are one place only if the curves have a piece in common.
        None => Ordering::Equal,
    }
}

/// How many searches go on at the same time.
const AT_ONCE: usize = 16;

/// A place that is looked for.
struct Search<'a, G: BasicTraits> {
    place: Site<'a, G>,
    /// Its point, if it is in the interior of the parameter space.
    inside: Option<&'a G::Point>,
    range: OrderRange,
    /// Whether it was on a curve with which it was compared.
    is_on_curve: bool,
}

impl<'a, G: BasicTraits> Search<'a, G> {
    fn new<T: Topology<G>>(arrangement: &Arrangement<G, T>, place: Site<'a, G>) -> Self {
        let inside = place.point().filter(|_| place.location.is_interior());
        Self { place, inside, range: OrderRange::of(arrangement.traits(), &place), is_on_curve: false }
    }
}

impl<G: BasicTraits> Trapezoids<G> {
    /// Finds a place. Also tells whether it may be on an edge: it is on none if it was on no curve with which it was compared.
    ///
    /// Where the place is on an edge and no side of it is asked for, the trapezoid above is found.
    pub(crate) fn search<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        place: &Site<'_, G>,
        toward: &Toward<'_, G>,
    ) -> (Found, bool) {
        let mut search = Search::new(arrangement, *place);
        let mut branch = self.structure.root();
        let mut steps = 0;
        let found = loop {
            steps += 1;
            let node = match self.structure.at(branch, &self.trapezoids) {
                Step::End(t) => break Found::Within(t),
                Step::Node(node) => node,
            };
            match self.compare(arrangement, &mut search, toward, node) {
                Ok(is_behind) => branch = node.branches()[usize::from(is_behind)],
                Err(site) => break Found::Site(site),
            }
        };
        self.structure.note_steps(steps, self.count());
        (found, search.is_on_curve)
    }

    /// Finds many places, a few at a time, so that what one of them waits for is fetched while others are compared. Gives for each what
    /// [`search`](Self::search) gives.
    ///
    /// # Complexity
    /// That of as many searches; but most of their time is waiting for memory, and that they share.
    pub(crate) fn search_all<'a, T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        places: impl Iterator<Item = Site<'a, G>>,
        mut found: impl FnMut(&Site<'a, G>, Found, bool),
    ) where
        G: 'a,
    {
        let mut places = places.map(|place| Search::new(arrangement, place)).peekable();
        let mut group = Vec::with_capacity(AT_ONCE);
        while places.peek().is_some() {
            group.clear();
            group.extend(places.by_ref().take(AT_ONCE).map(|search| (search, Err(self.structure.root()))));
            let (mut open, mut steps) = (group.len(), 0);
            while open > 0 {
                // All nodes are asked for before one is looked at.
                steps += 1;
                let mut nodes = [None; AT_ONCE];
                for (node, (_, at)) in nodes.iter_mut().zip(&mut group) {
                    let Err(branch) = *at else { continue };
                    match self.structure.at(branch, &self.trapezoids) {
                        Step::Node(next) => *node = Some(*next),
                        Step::End(t) => {
                            (*at, open) = (Ok(Found::Within(t)), open - 1);
                            self.structure.note_steps(steps, self.count());
                        }
                    }
                }
                for (node, (search, at)) in nodes.iter().zip(&mut group) {
                    let Some(node) = node else { continue };
                    match self.compare(arrangement, search, &Toward::Here, node) {
                        Ok(is_behind) => *at = Err(node.branches()[usize::from(is_behind)]),
                        Err(site) => (*at, open) = (Ok(Found::Site(site)), open - 1),
                    }
                }
            }
            for (search, at) in &group {
                found(&search.place, at.expect("no search is open"), search.is_on_curve);
            }
        }
    }

    /// Compares what is looked for with a node: whether it is behind, or the site there if it is found.
    #[inline]
    fn compare<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        search: &mut Search<'_, G>,
        toward: &Toward<'_, G>,
        node: &Node,
    ) -> Result<bool, SiteId> {
        let (traits, topology) = (arrangement.traits(), arrangement.topology());
        let place = &search.place;
        match node.comparison() {
            Comparison::Site(site, other) => match search.range.is_behind(other) {
                Some(is_behind) => Ok(is_behind),
                None => match topology.compare_sites(traits, place, &self.place(arrangement, site)) {
                    Ordering::Less => Ok(false),
                    Ordering::Greater => Ok(true),
                    Ordering::Equal => match toward {
                        Toward::Here if !self.is_gone(site) => Err(site),
                        _ => Ok(true),
                    },
                },
            },
            Comparison::Curve(curve, key) => {
                let by_key = search.inside.and_then(|point| traits.compare_v_at_u_by_key(point, &key));
                let order = by_key.unwrap_or_else(|| {
                    let curve = &arrangement.curves()[curve as usize];
                    match side(arrangement, place, curve) {
                        Ordering::Equal => {
                            search.is_on_curve = true;
                            match toward {
                                Toward::Here => Ordering::Greater,
                                Toward::Straight(side) => side.order(),
                                Toward::Right(other, side) => {
                                    compare_right(arrangement, other, curve, place).then(side.order())
                                }
                            }
                        }
                        order => order,
                    }
                });
                Ok(order.is_ge())
            }
        }
    }

    /// The first part, from the left, of a trapezoid that may have been cut by walls since it was found.
    pub(crate) fn first_part(&self, t: TrapezoidId) -> TrapezoidId {
        let mut branch = Branch::leaf(t);
        loop {
            match self.structure.at(branch, &self.trapezoids) {
                Step::End(t) => return t,
                Step::Node(node) => {
                    debug_assert!(matches!(node.comparison(), Comparison::Site(..)), "no edge came since");
                    branch = node.branches()[0];
                }
            }
        }
    }

    /// Finds a place on the bottom or top side, below or above all curves. Its point may be one of the interior of the parameter space, straight
    /// above or below.
    pub(crate) fn search_along_side<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        place: &Site<'_, G>,
        side: Side,
    ) -> Found {
        let compare = |site| {
            let other = self.place(arrangement, site);
            arrangement.topology().compare_sites(arrangement.traits(), place, &other)
        };
        let mut branch = self.structure.root();
        loop {
            let node = match self.structure.at(branch, &self.trapezoids) {
                Step::End(t) => return Found::Within(t),
                Step::Node(node) => node,
            };
            branch = node.branches()[match node.comparison() {
                Comparison::Site(site, _) => match compare(site) {
                    Ordering::Equal if !self.is_gone(site) => return Found::Site(site),
                    order => usize::from(order.is_ge()),
                },
                Comparison::Curve(..) => side as usize,
            }];
        }
    }

    /// The trapezoid in which a curve leaves a site to the right; above, if it runs along an edge.
    ///
    /// # Complexity
    /// Constant if it is not between two edges that leave the site to the right; else that of a search.
    pub(crate) fn first_of<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        site: SiteId,
        curve: &G::UMonotoneCurve,
    ) -> TrapezoidId {
        let [below, above] = self.right_of(site);
        if below == above {
            return above;
        }
        let place = self.place(arrangement, site);
        let (lowest, highest) = (self.trapezoid(below).above, self.trapezoid(above).below);
        let compare = |rail: RailId| {
            let other = &arrangement.curves()[self.rail(rail).curve as usize];
            compare_right(arrangement, curve, other, &place)
        };
        if compare(lowest).is_lt() {
            return below;
        }
        if compare(highest).is_ge() {
            return above;
        }
        match self.search(arrangement, &place, &Toward::Right(curve, Side::Above)) {
            (Found::Within(t), _) => t,
            (Found::Site(_), _) => unreachable!("only the place itself is looked for at a site"),
        }
    }

    /// Finds a place.
    pub(crate) fn find<T: Topology<G>>(&self, arrangement: &Arrangement<G, T>, place: &Site<'_, G>) -> Found {
        self.search(arrangement, place, &Toward::Here).0
    }

    /// Tells whether searches took so long that it pays to build all anew.
    pub(crate) fn is_worn(&self) -> bool {
        self.structure.is_worn(self.count())
    }

    /// The length of the longest path of the search structure, as it was built.
    pub(crate) fn longest_path(&self) -> u32 {
        self.structure.longest_path()
    }

    /// Puts the search structure in order.
    pub(super) fn tidy(&mut self) {
        let order = self.structure.tidy(&self.trapezoids);
        let mut numbers = vec![TrapezoidId::NONE; self.trapezoids.len()];
        for (new, &old) in order.iter().enumerate() {
            numbers[old.index()] = TrapezoidId::new(new);
        }
        let renumber = |t: &mut TrapezoidId| *t = numbers[t.index()];
        for site in &mut self.sites {
            site.left.iter_mut().chain(&mut site.right).for_each(renumber);
        }
        for rail in self.rails.iter_mut().filter(|rail| rail.edge != EdgeId::NONE) {
            rail.first.iter_mut().for_each(renumber);
        }
        self.trapezoids = order.into_iter().map(|old| self.trapezoids[old.index()]).collect();
    }
}
