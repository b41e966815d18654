//! What each reader said of each file, and the table of it.

use std::collections::BTreeMap;

/// What a reader said of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Cell {
    /// It was read, and says what it should.
    Passed,
    /// It was not tried, with the reason.
    Skipped(String),
    /// It was refused, or says something else.
    Failed(String),
}

/// One file and one reader.
#[derive(Debug, Clone)]
pub(super) struct Row {
    file: String,
    /// The line of the table: a format.
    line: String,
    /// The column of the table.
    reader: String,
    cell: Cell,
}

impl Row {
    pub(super) fn new(file: &str, line: &str, reader: &str, cell: Cell) -> Self {
        Self { file: file.to_owned(), line: line.to_owned(), reader: reader.to_owned(), cell }
    }

    /// The file, the reader and what is wrong, if something is.
    pub(super) fn failure(&self) -> Option<String> {
        match &self.cell {
            Cell::Failed(why) => Some(format!("{}: {}: {why}", self.file, self.reader)),
            _ => None,
        }
    }

    pub(super) fn is_skipped(&self) -> bool {
        matches!(self.cell, Cell::Skipped(_))
    }
}

/// Prints the table, one line for each format and one column for each reader, then why files were skipped.
pub(super) fn print(rows: &[Row]) {
    let lines = in_order(rows.iter().map(|row| row.line.as_str()));
    let readers = in_order(rows.iter().map(|row| row.reader.as_str()));
    let column = 19;
    let width = lines.iter().map(|line| line.len()).max().unwrap_or(0);
    println!(
        "\n{:width$}  {}",
        "",
        readers.iter().map(|name| format!("{name:>column$}")).collect::<String>()
    );
    for line in lines {
        let words = readers.iter().map(|reader| {
            let cells = rows.iter().filter(|row| row.line == line && row.reader == *reader);
            format!("{:>column$}", words(cells))
        });
        println!("{line:width$}  {}", words.collect::<String>());
    }
    let mut reasons: BTreeMap<&str, BTreeMap<&str, usize>> = BTreeMap::new();
    for row in rows {
        if let Cell::Skipped(why) = &row.cell {
            *reasons.entry(why).or_default().entry(&row.reader).or_default() += 1;
        }
    }
    for (why, readers) in reasons {
        let files: Vec<String> = readers.iter().map(|(reader, count)| format!("{reader} {count}")).collect();
        println!("skipped: {why} ({})", files.join(", "));
    }
}

fn words<'r>(rows: impl Iterator<Item = &'r Row>) -> String {
    let [mut passed, mut skipped, mut failed] = [0; 3];
    for row in rows {
        match row.cell {
            Cell::Passed => passed += 1,
            Cell::Skipped(_) => skipped += 1,
            Cell::Failed(_) => failed += 1,
        }
    }
    let named = [(passed, "ok"), (skipped, "skipped"), (failed, "FAILED")];
    let words: Vec<String> =
        named.iter().filter(|(count, _)| *count > 0).map(|(count, name)| format!("{count} {name}")).collect();
    if words.is_empty() { "-".to_owned() } else { words.join(", ") }
}

/// Without repetitions.
fn in_order<'r>(names: impl Iterator<Item = &'r str>) -> Vec<&'r str> {
    let mut found = Vec::new();
    for name in names {
        if !found.contains(&name) {
            found.push(name);
        }
    }
    found
}
