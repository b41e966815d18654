//! Pieces of curves that know whose they are, and which curves run together.

use crate::sweep::{Around, SweepInput};
use crate::topology::Topology;
use crate::traits::{ArrangementTraits, BasicTraits, Piece};

/// General curves, cut into u-monotone pieces, and points. Each curve and each point has a number: it is the *owner* of its pieces.
pub(super) struct Owned<'a, G: BasicTraits> {
    pub(super) curves: Vec<G::UMonotoneCurve>,
    /// The points that are pieces of curves, and those that were given.
    own_points: Vec<G::Point>,
    given_points: &'a [G::Point],
    /// For each piece its owner.
    pub(super) owners: Vec<u32>,
    /// For each site that is no image on another side: its owner, and whether it is a true end of it.
    pub(super) sites: Vec<(u32, bool)>,
    pub(super) owner_count: u32,
}

impl<'a, G: ArrangementTraits> Owned<'a, G> {
    pub(super) fn new<'c>(
        traits: &G,
        curves: impl IntoIterator<Item = &'c G::Curve>,
        points: &'a [G::Point],
    ) -> Self
    where
        G::Curve: 'c,
    {
        let mut owned = Self {
            curves: Vec::new(),
            own_points: Vec::new(),
            given_points: points,
            owners: Vec::new(),
            sites: Vec::new(),
            owner_count: 0,
        };
        let (mut is_artificial, mut point_owners) = (Vec::new(), Vec::new());
        let mut buffer = Vec::new();
        for curve in curves {
            traits.make_u_monotone(curve, &mut buffer);
            for piece in buffer.drain(..) {
                match piece {
                    Piece::Curve { curve, is_artificial: is } => {
                        owned.curves.push(curve);
                        owned.owners.push(owned.owner_count);
                        is_artificial.push(is);
                    }
                    Piece::Point(point) => {
                        owned.own_points.push(point);
                        point_owners.push(owned.owner_count);
                    }
                }
            }
            owned.owner_count += 1;
        }
        for end in 0..2 {
            let ends = owned.owners.iter().zip(&is_artificial);
            owned.sites.extend(ends.map(|(&owner, is): (&u32, &[bool; 2])| (owner, !is[end])));
        }
        owned.sites.extend(point_owners.into_iter().map(|owner| (owner, true)));
        for _ in points {
            owned.sites.push((owned.owner_count, true));
            owned.owner_count += 1;
        }
        owned
    }

    /// The input of a sweep over all pieces.
    pub(super) fn input<T: Topology<G>>(&self, traits: &G, topology: &T) -> SweepInput<'_, G> {
        let points = self.own_points.iter().chain(self.given_points);
        SweepInput::of_curves(traits, topology, &self.curves, points)
    }
}

/// The owners of strands, which a sweep has as tags: the number of the only owner, or that of a set of several.
pub(super) struct OwnerSets<'o> {
    owners: &'o [u32],
    single_count: u32,
    sets: Vec<Vec<u32>>,
    free: Vec<u32>,
}

impl<'o> OwnerSets<'o> {
    pub(super) fn new(owners: &'o [u32], owner_count: u32) -> Self {
        Self { owners, single_count: owner_count, sets: Vec::new(), free: Vec::new() }
    }

    /// The owners of a strand, sorted.
    pub(super) fn get<'s>(&'s self, tag: &'s u32) -> &'s [u32] {
        match tag.checked_sub(self.single_count) {
            None => std::slice::from_ref(tag),
            Some(set) => &self.sets[set as usize],
        }
    }

    /// The strand with a tag has ended.
    pub(super) fn release(&mut self, tag: u32) {
        if let Some(set) = tag.checked_sub(self.single_count) {
            self.free.push(set);
        }
    }

    /// Makes the tag of a strand that begins.
    pub(super) fn make(&mut self, around: &Around<'_, u32>, right: usize) -> u32 {
        let first = self.owners[around.right[right].curve()];
        if !around.is_overlap(right) {
            return first;
        }
        let slot = self.free.pop().unwrap_or_else(|| {
            self.sets.push(Vec::new());
            self.sets.len() as u32 - 1
        });
        let set = &mut self.sets[slot as usize];
        set.clear();
        set.extend(around.curves_of(right).map(|curve| self.owners[curve]));
        set.sort_unstable();
        set.dedup();
        if set.len() == 1 {
            self.free.push(slot);
            return first;
        }
        self.single_count + slot
    }
}
