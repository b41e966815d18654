//! Where curves meet, and whether they meet at all.

use super::owners::{Owned, OwnerSets};
use crate::sweep::{Around, Event, SweepVisitor, sweep};
use crate::topology::{Site, SiteAt, Topology};
use crate::traits::{Along, ArrangementTraits, BasicTraits, Location};
use std::ops::ControlFlow;

/// Whether a point that is an end of every curve through it counts as a meeting of these curves.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum CommonEnds {
    /// It does.
    Count,
    /// It does not.
    Ignore,
}

/// Gives the points that at least two of the curves and points have in common, each once and in lexicographic order.
///
/// A curve is taken as a whole: that it meets itself is no meeting, nor that it was cut into pieces. It goes *through* its ends, too,
/// and a point of `points` is a curve with one end. With m curves through a point, m at least 2, the point is given
///
/// - unless these curves coincide in a neighbourhood of it, and none of them ends there: so of an overlap only those points are
///   given at which the set of curves that run together changes, or a curve ends;
/// - and, with [`CommonEnds::Ignore`], unless it is an end of all m curves.
///
/// Degenerate: two equal lines have no such point, and of two equal segments only the ends are given, if they count at all. On a
/// surface with identified sides a point is where all its places are.
///
/// # Preconditions
/// Those of [`locate_by_sweep`](super::locate_by_sweep) on points.
///
/// ```
/// use splitstar_arrangement::models::{Segment, SegmentTraits};
/// use splitstar_arrangement::{CommonEnds, intersections, topology::BoundedPlane};
/// use exact::planar::Point2;
/// let segment = |a, b| Segment::new(Point2::from_i64(a), Point2::from_i64(b)).expect("two points");
/// let curves = [segment([0, 0], [4, 0]), segment([4, 0], [4, 4]), segment([2, 0], [2, 3])];
/// let find = |ends| intersections(&SegmentTraits, &BoundedPlane, &curves, &[], ends);
/// let [t, corner] = [[2, 0], [4, 0]].map(Point2::from_i64);
/// assert_eq!(find(CommonEnds::Ignore), [t.clone()]);
/// assert_eq!(find(CommonEnds::Count), [t, corner]);
/// ```
///
/// # Complexity
/// That of [`sweep`], and of sorting the points if some lie on identified sides.
pub fn intersections<'a, G: ArrangementTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    curves: impl IntoIterator<Item = &'a G::Curve>,
    points: &[G::Point],
    ends: CommonEnds,
) -> Vec<G::Point>
where
    G::Curve: 'a,
{
    let owned = Owned::new(traits, curves, points);
    let mut found = Vec::new();
    let _ = watch(traits, topology, &owned, |point, place| {
        if let (Some(point), true) = (point, place.is_given(ends)) {
            found.push(point.clone());
        }
        ControlFlow::Continue(())
    });
    if found.iter().any(|point| !topology.point_location(traits, point).is_interior()) {
        found.sort_by(|p, q| {
            let [p, q] = [p, q].map(|point| Site::of_point(topology, traits, point));
            topology.compare_sites(traits, &p, &q)
        });
    }
    found
}

/// Tells whether any two of the curves and points have a point in common. The sweep stops as soon as it is known.
///
/// Curves and their ends are understood as in [`intersections`]. With [`CommonEnds::Ignore`] two curves that meet only in points which
/// are ends of all curves there do not meet; but curves that overlap do, whatever their ends.
///
/// # Complexity
/// That of [`sweep`] up to the first meeting: O(n log n) predicates at most. Meetings on identified sides are known at the end.
pub fn do_any_meet<'a, G: ArrangementTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    curves: impl IntoIterator<Item = &'a G::Curve>,
    points: &[G::Point],
    ends: CommonEnds,
) -> bool
where
    G::Curve: 'a,
{
    let owned = Owned::new(traits, curves, points);
    let flow = watch(traits, topology, &owned, |_, place| {
        if place.is_meeting(ends) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    flow.is_break()
}

/// Which curves are at a place. One point of the surface may have several places.
#[derive(Clone, Debug, Default)]
struct Place {
    /// The owners of what is here, sorted.
    through: Vec<u32>,
    /// Those of them that have an end here, sorted.
    ends: Vec<u32>,
    /// How many owners each strand has that ends or begins here: the least number, if there is a strand, and the greatest.
    least: Option<usize>,
    most: usize,
}

impl Place {
    fn clear(&mut self) {
        self.through.clear();
        self.ends.clear();
        (self.least, self.most) = (None, 0);
    }

    fn add_strand(&mut self, owners: &[u32]) {
        self.through.extend(owners);
        self.least = Some(self.least.map_or(owners.len(), |least| least.min(owners.len())));
        self.most = self.most.max(owners.len());
    }

    fn add_place(&mut self, other: &Self) {
        self.through.extend(&other.through);
        self.ends.extend(&other.ends);
        self.least = match (self.least, other.least) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
        self.most = self.most.max(other.most);
    }

    fn sort(&mut self) {
        for owners in [&mut self.through, &mut self.ends] {
            owners.sort_unstable();
            owners.dedup();
        }
    }

    fn is_common(&self, ends: CommonEnds) -> bool {
        self.through.len() > 1 && (ends == CommonEnds::Count || self.ends.len() < self.through.len())
    }

    /// Whether the point is one of the intersections.
    fn is_given(&self, ends: CommonEnds) -> bool {
        let do_coincide = self.least == Some(self.through.len()) && self.ends.is_empty();
        self.is_common(ends) && !do_coincide
    }

    /// Whether curves meet here, or overlap next to it.
    fn is_meeting(&self, ends: CommonEnds) -> bool {
        self.is_common(ends) || self.most > 1
    }
}

/// Sweeps, and tells of all that is at each point, or at each place where a curve has an end without a point. Points on
/// identified sides come at the end, as their places are met at different times.
fn watch<G: ArrangementTraits, T: Topology<G>>(
    traits: &G,
    topology: &T,
    owned: &Owned<'_, G>,
    tell: impl FnMut(Option<&G::Point>, &Place) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let sides = topology.sides();
    let is_identified = [sides.is_u_identified(), sides.is_v_identified()];
    let mut watcher = Watcher {
        sites: &owned.sites,
        sets: OwnerSets::new(&owned.owners, owned.owner_count),
        is_identified,
        contractions: [0, 1, 2, 3].map(|side| topology.contraction(traits, side)),
        place: Place::default(),
        on_seams: Vec::new(),
        tell,
    };
    sweep(traits, topology, &owned.input(traits, topology), &mut watcher)?;
    let Watcher { mut on_seams, mut tell, .. } = watcher;
    let compare = |p: &G::Point, q: &G::Point| {
        let [p, q] = [p, q].map(|point| Site::of_point(topology, traits, point));
        topology.compare_sites(traits, &p, &q)
    };
    on_seams.sort_by(|(p, _), (q, _)| compare(p, q));
    for places in on_seams.chunk_by(|(p, _), (q, _)| compare(p, q).is_eq()) {
        let mut whole = Place::default();
        for (_, place) in places {
            whole.add_place(place);
        }
        whole.sort();
        tell(Some(&places[0].0), &whole)?;
    }
    ControlFlow::Continue(())
}

struct Watcher<'o, P, F> {
    sites: &'o [(u32, bool)],
    sets: OwnerSets<'o>,
    is_identified: [bool; 2],
    /// The points to which left, right, bottom and top are contracted.
    contractions: [Option<P>; 4],
    /// Kept to be used again.
    place: Place,
    on_seams: Vec<(P, Place)>,
    tell: F,
}

impl<P, F> Watcher<'_, P, F> {
    /// The point of a contracted side.
    fn contraction(&self, Location { u, v }: Location) -> Option<&P> {
        let side = match (u, v) {
            (_, Along::Low) => 2,
            (_, Along::High) => 3,
            (Along::Low, _) => 0,
            (Along::High, _) => 1,
            _ => return None,
        };
        self.contractions[side].as_ref()
    }

    fn is_on_seam(&self, location: Location) -> bool {
        self.is_identified[0] && location.u != Along::Inside
            || self.is_identified[1] && location.v != Along::Inside
    }
}

impl<G, F> SweepVisitor<G> for Watcher<'_, G::Point, F>
where
    G: BasicTraits,
    F: FnMut(Option<&G::Point>, &Place) -> ControlFlow<()>,
{
    type Tag = u32;

    fn event(&mut self, event: &Event<'_, G>, around: &mut Around<'_, u32>) -> ControlFlow<()> {
        self.place.clear();
        for strand in around.left {
            self.place.add_strand(self.sets.get(&strand.tag));
            self.sets.release(strand.tag);
        }
        for i in 0..around.right.len() {
            let tag = self.sets.make(around, i);
            around.right[i].tag = tag;
            self.place.add_strand(self.sets.get(&tag));
        }
        // Images on other sides are of sites that are met, too.
        for &(owner, is_end) in event.input_sites.iter().filter_map(|&site| self.sites.get(site as usize)) {
            self.place.through.push(owner);
            if is_end {
                self.place.ends.push(owner);
            }
        }
        self.place.sort();
        match event.site.at {
            SiteAt::Point(point) if self.is_on_seam(event.site.location) => {
                self.on_seams.push((point.clone(), self.place.clone()));
                ControlFlow::Continue(())
            }
            SiteAt::Point(point) => (self.tell)(Some(point), &self.place),
            SiteAt::End(..) => match self.contraction(event.site.location).cloned() {
                Some(point) => {
                    self.on_seams.push((point, self.place.clone()));
                    ControlFlow::Continue(())
                }
                None => (self.tell)(None, &self.place),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::{Segment, SegmentTraits};
    use crate::topology::BoundedPlane;
    use exact::planar::Point2;

    #[test]
    fn a_curve_that_leaves_an_overlap_goes_through_its_end() {
        // At (6, 0) the first and the third end, and the second goes on.
        let ends = [[[0, 0], [6, 0]], [[2, 0], [8, 0]], [[4, 0], [6, 0]], [[8, 0], [9, 1]]];
        let segments = ends.map(|ends| Segment::from_i64(ends).expect("the ends are different"));
        let found = |ends| intersections(&SegmentTraits, &BoundedPlane, &segments, &[], ends);
        let points = |at: &[[i64; 2]]| at.iter().map(|&at| Point2::from_i64(at)).collect::<Vec<_>>();
        assert_eq!(found(CommonEnds::Count), points(&[[2, 0], [4, 0], [6, 0], [8, 0]]));
        assert_eq!(found(CommonEnds::Ignore), points(&[[2, 0], [4, 0], [6, 0]]));
    }
}
