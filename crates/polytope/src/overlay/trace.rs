//! Walking one Gaussian map through another.
//!
//! The *red* map is traced through the *blue* one: starting from one red vertex whose place in blue is
//! known, every red arc is followed from blue face to blue face, so that each red vertex reached gets
//! its place too. Every decision is the sign of a scalar product of a normal of one map and an edge
//! vector of the other (degree 3 in the input), because
//!
//! - from a point on a blue circle, a red arc leaves to the side on which its *end* lies (arcs are
//!   shorter than a half circle, so the point itself adds nothing to the sign);
//! - a red arc inside a blue face leaves it where the corners of the face change sides of the red
//!   circle, and reaches that place unless its end lies before it.
//!
//! No crossing is ever computed, and arcs need no order: they come in the order in which they are met.
//!
//! The corners of a face lie on the left of a red circle in one run and on the right in another; so
//! the exit is found by galloping along the ring from the entry, in time logarithmic in the distance.
//! A red vertex inside a face remembers where the circle of the arc that reached it enters and leaves
//! the face: the arcs that leave that vertex search between these two places.

use super::map::{GaussianMap, Normal, same_turn};
use super::record::{Chord, Crossing, Kind, OverlayVertex, Piece, Place, Trace, Track};
use super::search::{first_between, first_where};
use crate::fault::{Fault, injected};
use dcel::{FacetId, HalfedgeId, VertexId};
use exact::Sign;

/// Where a red arc goes from the point that it has reached.
enum Heading {
    /// Into a face; the ring index of the first corner after the point where the arc enters.
    Into(VertexId, usize),
    /// From a point inside the face.
    Within(VertexId, Chord),
    /// Along a blue arc.
    Along(HalfedgeId),
}

/// How far a red arc goes in one step.
enum Step {
    /// To its end, which lies there.
    End(Place),
    /// To a vertex of the overlay, and how it goes on.
    On(OverlayVertex, Heading),
}

struct Walk<'a> {
    red: &'a GaussianMap<'a>,
    blue: &'a GaussianMap<'a>,
    trace: Trace,
}

/// Traces all arcs of `red` through `blue`.
///
/// # Complexity
/// Linear in both maps and the number of crossings, if the faces of the maps have a bounded number of
/// arcs; in general each step costs the logarithm of the distance between entry and exit on the ring
/// of the face.
pub(super) fn trace(red: &GaussianMap<'_>, blue: &GaussianMap<'_>) -> Trace {
    let mut walk = Walk { red, blue, trace: Trace::default() };
    walk.trace.places = vec![Place::Unknown; red.mesh.facet_count()];
    walk.trace.pieces.reserve(red.mesh.edge_count() * 2);
    let mut traced = vec![false; red.mesh.edge_count()];
    walk.trace.places[0] = super::locate::locate(blue, red.normal(FacetId(0)));
    let mut stack = vec![FacetId(0)];
    while let Some(f) = stack.pop() {
        // Consecutive arcs around a common vertex turn with the sectors of the blue vertex.
        let mut sector = None;
        for h in red.mesh.facet_cycle(f) {
            if std::mem::replace(&mut traced[h.edge()], true) {
                continue;
            }
            let end = red.end(h);
            let place = walk.follow(h, &mut sector);
            if let Place::Unknown = walk.trace.places[end.index()] {
                walk.trace.places[end.index()] = place;
                stack.push(end);
            }
        }
    }
    for place in &walk.trace.places {
        match place {
            Place::Arc(_) => walk.trace.counts.normals_on_arcs += 1,
            Place::Vertex(_) => walk.trace.counts.common_normals += 1,
            Place::Face(..) | Place::Unknown => {}
        }
    }
    walk.trace.counts.crossings = walk.trace.crossings.len();
    walk.trace
}

impl Walk<'_> {
    /// Follows the red arc `r` from its start to its end, and tells where the end lies.
    fn follow(&mut self, r: HalfedgeId, sector: &mut Option<HalfedgeId>) -> Place {
        let (red, blue) = (self.red, self.blue);
        let start = red.mesh.facet(r);
        let end = OverlayVertex::new(Kind::Red(red.end(r).0));
        let target = red.normal(red.end(r));
        let mut heading = match self.trace.places[start.index()] {
            Place::Face(w, chord) => {
                let chord = chord.unwrap_or_else(|| self.first_chord(r, w));
                self.trace.places[start.index()] = Place::Face(w, Some(chord));
                Heading::Within(w, chord)
            }
            Place::Arc(b) => self.leave_arc(r, target, b),
            Place::Vertex(m) => {
                let first = sector.unwrap_or_else(|| blue.mesh.boundary(m));
                let (heading, last) = self.leave_vertex(r, target, first);
                *sector = Some(last);
                heading
            }
            Place::Unknown => unreachable!("arcs are followed from vertices whose place is known"),
        };
        loop {
            let (step, on) = match heading {
                Heading::Along(b) => (self.along(r, target, b), Track::along(b)),
                Heading::Into(w, _) | Heading::Within(w, _) => {
                    (self.across(r, target, w, &heading), Track::inside(w))
                }
            };
            match step {
                Step::End(place) => {
                    self.trace.pieces.push(Piece { arc: r, to: end, on });
                    return place;
                }
                Step::On(to, next) => {
                    self.trace.pieces.push(Piece { arc: r, to, on });
                    heading = next;
                }
            }
        }
    }

    /// One step along the blue arc `b`.
    fn along(&mut self, r: HalfedgeId, target: Normal<'_>, b: HalfedgeId) -> Step {
        self.trace.counts.overlaps += 1;
        let last = self.blue.end(b);
        match self.before_end_of(b, target) {
            Sign::Positive => Step::End(Place::Arc(b)),
            Sign::Zero => Step::End(Place::Vertex(last)),
            Sign::Negative => self.through_vertex(r, target, last, self.blue.mesh.next(b.twin())),
        }
    }

    /// One step inside the blue face `w`.
    #[inline]
    fn across(&mut self, r: HalfedgeId, target: Normal<'_>, w: VertexId, heading: &Heading) -> Step {
        let blue = self.blue;
        if let Place::Face(known, _) = self.trace.places[self.red.end(r).index()]
            && known == w
        {
            // Both ends lie in one face, and faces are convex.
            return Step::End(Place::Face(w, None));
        }
        let ring = blue.ring(w);
        let (exit, through_corner) = self.exit(r, target, heading);
        let corner = ring[exit];
        // The arc before the exit corner: the red arc leaves through it or its end.
        let b = ring[if exit == 0 { ring.len() - 1 } else { exit - 1 }];
        let mut side = blue.side(target, b);
        if injected(Fault::ZeroAsPositive) && side == Sign::Zero {
            side = Sign::Positive;
        }
        match side {
            Sign::Positive => {
                let entry = self.entry(r, target, heading) as u32;
                Step::End(Place::Face(w, Some(Chord { arc: r, exit: exit as u32, entry })))
            }
            Sign::Zero if through_corner => Step::End(Place::Vertex(blue.mesh.facet(corner))),
            Sign::Zero => Step::End(Place::Arc(b)),
            Sign::Negative if through_corner => {
                self.through_vertex(r, target, blue.mesh.facet(corner), corner)
            }
            Sign::Negative => {
                let crossing = OverlayVertex::new(Kind::Crossing(self.trace.crossings.len() as u32));
                self.trace.crossings.push(Crossing { red: r, blue: b });
                Step::On(crossing, self.enter_right_of(b))
            }
        }
    }

    /// On through the blue vertex `m`, of which `leaving` is one of the arcs.
    fn through_vertex(&mut self, r: HalfedgeId, target: Normal<'_>, m: FacetId, leaving: HalfedgeId) -> Step {
        Step::On(OverlayVertex::new(Kind::Blue(m.0)), self.leave_vertex(r, target, leaving).0)
    }

    /// The side of the red circle of `r` on which a blue corner lies.
    #[inline]
    fn corner_side(&self, r: HalfedgeId, corner: HalfedgeId) -> Sign {
        self.red.side(self.blue.normal(self.blue.mesh.facet(corner)), r)
    }

    /// The heading into the face on the left of `b`, from a point on the arc `b` or at its start.
    #[inline]
    fn enter_left_of(&self, b: HalfedgeId) -> Heading {
        Heading::Into(self.blue.mesh.target(b), self.blue.ring_position(b) + 1)
    }

    #[inline]
    fn enter_right_of(&self, b: HalfedgeId) -> Heading {
        self.enter_left_of(b.twin())
    }

    /// From a point in the interior of the blue arc `b`.
    fn leave_arc(&self, r: HalfedgeId, target: Normal<'_>, b: HalfedgeId) -> Heading {
        match self.blue.side(target, b) {
            Sign::Positive => self.enter_left_of(b),
            Sign::Negative => self.enter_right_of(b),
            Sign::Zero if same_turn(self.red, r, self.blue, b) == Sign::Positive => Heading::Along(b),
            Sign::Zero => Heading::Along(b.twin()),
        }
    }

    /// From the blue vertex of which `first` is one of the leaving arcs: looks through the sectors
    /// counterclockwise from there. Also gives the arc where the search ended, which is where the
    /// search for the next red arc counterclockwise starts.
    fn leave_vertex(&self, r: HalfedgeId, target: Normal<'_>, first: HalfedgeId) -> (Heading, HalfedgeId) {
        let blue = self.blue;
        let mut b = first;
        let mut side = blue.side(target, b);
        loop {
            if side == Sign::Zero && same_turn(self.red, r, blue, b) == Sign::Positive {
                return (Heading::Along(b), b);
            }
            let next = blue.mesh.next(b);
            let next_side = blue.side(target, next);
            if side == Sign::Positive && next_side == Sign::Negative {
                return (self.enter_left_of(b), b);
            }
            (b, side) = (next, next_side);
        }
    }

    /// For a direction on the circle of `b` ahead of its start: positive if it comes before the end of
    /// `b`, zero at the end, negative beyond.
    fn before_end_of(&self, b: HalfedgeId, target: Normal<'_>) -> Sign {
        let blue = self.blue;
        let after = blue.mesh.prev(b.twin());
        if blue.mesh.next(b.twin()) == after {
            // The end is a digon: the arc after it goes on along the same circle.
            return -blue.order_on(b, blue.normal(blue.end(b)), target);
        }
        blue.side(target, after)
    }

    /// The ring index of the first corner that is no longer on the right of the red circle, ahead; and
    /// whether it is on the circle.
    fn exit(&self, r: HalfedgeId, target: Normal<'_>, heading: &Heading) -> (usize, bool) {
        // The search ends at the exit: a corner on the circle is the exit. It is not on the circle where
        // the search runs out of corners without looking at the last one, the entry.
        let mut on_circle = false;
        let not_right = |corner| {
            let side = self.corner_side(r, corner);
            on_circle |= side == Sign::Zero;
            side != Sign::Negative
        };
        let exit = match *heading {
            Heading::Into(w, first) => {
                let ring = self.blue.ring(w);
                first_where(ring, first, ring.len() - 1, not_right)
            }
            Heading::Within(w, chord) => {
                let ring = self.blue.ring(w);
                match self.turn(r, target, chord) {
                    Turn::Left => first_between(ring, chord.exit, chord.entry, not_right),
                    Turn::Right => first_between(ring, chord.entry, chord.exit, not_right),
                    straight => {
                        let exit = if straight == Turn::Straight { chord.exit } else { chord.entry } as usize;
                        on_circle = self.corner_side(r, ring[exit]) == Sign::Zero;
                        exit
                    }
                }
            }
            Heading::Along(_) => unreachable!("an arc along another one is not inside a face"),
        };
        (exit, on_circle)
    }

    /// The ring index of the first corner that is no longer on the left of the red circle, behind.
    fn entry(&self, r: HalfedgeId, target: Normal<'_>, heading: &Heading) -> usize {
        let not_left = |corner| self.corner_side(r, corner) != Sign::Positive;
        match *heading {
            Heading::Into(w, first) => {
                // From a vertex the corner itself is on the circle.
                let ring = self.blue.ring(w);
                let corner = first - 1;
                if self.corner_side(r, ring[corner]) == Sign::Zero { corner } else { first % ring.len() }
            }
            Heading::Within(w, chord) => {
                let ring = self.blue.ring(w);
                match self.turn(r, target, chord) {
                    Turn::Left => first_between(ring, chord.entry, chord.exit, not_left),
                    Turn::Right => first_between(ring, chord.exit, chord.entry, not_left),
                    Turn::Straight => chord.entry as usize,
                    Turn::Back => chord.exit as usize,
                }
            }
            Heading::Along(_) => unreachable!("an arc along another one is not inside a face"),
        }
    }

    /// Where the circle of the first arc to be followed enters and leaves the face of its start: by
    /// looking at all corners.
    fn first_chord(&self, r: HalfedgeId, w: VertexId) -> Chord {
        let ring = self.blue.ring(w);
        let side = |i: usize| self.corner_side(r, ring[i % ring.len()]);
        let find = |from: usize, wanted: &dyn Fn(Sign) -> bool| {
            let found = (from..from + ring.len()).find(|&i| wanted(side(i)));
            found.expect("a face has corners on both sides of a circle through its interior")
        };
        let right = find(0, &|s| s == Sign::Negative);
        let exit = find(right, &|s| s != Sign::Negative);
        let left = find(exit, &|s| s == Sign::Positive);
        let entry = find(left, &|s| s != Sign::Positive);
        Chord { arc: r, exit: (exit % ring.len()) as u32, entry: (entry % ring.len()) as u32 }
    }

    /// How the arc `r` goes on from the circle of the chord of its start.
    fn turn(&self, r: HalfedgeId, target: Normal<'_>, chord: Chord) -> Turn {
        match self.red.side(target, chord.arc) {
            Sign::Positive => Turn::Left,
            Sign::Negative => Turn::Right,
            // Facets with parallel edges.
            Sign::Zero if same_turn(self.red, r, self.red, chord.arc) == Sign::Positive => Turn::Straight,
            Sign::Zero => Turn::Back,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Turn {
    Left,
    Right,
    Straight,
    Back,
}
