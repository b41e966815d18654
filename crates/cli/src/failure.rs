//! How a command ends when it does not succeed.

use std::fmt;
use std::process::ExitCode;

/// Why a command stopped. One line on standard error, and an exit code.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The command line is wrong. Exit code 2.
    Usage(String),
    /// A file is wrong, or something could not be done with it. Exit code 1.
    File { file: String, line: Option<u32>, sentence: String },
    /// The reader of a report went away: nothing to say, nothing lost.
    Closed,
}

impl Failure {
    pub(crate) fn usage(sentence: impl Into<String>) -> Self {
        Self::Usage(sentence.into())
    }

    pub(crate) fn file(file: &str, line: Option<u32>, sentence: impl Into<String>) -> Self {
        Self::File { file: file.into(), line, sentence: sentence.into() }
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
            Self::File { file, line: Some(line), sentence } => {
                write!(f, "{}:{line}: {}", one_line(file), one_line(sentence))
            }
            Self::File { file, line: None, sentence } => {
                write!(f, "{}: {}", one_line(file), one_line(sentence))
            }
            Self::Closed => Ok(()),
        }
    }
}

/// A file's name may have any character; a message is one line.
pub(crate) fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { '\u{FFFD}' } else { c }).collect()
}
