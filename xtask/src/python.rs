//! Virtual environments with pinned packages, for programs in Python that results are compared with.

use std::fs;
use std::path::{Path, PathBuf};

use crate::{Failure, shell};

/// The Python of a virtual environment in `folder` that has at least the packages of `requirements`; both are named
/// from the root of the repository. What was installed before stays; when the pins change they are installed again.
///
/// # Errors
/// If there is no Python with the module `venv`, or no package index that has the packages.
pub(crate) fn environment(folder: &str, requirements: &str) -> Result<PathBuf, Failure> {
    let folder = shell::root().join(folder);
    let python = folder.join("bin/python");
    let pins = shell::root().join(requirements);
    let name = pins.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let (stamp, wanted) = (folder.join(format!("{name}.installed")), fs::read_to_string(&pins)?);
    if fs::read_to_string(&stamp).is_ok_and(|installed| installed == wanted) && python.exists() {
        return Ok(python);
    }
    println!("making the Python environment of {requirements} ...");
    if !python.exists() {
        shell::output(shell::program("python3").args(["-m", "venv"]).arg(&folder))?;
    }
    install(&python, &pins)?;
    fs::write(stamp, wanted)?;
    Ok(python)
}

fn install(python: &Path, pins: &Path) -> Result<(), Failure> {
    // An index that cannot be reached is given up soon.
    let words = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--retries", "1"];
    shell::output(shell::program(python).args(words).args(["--timeout", "20", "--requirement"]).arg(pins))?;
    Ok(())
}
