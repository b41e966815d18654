//! Nanoseconds per call of predicates and constructions, at several widths, and which tier decided.
//!
//! `cargo bench -p splitstar-exact --bench predicates` for the times; with `--features count-tiers` also the tiers (the counters cost time).

#![allow(clippy::print_stdout)]

mod common;

use common::{INPUTS, Random, time};
use exact::predicate::{circle_order, orientation, plane_side, same_direction, side_of_circle};
use exact::{Integer, Point3, Sign, Vector3};

impl Random {
    /// A value of the given number of bits and any sign.
    fn integer(&mut self, bits: u32) -> Integer {
        let mut value = Integer::ZERO;
        for _ in 0..bits.div_ceil(64) {
            value = (value << 64) + Integer::from(self.next());
        }
        let value = value.div_rem(&(Integer::ONE << bits)).1;
        if self.next() & 1 == 0 { -value } else { value }
    }

    fn vector(&mut self, bits: u32) -> Vector3 {
        Vector3::new([(); 3].map(|()| self.integer(bits)))
    }
}

struct Case {
    a: Vector3,
    b: Vector3,
    c: Vector3,
    normal: Vector3,
    other: Vector3,
    on: Point3,
    p: Point3,
}

fn cases(bits: u32, degenerate: bool) -> Vec<Case> {
    let mut random = Random(u64::from(bits));
    let point = |v: &Vector3| Point3::new(v.coordinates(), Integer::ONE).expect("one is positive");
    (0..INPUTS)
        .map(|_| {
            let (a, b) = (random.vector(bits - 1), random.vector(bits - 1));
            let c = if degenerate { &a - &b } else { random.vector(bits) };
            let (normal, other) = (a.cross(&b), b.cross(&c));
            let (on, p) = (point(&a), point(&c));
            Case { a, b, c, normal, other, on, p }
        })
        .collect()
}

#[cfg(feature = "count-tiers")]
fn decided<T>(inputs: &[T], mut call: impl FnMut(&T) -> Sign) -> String {
    use exact::tier::{Stage, thread_counts};
    let before = thread_counts();
    for input in inputs {
        call(input);
    }
    let counts = thread_counts() - before;
    let share = |stage: &Stage| {
        let count = counts.of(*stage);
        (count > 0).then(|| format!(" {stage:?} {:.0}%", 100.0 * count as f64 / counts.total() as f64))
    };
    Stage::ALL.iter().filter_map(share).collect()
}

#[cfg(not(feature = "count-tiers"))]
fn decided<T>(_inputs: &[T], _call: impl FnMut(&T) -> Sign) -> String {
    String::new()
}

/// A predicate on some of the vectors of a case.
type Call = fn(&Case) -> Sign;

fn main() {
    let predicates: [(&str, Call); 6] = [
        ("side_of_circle", |x| side_of_circle(&x.normal, &x.c)),
        ("orientation", |x| orientation(&x.a, &x.b, &x.c)),
        ("same_direction", |x| same_direction(&x.a, &x.c)),
        ("same_direction of normals", |x| same_direction(&x.normal, &x.other)),
        ("circle_order", |x| circle_order(&x.b, &x.normal, &x.other)),
        ("plane_side", |x| plane_side(&x.normal, &x.on, &x.p)),
    ];
    for degenerate in [false, true] {
        println!("{}", if degenerate { "\ndegenerate: c = a - b" } else { "random" });
        for (name, call) in predicates {
            for bits in [20, 32, 53, 62, 64, 128, 256] {
                let inputs = cases(bits, degenerate);
                let (ns, tiers) = (time(&inputs, call), decided(&inputs, call));
                println!("{name:28} {bits:4} bits {ns:9.1} ns {tiers}");
            }
        }
    }
    println!("\nconstructions");
    for bits in [20, 32, 53, 62, 64, 128, 256] {
        let inputs = cases(bits, false);
        let cross = time(&inputs, |x| x.a.cross(&x.b));
        let primitive = time(&inputs, |x| x.normal.primitive());
        let direction = time(&inputs, |x| x.on.direction_to(&x.p));
        println!(
            "{bits:4} bits: cross {cross:.1} ns, primitive normal {primitive:.1} ns, direction_to {direction:.1} ns"
        );
    }
}
