//! Two polytopes whose sum is not built.

use crate::{DirectionalPenetration, Penetration, Relation, Separation, Translation, Witness};
use exact::{Quaternion, Vector3};
use polytope::Polytope;

/// Two polytopes P and Q: the same queries as those of [`RelativePlacement`](crate::RelativePlacement), with Q turned
/// about the origin first and moved then.
#[derive(Clone, Copy, Debug)]
pub struct Pair<'p> {
    p: &'p Polytope,
    q: &'p Polytope,
}

impl<'p> Pair<'p> {
    /// Takes two polytopes.
    pub fn new(p: &'p Polytope, q: &'p Polytope) -> Self {
        Self { p, q }
    }

    /// Tells how P and Q, turned and then moved by s, lie to each other.
    pub fn relation(
        &self,
        s: &Translation,
        rotation: Option<&Quaternion>,
        hint: Option<Witness>,
    ) -> (Relation, Witness) {
        panic!("not yet {:?}", (self.p, self.q, s, rotation, hint))
    }

    /// Finds the distance of P and Q, turned and then moved by s.
    pub fn separation<'a>(
        &'a self,
        s: &'a Translation,
        rotation: Option<&'a Quaternion>,
        hint: Option<Witness>,
    ) -> Separation<'a> {
        panic!("not yet {:?}", (s, rotation, hint))
    }

    /// Finds how far Q, turned and then moved by s, has to go on in a direction until the interiors no longer meet;
    /// `None` if there is no such number: they overlap and the direction is the zero vector.
    pub fn directional_penetration<'a>(
        &'a self,
        s: &'a Translation,
        rotation: Option<&'a Quaternion>,
        direction: &'a Vector3,
        hint: Option<Witness>,
    ) -> Option<DirectionalPenetration<'a>> {
        panic!("not yet {:?}", (s, rotation, direction, hint))
    }

    /// Finds the shortest move after which the interiors no longer meet; `None` unless they overlap.
    pub fn minimum_penetration<'a>(
        &'a self,
        s: &'a Translation,
        rotation: Option<&'a Quaternion>,
        hint: Option<Witness>,
    ) -> Option<Penetration<'a>> {
        panic!("not yet {:?}", (s, rotation, hint))
    }
}
