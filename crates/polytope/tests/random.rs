//! Sums of random polytopes by both methods. The boxes are small, so that coincidences are the rule; all
//! that were met are counted, and a suite that meets too few of a kind fails.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

use exact::{Affine3, Sign, Vector3};
use splitstar_polytope::{Polytope, minkowski_sum, minkowski_sum_by_hull, overlay_counts};
use std::collections::BTreeMap;
use testkit::{Rng, assert_same, hull_of_dimension, random_hull, rotation, scaling, translation};

const RANGES: [i64; 3] = [1, 2, 5];

/// How often each degeneracy was met.
#[derive(Default)]
struct Census(BTreeMap<&'static str, usize>);

impl Census {
    fn add(&mut self, what: &'static str, times: usize) {
        *self.0.entry(what).or_default() += times;
    }

    /// Notes what is special about a pair: totals of the overlay, and numbers of pairs for the rest.
    fn note(&mut self, p: &Polytope, q: &Polytope) {
        let counts = overlay_counts(p, q);
        self.add("crossings", counts.crossings);
        self.add("common normals", counts.common_normals);
        self.add("normals on arcs", counts.normals_on_arcs);
        self.add("arcs along arcs", counts.overlaps);
        let edges = [p, q].map(edge_vectors);
        let normals = [p, q].map(facet_normals);
        let parallel = |a: &[Vector3], b: &[Vector3], sign: Sign| {
            a.iter().any(|a| b.iter().any(|b| a.cross(b).is_zero() && a.dot(b).sign() == sign))
        };
        let has = |of: &[Vec<Vector3>; 2], test: &dyn Fn(&Vector3) -> bool| of.iter().flatten().any(test);
        let zero = |v: &Vector3, axis: usize| v.sign(axis) == Sign::Zero;
        let conditions = [
            ("pairs with parallel edges", {
                parallel(&edges[0], &edges[1], Sign::Positive)
                    || parallel(&edges[0], &edges[1], Sign::Negative)
            }),
            ("pairs with parallel facets", parallel(&normals[0], &normals[1], Sign::Positive)),
            ("pairs with opposite facets", parallel(&normals[0], &normals[1], Sign::Negative)),
            ("pairs with a normal at a pole", has(&normals, &|n| zero(n, 0) && zero(n, 1))),
            ("pairs with a normal at the same pole twice", {
                normals
                    .iter()
                    .all(|n| n.iter().any(|n| zero(n, 0) && zero(n, 1) && n.sign(2) == Sign::Positive))
            }),
            ("pairs with a normal on the identification curve", {
                has(&normals, &|n| zero(n, 1) && n.sign(0) == Sign::Negative)
            }),
            ("pairs with an arc on a meridian", has(&edges, &|e| zero(e, 2))),
            ("pairs with an arc along the identification curve", has(&edges, &|e| zero(e, 0) && zero(e, 2))),
            ("pairs with an arc on the equator", has(&edges, &|e| zero(e, 0) && zero(e, 1))),
            ("pairs of coplanar polygons", {
                [p, q].map(Polytope::dimension) == [2, 2]
                    && parallel(&normals[0], &normals[1], Sign::Positive)
            }),
            ("pairs of a polygon and a segment in its plane", {
                let flat = |p: usize, q: usize| edges[q].iter().all(|e| e.dot(&normals[p][0]).is_zero());
                match [p, q].map(Polytope::dimension) {
                    [2, 1] => flat(0, 1),
                    [1, 2] => flat(1, 0),
                    _ => false,
                }
            }),
            ("pairs of parallel segments", {
                [p, q].map(Polytope::dimension) == [1, 1] && edges[0][0].cross(&edges[1][0]).is_zero()
            }),
            ("identical pairs", p.same_set(q)),
            ("reflected pairs", p.same_set(&q.reflected())),
        ];
        for (what, is_met) in conditions {
            self.add(what, usize::from(is_met));
        }
    }

    fn merge(mut self, other: Self) -> Self {
        other.0.into_iter().for_each(|(what, times)| self.add(what, times));
        self
    }

    /// Prints all counts, and fails if one of those listed is below its minimum.
    fn require(&self, title: &str, minimum: &[(&'static str, usize)]) {
        println!("{title}:");
        self.0.iter().for_each(|(what, times)| println!("  {times:8} {what}"));
        for (what, least) in minimum {
            let times = self.0.get(what).copied().unwrap_or(0);
            assert!(times >= *least, "{title}: {times} {what}, at least {least} are wanted");
        }
    }
}

fn edge_vectors(p: &Polytope) -> Vec<Vector3> {
    p.mesh().edges().map(|h| p.edge_vector(h)).collect()
}

fn facet_normals(p: &Polytope) -> Vec<Vector3> {
    if p.dimension() < 2 {
        return Vec::new();
    }
    p.mesh().facets().map(|f| p.facet_plane(f).normal).collect()
}

/// Runs `count` cases on two threads. Case `i` has a random generator of its own, so that its seed,
/// which is printed when it fails, repeats it alone.
fn run(seed: u64, count: u64, case: impl Fn(u64, &mut Rng) -> [Polytope; 2] + Sync) -> Census {
    println!("seed {seed:#x}, case i begins with seed + i");
    let part = |first: u64| {
        let mut census = Census::default();
        for i in (first..count).step_by(2) {
            let [p, q] = case(i, &mut Rng::new(seed.wrapping_add(i)));
            let context = || format!("case {i} of seed {seed:#x}");
            let sum = minkowski_sum(&[&p, &q]);
            assert_same(&sum, &minkowski_sum_by_hull(&[&p, &q]), context());
            census.add("pairs", 1);
            census.note(&p, &q);
        }
        census
    };
    std::thread::scope(|scope| {
        let other = scope.spawn(|| part(1));
        let census = part(0);
        census.merge(other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    })
}

#[test]
fn twenty_thousand_pairs_of_solids() {
    let census = run(0x5151_0001, 20_000, |i, rng| {
        let range = RANGES[(i % 3) as usize];
        [0; 2].map(|_: u8| hull_of_dimension(rng, 3, range))
    });
    census.require(
        "solids",
        &[
            ("pairs", 20_000),
            ("crossings", 150_000),
            ("common normals", 10_000),
            ("normals on arcs", 40_000),
            ("arcs along arcs", 20_000),
            ("pairs with parallel edges", 13_000),
            ("pairs with parallel facets", 7_000),
            ("pairs with opposite facets", 7_000),
            ("pairs with a normal at a pole", 12_000),
            ("pairs with a normal at the same pole twice", 1_500),
            ("pairs with a normal on the identification curve", 12_000),
            ("pairs with an arc on a meridian", 19_000),
            ("pairs with an arc along the identification curve", 12_000),
            ("pairs with an arc on the equator", 12_000),
        ],
    );
}

#[test]
fn every_combination_of_dimensions() {
    let census = run(0x5151_0002, 4_000, |i, rng| {
        let range = RANGES[(i / 16 % 3) as usize];
        [i % 4, i / 4 % 4].map(|dimension| hull_of_dimension(rng, dimension as u8, range))
    });
    census.require(
        "every combination of dimensions",
        &[
            ("pairs", 4_000),
            ("crossings", 10_000),
            ("common normals", 900),
            ("normals on arcs", 3_000),
            ("arcs along arcs", 1_000),
            ("pairs of coplanar polygons", 5),
            ("pairs of a polygon and a segment in its plane", 50),
            ("pairs of parallel segments", 1),
        ],
    );
}

/// A polytope and another one made from it: coincidences that pairs drawn independently rarely have.
#[test]
fn pairs_that_belong_together() {
    let census = run(0x5151_0003, 4_000, |i, rng| {
        let dimension = [3, 3, 2, 1][(i / 10 % 4) as usize];
        let p = hull_of_dimension(rng, dimension, RANGES[(i % 3) as usize]);
        let q = match i % 10 {
            0 => p.clone(),
            1 => p.reflected(),
            2 => p.transformed(&scaling(2, 3)),
            3 => p.transformed(&scaling(-1, 2)),
            4 => p.transformed(&translation([1, 2, -3], 7)),
            5 => p.transformed(&rotation([1, 0, 0, 1])),
            6 => p.transformed(&rotation([1, 1, 0, 0])),
            // A half turn about an axis, and a small one: edges stay parallel, normals on one circle.
            7 => p.transformed(&rotation([0, 0, 0, 1])),
            8 => p.transformed(&rotation([7, 0, 0, 1])),
            // The convex hull of some of its vertices, seen from the origin in another size.
            _ => {
                let part: Vec<_> = p.points().iter().filter(|_| !rng.one_in(3)).cloned().collect();
                let part = if part.is_empty() { p.points().to_vec() } else { part };
                testkit::around(&part).transformed(&Affine3::scaling(&3.into()))
            }
        };
        if rng.one_in(2) { [p, q] } else { [q, p] }
    });
    census.require(
        "pairs that belong together",
        &[
            ("pairs", 4_000),
            ("common normals", 10_000),
            ("normals on arcs", 4_000),
            ("arcs along arcs", 10_000),
            ("pairs with parallel facets", 1_000),
            ("pairs with opposite facets", 1_000),
            ("pairs of coplanar polygons", 200),
            ("pairs of parallel segments", 200),
            ("identical pairs", 400),
            ("reflected pairs", 400),
        ],
    );
}

/// Points in a box without choosing the dimension: what a user would draw.
#[test]
fn pairs_of_any_dimension() {
    let census = run(0x5151_0004, 2_000, |i, rng| {
        let range = RANGES[(i % 3) as usize];
        [random_hull(rng, range), random_hull(rng, range)]
    });
    census.require("hulls of any dimension", &[("pairs", 2_000), ("crossings", 15_000)]);
}
