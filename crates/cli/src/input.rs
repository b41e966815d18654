//! Operands: read, parsed, and made polytopes.

use crate::args::Place;
use crate::console::Console;
use crate::failure::{Failure, part_name};
use splitstar::formats::{self, Complex, Fault, ReadError, ReadModel, Shape};
use splitstar::polytope::PolygonMesh;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// A file that was read, with the name that messages give it.
pub(crate) struct Operand {
    pub(crate) name: String,
    pub(crate) read: ReadModel,
}

/// What is read of a stream before it is known whether to read on.
const START: u64 = 1 << 16;

impl Operand {
    /// Reads and parses a file or standard input.
    pub(crate) fn read(place: &Place, console: &Console) -> Result<Self, Failure> {
        let bytes = bytes(place, console, formats::check_start)?;
        let name = place.shown();
        let read = formats::read(&bytes, place.file_name().as_deref()).map_err(|error| {
            if let Some(options) = options_for_curves(&bytes) {
                let sentence =
                    format!("a file of curves, not a model; `splitstar arrange {name}{options}` reads it");
                return Failure::file(&name, None, sentence);
            }
            Failure::read(&name, &error)
        })?;
        console.step_done();
        let name = part_name(&name, read.places.part.as_deref());
        Ok(Self { name, read })
    }

    /// Tells what the reader had to leave out.
    pub(crate) fn tell_notes(&self, console: &Console) {
        for note in &self.read.notes {
            console.note(&self.name, None, &note.to_string());
        }
    }

    /// The failure of this file at a place.
    pub(crate) fn failure(&self, place: Option<formats::Place>, sentence: impl Into<String>) -> Failure {
        Failure::file(&self.name, place, sentence)
    }

    /// The place of a facet.
    pub(crate) fn facet_place(&self, facet: usize) -> Option<formats::Place> {
        self.read.places.facets.get(facet)
    }

    /// The place of a vertex.
    pub(crate) fn vertex_place(&self, vertex: usize) -> Option<formats::Place> {
        self.read.places.vertices.get(vertex)
    }

    /// The mesh; a complex of cells is refused, and named what makes it one.
    pub(crate) fn mesh(&self) -> Result<&PolygonMesh, Failure> {
        match &self.read.model.shape {
            Shape::Mesh(mesh) => Ok(mesh),
            Shape::Complex(complex) => Err(self.failure(None, no_mesh(complex, &self.name))),
        }
    }
}

/// With which options `arrange` reads a file that is none of a model, if it is one of curves without a mistake.
pub(crate) fn options_for_curves(bytes: &[u8]) -> Option<&'static str> {
    if formats::read_curves(bytes, None).is_ok_and(|file| !file.curves.is_empty() || file.period.is_some()) {
        return Some("");
    }
    let is_of_sphere = formats::read_sphere_curves(bytes, None).is_ok_and(|file| !file.curves.is_empty());
    is_of_sphere.then_some(" --surface sphere")
}

fn no_mesh(complex: &Complex, name: &str) -> String {
    let losses = complex.as_mesh().err().unwrap_or_default();
    let losses: Vec<String> = losses.iter().map(ToString::to_string).collect();
    format!(
        "a closed polytope is needed, and the file has {}; `splitstar convert {} -o OUT.off --lossy` writes its regular part, if it has one",
        losses.join(", and "),
        name
    )
}

/// Tells whether the first bytes of a stream, with the name of the file if it has one, may be those of a file.
pub(crate) type Check = fn(&[u8], Option<&str>) -> Result<(), ReadError>;

/// Whether a stream may be a text of which this was read from the first bytes: an error that comes before the last of their lines is
/// one of the whole text, which need not have an end. That the text ends is none.
pub(crate) fn check_lines<F>(start: &[u8], read: Result<F, ReadError>) -> Result<(), ReadError> {
    let Err(error) = read else { return Ok(()) };
    let lines = start.iter().filter(|byte| **byte == b'\n').count() as u64;
    match error.place {
        _ if matches!(error.fault, Fault::Truncated { .. }) && !start.contains(&0) => Ok(()),
        Some(formats::Place::Line(line)) if u64::from(line) <= lines || start.contains(&0) => Err(error),
        _ => Ok(()),
    }
}

/// Begins the step of reading, and reads a file or standard input.
pub(crate) fn bytes(place: &Place, console: &Console, check: Check) -> Result<Vec<u8>, Failure> {
    let name = place.shown();
    console.step(&format!("reading {name}"));
    match place {
        Place::Standard => read_stream(&mut io::stdin().lock(), place, check),
        Place::File(path) => read_file(path, place, check),
    }
}

/// A file whose size is known is read whole; a pipe or a device like a stream.
fn read_file(path: &Path, place: &Place, check: Check) -> Result<Vec<u8>, Failure> {
    let name = &place.shown();
    let failed = |error: io::Error| Failure::file(name, None, cannot_read(&error));
    let mut file = File::open(path).map_err(failed)?;
    let metadata = file.metadata().map_err(failed)?;
    if !metadata.is_file() {
        return read_stream(&mut file, place, check);
    }
    // One byte more than there should be: the last read finds the end without making room.
    let mut bytes = Vec::with_capacity(usize::try_from(metadata.len()).unwrap_or(0).saturating_add(1));
    file.read_to_end(&mut bytes).map_err(failed)?;
    Ok(bytes)
}

/// A stream may have no end: it is read on only if its start may be a file.
fn read_stream(stream: &mut impl Read, place: &Place, check: Check) -> Result<Vec<u8>, Failure> {
    let name = &place.shown();
    let failed = |error: io::Error| Failure::file(name, None, cannot_read(&error));
    let mut bytes = Vec::new();
    stream.by_ref().take(START).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 == START {
        check(&bytes, place.file_name().as_deref()).map_err(|error| Failure::read(name, &error))?;
        stream.read_to_end(&mut bytes).map_err(failed)?;
    }
    Ok(bytes)
}

fn cannot_read(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file; check the name".into(),
        io::ErrorKind::IsADirectory => "is a directory; give the name of a file".into(),
        io::ErrorKind::PermissionDenied => "cannot be read: permission denied; change the permission".into(),
        _ => format!("cannot be read: {error}"),
    }
}
