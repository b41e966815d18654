//! The program as its users see it: words in; exit code, streams and files out.

// A test fails by panicking, in its helpers too.
#![allow(clippy::unwrap_used)]

mod arrange;
mod convert;
mod damaged;
mod defects;
mod distance;
mod encode;
mod formats;
mod gauss;
mod invalid;
mod locate;
#[cfg(target_os = "linux")]
mod memory;
mod pictures;
mod results;
mod sphere;
mod streams;
mod usage;

use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What a run left behind.
struct Run {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

impl Run {
    /// Expects success, and gives standard output.
    #[track_caller]
    fn ok(self) -> String {
        assert_eq!(self.code, Some(0), "{}", self.stderr);
        self.stdout
    }

    /// Expects success, and gives the JSON object.
    #[track_caller]
    fn json(self) -> serde_json::Value {
        let text = self.ok();
        assert_eq!(text.lines().count(), 1, "{text}");
        serde_json::from_str(&text).unwrap()
    }

    /// Expects an exit code and one line on standard error, and gives that line.
    #[track_caller]
    fn error(self, code: i32) -> String {
        assert_eq!(self.code, Some(code), "{}", self.stderr);
        assert_eq!(self.stderr.lines().count(), 1, "{}", self.stderr);
        assert!(self.stderr.starts_with("error: "), "{}", self.stderr);
        assert_eq!(self.stdout, "");
        self.stderr.trim_end().to_string()
    }

    fn notes(&self) -> Vec<&str> {
        self.stderr.lines().filter(|line| line.starts_with("note: ")).collect()
    }
}

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_splitstar"))
}

fn finish(mut command: Command, input: &[u8]) -> Run {
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    // A program that stops at a usage error does not read its input.
    let _ = child.stdin.take().unwrap().write_all(input);
    let output = child.wait_with_output().unwrap();
    Run {
        code: output.status.code(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

fn run<W: AsRef<OsStr>>(words: &[W]) -> Run {
    run_with(words, b"")
}

fn run_with<W: AsRef<OsStr>>(words: &[W], input: &[u8]) -> Run {
    let mut command = program();
    command.args(words);
    finish(command, input)
}

/// The path of a model.
fn model(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models").join(name);
    fs::canonicalize(&path).unwrap_or_else(|_| panic!("{} is missing", path.display())).display().to_string()
}

/// An empty folder of a test's own.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
        if path.exists() {
            fs::remove_dir_all(&path).unwrap();
        }
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn path(&self, name: &str) -> String {
        self.0.join(name).display().to_string()
    }

    fn write(&self, name: &str, text: &str) -> String {
        fs::write(self.0.join(name), text).unwrap();
        self.path(name)
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap()
    }

    /// The names in the folder, hidden ones too.
    fn names(&self) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(&self.0)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }
}

/// Vertices, edges and facets of a JSON object.
fn counts(object: &serde_json::Value) -> [u64; 3] {
    ["vertices", "edges", "facets"].map(|key| object[key].as_u64().unwrap())
}
