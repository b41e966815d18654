//! How often each method is called.

use super::{Method, Watch, WatchedTraits};
use std::fmt::Debug;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// The traits of any model, with a counter for each method.
///
/// Calls from outside count, not those that the methods of the model make of each other.
///
/// ```
/// use splitstar_arrangement::traits::BasicTraits;
/// use splitstar_arrangement::wrappers::{CountingTraits, Method};
///
/// fn least<'p, G: BasicTraits>(traits: G, points: &'p [G::Point]) -> (Option<&'p G::Point>, u64) {
///     let traits = CountingTraits::new(traits);
///     let least = points.iter().min_by(|p, q| traits.compare_uv(p, q));
///     (least, traits.counters().count(Method::CompareUv))
/// }
/// ```
pub type CountingTraits<G> = WatchedTraits<G, Counters>;

impl<G> CountingTraits<G> {
    /// Wraps the traits of a model; every counter is zero.
    pub fn new(traits: G) -> Self {
        Self { traits, watch: Counters::default() }
    }

    /// The counters.
    pub fn counters(&self) -> &Counters {
        &self.watch
    }
}

/// A counter for each method. Threads may count together.
#[derive(Debug)]
pub struct Counters([AtomicU64; Method::ALL.len()]);

impl Default for Counters {
    fn default() -> Self {
        Self(std::array::from_fn(|_| AtomicU64::new(0)))
    }
}

impl Counters {
    /// How often a method was called.
    pub fn count(&self, method: Method) -> u64 {
        self.0[method as usize].load(Relaxed)
    }

    /// The methods that were called, and how often.
    pub fn iter(&self) -> impl Iterator<Item = (Method, u64)> + '_ {
        Method::ALL.iter().map(|&method| (method, self.count(method))).filter(|&(_, count)| count > 0)
    }

    /// The number of calls.
    pub fn total(&self) -> u64 {
        self.iter().map(|(_, count)| count).sum()
    }

    /// Sets every counter to zero.
    pub fn reset(&self) {
        for counter in &self.0 {
            counter.store(0, Relaxed);
        }
    }
}

impl Watch for Counters {
    #[inline]
    fn watch(&self, method: Method, _: &[&dyn Debug], _: &dyn Debug) {
        self.0[method as usize].fetch_add(1, Relaxed);
    }
}
