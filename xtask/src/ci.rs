//! `cargo xtask ci`: everything that must pass before a change lands.

use std::path::Path;
use std::process::Command;
use std::time::Instant;

use crate::readers::{self, Demand};
use crate::{Failure, shell, tidy};

/// The features of `exact` that only tests use: without this step their code would not be looked at.
const TEST_FEATURES: [&str; 4] = ["--package", "splitstar-exact", "--features", "force-tiers,count-tiers"];

/// The program and the library in front, by themselves: in a build of the whole workspace the features that tests switch
/// on hold for every crate, and what ships is not built.
const SHIPPED: [&str; 4] = ["--package", "splitstar-cli", "--package", "splitstar"];

/// Without threads. Its tests would switch the features on again, so this is for the library.
const SERIAL: [&str; 3] = ["--package", "splitstar-polytope", "--no-default-features"];

/// Runs every step in order and stops at the first that fails.
///
/// # Errors
/// The step that failed.
pub(crate) fn run() -> Result<(), Failure> {
    let start = Instant::now();
    let mut passed = 0;
    let mut step = |name: &str, action: &mut dyn FnMut() -> Result<(), Failure>| -> Result<(), Failure> {
        println!("\n== {name}");
        let begin = Instant::now();
        action().map_err(|failure| format!("{name}: {failure}"))?;
        println!("== {name}: passed in {:.0} s", begin.elapsed().as_secs_f64());
        passed += 1;
        Ok(())
    };

    step("format", &mut || shell::run(shell::cargo().args(["fmt", "--all", "--check"])))?;
    step("tidy", &mut tidy::run)?;
    step("lints", &mut || shell::run(&mut clippy(&["--workspace"], "--all-targets")))?;
    step("lints, with the test features", &mut || shell::run(&mut clippy(&TEST_FEATURES, "--all-targets")))?;
    step("tests", &mut || shell::run(shell::cargo().args(["test", "--workspace"])))?;
    step("tests, with the test features", &mut || {
        shell::run(shell::cargo().arg("test").args(TEST_FEATURES))
    })?;
    step("tests of what ships", &mut || shell::run(shell::cargo().arg("test").args(SHIPPED)))?;
    step("lints, without the default features", &mut || shell::run(&mut clippy(&SERIAL, "--lib")))?;
    step("documentation", &mut || {
        shell::run(shell::cargo().env("RUSTDOCFLAGS", "-Dwarnings").args(["doc", "--workspace", "--no-deps"]))
    })?;
    step("wasm32", &mut wasm32)?;
    step("other readers", &mut other_readers)?;

    println!("\nall {passed} steps passed in {:.0} s", start.elapsed().as_secs_f64());
    Ok(())
}

fn clippy(selection: &[&str], targets: &str) -> Command {
    let mut command = shell::cargo();
    command.arg("clippy").args(selection).args([targets, "--", "-Dwarnings"]);
    command
}

/// Other programs read our files. In continuous integration they must be there; elsewhere they are skipped where they
/// cannot be installed.
fn other_readers() -> Result<(), Failure> {
    let required = std::env::var_os("CI").is_some_and(|value| !value.is_empty());
    readers::check(if required { Demand::Packages } else { Demand::Rough })
}

/// Checks the libraries for a target without files and threads, where that target is installed.
fn wasm32() -> Result<(), Failure> {
    const TARGET: &str = "wasm32-unknown-unknown";
    let sysroot = shell::output(shell::program("rustc").args(["--print", "sysroot"]))?;
    if !Path::new(sysroot.trim()).join("lib/rustlib").join(TARGET).is_dir() {
        println!("skipped: the target {TARGET} is not installed (`rustup target add {TARGET}`)");
        return Ok(());
    }
    shell::run(shell::cargo().args(["check", "--package", "splitstar", "--target", TARGET]))
}
