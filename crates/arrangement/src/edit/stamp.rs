//! Stamps: which state of an arrangement something belongs to.

use crate::arrangement::Arrangement;
use crate::traits::BasicTraits;
use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};

/// Names a state of an arrangement.
///
/// Laws:
/// 1. Every change of an arrangement gives it a stamp that no arrangement had before.
/// 2. Two arrangements with equal stamps have equal contents: a clone keeps the stamp until one of them is changed.
///
/// Equal contents may have different stamps. The number means nothing, and differs from run to run if several threads make
/// arrangements: it goes into no result.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Stamp(u64);

impl Stamp {
    /// A stamp that nobody has.
    pub(crate) fn fresh() -> Self {
        // 2^64 edits take longer than anybody waits.
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}

impl fmt::Debug for Stamp {
    /// The number is left out, so that equal arrangements are shown alike.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Stamp")
    }
}

impl<G: BasicTraits, T> Arrangement<G, T> {
    /// The stamp of the present state: another one after every change.
    pub fn stamp(&self) -> Stamp {
        self.stamp
    }
}

/// Something belongs to another state of the arrangement than the present one, or to another arrangement.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Stale {
    /// The state to which it belongs.
    pub stamp: Stamp,
    /// The state of the arrangement.
    pub of_arrangement: Stamp,
}

impl Stale {
    /// Tells whether something that belongs to the state `stamp` is usable with an arrangement in the state `of_arrangement`.
    ///
    /// # Errors
    /// If the stamps are different.
    pub fn check(stamp: Stamp, of_arrangement: Stamp) -> Result<(), Self> {
        if stamp == of_arrangement { Ok(()) } else { Err(Self { stamp, of_arrangement }) }
    }
}

impl fmt::Display for Stale {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the arrangement was changed since, or is another one")
    }
}

impl std::error::Error for Stale {}

/// A value with the state of the arrangement that it was made for: a property map, a list of cells, an index.
///
/// Ids of removed cells are used again, so that a map that was not kept up to date would give wrong values without a sign. Here it
/// gives an error.
///
/// # Examples
///
/// ```
/// use dcel::FaceMap;
/// use exact::planar::Point2;
/// use splitstar_arrangement::edit::Stamped;
/// use splitstar_arrangement::{Arrangement, models::SegmentTraits, topology::BoundedPlane};
///
/// let mut arrangement = Arrangement::new(SegmentTraits, BoundedPlane);
/// let colours = FaceMap::filled(arrangement.dcel(), "white");
/// let mut colours = Stamped::new(&arrangement, colours);
/// assert_eq!(colours.get(&arrangement)?[arrangement.corner_face()], "white");
///
/// arrangement.insert_points([Point2::from_i64([1, 2])]);
/// let error = colours.get(&arrangement).expect_err("it was changed");
/// assert_eq!(error.to_string(), "the arrangement was changed since, or is another one");
///
/// // A point makes no face: whoever knows that may go on.
/// colours.renew(&arrangement);
/// assert!(colours.get(&arrangement).is_ok());
/// # Ok::<(), splitstar_arrangement::edit::Stale>(())
/// ```
#[derive(Clone, Debug)]
pub struct Stamped<M> {
    value: M,
    stamp: Stamp,
}

impl<M> Stamped<M> {
    /// Makes a value that is for the present state of an arrangement.
    pub fn new<G: BasicTraits, T>(arrangement: &Arrangement<G, T>, value: M) -> Self {
        Self { value, stamp: arrangement.stamp() }
    }

    /// The state for which the value is.
    pub fn stamp(&self) -> Stamp {
        self.stamp
    }

    /// Tells whether the value is for the present state of an arrangement.
    pub fn is_current<G: BasicTraits, T>(&self, arrangement: &Arrangement<G, T>) -> bool {
        self.stamp == arrangement.stamp()
    }

    /// The value.
    ///
    /// # Errors
    /// If it is not for the present state of the arrangement.
    pub fn get<G: BasicTraits, T>(&self, arrangement: &Arrangement<G, T>) -> Result<&M, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        Ok(&self.value)
    }

    /// The value, to be changed.
    ///
    /// # Errors
    /// If it is not for the present state of the arrangement.
    pub fn get_mut<G: BasicTraits, T>(&mut self, arrangement: &Arrangement<G, T>) -> Result<&mut M, Stale> {
        Stale::check(self.stamp, arrangement.stamp())?;
        Ok(&mut self.value)
    }

    /// Declares that the value is for the present state of an arrangement, and gives it to be made so.
    pub fn renew<G: BasicTraits, T>(&mut self, arrangement: &Arrangement<G, T>) -> &mut M {
        self.stamp = arrangement.stamp();
        &mut self.value
    }

    /// The value, whatever state it is for.
    pub fn into_inner(self) -> M {
        self.value
    }
}
