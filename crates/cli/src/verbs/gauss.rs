//! `splitstar gauss`.

use super::arrange::{COLLAPSED, sphere, sphere_scene};
use super::counted;
use super::sum::convex;
use crate::args::{CellEncoding, CellFormat, Place, Run};
use crate::console::Console;
use crate::failure::{Failure, one_line};
use crate::input::Operand;
use crate::map::MapReport;
use crate::output;
use crate::report::{Clock, Seconds};
use splitstar::formats::{self, StarGaussianMap};
use splitstar::gauss::{CubicalGaussianMap, SphericalGaussianMap};
use splitstar::render::{RenderError, Scene, SvgOptions};

pub(crate) fn gauss(run: &Run) -> Result<(), Failure> {
    if let Some(output) = &run.output {
        output::probe(output)?;
    }
    // The operand, the work, the writing.
    let mut console = Console::new(run.quiet, 3);
    let mut clock = Clock::start();
    let operand = Operand::read(&run.operands[0], &console)?;
    operand.tell_notes(&console);
    let mut seconds = Seconds { read: clock.lap(), ..Seconds::default() };
    console.step(run.verb.name());
    let polytope = convex(&operand, run, &console)?;
    let map: StarGaussianMap = match run.cubical {
        true => CubicalGaussianMap::of_polytope(&polytope).into(),
        false => SphericalGaussianMap::of_polytope_with(&polytope, sphere(run)).into(),
    };
    seconds.compute = clock.lap();
    let mut report = MapReport::of(&map, &polytope);
    console.step_done();
    console.step("writing");
    if let Some(output) = &run.output {
        output::write(output, &written(&map, run, output, &console)?)?;
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

fn written(map: &StarGaussianMap, run: &Run, output: &Place, console: &Console) -> Result<Vec<u8>, Failure> {
    let CellEncoding { format, gzip } = run.cell_encoding();
    let bytes = match format {
        CellFormat::Star => formats::write_gaussian_map(map),
        CellFormat::Svg => {
            let scene = scene(map, run).map_err(|error| {
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

fn scene(map: &StarGaussianMap, run: &Run) -> Result<Scene, RenderError> {
    match map {
        StarGaussianMap::Spherical(map) => {
            sphere_scene(map.arrangement(), map.arrangement().traits(), run.view)
        }
        StarGaussianMap::Cubical(map) => Scene::of_cube(map.arrangement()),
        _ => unreachable!("no other map is made"),
    }
}

fn summary(report: &MapReport, output: &Place) -> String {
    let Seconds { read, compute, write } = report.seconds;
    format!(
        "gauss: {}, {}, {}: {}, {:.3} s",
        counted(report.vertices, ["vertex", "vertices"]),
        counted(report.edges, ["edge", "edges"]),
        counted(report.faces, ["face", "faces"]),
        one_line(&output.shown()),
        read + compute + write
    )
}
