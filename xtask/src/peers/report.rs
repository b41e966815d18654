//! The table of times, the ratios, and the dated JSON.

use std::fs;
use std::path::PathBuf;

use serde_json::{Value, json};

use super::setup::Tools;
use super::{Outcome, Run};
use crate::{Failure, shell};

/// The time of the fastest of those methods over ours; nothing if one of them did not run.
fn ratio(outcome: &Outcome, than: &[super::Method]) -> Option<f64> {
    let time = |method: &super::Method| {
        outcome.peers.iter().find(|run| run.method == Some(*method)).map(|run| run.seconds)
    };
    let times = than.iter().map(time).collect::<Option<Vec<f64>>>()?;
    Some(times.into_iter().fold(f64::INFINITY, f64::min) / outcome.ours.seconds)
}

/// Prints one block for each pair.
pub(super) fn print(outcomes: &[Outcome]) {
    for outcome in outcomes {
        println!("\n{}", outcome.pair.name);
        for run in std::iter::once(&outcome.ours).chain(&outcome.peers) {
            let name = run.method.map_or_else(|| "splitstar".to_owned(), |method| method.to_string());
            let times = run.seconds / outcome.ours.seconds;
            println!("  {name:<12} {:>12.6} s {times:>8.1} x   {}", run.seconds, found(run));
        }
        if let Some(fastest) = outcome.ours.record["fastest"].as_f64() {
            println!("  {:<12} {fastest:>12.6} s in its fastest repetition", "");
        }
        for requirement in outcome.pair.requirements {
            let reached =
                ratio(outcome, requirement.than).map_or("unknown".to_owned(), |ratio| format!("{ratio:.1}"));
            println!("  {} times {}: {reached}", requirement.factor, names(requirement.than));
        }
    }
    println!();
}

/// Counts, of triangles for the floating-point methods.
fn found(run: &Run) -> String {
    match run.counts {
        Some(counts) => counts.to_string(),
        None => format!("{} vertices, {} triangles", run.record["vertices"], run.record["triangles"]),
    }
}

fn names(methods: &[super::Method]) -> String {
    methods.iter().map(ToString::to_string).collect::<Vec<_>>().join(" and ")
}

/// All that must hold and does not.
pub(super) fn failures(outcomes: &[Outcome], tools: &Tools) -> Vec<String> {
    let mut failures: Vec<String> =
        tools.missing().into_iter().map(|what| format!("missing: {what}")).collect();
    for outcome in outcomes {
        failures.extend(outcome.troubles.iter().cloned());
        for requirement in outcome.pair.requirements {
            let (name, factor, than) = (outcome.pair.name, requirement.factor, names(requirement.than));
            match ratio(outcome, requirement.than) {
                Some(ratio) if ratio >= factor => {}
                Some(ratio) => {
                    failures.push(format!("{name}: {ratio:.1} times faster than {than}, {factor} is asked"))
                }
                None => failures.push(format!("{name}: no time of {than}")),
            }
        }
    }
    failures
}

/// Writes the results and returns the path as it is shown.
///
/// # Errors
/// If the file cannot be written.
pub(super) fn write(outcomes: &[Outcome], out: Option<PathBuf>) -> Result<String, Failure> {
    write_dated("pairs", outcomes.iter().map(pair).collect(), "", out)
}

/// Writes rows under that key, with the date, the machine and the versions, to the given file or to one that is named by the
/// date and the ending; returns its path as it is shown.
///
/// # Errors
/// If the file cannot be written.
pub(super) fn write_dated(
    key: &str,
    rows: Vec<Value>,
    ending: &str,
    out: Option<PathBuf>,
) -> Result<String, Failure> {
    let date = shell::output(shell::program("date").arg("+%Y-%m-%d"))?.trim().to_owned();
    let path = out.unwrap_or_else(|| PathBuf::from(format!("peers/results/{date}{ending}.json")));
    let full = shell::root().join(&path);
    if let Some(folder) = full.parent() {
        fs::create_dir_all(folder)?;
    }
    let results = json!({ "date": date, "machine": machine(), "versions": versions(), key: rows });
    fs::write(full, format!("{results:#}\n"))?;
    Ok(path.display().to_string())
}

fn pair(outcome: &Outcome) -> Value {
    let requirements: Vec<Value> = outcome
        .pair
        .requirements
        .iter()
        .map(|requirement| {
            json!({
                "factor": requirement.factor,
                "than": names(requirement.than),
                "ratio": ratio(outcome, requirement.than),
            })
        })
        .collect();
    let runs: Vec<&Value> =
        std::iter::once(&outcome.ours).chain(&outcome.peers).map(|run| &run.record).collect();
    json!({ "pair": outcome.pair.name, "runs": runs, "requirements": requirements, "troubles": outcome.troubles })
}

/// What a reader of the times wants to know of the machine.
fn machine() -> Value {
    let information = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| {
        let line = information.lines().find(|line| line.starts_with(name))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    };
    let load = fs::read_to_string("/proc/loadavg").unwrap_or_default();
    json!({
        "processor": field("model name"),
        "family and model": [field("cpu family"), field("model\t")],
        "processors": std::thread::available_parallelism().map_or(0, std::num::NonZero::get),
        "load average": load.split_whitespace().next(),
    })
}

/// Versions of the compilers; those of the peers stand with their runs.
fn versions() -> Value {
    let first_line = |name: &str| {
        let text = shell::output(shell::program(name).arg("--version")).ok()?;
        Some(text.lines().next()?.to_owned())
    };
    // With a mark when the tree has changes that are not committed.
    let describe = ["describe", "--always", "--dirty", "--abbrev=40", "--exclude=*"];
    let commit = shell::output(shell::program("git").args(describe)).ok().map(|name| name.trim().to_owned());
    json!({
        "commit": commit,
        "rustc": first_line("rustc"),
        "g++": first_line("c++"),
        "cmake": first_line("cmake"),
        "python": first_line("python3"),
    })
}
