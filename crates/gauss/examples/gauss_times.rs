//! Times of the spherical Gaussian map on two models of the repository: maps, overlay, back to a polytope.
//!
//! `cargo run --release -p splitstar-gauss --example gauss_times -- [ROUNDS] [MODEL MODEL]`; the least of all rounds is written. With `growth
//! [FREQUENCY...]` in place of the arguments: geodesic spheres and turned ones of growing size, and the time for each edge of their sum.

use polytope::Polytope;
use splitstar_gauss::SphericalGaussianMap;
use std::hint::black_box;
use std::time::Instant;
use testkit::{geodesic_sphere, model, rotation};

/// The least of so many times of a step, in milliseconds, and what it makes.
fn least<T>(rounds: usize, step: impl Fn() -> T) -> (f64, T) {
    let timed = || {
        let start = Instant::now();
        let made = black_box(step());
        (start.elapsed().as_secs_f64() * 1e3, made)
    };
    (1..rounds).fold(timed(), |best, _| {
        let next = timed();
        if next.0 < best.0 { next } else { best }
    })
}

#[expect(clippy::print_stdout, reason = "an example that writes a table")]
fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments.first().is_some_and(|text| text == "growth") {
        return growth(&arguments[1..]);
    }
    let rounds = arguments.first().map_or(20, |text| text.parse().expect("a number of rounds"));
    let names = match &arguments[..] {
        [_, p, q] => [p.as_str(), q.as_str()],
        _ => ["convex/el16.off", "convex/oel16.xoff"],
    };
    let [p, q] = names.map(model);
    let (first, a) = least(rounds, || SphericalGaussianMap::of_polytope(&p));
    let (second, b) = least(rounds, || SphericalGaussianMap::of_polytope(&q));
    let (sum, c) = least(rounds, || a.minkowski_sum(&b));
    let (back, made) = least(rounds, || c.make_polytope());
    let (mirror, _) = least(rounds, || b.reflected());
    let (direct, _) = least(rounds, || polytope::minkowski_sum(&[&p, &q]));
    println!("{} + {}: {:?} vertices, edges, facets", names[0], names[1], made.counts().to_array());
    for (name, map) in [("first", &a), ("second", &b), ("sum", &c)] {
        let counts = map.counts_with_splits();
        println!(
            "{name}: {} vertices, {} edges, {} faces with splits",
            counts.vertices, counts.edges, counts.faces
        );
    }
    println!("map of the first    {first:8.3} ms");
    println!("map of the second   {second:8.3} ms");
    println!("sum                 {sum:8.3} ms");
    println!("maps and sum        {:8.3} ms", first + second + sum);
    println!("back to a polytope  {back:8.3} ms");
    println!("reflection          {mirror:8.3} ms");
    println!("direct overlay      {direct:8.3} ms");
}

#[expect(clippy::print_stdout, reason = "an example that writes a table")]
fn growth(arguments: &[String]) {
    let frequencies: Vec<usize> = match arguments {
        [] => vec![4, 8, 16, 32, 64],
        _ => arguments.iter().map(|text| text.parse().expect("a frequency")).collect(),
    };
    println!("  edges  of the sum  maps and sum  for each edge of the sum");
    for frequency in frequencies {
        let sphere =
            Polytope::from_mesh(&geodesic_sphere(frequency, 6), &mut Vec::new()).expect("a convex mesh");
        let turned = sphere.transformed(&rotation([7, -3, 2, 1]));
        let (time, sum) = least(3, || {
            let [a, b] = [&sphere, &turned].map(SphericalGaussianMap::of_polytope);
            a.minkowski_sum(&b)
        });
        let (edges, of_sum) = (sphere.counts().edges, sum.counts_with_splits().edges);
        println!("{edges:7}  {of_sum:10}  {time:9.2} ms  {:6.0} ns", time * 1e6 / of_sum as f64);
    }
}
