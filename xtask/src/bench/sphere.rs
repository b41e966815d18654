//! Time and counted predicates on a sphere: a sweep, insertion one by one, and location, in arrangements of random arcs.

use crate::Failure;
use crate::peers::arrangements::{Family, Operation, Search, Strategy, Task, fresh, searches};

use super::counted::of_arcs;

/// Numbers of arcs; about ten times as many cells at each.
const SIZES: [usize; 3] = [300, 1_000, 3_000];
/// These must reach the bounds.
const BOUNDED: [Strategy; 2] = [Strategy::Trapezoids, Strategy::Landmarks];
/// The predicates asked for a step, divided by the binary logarithm of the number of cells, may grow by this factor from the first size
/// to the last, which has about a hundred times as many. They are counted, so nothing else on the machine changes them.
const GROWTH: f64 = 1.3;
/// The time for a step grows at most as this power of the number of cells: what is linear for each step is far above it. That leaves
/// room for memory: in a larger arrangement, fewer of the cells are in a cache.
const POWER: f64 = 0.5;

/// What one operation costs.
struct Series {
    name: &'static str,
    rows: Vec<Row>,
}

/// At one size, and per step: a vertex, or a query.
#[derive(Debug, Clone, Copy)]
struct Row {
    cells: f64,
    nanoseconds: f64,
    calls: f64,
}

/// Prints the table, and checks both bounds.
///
/// # Errors
/// If a case fails, or a bound does not hold.
pub(super) fn run() -> Result<(), Failure> {
    println!(
        "{:<26} {:>6} {:>10} {:>10} {:>8} {:>10} {:>12}",
        "", "", "", "seconds to", "ns per", "predicates", "per step"
    );
    println!(
        "{:<26} {:>6} {:>10} {:>10} {:>8} {:>10} {:>12}",
        "random arcs on a sphere", "arcs", "cells", "make", "step", "per step", "and doubling"
    );
    let mut series = vec![
        edited("sweep: vertices", Operation::Build)?,
        edited("one by one: vertices", Operation::Insert)?,
    ];
    series.extend(located()?);
    let broken: Vec<String> = series.iter().flat_map(Series::broken).collect();
    if broken.is_empty() { Ok(()) } else { Err(broken.join("; ").into()) }
}

impl Series {
    fn new(name: &'static str) -> Self {
        Self { name, rows: Vec::new() }
    }

    /// Adds and prints what steps cost at one size.
    fn add(&mut self, arcs: usize, seconds: f64, row: Row) {
        let Row { cells, nanoseconds, calls } = row;
        println!(
            "{:<26} {arcs:>6} {cells:>10} {seconds:>10.6} {nanoseconds:>8.0} {calls:>10.2} {:>12.3}",
            self.name,
            calls / cells.log2()
        );
        self.rows.push(row);
    }

    /// What is wrong: nothing, one sentence or two.
    fn broken(&self) -> Vec<String> {
        let mut broken = Vec::new();
        if let (Some(first), Some(last)) = (self.rows.first(), self.rows.last()) {
            let [before, after] = [first, last].map(|row| row.calls / row.cells.log2());
            if after > GROWTH * before {
                broken.push(format!(
                    "{}: predicates per step and doubling grew from {before:.3} to {after:.3}",
                    self.name
                ));
            }
            if last.nanoseconds > first.nanoseconds * (last.cells / first.cells).powf(POWER) {
                broken.push(format!(
                    "{}: the time per step grew from {:.0} to {:.0} ns",
                    self.name, first.nanoseconds, last.nanoseconds
                ));
            }
        }
        broken
    }
}

/// What makes an arrangement; a step is a vertex.
fn edited(name: &'static str, operation: Operation) -> Result<Series, Failure> {
    let mut series = Series::new(name);
    for count in SIZES {
        let measured = fresh(&Task { operation, family: Family::Arcs, count }, 3, 1.0)?;
        let counts = measured.counts.ok_or("an arrangement has counts")?;
        let counted = of_arcs(operation, count)?;
        if counted.steps != counts.vertices {
            return Err(format!("{name}: {} vertices were counted, others measured", counted.steps).into());
        }
        let cells = (counts.vertices + counts.edges + counts.faces) as f64;
        let nanoseconds = 1e9 * measured.seconds / counts.vertices as f64;
        series.add(count, measured.seconds, Row { cells, nanoseconds, calls: counted.per_step() });
    }
    Ok(series)
}

/// What finds cells; a step is a query. In the smallest arrangement the answers are also those of the strategies that prepare nothing.
fn located() -> Result<Vec<Series>, Failure> {
    let mut series = BOUNDED.map(|strategy| {
        let name =
            if strategy == Strategy::Landmarks { "by landmarks: queries" } else { "by trapezoids: queries" };
        (strategy, Series::new(name))
    });
    for count in SIZES {
        let mut strategies = BOUNDED.to_vec();
        if count == SIZES[0] {
            strategies.extend([Strategy::Walk, Strategy::Naive]);
        }
        let (cells, found) = searches(Family::Arcs, count, &strategies)?;
        for Search { strategy, prepare, query, calls, .. } in found {
            if let Some((_, series)) = series.iter_mut().find(|(bounded, _)| *bounded == strategy) {
                series.add(count, prepare, Row { cells: cells as f64, nanoseconds: 1e9 * query, calls });
            }
        }
    }
    Ok(series.map(|(_, series)| series).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_found() {
        let of = |calls: [f64; 2], nanoseconds: [f64; 2]| {
            let row = |i: usize, cells| Row { cells, nanoseconds: nanoseconds[i], calls: calls[i] };
            Series { name: "some", rows: vec![row(0, 1024.0), row(1, 1024.0 * 1024.0)] }.broken()
        };
        assert_eq!(of([10.0, 26.0], [100.0, 3_200.0]), [""; 0]);
        assert_eq!(
            of([10.0, 26.1], [100.0, 100.0]),
            ["some: predicates per step and doubling grew from 1.000 to 1.305"]
        );
        assert_eq!(of([10.0, 10.0], [100.0, 3_201.0]), ["some: the time per step grew from 100 to 3201 ns"]);
    }

    #[test]
    fn strategies_agree_on_a_sphere() {
        let all = [Strategy::Trapezoids, Strategy::Landmarks, Strategy::Walk, Strategy::Naive];
        let (cells, found) = searches(Family::Arcs, 20, &all).expect("they agree");
        assert!(cells > 60, "{cells}");
        assert_eq!(found.len(), 4);
        assert!(found.iter().all(|search| search.calls > 0.0 && search.query > 0.0));
    }
}
