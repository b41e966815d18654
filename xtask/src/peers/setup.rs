//! Builds the CGAL drivers, makes the Python environment, writes the inputs. What cannot be had is reported, not fatal.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use super::pairs::{Method, Pair};
use crate::{Failure, python, shell};

/// What the CGAL drivers need.
pub(super) const CGAL_PACKAGES: &str =
    "on Debian: apt-get install libcgal-dev libgmp-dev libmpfr-dev libboost-dev cmake g++";
/// What the scripts in Python need.
pub(super) const PYTHON_PACKAGES: &str =
    "on Debian: apt-get install python3-venv, and access to a Python package index";

/// The peers that can run on this machine, and why the others cannot.
#[derive(Debug)]
pub(super) struct Tools {
    cgal: Result<PathBuf, String>,
    /// Nothing where no pair needs it.
    python: Option<Result<PathBuf, String>>,
}

impl Tools {
    /// One sentence for each group of peers that cannot run.
    pub(super) fn missing(&self) -> Vec<String> {
        let cgal = self.cgal.as_ref().err().map(|why| format!("CGAL ({why}); {CGAL_PACKAGES}"));
        let python = self
            .python
            .as_ref()
            .and_then(|python| python.as_ref().err())
            .map(|why| format!("Manifold and SciPy ({why}); {PYTHON_PACKAGES}"));
        cgal.into_iter().chain(python).collect()
    }

    /// The command that runs a method, up to its operands.
    pub(super) fn command(&self, method: Method) -> Option<Command> {
        let driver = |name: &str| self.cgal.as_ref().ok().map(|folder| shell::program(folder.join(name)));
        let script = |name: &str| {
            let mut command = shell::program(self.python.as_ref()?.as_ref().ok()?);
            command.arg(shell::root().join("peers/float/float_sums.py")).arg(name);
            Some(command)
        };
        match method {
            Method::Sgm => driver("sgm"),
            Method::Hull => driver("hull"),
            Method::Manifold => script("manifold"),
            Method::Scipy => script("scipy"),
            Method::OurSgm => None,
        }
    }
}

/// Makes the peers of those pairs ready, from what was made before where that is up to date.
pub(super) fn tools(pairs: &[&Pair]) -> Tools {
    let sentence = |failure: Failure| failure.to_string();
    let needs_python = pairs.iter().any(|pair| pair.methods.iter().any(|method| method.is_python()));
    Tools {
        cgal: cgal(&["sgm", "hull"]).map_err(sentence),
        python: needs_python.then(|| python().map_err(sentence)),
    }
}

/// Configures and builds those drivers with CMake, which sets the flags that CGAL's interval arithmetic needs; returns their
/// folder.
///
/// # Errors
/// If CMake, a compiler or CGAL is missing.
pub(super) fn cgal(drivers: &[&str]) -> Result<PathBuf, Failure> {
    let (source, build) = (shell::root().join("peers/cgal"), shell::root().join("peers/build"));
    println!("building the CGAL drivers ...");
    let mut configure = shell::program("cmake");
    configure.arg("-S").arg(source).arg("-B").arg(&build).arg("-DCMAKE_BUILD_TYPE=Release");
    shell::output(&mut configure)?;
    shell::output(shell::program("cmake").arg("--build").arg(&build).arg("--target").args(drivers))?;
    Ok(build)
}

fn python() -> Result<PathBuf, Failure> {
    python::environment("peers/venv", "peers/float/requirements.txt")
}

/// Writes the operands that are made by formula.
///
/// # Errors
/// If a file cannot be written.
pub(super) fn write_inputs(pairs: &[&Pair]) -> Result<(), Failure> {
    fs::create_dir_all(shell::root().join("peers/inputs"))?;
    for operand in pairs.iter().flat_map(|pair| [pair.a, pair.b]) {
        if let Some(solid) = operand.solid() {
            fs::write(operand.path(), solid.off())?;
        }
    }
    Ok(())
}
