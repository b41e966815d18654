//! Two polytopes whose sum is not built.

use crate::answer::Place;
use crate::bodies::Bodies;
use crate::expansion::{Exit, Expansion};
use crate::simplex::nearest;
use crate::{
    DirectionalPenetration, Penetration, Relation, RelativePlacement, Separation, Translation, Witness,
};
use exact::{Affine3, Quaternion, Vector3};
use polytope::Polytope;

/// Two polytopes P and Q of any dimension: the same queries as those of [`RelativePlacement`](crate::RelativePlacement), with Q
/// turned about the origin first and moved then.
///
/// M is not built. The queries ask which vertices of P and Q are extreme in one direction after the other, and find these
/// by walking on both polytopes at once, from the last ones. So only the features met are computed, and turned; this is the way for a
/// single query, and for a Q that turns with each one. The answers are exactly those of the sum.
///
/// ```
/// use exact::{Point3, Quaternion};
/// use polytope::convex_hull;
/// use splitstar_proximity::{Pair, Translation};
/// let corners: Vec<_> = (0..8).map(|i| Point3::from_i64([i >> 2, i >> 1 & 1, i & 1])).collect();
/// let cube = convex_hull(&corners).expect("there are points");
/// let eighth = Quaternion::new([5, 0, 0, 2].map(Into::into)).expect("not all are zero");
/// let s = Translation::from_i64([3, 0, 0]);
/// let pair = Pair::new(&cube, &cube);
/// assert_eq!(pair.separation(&s, None, None).squared_distance().to_string(), "4");
/// assert_eq!(pair.separation(&s, Some(&eighth), None).squared_distance().to_string(), "1444/841");
/// ```
///
/// # References
/// Thesis, section 6.4.
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
        let bodies = Bodies::new(self.p, self.q, rotation);
        let near = nearest(&bodies, s.point(), bodies.start(hint), true);
        let of = near.corners[0].of;
        if !near.direction.is_zero() {
            return (Relation::Disjoint, Witness::of_vertices(of));
        }
        match Expansion::new(&bodies, &s.0, of) {
            Some(mut hull) => {
                let (relation, of) = hull.relation();
                (relation, Witness::of_vertices(of))
            }
            None => (Relation::Touching, Witness::of_vertices(of)),
        }
    }

    /// Finds the distance of P and Q, turned and then moved by s.
    pub fn separation<'a>(
        &'a self,
        s: &'a Translation,
        rotation: Option<&'a Quaternion>,
        hint: Option<Witness>,
    ) -> Separation<'a> {
        self.separation_of(s, rotation, hint)
    }

    pub(crate) fn separation_of<'a>(
        &self,
        s: &'a Translation,
        rotation: Option<&'a Quaternion>,
        hint: Option<Witness>,
    ) -> Separation<'a>
    where
        'p: 'a,
    {
        let bodies = Bodies::new(self.p, self.q, rotation);
        let mut near = nearest(&bodies, s.point(), bodies.start(hint), false);
        let mut of = near.corners[0].of;
        let mut relation = Relation::Disjoint;
        if near.direction.is_zero() {
            relation = Relation::Touching;
            if let Some(mut hull) = Expansion::new(&bodies, &s.0, of) {
                (relation, of) = hull.relation();
                near.normal = Some(hull.normal_at(relation));
            }
        }
        let place = Place::Pair(self.p, self.q, rotation);
        Separation { relation, witness: Witness::of_vertices(of), place, s, near: Some(Box::new(near)) }
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
        self.directional_penetration_of(s, rotation, direction, hint)
    }

    pub(crate) fn directional_penetration_of<'a>(
        &self,
        s: &'a Translation,
        rotation: Option<&'a Quaternion>,
        direction: &'a Vector3,
        hint: Option<Witness>,
    ) -> Option<DirectionalPenetration<'a>>
    where
        'p: 'a,
    {
        let bodies = Bodies::new(self.p, self.q, rotation);
        let (relation, witness) = self.relation(s, rotation, hint);
        let mut found = DirectionalPenetration {
            relation,
            witness,
            place: Place::Pair(self.p, self.q, rotation),
            s,
            direction,
            exit: None,
        };
        if relation == Relation::Overlapping {
            if direction.is_zero() {
                return None;
            }
            let mut hull = around(&bodies, s, Some(witness));
            let exit = hull.exit(direction);
            found.witness = Witness::of_vertices(exit.of);
            found.exit = Some(Box::new(exit));
        }
        Some(found)
    }

    /// Finds the shortest move after which the interiors no longer meet; `None` unless they overlap.
    pub fn minimum_penetration<'a>(
        &'a self,
        s: &'a Translation,
        rotation: Option<&'a Quaternion>,
        hint: Option<Witness>,
    ) -> Option<Penetration<'a>> {
        let bodies = Bodies::new(self.p, self.q, rotation);
        let (relation, witness) = self.relation(s, rotation, hint);
        if relation != Relation::Overlapping {
            return None;
        }
        // Begun anew: of several nearest facets the same one is found for any hint.
        let mut hull = around(&bodies, s, None);
        let exit = hull.nearest_plane(LIMIT).unwrap_or_else(|| self.by_sum(s, rotation, witness));
        let witness = Witness::of_vertices(exit.of);
        let place = Place::Pair(self.p, self.q, rotation);
        Some(Penetration { witness, place, s, exit: Some(Box::new(exit)) })
    }

    /// The nearest facet, found by building M.
    fn by_sum(&self, s: &Translation, rotation: Option<&Quaternion>, witness: Witness) -> Exit {
        let turned = rotation.map(|rotation| self.q.transformed(&Affine3::rotation(rotation)));
        let sum = RelativePlacement::new(self.p, turned.as_ref().unwrap_or(self.q));
        let found = sum.minimum_penetration(s, None).expect("the polytopes overlap");
        let bodies = Bodies::new(self.p, self.q, rotation);
        let normal = found.direction();
        let of = bodies.extreme(&normal, bodies.start(Some(witness)));
        Exit { depth: found.squared_depth(), normal, of }
    }
}

/// The greatest number of vertices of a hull that is searched for the nearest facet. Many more are needed if all facets of M
/// are nearly as far from s; then M is built, in less time.
const LIMIT: usize = 1000;

/// A hull with s in its interior, for polytopes that overlap.
fn around<'b>(bodies: &'b Bodies<'b>, s: &'b Translation, hint: Option<Witness>) -> Expansion<'b> {
    let start = bodies.start(hint);
    let mut hull =
        Expansion::new(bodies, &s.0, start).expect("polytopes whose sum lies in a plane do not overlap");
    hull.relation();
    hull
}
