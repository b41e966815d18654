//! The example of `docs/write-your-own-curve.md`: the document, the laws of the model, and the engine around it.

#![allow(clippy::unwrap_used)]

#[path = "../../examples/own_curve.rs"]
mod own_curve;

mod engine;
mod lattice;
mod laws;

use own_curve::Curve;

const CODE: &str = include_str!("../../examples/own_curve.rs");
const PAGE: &str = include_str!("../../../../docs/write-your-own-curve.md");

#[test]
fn the_document_has_the_whole_example() {
    let blocks = PAGE.split("```rust\n").skip(1).map(|rest| rest.split("```").next().unwrap());
    let page: Vec<&str> = blocks.flat_map(str::lines).filter(|line| !line.is_empty()).collect();
    let code = CODE.lines().skip_while(|line| !line.starts_with("use "));
    let code: Vec<&str> = code.filter(|line| !line.is_empty()).collect();
    for (written, compiled) in page.iter().zip(&code) {
        assert_eq!(written, compiled);
    }
    assert_eq!(page.len(), code.len());
}

#[test]
fn the_model_has_less_than_150_lines() {
    let model = CODE.lines().skip_while(|line| !line.starts_with("use "));
    let lines = model.take_while(|line| !line.starts_with("// Optional")).count();
    assert!((100..150).contains(&lines), "{lines} lines");
}

#[test]
fn the_example_runs() {
    own_curve::main();
}

/// Numbers without a pattern: splitmix64.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u32) -> u32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 33) as u32 % bound
    }

    fn coordinate(&mut self, size: u32) -> i32 {
        self.below(size) as i32
    }

    /// A curve in a small field, where almost everything is degenerate.
    fn curve(&mut self, size: u32) -> Curve {
        let point = [self.coordinate(size), self.coordinate(size)];
        match self.below(2) {
            0 => Curve::Circle { centre: point, radius: self.below(size / 2 + 1) },
            _ => {
                let range = [self.coordinate(size), self.coordinate(size)];
                Curve::Arc { tip: point, opens_up: self.below(2) == 0, range }
            }
        }
    }

    fn curves(&mut self, count: u32, size: u32) -> Vec<Curve> {
        (0..count).map(|_| self.curve(size)).collect()
    }
}
