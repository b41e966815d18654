//! Events in order, and the status line kept up to date.

use super::input::{InputCurve, NO_GROUP, SweepInput};
use super::queue::{Ahead, Queue, compare_keys};
use super::status::{NIL, Status, StrandData};
use super::visitor::{Around, Event, Link, Strand, SweepVisitor};
use crate::topology::{Site, Topology};
use crate::traits::{Along, Meeting, Multiplicity, SideKind, Sides, UMonotoneTraits, Window};
use std::cmp::Ordering;
use std::ops::{ControlFlow, Range};

/// Sweeps over the input, and tells the visitor of every event, until it answers `Break`.
///
/// # Complexity
/// See the module.
///
/// # References
/// Thesis, section 2.4.1.
pub fn sweep<G: UMonotoneTraits, T: Topology<G>, V: SweepVisitor<G>>(
    traits: &G,
    topology: &T,
    input: &SweepInput<'_, G>,
    visitor: &mut V,
) -> ControlFlow<()> {
    Engine::new(traits, topology, input).run(visitor)
}

/// The buffers of one event; kept to be used again.
#[derive(Debug)]
pub(super) struct Buffers<T> {
    /// The nodes of the strands that end here, from bottom to top.
    pub(super) nodes: Vec<u32>,
    pub(super) left: Vec<Strand<T>>,
    pub(super) right: Vec<Strand<T>>,
    /// Curves that go on or begin; where curves overlap for good, one for all.
    pub(super) curves: Vec<u32>,
    /// Whether several curves ran in a strand that was dissolved.
    pub(super) is_dissolved: bool,
}

/// A site in the order in which sites are met.
#[derive(Debug)]
pub(super) struct Stop<'i, G: UMonotoneTraits> {
    pub(super) site: Site<'i, G>,
    /// The order key of its point, if it has one and is in the interior; else 0.
    key: u64,
    /// The curves that begin here, and the first of a list of those that end here.
    pub(super) starts: Range<u32>,
    pub(super) first_end: u32,
    /// The first of a list of curves that pass through here, in `passing`.
    passing: u32,
}

/// What the sweep needs of a curve, in one place.
pub(super) struct Way<'i, G: UMonotoneTraits> {
    pub(super) curve: &'i G::UMonotoneCurve,
    /// The point where it ends, if that is in the interior.
    until: Option<&'i G::Point>,
    /// The place of the site where it ends among the stops.
    pub(super) end: u32,
    group: u32,
    /// The next one of the curves that end there.
    pub(super) next_end: u32,
}

pub(super) struct Engine<'a, 'i, G: UMonotoneTraits, T, Tag> {
    pub(super) traits: &'a G,
    pub(super) topology: &'a T,
    sides: Sides,
    /// The sites in the order in which they are met: their numbers, and what is there.
    order: Vec<u32>,
    pub(super) stops: Vec<Stop<'i, G>>,
    pub(super) ways: Vec<Way<'i, G>>,
    /// For each curve its node on the status line, and the next curve of the same strand.
    pub(super) links: Vec<Link>,
    pub(super) status: Status<&'i G::UMonotoneCurve, Tag>,
    pub(super) queue: Queue<G::Point>,
    passing: Vec<(u32, u32)>,
    /// For each curve, another one with which it overlaps, and the end of that is known: it waits in the queue, or one of them ends
    /// there. Empty if overlaps only end where curves do.
    ///
    /// Such pairs connect all curves of a strand. So as long as neither a curve of it ends nor such a pair parts, it stays together.
    pub(super) noted: Vec<u32>,
    /// For the first curve of each strand, the last event at which one of its curves ended or a pair parted. Empty as `noted` is.
    pub(super) parted: Vec<u32>,
    /// The number of the current event.
    pub(super) now: u32,
}

impl<'a, 'i, G: UMonotoneTraits, T: Topology<G>, Tag: Copy + Default> Engine<'a, 'i, G, T, Tag> {
    fn new(traits: &'a G, topology: &'a T, input: &SweepInput<'i, G>) -> Self {
        let sites = &input.sites;
        let key = |site: &Site<'i, G>| match site.point() {
            Some(point) if site.location.is_interior() => traits.order_key(point),
            _ => 0,
        };
        let mut keyed: Vec<(u64, u32)> = sites.iter().map(key).zip(0..).collect();
        // Stable, and quick where the sites are already in order, as those of an arrangement usually are.
        keyed.sort_by(|&(key_a, a), &(key_b, b)| {
            compare_keys(key_a, key_b)
                .unwrap_or_else(|| topology.compare_sites(traits, &sites[a as usize], &sites[b as usize]))
        });
        let mut rank = vec![0; sites.len()];
        for (place, &(_, site)) in keyed.iter().enumerate() {
            rank[site as usize] = place as u32;
        }
        let stop = |&(key, site): &(u64, u32)| {
            let site = site as usize;
            let starts = input.first_start[site]..input.first_start[site + 1];
            Stop { site: sites[site], key, starts, first_end: input.first_end[site], passing: NIL }
        };
        let way = |&InputCurve { curve, ends, group, next_end }: &InputCurve<'i, G>| {
            let end = &sites[ends[1] as usize];
            let until = end.point().filter(|_| end.location.is_interior());
            Way { curve, until, end: rank[ends[1] as usize], group, next_end }
        };
        Self {
            traits,
            topology,
            sides: topology.sides(),
            stops: keyed.iter().map(stop).collect(),
            order: keyed.into_iter().map(|(_, site)| site).collect(),
            ways: input.curves.iter().map(way).collect(),
            links: (0..input.curves.len() as u32).map(Link::alone).collect(),
            status: Status::new(),
            queue: Queue::new(),
            passing: Vec::new(),
            noted: vec![NIL; if G::MEET_ONCE { 0 } else { input.curves.len() }],
            parted: vec![NIL; if G::MEET_ONCE { 0 } else { input.curves.len() }],
            now: 0,
        }
    }

    fn run<V: SweepVisitor<G, Tag = Tag>>(&mut self, visitor: &mut V) -> ControlFlow<()> {
        let mut buffers = Buffers {
            nodes: Vec::new(),
            left: Vec::new(),
            right: Vec::new(),
            curves: Vec::new(),
            is_dissolved: false,
        };
        let traits = self.traits;
        let is_less = |p: &G::Point, q: &G::Point| traits.compare_uv(p, q) == Ordering::Less;
        let mut cursor = 0;
        loop {
            let meeting_first = match (self.stops.get(cursor), self.queue.first()) {
                (None, None) => return ControlFlow::Continue(()),
                (Some(_), None) => Ordering::Greater,
                (None, Some(_)) => Ordering::Less,
                (Some(stop), Some(ahead)) => compare_keys(ahead.key, stop.key).unwrap_or_else(|| {
                    self.topology.compare_sites(traits, &Site::interior(&ahead.point), &stop.site)
                }),
            };
            let (from, met) = (cursor, self.queue_pop_if(meeting_first.is_le(), is_less));
            if meeting_first.is_ge() {
                cursor = self.end_of_equal_sites(cursor);
            }
            let site = match &met {
                Some(ahead) => Site::interior(&ahead.point),
                None => self.stops[from].site,
            };
            let mut multiplicity = match &met {
                Some(ahead) if cursor == from => ahead.multiplicity,
                _ => Multiplicity::Unknown,
            };
            // Mark the strands that end here or pass through.
            let mut hit = NIL;
            for place in from..cursor {
                hit = self.mark_stop(place, hit);
            }
            if let Some(ahead) = &met {
                hit = self.mark_met(ahead.curves, hit);
                while self.queue.first().is_some_and(|next| {
                    next.curves == ahead.curves
                        || compare_keys(next.key, ahead.key).is_none()
                            && traits.is_same_point(&next.point, &ahead.point)
                }) {
                    let next = self.queue.pop(is_less).expect("the queue has a first meeting");
                    if next.curves != ahead.curves {
                        multiplicity = Multiplicity::Unknown;
                    }
                    hit = self.mark_met(next.curves, hit);
                }
            }
            let below_point = if hit == NIL { self.locate(&site) } else { Err(hit) };
            let (below, above) = self.collect_left(below_point, from..cursor, &mut buffers);
            self.make_right(&site, from..cursor, multiplicity, &mut buffers);
            let tag = |node: u32| (node != NIL).then(|| self.status.strand(node).tag);
            let event = Event { site, input_sites: &self.order[from..cursor], is_meeting: met.is_some() };
            let mut around = Around {
                below: tag(below),
                above: tag(above),
                left: &buffers.left,
                right: &mut buffers.right,
                links: &self.links,
            };
            visitor.event(&event, &mut around)?;
            self.update_status(&site, below, above, &mut buffers);
            self.now += 1;
        }
    }

    fn queue_pop_if(
        &mut self,
        pop: bool,
        is_less: impl Fn(&G::Point, &G::Point) -> bool,
    ) -> Option<Ahead<G::Point>> {
        if pop { self.queue.pop(is_less) } else { None }
    }

    /// The place after the sites that are equal to the one at `cursor`.
    fn end_of_equal_sites(&self, cursor: usize) -> usize {
        let first = &self.stops[cursor];
        let is_equal = |stop: &Stop<'_, G>| {
            compare_keys(first.key, stop.key)
                .unwrap_or_else(|| self.topology.compare_sites(self.traits, &first.site, &stop.site))
                == Ordering::Equal
        };
        let mut end = cursor + 1;
        while self.stops.get(end).is_some_and(is_equal) {
            end += 1;
        }
        end
    }

    /// Marks the strands that are known to go through a stop, and gives one of them.
    fn mark_stop(&mut self, place: usize, mut hit: u32) -> u32 {
        let Stop { first_end: mut ended, mut passing, .. } = self.stops[place];
        while ended != NIL {
            if !G::MEET_ONCE {
                let leader = self.leader(ended);
                self.parted[leader as usize] = self.now;
            }
            hit = self.mark_curve(ended, hit);
            ended = self.ways[ended as usize].next_end;
        }
        while passing != NIL {
            let (curve, next) = self.passing[passing as usize];
            hit = self.mark_curve(curve, hit);
            passing = next;
        }
        hit
    }

    #[inline]
    fn mark_curve(&mut self, curve: u32, hit: u32) -> u32 {
        let leader = self.leader(curve);
        let node = self.links[leader as usize].node;
        if node == NIL {
            return hit;
        }
        self.status.set_mark(node, self.now);
        node
    }

    /// Two curves met: what was known of their overlap may be over.
    #[inline]
    fn mark_met(&mut self, curves: [u32; 2], mut hit: u32) -> u32 {
        if !G::MEET_ONCE {
            let [leader, other] = curves.map(|curve| self.leader(curve));
            if leader == other {
                self.parted[leader as usize] = self.now;
            }
        }
        for curve in curves {
            if !G::MEET_ONCE {
                self.noted[curve as usize] = NIL;
            }
            hit = self.mark_curve(curve, hit);
        }
        hit
    }

    /// The first curve of the strand of a curve.
    #[inline]
    fn leader(&mut self, mut curve: u32) -> u32 {
        loop {
            let leader = self.links[curve as usize].leader;
            if leader == curve {
                return curve;
            }
            // Curves that led and have ended are skipped from now on.
            let next = self.links[leader as usize].leader;
            self.links[curve as usize].leader = next;
            curve = next;
        }
    }

    /// Looks for a site through which no strand is known to go: the node below it, or the one that goes through it.
    fn locate(&self, site: &Site<'_, G>) -> Result<u32, u32> {
        let status = &self.status;
        let curve = |node: u32| status.strand(node).curve;
        match (site.location.u, site.location.v) {
            // Only curves along the left side are met before what follows on it.
            (Along::Low, _) => match (status.last(), site.point()) {
                (top, Some(_)) if top != NIL && self.traits.is_vertical(curve(top)) => Err(top),
                (top, _) => Ok(top),
            },
            // All strands end on the right side, and those that end further down are gone.
            (Along::High, _) => Ok(NIL),
            (_, Along::Low) => match (status.first(), site.point()) {
                (bottom, Some(p)) if bottom != NIL && self.sides.v[0] == SideKind::Identified => {
                    match self.traits.compare_v_at_u(p, curve(bottom)) {
                        Ordering::Equal => Err(bottom),
                        _ => Ok(NIL),
                    }
                }
                _ => Ok(NIL),
            },
            (_, Along::High) => Ok(status.last()),
            (Along::Inside, Along::Inside) => {
                let Some(p) = site.point() else { return Ok(status.last()) };
                let (mut node, mut below) = (status.root(), NIL);
                while node != NIL {
                    match self.traits.compare_v_at_u(p, curve(node)) {
                        Ordering::Less => node = status.child(node, 0),
                        Ordering::Equal => return Err(node),
                        Ordering::Greater => {
                            below = node;
                            node = status.child(node, 1);
                        }
                    }
                }
                Ok(below)
            }
        }
    }

    /// Replaces the strands on the left by those on the right, and asks new neighbours where they meet.
    fn update_status(&mut self, site: &Site<'_, G>, below: u32, above: u32, buffers: &mut Buffers<Tag>) {
        let Buffers { nodes, right, .. } = buffers;
        let mut last = below;
        let mut reused = nodes.iter();
        for strand in right.iter() {
            let curve = self.ways[strand.head as usize].curve;
            let data = StrandData { head: strand.head, curve, tag: strand.tag };
            let node = match reused.next() {
                Some(&node) => {
                    self.status.set_strand(node, data);
                    node
                }
                None => self.status.insert_above(last, data),
            };
            self.links[strand.head as usize].node = node;
            if !G::MEET_ONCE && last != below {
                self.ask(last, node, site);
            }
            last = node;
        }
        for &node in reused {
            self.status.remove(node);
        }
        if right.is_empty() {
            self.ask(below, above, site);
        } else {
            let first = if below == NIL { self.status.first() } else { self.status.next(below) };
            self.ask(below, first, site);
            self.ask(last, above, site);
        }
    }

    /// Asks two neighbours where they meet next, and notes it.
    #[inline]
    fn ask(&mut self, below: u32, above: u32, site: &Site<'_, G>) {
        if below == NIL || above == NIL {
            return;
        }
        let curves = [below, above].map(|node| self.status.strand(node).head);
        let [lower, upper] = curves.map(|curve| &self.ways[curve as usize]);
        if lower.group == upper.group && lower.group != NO_GROUP {
            return;
        }
        let first_to_end = usize::from(upper.end < lower.end);
        let Way { until, end, .. } = *[lower, upper][first_to_end];
        let after = site.point().filter(|_| site.location.is_interior());
        let window = Window { after, until, first_to_end };
        match self.traits.next_meeting(lower.curve, upper.curve, window) {
            Meeting::Never => {}
            Meeting::At(point, multiplicity) => self.push_meeting(point, curves, multiplicity),
            Meeting::AtEnd => {
                let link = self.passing.len() as u32;
                let stop = &mut self.stops[end as usize];
                self.passing.push((curves[1 - first_to_end], stop.passing));
                stop.passing = link;
            }
        }
    }

    pub(super) fn push_meeting(&mut self, point: G::Point, curves: [u32; 2], multiplicity: Multiplicity) {
        let traits = self.traits;
        let is_less = |p: &G::Point, q: &G::Point| traits.compare_uv(p, q) == Ordering::Less;
        let key = traits.order_key(&point);
        self.queue.push(Ahead { point, key, curves, multiplicity }, is_less);
    }
}
