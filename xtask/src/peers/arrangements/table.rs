//! Runs of one row: checked, printed, compared, and written.

use serde_json::{Value, json};

use super::once::{Counts, Measured};
use super::rows::{Measure, Peer, Requirement, Row};

/// What one program did with a row.
#[derive(Debug)]
pub(super) struct Run {
    /// The peer, or nothing for ours.
    pub(super) peer: Option<Peer>,
    pub(super) measured: Measured,
}

/// What happened with one row.
#[derive(Debug)]
pub(super) struct Outcome {
    pub(super) row: &'static Row,
    /// Nothing if we failed.
    pub(super) ours: Option<Run>,
    pub(super) peers: Vec<Run>,
    /// Programs that failed, inputs or counts that differ.
    pub(super) troubles: Vec<String>,
}

impl Outcome {
    fn runs(&self) -> impl Iterator<Item = &Run> {
        self.ours.iter().chain(&self.peers)
    }
}

impl Run {
    fn name(&self) -> String {
        self.peer.map_or_else(|| "splitstar".to_owned(), |peer| peer.to_string())
    }

    fn amount(&self, measure: Measure) -> f64 {
        match measure {
            Measure::Seconds => self.measured.seconds,
            Measure::Memory => self.measured.peak_bytes,
        }
    }

    /// Counts as far as it has them.
    fn found(&self) -> String {
        match self.measured.counts {
            Some(counts) => counts.to_string(),
            None => format!("{}/{}", self.measured.record["vertices"], self.measured.record["edges"]),
        }
    }
}

/// Everybody has read the same input, every exact program has found the cells that there are, and located points alike.
pub(super) fn check(outcome: &mut Outcome) {
    let expected: Counts = outcome.row.counts;
    let hash = format!("{:016x}", outcome.row.task.operands()[0].hash);
    let located = outcome.ours.as_ref().and_then(|run| run.measured.located);
    let mut troubles = Vec::new();
    for run in outcome.runs() {
        let name = run.name();
        if run.measured.hash != hash {
            troubles.push(format!("{name}: the input is {}, not {hash}", run.measured.hash));
        }
        if run.peer.is_none_or(Peer::is_exact) {
            if run.measured.counts != Some(expected) {
                troubles.push(format!("{name}: counts {}, there are {expected}", run.found()));
            }
            if run.measured.located.is_some() != outcome.row.task.operation.finds_cells() {
                troubles.push(format!(
                    "{name}: it finds cells for queries where it should not, or does not where it should"
                ));
            } else if let Some(ours) = located.filter(|ours| Some(*ours) != run.measured.located) {
                troubles.push(format!("{name}: found {:?}, we found {ours:?}", run.measured.located));
            } else if let Some(zone) = outcome.row.zone.filter(|&zone| run.measured.cells() != Some(zone)) {
                troubles
                    .push(format!("{name}: {:?} cells along curves, there are {zone}", run.measured.cells()));
            }
        }
    }
    outcome.troubles.extend(troubles);
}

/// What the peer needs over what we need; nothing if one of the two did not run.
fn ratio(outcome: &Outcome, requirement: &Requirement) -> Option<f64> {
    let theirs = outcome.peers.iter().find(|run| run.peer == Some(requirement.than))?;
    Some(theirs.amount(requirement.measure) / outcome.ours.as_ref()?.amount(requirement.measure))
}

/// Microseconds that we need for a query; nothing where none is asked or we did not run.
fn microseconds(outcome: &Outcome) -> Option<f64> {
    let queries = outcome.row.task.operation.queries()?;
    Some(1e6 * outcome.ours.as_ref()?.measured.seconds / queries as f64)
}

/// Prints one block for each row.
pub(super) fn print(outcomes: &[Outcome]) {
    for outcome in outcomes {
        println!("\n{}", outcome.row.name);
        for run in outcome.runs() {
            let times = outcome
                .ours
                .as_ref()
                .map(|ours| format!("{:.2} x", run.measured.seconds / ours.measured.seconds));
            println!(
                "  {:<10} {:>10.6} s {:>9} {:>7.0} MB   {}",
                run.name(),
                run.measured.seconds,
                times.unwrap_or_default(),
                run.measured.peak_bytes / 1e6,
                run.found()
            );
        }
        for requirement in outcome.row.requirements {
            let reached =
                ratio(outcome, requirement).map_or("unknown".to_owned(), |ratio| format!("{ratio:.2}"));
            let Requirement { factor, measure, than } = requirement;
            println!("  {factor} times {measure} than {than}: {reached}");
        }
        match (microseconds(outcome), outcome.row.microseconds) {
            (Some(needed), Some(most)) => println!("  at most {most} us a query: {needed:.3}"),
            (Some(needed), None) => println!("  us a query: {needed:.3}"),
            (None, _) => {}
        }
    }
    println!();
}

/// All that must hold and does not.
pub(super) fn failures(outcome: &Outcome) -> Vec<String> {
    let name = outcome.row.name;
    let mut failures: Vec<String> =
        outcome.troubles.iter().map(|trouble| format!("{name}: {trouble}")).collect();
    for requirement in outcome.row.requirements {
        let Requirement { factor, measure, than } = requirement;
        match ratio(outcome, requirement) {
            Some(ratio) if ratio >= *factor => {}
            Some(ratio) => {
                failures.push(format!("{name}: {ratio:.2} times {measure} than {than}, {factor} is asked"));
            }
            None => failures.push(format!("{name}: {measure} than {than} is not known")),
        }
    }
    if let Some(most) = outcome.row.microseconds {
        match microseconds(outcome) {
            Some(needed) if needed <= most => {}
            Some(needed) => failures.push(format!("{name}: {needed:.3} us a query, {most} are allowed")),
            None => failures.push(format!("{name}: the time of a query is not known")),
        }
    }
    failures
}

/// A row of the written results.
pub(super) fn record(outcome: &Outcome) -> Value {
    let requirements: Vec<Value> = outcome
        .row
        .requirements
        .iter()
        .map(|requirement| {
            json!({
                "factor": requirement.factor,
                "measure": requirement.measure.to_string(),
                "than": requirement.than.to_string(),
                "ratio": ratio(outcome, requirement),
            })
        })
        .collect();
    let runs: Vec<&Value> = outcome.runs().map(|run| &run.measured.record).collect();
    json!({
        "row": outcome.row.name,
        "task": outcome.row.task.words().join(" "),
        "runs": runs,
        "requirements": requirements,
        "microseconds": { "a_query": microseconds(outcome), "at_most": outcome.row.microseconds },
        "troubles": outcome.troubles,
    })
}
