//! Where the repository is, and how other programs are run.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::Failure;

/// The root of the repository: the parent of this crate.
pub(crate) fn root() -> PathBuf {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
    manifest.parent().expect("the crate stands in a folder of the repository").to_path_buf()
}

/// The cargo that started this program, or the one on the path.
pub(crate) fn cargo() -> Command {
    program(std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo")))
}

/// A command that starts in the root of the repository.
pub(crate) fn program(name: impl AsRef<std::ffi::OsStr>) -> Command {
    let mut command = Command::new(name);
    command.current_dir(root());
    command
}

/// The command as a line that can be typed, with the program's folder and the repository's left out.
pub(crate) fn shown(command: &Command) -> String {
    let root = format!("{}/", root().display());
    let program = Path::new(command.get_program());
    let mut words: Vec<String> = command
        .get_envs()
        .filter_map(|(name, value)| {
            Some(format!("{}={}", name.to_string_lossy(), value?.to_string_lossy().replace(&root, "")))
        })
        .collect();
    let name = program.to_string_lossy();
    words.push(match name.strip_prefix(&root) {
        Some(inside) => inside.to_owned(),
        None => program.file_name().unwrap_or_default().to_string_lossy().into_owned(),
    });
    words.extend(command.get_args().map(|word| word.to_string_lossy().replace(&root, "")));
    words.join(" ")
}

/// Prints the command and runs it with this terminal as its input and output.
///
/// # Errors
/// If the program cannot be started or does not succeed.
pub(crate) fn run(command: &mut Command) -> Result<(), Failure> {
    let line = shown(command);
    println!("$ {line}");
    let status = command.status().map_err(|error| format!("cannot start `{line}`: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("`{line}` failed ({status})").into()) }
}

/// Runs the command quietly and returns what it wrote to standard output.
///
/// # Errors
/// If the program cannot be started or does not succeed; then with the last line of its standard error.
pub(crate) fn output(command: &mut Command) -> Result<String, Failure> {
    let line = shown(command);
    let result =
        command.stdin(Stdio::null()).output().map_err(|error| format!("cannot start `{line}`: {error}"))?;
    if !result.status.success() {
        let complaint = String::from_utf8_lossy(&result.stderr);
        let last = complaint.lines().rfind(|line| !line.trim().is_empty()).unwrap_or("no message").to_owned();
        return Err(format!("`{line}` failed ({}): {last}", result.status).into());
    }
    Ok(String::from_utf8(result.stdout)?)
}
