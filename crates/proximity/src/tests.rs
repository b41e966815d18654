//! The two routes to each answer, with M and without, against each other.

use crate::{Pair, Relation, RelativePlacement, Translation, Witness};
use exact::{Affine3, Quaternion, Rational, Vector3};
use polytope::Polytope;
use testkit::{Rng, hull_of_dimension, mixed_width_hull, quaternion, random_hull, weighted_hull};

/// What the queries say of one placement, as texts.
fn by_sum(of: &RelativePlacement, s: &Translation, r: &Vector3, hint: &mut Option<Witness>) -> Vec<String> {
    let separation = of.separation(s, *hint);
    let relation = separation.relation();
    let mut said = vec![format!("{relation:?}"), separation.squared_distance().to_string()];
    if relation != Relation::Overlapping {
        said.push(format!("{:?} {:?}", separation.closest_points(), separation.features()));
    }
    let (again, witness) = of.relation(s, *hint);
    said.push(format!("{again:?}"));
    said.push(format!("{:?}", of.directional_penetration(s, r, *hint).map(|found| found.depth())));
    said.push(format!("{:?}", of.minimum_penetration(s, *hint).map(|found| found.squared_depth())));
    check_points(&separation.closest_points(), &separation.squared_distance());
    *hint = Some(if relation == Relation::Touching { witness } else { separation.witness() });
    said
}

fn by_pair(
    of: &Pair<'_>,
    s: &Translation,
    rotation: Option<&Quaternion>,
    r: &Vector3,
    hint: &mut Option<Witness>,
) -> Vec<String> {
    let separation = of.separation(s, rotation, *hint);
    let relation = separation.relation();
    let mut said = vec![format!("{relation:?}"), separation.squared_distance().to_string()];
    if relation != Relation::Overlapping {
        said.push(format!("{:?} {:?}", separation.closest_points(), separation.features()));
    }
    let (again, witness) = of.relation(s, rotation, *hint);
    said.push(format!("{again:?}"));
    let found = of.directional_penetration(s, rotation, r, *hint);
    said.push(format!("{:?}", found.map(|found| found.depth())));
    let found = of.minimum_penetration(s, rotation, *hint);
    said.push(format!("{:?}", found.map(|found| found.squared_depth())));
    *hint = Some(if relation == Relation::Touching { witness } else { separation.witness() });
    said
}

fn check_points([a, b]: &[[Rational; 3]; 2], squared_distance: &Rational) {
    let away = [0, 1, 2].map(|i: usize| &a[i] - &b[i]);
    let square: Rational = away.iter().map(|c| c * c).sum();
    assert_eq!(square, *squared_distance);
}

/// A translation that is anywhere, on a grid, or puts a vertex upon a vertex.
fn translation(rng: &mut Rng, p: &Polytope, q: &Polytope, range: i64) -> Translation {
    match rng.below(4) {
        0 => Translation::from_f64([0; 3].map(|_: u8| rng.within(range * 1000) as f64 / 1000.0))
            .expect("the numbers are finite"),
        1 => Translation::from_i64([0; 3].map(|_: u8| rng.within(range))),
        2 => Translation::new(
            &[0; 3]
                .map(|_: u8| Rational::new(rng.within(6 * range).into(), 6.into()).expect("six is not zero")),
        ),
        _ => {
            let a = rng.choose(p.points()).coordinates();
            let b = rng.choose(q.points()).coordinates();
            Translation::new(&[0, 1, 2].map(|i: usize| &a[i] - &b[i]))
        }
    }
}

fn check(rng: &mut Rng, p: &Polytope, q: &Polytope, rotation: Option<&Quaternion>, count: usize, range: i64) {
    let turned = rotation.map_or_else(|| q.clone(), |rotation| q.transformed(&Affine3::rotation(rotation)));
    let (sum, pair) = (RelativePlacement::new(p, &turned), Pair::new(p, q));
    let (mut first, mut second) = (None, None);
    for _ in 0..count {
        let s = translation(rng, p, &turned, range);
        let r = Vector3::from_i64([0; 3].map(|_: u8| rng.within(3)));
        let context = format!("{:?} {:?} {:?} {r:?} {rotation:?}", p.points(), q.points(), s.coordinates());
        let expected = by_sum(&sum, &s, &r, &mut None);
        assert_eq!(by_sum(&sum, &s, &r, &mut first), expected, "with a hint {context}");
        let found = by_pair(&pair, &s, rotation, &r, &mut second);
        if rotation.is_none() {
            assert_eq!(found, expected, "without M {context}");
        } else {
            // Features have other numbers after the map.
            let plain = |said: &[String]| [&said[..2], &said[said.len() - 3..]].concat();
            assert_eq!(plain(&found), plain(&expected), "without M, turned {context}");
        }
    }
}

#[test]
fn both_routes_agree_on_small_hulls_of_all_dimensions() {
    let rng = &mut Rng::new(91);
    for _ in 0..150 {
        let [p, q] = [0; 2].map(|_: u8| {
            let dimension = rng.below(4) as u8;
            hull_of_dimension(rng, dimension, 3)
        });
        check(rng, &p, &q, None, 12, 7);
    }
    for _ in 0..150 {
        let [p, q] = [0; 2].map(|_: u8| random_hull(rng, 4));
        check(rng, &p, &q, None, 12, 9);
    }
}

#[test]
fn both_routes_agree_on_turned_hulls() {
    let rng = &mut Rng::new(92);
    for _ in 0..60 {
        let [p, q] = [0; 2].map(|_: u8| {
            let dimension = rng.below(4) as u8;
            hull_of_dimension(rng, dimension, 3)
        });
        let turn = quaternion([rng.within(2), rng.within(2), rng.within(2), 1]);
        check(rng, &p, &q, Some(&turn), 8, 7);
    }
}

#[test]
fn both_routes_agree_on_wide_and_weighted_hulls() {
    let rng = &mut Rng::new(93);
    for _ in 0..25 {
        let p = weighted_hull(rng, 8, 3, 90);
        let q = mixed_width_hull(rng, 8, 3, 70);
        check(rng, &p, &q, None, 4, 8);
        let q = weighted_hull(rng, 8, 3, 5);
        check(rng, &p, &q, None, 6, 8);
    }
}
