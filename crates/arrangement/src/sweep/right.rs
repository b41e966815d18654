//! What begins at an event: curves sorted by their order to the right, and put together where they overlap.

use super::engine::{Buffers, Engine};
use super::status::NIL;
use super::visitor::{Link, Strand};
use crate::topology::{Site, Topology, ends_on_side};
use crate::traits::{Multiplicity, UMonotoneTraits};
use std::cmp::Ordering;
use std::ops::Range;

impl<G: UMonotoneTraits, T: Topology<G>, Tag: Copy + Default> Engine<'_, '_, G, T, Tag> {
    /// Makes the strands that begin at an event. `buffers.curves` has the curves that go on, from bottom to top as they came;
    /// those that begin at the sites `places` of the order are added.
    pub(super) fn make_right(
        &mut self,
        site: &Site<'_, G>,
        places: Range<usize>,
        multiplicity: Multiplicity,
        buffers: &mut Buffers<Tag>,
    ) {
        let Buffers { right, curves, is_dissolved, .. } = buffers;
        right.clear();
        let going_on = curves.len();
        for place in places.clone() {
            curves.extend(self.stops[place].starts.clone());
        }
        let begins = curves.len() > going_on;
        let is_pair = !begins && going_on == 2 && !*is_dissolved;
        if !begins && G::MEET_ONCE || is_pair && multiplicity == Multiplicity::Odd {
            // Straight curves through one point all change sides.
            curves.reverse();
        } else if is_pair && multiplicity == Multiplicity::Even {
            // They keep their order.
        } else if curves.len() > 1 && !(going_on == 0 && places.len() == 1) {
            self.sort(site, curves);
            return self.bundle(site, right, curves);
        }
        right.extend(curves.iter().map(|&head| Strand { head, tag: Tag::default() }));
    }

    /// Sorts curves through a point by their order to the right of it.
    fn sort(&self, site: &Site<'_, G>, curves: &mut [u32]) {
        if let Some(p) = site.point() {
            curves.sort_by(|&a, &b| self.compare_right(a, b, p));
        }
    }

    fn compare_right(&self, a: u32, b: u32, p: &G::Point) -> Ordering {
        self.traits.compare_v_at_u_right(self.ways[a as usize].curve, self.ways[b as usize].curve, p)
    }

    /// Puts sorted curves that overlap into one strand each. Curves at a site without a point are there because they overlap.
    fn bundle(&mut self, site: &Site<'_, G>, right: &mut Vec<Strand<Tag>>, curves: &[u32]) {
        let mut rest = curves;
        while let Some((&head, others)) = rest.split_first() {
            let overlapping = others
                .iter()
                .take_while(|&&curve| site.point().is_none_or(|p| self.compare_right(head, curve, p).is_eq()))
                .count();
            for &curve in &others[..overlapping] {
                self.join(head, curve);
                if !G::MEET_ONCE && self.noted[curve as usize] != head {
                    self.noted[curve as usize] = head;
                    self.note_end_of_overlap(head, curve, site);
                }
            }
            right.push(Strand { head, tag: Tag::default() });
            rest = &others[overlapping..];
        }
    }

    /// Puts the strand of a curve into that of another.
    fn join(&mut self, head: u32, mut curve: u32) {
        while curve != NIL {
            let next = self.links[curve as usize].next;
            let second = self.links[head as usize].next;
            self.links[curve as usize] = Link { leader: head, node: NIL, prev: head, next: second };
            if second != NIL {
                self.links[second as usize].prev = curve;
            }
            self.links[head as usize].next = curve;
            curve = next;
        }
    }

    /// Two curves that overlap may part before either ends: that is an event.
    fn note_end_of_overlap(&mut self, a: u32, b: u32, site: &Site<'_, G>) {
        let [curve_a, curve_b] = [a, b].map(|curve| self.ways[curve as usize].curve);
        let is_ahead = |point: &G::Point| {
            // On a side curves end, and that is a site already. The point of a contracted side is not told apart by where it is.
            let meeting = Site::of_point(self.topology, self.traits, point);
            meeting.location.is_interior()
                && ![curve_a, curve_b]
                    .into_iter()
                    .any(|curve| ends_on_side(self.topology, self.traits, curve, point))
                && self.topology.compare_sites(self.traits, &meeting, site) == Ordering::Greater
                && [a, b].into_iter().all(|curve| {
                    let end = &self.stops[self.ways[curve as usize].end as usize].site;
                    self.topology.compare_sites(self.traits, &meeting, end) == Ordering::Less
                })
        };
        let end = self.traits.end_of_overlap(curve_a, curve_b, site.point());
        if let Some(point) = end.filter(is_ahead) {
            self.push_meeting(point, [a, b], Multiplicity::Unknown);
        }
    }
}
