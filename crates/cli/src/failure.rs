//! How a command ends when it does not succeed.

use splitstar::formats::{Place, ReadError};
use std::fmt;
use std::process::ExitCode;

/// Why a command stopped. One line on standard error, and an exit code.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The command line is wrong. Exit code 2.
    Usage(String),
    /// A file is wrong, or something could not be done with it. Exit code 1.
    File { file: String, place: Option<Place>, sentence: String },
    /// The reader of a report went away: nothing to say, nothing lost.
    Closed,
}

impl Failure {
    pub(crate) fn usage(sentence: impl Into<String>) -> Self {
        Self::Usage(sentence.into())
    }

    pub(crate) fn file(file: &str, place: Option<Place>, sentence: impl Into<String>) -> Self {
        Self::File { file: file.into(), place, sentence: sentence.into() }
    }

    pub(crate) fn read(file: &str, error: &ReadError) -> Self {
        Self::file(&part_name(file, error.part.as_deref()), error.place, error.sentence())
    }

    pub(crate) fn exit_code(&self) -> ExitCode {
        match self {
            Self::Usage(_) => ExitCode::from(2),
            Self::File { .. } => ExitCode::from(1),
            Self::Closed => ExitCode::SUCCESS,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage(sentence) => write!(f, "{}", one_line(sentence)),
            Self::File { file, place, sentence } => {
                write!(f, "{} {}", located(file, *place), one_line(sentence))
            }
            Self::Closed => Ok(()),
        }
    }
}

/// A file with a place in it, as messages begin: `cube.off:7:`, `cube.stl: byte 84:`.
pub(crate) fn located(file: &str, place: Option<Place>) -> String {
    let file = one_line(file);
    match place {
        None => format!("{file}:"),
        Some(Place::Line(line)) => format!("{file}:{line}:"),
        Some(Place::Byte(byte)) => format!("{file}: byte {byte}:"),
    }
}

/// A file, or a file within an archive.
pub(crate) fn part_name(file: &str, part: Option<&str>) -> String {
    match part {
        None => file.to_string(),
        Some(part) => format!("{file}({part})"),
    }
}

/// A file's name may have any character; a message is one line.
pub(crate) fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { '\u{FFFD}' } else { c }).collect()
}
