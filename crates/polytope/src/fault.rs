//! Faults that tests inject, to see that the oracles catch them (feature `faults`; nothing otherwise).

/// A mistake that the code makes on purpose.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(not(feature = "faults"), expect(unreachable_pub, reason = "public with the feature only"))]
pub enum Fault {
    /// The normal of the last crossing points inwards.
    FlippedNormal,
    /// An edge of the sum is left out.
    DroppedEdge,
    /// The end of an arc on an arc of the other map counts as inside the face.
    ZeroAsPositive,
    /// A vertex of the sum is made from the wrong summand vertex.
    WrongVertex,
    /// The digons that cut long arcs stay in the sum.
    SkippedDigons,
    /// Coplanar triangles of a hull are not merged.
    SkippedMerge,
}

#[cfg(feature = "faults")]
mod injection {
    use super::Fault;
    use std::cell::Cell;

    thread_local! {
        static INJECTED: Cell<Option<Fault>> = const { Cell::new(None) };
    }

    /// Runs `work` with a fault in all that this thread computes. The fault ends even if `work` panics.
    pub fn with_fault<T>(fault: Fault, work: impl FnOnce() -> T) -> T {
        struct Reset;
        impl Drop for Reset {
            fn drop(&mut self) {
                INJECTED.set(None);
            }
        }
        INJECTED.set(Some(fault));
        let _reset = Reset;
        work()
    }

    pub(crate) fn injected(fault: Fault) -> bool {
        INJECTED.get() == Some(fault)
    }
}

#[cfg(feature = "faults")]
pub(crate) use injection::injected;
#[cfg(feature = "faults")]
pub use injection::with_fault;

/// Whether the fault is injected: never without the feature.
#[cfg(not(feature = "faults"))]
#[inline(always)]
pub(crate) fn injected(_: Fault) -> bool {
    false
}
