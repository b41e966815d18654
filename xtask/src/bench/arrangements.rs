//! Time for arrangements of more and more segments with as many crossings each: n log n.

use crate::Failure;
use crate::peers::arrangements::{Family, Operation, Task, fresh};

/// Bits of the steps and number of segments: with four times as many segments of half the length, each has as many crossings.
const SIZES: [(u32, usize); 5] = [(16, 6_250), (15, 25_000), (14, 100_000), (13, 400_000), (12, 1_600_000)];
/// The time per event and doubling of the number of events may grow by this factor from the second case to the last: caches are
/// left behind.
const GROWTH: f64 = 2.0;
/// Bytes per cell, in a fresh process: the program itself and the input count.
const MEMORY: f64 = 1024.0;

/// Prints the table, and checks both bounds.
///
/// # Errors
/// If a case fails, or a bound does not hold.
pub(super) fn run() -> Result<(), Failure> {
    println!(
        "{:<20} {:>10} {:>10} {:>10} {:>8} {:>14} {:>9}",
        "", "", "", "", "ns per", "ns per event", "bytes per"
    );
    println!(
        "{:<20} {:>10} {:>10} {:>10} {:>8} {:>14} {:>9}",
        "short segments", "crossings", "events", "seconds", "event", "and doubling", "cell"
    );
    let (mut times, mut broken) = (Vec::new(), Vec::new());
    for (bits, count) in SIZES {
        let task = Task { operation: Operation::Build, family: Family::Short(bits), count };
        let measured = fresh(&task, 3, 1.0)?;
        let counts = measured.counts.ok_or("an arrangement has counts")?;
        // Every vertex is met once.
        let events = counts.vertices as f64;
        let cells = (counts.vertices + counts.edges + counts.faces) as f64;
        let per_event = 1e9 * measured.seconds / events;
        let (time, memory) = (per_event / events.log2(), measured.peak_bytes / cells);
        let name = format!("s{bits} {count}");
        println!(
            "{name:<20} {:>10.3} {events:>10} {:>10.6} {per_event:>8.0} {time:>14.2} {memory:>9.0}",
            // Edges are segments and two more for each crossing.
            (counts.edges - count) as f64 / count as f64,
            measured.seconds
        );
        if memory > MEMORY {
            broken.push(format!("{name}: {memory:.0} bytes per cell, at most {MEMORY} are allowed"));
        }
        times.push(time);
    }
    let (base, last) = (times[1], times[times.len() - 1]);
    if last > GROWTH * base {
        broken.push(format!("the time per event and doubling grew from {base:.2} to {last:.2} ns"));
    }
    if broken.is_empty() { Ok(()) } else { Err(broken.join("; ").into()) }
}
