//! Which trapezoid has a place in it.

use super::{Node, Side, SiteId, TrapezoidId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::{Site, Topology};
use crate::traits::{Along, BasicTraits, CurveEnd};
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

impl<G: BasicTraits> Trapezoids<G> {
    /// Finds a place. Also tells in how many steps.
    ///
    /// Where the place is on an edge and no side of it is asked for, the trapezoid above is found.
    pub(crate) fn search<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        place: &Site<'_, G>,
        toward: &Toward<'_, G>,
    ) -> (Found, u32) {
        let (traits, topology) = (arrangement.traits(), arrangement.topology());
        let key = place.point().filter(|_| place.location.is_interior());
        let key = key.map_or(0, |point| traits.order_key(point));
        let mut node = 0;
        let mut steps = 0;
        loop {
            steps += 1;
            let next = match &self.nodes[node] {
                Node::Leaf(t) => return (Found::Within(*t), steps),
                Node::Link(next) => *next,
                // Keys order as the places do, where they are different and there are any.
                Node::Split { key: other, children, .. } if key != *other && key != 0 && *other != 0 => {
                    children[usize::from(key > *other)]
                }
                Node::Split { site, children, .. } => {
                    match topology.compare_sites(traits, place, &self.place(arrangement, *site)) {
                        Ordering::Less => children[0],
                        Ordering::Greater => children[1],
                        Ordering::Equal => match toward {
                            Toward::Here if !self.is_gone(*site) => return (Found::Site(*site), steps),
                            _ => children[1],
                        },
                    }
                }
                Node::Curve { curve, children } => {
                    let curve = &arrangement.curves()[*curve as usize];
                    let order = match side(arrangement, place, curve) {
                        Ordering::Equal => match toward {
                            Toward::Here => Ordering::Greater,
                            Toward::Straight(side) => side.order(),
                            Toward::Right(other, side) => {
                                compare_right(arrangement, other, curve, place).then(side.order())
                            }
                        },
                        order => order,
                    };
                    if order.is_lt() { children[0] } else { children[1] }
                }
            };
            node = next.index();
        }
    }

    /// The trapezoid in which a curve leaves a site to the right; above, if it runs along an edge. Notes how long that took.
    ///
    /// # Complexity
    /// Constant if at most one edge leaves the site to the right; else that of a search.
    pub(crate) fn first_of<T: Topology<G>>(
        &mut self,
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
        if lowest == highest {
            let other = &arrangement.curves()[self.rail(lowest).curve as usize];
            return if compare_right(arrangement, curve, other, &place).is_lt() { below } else { above };
        }
        match self.search(arrangement, &place, &Toward::Right(curve, Side::Above)) {
            (Found::Within(t), steps) => {
                self.note_steps(steps);
                t
            }
            (Found::Site(_), _) => unreachable!("only the place itself is looked for at a site"),
        }
    }

    /// Finds a place while the arrangement is edited: notes how long that took.
    pub(crate) fn find<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        place: &Site<'_, G>,
    ) -> Found {
        let (found, steps) = self.search(arrangement, place, &Toward::Here);
        self.note_steps(steps);
        found
    }

    fn note_steps(&mut self, steps: u32) {
        let usual = 6 * (self.trapezoids.len().ilog2() + 1);
        self.excess += u64::from(steps.saturating_sub(usual));
    }

    /// Tells whether searches took so long that it pays to build all anew.
    pub(crate) fn is_worn(&self) -> bool {
        // Dead nodes count too: they are memory. But what was built anew just now is not worn, however unlucky its order was.
        let size = self.count() as u64;
        let nodes = (self.nodes.len() as u64).saturating_sub(self.built_nodes as u64);
        self.excess > 64 + 8 * size || nodes > 64 + (12 * size).max(self.built_nodes as u64)
    }
}
