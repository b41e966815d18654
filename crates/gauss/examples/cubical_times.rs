//! Times of the cubical Gaussian map on two models of the repository: maps, overlay, back to a polytope.
//!
//! `cargo run --release -p splitstar-gauss --example cubical_times -- [ROUNDS] [MODEL MODEL]`; the least of all rounds is written.

use splitstar_gauss::CubicalGaussianMap;
use std::hint::black_box;
use std::time::Instant;
use testkit::model;

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
    let rounds = arguments.first().map_or(20, |text| text.parse().expect("a number of rounds"));
    let names = match &arguments[..] {
        [_, p, q] => [p.as_str(), q.as_str()],
        _ => ["convex/el16.off", "convex/oel16.xoff"],
    };
    let [p, q] = names.map(model);
    let (first, a) = least(rounds, || CubicalGaussianMap::of_polytope(&p));
    let (second, b) = least(rounds, || CubicalGaussianMap::of_polytope(&q));
    let (sum, c) = least(rounds, || a.minkowski_sum(&b));
    let (back, made) = least(rounds, || c.make_polytope());
    let (mirror, _) = least(rounds, || b.reflected());
    let (direct, _) = least(rounds, || polytope::minkowski_sum(&[&p, &q]));
    println!("{} + {}: {:?} vertices, edges, facets", names[0], names[1], made.counts().to_array());
    for (name, map) in [("first", &a), ("second", &b), ("sum", &c)] {
        let counts = map.arrangement().counts_with_artificial();
        println!(
            "{name}: {} vertices, {} edges, {} faces of all sides",
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
