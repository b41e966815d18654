//! Reading a Gaussian map takes no more than 64 times the file and 64 MiB. Each file in a process of its own: the peak is that
//! of the process, and what one has freed another may take without a trace.

// What was measured is worth seeing: `cargo test --test star_gaussian_memory -- --nocapture`.
#![allow(clippy::print_stdout, clippy::unwrap_used)]
#![cfg(target_os = "linux")]

use gauss::{CubicalGaussianMap, SphericalGaussianMap};
use polytope::Polytope;
use splitstar_formats::{StarGaussianMap, read_gaussian_map, write_gaussian_map};
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Instant;
use testkit::geodesic_sphere;

const MIB: u64 = 1 << 20;

/// The greatest resident size so far.
fn peak() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("VmHWM")).unwrap();
    let kib: u64 = line.split_whitespace().nth(1).unwrap().parse().unwrap();
    kib << 10
}

/// Nothing but the points of a polytope, in as few bytes as can be: on a paraboloid, so that all of them are vertices.
fn points(surface: &str, side: i64) -> String {
    let mut text = format!("star 1 gaussian\nsurface {surface}\n");
    for x in 0..side {
        for y in 0..side {
            writeln!(text, "primal {x} {y} {}", x * x + y * y).unwrap();
        }
    }
    text + "end\n"
}

/// Few points with very many digits.
fn wide(surface: &str, count: u64) -> String {
    let mut text = format!("star 1 gaussian\nsurface {surface}\n");
    for i in 0..count {
        let digits = "7".repeat(900);
        writeln!(text, "primal {i}{digits} {}{digits} {}{digits}", i * i % 97, i * 31 % 89).unwrap();
    }
    text + "end\n"
}

/// Names the file for the process of one case.
const CASE: &str = "STAR_GAUSSIAN_CASE";

/// The process of one case; without a file, it does nothing.
#[test]
fn one_case() {
    let Some(file) = std::env::var_os(CASE) else { return };
    let bytes = fs::read(file).unwrap();
    let before = peak() - bytes.len() as u64;
    let start = Instant::now();
    let result = read_gaussian_map(&bytes, None);
    let taken = peak() - before;
    let refused = result.as_ref().err().map_or("read".into(), |error| error.to_string());
    println!("case: {taken} {} ms: {refused}", start.elapsed().as_millis());
}

#[test]
fn reading_is_within_the_bound() {
    let sphere = Polytope::from_mesh(&geodesic_sphere(24, 9), &mut Vec::new()).unwrap();
    let text = |map: StarGaussianMap| String::from_utf8(write_gaussian_map(&map)).unwrap();
    // Of these points, as many as are not too many at once.
    let texts = [
        ("whole map on the sphere", text(SphericalGaussianMap::of_polytope(&sphere).into()), "read"),
        ("whole map on a cube", text(CubicalGaussianMap::of_polytope(&sphere).into()), "read"),
        ("points, sphere", points("sphere -1 0", 80), "line 3: the map of the hull"),
        ("points, cube", points("cube", 80), "line 3: the map of the hull"),
        ("more points", points("cube", 90), "line 6870: reading it would take more"),
        ("many points", points("cube", 700), "line 66180: reading it would take more"),
        ("wide points, sphere", wide("sphere -1 0", 60), "line 3: the map of the hull"),
        ("wide points, cube", wide("cube", 60), "line 3: the map of the hull"),
    ];
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("star_gaussian_memory.star");
    for (name, text, expected) in texts {
        fs::write(&file, &text).unwrap();
        let mut command = Command::new(std::env::current_exe().unwrap());
        let output = command.args(["--exact", "one_case", "--nocapture"]).env(CASE, &file).output().unwrap();
        let output = String::from_utf8(output.stdout).unwrap();
        let (_, case) = output.split_once("case: ").unwrap_or_else(|| panic!("{name}: {output}"));
        let mut words = case.splitn(2, ' ');
        let taken: u64 = words.next().unwrap().parse().unwrap();
        let bound = 64 * text.len() as u64 + 64 * MIB;
        println!("{name}: {} MiB of {} for {} bytes, {case}", taken / MIB, bound / MIB, text.len());
        assert!(taken <= bound, "{name}: {} MiB of {}", taken / MIB, bound / MIB);
        assert!(case.contains(expected), "{name}: {case}");
    }
}
