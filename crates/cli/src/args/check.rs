//! Whether the parts of a command line fit together.

use super::names::{cells_of_name, encoding_of_name};
use super::{CellFormat, Place, Run, Strategy, Surface, Verb, usage};
use crate::failure::Failure;

/// What only the whole command line shows.
pub(super) fn check(run: &Run, given: &[&str]) -> Result<(), Failure> {
    let verb = run.verb;
    let (least, most) = match verb {
        Verb::Sum => (2, usize::MAX),
        Verb::Hull | Verb::Arrange => (1, usize::MAX),
        Verb::Info | Verb::Convert | Verb::Gauss => (1, 1),
        Verb::Distance | Verb::Locate => (2, 2),
    };
    let count = run.operands.len();
    if count != 2 && matches!(verb, Verb::Distance | Verb::Locate) {
        let wanted = match verb {
            Verb::Locate => "the file of an arrangement and a file of points",
            _ => "the files of two polytopes",
        };
        return Err(usage(verb, format!("{wanted} expected, {count} given")));
    }
    if count < least {
        let wanted = if least == 1 { "a file to read" } else { "two or more files to add" };
        return Err(usage(verb, format!("{wanted} expected, {count} given")));
    }
    if count > most {
        return Err(usage(verb, format!("one file to read expected, {count} given")));
    }
    let inputs = run.operands.iter().chain(&run.placing.path);
    if inputs.filter(|input| **input == Place::Standard).count() > 1 {
        return Err(usage(verb, "standard input `-` can be read once only"));
    }
    if verb.needs_output() && run.output.is_none() {
        return Err(usage(verb, "where to write is missing: -o OUT, or -o - for standard output"));
    }
    let named = match (&run.output, verb) {
        (Some(output), Verb::Arrange | Verb::Gauss) if run.cells.is_none() => {
            let what = if verb == Verb::Gauss { "a Gaussian map" } else { "an arrangement" };
            cells_of_name(output, what).err()
        }
        (Some(_), Verb::Arrange | Verb::Locate | Verb::Gauss) => None,
        (Some(output), _) if run.format.is_none() => encoding_of_name(output).err(),
        (None, Verb::Arrange | Verb::Gauss) if run.cells.is_some() => {
            Some("`--format` says what to write, and where is missing: -o OUT".into())
        }
        _ => None,
    };
    if let Some(sentence) = named {
        return Err(usage(verb, sentence));
    }
    if run.json && run.output == Some(Place::Standard) {
        let what = match verb {
            Verb::Arrange => "the arrangement",
            Verb::Gauss => "the map",
            Verb::Locate => "the answers",
            _ => "the mesh",
        };
        let sentence = format!("`-o -` and `--json` both want standard output; write {what} to a file");
        return Err(usage(verb, sentence));
    }
    check_surface(run)?;
    if given.contains(&"rotate") && given.contains(&"quat") {
        return Err(usage(verb, "`--rotate` and `--quat` exclude each other"));
    }
    if given.contains(&"path") && (given.contains(&"move-b") || given.contains(&"quat-b")) {
        let sentence = "`--path` has all placements, and excludes `--move-b` and `--quat-b`";
        return Err(usage(verb, sentence));
    }
    if run.strategy == Some(Strategy::Sweep) && run.ray.is_some() {
        let others: Vec<&str> =
            Strategy::ALL.into_iter().filter(|&other| other != Strategy::Sweep).map(Strategy::name).collect();
        let sentence = format!(
            "a sweep finds cells, not what a ray meets; give another strategy: {}",
            others.join(", ")
        );
        return Err(usage(verb, sentence));
    }
    Ok(())
}

/// Options that only one surface has.
fn check_surface(run: &Run) -> Result<(), Failure> {
    let wrong = |sentence: &str| Err(usage(run.verb, sentence));
    match run.surface {
        Some(Surface::Plane) if run.period.is_some() => {
            return wrong("`--surface plane` and `--period` exclude each other");
        }
        Some(Surface::Sphere) if run.period.is_some() => {
            return wrong("`--surface sphere` and `--period` exclude each other");
        }
        Some(Surface::Sphere) => {}
        _ if run.verb == Verb::Gauss && !run.cubical => {}
        _ if run.cubical && run.identification.is_some() => {
            return wrong("`--cubical` and `--identification` exclude each other: a cube is not cut open");
        }
        _ if run.cubical && run.view.is_some() => {
            return wrong("`--cubical` and `--view` exclude each other: the sides of a cube are unfolded");
        }
        _ if run.identification.is_some() => {
            return wrong("`--identification` is an option of the sphere; give --surface sphere, too");
        }
        _ if run.view.is_some() => {
            return wrong("`--view` is an option of the sphere; give --surface sphere, too");
        }
        _ => {}
    }
    let is_picture = run.output.is_some() && run.cell_encoding().format == CellFormat::Svg;
    if run.view.is_some() && !is_picture {
        return wrong("`--view` says how a picture looks, and none is written: -o OUT.svg");
    }
    Ok(())
}
