//! `splitstar arrange`.

mod build;

use super::counted;
use crate::args::{CellEncoding, CellFormat, Place, Run};
use crate::cells::CellReport;
use crate::console::Console;
use crate::curves::{CurveOperand, ground, tell_notes};
use crate::failure::{Failure, one_line};
use crate::output;
use crate::report::{Clock, Seconds};
use splitstar::arrangement::models::TorusSegmentTraits;
use splitstar::formats::{self, StarArrangement};
use splitstar::render::{Frame, RenderError, Scene, SvgOptions};

pub(crate) fn arrange(run: &Run) -> Result<(), Failure> {
    if let Some(output) = &run.output {
        output::probe(output)?;
    }
    // The operands, the work, the writing.
    let mut console = Console::new(run.quiet, run.operands.len() + 2);
    let mut clock = Clock::start();
    let operands: Vec<CurveOperand> =
        run.operands.iter().map(|place| CurveOperand::read(place, &console)).collect::<Result<_, _>>()?;
    tell_notes(&operands, &console);
    let ground = ground(&operands, run)?;
    let mut seconds = Seconds { read: clock.lap(), ..Seconds::default() };
    console.step(run.verb.name());
    let arrangement = build::arrangement(operands, ground, &console)?;
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
            let scene = scene(arrangement).map_err(|error| {
                let sentence = format!("not drawn: {error}; write star, which has no limit");
                Failure::file(&output.shown(), None, sentence)
            })?;
            if scene.is_collapsed() {
                let sentence = "coordinates differ too little for a picture; write star";
                console.note(&output.shown(), None, sentence);
            }
            scene.to_svg(&SvgOptions::default()).into_bytes()
        }
    };
    Ok(if gzip { formats::pack_gzip(&bytes) } else { bytes })
}

/// The picture of an arrangement: of all vertices, or of one rectangle of a torus.
fn scene(arrangement: &StarArrangement) -> Result<Scene, RenderError> {
    match arrangement {
        StarArrangement::Linear(arrangement) => Scene::of_arrangement(arrangement, None),
        StarArrangement::Polycurves(arrangement) => Scene::of_arrangement(arrangement, None),
        StarArrangement::Torus(arrangement) => {
            Scene::of_arrangement(arrangement, Some(rectangle(arrangement.traits())?))
        }
        StarArrangement::TorusPolycurves(arrangement) => {
            Scene::of_arrangement(arrangement, Some(rectangle(arrangement.traits().inner())?))
        }
        _ => unreachable!("no other arrangement is built"),
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
