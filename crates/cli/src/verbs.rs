//! What the verbs do, one function each.

mod arrange;
mod convert;
mod distance;
mod gauss;
mod hull;
mod info;
mod locate;
mod sum;

pub(crate) use arrange::arrange;
pub(crate) use convert::convert;
pub(crate) use distance::distance;
pub(crate) use gauss::gauss;
pub(crate) use hull::hull;
pub(crate) use info::info;
pub(crate) use locate::locate;
pub(crate) use sum::sum;

use crate::approx::approx;
use crate::args::{Place, Run};
use crate::console::Console;
use crate::failure::Failure;
use crate::input::Operand;
use crate::output;
use crate::report::{Clock, Made, Report, Seconds, width_bits};
use splitstar::exact::{Point3, Quaternion};
use splitstar::formats::{self, Format, Loss, Model, Shape, Unit, WriteError, WriteOptions, Written};
use splitstar::polytope::{PolygonMesh, Polytope};

/// A verb at work: its output is known to be writable, its operands are read.
struct Job<'a> {
    run: &'a Run,
    output: &'a Place,
    operands: Vec<Operand>,
    console: Console,
    clock: Clock,
    seconds: Seconds,
}

impl<'a> Job<'a> {
    fn start(run: &'a Run) -> Result<Self, Failure> {
        let output = run.output.as_ref().expect("a verb that writes has an output");
        output::probe(output)?;
        // The operands, the work, the writing.
        let console = Console::new(run.quiet, run.operands.len() + 2);
        let mut clock = Clock::start();
        let operands: Vec<Operand> =
            run.operands.iter().map(|place| Operand::read(place, &console)).collect::<Result<_, _>>()?;
        for operand in &operands {
            operand.tell_notes(&console);
        }
        let seconds = Seconds { read: clock.lap(), ..Seconds::default() };
        console.step(run.verb.name());
        Ok(Self { run, output, operands, console, clock, seconds })
    }

    /// Writes the result, and says what it is.
    fn finish(mut self, outcome: &Outcome) -> Result<(), Failure> {
        self.seconds.compute = self.clock.lap();
        self.console.step_done();
        self.console.step("writing");
        let file = self.output.shown();
        let mut options = WriteOptions::new(self.run.encoding());
        (options.float, options.lossy) = (self.run.float, self.run.lossy);
        let written = formats::write(&outcome.model, &options).map_err(|error| {
            Failure::file(&file, None, format!("not written: {error}{}", option_for(&error)))
        })?;
        output::write(self.output, &written.bytes)?;
        self.seconds.write = self.clock.lap();
        self.console.close();
        for note in &written.notes {
            self.console.note(&file, None, &note.to_string());
        }
        if self.run.float || !written.largest_rounding.is_zero() {
            let rounding = approx(&written.largest_rounding);
            self.console.note(&file, None, &format!("written as floats; the largest rounding is {rounding}"));
        }
        if !written.largest_rounding.is_zero() && has_polygons(&outcome.model, options.encoding.format) {
            let what = "facets of more than three corners are in general not planar any more; write triangles \
                        (convert --triangulate), or OFF or star without --float";
            self.console.note(&file, None, what);
        }
        if self.run.json {
            return output::report(&self.report(outcome, &written).json());
        }
        self.console.say(&self.summary(&file, outcome));
        Ok(())
    }

    fn report(&self, outcome: &Outcome, written: &Written) -> Report {
        let report = match (&outcome.polytope, &outcome.model.shape) {
            (Some(polytope), _) => Report::of_polytope(polytope),
            (None, Shape::Mesh(mesh)) => Report::of_mesh(mesh),
            (None, Shape::Complex(complex)) => Report::of_complex(complex),
        };
        let points: Vec<&Point3> = outcome.model.shape.points().collect();
        let made = Made {
            method: outcome.method,
            width_bits: width_bits(&points),
            rounding: written.largest_rounding.to_string(),
            quaternion: outcome
                .quaternion
                .as_ref()
                .map(|q| q.components().each_ref().map(ToString::to_string)),
            seconds: self.seconds,
        };
        report.file(self.run.encoding().format, &outcome.model).made(made)
    }

    fn summary(&self, file: &str, outcome: &Outcome) -> String {
        let Seconds { read, compute, write } = self.seconds;
        let what = match (&outcome.polytope, &outcome.model.shape) {
            (Some(polytope), _) => {
                let counts = polytope.counts();
                format!(
                    "dimension {}, {}, {}, {}",
                    polytope.dimension(),
                    counted(counts.vertices, ["vertex", "vertices"]),
                    counted(counts.edges, ["edge", "edges"]),
                    counted(counts.facets, ["facet", "facets"])
                )
            }
            (None, Shape::Mesh(mesh)) => format!(
                "{}, {}",
                counted(mesh.points.len(), ["vertex", "vertices"]),
                counted(mesh.facets.len(), ["facet", "facets"])
            ),
            (None, Shape::Complex(complex)) => format!(
                "{}, {}",
                counted(complex.vertices.len(), ["vertex", "vertices"]),
                counted(complex.facets.len(), ["facet", "facets"])
            ),
        };
        let file = crate::failure::one_line(file);
        let verb = self.run.verb.name();
        let method = if outcome.method == verb { String::new() } else { format!(" ({})", outcome.method) };
        format!("{verb}{method}: {what}: {file}, {:.3} s", read + compute + write)
    }
}

/// The unit that operands have; those without one have that of the others.
fn common_unit(operands: &[Operand]) -> Result<Option<Unit>, Failure> {
    let mut units = operands.iter().filter_map(|operand| Some((operand, operand.read.model.unit?)));
    let Some((first, unit)) = units.next() else { return Ok(None) };
    match units.find(|(_, other)| *other != unit) {
        None => Ok(Some(unit)),
        Some((operand, other)) => Err(operand.failure(
            None,
            format!(
                "its unit is {other}, that of {} is {unit}; `splitstar convert --unit {unit}` makes them one",
                first.name
            ),
        )),
    }
}

/// What a verb made, and how.
struct Outcome {
    model: Model,
    /// The model, if it is known to be one.
    polytope: Option<Polytope>,
    method: &'static str,
    quaternion: Option<Quaternion>,
}

impl Outcome {
    fn of_polytope(polytope: Polytope, unit: Option<Unit>, method: &'static str) -> Self {
        let mut model = Model::of_mesh(polytope.to_mesh());
        model.unit = unit;
        Self { model, polytope: Some(polytope), method, quaternion: None }
    }
}

/// The option of ours that is the way out.
fn option_for(error: &WriteError) -> &'static str {
    match error {
        WriteError::Loses { losses, .. } => match losses[..] {
            [Loss::Holes(_)] => " with --triangulate",
            _ => " with --lossy",
        },
        _ => "",
    }
}

/// Whether facets of more than three corners are written.
fn has_polygons(model: &Model, format: Format) -> bool {
    let triangles_only = matches!(format, Format::Stl | Format::StlAscii | Format::ThreeMf | Format::Glb);
    let has_more = |mesh: &PolygonMesh| mesh.facets.iter().any(|cycle| cycle.len() > 3);
    !triangles_only && model.shape.mesh().is_some_and(has_more)
}

fn counted(count: usize, [one, many]: [&str; 2]) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// The points that the facets of a mesh use; all of them if there is no facet.
fn used_points(mesh: &PolygonMesh) -> Vec<Point3> {
    if mesh.facets.is_empty() {
        return mesh.points.clone();
    }
    let mut used = vec![false; mesh.points.len()];
    for &vertex in mesh.facets.corners() {
        used[vertex as usize] = true;
    }
    mesh.points.iter().zip(used).filter(|(_, used)| *used).map(|(point, _)| point.clone()).collect()
}
