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
/// And be so many at most; 0.63 were measured.
const MOST: f64 = 1.0;
/// Steps that ask no predicate (numbers that order points) are not among these. So the longest path of a search structure may have so many
/// comparisons for each binary logarithm of the number of cells. 5 were measured. It does not depend
/// on the load either.
const PATH: f64 = 8.0;
/// And the time of a query may grow at most as this power of the number of cells, from the second size to the last: a linear walk would be far
/// above it. That leaves room for memory: in a larger arrangement, fewer of the cells are in a cache.
const POWER: f64 = 0.5;

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
    let mut broken_ones = Vec::new();
    for (bits, count) in SIZES {
        let mut strategies = BOUNDED.to_vec();
        if count <= SMALL {
            strategies.extend([Strategy::Walk, Strategy::Naive]);
        }
        let (cells, found) = searches(Family::Short(bits), count, &strategies)?;
        for Search { strategy, prepare, query, calls, path } in found {
            let doublings = (cells as f64).log2();
            let (name, nanoseconds) = (format!("{strategy:?}").to_lowercase(), 1e9 * query);
            println!(
                "{name:<12} {:>10} {cells:>10} {prepare:>10.6} {nanoseconds:>10.0} {:>10.1} {calls:>10.2} {:>12.3}",
                format!("s{bits}"),
                nanoseconds / doublings,
                calls / doublings
            );
            if let Some((_, sizes)) = series.iter_mut().find(|(bounded, _)| *bounded == strategy) {
                sizes.push(Size { cells: cells as f64, calls: calls / doublings, nanoseconds });
            }
            if let Some(path) = path {
                println!("{:<12} {path:>10} comparisons on its longest path", "");
                if f64::from(path) > PATH * doublings {
                    broken_ones.push(format!("a path of {path} comparisons among {cells} cells"));
                }
            }
        }
    }
    broken_ones.extend(series.iter().flat_map(|(strategy, sizes)| broken(*strategy, sizes)));
    if broken_ones.is_empty() { Ok(()) } else { Err(broken_ones.join("; ").into()) }
}

/// What a query costs in an arrangement.
#[derive(Debug, Clone, Copy)]
struct Size {
    cells: f64,
    /// Predicates per query and doubling.
    calls: f64,
    nanoseconds: f64,
}

/// What is wrong with queries in growing arrangements.
fn broken(strategy: Strategy, sizes: &[Size]) -> Vec<String> {
    let mut broken = Vec::new();
    if let (Some(base), Some(last)) = (sizes.get(1), sizes.last()) {
        if last.calls > GROWTH * base.calls {
            broken.push(format!(
                "{strategy:?}: predicates per query and doubling grew from {:.3} to {:.3}",
                base.calls, last.calls
            ));
        }
        if last.nanoseconds > base.nanoseconds * (last.cells / base.cells).powf(POWER) {
            broken.push(format!(
                "{strategy:?}: nanoseconds per query grew from {:.0} to {:.0}",
                base.nanoseconds, last.nanoseconds
            ));
        }
    }
    if let Some(most) = sizes.iter().map(|size| size.calls).find(|&calls| calls > MOST) {
        broken.push(format!("{strategy:?}: {most:.3} predicates per query and doubling, {MOST} are allowed"));
    }
    broken
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_found() {
        let of = |calls: &[f64], times: &[f64]| {
            let sizes = calls.iter().zip(times).zip([1e3, 1e4, 1e5, 1e6]);
            let sizes = sizes.map(|((&calls, &nanoseconds), cells)| Size { cells, calls, nanoseconds });
            broken(Strategy::Landmarks, &sizes.collect::<Vec<_>>())
        };
        let broken = |calls: &[f64]| of(calls, &[100.0, 200.0, 400.0, 800.0]);
        let slow = ["Landmarks: nanoseconds per query grew from 200 to 3000"];
        assert_eq!(of(&[1.0; 4], &[100.0, 200.0, 1000.0, 3000.0]), slow);
        assert_eq!(broken(&[0.9, 0.5, 0.9, 0.64]), [""; 0]);
        let grown = ["Landmarks: predicates per query and doubling grew from 0.500 to 0.700"];
        assert_eq!(broken(&[0.9, 0.5, 0.5, 0.7]), grown);
        let many = ["Landmarks: 1.100 predicates per query and doubling, 1 are allowed"];
        assert_eq!(broken(&[1.1, 0.9, 0.8, 0.7]), many);
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
