//! A million triangles of binary STL: how long we read, and how long trimesh.

use std::fs;
use std::path::Path;
use std::time::Instant;

use serde_json::Value;

use crate::{Failure, shell, solids};

/// Triangles of the file.
const TRIANGLES: usize = 1_000_000;
/// Parts of an edge of the icosahedron: the first with so many triangles.
const FREQUENCY: usize = 224;
/// The fastest of this many runs counts.
const RUNS: usize = 5;

/// The fastest times in seconds.
#[derive(Debug)]
pub(super) struct Times {
    pub(super) ours: f64,
    /// As `trimesh.load(FILE)` does it: equal vertices are merged, as we do.
    pub(super) trimesh: f64,
    /// With `process=False`: the triangles as they stand.
    pub(super) raw: f64,
}

/// Times a release build of ours and the script with that Python, one after the other.
///
/// # Errors
/// If the file cannot be written, if one of them fails, or if they do not find the same vertices and triangles.
pub(super) fn times(folder: &Path, mut script: std::process::Command) -> Result<Times, Failure> {
    let file = folder.join("million.stl");
    fs::write(&file, sphere())?;
    println!("building for release ...");
    let mut build = shell::cargo();
    shell::output(build.args(["build", "--release", "--quiet", "--package", "xtask"]))?;
    let mut ours = shell::cargo();
    ours.args(["run", "--release", "--quiet", "--package", "xtask", "--", "readers-time"]).arg(&file);
    let ours: Value = serde_json::from_str(shell::output(&mut ours)?.trim())?;
    let theirs: Value =
        serde_json::from_str(shell::output(script.arg("time").arg(&file).arg(RUNS.to_string()))?.trim())?;
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

/// Reads the file several times, from the disk on, and prints the fastest time with the counts.
///
/// # Errors
/// If it cannot be read.
pub(crate) fn time(path: &str) -> Result<(), Failure> {
    let mut best = f64::INFINITY;
    let mut counts = [0; 2];
    for _ in 0..RUNS {
        let begin = Instant::now();
        let bytes = fs::read(path)?;
        let read = formats::read(&bytes, Some(path))?;
        best = best.min(begin.elapsed().as_secs_f64());
        let mesh = read.model.shape.mesh().ok_or("it is no mesh")?;
        counts = [mesh.points.len(), mesh.facets.len()];
    }
    let [vertices, triangles] = counts;
    println!("{}", serde_json::json!({ "seconds": best, "vertices": vertices, "triangles": triangles }));
    Ok(())
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
