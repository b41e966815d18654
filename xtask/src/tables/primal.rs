//! Vertices, edges and facets of polytopes and of their sums.

use super::rows::{POLYTOPES, Row, SUMS};
use super::{head, names, paths, print_row};
use crate::Failure;
use crate::library::{self, Counts};

/// Prints the primal columns; gives the names of rows that are not as expected.
///
/// # Errors
/// If a model cannot be read.
pub(super) fn run() -> Result<Vec<String>, Failure> {
    let mut surprises = Vec::new();
    for (title, rows) in
        [("Table 3.3, primal: V/E/F", &POLYTOPES[..]), ("Table 3.4, primal: V/E/F", &SUMS[..])]
    {
        head(title);
        for row in rows {
            surprises.extend(print(row)?);
        }
        println!();
    }
    Ok(surprises)
}

fn print(row: &Row) -> Result<Option<String>, Failure> {
    let printed = row.primal.to_string();
    let surprise = print_row(row.name, &count(row.models)?.to_string(), &printed, row.why);
    for other in row.others {
        let counted = count(other)?.to_string();
        let agrees = if counted == printed { "as printed" } else { "" };
        println!("{:<30} | {counted:<15} | {agrees:<15} |   {}", "", names(other));
    }
    Ok(surprise)
}

/// The counts of one convex model, or of the sum of two.
fn count(models: &[&str]) -> Result<Counts, Failure> {
    library::sum_counts(&paths(models))
}
