//! The family of polytopes whose sums have the greatest number of facets, and the bound.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

use exact::{Point3, Sign};
use splitstar_polytope::{
    MaximalError, Polytope, convex_hull, max_facets, maximal_polytope, maximal_summands, minkowski_sum,
    minkowski_sum_by_hull, minkowski_sum_by_lp,
};
use std::collections::HashSet;
use testkit::{Rng, assert_same, hull_of_dimension, random_rotation};

fn facets(polytopes: &[Polytope]) -> Vec<usize> {
    polytopes.iter().map(|p| p.counts().facets).collect()
}

fn sum(summands: &[Polytope]) -> Polytope {
    minkowski_sum(&summands.iter().collect::<Vec<_>>())
}

#[test]
fn the_bound_by_its_formulas() {
    for m in 4..=12 {
        assert_eq!(max_facets(&[m]), Some(m));
        for n in 4..=12 {
            assert_eq!(max_facets(&[m, n]), Some(4 * m * n + 26 - 9 * (m + n)));
        }
    }
    for k in 1..=20 {
        assert_eq!(max_facets(&vec![4; k]), Some(5 * k * k - k));
    }
    assert_eq!(max_facets(&[]), Some(0));
    for too_small in [0, 1, 2, 3] {
        assert_eq!(max_facets(&[too_small]), None);
        assert_eq!(max_facets(&[5, too_small]), None);
        assert_eq!(max_facets(&[too_small, usize::MAX]), None);
    }
    for large in [usize::MAX, usize::MAX / 2, usize::MAX / 3] {
        assert_eq!(max_facets(&[large, large]), None);
    }
}

/// The arcs of a summand matter only if another follows.
#[test]
fn the_bound_overflows_only_if_it_is_too_large() {
    for large in [usize::MAX / 2, usize::MAX / 2 + 1, usize::MAX - 1, usize::MAX] {
        assert_eq!(max_facets(&[large]), Some(large));
        assert_eq!(max_facets(&[large, 4]), None);
        assert_eq!(max_facets(&[4, large]), None);
    }
    // With a tetrahedron, m facets make 7 m - 10.
    let most = usize::MAX / 7 + 1;
    assert_eq!(max_facets(&[4, most]), Some(7 * (most - 2) + 4));
    assert_eq!(max_facets(&[most, 4]), Some(7 * (most - 2) + 4));
    assert_eq!(max_facets(&[4, most + 1]), None);
    assert_eq!(max_facets(&[most + 1, 4]), None);
}

#[test]
fn the_family_is_simple_and_convex() {
    for k in [0, 1, 2, 3, 5, 8, 100] {
        for m in (4..=14).chain([40, 101]) {
            let context = format!("{m} facets for {k} summands");
            let p = maximal_polytope(m, k).expect("the numbers are in range");
            assert_eq!(p.counts().to_array(), [2 * m - 4, 3 * m - 6, m], "{context}");
            assert_same(&p, &convex_hull(p.points()).expect("there are vertices"), &context);
            // Two facets look up.
            let up = p.mesh().facets().filter(|&f| p.facet_normal(f).sign(2) == Sign::Positive).count();
            assert_eq!(up, 2, "{context}");
        }
    }
}

/// What the proof says of the Gaussian map, in the projection to the planes y = -1 and y = 1.
#[test]
fn normals_lie_in_their_strips_far_from_the_origin() {
    for k in [2, 3, 4, 7] {
        for m in (4..=12).chain([30]) {
            let context = format!("{m} facets for {k} summands");
            let p = maximal_polytope(m, k).expect("the numbers are in range");
            let (mut poles, mut lower, mut upper) = (0, 0, 0);
            for f in p.mesh().facets() {
                let normal = p.facet_normal(f).to_i128().expect("the numbers are small");
                let [x, y, z] = normal;
                let (square, far) = ((k * k) as i128, (k + 1) as i128);
                match y.signum() {
                    0 => {
                        assert!(x == 0 && z > 0, "{context}");
                        poles += 1;
                    }
                    -1 => {
                        // From 1 to 1 + 1 / k^2.
                        assert!(x >= -y && (x + y) * square <= -y, "{context}: {normal:?}");
                        lower += 1;
                    }
                    _ => {
                        assert!(-x > y && (-x - y) * square <= y, "{context}: {normal:?}");
                        upper += 1;
                    }
                }
                assert!(z.abs() >= far * y.abs(), "{context}: {normal:?}");
            }
            assert_eq!((poles, lower, upper), (1, m - 2, 1), "{context}");
        }
    }
}

#[test]
fn all_pairs_reach_the_bound() {
    for m in 4..=12 {
        for n in 4..=12 {
            let summands = maximal_summands(&[m, n]).expect("the numbers are in range");
            assert_eq!(facets(&summands), [m, n]);
            let sum = sum(&summands);
            assert_eq!(sum.counts().facets, 4 * m * n + 26 - 9 * (m + n), "{m} and {n}");
            assert_eq!(sum.check_valid(), [], "{m} and {n}");
            if m + n <= 16 {
                let [p, q] = [&summands[0], &summands[1]];
                assert_same(&sum, &minkowski_sum_by_lp(&[p, q]), format!("{m} and {n}"));
                assert_same(&sum, &minkowski_sum_by_hull(&[q, p]), format!("{m} and {n}"));
            }
        }
    }
}

#[test]
fn tetrahedra_reach_the_bound() {
    for k in 1..=8 {
        let summands = maximal_summands(&vec![4; k]).expect("the numbers are in range");
        let sum = sum(&summands);
        assert_eq!(sum.counts().facets, 5 * k * k - k, "{k} tetrahedra");
        assert_eq!(sum.check_valid(), [], "{k} tetrahedra");
        let by_lp = minkowski_sum_by_lp(&summands.iter().collect::<Vec<_>>());
        assert_same(&sum, &by_lp, format!("{k} tetrahedra"));
    }
}

#[test]
fn mixed_summands_reach_the_bound() {
    let rows: [&[usize]; 10] = [
        &[5, 5, 5],
        &[4, 5, 6],
        &[12, 4, 9],
        &[20, 20, 20],
        &[7, 7, 7, 7],
        &[4, 11, 5, 8],
        &[6, 5, 4, 5, 6],
        &[10, 9, 8, 7, 6],
        &[4, 5, 6, 7, 8, 9],
        &[5, 4, 5, 4, 5, 4, 5],
    ];
    for row in rows {
        let summands = maximal_summands(row).expect("the numbers are in range");
        assert_eq!(facets(&summands), row);
        let by_overlay = sum(&summands);
        assert_eq!(Some(by_overlay.counts().facets), max_facets(row), "{row:?}");
        assert_eq!(by_overlay.check_valid(), [], "{row:?}");
        let by_lp = minkowski_sum_by_lp(&summands.iter().collect::<Vec<_>>());
        assert_same(&by_overlay, &by_lp, format!("{row:?}"));
    }
}

#[test]
fn large_summands_reach_the_bound() {
    let summands = maximal_summands(&[101, 60]).expect("the numbers are in range");
    assert_eq!(Some(sum(&summands).counts().facets), max_facets(&[101, 60]));
}

/// Theorem 4.1 on sums that were not made for it.
#[test]
fn no_sum_exceeds_the_bound() {
    let seed = 0x3a_0001;
    println!("seed {seed:#x}, case i begins with seed + i");
    for i in 0..1_000_u64 {
        let mut rng = Rng::new(seed + i);
        let summands: Vec<Polytope> = (0..2 + i % 3)
            .map(|_| hull_of_dimension(&mut rng, 3, 6).transformed(&random_rotation(&mut rng, 5)))
            .collect();
        let (bound, found) = (max_facets(&facets(&summands)), sum(&summands).counts().facets);
        assert!(Some(found) <= bound, "case {i} of seed {seed:#x}: {found} facets, at most {bound:?}");
    }
}

#[test]
fn vertices_are_integers_and_distinct() {
    let p = maximal_polytope(4, 2).expect("the numbers are in range");
    let expected = [[0, 0, 0], [24, 30, 0], [-36, -42, -1], [-84, -84, 0]].map(Point3::from_i64);
    let points: HashSet<String> = p.points().iter().map(Point3::to_string).collect();
    assert_eq!(points, expected.iter().map(Point3::to_string).collect());
    let wide = maximal_polytope(2_000, 1 << 20).expect("the numbers are in range");
    assert_eq!(wide.counts().facets, 2_000);
}

#[test]
fn numbers_out_of_range_are_refused() {
    for m in [0, 1, 2, 3] {
        assert_eq!(maximal_polytope(m, 2).err(), Some(MaximalError::TooFewFacets(m)));
        assert_eq!(maximal_summands(&[5, m]).err(), Some(MaximalError::TooFewFacets(m)));
    }
    for huge in [(1 << 20) + 1, 1 << 28, usize::MAX] {
        assert_eq!(maximal_polytope(huge, 2).err(), Some(MaximalError::TooManyFacets(huge)));
        assert_eq!(maximal_polytope(5, huge).err(), Some(MaximalError::TooManySummands(huge)));
        assert_eq!(maximal_summands(&[5, huge]).err(), Some(MaximalError::TooManyFacets(huge)));
    }
    // What is refused together takes no memory before.
    let together = Some(MaximalError::TooManyFacets(3 << 19));
    assert_eq!(maximal_summands(&[1 << 19; 3]).err(), together);
    assert_eq!(maximal_summands(&[]).expect("no summand is no error").len(), 0);
    assert_eq!(MaximalError::TooFewFacets(3).to_string(), "a solid has at least 4 facets, not 3");
}
