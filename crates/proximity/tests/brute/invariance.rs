//! What must not change an answer: exchanged operands, exact rotations of both, scaling to any width, hints of any kind, one placement
//! after the other; and what brute force says of a second operand that is turned.

use crate::check::{Expected, Subject, relation, translation};
use crate::number::Triple;
use crate::pairs;
use crate::placements::{PARTS, placement, rational};
use crate::planes::{Brute, Place};
use crate::random::direction;
use crate::solid::common_scale;
use exact::{Affine3, Integer, Quaternion, Rational, Vector3};
use polytope::Polytope;
use splitstar_proximity::{
    Motion, Pair, Placement, Relation, RelativePlacement, Separation, Translation, Witness,
};
use testkit::{Rng, quaternion};

/// Placements of each pair.
const COUNT: usize = 90;

/// All answers about one placement.
#[derive(Clone, PartialEq, Debug)]
struct Answers {
    relation: Relation,
    squared_distance: Rational,
    squared_depth: Option<Rational>,
    along: Rational,
}

fn answers(subject: &Subject<'_>, s: &Translation, direction: &Vector3, hint: Option<Witness>) -> Answers {
    let separation = subject.separation(s, hint);
    Answers {
        relation: subject.relation(s, hint).0,
        squared_distance: separation.squared_distance(),
        squared_depth: subject.depth(s, hint).map(|penetration| penetration.squared_depth()),
        along: subject.along(s, direction, hint).expect("the direction is not zero").depth(),
    }
}

/// Random placements of every pair, with a direction.
fn for_all(seed: u64, mut test: impl FnMut(&pairs::Pair, &[(Translation, [i64; 3])], &mut Rng)) {
    println!("seed {seed}");
    let mut rng = Rng::new(seed);
    for pair in pairs::pairs().into_iter().chain(pairs::flat_pairs()) {
        let scale = common_scale(&pair.p, &pair.q) * Integer::from(PARTS);
        let brute = Brute::<i128>::new(&pair.p, &pair.q, scale.clone());
        let placements: Vec<(Translation, [i64; 3])> = (0..COUNT)
            .map(|number| {
                let s = placement(&brute, number, &mut rng).s;
                (translation(&s, &scale, number), direction(&mut rng))
            })
            .collect();
        test(&pair, &placements, &mut rng);
    }
}

fn negated(s: &Translation) -> Translation {
    Translation::new(&s.coordinates().map(|c| -c))
}

/// Runs a test on the library with its sum, and without.
fn for_both(p: &Polytope, q: &Polytope, mut test: impl FnMut(&Subject<'_>)) {
    let (sum, pair) = (RelativePlacement::new(p, q), Pair::new(p, q));
    test(&Subject::Sum(&sum));
    test(&Subject::Pair(&pair, None));
}

#[test]
fn operands_may_be_exchanged() {
    for_all(31, |pairs::Pair { name, p, q }, placements, _| {
        let reference = RelativePlacement::new(p, q);
        let reference = Subject::Sum(&reference);
        for_both(q, p, |exchanged| {
            for (s, direction) in placements {
                let opposite = Vector3::from_i64(direction.map(|c| -c));
                let expected = answers(&reference, s, &Vector3::from_i64(*direction), None);
                assert_eq!(answers(exchanged, &negated(s), &opposite, None), expected, "{name}: {s:?}");
            }
        });
    });
}

#[test]
fn both_may_be_turned() {
    for_all(32, |pairs::Pair { name, p, q }, placements, rng| {
        let reference = RelativePlacement::new(p, q);
        let reference = Subject::Sum(&reference);
        let components = [1, 0, 0, 0].map(|c: i64| 3 * c + rng.within(2));
        let turn = Affine3::rotation(&quaternion(components));
        let (turned_p, turned_q) = (p.transformed(&turn), q.transformed(&turn));
        let length: i64 = components.iter().map(|c| c * c).sum();
        for_both(&turned_p, &turned_q, |turned| {
            for (s, direction) in placements {
                let expected = answers(&reference, s, &Vector3::from_i64(*direction), None);
                let s = Translation::new(&turned_vector(&turn, &s.coordinates()));
                // The turned direction times the squared length of the quaternion.
                let direction = turned_vector(&turn, &direction.map(Rational::from));
                let direction = direction.map(|c| (c * Rational::from(length)).numerator());
                let mut found = answers(turned, &s, &Vector3::new(direction), None);
                found.along *= Rational::from(length);
                assert_eq!(found, expected, "{name}, quaternion {components:?}: {s:?}");
            }
        });
    });
}

fn turned_vector(turn: &Affine3, vector: &[Rational; 3]) -> [Rational; 3] {
    turn.apply(&exact::Point3::from_rationals(vector)).coordinates()
}

#[test]
fn all_may_be_scaled() {
    let wide = Rational::from(&(Integer::from(1_i64 << 40) * Integer::from(1_i64 << 40) + Integer::from(1)));
    let factors = [
        Rational::new(7.into(), 3.into()).expect("three is not zero"),
        wide.clone(),
        wide.recip().expect("wide is not zero"),
    ];
    for_all(33, |pairs::Pair { name, p, q }, placements, rng| {
        let reference = RelativePlacement::new(p, q);
        let reference = Subject::Sum(&reference);
        let factor = rng.choose(&factors);
        let scaling = Affine3::scaling(factor);
        for_both(&p.transformed(&scaling), &q.transformed(&scaling), |scaled| {
            for (s, direction) in placements {
                let direction = Vector3::from_i64(*direction);
                let expected = answers(&reference, s, &direction, None);
                let s = Translation::new(&s.coordinates().map(|c| c * factor));
                let found = answers(scaled, &s, &direction, None);
                assert_eq!(found.relation, expected.relation, "{name} times {factor}");
                let square = factor * factor;
                assert_eq!(
                    found.squared_distance,
                    &expected.squared_distance * &square,
                    "{name} times {factor}"
                );
                assert_eq!(
                    found.squared_depth,
                    expected.squared_depth.map(|d| d * &square),
                    "{name} times {factor}"
                );
                assert_eq!(found.along, expected.along * factor, "{name} times {factor}");
            }
        });
    });
}

/// All that a separation says.
fn said(separation: &Separation<'_>) -> String {
    let (points, features) = (separation.closest_points(), separation.features());
    format!("{:?} {} {points:?} {features:?}", separation.relation(), separation.squared_distance())
}

/// All that is said of penetration.
fn said_of_depth(
    subject: &Subject<'_>,
    s: &Translation,
    direction: &Vector3,
    hint: Option<Witness>,
) -> String {
    let along = subject.along(s, direction, hint).expect("the direction is not zero");
    let least = subject.depth(s, hint);
    let least = least.map(|found| (found.facet(), found.direction().coordinates(), found.features()));
    format!("{least:?} {:?}", along.depth())
}

#[test]
fn any_hint_will_do() {
    let mut foreign: Vec<Witness> = Vec::new();
    for_all(34, |pairs::Pair { name, p, q }, placements, rng| {
        for_both(p, q, |subject| {
            let mut hints: Vec<Witness> = foreign.clone();
            for (s, direction) in placements {
                let direction = Vector3::from_i64(*direction);
                let (expected, first) = (answers(subject, s, &direction, None), subject.separation(s, None));
                hints.extend([subject.relation(s, None).1, first.witness()]);
                hints.extend(subject.depth(s, None).map(|penetration| penetration.witness()));
                hints.extend(subject.along(s, &direction, None).map(|along| along.witness()));
                let hint = Some(*rng.choose(&hints));
                assert_eq!(answers(subject, s, &direction, hint), expected, "{name}: {s:?} {hint:?}");
                assert_eq!(said(&subject.separation(s, hint)), said(&first), "{name}: {s:?} {hint:?}");
                let [found, expected] = [hint, None].map(|hint| said_of_depth(subject, s, &direction, hint));
                assert_eq!(found, expected, "{name}: {s:?} {hint:?}");
            }
            // Of other polytopes, too.
            foreign.push(*rng.choose(&hints));
        });
    });
}

#[test]
fn a_motion_gives_the_answers_of_single_queries() {
    for_all(35, |pairs::Pair { name, p, q }, placements, _| {
        let translations: Vec<Translation> = placements.iter().map(|(s, _)| s.clone()).collect();
        let moves: Vec<Placement> =
            translations.iter().map(|s| Placement { rotation: None, translation: s.clone() }).collect();
        let (sum, pair) = (RelativePlacement::new(p, q), Pair::new(p, q));
        let single: Vec<String> = translations.iter().map(|s| said(&sum.separation(s, None))).collect();
        let found: Vec<String> =
            Motion::of_translations(&sum, &translations).map(|found| said(&found)).collect();
        assert_eq!(found, single, "{name}");
        // Of several shortest moves, this one may name another.
        let single: Vec<String> =
            translations.iter().map(|s| said(&pair.separation(s, None, None))).collect();
        let found: Vec<String> = Motion::of_placements(&pair, &moves).map(|found| said(&found)).collect();
        assert_eq!(found, single, "{name}");
    });
}

#[test]
fn the_second_may_be_turned() {
    let seed = 36;
    println!("seed {seed}");
    let mut rng = Rng::new(seed);
    for pairs::Pair { name, p, q } in pairs::pairs().into_iter().chain(pairs::flat_pairs()) {
        let pair = Pair::new(&p, &q);
        let mut moves = Vec::new();
        let mut expected_moves = Vec::new();
        for components in
            [[1, 0, 0, 0], [2, 0, 0, 0], [1, 1, 0, 0], [0, 1, 1, 0], [3, 1, 0, 0], [2, -1, 3, 1]]
        {
            let rotation: Quaternion = quaternion(components);
            let turned = q.transformed(&Affine3::rotation(&rotation));
            let scale = common_scale(&p, &turned) * Integer::from(PARTS);
            let brute = Brute::<Integer>::new(&p, &turned, scale.clone());
            let (sum, subject) = (RelativePlacement::new(&p, &turned), Subject::Pair(&pair, Some(&rotation)));
            for number in 0..12 {
                let made: Triple<Integer> = placement(&brute, number, &mut rng).s;
                let direction = direction(&mut rng);
                let s = Translation::new(&rational(&made, &scale));
                let expected = Expected::new(&brute, &made, direction, || brute.squared_distance(&made));
                let case =
                    format!("{name}, quaternion {components:?}, placement {number}: {made:?} over {scale}");
                subject.check(&s, direction, &expected, None, &case);
                subject.check_closest([&p, &turned], &s, &expected, &case);
                subject.check_direction(&brute, &made, &s, &case);
                let separation = sum.separation(&s, None);
                if expected.place != Place::Overlapping {
                    assert_eq!(said(&subject.separation(&s, None)), said(&separation), "{case}");
                }
                expected_moves.push((relation(expected.place), separation.squared_distance()));
                moves.push(Placement { rotation: Some(rotation.clone()), translation: s });
            }
        }
        let found =
            Motion::of_placements(&pair, &moves).map(|found| (found.relation(), found.squared_distance()));
        assert_eq!(found.collect::<Vec<_>>(), expected_moves, "{name}");
    }
}
