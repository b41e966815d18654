//! Files of curves: read, and put together.

use crate::args::{Place, Run, Surface};
use crate::console::Console;
use crate::failure::Failure;
use crate::input;
use splitstar::exact::Rational;
use splitstar::formats::{self, CurveFile, CurvePoint, InputCurve};
use std::collections::BTreeSet;

/// A file of curves, with the name that messages give it.
pub(crate) struct CurveOperand {
    pub(crate) name: String,
    pub(crate) file: CurveFile,
}

/// How often the curves of all files together go around a torus at most: a short line may ask for any number of pieces.
const TURNS: i64 = 1 << 17;

/// What curves lie on.
pub(crate) enum Ground {
    Plane,
    /// The torus of these periods.
    Torus([Rational; 2]),
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

/// Whether a stream whose first bytes are these may be a file of curves: an error that comes before the last of their
/// lines is one of the whole file, which need not have an end.
fn check_start(start: &[u8], file_name: Option<&str>) -> Result<(), formats::ReadError> {
    let lines = start.iter().filter(|byte| **byte == b'\n').count() as u64;
    match formats::read_curves(start, file_name) {
        Err(error) => match error.place {
            Some(formats::Place::Line(line)) if u64::from(line) <= lines || start.contains(&0) => Err(error),
            _ => Ok(()),
        },
        Ok(_) => Ok(()),
    }
}

/// Finds out what the curves of all files lie on. The files and the command line must agree.
pub(crate) fn ground(operands: &[CurveOperand], run: &Run) -> Result<Ground, Failure> {
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
        Some((period, _)) => {
            check_torus(operands)?;
            check_turns(operands, period)?;
            Ok(Ground::Torus(period.clone()))
        }
        None if run.surface == Some(Surface::Torus) => {
            let sentence = "a torus needs its periods; make `period P Q` the first record of the file, or give \
                            --period P,Q";
            Err(Failure::file(&operands[0].name, None, sentence))
        }
        None => Ok(Ground::Plane),
    }
}

/// A file without `period` may have curves that a torus has not.
fn check_torus(operands: &[CurveOperand]) -> Result<(), Failure> {
    for operand in operands {
        for (place, curve) in operand.file.curves.iter().enumerate() {
            let what = match curve {
                InputCurve::Ray(_) => "ray",
                InputCurve::Line(_) => "line",
                _ => continue,
            };
            let sentence = format!("a {what} has no end on a torus; give a segment, or arrange in the plane");
            return Err(operand.failure(place, sentence));
        }
    }
    Ok(())
}

/// A curve that goes around a torus is cut there, into so many pieces. What all of them may be together is limited.
fn check_turns(operands: &[CurveOperand], period: &[Rational; 2]) -> Result<(), Failure> {
    let mut left = TURNS;
    for operand in operands {
        for (place, curve) in operand.file.curves.iter().enumerate() {
            let ends: &[CurvePoint] = match curve {
                InputCurve::Segment(ends) => ends,
                InputCurve::Polyline(points) => points,
                _ => continue,
            };
            for ends in ends.windows(2) {
                left =
                    turns(&ends[0], &ends[1], period).and_then(|turns| left.checked_sub(turns)).unwrap_or(-1);
                if left < 0 {
                    let sentence = format!(
                        "up to here the curves go around the torus more than {TURNS} times, and are cut there; \
                         give larger periods, or fewer or shorter curves"
                    );
                    return Err(operand.failure(place, sentence));
                }
            }
        }
    }
    Ok(())
}

/// How many whole periods there are between two points, in both directions together, if that is a small number.
fn turns(p: &CurvePoint, q: &CurvePoint, period: &[Rational; 2]) -> Option<i64> {
    let (p, q) = (p.coordinates(), q.coordinates());
    let along = |axis: usize| (&q[axis] - &p[axis]).abs().checked_div(&period[axis])?.floor().to_i64();
    along(0)?.checked_add(along(1)?)
}
