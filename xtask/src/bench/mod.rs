//! `cargo xtask bench`: how time and memory grow, and what the width of the coordinates costs.
//!
//! | file | role |
//! |---|---|
//! | `growth` | geodesic spheres and bipyramids of growing size: time and peak memory per feature |
//! | `arrangements` | short segments of growing number: time per event |
//! | `editing` | curves inserted one by one into growing arrangements, faces with thousands of holes: time and counted work per step (`counted`) |
//! | `location` | points in growing arrangements: time and predicates per query |
//! | `gauss` | Gaussian maps of geodesic spheres of growing size, on the sphere and on a cube: time per feature |
//! | `sphere` | random arcs on a sphere: time and counted work of a sweep, of insertion one by one, and of queries |
//! | `widths` | a histogram of coordinate widths, and the speed at given widths |
//!
//! `bench repeat A B N` sums two files N times and does nothing else: what a profiler looks at. The difference of two N is the
//! cost of a sum without reading.
//!
//! Every case runs in a process of its own (`bench --case A B`), so that its peak memory is its own.

mod arrangements;
mod counted;
mod editing;
mod gauss;
mod growth;
mod location;
mod sphere;
mod widths;

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::library;
use crate::{Failure, shell};

/// Runs one of the measurements, or all.
///
/// # Errors
/// If an input cannot be written or summed.
pub(crate) fn run(words: &[&str]) -> Result<(), Failure> {
    match words {
        [] => [growth::run, arrangements::run, editing::run, location::run, sphere::run, gauss::run, widths::run]
            .iter()
            .try_for_each(|run| run()),
        ["growth"] => growth::run(),
        ["arrangements"] => arrangements::run(),
        ["editing"] => editing::run(),
        ["location"] => location::run(),
        ["sphere"] => sphere::run(),
        ["gauss"] => gauss::run(),
        ["widths"] => widths::run(),
        ["--case", a, b] => case(&[PathBuf::from(a), PathBuf::from(b)]),
        ["repeat", a, b, times] => repeat(&[PathBuf::from(a), PathBuf::from(b)], times.parse()?),
        _ => {
            Err("usage: cargo xtask bench [growth|arrangements|editing|location|sphere|gauss|widths|repeat A B N]"
                .into())
        }
    }
}

/// Sums two files that many times.
fn repeat(operands: &[PathBuf; 2], times: usize) -> Result<(), Failure> {
    let measured = library::measured_sum(operands, times, 0.0)?;
    let [build, _, sum] = measured.phases;
    println!("{}: {:.6} s (operands {build:.6}, sum {sum:.6})", measured.sum, measured.seconds);
    Ok(())
}

/// What a process of its own measured.
#[derive(Debug, Clone, Copy)]
struct Case {
    /// V + E + F of both operands and of the sum.
    features: f64,
    /// Median time, and its parts: making the operands, and the sum.
    seconds: f64,
    phases: [f64; 2],
    /// Peak memory of a process that reads and sums once.
    peak_bytes: f64,
}

/// The process of one case: sums once and looks at its peak memory, then sums again and again for the time.
fn case(operands: &[PathBuf; 2]) -> Result<(), Failure> {
    let once = library::measured_sum(operands, 1, 0.0)?;
    let peak = peak_kib()?;
    let many = library::measured_sum(operands, 3, 1.0)?;
    let features: usize = once.operands.iter().chain([&once.sum]).map(|counts| counts.features()).sum();
    let [operands, _, sum] = many.phases;
    let answer = json!({
        "features": features,
        "seconds": many.seconds,
        "operands": operands,
        "sum": sum,
        "peak_bytes": peak * 1024,
    });
    println!("{answer}");
    Ok(())
}

/// Starts the process of one case.
fn measure(a: &Path, b: &Path) -> Result<Case, Failure> {
    let program = std::env::current_exe()?;
    let text = shell::output(shell::program(program).args(["bench", "--case"]).arg(a).arg(b))?;
    let answer: Value = serde_json::from_str(text.trim())?;
    let number =
        |key: &str| answer[key].as_f64().ok_or_else(|| format!("no `{key}` in the answer of the case"));
    Ok(Case {
        features: number("features")?,
        seconds: number("seconds")?,
        phases: [number("operands")?, number("sum")?],
        peak_bytes: number("peak_bytes")?,
    })
}

/// The largest resident set of this process so far.
pub(crate) fn peak_kib() -> Result<u64, Failure> {
    let status = fs::read_to_string("/proc/self/status")
        .map_err(|error| format!("peak memory needs Linux: {error}"))?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).ok_or("no VmHWM in the status")?;
    let word = line.split_whitespace().next().ok_or("no number in VmHWM")?;
    Ok(word.parse()?)
}

/// Writes an input beside those of the peers.
fn write_input(name: &str, text: &str) -> Result<PathBuf, Failure> {
    let folder = shell::root().join("peers/inputs");
    fs::create_dir_all(&folder)?;
    let path = folder.join(format!("{name}.xoff"));
    fs::write(&path, text)?;
    Ok(path)
}
