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

fn cube() -> Polytope {
    testkit::hull(&(0..8).map(|i| [i >> 2, i >> 1 & 1, i & 1]).collect::<Vec<_>>())
}

fn integers(coordinates: [i64; 3]) -> [String; 3] {
    coordinates.map(|c| c.to_string())
}

#[test]
fn cubes_in_contact_of_every_kind() {
    use crate::Feature::{Edge, Facet, Vertex};
    let cube = cube();
    let of = RelativePlacement::new(&cube, &cube);
    for (s, zeros) in [([1, 1, 1], 0), ([1, 1, 0], 1), ([1, 0, 0], 2), ([-1, 1, 0], 1), ([0, 0, -1], 2)] {
        let s = Translation::from_i64(s);
        let separation = of.separation(&s, None);
        assert_eq!(separation.relation(), Relation::Touching);
        for feature in separation.features() {
            let dimension = match feature {
                Vertex(_) => 0,
                Edge(_) => 1,
                Facet(_) => 2,
            };
            assert_eq!(dimension, zeros, "{:?}", s.coordinates());
        }
        let [a, b] = separation.closest_points();
        assert_eq!(a, b);
        assert!(of.minimum_penetration(&s, None).is_none());
        let along = Vector3::from_i64([1, 0, 0]);
        let found = of.directional_penetration(&s, &along, None).expect("they do not overlap");
        assert!(found.depth().is_zero() && found.facet().is_none() && found.features().is_none());
    }
    // Facet against facet, apart: the least of all closest points is a corner of the common square.
    let s = Translation::new(&["3", "1/2", "-1/3"].map(|c| c.parse().expect("a number")));
    let separation = of.separation(&s, None);
    assert_eq!(separation.squared_distance(), 4.into());
    let [a, b] = separation.closest_points().map(|point| point.map(|c| c.to_string()));
    assert_eq!([a, b], [["1", "1/2", "0"], ["3", "1/2", "0"]].map(|p| p.map(String::from)));
    assert!(matches!(separation.features(), [Facet(_), Facet(_)]));
}

#[test]
fn a_zero_direction_ends_no_overlap() {
    let cube = cube();
    let (of, pair) = (RelativePlacement::new(&cube, &cube), Pair::new(&cube, &cube));
    let zero = Vector3::from_i64([0; 3]);
    let [inside, outside] = [[0; 3], [9; 3]].map(Translation::from_i64);
    assert!(of.directional_penetration(&inside, &zero, None).is_none());
    assert!(pair.directional_penetration(&inside, None, &zero, None).is_none());
    let apart = of.directional_penetration(&outside, &zero, None).expect("they do not overlap");
    assert!(apart.depth().is_zero());
    let up = Vector3::from_i64([0, 0, 3]);
    let found = of.directional_penetration(&inside, &up, None).expect("the direction is not zero");
    assert_eq!(found.depth().to_string(), "1/3");
    assert!(matches!(found.features(), Some([crate::Feature::Facet(_), crate::Feature::Facet(_)])));
}

#[test]
fn the_far_side_of_a_thin_plate_is_never_the_answer() {
    // The distance to the boundary of M has a local minimum behind the plate; a hint from there leads nowhere.
    let plate =
        testkit::hull(&(0..8).map(|i| [1000 * (i >> 2), 1000 * (i >> 1 & 1), i & 1]).collect::<Vec<_>>());
    let of = RelativePlacement::new(&plate, &Polytope::point(exact::Point3::ORIGIN));
    let below = Translation::from_i64([500, 400, -7]);
    let above = Translation::from_i64([500, 400, 9]);
    let hint = of.separation(&below, None).witness();
    let separation = of.separation(&above, Some(hint));
    assert_eq!(separation.squared_distance(), 64.into());
    assert_eq!(separation.closest_points()[0].each_ref().map(|c| c.to_string()), integers([500, 400, 1]));
}

#[test]
fn a_witness_of_other_polytopes_does_no_harm() {
    let sphere = testkit::around(&testkit::geodesic_sphere(3, 6).points);
    let cube = cube();
    let (large, small) = (RelativePlacement::new(&sphere, &sphere), RelativePlacement::new(&cube, &cube));
    let rng = &mut Rng::new(94);
    for _ in 0..50 {
        let s = translation(rng, &sphere, &cube, 3);
        for witness in
            [large.separation(&s, None).witness(), Pair::new(&sphere, &cube).relation(&s, None, None).1]
        {
            let (plain, hinted) = (small.separation(&s, None), small.separation(&s, Some(witness)));
            assert_eq!(plain.squared_distance(), hinted.squared_distance());
            assert_eq!(small.relation(&s, Some(witness)).0, plain.relation());
            let pair = Pair::new(&cube, &cube);
            assert_eq!(pair.separation(&s, None, Some(witness)).relation(), plain.relation());
        }
    }
}

#[test]
fn translations_of_all_magnitudes() {
    let cube = cube();
    let of = RelativePlacement::new(&cube, &cube);
    for exponent in [-1070, -600, -301, -40, 0, 40, 301, 600, 1020] {
        let length = 2f64.powi(exponent);
        let s = Translation::from_f64([length, 0.0, -length]).expect("the numbers are finite");
        let separation = of.separation(&s, None);
        let exact = Rational::try_from(length).expect("a finite number");
        let gap = exact.clone() - Rational::ONE;
        let expected = match exponent {
            ..0 => Relation::Overlapping,
            0 => Relation::Touching,
            _ => Relation::Disjoint,
        };
        assert_eq!(separation.relation(), expected, "2^{exponent}");
        if expected == Relation::Disjoint {
            assert_eq!(separation.squared_distance(), &gap * &gap + &gap * &gap);
        }
        if expected == Relation::Overlapping {
            let found = of.minimum_penetration(&s, None).expect("they overlap");
            assert_eq!(found.squared_depth(), &gap * &gap);
        }
    }
}

#[test]
fn a_sphere_around_its_own_center_has_one_least_depth_on_both_routes() {
    // All facets are nearly as deep: without M, the hull would have to grow to the whole of it.
    let sphere = testkit::around(&testkit::geodesic_sphere(8, 6).points);
    let turned = sphere.transformed(&testkit::rotation([7, 1, 2, 3]));
    let s = Translation::from_f64([1e-9, 2e-9, -3e-9]).expect("the numbers are finite");
    let of = RelativePlacement::new(&sphere, &turned);
    let turn = quaternion([7, 1, 2, 3]);
    let pair = Pair::new(&sphere, &sphere);
    let [first, second] = [
        of.minimum_penetration(&s, None).map(|found| found.squared_depth()),
        pair.minimum_penetration(&s, Some(&turn), None).map(|found| found.squared_depth()),
    ];
    assert_eq!(first, second);
    // The least of all depths, one by one.
    let depth = |f| {
        let plane = of.sum().facet_plane(f);
        let height = plane.height(s.point());
        let length = Rational::from(plane.normal.dot(&plane.normal));
        (&height * &height).checked_div(&length).expect("a normal is not zero")
    };
    assert_eq!(first, of.sum().mesh().facets().map(depth).min());
}

/// The hull of that sphere passes the limit, so that the answer above comes from the sum; below a limit it is given up at once.
#[test]
fn a_hull_that_grows_beyond_its_limit_is_given_up() {
    use crate::bodies::Bodies;
    use crate::expansion::{Exit, Expansion};
    let nearest = |p: &Polytope, turn: Option<&Quaternion>, s: &Translation, limit: usize| -> Option<Exit> {
        let bodies = Bodies::new(p, p, turn);
        let mut hull = Expansion::new(&bodies, &s.0, bodies.start(None)).expect("the sum is solid");
        hull.relation();
        hull.nearest_plane(limit)
    };
    let sphere = testkit::around(&testkit::geodesic_sphere(8, 6).points);
    let s = Translation::from_f64([1e-9, 2e-9, -3e-9]).expect("the numbers are finite");
    let turn = quaternion([7, 1, 2, 3]);
    assert!(nearest(&sphere, Some(&turn), &s, 1000).is_none());
    let small = testkit::around(&testkit::geodesic_sphere(2, 6).points);
    let of = RelativePlacement::new(&small, &small.transformed(&Affine3::rotation(&turn)));
    let expected = of.minimum_penetration(&s, None).map(|found| found.squared_depth());
    let mut given_up = 0;
    for limit in [4, 10, 30, 100, usize::MAX] {
        match nearest(&small, Some(&turn), &s, limit) {
            Some(exit) => assert_eq!(Some(exit.depth), expected, "limit {limit}"),
            None => given_up += 1,
        }
    }
    assert!((1..5).contains(&given_up), "{given_up}");
}

#[test]
fn a_motion_answers_each_placement_in_turn() {
    let cube = cube();
    let of = RelativePlacement::new(&cube, &cube);
    let path: Vec<Translation> = (-3..4).map(|x| Translation::from_i64([x, 0, 0])).collect();
    let squares: Vec<String> = crate::Motion::of_translations(&of, &path)
        .map(|found| found.squared_distance().to_string())
        .collect();
    assert_eq!(squares, ["4", "1", "0", "0", "0", "1", "4"]);
    let pair = Pair::new(&cube, &cube);
    let quarter = quaternion([1, 0, 0, 1]);
    let placements: Vec<crate::Placement> = path
        .into_iter()
        .map(|translation| crate::Placement { rotation: Some(quarter.clone()), translation })
        .collect();
    let relations: Vec<Relation> =
        crate::Motion::of_placements(&pair, &placements).map(|found| found.relation()).collect();
    use Relation::{Disjoint, Overlapping, Touching};
    // A quarter turn puts the cube from -1 to 0.
    assert_eq!(relations, [Disjoint, Disjoint, Disjoint, Touching, Overlapping, Touching, Disjoint]);
}
