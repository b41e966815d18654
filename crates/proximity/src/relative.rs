//! Two polytopes whose sum is kept.

use crate::{DirectionalPenetration, Penetration, Relation, Separation, Translation, Witness};
use exact::Vector3;
use polytope::{Polytope, minkowski_sum};

/// Two polytopes P and Q, and the Minkowski sum M of P and the reflection of Q.
#[derive(Clone, Debug)]
pub struct RelativePlacement {
    sum: Polytope,
}

impl RelativePlacement {
    /// Builds M.
    pub fn new(p: &Polytope, q: &Polytope) -> Self {
        Self { sum: minkowski_sum(&[p, &q.reflected()]) }
    }

    /// Gives M.
    pub fn sum(&self) -> &Polytope {
        &self.sum
    }

    /// Tells how P and Q, moved by s, lie to each other.
    pub fn relation(&self, s: &Translation, hint: Option<Witness>) -> (Relation, Witness) {
        panic!("not yet {:?}", (s, hint))
    }

    /// Finds the distance of P and Q moved by s.
    pub fn separation<'a>(&'a self, s: &'a Translation, hint: Option<Witness>) -> Separation<'a> {
        panic!("not yet {:?}", (s, hint))
    }

    /// Finds how far Q, moved by s, has to go on in a direction until the interiors no longer meet; `None` if there
    /// is no such number: they overlap and the direction is the zero vector.
    pub fn directional_penetration<'a>(
        &'a self,
        s: &'a Translation,
        direction: &'a Vector3,
        hint: Option<Witness>,
    ) -> Option<DirectionalPenetration<'a>> {
        panic!("not yet {:?}", (s, direction, hint))
    }

    /// Finds the shortest move after which the interiors of P and Q, moved by s, no longer meet; `None` unless they overlap.
    pub fn minimum_penetration<'a>(
        &'a self,
        s: &'a Translation,
        hint: Option<Witness>,
    ) -> Option<Penetration<'a>> {
        panic!("not yet {:?}", (s, hint))
    }
}
