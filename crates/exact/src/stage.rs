//! Which tier decided: counters (feature `count-tiers`), and where to begin (feature `force-tiers`). The unit tests of this
//! crate have both.

/// A step of the cascades at which a predicate can be decided.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Stage {
    /// Exact in 128 bits, because the widths at hand allow it; no filter was tried.
    Narrow,
    /// The semi-static float filter.
    Float,
    /// Fixed-width integers, exact.
    Fixed,
    /// Intervals around the cached floats.
    Interval,
    /// Integers of any size, exact.
    Big,
}

impl Stage {
    /// All stages, from the cheapest.
    pub const ALL: [Self; 5] = [Self::Narrow, Self::Float, Self::Fixed, Self::Interval, Self::Big];
}

#[cfg(not(any(test, feature = "count-tiers")))]
#[inline(always)]
pub(crate) fn count(_stage: Stage) {}

/// Tells whether a test says where to begin, so that no shortcut and no narrow tier is taken.
#[inline(always)]
pub(crate) fn is_forced() -> bool {
    #[cfg(any(test, feature = "force-tiers"))]
    {
        start() != Start::Usual
    }
    #[cfg(not(any(test, feature = "force-tiers")))]
    false
}

/// Tells whether a test wants the boxes to be skipped.
#[inline(always)]
pub(crate) fn are_boxes_skipped() -> bool {
    #[cfg(any(test, feature = "force-tiers"))]
    {
        !matches!(start(), Start::Usual | Start::Float)
    }
    #[cfg(not(any(test, feature = "force-tiers")))]
    false
}

/// Tells whether a test wants integers of any size where there are no intervals, because boxes are what these could tell.
#[inline(always)]
pub(crate) fn is_big_forced() -> bool {
    #[cfg(any(test, feature = "force-tiers"))]
    {
        matches!(start(), Start::Interval | Start::Big)
    }
    #[cfg(not(any(test, feature = "force-tiers")))]
    false
}

#[cfg(any(test, feature = "count-tiers"))]
pub(crate) use counting::count;
#[cfg(any(test, feature = "count-tiers"))]
pub use counting::{Counts, counts, thread_counts};

#[cfg(any(test, feature = "count-tiers"))]
mod counting {
    use super::Stage;
    use std::cell::Cell;
    use std::ops::Sub;
    use std::sync::atomic::{AtomicU64, Ordering};

    /// How many predicates each stage decided. Counters only grow: take differences.
    #[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
    pub struct Counts {
        /// Decided in 128 bits without a filter.
        pub narrow: u64,
        /// Decided by the float filter.
        pub float: u64,
        /// Decided by fixed-width integers.
        pub fixed: u64,
        /// Decided by intervals.
        pub interval: u64,
        /// Decided by integers of any size.
        pub big: u64,
    }

    impl Counts {
        fn from_array([narrow, float, fixed, interval, big]: [u64; 5]) -> Self {
            Self { narrow, float, fixed, interval, big }
        }

        /// Gives how many predicates this stage decided.
        pub fn of(&self, stage: Stage) -> u64 {
            match stage {
                Stage::Narrow => self.narrow,
                Stage::Float => self.float,
                Stage::Fixed => self.fixed,
                Stage::Interval => self.interval,
                Stage::Big => self.big,
            }
        }

        /// Gives the number of all predicates decided.
        pub fn total(&self) -> u64 {
            Stage::ALL.iter().map(|&stage| self.of(stage)).sum()
        }
    }

    impl Sub for Counts {
        type Output = Self;
        fn sub(self, earlier: Self) -> Self {
            Self {
                narrow: self.narrow - earlier.narrow,
                float: self.float - earlier.float,
                fixed: self.fixed - earlier.fixed,
                interval: self.interval - earlier.interval,
                big: self.big - earlier.big,
            }
        }
    }

    static TOTAL: [AtomicU64; 5] = [const { AtomicU64::new(0) }; 5];

    thread_local! {
        static OF_THREAD: [Cell<u64>; 5] = const { [const { Cell::new(0) }; 5] };
    }

    #[inline]
    pub(crate) fn count(stage: Stage) {
        TOTAL[stage as usize].fetch_add(1, Ordering::Relaxed);
        OF_THREAD.with(|counters| {
            let counter = &counters[stage as usize];
            counter.set(counter.get() + 1);
        });
    }

    /// Gives the counts of the whole process since its start.
    pub fn counts() -> Counts {
        Counts::from_array([0, 1, 2, 3, 4].map(|i: usize| TOTAL[i].load(Ordering::Relaxed)))
    }

    /// Gives the counts of the calling thread since its start.
    pub fn thread_counts() -> Counts {
        OF_THREAD.with(|counters| Counts::from_array([0, 1, 2, 3, 4].map(|i: usize| counters[i].get())))
    }
}

#[cfg(any(test, feature = "force-tiers"))]
pub(crate) use forcing::start;
#[cfg(any(test, feature = "force-tiers"))]
pub use forcing::{Guard, Start, force};

#[cfg(any(test, feature = "force-tiers"))]
mod forcing {
    use std::sync::atomic::{AtomicU8, Ordering};
    use std::sync::{Mutex, MutexGuard, PoisonError};

    /// Where the evaluation of every predicate begins; from there it goes on when undecided.
    #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
    #[repr(u8)]
    pub enum Start {
        /// As without forcing. Holds the lock, so that nobody else forces meanwhile.
        Usual = 0,
        /// The float filter, even where 128 bits suffice; then fixed width, or intervals and big integers if too wide.
        Float,
        /// Fixed width without a filter; big integers if too wide.
        Fixed,
        /// Intervals, then big integers, even for narrow input.
        Interval,
        /// Big integers at once.
        Big,
    }

    impl Start {
        /// All that force something.
        pub const FORCED: [Self; 4] = [Self::Float, Self::Fixed, Self::Interval, Self::Big];
    }

    static START: AtomicU8 = AtomicU8::new(Start::Usual as u8);
    static LOCK: Mutex<()> = Mutex::new(());

    /// Keeps a tier forced; dropping it ends that.
    #[must_use = "the forcing ends when the guard is dropped"]
    #[derive(Debug)]
    pub struct Guard {
        _lock: MutexGuard<'static, ()>,
    }

    impl Drop for Guard {
        fn drop(&mut self) {
            START.store(Start::Usual as u8, Ordering::SeqCst);
        }
    }

    /// Makes every predicate of the process begin at one tier, in all threads, as long as the guard lives.
    ///
    /// Waits while another guard lives: a thread that holds one and asks for a second waits forever.
    pub fn force(start: Start) -> Guard {
        // A test that failed while it held the lock has left nothing broken behind: Drop has reset the start.
        let lock = LOCK.lock().unwrap_or_else(PoisonError::into_inner);
        START.store(start as u8, Ordering::SeqCst);
        Guard { _lock: lock }
    }

    #[inline]
    pub(crate) fn start() -> Start {
        match START.load(Ordering::Relaxed) {
            1 => Start::Float,
            2 => Start::Fixed,
            3 => Start::Interval,
            4 => Start::Big,
            _ => Start::Usual,
        }
    }
}

#[cfg(test)]
mod tests;
