//! Laws of the Minkowski sum: order of the summands, rotation, reflection, scaling, translation, width.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

use exact::{Affine3, Point3};
use splitstar_polytope::{Polytope, convex_hull, minkowski_sum, minkowski_sum_by_hull};
use testkit::{
    Rng, around, assert_same, hull_of_dimension, mixed_width_hull, random_hull, random_rotation, scaling,
    stl_like_mesh, translation, weighted_hull, wide_hull,
};

/// A polytope of any dimension, solids more often.
fn any(rng: &mut Rng, range: i64) -> Polytope {
    let dimension = [0, 1, 1, 2, 2, 3, 3, 3][rng.below(8) as usize];
    hull_of_dimension(rng, dimension, range)
}

fn sum(p: &Polytope, q: &Polytope) -> Polytope {
    minkowski_sum(&[p, q])
}

/// Each case with its seed printed if it fails.
fn cases(seed: u64, count: u64, case: impl Fn(&mut Rng, &str)) {
    println!("seed {seed:#x}, case i begins with seed + i");
    for i in 0..count {
        case(&mut Rng::new(seed + i), &format!("case {i} of seed {seed:#x}"));
    }
}

/// The hull of all sums of one vertex of each summand, one summand after the other.
fn one_after_the_other(summands: &[&Polytope]) -> Polytope {
    let origin = Polytope::point(Point3::from_i64([0, 0, 0]));
    summands.iter().fold(origin, |total, p| {
        let sums: Vec<Point3> =
            total.points().iter().flat_map(|a| p.points().iter().map(|b| a.plus(b))).collect();
        convex_hull(&sums).expect("a polytope has a vertex")
    })
}

#[test]
fn summands_in_any_order() {
    cases(0x1a0_0001, 1_500, |rng, context| {
        let range = *rng.choose(&[1, 2, 5]);
        let count = rng.between(0, 6);
        let polytopes: Vec<Polytope> = (0..count).map(|_| any(rng, range)).collect();
        let mut summands: Vec<&Polytope> = polytopes.iter().collect();
        let hull = one_after_the_other(&summands);
        assert_same(&minkowski_sum(&summands), &hull, context);
        assert_same(&minkowski_sum_by_hull(&summands), &hull, context);
        for _ in 0..2 {
            rng.shuffle(&mut summands);
            assert_same(&minkowski_sum(&summands), &hull, context);
        }
        // Sums are summands again, in any association.
        let folded = summands.split_first().map(|(first, rest)| {
            rest.iter().fold(
                (*first).clone(),
                |total, p| if rng.one_in(2) { sum(&total, p) } else { sum(p, &total) },
            )
        });
        if let Some(folded) = folded {
            assert_same(&folded, &hull, context);
        }
    });
}

/// Many segments and polygons, often coplanar: sums of dimension 2 that are summands again.
#[test]
fn flat_summands_in_any_order() {
    cases(0x1a0_0002, 1_500, |rng, context| {
        let plane = hull_of_dimension(rng, 2, 2);
        let count = rng.between(2, 6);
        let polytopes: Vec<Polytope> = (0..count)
            .map(|_| {
                let vertices = plane.points();
                let mut part: Vec<Point3> =
                    (0..rng.between(1, 5)).map(|_| rng.choose(vertices).clone()).collect();
                if rng.one_in(8) {
                    part.push(Point3::from_i64([0; 3].map(|_: i64| rng.within(3))));
                }
                let turned = if rng.one_in(2) { Affine3::reflection() } else { Affine3::identity() };
                around(&part).transformed(&turned)
            })
            .collect();
        let mut summands: Vec<&Polytope> = polytopes.iter().collect();
        let hull = one_after_the_other(&summands);
        for _ in 0..3 {
            assert_same(&minkowski_sum(&summands), &hull, context);
            rng.shuffle(&mut summands);
            let total = summands[1..].iter().fold(summands[0].clone(), |total, p| sum(&total, p));
            assert_same(&total, &hull, context);
            // A sum under a map, and then a summand again.
            let turn = random_rotation(rng, 3);
            let [p, q] = [&total, summands[0]].map(|p| p.transformed(&turn));
            assert_same(&sum(&p, &q), &one_after_the_other(&[&p, &q]), context);
        }
    });
}

#[test]
fn an_affine_map_commutes_with_the_sum() {
    cases(0x1a0_0003, 1_000, |rng, context| {
        let range = *rng.choose(&[1, 2, 5]);
        let (p, q) = (any(rng, range), any(rng, range));
        let turn = random_rotation(rng, 9);
        let shear = random_rotation(rng, 3).then(&scaling(rng.within(9) * 2 + 1, 6));
        for map in [turn, shear] {
            let mapped = sum(&p.transformed(&map), &q.transformed(&map));
            assert_same(&mapped, &sum(&p, &q).transformed(&map), context);
        }
    });
}

#[test]
fn reflection_of_a_difference() {
    cases(0x1a0_0004, 1_000, |rng, context| {
        let range = *rng.choose(&[1, 2, 5]);
        let (p, q) = (any(rng, range), any(rng, range));
        // P + (-Q) = -((-P) + Q), and P - P is its own reflection.
        let difference = sum(&p, &q.reflected());
        assert_same(&difference, &sum(&p.reflected(), &q).reflected(), context);
        let symmetric = sum(&p, &p.reflected());
        assert_same(&symmetric, &symmetric.reflected(), context);
        assert_eq!(symmetric.dimension(), p.dimension(), "{context}");
    });
}

#[test]
fn a_translated_summand_translates_the_sum() {
    cases(0x1a0_0005, 1_000, |rng, context| {
        let range = *rng.choose(&[1, 2, 5]);
        let (p, q) = (any(rng, range), any(rng, range));
        let by = translation([rng.within(20), rng.within(20), rng.within(20)], rng.between(1, 9) as i64);
        let moved = sum(&p, &q).transformed(&by);
        assert_same(&sum(&p.transformed(&by), &q), &moved, context);
        assert_same(&sum(&p, &q.transformed(&by)), &moved, context);
        // A point is a translation.
        let origin = Polytope::point(Point3::from_i64([0, 0, 0]));
        assert_same(&sum(&moved, &origin.transformed(&by)), &moved.transformed(&by), context);
    });
}

#[test]
fn a_polytope_and_its_multiples() {
    cases(0x1a0_0006, 1_000, |rng, context| {
        let range = *rng.choose(&[1, 2, 5]);
        let p = any(rng, range);
        let multiple = |numerator: i64, denominator: i64| p.transformed(&scaling(numerator, denominator));
        assert_same(&sum(&p, &p), &multiple(2, 1), context);
        assert_same(&minkowski_sum(&[&p, &p, &p]), &multiple(3, 1), context);
        assert_same(&minkowski_sum(&[&p; 6]), &multiple(6, 1), context);
        let third = multiple(1, 3);
        assert_same(&sum(&third, &p), &multiple(4, 3), context);
        assert_same(&minkowski_sum(&[&third; 3]), &p, context);
        assert_same(&minkowski_sum(&[&p, &third, &multiple(2, 3)]), &multiple(2, 1), context);
    });
}

/// Volumes: the Brunn-Minkowski inequality for cubes of volumes is Vol(P+Q) >= Vol P + Vol Q and more;
/// exact here is that the volume of P + tQ is a polynomial of degree 3 in t.
#[test]
fn the_volume_is_a_polynomial() {
    cases(0x1a0_0007, 300, |rng, context| {
        let (p, q) = (random_hull(rng, 5), random_hull(rng, 5));
        let volume = |t: i64| match t {
            0 => p.volume(),
            _ => sum(&p, &q.transformed(&scaling(t, 1))).volume(),
        };
        let v = [0, 1, 2, 3, 4].map(volume);
        // The fourth difference is zero, and the third one is 3! times the leading coefficient.
        let times = |n: i64, i: usize| exact::Rational::from(n) * &v[i];
        let third = &v[3] - times(3, 2) + times(3, 1) - v[0].clone();
        let shifted = &v[4] - times(3, 3) + times(3, 2) - v[1].clone();
        assert_eq!(third, shifted, "{context}");
        assert_eq!(third, exact::Rational::from(6) * q.volume(), "{context}");
        assert!(v[1] >= &v[0] + q.volume(), "{context}");
    });
}

#[test]
fn wide_coordinates() {
    for (bits, count) in [(31, 300), (53, 300), (61, 300), (64, 200), (128, 100), (256, 40), (1100, 10)] {
        cases(0x1a1_0000 + (u64::from(bits) << 24), count, |rng, context| {
            let context = format!("{bits} bits, {context}");
            let points = rng.between(4, 10);
            let (p, q) = (wide_hull(rng, points, bits), wide_hull(rng, points, bits));
            let [small, one_wide, weighted] = [
                random_hull(rng, 3),
                mixed_width_hull(rng, points, 3, bits),
                weighted_hull(rng, points, 2, bits),
            ];
            for (p, q) in [
                (&p, &q),
                (&p, &p),
                (&p, &small),
                (&small, &q),
                (&one_wide, &small),
                (&one_wide, &one_wide.reflected()),
                (&weighted, &small),
                (&p, &weighted),
                (&weighted, &weighted.reflected()),
            ] {
                assert_same(&sum(p, q), &minkowski_sum_by_hull(&[p, q]), &context);
            }
            assert_same(&sum(&weighted, &weighted), &weighted.transformed(&scaling(2, 1)), &context);
        });
    }
}

/// The same pair in other sizes and far away: counts do not change, whatever tier decides.
#[test]
fn width_changes_nothing() {
    cases(0x1a0_0009, 300, |rng, context| {
        let range = *rng.choose(&[1, 2, 5]);
        let (p, q) = (any(rng, range), any(rng, range));
        let counts = sum(&p, &q).counts();
        for bits in [10, 40, 58, 62, 70, 126, 130, 500] {
            let factor = exact::Integer::from(3).pow(bits * 5 / 8);
            let scale = Affine3::scaling(&exact::Rational::from(factor.clone()));
            let far = Affine3::translation(&[0; 3].map(|_: u8| exact::Rational::from(&factor)));
            for map in [&scale, &far, &scale.then(&far)] {
                let mapped = sum(&p.transformed(map), &q.transformed(map));
                assert_eq!(mapped.counts(), counts, "{bits} bits, {context}");
                assert_eq!(mapped.check_valid(), [], "{bits} bits, {context}");
            }
            let mixed = sum(&p.transformed(&far), &q);
            assert_same(&mixed, &sum(&p, &q).transformed(&far), format!("{bits} bits, {context}"));
        }
    });
}

/// Float coordinates with spread exponents, as STL files have them.
#[test]
fn float_meshes() {
    for spread in [0, 10, 30, 60, 200] {
        cases(0x1a2_0000 + (spread << 24), 20, |rng, context| {
            let context = format!("spread {spread}, {context}");
            let polytopes = [20, 12].map(|count| {
                let mesh = stl_like_mesh(rng, count, spread);
                Polytope::from_mesh(&mesh, &mut Vec::new())
                    .unwrap_or_else(|error| panic!("{context}: {error}"))
            });
            let [p, q] = &polytopes;
            assert_same(&sum(p, q), &minkowski_sum_by_hull(&[p, q]), &context);
            assert_same(&sum(p, &p.reflected()), &minkowski_sum_by_hull(&[p, &p.reflected()]), &context);
        });
    }
}

/// The same summands give the same bytes with any number of threads.
#[test]
fn threads_change_nothing() {
    cases(0x1a0_000a, 60, |rng, context| {
        let polytopes: Vec<Polytope> = (0..rng.between(4, 9)).map(|_| any(rng, 5)).collect();
        let summands: Vec<&Polytope> = polytopes.iter().collect();
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            let mesh = pool.install(|| minkowski_sum(&summands)).to_mesh();
            (mesh.points.iter().map(Point3::homogeneous).collect::<Vec<_>>(), mesh.facets)
        };
        let one = with(1);
        for threads in [2, 3, 8] {
            assert!(with(threads) == one, "{threads} threads, {context}");
        }
    });
}
