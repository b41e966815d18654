//! The command line of splitstar: exact computational geometry.
//!
//! Decides nothing geometric: it reads words and files, calls the library, writes files and reports.

// An application prints.
#![allow(clippy::print_stdout, clippy::print_stderr)]

mod approx;
mod args;
mod cells;
mod console;
mod curves;
mod explain;
mod failure;
mod help;
mod input;
mod located;
mod map;
mod output;
mod placed;
mod points;
mod report;
mod verbs;

use args::{Command, Verb};
use failure::Failure;
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if !matches!(failure, Failure::Closed) {
                // If nobody reads standard error there is nobody to tell.
                let _ = writeln!(std::io::stderr(), "error: {failure}");
            }
            failure.exit_code()
        }
    }
}

fn run() -> Result<(), Failure> {
    match args::parse(std::env::args_os().skip(1))? {
        Command::Help(verb) => output::report(help::text(verb)),
        Command::Version => output::report(help::VERSION),
        Command::Run(run) => {
            output::guard_against_interrupt();
            match run.verb {
                Verb::Sum => verbs::sum(&run),
                Verb::Hull => verbs::hull(&run),
                Verb::Info => verbs::info(&run),
                Verb::Convert => verbs::convert(&run),
                Verb::Distance => verbs::distance(&run),
                Verb::Arrange => verbs::arrange(&run),
                Verb::Locate => verbs::locate(&run),
                Verb::Gauss => verbs::gauss(&run),
            }
        }
    }
}
