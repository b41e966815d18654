//! `cargo xtask tidy`: the tree against `ARCHITECTURE.md`, and the rules for files.
//!
//! | file | role |
//! |---|---|
//! | `architecture` | reads the two tables of `ARCHITECTURE.md` |
//! | `source` | Rust text without comments, strings and unit tests; words and public signatures in it |
//! | `tree` | gathers crates, sources and tracked text from the disk |
//! | `checks` | the rules, as functions from the tree to problems |

mod architecture;
mod checks;
mod source;
#[cfg(test)]
mod tests;
mod tree;

use crate::Failure;

/// One thing that is wrong, and where.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Problem {
    /// Path from the root of the repository.
    path: String,
    /// Line, from 1; 0 where the file as a whole is meant.
    line: usize,
    what: String,
}

impl std::fmt::Display for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.line {
            0 => write!(f, "{}: {}", self.path, self.what),
            line => write!(f, "{}:{line}: {}", self.path, self.what),
        }
    }
}

/// Checks the repository and prints every problem.
///
/// # Errors
/// If there is a problem, or if the tree cannot be read.
pub(crate) fn run() -> Result<(), Failure> {
    let tree = tree::read()?;
    let problems = checks::all(&tree);
    for problem in &problems {
        println!("{problem}");
    }
    match problems.len() {
        0 => {
            let sources: usize = tree.crates.iter().map(|member| member.sources.len()).sum();
            println!("tidy: {} crates, {sources} sources, {} texts", tree.crates.len(), tree.texts.len());
            Ok(())
        }
        1 => Err("one rule is broken".into()),
        many => Err(format!("{many} rules are broken").into()),
    }
}
