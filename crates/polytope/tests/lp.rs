//! Sums by linear programming: the rows of the models, degenerate summands, wide coordinates. By the overlay
//! and by the hull they are the same, in incidences too.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

use exact::{Point3, Rational};
use splitstar_polytope::{Polytope, minkowski_sum, minkowski_sum_by_hull, minkowski_sum_by_lp};
use testkit::{
    Rng, SumRow, assert_same, bipyramid, flat_points, hull, hull_of_dimension, mixed_width_hull, model,
    prism, random_hull, random_rotation, rotation, scaling, segment, spread_generators, translation,
    weighted_hull, wide_hull, zonotope_volume,
};

/// General turns, some about an axis, and one that maps axes to axes.
const QUATERNIONS: [[i64; 4]; 5] = [[1, 1, 1, 1], [3, 0, 1, 0], [5, 1, 0, 2], [7, -3, 2, 1], [2, 1, -5, 4]];

fn unit_cube() -> Polytope {
    model("convex/unit_cube.off")
}

#[track_caller]
fn check(summands: &[&Polytope], context: &str) -> Polytope {
    let sum = minkowski_sum_by_lp(summands);
    assert_same(&sum, &minkowski_sum(summands), context);
    sum
}

#[test]
fn every_sum_of_the_models_in_both_orders_and_turned() {
    let mut rows = 0;
    for row in SumRow::all() {
        let summands: Vec<&Polytope> = row.summands.iter().collect();
        let expected = check(&summands, &row.name());
        row.check(&expected, "by linear programs");
        let swapped: Vec<&Polytope> = row.summands.iter().rev().collect();
        row.check(&check(&swapped, &row.name()), "by linear programs, swapped");
        for quaternion in QUATERNIONS {
            let turn = rotation(quaternion);
            let turned: Vec<Polytope> = row.summands.iter().map(|p| p.transformed(&turn)).collect();
            let sum = minkowski_sum_by_lp(&turned.iter().collect::<Vec<_>>());
            row.check(&sum, &format!("by linear programs, turned by {quaternion:?}"));
            assert!(sum.same_set(&expected.transformed(&turn)), "{} turned by {quaternion:?}", row.name());
        }
        rows += 1;
    }
    assert_eq!(rows, 37);
}

/// The hull of these points and a cube: an arc of the Gaussian map runs through a pole.
#[test]
fn an_arc_through_a_pole() {
    let p = hull(&[
        [1, -2, 2],
        [-1, -2, -2],
        [-1, -2, -1],
        [-1, 1, 2],
        [-2, -2, -2],
        [2, -2, -1],
        [-1, -2, 1],
        [0, -2, 1],
    ]);
    for cube in [unit_cube(), model("convex/cube.off")] {
        for summands in [[&p, &cube], [&cube, &p]] {
            let sum = check(&summands, "hull of eight points and cube");
            assert_same(&sum, &minkowski_sum_by_hull(&summands), "hull of eight points and cube");
        }
    }
}

#[test]
fn points_alone_and_no_summand() {
    assert!(minkowski_sum_by_lp(&[]).same_set(&Polytope::point(Point3::ORIGIN)));
    let [p, q] = [[1, 2, 3], [-4, 5, 0]].map(|p| Polytope::point(Point3::from_i64(p)));
    assert!(check(&[&p, &q, &p], "points").same_set(&Polytope::point(Point3::from_i64([-2, 9, 6]))));
    let cube = unit_cube();
    assert_same(&minkowski_sum_by_lp(&[&cube]), &cube, "one summand");
    assert_same(
        &check(&[&p, &cube, &q], "a cube and points"),
        &cube.transformed(&translation([-3, 7, 3], 1)),
        "",
    );
}

#[test]
fn segments() {
    let [a, b, c] = [[1, 0, 0], [0, 2, 0], [0, 0, 3]].map(segment);
    let [long, back] = [[5, 0, 0], [-2, 0, 0]].map(segment);
    let parallel = check(&[&a, &long, &back, &a], "parallel segments");
    assert_eq!((parallel.dimension(), parallel.counts().to_array()), (1, [2, 1, 0]));
    assert!(parallel.same_set(&hull(&[[-2, 0, 0], [7, 0, 0]])));
    let rectangle = check(&[&a, &b, &back, &b], "two directions");
    assert_eq!((rectangle.dimension(), rectangle.counts().to_array()), (2, [4, 4, 1]));
    let cuboid = check(&[&a, &b, &c, &long, &b, &back], "three directions");
    assert_eq!(cuboid.volume(), Rational::from(8 * 4 * 3));
}

/// Zonotopes: every edge of the sum is that of one segment, or of all that are parallel.
#[test]
fn zonotopes() {
    for k in 1..=12 {
        let generators = spread_generators(k);
        let segments: Vec<Polytope> = generators.iter().map(|&g| segment(g)).collect();
        let sum = check(&segments.iter().collect::<Vec<_>>(), &format!("{k} segments"));
        assert_eq!(sum.volume(), if k < 3 { Rational::from(0) } else { zonotope_volume(&generators) });
        if k >= 3 {
            let k = k as usize;
            assert_eq!(sum.counts().to_array(), [k * (k - 1) + 2, 2 * k * (k - 1), k * (k - 1)]);
        }
        let twice: Vec<&Polytope> = segments.iter().chain(segments.iter().rev()).collect();
        assert!(
            minkowski_sum_by_lp(&twice).same_set(&sum.transformed(&scaling(2, 1))),
            "{k} segments, twice"
        );
    }
}

/// All edges of cubes are parallel: each step moves in every summand.
#[test]
fn many_cubes() {
    let cubes: Vec<Polytope> = (1..=9)
        .map(|i| unit_cube().transformed(&scaling(if i % 2 == 0 { -i } else { i }, i % 3 + 1)))
        .collect();
    let sum = check(&cubes.iter().collect::<Vec<_>>(), "nine cubes");
    assert_eq!(sum.counts().to_array(), [8, 12, 6]);
    // Boxes, prisms over squares, and a cube turned about an axis that all share.
    let boxes = ["x", "y", "z"].map(|axis| model(&format!("convex/box_{axis}.off")));
    let turned = unit_cube().transformed(&rotation([2, 0, 0, 1]));
    let sum =
        check(&[&boxes[0], &turned, &boxes[1], &cubes[3], &boxes[2], &turned], "boxes and turned cubes");
    assert_eq!(sum.counts().to_array(), [16, 24, 10]);
}

#[test]
fn copies_and_reflections_of_one_polytope() {
    for name in ["tetrahedron", "octahedron", "icosahedron", "dp"] {
        let p = model(&format!("convex/{name}.off"));
        let q = p.reflected();
        let twice = minkowski_sum_by_lp(&[&p, &p]);
        assert_same(&twice, &p.transformed(&scaling(2, 1)), name);
        let difference = check(&[&p, &q], name);
        assert!(difference.same_set(&difference.reflected()), "{name}");
        check(&[&p, &q, &p, &q], name);
    }
}

/// Vertices of high degree, and facets with many corners.
#[test]
fn large_degrees() {
    for quaternion in [[1, 0, 0, 0], [3, 1, 0, 0], [5, 1, 2, 3]] {
        for p in [prism(40, 1), bipyramid(40, 1)] {
            let q = bipyramid(30, 2).transformed(&rotation(quaternion));
            check(&[&p, &q], &format!("turned by {quaternion:?}"));
        }
    }
}

/// One to four random summands of random dimensions at once, in boxes so small that coincidences are the rule.
#[test]
fn random_summands_of_all_dimensions() {
    let seed = 0x1b_0010;
    println!("seed {seed:#x}, case i begins with seed + i");
    let mut dimensions = [0; 4];
    for i in 0..6_000_u64 {
        let mut rng = Rng::new(seed + i);
        let range = [1, 2, 5][(i % 3) as usize];
        let count = 1 + i / 3 % 4;
        let summands: Vec<Polytope> = (0..count)
            .map(|_| {
                let dimension = rng.below(4) as u8;
                hull_of_dimension(&mut rng, dimension, range)
            })
            .collect();
        let summands: Vec<&Polytope> = summands.iter().collect();
        let sum = check(&summands, &format!("case {i} of seed {seed:#x}"));
        if i % 8 == 0 {
            assert_same(&sum, &minkowski_sum_by_hull(&summands), format!("case {i} of seed {seed:#x}"));
        }
        dimensions[usize::from(sum.dimension())] += 1;
    }
    println!("dimensions of the sums: {dimensions:?}");
    assert!(dimensions.iter().all(|&times| times >= 20), "{dimensions:?}");
}

/// Sums in one plane, and solids that belong together: parallel facets and edges in number.
#[test]
fn random_summands_that_belong_together() {
    let seed = 0x1b_0020;
    println!("seed {seed:#x}, case i begins with seed + i");
    for i in 0..1_500_u64 {
        let mut rng = Rng::new(seed + i);
        let context = format!("case {i} of seed {seed:#x}");
        let p = if i % 3 == 0 { hull(&flat_points(&mut rng, 8, 3)) } else { random_hull(&mut rng, 2) };
        let others: Vec<Polytope> = (0..1 + rng.below(3))
            .map(|_| match rng.below(5) {
                0 => p.reflected(),
                1 => p.transformed(&scaling(3, 2)),
                2 => p.transformed(&rotation([0, 0, 0, 1])),
                3 => p.transformed(&rotation([7, 0, 0, 1])),
                _ => p.transformed(&random_rotation(&mut rng, 2)),
            })
            .collect();
        let summands: Vec<&Polytope> = std::iter::once(&p).chain(&others).collect();
        let sum = check(&summands, &context);
        let reversed: Vec<&Polytope> = summands.iter().rev().copied().collect();
        assert!(minkowski_sum_by_lp(&reversed).same_set(&sum), "{context}, reversed");
    }
}

#[test]
fn coordinates_of_any_width() {
    let seed = 0x1b_0030;
    println!("seed {seed:#x}, case i begins with seed + i");
    for i in 0..240_u64 {
        let mut rng = Rng::new(seed + i);
        let bits = [30, 61, 62, 63, 100, 126, 200][(i % 7) as usize];
        let summands: Vec<Polytope> = (0..2 + i % 2)
            .map(|_| match rng.below(4) {
                0 => wide_hull(&mut rng, 8, bits),
                1 => mixed_width_hull(&mut rng, 6, 3, bits),
                2 => weighted_hull(&mut rng, 6, 3, bits),
                _ => random_hull(&mut rng, 3),
            })
            .collect();
        check(&summands.iter().collect::<Vec<_>>(), &format!("case {i} of seed {seed:#x}, {bits} bits"));
    }
}
