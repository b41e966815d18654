//! The project's own tasks, run as `cargo xtask VERB`.
//!
//! | verb | what it does |
//! |---|---|
//! | `ci` | what continuous integration runs: format, lints, tests, documentation, `tidy` |
//! | `tidy` | checks the tree against `ARCHITECTURE.md` and the rules for files |
//! | `tables` | counts and times the tables of the thesis on Minkowski sums again |
//! | `peers` | times the library and its peers on the same inputs, in one run |
//! | `readers` | other programs read our files, and we read theirs |
//! | `bench` | growth of time and memory with the size of the input, and with the width of the coordinates |
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program for the terminal")]

mod bench;
mod ci;
mod library;
mod peers;
mod python;
mod readers;
mod shell;
mod solids;
mod tables;
mod tidy;

use std::process::ExitCode;

/// What stops a task: one sentence for the terminal.
type Failure = Box<dyn std::error::Error>;

const USAGE: &str = "\
usage: cargo xtask VERB

  ci                                         everything that must pass before a change lands
  tidy                                       ARCHITECTURE.md against the tree
  tables [counts|times|search]               thesis tables 3.2 to 3.5: counted, printed, why they differ; times beside peers
  peers [--require] [--only PAIR] [--out F]  speed against CGAL, Manifold and SciPy; see peers/README.md
  peers arrangements [the same options]      speed of arrangements against CGAL and GEOS
  peers proximity [the same options]         speed and depths of moving polytopes against parry3d and coal
  readers [--require]                        files against trimesh, Manifold, assimp and others; see peers/README.md
  bench [growth|arrangements|editing|location|sphere|gauss|widths]
                                             growth of time and memory; widths of coordinates";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words.as_slice() {
        ["ci"] => ci::run(),
        ["tidy"] => tidy::run(),
        ["tables", rest @ ..] => tables::run(rest),
        ["peers", rest @ ..] => peers::run(rest),
        ["readers", rest @ ..] => readers::run(rest),
        // Asked by `readers`, in a release build.
        ["readers-time", path] => readers::time(path),
        ["bench", rest @ ..] => bench::run(rest),
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            ExitCode::FAILURE
        }
    }
}
