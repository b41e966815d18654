//! The rules. Each is a function from the tree to the problems it finds.

use super::Problem;
use super::architecture::{self, Architecture, CrateRow};
use super::source;
use super::tree::{Member, Text, Tree};

/// Above this many lines of code a file says at its top why it is long.
const LONG: usize = 400;
/// Above this many it is split.
const TOO_LONG: usize = 800;
/// Above this many lines unit tests move to a file of their own.
const LONG_TESTS: usize = 200;
/// The pattern of the table that stands for a rule of its own: no float in a public signature.
const PUBLIC_FLOAT: &str = "pub f64";

/// Every problem, by path and line.
pub(super) fn all(tree: &Tree) -> Vec<Problem> {
    let mut problems = Vec::new();
    match architecture::parse(&tree.architecture) {
        Ok(architecture) => {
            order(tree, &architecture, &mut problems);
            absences(tree, &architecture, &mut problems);
        }
        Err((line, what)) => problems.push(in_architecture(line, what)),
    }
    for member in &tree.crates {
        manifest(tree, member, &mut problems);
        lengths(member, &mut problems);
    }
    reasons(tree, &mut problems);
    for text in &tree.texts {
        machine_paths(text, &mut problems);
    }
    problems.sort();
    problems
}

fn in_architecture(line: usize, what: String) -> Problem {
    Problem { path: "ARCHITECTURE.md".to_owned(), line, what }
}

/// The table lists every crate, says truly what each uses, and each uses only rows above its own.
fn order(tree: &Tree, architecture: &Architecture, problems: &mut Vec<Problem>) {
    for member in &tree.crates {
        if !architecture.crates.iter().any(|row| row.name == member.name) {
            problems.push(in_architecture(0, format!("no row for the crate `{}`", member.name)));
        }
    }
    for (place, row) in architecture.crates.iter().enumerate() {
        let mut say = |what: String| problems.push(in_architecture(row.line, what));
        let Some(member) = tree.crates.iter().find(|member| member.name == row.name) else {
            say(format!("there is no crate `{}`", row.name));
            continue;
        };
        let above = &architecture.crates[..place];
        for used in &row.uses {
            if !above.iter().any(|lower| lower.name == *used) {
                say(format!("`{}` uses `{used}`, which does not stand above it", row.name));
            }
        }
        for (column, said, is) in
            [("uses", &row.uses, &member.uses), ("from outside", &row.outside, &member.outside)]
        {
            for name in is.iter().filter(|name| !said.contains(name)) {
                say(format!(
                    "{} depends on `{name}`, which is not in column *{column}* of `{}`",
                    member.manifest, row.name
                ));
            }
            for name in said.iter().filter(|name| !is.contains(name)) {
                say(format!(
                    "column *{column}* of `{}` names `{name}`, but {} does not",
                    row.name, member.manifest
                ));
            }
        }
    }
}

/// What the tables call absent does not occur in the sources.
fn absences(tree: &Tree, architecture: &Architecture, problems: &mut Vec<Problem>) {
    for row in &architecture.crates {
        let Some(member) = tree.crates.iter().find(|member| member.name == row.name) else { continue };
        let patterns = patterns(architecture, row);
        for text in &member.sources {
            let code = source::code(&text.content);
            for pattern in &patterns {
                let lines = match *pattern {
                    PUBLIC_FLOAT => source::float_signatures(&code),
                    words => source::lines_with(&code, words),
                };
                let forbidden = lines.into_iter().filter(|&line| !is_allowed(&text.content, line, pattern));
                problems.extend(forbidden.map(|line| Problem {
                    path: text.path.clone(),
                    line,
                    what: format!("`{pattern}` is absent from `{}` by ARCHITECTURE.md", row.name),
                }));
            }
        }
    }
}

/// What is absent from the crate of that row, by either table.
fn patterns<'a>(architecture: &'a Architecture, row: &'a CrateRow) -> Vec<&'a str> {
    let sets = architecture.sets.iter().filter(|set| set.covers(row)).flat_map(|set| &set.absent);
    row.absent.iter().chain(sets).map(String::as_str).collect()
}

/// Whether that line or the one above it says `// tidy: PATTERN, because ...`.
fn is_allowed(text: &str, line: usize, pattern: &str) -> bool {
    let excuse = format!("// tidy: {pattern}, because ");
    text.lines().skip(line.saturating_sub(2)).take(2).any(|near| near.contains(&excuse))
}

/// Lints of the workspace; tests depend on `testkit`, on what the crate itself uses (with other features), on the crate itself,
/// and on crates from outside that the workspace names.
fn manifest(tree: &Tree, member: &Member, problems: &mut Vec<Problem>) {
    let mut say = |what: String| problems.push(Problem { path: member.manifest.clone(), line: 0, what });
    if !member.takes_lints {
        say("`[lints]` with `workspace = true` is missing".to_owned());
    }
    let known = |name: &String| {
        name == "testkit" || *name == member.name || member.uses.contains(name) || tree.outside.contains(name)
    };
    for name in member.for_tests.iter().filter(|name| !known(name)) {
        say(format!(
            "`{name}` is a dependency of the tests: only `testkit`, and what the crate uses, may be"
        ));
    }
}

/// Files are short, or say why not; tests may be tables, and only the upper limit holds for them.
fn lengths(member: &Member, problems: &mut Vec<Problem>) {
    for (text, limit) in
        member.sources.iter().map(|text| (text, LONG)).chain(member.tests.iter().map(|text| (text, TOO_LONG)))
    {
        let mut say = |what: String| problems.push(Problem { path: text.path.clone(), line: 0, what });
        let code = source::code(&text.content);
        let lines = source::code_lines(&code);
        if lines > TOO_LONG {
            say(format!("{lines} lines of code: split it above {TOO_LONG}"));
        } else if lines > limit && !text.content.lines().any(|line| line.starts_with("//! Long: ")) {
            say(format!("{lines} lines of code: above {LONG} a line `//! Long: reason` at the top says why"));
        }
        let marked = text.content.lines().position(|line| line.trim() == "#[cfg(test)]");
        let is_inline =
            |start: &usize| text.content.lines().nth(start + 1).is_some_and(|line| line.ends_with('{'));
        if let Some(start) = marked.filter(is_inline) {
            let tests = text.content.lines().count() - start;
            if tests > LONG_TESTS {
                say(format!(
                    "{tests} lines of unit tests: above {LONG_TESTS} they move to a file `tests.rs`"
                ));
            }
        }
    }
}

/// Every dependency from outside has a row with its reason.
fn reasons(tree: &Tree, problems: &mut Vec<Problem>) {
    let listed: Vec<&str> =
        tree.dependencies.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next()).collect();
    let mut say =
        |what: String| problems.push(Problem { path: "docs/dependencies.md".to_owned(), line: 0, what });
    for name in tree.outside.iter().filter(|name| !listed.contains(&name.as_str())) {
        say(format!("no row for the dependency `{name}`"));
    }
    for name in listed.iter().filter(|name| !tree.outside.iter().any(|used| used == *name)) {
        say(format!("`{name}` is not a dependency of the workspace"));
    }
}

/// No text names a folder of one machine.
fn machine_paths(text: &Text, problems: &mut Vec<Problem>) {
    // In two parts, so that this file does not name them itself.
    const FOLDERS: [(&str, &str); 6] =
        [("/wo", "rk/"), ("/ho", "me/"), ("/ro", "ot/"), ("/tm", "p/"), ("/Use", "rs/"), ("C:", "\\")];
    for (index, line) in text.content.lines().enumerate() {
        for (start, end) in FOLDERS {
            let folder = format!("{start}{end}");
            let found = line
                .match_indices(&folder)
                .any(|(at, _)| !line[..at].ends_with(|c: char| c.is_alphanumeric() || "._-}*".contains(c)));
            if found {
                let what = format!("`{folder}` is a folder of one machine");
                problems.push(Problem { path: text.path.clone(), line: index + 1, what });
            }
        }
    }
}
