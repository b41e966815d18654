//! Changed files, many: the reader answers at once, and what it accepts it can write and read again.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

use splitstar_formats::{Format, Kind, Model, WriteOptions, read, write};
use std::path::Path;
use std::time::{Duration, Instant};
use testkit::{Rng, mutate};

const SEED: u64 = 0x0FF5_EED0;
const CASES: usize = 20_000;

const SPLICES: &[&[u8]] = &[
    b"-",
    b"+",
    b".",
    b"e",
    b"/",
    b"#",
    b"\n",
    b"\r",
    b"\r\n",
    b" ",
    b"\0",
    b"\xFF",
    b"0",
    b"9",
    b"OFF",
    b"BINARY",
    b"1e400",
    b"1e-400",
    b"1e401",
    b"1e99999999999",
    b"1/0",
    b"1/3",
    b"-7/999999999999999999",
    b"nan",
    b"inf",
    b"4294967295",
    b"4294967294",
    b"18446744073709551616",
    b"-1",
    b"0.1",
    b"2 0 1",
    b"3 0 1 2",
    b"1 0",
    b"STCN",
    b"123456789012345678901234567890",
    b"0.000000000000000000000000000000001",
];

#[test]
fn changed_files_never_break_the_reader() {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let bases = [
        "convex/cube.off",
        "convex/dp.off",
        "convex/odp.xoff",
        "invalid/flat.off",
        "invalid/huge_counts.off",
        "invalid/zero_facets.off",
    ]
    .map(|name| std::fs::read(models.join(name)).unwrap());
    println!("seed {SEED:#x}, {CASES} cases");
    let mut random = Rng::new(SEED);
    let (mut accepted, mut slowest) = (0, Duration::ZERO);
    for case in 0..CASES {
        let mut text = bases[random.index(bases.len())].clone();
        for _ in 0..=random.index(4) {
            mutate(&mut text, SPLICES, &mut random);
        }
        let start = Instant::now();
        let result = read(&text, Some("off"));
        slowest = slowest.max(start.elapsed());
        match result {
            Ok(model) => {
                accepted += 1;
                let mesh = model.model.shape.into_mesh().unwrap();
                assert!(mesh.points.capacity() <= text.len() / 3 + 4, "case {case}");
                let model = Model::of_mesh(mesh.clone());
                let written = write(&model, &WriteOptions::new(Format::Off)).unwrap().bytes;
                let again = read(&written, None)
                    .map(|read| read.model.shape.into_mesh().unwrap())
                    .unwrap_or_else(|error| panic!("case {case}: {error}"));
                assert_eq!(again.points, mesh.points, "case {case}");
                assert_eq!(again.facets, mesh.facets, "case {case}");
                assert_eq!(Kind::of(&again), Kind::of(&mesh), "case {case}");
            }
            Err(error) => {
                let message = error.to_string();
                assert!(message.len() < 300 && !message.contains('\n'), "case {case}: {message}");
                assert!(!message.contains(char::is_control), "case {case}: {message}");
            }
        }
    }
    println!("{accepted} accepted, slowest {slowest:?}");
    assert!(accepted > CASES / 20 && accepted < CASES * 19 / 20, "{accepted} of {CASES} accepted");
    assert!(slowest < Duration::from_secs(2), "{slowest:?}");
}
