//! One placement: every answer of the library beside that of brute force.

use crate::contact::{common_corners, first, holds_rational, is_smallest_face, moved, vertices_of};
use crate::number::{Fraction, Number, Triple, negated};
use crate::placements::rational;
use crate::planes::{Brute, Place};
use crate::solid::Solid;
use exact::{Integer, Quaternion, Rational, Vector3};
use polytope::Polytope;
use splitstar_proximity::{
    DirectionalPenetration, Pair, Penetration, Relation, RelativePlacement, Separation, Translation, Witness,
};
use std::cmp::Ordering;

pub(crate) fn relation(place: Place) -> Relation {
    match place {
        Place::Disjoint => Relation::Disjoint,
        Place::Touching => Relation::Touching,
        Place::Overlapping => Relation::Overlapping,
    }
}

/// What brute force says about one placement.
#[derive(Debug)]
pub(crate) struct Expected {
    pub(crate) place: Place,
    pub(crate) squared_distance: Rational,
    pub(crate) squared_depth: Option<Rational>,
    /// How often `q` has to be moved by the direction until interiors do not meet.
    pub(crate) along: Rational,
}

impl Expected {
    pub(crate) fn new<N: Number>(
        brute: &Brute<N>,
        s: &Triple<N>,
        direction: [i64; 3],
        squared_distance: impl Fn() -> Fraction<N>,
    ) -> Self {
        let place = brute.place(s);
        let squared_scale = &brute.scale * &brute.scale;
        let zero = || Rational::from(0);
        let is_overlapping = place == Place::Overlapping;
        let direction = direction.map(|c| N::of(&Integer::from(c)));
        Self {
            place,
            squared_distance: match place {
                Place::Disjoint => squared_distance().rational(&squared_scale),
                _ => zero(),
            },
            squared_depth: is_overlapping.then(|| brute.minimum_penetration(s).rational(&squared_scale)),
            along: match is_overlapping {
                true => brute.directional_penetration(s, &direction).rational(&brute.scale),
                false => zero(),
            },
        }
    }
}

/// The library with its sum, or without; `q` turned by a rotation before.
#[derive(Clone, Copy)]
pub(crate) enum Subject<'a> {
    Sum(&'a RelativePlacement),
    Pair(&'a Pair<'a>, Option<&'a Quaternion>),
}

impl Subject<'_> {
    pub(crate) fn relation(&self, s: &Translation, hint: Option<Witness>) -> (Relation, Witness) {
        match self {
            Self::Sum(sum) => sum.relation(s, hint),
            Self::Pair(pair, rotation) => pair.relation(s, *rotation, hint),
        }
    }

    pub(crate) fn separation<'b>(&'b self, s: &'b Translation, hint: Option<Witness>) -> Separation<'b> {
        match self {
            Self::Sum(sum) => sum.separation(s, hint),
            Self::Pair(pair, rotation) => pair.separation(s, *rotation, hint),
        }
    }

    pub(crate) fn along<'b>(
        &'b self,
        s: &'b Translation,
        direction: &'b Vector3,
        hint: Option<Witness>,
    ) -> Option<DirectionalPenetration<'b>> {
        match self {
            Self::Sum(sum) => sum.directional_penetration(s, direction, hint),
            Self::Pair(pair, rotation) => pair.directional_penetration(s, *rotation, direction, hint),
        }
    }

    pub(crate) fn depth<'b>(&'b self, s: &'b Translation, hint: Option<Witness>) -> Option<Penetration<'b>> {
        match self {
            Self::Sum(sum) => sum.minimum_penetration(s, hint),
            Self::Pair(pair, rotation) => pair.minimum_penetration(s, *rotation, hint),
        }
    }

    /// Asks all questions and compares the answers; returns where the last one has ended.
    pub(crate) fn check(
        &self,
        s: &Translation,
        direction: [i64; 3],
        expected: &Expected,
        hint: Option<Witness>,
        case: &str,
    ) -> Witness {
        let (found, witness) = self.relation(s, hint);
        assert_eq!(found, relation(expected.place), "relation: {case}");
        let separation = self.separation(s, hint.map(|_| witness));
        assert_eq!(separation.relation(), relation(expected.place), "relation with the distance: {case}");
        assert_eq!(separation.squared_distance(), expected.squared_distance, "squared distance: {case}");
        let penetration = self.depth(s, hint);
        let squared_depth = penetration.as_ref().map(Penetration::squared_depth);
        assert_eq!(squared_depth, expected.squared_depth, "squared depth: {case}");
        let direction = Vector3::from_i64(direction);
        let along = self.along(s, &direction, hint).expect("the direction is not zero");
        assert_eq!(along.depth(), expected.along, "depth along {direction:?}: {case}");
        assert_eq!(along.relation(), relation(expected.place), "relation with the depth: {case}");
        separation.witness()
    }

    /// Compares the direction and the features of the penetration: those of a facet at this depth.
    pub(crate) fn check_direction<N: Number>(
        &self,
        brute: &Brute<N>,
        s: &Triple<N>,
        translation: &Translation,
        case: &str,
    ) {
        let Some(penetration) = self.depth(translation, None) else { return };
        let normal = penetration.direction().coordinates();
        assert_eq!(Vector3::new(normal.clone()).primitive().coordinates(), normal, "primitive: {case}");
        let normal = normal.each_ref().map(N::of);
        let (sign, squared) = brute.gap(&normal, s);
        assert_eq!((sign, &squared), (Ordering::Less, &penetration.squared_depth()), "direction: {case}");
        let extreme = [brute.p.extreme(&normal).1, brute.q.extreme(&negated(&normal)).1];
        let [of_p, of_q] = penetration.features();
        let features = [vertices_of(of_p, &brute.p), vertices_of(of_q, &brute.q)];
        assert_eq!(features, extreme, "features of the facet: {case}");
    }

    /// Checks that the closest points belong to the polytopes and are as far apart as brute force says; if the polytopes overlap, that
    /// they are one common point. `solids` are the polytopes over the scale, before the translation.
    pub(crate) fn check_membership(
        &self,
        solids: &[Solid<Integer>; 2],
        scale: &Integer,
        s: &Translation,
        expected: &Expected,
        hint: Option<Witness>,
        case: &str,
    ) {
        let [a, b] = self.separation(s, hint).closest_points();
        let away: [Rational; 3] = [0, 1, 2].map(|i: usize| &a[i] - &b[i]);
        let squared: Rational = away.iter().map(|c| c * c).sum();
        assert_eq!(squared, expected.squared_distance, "distance of the closest points: {case}");
        assert!(holds_rational(&solids[0], scale, &a), "the first closest point {a:?}: {case}");
        let s = s.coordinates();
        let b = [0, 1, 2].map(|i: usize| &b[i] - &s[i]);
        assert!(holds_rational(&solids[1], scale, &b), "the second closest point, moved back, {b:?}: {case}");
    }

    /// Compares the closest points, and the features that hold them, with all that the polytopes have in common once `q` is moved by the
    /// difference of these points.
    pub(crate) fn check_closest(
        &self,
        [p, q]: [&Polytope; 2],
        s: &Translation,
        expected: &Expected,
        case: &str,
    ) {
        let separation = self.separation(s, None);
        let [a, b] = separation.closest_points();
        let by: [Rational; 3] = [0, 1, 2].map(|i| &a[i] - &b[i]);
        let squared: Rational = by.iter().map(|c| c * c).fold(Rational::from(0), |sum, c| sum + c);
        assert_eq!(squared, expected.squared_distance, "distance of the closest points: {case}");
        let total: [Rational; 3] = {
            let s = s.coordinates();
            [0, 1, 2].map(|i| &s[i] + &by[i])
        };
        let scale = total
            .iter()
            .chain(&a)
            .fold(crate::solid::common_scale(p, q), |scale, c| scale.lcm(&c.denominator()));
        let integer = |c: &Rational| (c * &Rational::from(&scale)).numerator();
        let zero = [0; 3].map(Integer::from);
        let (p, q) = (moved(p, &scale, &zero), moved(q, &scale, &total.each_ref().map(integer)));
        if expected.place == Place::Overlapping {
            let point = a.each_ref().map(integer);
            for solid in [&p, &q] {
                assert!(crate::contact::holds(solid, &point), "a common point: {case}");
            }
            return;
        }
        let corners = common_corners(&p, &q);
        assert_eq!(Some(&a), first(&corners, &scale).as_ref(), "the first closest point: {case}");
        let [of_p, of_q] = separation.features();
        assert!(is_smallest_face(of_p, &p, &corners), "{of_p} of the first: {case}");
        assert!(is_smallest_face(of_q, &q, &corners), "{of_q} of the second: {case}");
    }
}

/// A translation, made in one of the ways in which it can be.
pub(crate) fn translation<N: Number>(s: &Triple<N>, scale: &Integer, way: usize) -> Translation {
    let exact = rational(s, scale);
    let floats = exact.each_ref().map(Rational::approx_f64);
    let is_float =
        exact.iter().zip(floats).all(|(c, float)| Rational::try_from(float).is_ok_and(|f| f == *c));
    let integers = exact.each_ref().map(|c| c.is_integer().then(|| c.numerator().to_i64()).flatten());
    match integers {
        [Some(x), Some(y), Some(z)] if way.is_multiple_of(2) => Translation::from_i64([x, y, z]),
        _ if way.is_multiple_of(2) && is_float => Translation::from_f64(floats).expect("floats are finite"),
        _ => Translation::new(&exact),
    }
}
