//! What `locate` reads: an arrangement with the numbers of its cells, and points.

use crate::args::Place;
use crate::console::Console;
use crate::failure::Failure;
use crate::input;
use splitstar::exact::Rational;
use splitstar::exact::spherical::Direction;
use splitstar::formats::{self, CellNumbers, CurveNote, CurvePoint, ReadError, StarArrangement};

/// An arrangement that was read.
pub(crate) struct ArrangementOperand {
    pub(crate) arrangement: StarArrangement,
    pub(crate) numbers: CellNumbers,
}

/// A file of points, with the name that messages give it.
pub(crate) struct PointOperand {
    pub(crate) name: String,
    pub(crate) points: Points,
    period: Option<[Rational; 2]>,
    notes: Vec<CurveNote>,
}

/// Points of the surface of an arrangement.
pub(crate) enum Points {
    /// Of the plane, or of the universal cover of a torus.
    Flat(Vec<CurvePoint>),
    Sphere(Vec<Direction>),
}

impl Points {
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Flat(points) => points.len(),
            Self::Sphere(points) => points.len(),
        }
    }
}

impl ArrangementOperand {
    /// Reads and checks a star file or standard input. `other` is the operand of the points: both may be exchanged.
    pub(crate) fn read(place: &Place, other: &Place, console: &Console) -> Result<Self, Failure> {
        let bytes = input::bytes(place, console, check_arrangement)?;
        let name = place.shown();
        let read = formats::read_numbered_arrangement(&bytes, place.file_name().as_deref());
        let (arrangement, numbers) = read.map_err(|error| {
            if let Some(sentence) = advice_for_points(&bytes, &name, other) {
                return Failure::file(&name, None, sentence);
            }
            if let Some(options) = input::options_for_curves(&bytes) {
                let sentence = format!(
                    "a file of curves, not an arrangement; `splitstar arrange {name}{options} -o OUT.star` makes one"
                );
                return Failure::file(&name, None, sentence);
            }
            Failure::read(&name, &error)
        })?;
        console.step_done();
        Ok(Self { arrangement, numbers })
    }

    fn is_on_sphere(&self) -> bool {
        matches!(self.arrangement, StarArrangement::Sphere(_) | StarArrangement::SpherePolycurves(_))
    }

    /// The periods, if it lies on a torus.
    fn period(&self) -> Option<&[Rational; 2]> {
        match &self.arrangement {
            StarArrangement::Torus(arrangement) => Some(arrangement.traits().period()),
            StarArrangement::TorusPolycurves(arrangement) => Some(arrangement.traits().inner().period()),
            _ => None,
        }
    }
}

impl PointOperand {
    /// Reads and parses a file or standard input, as points of the surface of an arrangement.
    pub(crate) fn read(place: &Place, of: &ArrangementOperand, console: &Console) -> Result<Self, Failure> {
        let (name, file_name) = (place.shown(), place.file_name());
        let failed = |error: ReadError| Failure::read(&name, &error);
        let (points, period, notes) = if of.is_on_sphere() {
            let bytes = input::bytes(place, console, check_sphere_points)?;
            let file = formats::read_sphere_points(&bytes, file_name.as_deref()).map_err(failed)?;
            (Points::Sphere(file.points), None, file.notes)
        } else {
            let bytes = input::bytes(place, console, check_points)?;
            let file = formats::read_points(&bytes, file_name.as_deref()).map_err(failed)?;
            (Points::Flat(file.points), file.period, file.notes)
        };
        console.step_done();
        Ok(Self { name, points, period, notes })
    }

    /// Tells what the reader had to leave out.
    pub(crate) fn tell_notes(&self, console: &Console) {
        self.notes.iter().for_each(|note| console.note(&self.name, None, &note.to_string()));
    }

    /// Refuses points of another torus than that of the arrangement, if they say of which they are.
    pub(crate) fn check_period(&self, operand: &ArrangementOperand) -> Result<(), Failure> {
        let Some(period) = &self.period else { return Ok(()) };
        let shown = |[p, q]: &[Rational; 2]| format!("`period {p} {q}`");
        let sentence = match operand.period() {
            Some(other) if other == period => return Ok(()),
            Some(other) => format!(
                "its torus has {}, that of the arrangement has {}; make them one, or leave the record out",
                shown(period),
                shown(other)
            ),
            None => format!(
                "it has points of a torus ({}), and the arrangement lies in the plane; leave the record out",
                shown(period)
            ),
        };
        Err(Failure::file(&self.name, None, sentence))
    }
}

/// What is said where an arrangement was expected, if the file has points to be asked about.
fn advice_for_points(bytes: &[u8], name: &str, other: &Place) -> Option<String> {
    let is_of_points = formats::read_points(bytes, None).is_ok_and(|file| !file.points.is_empty())
        || formats::read_sphere_points(bytes, None).is_ok_and(|file| !file.points.is_empty());
    if !is_of_points {
        return None;
    }
    // Standard input is not waited for.
    let first = match other {
        Place::File(path) if !matches!(path.metadata(), Ok(of) if of.is_file()) => None,
        Place::File(path) => std::fs::read(path).ok(),
        Place::Standard => None,
    };
    Some(match first.filter(|first| formats::read_arrangement(first, None).is_ok()) {
        Some(_) => {
            let other = other.shown();
            format!("a file of points, not an arrangement; exchange both: `splitstar locate {other} {name}`")
        }
        None => "a file of points, not an arrangement; give a star file, as `splitstar arrange CURVES -o OUT.star` writes it, \
                 and behind it the points"
            .into(),
    })
}

fn check_arrangement(start: &[u8], file_name: Option<&str>) -> Result<(), ReadError> {
    input::check_lines(start, formats::read_arrangement(start, file_name))
}

fn check_points(start: &[u8], file_name: Option<&str>) -> Result<(), ReadError> {
    input::check_lines(start, formats::read_points(start, file_name))
}

fn check_sphere_points(start: &[u8], file_name: Option<&str>) -> Result<(), ReadError> {
    input::check_lines(start, formats::read_sphere_points(start, file_name))
}
