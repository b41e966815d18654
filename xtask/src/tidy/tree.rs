//! Gathers what the rules look at.

use std::path::Path;

use serde_json::Value;

use crate::{Failure, shell};

/// A tracked file that is text.
#[derive(Debug, Default)]
pub(super) struct Text {
    /// Path from the root of the repository.
    pub(super) path: String,
    pub(super) content: String,
}

/// A crate of the workspace, by its short name.
#[derive(Debug, Default)]
pub(super) struct Member {
    /// The name of its folder, which is also how it is called in code.
    pub(super) name: String,
    /// Path of its manifest from the root of the repository.
    pub(super) manifest: String,
    /// Crates of the workspace it depends on.
    pub(super) uses: Vec<String>,
    /// Other crates it depends on.
    pub(super) outside: Vec<String>,
    /// Crates it depends on for its tests only.
    pub(super) for_tests: Vec<String>,
    /// Whether its manifest takes the lints of the workspace.
    pub(super) takes_lints: bool,
    /// Its Rust files under `src`, without those of unit tests.
    pub(super) sources: Vec<Text>,
    /// Its Rust files that hold tests.
    pub(super) tests: Vec<Text>,
}

/// The repository as the rules see it.
#[derive(Debug, Default)]
pub(super) struct Tree {
    pub(super) architecture: String,
    pub(super) dependencies: String,
    pub(super) crates: Vec<Member>,
    /// The crates from outside that the manifest of the workspace names.
    pub(super) outside: Vec<String>,
    /// Every tracked file that is text.
    pub(super) texts: Vec<Text>,
}

/// Reads the repository that this program was built from.
///
/// # Errors
/// If `cargo` or `git` does not answer, or a document is missing.
pub(super) fn read() -> Result<Tree, Failure> {
    let root = shell::root();
    let mut tree = Tree::default();
    for path in tracked()? {
        // What is not text has no words: models/invalid has random bytes on purpose.
        if let Ok(content) = std::fs::read_to_string(root.join(&path)) {
            tree.texts.push(Text { path, content });
        }
    }
    let document = |name: &str| {
        let text = tree.texts.iter().find(|text| text.path == name);
        text.map(|text| text.content.clone()).ok_or_else(|| format!("{name} is missing"))
    };
    tree.architecture = document("ARCHITECTURE.md")?;
    tree.dependencies = document("docs/dependencies.md")?;
    tree.outside = outside(&document("Cargo.toml")?);
    tree.crates = members(&root, &tree.texts)?;
    Ok(tree)
}

/// Tracked files, and new ones that are not ignored.
fn tracked() -> Result<Vec<String>, Failure> {
    let arguments = ["ls-files", "-z", "--cached", "--others", "--exclude-standard"];
    let list = shell::output(shell::program("git").args(arguments))?;
    Ok(list.split('\0').filter(|path| !path.is_empty()).map(str::to_owned).collect())
}

fn members(root: &Path, texts: &[Text]) -> Result<Vec<Member>, Failure> {
    let arguments = ["metadata", "--no-deps", "--offline", "--format-version", "1"];
    let metadata: Value = serde_json::from_str(&shell::output(shell::cargo().args(arguments))?)?;
    let sources = texts.iter().filter(|text| text.path.ends_with(".rs"));
    let unit_tests: Vec<String> = sources.clone().flat_map(test_modules).collect();
    let mut members = Vec::new();
    for package in metadata["packages"].as_array().into_iter().flatten() {
        let manifest = package["manifest_path"].as_str().unwrap_or_default();
        let folder = Path::new(manifest).parent().unwrap_or(root);
        let inside = folder.strip_prefix(root)?.to_string_lossy().into_owned();
        let mut member = Member {
            name: file_name(folder),
            manifest: format!("{inside}/Cargo.toml"),
            takes_lints: std::fs::read_to_string(manifest)?.contains("[lints]\nworkspace = true"),
            ..Member::default()
        };
        for dependency in package["dependencies"].as_array().into_iter().flatten() {
            let ours = dependency["path"].as_str().map(|path| file_name(Path::new(path)));
            let name =
                ours.clone().unwrap_or_else(|| dependency["name"].as_str().unwrap_or_default().to_owned());
            match (dependency["kind"].as_str(), ours) {
                (Some("dev"), _) => member.for_tests.push(name),
                (_, Some(_)) => member.uses.push(name),
                (_, None) => member.outside.push(name),
            }
        }
        for text in sources.clone() {
            let Some(path) = text.path.strip_prefix(&format!("{inside}/")) else { continue };
            let copy = Text { path: text.path.clone(), content: text.content.clone() };
            let is_test = path.split('/').any(|part| part == "tests" || part == "tests.rs")
                || unit_tests.contains(&text.path);
            if is_test {
                member.tests.push(copy);
            } else if path.starts_with("src/") {
                member.sources.push(copy);
            }
        }
        members.push(member);
    }
    Ok(members)
}

/// The files that this source takes in with `#[cfg(test)] mod name;`.
fn test_modules(source: &Text) -> Vec<String> {
    let (folder, file) = source.path.rsplit_once('/').unwrap_or(("", &source.path));
    let inside = match file {
        "lib.rs" | "main.rs" | "mod.rs" => folder.to_owned(),
        _ => format!("{folder}/{}", file.trim_end_matches(".rs")),
    };
    let lines = source.content.lines().zip(source.content.lines().skip(1));
    lines
        .filter(|(mark, _)| mark.trim() == "#[cfg(test)]")
        .filter_map(|(_, module)| module.trim().strip_prefix("mod ")?.strip_suffix(';'))
        .map(|name| format!("{inside}/{name}.rs"))
        .collect()
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The names in `[workspace.dependencies]` that have no path.
fn outside(manifest: &str) -> Vec<String> {
    let section = manifest.lines().skip_while(|line| line.trim() != "[workspace.dependencies]").skip(1);
    section
        .take_while(|line| !line.starts_with('['))
        .filter(|line| !line.trim_start().starts_with('#') && !line.contains("path ="))
        .filter_map(|line| Some(line.split_once('=')?.0.trim().to_owned()))
        .collect()
}
