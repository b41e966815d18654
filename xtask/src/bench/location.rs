//! What it costs to find the cell of a point in arrangements of growing size: no more than a logarithm.

use crate::Failure;
use crate::peers::arrangements::{Family, Search, Strategy, searches};

/// Bits of the steps and number of segments: with sixteen times as many segments of a quarter of the length, each has as many crossings.
const SIZES: [(u32, usize); 4] = [(19, 98), (17, 1_563), (15, 25_000), (13, 400_000)];
/// Strategies that prepare something must reach the bounds at all sizes.
const BOUNDED: [Strategy; 2] = [Strategy::Trapezoids, Strategy::Landmarks];
/// The others are for arrangements of at most so many segments.
const SMALL: usize = 2_000;
/// The predicates asked for a point, divided by the binary logarithm of the number of cells, may grow by this factor from the second size
/// to the last, which is 256 times as large. They are counted, so nothing else on the machine changes them.
const GROWTH: f64 = 1.3;
/// And be so many at most.
const MOST: f64 = 3.0;

/// Prints the table, and checks both bounds.
///
/// # Errors
/// If a case fails, or a bound does not hold.
pub(super) fn run() -> Result<(), Failure> {
    println!(
        "{:<12} {:>10} {:>10} {:>10} {:>10} {:>10} {:>10} {:>12}",
        "", "", "", "seconds to", "ns per", "ns per", "predicates", "per query"
    );
    println!(
        "{:<12} {:>10} {:>10} {:>10} {:>10} {:>10} {:>10} {:>12}",
        "location", "input", "cells", "prepare", "query", "doubling", "per query", "and doubling"
    );
    let mut series = BOUNDED.map(|strategy| (strategy, Vec::new()));
    for (bits, count) in SIZES {
        let mut strategies = BOUNDED.to_vec();
        if count <= SMALL {
            strategies.extend([Strategy::Walk, Strategy::Naive]);
        }
        let (cells, found) = searches(Family::Short(bits), count, &strategies)?;
        for Search { strategy, prepare, query, calls } in found {
            let doublings = (cells as f64).log2();
            let (name, nanoseconds) = (format!("{strategy:?}").to_lowercase(), 1e9 * query);
            println!(
                "{name:<12} {:>10} {cells:>10} {prepare:>10.6} {nanoseconds:>10.0} {:>10.1} {calls:>10.2} {:>12.3}",
                format!("s{bits}"),
                nanoseconds / doublings,
                calls / doublings
            );
            if let Some((_, per_doubling)) = series.iter_mut().find(|(bounded, _)| *bounded == strategy) {
                per_doubling.push(calls / doublings);
            }
        }
    }
    let broken: Vec<String> = series.iter().flat_map(|(strategy, calls)| broken(*strategy, calls)).collect();
    if broken.is_empty() { Ok(()) } else { Err(broken.join("; ").into()) }
}

/// What is wrong with the predicates per query and doubling of growing arrangements.
fn broken(strategy: Strategy, calls: &[f64]) -> Vec<String> {
    let mut broken = Vec::new();
    if let (Some(base), Some(last)) = (calls.get(1), calls.last())
        && *last > GROWTH * base
    {
        broken.push(format!(
            "{strategy:?}: predicates per query and doubling grew from {base:.3} to {last:.3}"
        ));
    }
    if let Some(most) = calls.iter().copied().find(|&calls| calls > MOST) {
        broken.push(format!("{strategy:?}: {most:.3} predicates per query and doubling, {MOST} are allowed"));
    }
    broken
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_found() {
        let broken = |calls: &[f64]| broken(Strategy::Landmarks, calls);
        assert_eq!(broken(&[3.0, 2.0, 3.0, 2.6]), [""; 0]);
        let grown = ["Landmarks: predicates per query and doubling grew from 2.000 to 2.700"];
        assert_eq!(broken(&[3.0, 2.0, 2.0, 2.7]), grown);
        let many = ["Landmarks: 3.100 predicates per query and doubling, 3 are allowed"];
        assert_eq!(broken(&[3.1, 3.0, 2.0, 1.0]), many);
    }

    #[test]
    fn strategies_are_compared() {
        let all = [Strategy::Trapezoids, Strategy::Landmarks, Strategy::Walk, Strategy::Naive];
        let (cells, found) = searches(Family::Short(19), 30, &all).expect("they agree");
        assert!(cells > 90, "{cells}");
        assert_eq!(found.len(), 4);
        assert!(found.iter().all(|search| search.calls > 0.0 && search.query > 0.0));
    }
}
