//! `cargo xtask peers proximity`: distances and depths of moving polytopes, beside parry3d and coal, in one run, on one thread.
//!
//! | file | role |
//! |---|---|
//! | `rows` | queries, orders of placements, sizes, and what must be reached |
//! | `placements` | the placements of a row, the same for everybody |
//! | `ours` | where the library is called |
//! | `replay` | overlaps for which others report too small a depth |
//! | `table` | what is printed, what failed, and the JSON of it |

mod ours;
mod placements;
mod replay;
mod rows;
mod table;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use proximity::RelativePlacement;
use serde_json::{Value, json};

use super::pairs::Operand;
use super::{BUDGET, LEAST, report, setup};
use crate::{Failure, python, shell};
use rows::{Peer, Query, Row};
use table::{Outcome, Run};

/// What the results of this command are called, beside those of the sums.
const ENDING: &str = "-proximity";
/// How far the sums of all answers may be apart, relative to ours: other programs stop at tolerances of their own.
const APART: f64 = 1e-3;

/// The programs that drive the peers, or why they cannot run.
struct Tools {
    parry: Result<PathBuf, String>,
    python: Result<PathBuf, String>,
}

/// Runs all rows and the replay, prints the table and writes the results.
///
/// # Errors
/// If an option is wrong or an input cannot be written; with `--require` also if a peer is missing or fails, if answers are far apart,
/// if we need more time than we may, or if a depth of ours is not the least.
pub(super) fn run(words: &[&str]) -> Result<(), Failure> {
    let options = super::options(words)?;
    let is_wanted = |name: &str| options.only.as_ref().is_none_or(|only| name.starts_with(only.as_str()));
    let wanted: Vec<Row> = rows::rows().into_iter().filter(|row| is_wanted(&row.name())).collect();
    if wanted.is_empty() && !is_wanted("replay") {
        let names: Vec<String> = rows::rows().iter().map(Row::name).collect();
        return Err(format!("no such row; there are {} and replay", names.join(", ")).into());
    }
    write_operands()?;
    let tools = Tools::new();
    let missing = tools.missing();
    for what in &missing {
        println!("missing: {what}");
    }
    let mut outcomes = Vec::new();
    for frequency in [4, 16] {
        let of_size: Vec<Row> = wanted.iter().copied().filter(|row| row.frequency == frequency).collect();
        if of_size.is_empty() {
            continue;
        }
        let [a, b] = ours::polytopes(rows::operands(frequency))?;
        let begin = Instant::now();
        let sum = RelativePlacement::new(&a, &b);
        let built = begin.elapsed().as_secs_f64();
        println!("the sum of {} and {} vertices took {built:.3} s", a.points().len(), b.points().len());
        for row in of_size {
            println!("{} ...", row.name());
            outcomes.push(outcome(row, &sum, built, &tools)?);
        }
    }
    let replay = is_wanted("replay").then(|| replay::run(&tools)).transpose()?;
    outcomes.iter().for_each(table::print);
    if let Some(replay) = &replay {
        replay.print();
    }
    println!();
    // A part of the table would hide the whole table of the same day.
    if options.only.is_none() || options.out.is_some() {
        let rows =
            outcomes.iter().map(table::record).chain(replay.iter().map(|replay| replay.record())).collect();
        println!("written: {}", report::write_dated("rows", rows, ENDING, options.out)?);
    }
    let missing = missing.into_iter().map(|what| format!("missing: {what}"));
    let of_replay = replay.iter().flat_map(|replay| replay.failures());
    let failures: Vec<String> =
        missing.chain(outcomes.iter().flat_map(table::failures)).chain(of_replay).collect();
    super::conclude(&failures, options.require)
}

impl Tools {
    /// Makes the peers ready, from what was made before where that is up to date.
    fn new() -> Self {
        let sentence = |failure: Failure| failure.to_string();
        let requirements = "peers/float/requirements-proximity.txt";
        Self {
            parry: parry().map_err(sentence),
            python: python::environment("peers/venv", requirements).map_err(sentence),
        }
    }

    /// One sentence for each peer that cannot run.
    fn missing(&self) -> Vec<String> {
        let parry =
            self.parry.as_ref().err().map(|why| format!("parry3d ({why}); access to crates.io is needed"));
        let coal = self.python.as_ref().err().map(|why| format!("coal ({why}); {}", setup::PYTHON_PACKAGES));
        parry.into_iter().chain(coal).collect()
    }

    /// The command that asks a peer, with all its arguments.
    fn command(&self, peer: Peer, query: &str, operands: &[Operand; 2], places: &Path) -> Option<Command> {
        let mut command = match peer {
            Peer::Parry => shell::program(self.parry.as_ref().ok()?),
            Peer::Coal => {
                let mut command = shell::program(self.python.as_ref().ok()?);
                command.arg(shell::root().join("peers/float/proximity.py"));
                command
            }
        };
        command.arg(query).args(operands.map(Operand::path)).arg(places);
        command.arg(LEAST.to_string()).arg(BUDGET.to_string());
        Some(command)
    }
}

/// Builds the driver of parry3d, which is a project of its own; returns its path.
///
/// # Errors
/// If its packages cannot be had.
fn parry() -> Result<PathBuf, Failure> {
    println!("building the driver of parry3d ...");
    let (project, build) = (shell::root().join("peers/parry"), shell::root().join("peers/build/parry"));
    let mut command = shell::cargo();
    command.args(["build", "--release", "--locked", "--quiet", "--manifest-path"]);
    command.arg(project.join("Cargo.toml")).arg("--target-dir").arg(&build);
    shell::output(&mut command)?;
    Ok(build.join("release/parry-driver"))
}

/// Writes the spheres.
fn write_operands() -> Result<(), Failure> {
    fs::create_dir_all(shell::root().join("peers/inputs"))?;
    for operand in [4, 16].into_iter().flat_map(rows::operands) {
        let solid = operand.solid().ok_or("a sphere is made by formula")?;
        fs::write(operand.path(), solid.off())?;
    }
    Ok(())
}

/// Draws the placements of a row and lets everybody answer, one after the other.
fn outcome(row: Row, sum: &RelativePlacement, built: f64, tools: &Tools) -> Result<Outcome, Failure> {
    let places = placements::draw(row.query, row.order, sum);
    let path = shell::root().join(format!("peers/inputs/placements-{}.txt", row.name()));
    fs::write(&path, placements::text(&places))?;
    let ours = ours::measured(sum, row.query, row.order, &places, LEAST, BUDGET);
    let record = json!({
        "method": "splitstar",
        "version": env!("CARGO_PKG_VERSION"),
        "placements": places.len(),
        "repetitions": ours.repetitions,
        "nanoseconds": ours.nanoseconds,
        "fastest": ours.fastest,
        "sum": ours.sum,
        "build_seconds": built,
    });
    let ours = Run { peer: None, nanoseconds: ours.nanoseconds, sum: ours.sum, record };
    let mut outcome = Outcome { row, ours, peers: Vec::new(), troubles: Vec::new() };
    for peer in [Peer::Parry, Peer::Coal] {
        let operands = row.operands();
        let Some(mut command) = tools.command(peer, row.query.name(), &operands, &path) else { continue };
        let answered = driver(&mut command, &placements::hash(&places)).and_then(|record| {
            let number =
                |key: &str| record[key].as_f64().ok_or_else(|| format!("the driver gave no `{key}`"));
            Ok((number("nanoseconds")?, number("sum")?, record))
        });
        match answered {
            Ok((nanoseconds, sum, record)) => {
                let apart = (sum - outcome.ours.sum).abs() / outcome.ours.sum.abs().max(1.0);
                // Too small depths are what the replay is about.
                if apart > APART && row.query != Query::Penetration {
                    outcome
                        .troubles
                        .push(format!("{peer}: the sum of answers is {sum}, ours {}", outcome.ours.sum));
                }
                outcome.peers.push(Run { peer: Some(peer), nanoseconds, sum, record });
            }
            Err(failure) => outcome.troubles.push(format!("{peer}: {failure}")),
        }
    }
    Ok(outcome)
}

/// Runs one driver, which prints one JSON object, and sees that it read the same placements.
fn driver(command: &mut Command, hash: &str) -> Result<Value, Failure> {
    let line = shell::shown(command);
    let mut record: Value = serde_json::from_str(shell::output(command)?.trim())?;
    if record["input_hash"] != hash {
        return Err("the driver has read other placements".into());
    }
    record["command"] = json!(line);
    Ok(record)
}
