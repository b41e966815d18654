//! The face of a trapezoid, and which trapezoids are next to one another.

use super::{Side, SiteId, TrapezoidId, Trapezoids};
use crate::arrangement::Arrangement;
use crate::topology::Topology;
use crate::traits::{Along, BasicTraits, Location};
use dcel::{CcbId, FaceId, VertexId};

/// Whether one may step from left to right past a site: below and above it. On a side of the parameter space only one of the walls
/// is on the surface.
#[inline]
fn is_open(location: Location) -> [bool; 2] {
    match (location.u, location.v) {
        (Along::Low, _) => [true, false],
        (Along::High, _) => [false, true],
        (_, Along::Low) => [false, true],
        (_, Along::High) => [true, false],
        _ => [true, true],
    }
}

/// What a part of a face has that is not its boundary.
#[derive(Debug, Default)]
pub(crate) struct Contents {
    pub(crate) ccbs: Vec<CcbId>,
    pub(crate) isolated: Vec<VertexId>,
}

/// Trapezoids of a face, found one after the other.
struct Search {
    found: Vec<TrapezoidId>,
    visited: usize,
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
            if let Some(face) = self.vertex(left).and_then(|v| dcel.isolated_face(v)) {
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
                    if from[wall] == t && is_open(self.location(site))[wall] {
                        out.push(to[wall]);
                    }
                }
            };
        past(trapezoid.left, Self::right_of, Self::left_of);
        past(trapezoid.right, Self::left_of, Self::right_of);
        self.across_seams(arrangement, t, out);
    }

    /// Appends the trapezoids that are next to one across identified sides.
    fn across_seams<T: Topology<G>>(&self, _: &Arrangement<G, T>, _: TrapezoidId, _: &mut Vec<TrapezoidId>) {}

    /// Visits the trapezoids connected with each of two, in step; gives all that are connected with the one that has fewer, and says
    /// which it is: 0 or 1. Both together if they are connected with one another: then the answer has both.
    ///
    /// # Complexity
    /// Linear in the number of trapezoids of the smaller part.
    pub(crate) fn smaller_part<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        starts: [TrapezoidId; 2],
    ) -> (usize, Vec<TrapezoidId>) {
        let mut seen = std::collections::HashSet::new();
        let mut searches = starts.map(|start| {
            seen.insert(start);
            Search { found: vec![start], visited: 0 }
        });
        let mut next = Vec::new();
        loop {
            for (i, search) in searches.iter_mut().enumerate() {
                let Some(&t) = search.found.get(search.visited) else {
                    return (i, std::mem::take(&mut search.found));
                };
                search.visited += 1;
                next.clear();
                self.neighbours(arrangement, t, &mut next);
                search.found.extend(next.iter().copied().filter(|&t| seen.insert(t)));
            }
        }
    }

    /// All trapezoids connected with one.
    pub(crate) fn part<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        start: TrapezoidId,
    ) -> Vec<TrapezoidId> {
        let mut seen = std::collections::HashSet::from([start]);
        let mut search = Search { found: vec![start], visited: 0 };
        let mut next = Vec::new();
        while let Some(&t) = search.found.get(search.visited) {
            search.visited += 1;
            next.clear();
            self.neighbours(arrangement, t, &mut next);
            search.found.extend(next.iter().copied().filter(|&t| seen.insert(t)));
        }
        search.found
    }

    /// The CCBs along trapezoids, and the isolated vertices between them; each once.
    pub(crate) fn contents<T: Topology<G>>(
        &self,
        arrangement: &Arrangement<G, T>,
        trapezoids: &[TrapezoidId],
    ) -> Contents {
        let dcel = arrangement.dcel();
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
            let isolated = |site: SiteId| {
                let v = if site.is_none() { None } else { self.vertex(site) };
                v.filter(|&v| dcel.isolated_face(v).is_some())
            };
            contents.isolated.extend([trapezoid.left, trapezoid.right].into_iter().filter_map(isolated));
        }
        contents.ccbs.sort_unstable();
        contents.ccbs.dedup();
        contents.isolated.sort_unstable();
        contents.isolated.dedup();
        contents
    }
}
