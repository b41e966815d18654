//! Files of curves: read, and put together.

use crate::args::{Place, Run, Surface};
use crate::console::Console;
use crate::failure::Failure;
use crate::input;
use splitstar::exact::Rational;
use splitstar::formats::{self, CurveFile};
use std::collections::BTreeSet;

/// A file of curves, with the name that messages give it.
pub(crate) struct CurveOperand {
    pub(crate) name: String,
    pub(crate) file: CurveFile,
}

impl CurveOperand {
    /// Reads and parses a file or standard input.
    pub(crate) fn read(place: &Place, console: &Console) -> Result<Self, Failure> {
        let bytes = input::bytes(place, console, check_start)?;
        let name = place.shown();
        let file = formats::read_curves(&bytes, place.file_name().as_deref())
            .map_err(|error| Failure::read(&name, &error))?;
        console.step_done();
        Ok(Self { name, file })
    }

    /// The failure of this file at one of its curves.
    pub(crate) fn failure(&self, curve: usize, sentence: impl Into<String>) -> Failure {
        Failure::file(&self.name, self.file.places.get(curve), sentence)
    }
}

/// Tells what the reader had to leave out, once for a file that is given several times.
pub(crate) fn tell_notes(operands: &[CurveOperand], console: &Console) {
    let mut told = BTreeSet::new();
    for CurveOperand { name, file } in operands {
        if told.insert(name) {
            file.notes.iter().for_each(|note| console.note(name, None, &note.to_string()));
        }
    }
}

/// Whether a stream whose first bytes are these may be a file of curves.
fn check_start(start: &[u8], file_name: Option<&str>) -> Result<(), formats::ReadError> {
    input::check_lines(start, formats::read_curves(start, file_name))
}

/// Finds out what the curves of all files lie on: the torus of these periods, or the plane. The files and the command line must agree.
pub(crate) fn period(operands: &[CurveOperand], run: &Run) -> Result<Option<[Rational; 2]>, Failure> {
    let shown = |[p, q]: &[Rational; 2]| format!("period {p} {q}");
    let mut known = run.period.as_ref().map(|period| (period, "that of --period"));
    let mut first_name = String::new();
    for CurveOperand { name, file } in operands {
        let Some(period) = &file.period else { continue };
        if run.surface == Some(Surface::Plane) {
            let sentence = format!(
                "it has curves of a torus (`{}`), and --surface is plane; leave out one of both",
                shown(period)
            );
            return Err(Failure::file(name, None, sentence));
        }
        match known {
            None => {
                first_name.clone_from(name);
                known = Some((period, ""));
            }
            Some((other, whose)) if other != period => {
                let whose =
                    if whose.is_empty() { format!("that of {first_name}") } else { whose.to_string() };
                let (this, other) = (shown(period), shown(other));
                let sentence = format!(
                    "its torus has `{this}`, {whose} has `{other}`; the curves of an arrangement lie on one torus"
                );
                return Err(Failure::file(name, None, sentence));
            }
            Some(_) => {}
        }
    }
    match known {
        Some((period, _)) => Ok(Some(period.clone())),
        None if run.surface == Some(Surface::Torus) => {
            let sentence = "a torus needs its periods; make `period P Q` the first record of the file, or give \
                            --period P,Q";
            Err(Failure::file(&operands[0].name, None, sentence))
        }
        None => Ok(None),
    }
}
