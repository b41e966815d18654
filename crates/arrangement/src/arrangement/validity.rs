//! Every violation of what an arrangement promises.

use super::Arrangement;
use crate::topology::Topology;
use crate::traits::BasicTraits;

/// A broken promise of an arrangement.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Violation {}

impl<G: BasicTraits, T: Topology<G>> Arrangement<G, T> {
    /// Looks for violations.
    pub fn check_valid(&self) -> Vec<Violation> {
        Vec::new()
    }
}
