//! Operands: read, parsed, and made polytopes.

use crate::args::Place;
use crate::console::Console;
use crate::failure::Failure;
use splitstar::formats::{ReadMesh, read_off};
use std::io::{self, Read};

/// A file that was read, with the name that messages give it.
pub(crate) struct Operand {
    pub(crate) name: String,
    pub(crate) read: ReadMesh,
}

impl Operand {
    /// Reads and parses a file or standard input.
    pub(crate) fn read(place: &Place, console: &Console) -> Result<Self, Failure> {
        let name = match place {
            Place::Standard => "-".to_string(),
            Place::File(path) => path.to_string_lossy().into_owned(),
        };
        console.step(&format!("reading {name}"));
        let bytes = match place {
            Place::Standard => {
                let mut bytes = Vec::new();
                io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
            }
            Place::File(path) => std::fs::read(path),
        }
        .map_err(|error| Failure::file(&name, None, cannot_read(&error)))?;
        let read = read_off(&bytes).map_err(|error| Failure::file(&name, error.line(), error.sentence()))?;
        console.step_done();
        Ok(Self { name, read })
    }

    /// The failure of this file at a line.
    pub(crate) fn failure(&self, line: Option<u32>, sentence: impl Into<String>) -> Failure {
        Failure::file(&self.name, line, sentence)
    }

    /// The line of a facet.
    pub(crate) fn facet_line(&self, facet: usize) -> Option<u32> {
        self.read.facet_lines.get(facet).copied()
    }

    /// The line of a vertex.
    pub(crate) fn vertex_line(&self, vertex: usize) -> Option<u32> {
        self.read.vertex_lines.get(vertex).copied()
    }
}

fn cannot_read(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file; check the name".into(),
        io::ErrorKind::IsADirectory => "is a directory; give the name of a file".into(),
        io::ErrorKind::PermissionDenied => "cannot be read: permission denied; change the permission".into(),
        _ => format!("cannot be read: {error}"),
    }
}
