//! One task in a process of its own: its peak memory and its processor time belong to the task alone.

use std::fs;
use std::sync::OnceLock;
use std::thread;
use std::time::Instant;

use serde_json::{Value, json};

use super::task::{Operand, Operation, Task};
use super::{edits, ours, places};
use crate::bench::peak_kib;
use crate::{Failure, shell};

/// Cells of an arrangement; unbounded faces count, vertices at infinity do not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Counts {
    pub(crate) vertices: usize,
    pub(crate) edges: usize,
    pub(crate) faces: usize,
}

impl std::fmt::Display for Counts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}/{}", self.vertices, self.edges, self.faces)
    }
}

/// Cells where points were located, that curves met, or that are straight above or below something, each as often as it was found.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Located {
    pub(super) vertices: usize,
    pub(super) edges: usize,
    pub(super) faces: usize,
    /// The numbers of halfedges on the outer boundaries of these faces, added up: right faces, not only cells of the right kind. On a
    /// sphere, on all boundaries, but those that come to a vertex of degree two: programs cut elsewhere.
    pub(super) around: usize,
}

/// What our own call of an operation gives.
#[derive(Debug, Clone, Copy)]
pub(super) struct Found {
    /// Vertices and edges of splits included, as peers count; on a sphere without, as they cut elsewhere.
    pub(super) counts: Counts,
    /// For location, zones and walls only.
    pub(super) located: Option<Located>,
    /// Of the operation alone, by [`timed`].
    pub(super) seconds: f64,
}

/// What a program reported of a task.
#[derive(Debug, Clone)]
pub(crate) struct Measured {
    /// Median processor seconds.
    pub(crate) seconds: f64,
    /// Largest resident set until the operation was done once.
    pub(crate) peak_bytes: f64,
    /// Nothing where there are no faces.
    pub(crate) counts: Option<Counts>,
    pub(super) located: Option<Located>,
    /// How many of the points of the task the time is for, if it is not for all.
    pub(super) asked: Option<usize>,
    pub(super) hash: String,
    /// All that it reported.
    pub(super) record: Value,
}

impl Located {
    /// How many cells were found.
    fn cells(self) -> usize {
        self.vertices + self.edges + self.faces
    }
}

impl Measured {
    /// How many cells were found where points are located, or along curves; nothing for other operations.
    pub(crate) fn cells(&self) -> Option<usize> {
        self.located.map(Located::cells)
    }

    /// Reads what a driver printed; ours prints the same.
    ///
    /// # Errors
    /// If time, memory or input are missing.
    pub(super) fn read(record: Value) -> Result<Measured, Failure> {
        let number = |key: &str| record[key].as_f64().ok_or_else(|| format!("the driver gave no `{key}`"));
        let count =
            |object: &Value, key: &str| object[key].as_u64().and_then(|value| usize::try_from(value).ok());
        let counts = match ["vertices", "edges", "faces"].map(|key| count(&record, key)) {
            [Some(vertices), Some(edges), Some(faces)] => Some(Counts { vertices, edges, faces }),
            _ => None,
        };
        let keys = ["vertices", "edges", "faces", "around"];
        let located = match keys.map(|key| count(&record["located"], key)) {
            [Some(vertices), Some(edges), Some(faces), Some(around)] => {
                Some(Located { vertices, edges, faces, around })
            }
            _ => None,
        };
        let (seconds, peak_bytes) = (number("seconds")?, number("peak_bytes")?);
        let hash = record["input_hash"].as_str().ok_or("the driver did not name its input")?.to_owned();
        let asked = count(&record, "asked");
        Ok(Measured { seconds, peak_bytes, counts, located, asked, hash, record })
    }
}

/// Does our side of a task in a new process.
///
/// # Errors
/// If the process cannot be started or fails.
pub(crate) fn fresh(task: &Task, least: usize, budget: f64) -> Result<Measured, Failure> {
    let mut command = shell::program(std::env::current_exe()?);
    command.args(["peers", "arrangements", "--once"]).args(task.words());
    command.arg(least.to_string()).arg(budget.to_string());
    Measured::read(serde_json::from_str(shell::output(&mut command)?.trim())?)
}

/// Does our side of a task in this process, at least `least` times and for about `budget` seconds.
///
/// # Errors
/// If the library refuses the input, or finds different cells in two repetitions.
pub(super) fn answer(task: &Task, least: usize, budget: f64) -> Result<Value, Failure> {
    let operands = task.operands();
    let start = Instant::now();
    let first = perform(task.operation, &operands)?;
    let peak = peak_kib()?;
    let mut times = vec![first.seconds];
    while times.len() < least || (start.elapsed().as_secs_f64() < budget && times.len() < 2_000) {
        let again = perform(task.operation, &operands)?;
        if (again.counts, again.located) != (first.counts, first.located) {
            return Err(format!("{} at first, then {}", first.counts, again.counts).into());
        }
        times.push(again.seconds);
    }
    times.sort_by(f64::total_cmp);
    let middle = (times[(times.len() - 1) / 2] + times[times.len() / 2]) / 2.0;
    let mut answer = json!({
        "method": "splitstar",
        "version": env!("CARGO_PKG_VERSION"),
        "input_hash": format!("{:016x}", operands[0].hash),
        "repetitions": times.len(),
        "seconds": middle,
        "fastest": times[0],
        "peak_bytes": peak * 1024,
        "vertices": first.counts.vertices,
        "edges": first.counts.edges,
        "faces": first.counts.faces,
    });
    if let Some(Located { vertices, edges, faces, around }) = first.located {
        answer["located"] = json!({ "vertices": vertices, "edges": edges, "faces": faces, "around": around });
    }
    Ok(answer)
}

fn perform(operation: Operation, operands: &[Operand]) -> Result<Found, Failure> {
    match (operation, operands) {
        (Operation::Build, [input]) => ours::build(&input.curves),
        (Operation::Insert, [input]) => edits::insert(&input.curves),
        (Operation::Remove, [input]) => edits::remove(&input.curves),
        (Operation::Ready, [input]) => edits::make_ready(&input.curves),
        (Operation::History, [input]) => edits::build_with_history(&input.curves),
        (Operation::InsertHistory, [input]) => edits::insert_with_history(&input.curves),
        (Operation::Zone | Operation::ZoneLong, [input, crossing]) => {
            edits::zone(&input.curves, &crossing.curves)
        }
        (Operation::Overlay, [red, blue]) => ours::overlay_of(&red.curves, &blue.curves),
        (Operation::Locate, [input, points]) => ours::locate(&input.curves, &points.curves),
        (Operation::Prepare(strategy), [input]) => places::prepare(&input.curves, strategy),
        (Operation::Ask(strategy, question), [input, points]) => {
            places::ask(&input.curves, &points.curves, strategy, question)
        }
        (Operation::Decompose, [input]) => places::decompose(&input.curves),
        _ => Err(format!("operands do not fit: {operation}").into()),
    }
}

/// The result and the processor seconds of this thread; the library starts no other for arrangements.
pub(crate) fn timed<T>(action: impl FnOnce() -> T) -> (T, f64) {
    let begin = processor_seconds();
    let result = action();
    (result, processor_seconds() - begin)
}

/// The first number of the kernel's account are the nanoseconds that the thread ran. Where there is none, the clock on the wall
/// stands for it, so that a busy machine counts against us.
fn processor_seconds() -> f64 {
    static ORIGIN: OnceLock<Instant> = OnceLock::new();
    // The account is brought up to date when the thread is scheduled.
    thread::yield_now();
    let account = fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = account.split_whitespace().next().and_then(|word| word.parse::<f64>().ok());
    match nanoseconds {
        Some(nanoseconds) if nanoseconds > 0.0 => nanoseconds * 1e-9,
        _ => ORIGIN.get_or_init(Instant::now).elapsed().as_secs_f64(),
    }
}
