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

    /// The time for all points of the task, where points are asked about.
    fn amount(&self, row: &Row, measure: Measure) -> f64 {
        match measure {
            Measure::Seconds => {
                let asked = row.task.operation.queries().zip(self.measured.asked);
                self.measured.seconds * asked.map_or(1.0, |(all, few)| all as f64 / few as f64)
            }
            Measure::Memory => self.measured.peak_bytes,
        }
    }

    /// Microseconds for a point; nothing where none is asked about.
    fn microseconds(&self, row: &Row) -> Option<f64> {
        Some(1e6 * self.amount(row, Measure::Seconds) / row.task.operation.queries()? as f64)
    }

    /// Whether that is what it found, as far as programs find the same.
    fn has_found(&self, row: &Row) -> bool {
        let compared = |Counts { vertices, edges, faces }| {
            // Every cut is one vertex and one edge more.
            let is_cut = row.task.family.is_cut() && self.peer.is_some();
            if is_cut { [0, (edges + faces).wrapping_sub(vertices), faces] } else { [vertices, edges, faces] }
        };
        self.measured.counts.map(compared) == Some(compared(row.counts))
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
    let hash = format!("{:016x}", outcome.row.task.operands()[0].hash);
    let located = outcome.ours.as_ref().and_then(|run| run.measured.located);
    let mut troubles = Vec::new();
    for run in outcome.runs() {
        let name = run.name();
        if run.measured.hash != hash {
            troubles.push(format!("{name}: the input is {}, not {hash}", run.measured.hash));
        }
        if run.peer.is_none_or(Peer::is_exact) {
            if !run.has_found(outcome.row) {
                troubles.push(format!("{name}: counts {}, there are {}", run.found(), outcome.row.counts));
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
    let amount = |run: &Run| run.amount(outcome.row, requirement.measure);
    Some(amount(theirs) / amount(outcome.ours.as_ref()?))
}

/// Microseconds that we need for a query; nothing where none is asked or we did not run.
fn microseconds(outcome: &Outcome) -> Option<f64> {
    outcome.ours.as_ref()?.microseconds(outcome.row)
}

/// Prints one block for each row.
pub(super) fn print(outcomes: &[Outcome]) {
    for outcome in outcomes {
        println!("\n{}", outcome.row.name);
        for run in outcome.runs() {
            let times = outcome
                .ours
                .as_ref()
                .map(|ours| [run, ours].map(|run| run.amount(outcome.row, Measure::Seconds)))
                .map(|[theirs, ours]| format!("{:.2} x", theirs / ours));
            println!(
                "  {:<10} {:>10.6} s {:>9} {:>7.0} MB   {}",
                run.name(),
                run.measured.seconds,
                times.unwrap_or_default(),
                run.measured.peak_bytes / 1e6,
                run.found()
            );
            if let (Some(asked), Some(needed)) = (run.measured.asked, run.microseconds(outcome.row)) {
                println!("  {:<10} for {asked} points, {needed:.3} us each", "");
            }
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
    let theirs: Vec<Option<f64>> = outcome.peers.iter().map(|run| run.microseconds(outcome.row)).collect();
    let runs: Vec<&Value> = outcome.runs().map(|run| &run.measured.record).collect();
    json!({
        "row": outcome.row.name,
        "task": outcome.row.task.words().join(" "),
        "runs": runs,
        "requirements": requirements,
        "microseconds": {
            "a_query": microseconds(outcome),
            "at_most": outcome.row.microseconds,
            "of_peers": theirs,
        },
        "troubles": outcome.troubles,
    })
}
