//! `cargo xtask peers`: the library and its peers on the same inputs, in one run, on one thread.
//!
//! | file | role |
//! |---|---|
//! | `pairs` | the pairs of operands, who runs on each, and what must be reached |
//! | `setup` | builds the CGAL drivers, makes the Python environment, writes the inputs |
//! | `report` | the table, the ratios, and the dated JSON |
//! | `arrangements` | the same for arrangements: `cargo xtask peers arrangements` |
//! | `proximity` | the same for distances and depths: `cargo xtask peers proximity` |

pub(crate) mod arrangements;
mod pairs;
mod proximity;
mod report;
mod setup;

use std::path::PathBuf;
use std::process::Command;

use serde_json::{Value, json};

use crate::library::{self, Counts, Measured};
use crate::{Failure, shell};
use pairs::{Method, Pair};
use setup::Tools;

/// A method is repeated for about this long, and at least three times.
const BUDGET: f64 = 1.0;
const LEAST: usize = 3;

/// What one method did with one pair.
#[derive(Debug)]
struct Run {
    /// The method, or nothing for ours.
    method: Option<Method>,
    seconds: f64,
    /// The counts that an exact method found.
    counts: Option<Counts>,
    /// All that is written to the results.
    record: Value,
}

/// What happened with one pair.
#[derive(Debug)]
struct Outcome {
    pair: &'static Pair,
    ours: Run,
    peers: Vec<Run>,
    /// Peers that failed, counts that disagree.
    troubles: Vec<String>,
}

struct Options {
    require: bool,
    only: Option<String>,
    out: Option<PathBuf>,
}

/// Runs all pairs, prints the table and writes the results; or does so for arrangements, or for proximity.
///
/// # Errors
/// If an option is wrong, or the library fails; with `--require` also if a peer is missing or fails, exact counts disagree, or a
/// ratio is not reached.
pub(crate) fn run(words: &[&str]) -> Result<(), Failure> {
    if let ["arrangements", rest @ ..] = words {
        return arrangements::run(rest);
    }
    if let ["proximity", rest @ ..] = words {
        return proximity::run(rest);
    }
    let options = options(words)?;
    let wanted: Vec<&'static Pair> = pairs::PAIRS
        .iter()
        .filter(|pair| options.only.as_ref().is_none_or(|only| *only == pair.name))
        .collect();
    if wanted.is_empty() {
        let names: Vec<&str> = pairs::PAIRS.iter().map(|pair| pair.name).collect();
        return Err(format!("no such pair; there are {}", names.join(", ")).into());
    }
    setup::write_inputs(&wanted)?;
    let tools = setup::tools(&wanted);
    for missing in tools.missing() {
        println!("missing: {missing}");
    }
    let mut outcomes = Vec::new();
    for pair in wanted {
        outcomes.push(outcome(pair, &tools)?);
    }
    report::print(&outcomes);
    // A part of the table would hide the whole table of the same day.
    if options.only.is_none() || options.out.is_some() {
        println!("written: {}", report::write(&outcomes, options.out)?);
    }
    conclude(&report::failures(&outcomes, &tools), options.require)
}

/// Prints what does not hold.
///
/// # Errors
/// If there is something, and all is required.
fn conclude(failures: &[String], require: bool) -> Result<(), Failure> {
    for failure in failures {
        println!("{}: {failure}", if require { "failed" } else { "note" });
    }
    if require && !failures.is_empty() {
        return Err(format!("{} requirements are not met", failures.len()).into());
    }
    Ok(())
}

fn options(words: &[&str]) -> Result<Options, Failure> {
    let mut options = Options { require: false, only: None, out: None };
    let mut words = words.iter();
    while let Some(&word) = words.next() {
        let mut value =
            || words.next().map(|&value| value.to_owned()).ok_or_else(|| format!("`{word}` needs a value"));
        match word {
            "--require" => options.require = true,
            "--only" => options.only = Some(value()?),
            "--out" => options.out = Some(PathBuf::from(value()?)),
            _ => return Err(format!("no such option: {word}").into()),
        }
    }
    Ok(options)
}

fn outcome(pair: &'static Pair, tools: &Tools) -> Result<Outcome, Failure> {
    println!("{} ...", pair.name);
    let operands = [pair.a.path(), pair.b.path()];
    let measured = library::measured_sum_by(pair.by, &operands, LEAST, BUDGET)?;
    let ours = our_run(None, pair.by, &measured);
    let mut outcome = Outcome { pair, ours, peers: Vec::new(), troubles: Vec::new() };
    for &method in pair.methods {
        if method == Method::OurSgm {
            let measured = library::measured_sum_by(library::Method::Sgm, &operands, LEAST, BUDGET)?;
            outcome.peers.push(our_run(Some(method), library::Method::Sgm, &measured));
            continue;
        }
        let Some(mut command) = tools.command(method) else { continue };
        match peer(&mut command, method, &operands) {
            Ok(run) => {
                if run.counts.is_some_and(|counts| counts != measured.sum) {
                    let theirs = run.counts.map(|counts| counts.to_string()).unwrap_or_default();
                    outcome
                        .troubles
                        .push(format!("{}: {method} counts {theirs}, we count {}", pair.name, measured.sum));
                }
                outcome.peers.push(run);
            }
            Err(failure) => outcome.troubles.push(format!("{}: {method}: {failure}", pair.name)),
        }
    }
    Ok(outcome)
}

/// What we did.
fn our_run(method: Option<Method>, by: library::Method, measured: &Measured) -> Run {
    let [polytopes, maps, sum] = measured.phases;
    Run {
        method,
        seconds: measured.seconds,
        counts: Some(measured.sum),
        record: json!({
            "method": format!("splitstar, {}", by.name()),
            "version": env!("CARGO_PKG_VERSION"),
            "repetitions": measured.repetitions,
            "seconds": measured.seconds,
            "fastest": measured.fastest,
            "phases": { "polytopes": polytopes, "maps": maps, "sum": sum },
            "vertices": measured.sum.vertices,
            "edges": measured.sum.edges,
            "facets": measured.sum.facets,
        }),
    }
}

/// CGAL's drivers of sums, for other tasks.
#[derive(Debug)]
pub(crate) struct Cgal(Result<PathBuf, String>);

impl Cgal {
    /// Builds a driver, or says why not.
    pub(crate) fn new(driver: &str) -> Self {
        Self(setup::cgal(&[driver]).map(|folder| folder.join(driver)).map_err(|failure| failure.to_string()))
    }

    /// The seconds of a sum, repeated so often at least and for about so many seconds.
    ///
    /// # Errors
    /// Why there are none, in one sentence.
    pub(crate) fn seconds(&self, operands: &[PathBuf], least: usize, budget: f64) -> Result<f64, String> {
        let driver = self.0.as_ref().map_err(String::clone)?;
        let mut command = shell::program(driver);
        command.args(operands).arg(least.to_string()).arg(budget.to_string());
        let text = shell::output(&mut command).map_err(|failure| failure.to_string())?;
        let record: Value = serde_json::from_str(text.trim()).map_err(|error| error.to_string())?;
        record["seconds"].as_f64().ok_or_else(|| "the driver gave no time".to_owned())
    }
}

/// Runs one driver; it prints one JSON object.
fn peer(command: &mut Command, method: Method, operands: &[PathBuf; 2]) -> Result<Run, Failure> {
    command.args(operands).arg(LEAST.to_string()).arg(BUDGET.to_string());
    let line = shell::shown(command);
    let mut record: Value = serde_json::from_str(shell::output(command)?.trim())?;
    let seconds = record["seconds"].as_f64().ok_or("the driver gave no time")?;
    let number = |key: &str| record[key].as_u64().and_then(|value| usize::try_from(value).ok());
    let counts = match (number("vertices"), number("edges"), number("facets")) {
        (Some(vertices), Some(edges), Some(facets)) => Some(Counts { vertices, edges, facets }),
        _ => None,
    };
    record["command"] = json!(line);
    Ok(Run { method: Some(method), seconds, counts, record })
}
