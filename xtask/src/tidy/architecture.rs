//! The two tables of `ARCHITECTURE.md` that are checked.
//!
//! *Crates*: `| layer | crate | uses | from outside | absent |`, lowest layer first. *Absent everywhere*: `| from | absent | why |`,
//! where `from` is `every crate` or `every library`, with `but` and names where there are exceptions. What stands in
//! backticks is data, all other words are for the reader.

/// The heading of the table of crates, as it must stand in the document.
pub(super) const CRATES_HEADING: &str = "| layer | crate | uses | from outside | absent |";
/// The heading of the table of what is absent from sets of crates.
pub(super) const SETS_HEADING: &str = "| from | absent | why |";

/// One row of the table of crates.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct CrateRow {
    pub(super) line: usize,
    pub(super) layer: String,
    pub(super) name: String,
    pub(super) uses: Vec<String>,
    pub(super) outside: Vec<String>,
    pub(super) absent: Vec<String>,
}

impl CrateRow {
    /// Whether the crate is a library that ships: not an app and not for development.
    pub(super) fn is_library(&self) -> bool {
        !matches!(self.layer.as_str(), "apps" | "dev")
    }
}

/// One row of the table of what is absent from sets of crates.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct SetRow {
    pub(super) libraries_only: bool,
    pub(super) exceptions: Vec<String>,
    pub(super) absent: Vec<String>,
}

impl SetRow {
    /// Whether the row speaks of that crate.
    pub(super) fn covers(&self, row: &CrateRow) -> bool {
        (row.is_library() || !self.libraries_only) && !self.exceptions.contains(&row.name)
    }
}

/// Both tables.
#[derive(Debug, Default)]
pub(super) struct Architecture {
    pub(super) crates: Vec<CrateRow>,
    pub(super) sets: Vec<SetRow>,
}

/// Reads the tables.
///
/// # Errors
/// The line and what is wrong with it, if a table is missing or a row has another shape.
pub(super) fn parse(text: &str) -> Result<Architecture, (usize, String)> {
    let mut architecture = Architecture::default();
    for (line, cells) in rows(text, CRATES_HEADING, 5)? {
        let [name] =
            quoted(&cells[1]).try_into().map_err(|_| (line, "one crate in backticks expected".to_owned()))?;
        architecture.crates.push(CrateRow {
            line,
            layer: cells[0].clone(),
            name,
            uses: quoted(&cells[2]),
            outside: quoted(&cells[3]),
            absent: quoted(&cells[4]),
        });
    }
    for (line, cells) in rows(text, SETS_HEADING, 3)? {
        let libraries_only = match cells[0].split(" but ").next() {
            Some("every crate") => false,
            Some("every library") => true,
            _ => return Err((line, "`every crate` or `every library` expected".to_owned())),
        };
        architecture.sets.push(SetRow {
            libraries_only,
            exceptions: quoted(&cells[0]),
            absent: quoted(&cells[1]),
        });
    }
    Ok(architecture)
}

/// The cells of a row, with its line number.
type Row = (usize, Vec<String>);

/// The rows under `heading`.
fn rows(text: &str, heading: &str, width: usize) -> Result<Vec<Row>, (usize, String)> {
    let lines: Vec<&str> = text.lines().collect();
    let start = lines
        .iter()
        .position(|line| line.trim() == heading)
        .ok_or_else(|| (0, format!("no table with the heading `{heading}`")))?;
    let mut found = Vec::new();
    for (index, line) in
        lines.iter().enumerate().skip(start + 2).take_while(|(_, line)| line.starts_with('|'))
    {
        let inner = line.trim().trim_start_matches('|').trim_end_matches('|');
        let cells: Vec<String> = inner.split('|').map(|cell| cell.trim().to_owned()).collect();
        if cells.len() != width {
            return Err((index + 1, format!("{width} cells expected, {} found", cells.len())));
        }
        found.push((index + 1, cells));
    }
    Ok(found)
}

/// What stands between backticks.
fn quoted(cell: &str) -> Vec<String> {
    cell.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}
