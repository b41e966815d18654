//! The face of a trapezoid, and which trapezoids are next to one another.

use super::seams::is_open;
use super::{Side, SiteId, Trapezoid, TrapezoidId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::{Along, BasicTraits};
use dcel::{CcbId, FaceId, VertexId};

/// What a part of a face has that is not its boundary.
#[derive(Debug, Default)]
pub(crate) struct Contents {
    pub(crate) ccbs: Vec<CcbId>,
    pub(crate) isolated: Vec<VertexId>,
}

/// Trapezoids that were found, and are marked.
///
/// Each visit has numbers of its own for its marks, so that old ones need not be wiped out.
#[derive(Clone, Debug, Default)]
pub(super) struct Visits {
    marks: Vec<u32>,
    pub(super) last: u32,
    pub(super) found: [Vec<TrapezoidId>; 2],
    next: Vec<TrapezoidId>,
}

impl Visits {
    /// Begins a visit among a number of trapezoids, and gives the marks of two parts.
    fn begin(&mut self, count: usize) -> [u32; 2] {
        if self.last > u32::MAX - 2 {
            self.marks.fill(0);
            self.last = 0;
        }
        if self.marks.len() < count {
            self.marks.resize(count, 0);
        }
        for found in &mut self.found {
            found.clear();
        }
        self.last += 2;
        [self.last - 1, self.last]
    }
}

impl<G: BasicTraits> Trapezoids<G> {
    /// The face in which a trapezoid lies.
    ///
    /// # Complexity
    /// Constant; on identified sides linear in the number of vertices without an edge that begins there.
    pub(crate) fn face_of<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        mut t: TrapezoidId,
    ) -> FaceId {
        let dcel = arrangement.dcel();
        loop {
            let trapezoid = self.trapezoid(t);
            if !trapezoid.below.is_none() {
                return dcel.face(self.rail(trapezoid.below).edge.halfedge());
            }
            if !trapezoid.above.is_none() {
                return dcel.face(self.rail(trapezoid.above).edge.halfedge().twin());
            }
            let left = trapezoid.left;
            if left.is_none() {
                return arrangement.corner_face();
            }
            if let Some(face) = dcel.isolated_face(self.vertex(left)) {
                return face;
            }
            let [below, above] = self.left_of(left);
            t = if is_open(self.location(left))[1] { above } else { below };
        }
    }

    /// Appends the trapezoids that are next to one, past walls.
    fn neighbours<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        t: TrapezoidId,
        out: &mut Vec<TrapezoidId>,
    ) {
        let trapezoid = self.trapezoid(t);
        let mut past =
            |site: SiteId, from: fn(&Self, SiteId) -> [TrapezoidId; 2], to: fn(&Self, SiteId) -> _| {
                if site.is_none() {
                    return;
                }
                let (from, to): (_, [TrapezoidId; 2]) = (from(self, site), to(self, site));
                for wall in [0, 1] {
                    if from[wall] == t && self.is_open_across(arrangement, site)[wall] {
                        out.push(to[wall]);
                    }
                }
            };
        past(trapezoid.left, Self::right_of, Self::left_of);
        past(trapezoid.right, Self::left_of, Self::right_of);
        self.across_seams(arrangement, t, out);
    }

    /// Visits the trapezoids connected with each of two, in step; gives all that are connected with the one that has fewer, and says
    /// which it is: 0 or 1. If they are connected with one another, the answer has all that are connected with both, and is 0.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids of the answer.
    pub(crate) fn smaller_part<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        starts: [TrapezoidId; 2],
    ) -> (usize, Vec<TrapezoidId>) {
        let mut visits = std::mem::take(&mut self.visits);
        let smaller = self.visit_in_step(arrangement, starts, &mut visits);
        let smaller = smaller.unwrap_or_else(|| {
            self.visit(arrangement, starts[0], &mut visits);
            0
        });
        let part = std::mem::take(&mut visits.found[smaller]);
        self.visits = visits;
        (smaller, part)
    }

    /// All trapezoids connected with one.
    ///
    /// # Complexity
    /// Linear in their number.
    #[cfg(test)]
    pub(super) fn part<T: Topology<G>>(
        &mut self,
        arrangement: &Arrangement<G, T>,
        start: TrapezoidId,
    ) -> Vec<TrapezoidId> {
        let mut visits = std::mem::take(&mut self.visits);
        self.visit(arrangement, start, &mut visits);
        let part = std::mem::take(&mut visits.found[0]);
        self.visits = visits;
        part
    }

    /// Visits two parts until one has no more, and says which; `None` as soon as they meet.
    fn visit_in_step<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        starts: [TrapezoidId; 2],
        visits: &mut Visits,
    ) -> Option<usize> {
        if starts[0] == starts[1] {
            return None;
        }
        let marks = visits.begin(self.trapezoids.len());
        for i in [0, 1] {
            visits.marks[starts[i].index()] = marks[i];
            visits.found[i].push(starts[i]);
        }
        for visited in 0.. {
            for i in [0, 1] {
                let Some(&t) = visits.found[i].get(visited) else { return Some(i) };
                if !self.visit_next(arrangement, t, visits, i, marks) {
                    return None;
                }
            }
        }
        None
    }

    /// Visits all that are connected with a trapezoid.
    pub(super) fn visit<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        start: TrapezoidId,
        visits: &mut Visits,
    ) {
        let [mark, _] = visits.begin(self.trapezoids.len());
        visits.marks[start.index()] = mark;
        visits.found[0].push(start);
        let mut visited = 0;
        while let Some(&t) = visits.found[0].get(visited) {
            self.visit_next(arrangement, t, visits, 0, [mark; 2]);
            visited += 1;
        }
    }

    /// Finds the trapezoids next to one; tells whether none of them is of the other part.
    fn visit_next<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        t: TrapezoidId,
        visits: &mut Visits,
        part: usize,
        marks: [u32; 2],
    ) -> bool {
        let Visits { marks: marked, found, next, .. } = visits;
        next.clear();
        self.neighbours(arrangement, t, next);
        for &t in next.iter() {
            let mark = std::mem::replace(&mut marked[t.index()], marks[part]);
            if mark == marks[part] {
                continue;
            }
            if mark == marks[1 - part] {
                return false;
            }
            found[part].push(t);
        }
        true
    }

    /// The CCBs along trapezoids, and the isolated vertices between them or on their sides; each once.
    pub(crate) fn contents<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        trapezoids: &[TrapezoidId],
    ) -> Contents {
        let dcel = arrangement.dcel();
        let isolated = |v: VertexId| Some(v).filter(|&v| dcel.isolated_face(v).is_some());
        // Vertices that stand for sides have no site as long as no curve ends there.
        let sides = arrangement.topology().side_vertices().map(|v| v.and_then(|v| isolated(VertexId(v))));
        let mut contents = Contents::default();
        for &t in trapezoids {
            let trapezoid = self.trapezoid(t);
            for side in [Side::Below, Side::Above] {
                let rail = trapezoid.rail(side);
                if !rail.is_none() {
                    let h = self.rail(rail).edge.halfedge();
                    contents.ccbs.push(dcel.ccb(if side == Side::Below { h } else { h.twin() }));
                }
            }
            let ends = [trapezoid.left, trapezoid.right].into_iter().filter(|site| !site.is_none());
            contents.isolated.extend(ends.filter_map(|site| isolated(self.vertex(site))));
            let touched = sides.into_iter().zip(self.touched_sides(trapezoid));
            contents.isolated.extend(touched.filter(|(_, is)| *is).filter_map(|(v, _)| v));
        }
        contents.ccbs.sort_unstable();
        contents.ccbs.dedup();
        contents.isolated.sort_unstable();
        contents.isolated.dedup();
        contents
    }

    /// Whether a trapezoid touches the sides left, right, bottom and top, as far as no site is on them.
    fn touched_sides(&self, trapezoid: &Trapezoid) -> [bool; 4] {
        let Trapezoid { left, right, below, above, .. } = *trapezoid;
        let is_at = |site: SiteId, u: Along| !site.is_none() && self.location(site).u == u;
        // Above a piece of the left side is that side itself, and below a piece of the right one.
        let is_on_top = above.is_none() && !is_at(right, Along::Low);
        let is_on_bottom = below.is_none() && !is_at(left, Along::High);
        [left.is_none(), right.is_none(), is_on_bottom, is_on_top]
    }
}
