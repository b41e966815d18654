//! Reading a Gaussian map takes no more than 64 times the file and 64 MiB. Each file in a process of its own: the peak is that
//! of the process, and what one has freed another may take without a trace.

// What was measured is worth seeing: `cargo test --test star_gaussian_memory -- --nocapture`.
#![allow(clippy::print_stdout, clippy::unwrap_used)]
#![cfg(target_os = "linux")]

use exact::{Affine3, Point3, Rational};
use gauss::{CubicalGaussianMap, SphericalGaussianMap};
use polytope::{Polytope, convex_hull};
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

/// The prism over the points (i, i^2), as far from the origin as told: a vertex of degree three for each face, and few digits in edges.
fn prism(sides: i64, offset: &str) -> Polytope {
    let corners = (0..sides).flat_map(|x| [0, 1].map(|z| Point3::from_i64([x, x * x, z])));
    let prism = convex_hull(&corners.collect::<Vec<_>>()).unwrap();
    let offset: Rational = offset.parse().unwrap();
    prism.transformed(&Affine3::translation(&[(); 3].map(|()| offset.clone())))
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
    let texts = [
        ("whole map on the sphere", text(SphericalGaussianMap::of_polytope(&sphere).into())),
        ("whole map on a cube", text(CubicalGaussianMap::of_polytope(&sphere).into())),
        ("whole map of a prism", text(SphericalGaussianMap::of_polytope(&prism(20_000, "0")).into())),
        ("whole map of a prism on a cube", text(CubicalGaussianMap::of_polytope(&prism(20_000, "0")).into())),
        ("whole map far away", text(SphericalGaussianMap::of_polytope(&prism(8_000, "1e16")).into())),
        ("whole map farther away", text(SphericalGaussianMap::of_polytope(&prism(3_000, "1e60")).into())),
        (
            "whole map with a denominator",
            text(
                CubicalGaussianMap::of_polytope(&prism(
                    3_000,
                    "1000000000000000000000000000000000000000000/7",
                ))
                .into(),
            ),
        ),
        ("points, sphere", points("sphere -1 0", 90)),
        ("points, cube", points("cube", 90)),
        ("many points", points("cube", 700)),
        ("wide points, sphere", wide("sphere -1 0", 60)),
        ("wide points, cube", wide("cube", 60)),
    ];
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("star_gaussian_memory.star");
    let mut wrong = Vec::new();
    for (name, text) in texts {
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
        if case.trim_end().lines().next().is_some_and(|case| case.ends_with(": read"))
            != name.starts_with("whole")
        {
            wrong.push(format!("{name}: {case}"));
        }
    }
    assert_eq!(wrong, [""; 0]);
}
