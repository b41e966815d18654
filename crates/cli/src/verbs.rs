//! What the verbs do, one function each.

mod convert;
mod hull;
mod info;
mod sum;

pub(crate) use convert::convert;
pub(crate) use hull::hull;
pub(crate) use info::info;
pub(crate) use sum::sum;

use crate::approx::approx;
use crate::args::{Place, Run};
use crate::console::Console;
use crate::failure::Failure;
use crate::input::Operand;
use crate::output;
use crate::report::{Clock, Made, Report, Seconds, width_bits};
use splitstar::exact::{Point3, Quaternion};
use splitstar::formats::{Coordinates, WriteOptions, write_off};
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
        let operands =
            run.operands.iter().map(|place| Operand::read(place, &console)).collect::<Result<_, _>>()?;
        let seconds = Seconds { read: clock.lap(), ..Seconds::default() };
        console.step(run.verb.name());
        Ok(Self { run, output, operands, console, clock, seconds })
    }

    /// Writes the result, and says what it is.
    fn finish(mut self, result: &Outcome) -> Result<(), Failure> {
        self.seconds.compute = self.clock.lap();
        self.console.step_done();
        self.console.step("writing");
        let file = match self.output {
            Place::Standard => "-".to_string(),
            Place::File(path) => path.to_string_lossy().into_owned(),
        };
        let coordinates = if self.run.float { Coordinates::Float } else { Coordinates::Exact };
        let options = WriteOptions::with_coordinates(coordinates);
        let polytope_mesh;
        let mesh = match &result.shape {
            Shape::Mesh(mesh) => mesh,
            Shape::Polytope(polytope) => {
                polytope_mesh = polytope.to_mesh();
                &polytope_mesh
            }
        };
        let (text, written) =
            write_off(mesh, &options).map_err(|error| Failure::file(&file, None, error.to_string()))?;
        output::write(self.output, &text)?;
        self.seconds.write = self.clock.lap();
        self.console.close();
        if self.run.float {
            let rounding = approx(&written.largest_rounding);
            self.console.note(&file, None, &format!("written as floats; the largest rounding is {rounding}"));
        }
        if !self.run.json {
            self.console.say(&self.summary(&file, result, mesh));
            return Ok(());
        }
        let report = match &result.shape {
            Shape::Mesh(mesh) => Report::of_mesh(mesh),
            Shape::Polytope(polytope) => Report::of_polytope(polytope),
        };
        let made = Made {
            method: result.method,
            width_bits: width_bits(&mesh.points),
            rounding: self.run.float.then(|| written.largest_rounding.to_string()),
            quaternion: result
                .quaternion
                .as_ref()
                .map(|q| q.components().each_ref().map(ToString::to_string)),
            seconds: self.seconds,
        };
        output::report(&report.made(made).json())
    }

    fn summary(&self, file: &str, result: &Outcome, mesh: &PolygonMesh) -> String {
        let Seconds { read, compute, write } = self.seconds;
        let what = match &result.shape {
            Shape::Polytope(polytope) => {
                let counts = polytope.counts();
                format!(
                    "dimension {}, {}, {}, {}",
                    polytope.dimension(),
                    counted(counts.vertices, ["vertex", "vertices"]),
                    counted(counts.edges, ["edge", "edges"]),
                    counted(counts.facets, ["facet", "facets"])
                )
            }
            Shape::Mesh(_) => format!(
                "{}, {}",
                counted(mesh.points.len(), ["vertex", "vertices"]),
                counted(mesh.facets.len(), ["facet", "facets"])
            ),
        };
        let file = crate::failure::one_line(file);
        let verb = self.run.verb.name();
        let method = if result.method == verb { String::new() } else { format!(" ({})", result.method) };
        format!("{verb}{method}: {what}: {file}, {:.3} s", read + compute + write)
    }
}

/// What a verb made, and how.
struct Outcome {
    shape: Shape,
    method: &'static str,
    quaternion: Option<Quaternion>,
}

enum Shape {
    Polytope(Polytope),
    Mesh(PolygonMesh),
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
