//! Files of curves: read, and put together.

use crate::args::{Place, Run, Surface};
use crate::console::Console;
use crate::failure::Failure;
use crate::input;
use splitstar::exact::Rational;
use splitstar::formats::{self, CurveFile, CurveNote, InputCurve, PlaceList, ReadError};
use splitstar::formats::{SphereCurve, SphereCurveFile};
use std::collections::BTreeSet;

/// A file of curves, with the name that messages give it.
pub(crate) struct CurveOperand<C> {
    pub(crate) name: String,
    pub(crate) curves: Vec<C>,
    places: PlaceList,
    notes: Vec<CurveNote>,
    period: Option<[Rational; 2]>,
}

/// A file of curves of the plane or of a torus.
pub(crate) type FlatOperand = CurveOperand<InputCurve>;

/// A file of curves on the sphere.
pub(crate) type SphereOperand = CurveOperand<SphereCurve>;

impl FlatOperand {
    /// Reads and parses a file or standard input.
    pub(crate) fn read(place: &Place, console: &Console) -> Result<Self, Failure> {
        let check: input::Check = |start, name| input::check_lines(start, formats::read_curves(start, name));
        let (name, file) = read(place, console, check, formats::read_curves)?;
        let CurveFile { curves, places, period, notes, .. } = file;
        Ok(Self { name, curves, places, notes, period })
    }
}

impl SphereOperand {
    /// Reads and parses a file or standard input.
    pub(crate) fn read(place: &Place, console: &Console) -> Result<Self, Failure> {
        let check: input::Check =
            |start, name| input::check_lines(start, formats::read_sphere_curves(start, name));
        let (name, file) = read(place, console, check, formats::read_sphere_curves)?;
        let SphereCurveFile { curves, places, notes, .. } = file;
        Ok(Self { name, curves, places, notes, period: None })
    }
}

fn read<F>(
    place: &Place,
    console: &Console,
    check: input::Check,
    read: fn(&[u8], Option<&str>) -> Result<F, ReadError>,
) -> Result<(String, F), Failure> {
    let bytes = input::bytes(place, console, check)?;
    let name = place.shown();
    let file = read(&bytes, place.file_name().as_deref()).map_err(|error| Failure::read(&name, &error))?;
    console.step_done();
    Ok((name, file))
}

impl<C> CurveOperand<C> {
    /// The failure of this file at one of its curves.
    pub(crate) fn failure(&self, curve: usize, sentence: impl Into<String>) -> Failure {
        Failure::file(&self.name, self.places.get(curve), sentence)
    }
}

/// Tells what the reader had to leave out, once for a file that is given several times.
pub(crate) fn tell_notes<C>(operands: &[CurveOperand<C>], console: &Console) {
    let mut told = BTreeSet::new();
    for CurveOperand { name, notes, .. } in operands {
        if told.insert(name) {
            notes.iter().for_each(|note| console.note(name, None, &note.to_string()));
        }
    }
}

/// Finds out what the curves of all files lie on: the torus of these periods, or the plane. The files and the command line must agree.
pub(crate) fn period(operands: &[FlatOperand], run: &Run) -> Result<Option<[Rational; 2]>, Failure> {
    let shown = |[p, q]: &[Rational; 2]| format!("period {p} {q}");
    let mut known = run.period.as_ref().map(|period| (period, "that of --period"));
    let mut first_name = String::new();
    for CurveOperand { name, period, .. } in operands {
        let Some(period) = period else { continue };
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
