//! Time for edits of arrangements of growing size: no more than a logarithm for each cell that an edit meets.

use crate::Failure;
use crate::peers::arrangements::{Family, Operation, Task, fresh, split_off_faces};

/// Bits of the steps and number of segments: with four times as many segments of half the length, each has as many crossings.
const SIZES: [(u32, usize); 4] = [(17, 1_563), (16, 6_250), (15, 25_000), (14, 100_000)];
/// Holes of one face, and how many small faces are split off it.
const HOLES: [usize; 3] = [1_000, 10_000, 100_000];
const STEPS: usize = 1_000;
/// The time per step and doubling of the size may grow by this factor from the second size to the last, which is 16 or 10 times as
/// large: caches are left behind. What is linear in the size grows by a factor of 8 or more.
const GROWTH: f64 = 3.5;

/// The times of one operation.
struct Series {
    name: &'static str,
    /// Nanoseconds per step, divided by the binary logarithm of the size.
    times: Vec<f64>,
}

/// Prints the table, and checks the bound.
///
/// # Errors
/// If a case fails, or the bound does not hold.
pub(super) fn run() -> Result<(), Failure> {
    println!("{:<28} {:>8} {:>10} {:>10} {:>10} {:>8} {:>13}", "", "", "", "", "", "ns per", "ns per step");
    println!(
        "{:<28} {:>8} {:>10} {:>10} {:>10} {:>8} {:>13}",
        "edits", "input", "size", "steps", "seconds", "step", "and doubling"
    );
    let series = [
        growing("insert curves: vertices", Operation::Insert)?,
        growing("zones: cells", Operation::Zone)?,
        growing("remove edges: vertices", Operation::Remove)?,
        holes("split small faces off one")?,
    ];
    let broken: Vec<String> = series.iter().filter_map(Series::broken).collect();
    if broken.is_empty() { Ok(()) } else { Err(broken.join("; ").into()) }
}

impl Series {
    fn new(name: &'static str) -> Self {
        Self { name, times: Vec::new() }
    }

    /// Adds and prints what so many steps cost at that size.
    fn add(&mut self, input: &str, size: usize, steps: usize, seconds: f64) {
        let step = 1e9 * seconds / steps as f64;
        let time = step / (size as f64).log2();
        println!(
            "{:<28} {input:>8} {size:>10} {steps:>10} {seconds:>10.6} {step:>8.0} {time:>13.2}",
            self.name
        );
        self.times.push(time);
    }

    /// What is wrong, if it grew too much.
    fn broken(&self) -> Option<String> {
        let (base, last) = (*self.times.get(1)?, *self.times.last()?);
        (last > GROWTH * base).then(|| {
            format!("{}: the time per step and doubling grew from {base:.2} to {last:.2} ns", self.name)
        })
    }
}

/// An operation on short segments. The size is the number of vertices; steps are cells that are found, or else vertices.
fn growing(name: &'static str, operation: Operation) -> Result<Series, Failure> {
    let mut series = Series::new(name);
    for (bits, count) in SIZES {
        let measured = fresh(&Task { operation, family: Family::Short(bits), count }, 3, 1.0)?;
        let size = measured.counts.ok_or("an arrangement has counts")?.vertices;
        series.add(&format!("s{bits}"), size, measured.cells().unwrap_or(size), measured.seconds);
    }
    Ok(series)
}

/// Small faces are split off one with many holes: the median of three runs.
fn holes(name: &'static str) -> Result<Series, Failure> {
    let mut series = Series::new(name);
    for holes in HOLES {
        let run = |_| split_off_faces(holes, STEPS);
        let mut seconds = [0, 1, 2].into_iter().map(run).collect::<Result<Vec<f64>, _>>()?;
        seconds.sort_by(f64::total_cmp);
        series.add("holes", holes, STEPS, seconds[1]);
    }
    Ok(series)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_found() {
        let series = |times: &[f64]| Series { name: "some", times: times.to_vec() };
        assert_eq!(series(&[1.0, 10.0, 70.0, 35.0]).broken(), None);
        let broken = series(&[1.0, 10.0, 20.0, 36.0]).broken().expect("it grew");
        assert_eq!(broken, "some: the time per step and doubling grew from 10.00 to 36.00 ns");
    }

    #[test]
    fn small_faces_are_split_off() {
        assert!(split_off_faces(30, 30).expect("there are enough holes") > 0.0);
        assert!(split_off_faces(3, 4).is_err());
    }
}
