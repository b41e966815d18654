//! Time and counted work of edits of arrangements of growing size: no more than a logarithm for each cell that an edit meets.

use crate::Failure;
use crate::peers::arrangements::{Family, Operation, Task, fresh, split_off_faces};

use super::counted::{Counted, of_holes, of_short};

/// Bits of the steps and number of segments: with 16 times as many segments of a quarter of the length, each has as many crossings.
const SIZES: [(u32, usize); 3] = [(18, 391), (16, 6_250), (14, 100_000)];
/// Holes of one face, and how many small faces are split off it.
const HOLES: [usize; 3] = [1_000, 10_000, 100_000];
const STEPS: usize = 1_000;
/// What the work per step gains from the second size to the third is at most this many times what it gains from the first to the second.
///
/// Sizes are the powers of one factor, 16 or 10. What is a constant and a multiple of the logarithm gains as much each time: the ratio
/// is 1, whatever the constant. What has a part that is a root of the size gains sqrt(16) = 4 or sqrt(10) = 3.2 times as much each next
/// time, in that part. Work is counted, so nothing but the order of input makes it flicker: see [`SLACK`].
const GAIN: f64 = 2.0;
/// A gain of this part of the work at the second size is none.
const SLACK: f64 = 0.05;
/// The time per step grows from the second size to the third at most as this power of the size: by 7 for 16 times, by 5 for 10 times.
///
/// A logarithm alone grows by less than 1.4 there, but the cells are no longer in a cache: factors of up to 3.3 in all were measured on
/// an idle machine. A root alone grows by 4 or 3.2, and with the same caches left behind by about 10. The limit is between, with room for
/// a machine that does other things; what is near it, the work tells apart.
const POWER: f64 = 0.7;

/// What one operation costs.
struct Series {
    name: &'static str,
    rows: Vec<Row>,
}

/// At one size, and per step.
#[derive(Clone, Copy)]
struct Row {
    size: f64,
    nanoseconds: f64,
    work: f64,
}

/// Prints the table, and checks both bounds.
///
/// # Errors
/// If a case fails, or a bound does not hold.
pub(super) fn run() -> Result<(), Failure> {
    println!("{:<28} {:>8} {:>10} {:>10} {:>10} {:>8} {:>8}", "", "", "", "", "", "ns per", "work per");
    println!(
        "{:<28} {:>8} {:>10} {:>10} {:>10} {:>8} {:>8}",
        "edits", "input", "size", "steps", "seconds", "step", "step"
    );
    let series = [
        growing("insert curves: vertices", Operation::Insert)?,
        growing("zones: cells", Operation::Zone)?,
        growing("remove edges: vertices", Operation::Remove)?,
        holes("split small faces off one")?,
    ];
    let broken: Vec<String> = series.iter().flat_map(Series::broken).collect();
    if broken.is_empty() { Ok(()) } else { Err(broken.join("; ").into()) }
}

impl Series {
    fn new(name: &'static str) -> Self {
        Self { name, rows: Vec::new() }
    }

    /// Adds and prints what steps cost at that size.
    fn add(&mut self, input: &str, size: usize, seconds: f64, counted: Counted) {
        let Counted { steps, .. } = counted;
        let (nanoseconds, work) = (1e9 * seconds / steps as f64, counted.per_step());
        println!(
            "{:<28} {input:>8} {size:>10} {steps:>10} {seconds:>10.6} {nanoseconds:>8.0} {work:>8.1}",
            self.name
        );
        self.rows.push(Row { size: size as f64, nanoseconds, work });
    }

    /// What is wrong: nothing, one sentence or two.
    fn broken(&self) -> Vec<String> {
        let &[a, b, c] = &self.rows[..] else {
            return vec![format!("{}: there are no three sizes", self.name)];
        };
        let mut broken = Vec::new();
        let (first, second) = (b.work - a.work, c.work - b.work);
        if second > GAIN * first.max(SLACK * b.work) {
            broken.push(format!(
                "{}: the work per step gained {first:.1}, and then {second:.1}, which is no logarithm",
                self.name
            ));
        }
        if c.nanoseconds > b.nanoseconds * (c.size / b.size).powf(POWER) {
            broken.push(format!(
                "{}: the time per step grew from {:.0} to {:.0} ns",
                self.name, b.nanoseconds, c.nanoseconds
            ));
        }
        broken
    }
}

/// An operation on short segments. The size is the number of vertices; steps are cells that are found, or else vertices.
fn growing(name: &'static str, operation: Operation) -> Result<Series, Failure> {
    let mut series = Series::new(name);
    for (bits, count) in SIZES {
        let measured = fresh(&Task { operation, family: Family::Short(bits), count }, 3, 1.0)?;
        let size = measured.counts.ok_or("an arrangement has counts")?.vertices;
        let counted = of_short(operation, count, bits)?;
        if counted.steps != measured.cells().unwrap_or(size) {
            return Err(format!("{name}: {} steps were counted, others measured", counted.steps).into());
        }
        series.add(&format!("s{bits}"), size, measured.seconds, counted);
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
        series.add("holes", holes, seconds[1], of_holes(holes, STEPS)?);
    }
    Ok(series)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Costs at sizes of which each is 16 times the one before.
    fn series(cost: impl Fn(f64) -> [f64; 2]) -> Series {
        let rows = [1_000.0, 16_000.0, 256_000.0].map(|size| {
            let [nanoseconds, work] = cost(size);
            Row { size, nanoseconds, work }
        });
        Series { name: "some", rows: rows.to_vec() }
    }

    #[test]
    fn logarithms_pass_and_roots_do_not() {
        for constant in [0.0, 10.0, 1_000.0] {
            assert!(series(|n| [1_000.0, constant + n.log2()]).broken().is_empty());
            let root = series(|n| [1_000.0, constant + n.sqrt()]).broken();
            assert!(root.len() == 1 && root[0].contains("no logarithm"), "{root:?}");
        }
        // A root that is less than a fifth of the work at the second size, beside a logarithm that is the rest.
        assert_eq!(series(|n| [1_000.0, n.log2() + n.sqrt() / 40.0]).broken().len(), 1);
        // Something that falls, or stays, but for a little.
        assert!(series(|n| [1_000.0, 50.0 - n.log2()]).broken().is_empty());
        assert!(series(|n| [1_000.0, 50.0 + f64::from(n > 100_000.0)]).broken().is_empty());
        // A logarithm on a machine whose memory is slow; and a root there.
        assert!(series(|n| [n.powf(0.41), 50.0]).broken().is_empty());
        assert_eq!(
            series(|n| [n.powf(0.75), 50.0]).broken(),
            ["some: the time per step grew from 1423 to 11381 ns"]
        );
    }

    #[test]
    fn small_faces_are_split_off() {
        assert!(split_off_faces(30, 30).expect("there are enough holes") > 0.0);
        assert!(split_off_faces(3, 4).is_err());
    }
}
