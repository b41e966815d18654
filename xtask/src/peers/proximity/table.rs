//! What is printed of a row, what failed, and the JSON of it.

use serde_json::{Value, json};

use super::rows::{Peer, Row};

/// What one program did with one row.
#[derive(Debug)]
pub(super) struct Run {
    /// Nothing for ours.
    pub(super) peer: Option<Peer>,
    /// Of a query.
    pub(super) nanoseconds: f64,
    /// Of all answers.
    pub(super) sum: f64,
    /// All that is written to the results.
    pub(super) record: Value,
}

/// What happened with one row.
#[derive(Debug)]
pub(super) struct Outcome {
    pub(super) row: Row,
    pub(super) ours: Run,
    pub(super) peers: Vec<Run>,
    /// Peers that failed, answers that are far apart.
    pub(super) troubles: Vec<String>,
}

/// Prints one block.
pub(super) fn print(outcome: &Outcome) {
    let Outcome { row, ours, peers, .. } = outcome;
    println!("\n{}", row.name());
    for run in std::iter::once(ours).chain(peers) {
        let name = run.peer.map_or_else(|| "splitstar".to_owned(), |peer| peer.to_string());
        let times = run.nanoseconds / ours.nanoseconds;
        let call = run.record["call"].as_f64().map(|call| format!(", {call:.0} ns of them the call"));
        let call = call.unwrap_or_default();
        println!("  {name:<12} {:>9.0} ns {times:>7.1} x   sum {:.6}{call}", run.nanoseconds, run.sum);
    }
    println!("  at most {} ns: {:.0}", row.reach, ours.nanoseconds);
}

/// All that must hold and does not.
pub(super) fn failures(outcome: &Outcome) -> Vec<String> {
    let Outcome { row, ours, troubles, .. } = outcome;
    let mut failures: Vec<String> =
        troubles.iter().map(|trouble| format!("{}: {trouble}", row.name())).collect();
    if ours.nanoseconds > row.reach {
        failures.push(format!(
            "{}: {:.0} ns a query, {} are allowed",
            row.name(),
            ours.nanoseconds,
            row.reach
        ));
    }
    failures
}

/// A row of the written results.
pub(super) fn record(outcome: &Outcome) -> Value {
    let runs: Vec<&Value> =
        std::iter::once(&outcome.ours).chain(&outcome.peers).map(|run| &run.record).collect();
    json!({
        "row": outcome.row.name(),
        "runs": runs,
        "nanoseconds": { "a_query": outcome.ours.nanoseconds, "at_most": outcome.row.reach },
        "troubles": outcome.troubles,
    })
}
