//! What comes to an event from the left: strands, taken apart where their curves may part.

use super::engine::{Buffers, Engine};
use super::status::{NIL, Status, StrandData};
use super::visitor::{Link, Strand};
use crate::topology::Topology;
use crate::traits::UMonotoneTraits;
use std::ops::Range;

impl<G: UMonotoneTraits, T: Topology<G>, Tag: Copy + Default> Engine<'_, '_, G, T, Tag> {
    /// Collects the strands through the event, given the node below it or one through it, and the curves of these strands that do
    /// not end at one of the stops `places`; of a strand that stays together, the first one. Gives the nodes next below and next
    /// above.
    pub(super) fn collect_left(
        &mut self,
        place: Result<u32, u32>,
        places: Range<usize>,
        buffers: &mut Buffers<Tag>,
    ) -> (u32, u32) {
        let Buffers { nodes, left, curves, is_dissolved, .. } = buffers;
        nodes.clear();
        left.clear();
        curves.clear();
        *is_dissolved = false;
        let hit = match place {
            Ok(below) => {
                let above = if below == NIL { self.status.first() } else { self.status.next(below) };
                return (below, above);
            }
            Err(hit) => hit,
        };
        self.status.set_mark(hit, self.now);
        let goes_through = |status: &Status<_, _>, node: u32| node != NIL && status.mark(node) == self.now;
        let mut first = hit;
        while goes_through(&self.status, self.status.prev(first)) {
            first = self.status.prev(first);
        }
        let mut node = first;
        while goes_through(&self.status, node) {
            let StrandData { head, tag, .. } = *self.status.strand(node);
            nodes.push(node);
            left.push(Strand { head, tag });
            node = self.status.next(node);
        }
        if G::MEET_ONCE {
            // Curves that overlap do so until one of them ends: the others stay together.
            for place in places {
                let mut ended = self.stops[place].first_end;
                while ended != NIL {
                    self.unlink(ended);
                    ended = self.ways[ended as usize].next_end;
                }
            }
            curves
                .extend(nodes.iter().map(|&node| self.status.strand(node).head).filter(|&head| head != NIL));
        } else {
            for Strand { head, .. } in left.iter() {
                if self.parted[*head as usize] == self.now {
                    *is_dissolved |= self.links[*head as usize].next != NIL;
                    self.dissolve(*head, places.end as u32, curves);
                } else {
                    curves.push(*head);
                }
            }
        }
        (self.status.prev(first), node)
    }

    /// Takes a curve that ends out of its strand.
    fn unlink(&mut self, curve: u32) {
        let Link { prev, next, .. } = self.links[curve as usize];
        if next != NIL {
            self.links[next as usize].prev = prev;
        }
        if prev != NIL {
            self.links[prev as usize].next = next;
            return;
        }
        let node = self.links[curve as usize].node;
        let tag = self.status.strand(node).tag;
        if next != NIL {
            self.links[next as usize].leader = next;
            self.links[next as usize].node = node;
            // The others find the new leader by way of the old one.
            self.links[curve as usize].leader = next;
        }
        let shown = if next == NIL { curve } else { next };
        self.status.set_strand(node, StrandData { head: next, curve: self.ways[shown as usize].curve, tag });
    }

    /// Takes a strand apart, and collects those of its curves that do not end before the stop `end`.
    fn dissolve(&mut self, head: u32, end: u32, curves: &mut Vec<u32>) {
        let mut curve = head;
        while curve != NIL {
            if self.ways[curve as usize].end >= end {
                curves.push(curve);
            }
            let next = self.links[curve as usize].next;
            self.links[curve as usize] = Link::alone(curve);
            curve = next;
        }
    }
}
