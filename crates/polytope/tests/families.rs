//! Sums of which everything is known: prisms, bipyramids, zonotopes, geodesic spheres; and large facets.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

use exact::Point3;
use splitstar_polytope::{Polytope, convex_hull, minkowski_sum, minkowski_sum_by_hull, overlay_counts};
use testkit::{
    Rng, antiprism, assert_same, bipyramid, geodesic_sphere, hull, prism, rational_circle, rotation, segment,
    spread_generators, zonotope_volume,
};

fn counts(p: &Polytope) -> [usize; 3] {
    p.counts().to_array()
}

#[test]
fn families_are_as_their_documentation_says() {
    for n in [3, 4, 5, 17, 64, 101] {
        assert_eq!(counts(&prism(n, 2)), [2 * n, 3 * n, n + 2], "prism {n}");
        assert_eq!(counts(&bipyramid(n, 1)), [n + 2, 3 * n, 2 * n], "bipyramid {n}");
        let odd = n % 2 == 1;
        let expected = if odd { [2 * n, 4 * n, 2 * n + 2] } else { [2 * n, 3 * n, n + 2] };
        assert_eq!(counts(&antiprism(n)), expected, "antiprism {n}");
    }
    for frequency in [1, 2, 3, 5, 8] {
        let sphere = Polytope::from_mesh(&geodesic_sphere(frequency, 6), &mut Vec::new());
        let sphere = sphere.unwrap_or_else(|error| panic!("frequency {frequency}: {error}"));
        let f2 = frequency * frequency;
        assert_eq!(counts(&sphere), [10 * f2 + 2, 30 * f2, 20 * f2], "frequency {frequency}");
        assert_eq!(sphere.check_valid(), [], "frequency {frequency}");
    }
}

#[test]
fn segments_sweep() {
    let polygon = convex_hull(
        &rational_circle(20)
            .iter()
            .map(|[x, y]| Point3::from_rationals(&[x.clone(), y.clone(), 0.into()]))
            .collect::<Vec<_>>(),
    )
    .expect("twenty points");
    assert_eq!((polygon.dimension(), counts(&polygon)), (2, [20, 20, 1]));
    // Across the plane: a prism, upright and slanted. Along it: a polygon with two more edges, or none.
    assert_same(&minkowski_sum(&[&polygon, &segment([0, 0, 3])]), &prism(20, 3), "upright");
    assert_eq!(counts(&minkowski_sum(&[&segment([5, 1, 3]), &polygon])), [40, 60, 22]);
    let swept = minkowski_sum(&[&polygon, &segment([7, 5, 0])]);
    assert_eq!((swept.dimension(), counts(&swept)), (2, [22, 22, 1]));
    let square = hull(&[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]);
    let longer = minkowski_sum(&[&square, &segment([4, 0, 0])]);
    assert_same(&longer, &hull(&[[0, 0, 0], [5, 0, 0], [5, 1, 0], [0, 1, 0]]), "along an edge");
    // Segments: parallel, opposite, equal, crossing.
    assert_same(&minkowski_sum(&[&segment([1, 2, 3]), &segment([2, 4, 6])]), &segment([3, 6, 9]), "parallel");
    let opposite = minkowski_sum(&[&segment([1, 2, 3]), &segment([-1, -2, -3])]);
    assert_same(&opposite, &hull(&[[1, 2, 3], [-1, -2, -3]]), "opposite");
    assert_same(&minkowski_sum(&[&segment([1, 0, 0]), &segment([0, 1, 0])]), &square, "crossing");
    // The sum of no summand is the origin, that of one is that one.
    assert_same(&minkowski_sum(&[]), &hull(&[[0, 0, 0]]), "none");
    assert_same(&minkowski_sum(&[&square]), &square, "one");
}

fn zonotope(generators: &[[i64; 3]]) -> Polytope {
    let segments: Vec<Polytope> = generators.iter().map(|&g| segment(g)).collect();
    minkowski_sum(&segments.iter().collect::<Vec<_>>())
}

/// k segments, no three coplanar: a facet for every pair and side.
#[test]
fn zonotopes_in_general_position() {
    for k in 3..=12i64 {
        let mut generators = spread_generators(k);
        let facets = (k * (k - 1)) as usize;
        for turn in 0..3 {
            let sum = zonotope(&generators);
            assert_eq!(counts(&sum), [facets + 2, 2 * facets, facets], "{k} generators");
            assert_eq!(sum.volume(), zonotope_volume(&generators), "{k} generators");
            assert_eq!(sum.check_valid(), [], "{k} generators");
            if k <= 7 {
                let segments: Vec<Polytope> = generators.iter().map(|&g| segment(g)).collect();
                let oracle = minkowski_sum_by_hull(&segments.iter().collect::<Vec<_>>());
                assert_same(&sum, &oracle, format!("{k} generators"));
            }
            // The other end first, in another order: a translation.
            generators.reverse();
            generators[turn] = generators[turn].map(|c| -c);
        }
    }
}

#[test]
fn zonotopes_with_coplanar_and_parallel_generators() {
    const SEED: u64 = 0xfa_0001;
    println!("seed {SEED:#x}");
    let mut rng = Rng::new(SEED);
    let mut dimensions = [0; 4];
    for case in 0..400 {
        let count = rng.between(1, 8);
        let range = *rng.choose(&[1, 1, 2]);
        let mut generators: Vec<[i64; 3]> =
            (0..count).map(|_| [0; 3].map(|_: i64| rng.within(range))).collect();
        match rng.below(10) {
            0..3 => generators.iter_mut().for_each(|g| g[2] = g[0] - g[1]), // coplanar
            3 => generators.iter_mut().for_each(|g| *g = [g[0], -2 * g[0], 0]), // parallel
            _ => {}
        }
        let segments: Vec<Polytope> = generators.iter().map(|&g| segment(g)).collect();
        let summands: Vec<&Polytope> = segments.iter().collect();
        let sum = minkowski_sum(&summands);
        assert_same(&sum, &minkowski_sum_by_hull(&summands), format!("case {case}: {generators:?}"));
        assert_eq!(sum.volume(), zonotope_volume(&generators), "case {case}: {generators:?}");
        dimensions[usize::from(sum.dimension())] += 1;
    }
    assert!(dimensions.iter().all(|&n| n >= 5), "{dimensions:?}");
}

/// Facets and vertices with 500 edges, against counts from the overlay of the maps.
#[test]
fn large_facets() {
    let n = 500;
    let (prism, bipyramid) = (prism(n, 1), bipyramid(n, 1));
    // Parallel prisms over one polygon: all normals are common.
    let twice = minkowski_sum(&[&prism, &prism]);
    assert_eq!(counts(&twice), [2 * n, 3 * n, n + 2]);
    // The same n-gon turned by an angle that no edge shares: a 2n-gon.
    let about_z = rotation([1000, 0, 0, 1]);
    let turned = prism.transformed(&about_z);
    let sum = minkowski_sum(&[&prism, &turned]);
    assert_eq!(counts(&sum), [4 * n, 6 * n, 2 * n + 2]);
    assert_eq!(overlay_counts(&prism, &turned).common_normals, 2);
    // Over one polygon: the bipyramid's edges are parallel to those of the prism.
    let sum = minkowski_sum(&[&prism, &bipyramid]);
    assert_same(&sum, &minkowski_sum_by_hull(&[&prism, &bipyramid]), "prism + bipyramid");
    let turned = bipyramid.transformed(&about_z);
    let sum = minkowski_sum(&[&bipyramid, &turned]);
    assert_eq!(sum.check_valid(), []);
    assert_eq!(sum.counts().facets, 4 * n + overlay_counts(&bipyramid, &turned).crossings);
}

/// The same, turned about general axes, which puts the apices of high degree into facets of the other.
#[test]
fn large_facets_turned() {
    let check = |p: &Polytope, q: &Polytope, context: &str| {
        let (sum, overlay) = (minkowski_sum(&[p, q]), overlay_counts(p, q));
        let facets = p.counts().facets + q.counts().facets + overlay.crossings - overlay.common_normals;
        assert_eq!(sum.counts().facets, facets, "{context}");
        assert_eq!(sum.check_valid(), [], "{context}");
        assert!(sum.same_set(&minkowski_sum(&[q, p])), "{context}");
        sum
    };
    let shapes = |n: usize| [prism(n, 1), bipyramid(n, 1), antiprism(n | 1)];
    for quaternion in [[3, 1, 0, 0], [5, 1, 2, 3], [1, 1, 1, 1]] {
        for p in &shapes(60) {
            for q in &shapes(60) {
                let q = q.transformed(&rotation(quaternion));
                let context = format!("{:?} and {:?} turned by {quaternion:?}", counts(p), counts(&q));
                assert_same(&check(p, &q, &context), &minkowski_sum_by_hull(&[p, &q]), context);
            }
        }
    }
    let [prism, bipyramid, antiprism] = shapes(500);
    for q in [&bipyramid, &antiprism] {
        let q = q.transformed(&rotation([5, 1, 2, 3]));
        for p in [&prism, &bipyramid] {
            check(p, &q, &format!("{:?} and {:?}", counts(p), counts(&q)));
        }
    }
}

/// Both polygons in one plane, and in planes that cross: hundreds of arcs through the poles of each other.
#[test]
fn large_polygons() {
    let flat = |n: usize| {
        let lift = |[x, y]: &[exact::Rational; 2]| Point3::from_rationals(&[x.clone(), y.clone(), 0.into()]);
        convex_hull(&rational_circle(n).iter().map(lift).collect::<Vec<_>>()).expect("a polygon has vertices")
    };
    let (p, q) = (flat(500), flat(300));
    let in_plane = minkowski_sum(&[&p, &q.transformed(&rotation([1000, 0, 0, 1]))]);
    assert_eq!((in_plane.dimension(), counts(&in_plane)), (2, [800, 800, 1]));
    assert_eq!(in_plane.check_valid(), []);
    for quaternion in [[1, 1, 0, 0], [2, 1, 0, 0], [3, 1, 2, 1]] {
        let across = q.transformed(&rotation(quaternion));
        let sum = minkowski_sum(&[&p, &across]);
        assert_eq!((sum.dimension(), sum.check_valid()), (3, vec![]), "{quaternion:?}");
        assert!(sum.same_set(&minkowski_sum(&[&across, &p])), "{quaternion:?}");
        let small = [flat(50), flat(30).transformed(&rotation(quaternion))];
        let sums = [minkowski_sum(&small.each_ref()), minkowski_sum_by_hull(&small.each_ref())];
        assert_same(&sums[0], &sums[1], format!("{quaternion:?}"));
    }
}

#[test]
fn geodesic_spheres() {
    let sphere = |frequency| {
        Polytope::from_mesh(&geodesic_sphere(frequency, 6), &mut Vec::new()).expect("the sphere is convex")
    };
    for (f, g) in [(2, 3), (4, 4), (3, 7)] {
        let (p, q) = (sphere(f), sphere(g).transformed(&rotation([9, 1, 2, 3])));
        let context = format!("frequencies {f} and {g}");
        assert_same(&minkowski_sum(&[&p, &q]), &minkowski_sum_by_hull(&[&p, &q]), context);
        let same = minkowski_sum(&[&sphere(f), &sphere(f)]);
        assert_eq!(same.counts(), p.counts());
    }
    let large = sphere(16);
    let sum = minkowski_sum(&[&large, &large.transformed(&rotation([9, 1, 2, 3]))]);
    assert_eq!(sum.check_valid(), []);
    assert!(sum.counts().vertices > 10_000);
}
