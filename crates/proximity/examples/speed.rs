//! Nanoseconds a query, one thread, for icospheres of 162 and 2,562 vertices of diameter 2 against each other, one of them
//! turned so that no facets are parallel.
//!
//! *Coherent*: steps of 1/1,000 of the diameter, each query with the witness of the last one. *Random*: uniform in the ball of radius
//! 1.5 diameters, without a witness. The seed is fixed. Translations are floats, made before the clock runs.
//!
//! `cargo run --release -p splitstar-proximity --example speed`

// A benchmark prints and looks at the clock.
#![allow(clippy::print_stdout)]

use polytope::Polytope;
use splitstar_proximity::{Pair, Relation, RelativePlacement, Translation, Witness};
use std::hint::black_box;
use std::time::Instant;
use testkit::{Rng, around, geodesic_sphere, rotation};

const DIAMETER: f64 = 2.0;

fn main() {
    let only = std::env::args().nth(1);
    for frequency in [4, 16] {
        let sphere = around(&geodesic_sphere(frequency, 6).points);
        let turned = sphere.transformed(&rotation([7, 1, 2, 3]));
        let begin = Instant::now();
        let spheres = RelativePlacement::new(&sphere, &turned);
        let counts = spheres.sum().counts().to_array();
        println!(
            "{} vertices; the sum has {counts:?} and is made in {:.0?}",
            sphere.points().len(),
            begin.elapsed()
        );
        let is_wanted = |name: &str| only.as_ref().is_none_or(|only| name.contains(only.as_str()));
        let of = &spheres;
        if is_wanted("distance") {
            let query = |s: &Translation, hint| Some(of.separation(s, hint).witness());
            rows("distance, disjoint", of, &|relation| relation == Relation::Disjoint, &query);
        }
        if is_wanted("relation") {
            rows("relation, mixed", of, &|_| true, &|s, hint| Some(of.relation(s, hint).1));
        }
        if is_wanted("penetration") {
            let query = |s: &Translation, hint| of.minimum_penetration(s, hint).map(|found| found.witness());
            rows("minimum penetration", of, &|relation| relation == Relation::Overlapping, &query);
        }
        if is_wanted("without") {
            without_sum(of, &sphere, &turned);
        }
    }
}

type Query<'a> = dyn Fn(&Translation, Option<Witness>) -> Option<Witness> + 'a;

fn rows(name: &str, of: &RelativePlacement, is_wanted: &dyn Fn(Relation) -> bool, query: &Query<'_>) {
    let rng = &mut Rng::new(9);
    let path = path(rng, of, is_wanted);
    let scattered = scattered(rng, of, is_wanted);
    // The hierarchy is made by the first query.
    query(&path[0], None);
    let coherent = measure(&path, |s, hint| query(s, hint));
    let random = measure(&scattered, |s, _| query(s, None));
    println!("{name:20} coherent {coherent:8.0} ns, random {random:8.0} ns");
}

fn without_sum(of: &RelativePlacement, p: &Polytope, q: &Polytope) {
    let pair = Pair::new(p, q);
    let rng = &mut Rng::new(9);
    let mut row = |name: &str, is_wanted: &dyn Fn(Relation) -> bool, query: &Query<'_>| {
        let scattered = scattered(rng, of, is_wanted);
        let random = measure(&scattered[..100], |s, hint| query(s, hint));
        println!("{name:20} random {random:8.0} ns, without the sum");
    };
    let distance = |s: &Translation, hint| Some(pair.separation(s, None, hint).witness());
    row("distance, disjoint", &|relation| relation == Relation::Disjoint, &distance);
    row("relation, mixed", &|_| true, &|s, hint| Some(pair.relation(s, None, hint).1));
    let depth = |s: &Translation, hint| pair.minimum_penetration(s, None, hint).map(|found| found.witness());
    row("minimum penetration", &|relation| relation == Relation::Overlapping, &depth);
}

/// The least mean of some runs.
fn measure(
    placements: &[Translation],
    mut query: impl FnMut(&Translation, Option<Witness>) -> Option<Witness>,
) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..5 {
        let begin = Instant::now();
        let mut witness = None;
        for s in placements {
            witness = black_box(query(black_box(s), witness));
        }
        least = least.min(begin.elapsed().as_nanos() as f64 / placements.len() as f64);
    }
    least
}

fn unit(rng: &mut Rng) -> f64 {
    (rng.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

fn ball(rng: &mut Rng, radius: f64) -> [f64; 3] {
    loop {
        let point = [0; 3].map(|_: u8| unit(rng));
        if point.iter().map(|c| c * c).sum::<f64>() < 1.0 {
            return point.map(|c| c * radius);
        }
    }
}

fn scattered(
    rng: &mut Rng,
    of: &RelativePlacement,
    is_wanted: &dyn Fn(Relation) -> bool,
) -> Vec<Translation> {
    let point = |_: usize| Translation::from_f64(ball(rng, 1.5 * DIAMETER)).expect("a finite point");
    (0..).map(point).filter(|s| is_wanted(of.relation(s, None).0)).take(20_000).collect()
}

/// A way of fixed steps that turns a little with each, and goes elsewhere where it would leave what is wanted.
fn path(rng: &mut Rng, of: &RelativePlacement, is_wanted: &dyn Fn(Relation) -> bool) -> Vec<Translation> {
    let step = DIAMETER / 1000.0;
    let fits = |place: [f64; 3]| {
        let s = Translation::from_f64(place).expect("a finite point");
        let norm = place.iter().map(|c| c * c).sum::<f64>().sqrt();
        (norm < 1.5 * DIAMETER && is_wanted(of.relation(&s, None).0)).then_some(s)
    };
    let mut place = loop {
        let place = ball(rng, 1.5 * DIAMETER);
        if fits(place).is_some() {
            break place;
        }
    };
    let mut heading = ball(rng, 1.0);
    let mut path = Vec::new();
    while path.len() < 20_000 {
        let turn = ball(rng, 0.05);
        heading = [0, 1, 2].map(|i: usize| heading[i] + turn[i]);
        let length = heading.iter().map(|c| c * c).sum::<f64>().sqrt();
        heading = heading.map(|c| c / length);
        let next = [0, 1, 2].map(|i: usize| place[i] + step * heading[i]);
        match fits(next) {
            Some(s) => {
                place = next;
                path.push(s);
            }
            None => heading = ball(rng, 1.0),
        }
    }
    path
}
