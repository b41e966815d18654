//! `cargo xtask tables`: the tables of the thesis on Minkowski sums, counted and timed again.
//!
//! The thesis is *Minkowski Sum Construction and other Applications of Arrangements of Geodesic Arcs on the Sphere*
//! (E. Fogel, 2009). Its models are not published; ours are built from what it says of them (`models/README.md`), so that a
//! row may differ. Each figure is counted at run time; only what was printed is a constant here, and where the model lies.
//!
//! | file | role |
//! |---|---|
//! | `rows` | what was printed in tables 3.2, 3.3 and 3.4, with placements, and why figures differ |
//! | `primal` | V/E/F of the polytopes |
//! | `maps` | V/HE/F of their spherical and cubical Gaussian maps |
//! | `search` | how the placements were found: `cargo xtask tables search` |
//! | `times` | table 3.5 beside the peers of this machine |

mod maps;
mod primal;
mod rows;
mod search;
mod times;

use std::path::PathBuf;

use crate::{Failure, shell};

/// Counts every row and prints all tables; or only those that are counted, or the search of placements.
///
/// # Errors
/// If a model cannot be read, or if a row without a reason differs or a row with a reason agrees.
pub(crate) fn run(words: &[&str]) -> Result<(), Failure> {
    match words {
        [] => counted().and(times::run()),
        ["counts"] => counted(),
        ["times"] => times::run(),
        ["search"] => search::run(None),
        ["search", name] => search::run(Some(name)),
        _ => Err("usage: cargo xtask tables [counts|times|search [ROW]]".into()),
    }
}

fn counted() -> Result<(), Failure> {
    let mut surprises = primal::run()?;
    surprises.extend(maps::run()?);
    if surprises.is_empty() {
        Ok(())
    } else {
        Err(format!("not as expected: {}", surprises.join(", ")).into())
    }
}

/// The files of models.
fn paths(models: &[&str]) -> Vec<PathBuf> {
    models.iter().map(|name| shell::root().join("models/convex").join(name)).collect()
}

/// Names of models, without the endings of their files.
fn names(models: &[&str]) -> String {
    let names: Vec<&str> = models.iter().map(|name| name.split('.').next().unwrap_or(name)).collect();
    names.join(" + ")
}

/// Prints the head of a table.
fn head(title: &str) {
    println!("{title}\n");
    println!("{:<30} | {:<15} | {:<15} | why they differ", "", "counted", "printed");
    println!("{:-<30}-|-{:-<15}-|-{:-<15}-|-{:-<16}", "", "", "", "");
}

/// Prints a row, and gives its name if the figures agree and there is a reason why not, or the other way round.
fn print_row(name: &str, counted: &str, printed: &str, why: &str) -> Option<String> {
    println!("{name:<30} | {counted:<15} | {printed:<15} | {why}");
    ((counted == printed) != why.is_empty()).then(|| name.to_owned())
}

#[cfg(test)]
mod tests {
    #[test]
    fn rows_differ_where_it_is_said() {
        super::counted().expect("every row without a reason is as printed, and no other");
    }
}
