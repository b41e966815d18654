//! A million triangles of binary STL: how long we read, and how long trimesh.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use serde_json::{Value, json};

use crate::{Failure, shell, solids};

/// Triangles of the file.
const TRIANGLES: usize = 1_000_000;
/// Parts of an edge of the icosahedron: the first with so many triangles.
const FREQUENCY: usize = 224;
/// The fastest of this many runs counts.
const RUNS: usize = 5;
/// And of this many where the numbers are only printed.
const ROUGH_RUNS: usize = 2;

/// The fastest times in seconds.
#[derive(Debug)]
pub(super) struct Times {
    pub(super) ours: f64,
    /// As `trimesh.load(FILE)` does it: equal vertices are merged, as we do.
    pub(super) trimesh: f64,
    /// With `process=False`: the triangles as they stand.
    pub(super) raw: f64,
}

/// Which build of ours is timed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Build {
    /// One for release, made here.
    Release,
    /// This program itself, with its overflow checks; the numbers are rough ones.
    This,
}

/// Times ours and the script with that Python, one after the other.
///
/// # Errors
/// If the file cannot be written, if one of them fails, or if they do not find the same vertices and triangles.
pub(super) fn times(folder: &Path, mut script: Command, build: Build) -> Result<Times, Failure> {
    let file = folder.join("million.stl");
    fs::write(&file, sphere())?;
    let (ours, runs) = match build {
        Build::Release => (release(&file)?, RUNS),
        Build::This => (fastest(&file, ROUGH_RUNS)?, ROUGH_RUNS),
    };
    let theirs: Value =
        serde_json::from_str(shell::output(script.arg("time").arg(&file).arg(runs.to_string()))?.trim())?;
    for what in ["triangles", "vertices"] {
        if ours[what] != theirs[what] {
            return Err(format!(
                "{what} of {}: we find {}, trimesh {}",
                file.display(),
                ours[what],
                theirs[what]
            )
            .into());
        }
    }
    let seconds = |value: &Value| value.as_f64().ok_or("a time is missing");
    Ok(Times {
        ours: seconds(&ours["seconds"])?,
        trimesh: seconds(&theirs["seconds"])?,
        raw: seconds(&theirs["raw_seconds"])?,
    })
}

/// What [`time`] prints in a build for release.
fn release(file: &Path) -> Result<Value, Failure> {
    println!("building for release ...");
    let cargo = |words: &[&str]| {
        let mut command = shell::cargo();
        command.args(words).args(["--release", "--quiet", "--package", "xtask"]);
        command
    };
    shell::output(&mut cargo(&["build"]))?;
    Ok(serde_json::from_str(shell::output(cargo(&["run"]).args(["--", "readers-time"]).arg(file))?.trim())?)
}

/// Reads the file several times and prints the fastest time with the counts.
///
/// # Errors
/// If it cannot be read.
pub(crate) fn time(path: &str) -> Result<(), Failure> {
    println!("{}", fastest(Path::new(path), RUNS)?);
    Ok(())
}

/// The fastest time from the disk to the model, with the counts.
fn fastest(path: &Path, runs: usize) -> Result<Value, Failure> {
    let mut best = f64::INFINITY;
    let mut counts = [0; 2];
    for _ in 0..runs {
        let begin = Instant::now();
        let bytes = fs::read(path)?;
        let read = formats::read(&bytes, Some("million.stl"))?;
        best = best.min(begin.elapsed().as_secs_f64());
        let mesh = read.model.shape.mesh().ok_or("it is no mesh")?;
        counts = [mesh.points.len(), mesh.facets.len()];
    }
    let [vertices, triangles] = counts;
    Ok(json!({ "seconds": best, "vertices": vertices, "triangles": triangles }))
}

/// A part of a sphere as binary STL, written without our writer.
fn sphere() -> Vec<u8> {
    let solid = solids::geodesic_sphere(FREQUENCY);
    let count = u32::try_from(TRIANGLES).expect("a million is a small number");
    let mut bytes = vec![0; 80];
    bytes.extend(count.to_le_bytes());
    for facet in solid.facets.iter().take(TRIANGLES) {
        bytes.extend([0; 12]); // no normal: readers make their own
        for coordinate in facet.iter().flat_map(|&corner| solid.points[corner]) {
            let float = (coordinate as f64 / solid.denominator as f64) as f32;
            bytes.extend(float.to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}
