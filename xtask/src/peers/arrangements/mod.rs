//! `cargo xtask peers arrangements`: the arrangement engine, CGAL and GEOS on the same curves, in one run, on one thread.
//!
//! | file | role |
//! |---|---|
//! | `task` | an operation and its input: which curves, drawn by `testkit`, and their text for other programs |
//! | `rows` | the tasks of the table, what must be found, who else runs, and what must be reached |
//! | `ours`, `edits`, `places` | where the library is called: arrangements are made, edited, and asked where points lie |
//! | `once` | one task in a process of its own, whose memory and processor time are measured |
//! | `table` | runs of one row, the ratios, what failed, and the JSON of it |

mod edits;
mod once;
mod ours;
mod places;
mod rows;
mod table;
mod task;
#[cfg(test)]
mod tests;

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use serde_json::{Value, json};

use super::{BUDGET, LEAST, report, setup};
use crate::{Failure, python, shell};
pub(crate) use edits::{Holes, split_off_faces};
pub(crate) use once::{Measured, fresh, timed};
pub(crate) use ours::arcs;
pub(crate) use places::{Search, searches};
use rows::{Peer, ROWS, Row};
use table::{Outcome, Run};
pub(crate) use task::{Family, Operation, Strategy, Task};

/// What the results of this command are called, beside those of the sums.
const ENDING: &str = "-arrangements";

/// The folders of the drivers, or why they cannot run; nothing where no row needs them.
struct Tools {
    cgal: Option<Result<PathBuf, String>>,
    python: Option<Result<PathBuf, String>>,
}

/// Runs all rows, prints the table and writes the results; `--once TASK` does one task and prints what it measured.
///
/// # Errors
/// If an option is wrong or an input cannot be written; with `--require` also if a peer is missing, if someone fails, if counts
/// are not those that they must be, or a ratio is not reached.
pub(super) fn run(words: &[&str]) -> Result<(), Failure> {
    if let ["--once", operation, family, count, least, budget] = words {
        let task = Task::parse([operation, family, count])?;
        println!("{}", once::answer(&task, least.parse()?, budget.parse()?)?);
        return Ok(());
    }
    let options = super::options(words)?;
    let wanted: Vec<&'static Row> =
        ROWS.iter().filter(|row| options.only.as_ref().is_none_or(|only| *only == row.name)).collect();
    if wanted.is_empty() {
        let names: Vec<&str> = ROWS.iter().map(|row| row.name).collect();
        return Err(format!("no such row; there are {}", names.join(", ")).into());
    }
    let tools = tools(&wanted);
    let missing = tools.missing();
    for what in &missing {
        println!("missing: {what}");
    }
    let mut outcomes = Vec::new();
    for row in wanted {
        println!("{} ...", row.name);
        outcomes.push(outcome(row, &tools)?);
    }
    table::print(&outcomes);
    // A part of the table would hide the whole table of the same day.
    if options.only.is_none() || options.out.is_some() {
        let rows = outcomes.iter().map(table::record).collect();
        println!("written: {}", report::write_dated("rows", rows, ENDING, options.out)?);
    }
    let missing = missing.into_iter().map(|what| format!("missing: {what}"));
    let failures: Vec<String> = missing.chain(outcomes.iter().flat_map(table::failures)).collect();
    super::conclude(&failures, options.require)
}

impl Tools {
    /// One sentence for each group of peers that cannot run.
    fn missing(&self) -> Vec<String> {
        let why = |tool: &Option<Result<PathBuf, String>>| {
            tool.as_ref().and_then(|found| found.as_ref().err()).cloned()
        };
        let cgal = why(&self.cgal).map(|why| format!("CGAL ({why}); {}", setup::CGAL_PACKAGES));
        let python = why(&self.python).map(|why| format!("GEOS ({why}); {}", setup::PYTHON_PACKAGES));
        cgal.into_iter().chain(python).collect()
    }

    /// The command that does the task, up to the number of repetitions.
    fn command(&self, peer: Peer, task: &Task, inputs: &[PathBuf]) -> Option<Command> {
        let mut command = match peer {
            Peer::Cgal => {
                let folder = self.cgal.as_ref()?.as_ref().ok()?;
                let mut command = shell::program(folder.join(task.family.driver()));
                command.arg(task.operation.to_string());
                command
            }
            Peer::Geos => {
                let mut command = shell::program(self.python.as_ref()?.as_ref().ok()?);
                command.arg(shell::root().join("peers/float/node_segments.py"));
                command
            }
            Peer::Plain => return None,
        };
        command.args(inputs);
        Some(command)
    }
}

/// Makes the peers of those rows ready, from what was made before where that is up to date.
fn tools(rows: &[&Row]) -> Tools {
    let needs = |peer: Peer| rows.iter().any(|row| row.peers.contains(&peer));
    let mut drivers: Vec<&str> = rows.iter().map(|row| row.task.family.driver()).collect();
    drivers.sort_unstable();
    drivers.dedup();
    let sentence = |failure: Failure| failure.to_string();
    let environment =
        || python::environment("peers/venv", "peers/float/requirements-arrangements.txt").map_err(sentence);
    Tools {
        cgal: needs(Peer::Cgal).then(|| setup::cgal(&drivers).map_err(sentence)),
        python: needs(Peer::Geos).then(environment),
    }
}

/// Writes the input and lets everybody do the task, one after the other.
fn outcome(row: &'static Row, tools: &Tools) -> Result<Outcome, Failure> {
    let inputs = write_inputs(&row.task)?;
    let mut outcome = Outcome { row, ours: None, peers: Vec::new(), troubles: Vec::new() };
    match fresh(&row.task, LEAST, BUDGET) {
        Ok(measured) => outcome.ours = Some(Run { peer: None, measured }),
        Err(failure) => outcome.troubles.push(format!("ours: {failure}")),
    }
    for &peer in row.peers {
        let measured = if peer == Peer::Plain {
            let plain = rows::plain(&row.task).ok_or("the task has no history")?;
            fresh(&plain, LEAST, BUDGET)
        } else {
            let Some(mut command) = tools.command(peer, &row.task, &inputs) else { continue };
            theirs(&mut command)
        };
        match measured {
            Ok(measured) => outcome.peers.push(Run { peer: Some(peer), measured }),
            Err(failure) => outcome.troubles.push(format!("{peer}: {failure}")),
        }
    }
    table::check(&mut outcome);
    Ok(outcome)
}

/// Runs one driver; it prints one JSON object.
fn theirs(command: &mut Command) -> Result<Measured, Failure> {
    command.arg(LEAST.to_string()).arg(BUDGET.to_string());
    let line = shell::shown(command);
    let mut record: Value = serde_json::from_str(shell::output(command)?.trim())?;
    record["command"] = json!(line);
    Measured::read(record)
}

/// Writes the operands of a task; the same for every program.
fn write_inputs(task: &Task) -> Result<Vec<PathBuf>, Failure> {
    let folder = shell::root().join("peers/inputs");
    fs::create_dir_all(&folder)?;
    let mut paths = Vec::new();
    for operand in task.operands() {
        let path = folder.join(format!("{}.curves", operand.name));
        fs::write(&path, operand.curves.text())?;
        paths.push(path);
    }
    Ok(paths)
}
