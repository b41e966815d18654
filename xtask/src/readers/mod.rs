//! `cargo xtask readers`: other programs read what we write, and we read what they write.
//!
//! | file | role |
//! |---|---|
//! | `ours` | every model in every format, read back and compared exactly |
//! | `theirs` | files of other programs, read by us |
//! | `speed` | a million triangles: our reader and trimesh in one run |
//! | `table` | what each reader said of each file |

mod ours;
mod speed;
mod table;
mod theirs;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use crate::{Failure, python, shell};
pub(crate) use speed::time;
use speed::{Build, Times};
use table::{Cell, Row};

/// How much is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Demand {
    /// What is not installed is skipped, and the speed is printed.
    Nothing,
    /// The same, with this build instead of one for release, which takes a while to make.
    Rough,
    /// As before, but the packages of Python must be there. The speed is not asked for: the machine may be busy.
    Packages,
    /// The packages must be there, and we must be as fast as trimesh.
    All,
}

/// The verb with its options.
///
/// # Errors
/// As [`check`].
pub(crate) fn run(words: &[&str]) -> Result<(), Failure> {
    match words {
        [] => check(Demand::Nothing),
        ["--require"] => check(Demand::All),
        _ => Err("the only option is --require".into()),
    }
}

/// Writes, lets the others read, reads theirs, measures, and prints the tables.
///
/// # Errors
/// If any file is not read as it should, or what is asked for is not there.
pub(crate) fn check(demand: Demand) -> Result<(), Failure> {
    let folder = shell::root().join("target/readers");
    let (ours, theirs) = (folder.join("ours"), folder.join("theirs"));
    for folder in [&ours, &theirs] {
        if folder.exists() {
            fs::remove_dir_all(folder)?;
        }
        fs::create_dir_all(folder)?;
    }
    println!("writing our files and reading them back ...");
    let mut rows = ours::write(&ours)?;
    let mut failures = Vec::new();
    match environment() {
        Ok(python) => {
            println!("reading with other programs ...");
            rows.extend(others(&python, &ours)?);
            shell::output(script(&python).arg("write").arg(&theirs))?;
            rows.extend(theirs::read(&theirs)?);
            table::print(&rows);
            let build = match demand {
                Demand::Rough | Demand::Packages => Build::This,
                Demand::Nothing | Demand::All => Build::Release,
            };
            match speed::times(&folder, script(&python), build) {
                Ok(times) => failures.extend(print_times(&times, build).filter(|_| demand == Demand::All)),
                Err(failure) => failures.push(failure.to_string()),
            }
        }
        Err(failure) => {
            table::print(&rows);
            println!(
                "skipped: all other programs ({failure}); needed are python3-venv and access to a Python package index"
            );
            if matches!(demand, Demand::Packages | Demand::All) {
                failures.push("the Python environment cannot be made".to_owned());
            }
        }
    }
    failures.extend(rows.iter().filter_map(Row::failure));
    for failure in &failures {
        println!("failed: {failure}");
    }
    match failures.len() {
        0 => Ok(()),
        count => Err(format!("{count} checks failed").into()),
    }
}

/// The Python with trimesh and Manifold; MeshLab is welcome, but is not to be had on every machine.
fn environment() -> Result<PathBuf, Failure> {
    const FOLDER: &str = "target/readers/venv";
    let python = python::environment(FOLDER, "peers/readers/requirements.txt")?;
    if let Err(failure) = python::environment(FOLDER, "peers/readers/requirements-vrml.txt") {
        println!("without MeshLab ({failure})");
    }
    Ok(python)
}

fn script(python: &Path) -> Command {
    let mut command = shell::program(python);
    command.arg(shell::root().join("peers/readers/check.py"));
    command
}

/// Runs the script on our files; it prints a list of what each program said.
fn others(python: &Path, ours: &Path) -> Result<Vec<Row>, Failure> {
    let report: Value = serde_json::from_str(&shell::output(script(python).arg("read").arg(ours))?)?;
    let mut rows = Vec::new();
    for entry in report.as_array().ok_or("the script printed no list")? {
        let text = |key: &str| entry[key].as_str().unwrap_or_default();
        let cell = match text("result") {
            "passed" => Cell::Passed,
            "skipped" => Cell::Skipped(text("why").to_owned()),
            _ => Cell::Failed(text("why").to_owned()),
        };
        rows.push(Row::new(text("file"), text("row"), text("reader"), cell));
    }
    if rows.iter().all(Row::is_skipped) {
        return Err("the other programs read no file".into());
    }
    Ok(rows)
}

/// Prints the times; the complaint if ours is the longer one.
fn print_times(times: &Times, build: Build) -> impl Iterator<Item = String> + use<> {
    let [ours, trimesh, raw] = [times.ours, times.trimesh, times.raw].map(|seconds| 1000.0 * seconds);
    let note = if build == Build::This { "; ours is no build for release" } else { "" };
    println!("\nbinary STL, 10^6 triangles, the fastest run, from the disk{note}:");
    println!("  splitstar                      {ours:8.0} ms");
    println!("  trimesh.load                   {trimesh:8.0} ms   ratio {:.2}", trimesh / ours);
    println!("  trimesh.load, process=False    {raw:8.0} ms   ratio {:.2} (vertices not merged)", raw / ours);
    (ours > trimesh).then(|| format!("we read in {ours:.0} ms, trimesh in {trimesh:.0} ms")).into_iter()
}
