//! `splitstar arrange`.

use super::counted;
use crate::args::{CellEncoding, CellFormat, Place, Run, Surface, View};
use crate::cells::CellReport;
use crate::console::Console;
use crate::curves::{CurveOperand, FlatOperand, SphereOperand, period, tell_notes};
use crate::failure::{Failure, one_line};
use crate::output;
use crate::report::{Clock, Seconds};
use splitstar::arrangement::Arrangement;
use splitstar::arrangement::models::{GeodesicTraits, TorusSegmentTraits};
use splitstar::arrangement::sweep::Progress;
use splitstar::arrangement::topology::Topology;
use splitstar::arrangement::traits::{ApproxTraits, UMonotoneTraits};
use splitstar::formats::{self, CurveError, StarArrangement};
use splitstar::render::{Frame, GlobeOptions, RenderError, Scene, SvgOptions};
use std::ops::ControlFlow;

pub(crate) fn arrange(run: &Run) -> Result<(), Failure> {
    if let Some(output) = &run.output {
        output::probe(output)?;
    }
    // The operands, the work, the writing.
    let mut console = Console::new(run.quiet, run.operands.len() + 2);
    let mut clock = Clock::start();
    let mut seconds = Seconds::default();
    let arrangement = match run.surface {
        Some(Surface::Sphere) => {
            let operands = read_all(run, &console, SphereOperand::read)?;
            let traits = sphere(run);
            seconds.read = clock.lap();
            console.step(run.verb.name());
            let make = |curves, tell: Tell<'_>| StarArrangement::of_sphere_curves_with(curves, traits, tell);
            arranged(operands, make, &console)?
        }
        _ => {
            let operands = read_all(run, &console, FlatOperand::read)?;
            let period = period(&operands, run)?;
            seconds.read = clock.lap();
            console.step(run.verb.name());
            let make = |curves, tell: Tell<'_>| StarArrangement::of_curves_with(curves, period, tell);
            arranged(operands, make, &console)?
        }
    };
    let mut report = CellReport::of(&arrangement);
    seconds.compute = clock.lap();
    console.step_done();
    console.step("writing");
    if let Some(output) = &run.output {
        output::write(output, &written(&arrangement, run, output, &console)?)?;
    }
    seconds.write = clock.lap();
    console.close();
    report.seconds = seconds;
    if run.json {
        return output::report(&report.json());
    }
    match &run.output {
        None => output::report(&report.table()),
        Some(output) => {
            console.say(&summary(&report, output));
            Ok(())
        }
    }
}

/// What is told how far a sweep has come.
type Tell<'a> = &'a mut dyn FnMut(Progress) -> ControlFlow<()>;

/// Reads all files, and tells what had to be left out.
fn read_all<C>(
    run: &Run,
    console: &Console,
    read: fn(&Place, &Console) -> Result<CurveOperand<C>, Failure>,
) -> Result<Vec<CurveOperand<C>>, Failure> {
    let operands: Vec<_> = run.operands.iter().map(|place| read(place, console)).collect::<Result<_, _>>()?;
    tell_notes(&operands, console);
    Ok(operands)
}

/// The sphere, cut open where it is said.
pub(super) fn sphere(run: &Run) -> GeodesicTraits {
    let Some([x, y]) = &run.identification else { return GeodesicTraits::new() };
    let direction = [x.numerator() * y.denominator(), y.numerator() * x.denominator()];
    GeodesicTraits::with_identification(direction).expect("zeros are refused on the command line")
}

/// The arrangement of the curves of all files; the console is told how far it has come.
fn arranged<C>(
    mut operands: Vec<CurveOperand<C>>,
    make: impl FnOnce(Vec<C>, Tell<'_>) -> Result<Option<StarArrangement>, CurveError>,
    console: &Console,
) -> Result<StarArrangement, Failure> {
    let mut tell = |progress: Progress| {
        console.step_at("arrange", progress.sites_met, progress.sites);
        ControlFlow::Continue(())
    };
    let counts: Vec<usize> = operands.iter().map(|operand| operand.curves.len()).collect();
    let curves = operands.iter_mut().flat_map(|operand| std::mem::take(&mut operand.curves)).collect();
    match make(curves, &mut tell) {
        Ok(made) => Ok(made.expect("nobody stops the sweep")),
        Err(CurveError { mut curve, fault }) => {
            let mut at = 0;
            while at + 1 < counts.len() && curve >= counts[at] {
                curve -= counts[at];
                at += 1;
            }
            Err(operands[at].failure(curve, fault.to_string()))
        }
    }
}

/// What is said of a picture that may show different things in one place.
pub(super) const COLLAPSED: &str = "coordinates differ too little for a picture; write star";

fn written(
    arrangement: &StarArrangement,
    run: &Run,
    output: &Place,
    console: &Console,
) -> Result<Vec<u8>, Failure> {
    let CellEncoding { format, gzip } = run.cell_encoding();
    let bytes = match format {
        CellFormat::Star => formats::write_arrangement(arrangement),
        CellFormat::Svg => {
            let scene = scene(arrangement, run.view).map_err(|error| {
                let sentence = format!("not drawn: {error}; write star, which has no limit");
                Failure::file(&output.shown(), None, sentence)
            })?;
            if scene.is_collapsed() {
                console.note(&output.shown(), None, COLLAPSED);
            }
            scene.to_svg(&SvgOptions::default()).into_bytes()
        }
    };
    Ok(if gzip { formats::pack_gzip(&bytes) } else { bytes })
}

/// The picture of an arrangement: of all vertices, of one rectangle of a torus, or of a sphere as it is asked for.
fn scene(arrangement: &StarArrangement, view: Option<View>) -> Result<Scene, RenderError> {
    match arrangement {
        StarArrangement::Linear(arrangement) => Scene::of_arrangement(arrangement, None),
        StarArrangement::Polycurves(arrangement) => Scene::of_arrangement(arrangement, None),
        StarArrangement::Torus(arrangement) => {
            Scene::of_arrangement(arrangement, Some(rectangle(arrangement.traits())?))
        }
        StarArrangement::TorusPolycurves(arrangement) => {
            Scene::of_arrangement(arrangement, Some(rectangle(arrangement.traits().inner())?))
        }
        StarArrangement::Sphere(arrangement) => sphere_scene(arrangement, arrangement.traits(), view),
        StarArrangement::SpherePolycurves(arrangement) => {
            sphere_scene(arrangement, arrangement.traits().inner(), view)
        }
        _ => unreachable!("no other arrangement is built"),
    }
}

pub(super) fn sphere_scene<G: ApproxTraits + UMonotoneTraits, T: Topology<G>>(
    arrangement: &Arrangement<G, T>,
    sphere: &GeodesicTraits,
    view: Option<View>,
) -> Result<Scene, RenderError> {
    match view {
        Some(View::Unfolded) => Scene::of_arrangement(arrangement, None),
        Some(View::Globe) | None => {
            let [x, y, _] = sphere.identification().approx_f64();
            Scene::of_globe(arrangement, &GlobeOptions::default().with_identification([x, y])?)
        }
    }
}

fn rectangle(traits: &TorusSegmentTraits) -> Result<Frame, RenderError> {
    Frame::new([0.0, 0.0], traits.period().each_ref().map(|period| period.approx_f64()))
}

fn summary(report: &CellReport, output: &Place) -> String {
    let Seconds { read, compute, write } = report.seconds;
    format!(
        "arrange: {}, {}, {}: {}, {:.3} s",
        counted(report.vertices, ["vertex", "vertices"]),
        counted(report.edges, ["edge", "edges"]),
        counted(report.faces, ["face", "faces"]),
        one_line(&output.shown()),
        read + compute + write
    )
}
