//! Vertices, halfedges and faces of Gaussian maps.

use super::rows::{AS_FILED, Map, POLYTOPES, Row, SIDES, SUMS};
use super::{head, names, paths, print_row};
use crate::Failure;
use crate::library::{self, MapCounts};
use polytope::Polytope;

/// Prints the columns of both kinds of maps; gives the names of rows that are not as expected.
///
/// # Errors
/// If a model cannot be read.
pub(super) fn run() -> Result<Vec<String>, Failure> {
    let mut surprises = sides()?;
    for (title, rows) in [("Table 3.3", &POLYTOPES[..]), ("Table 3.4", &SUMS[..])] {
        head(&format!(
            "{title}, spherical (SGM) and cubical (CGM) Gaussian maps: V/HE/F with what is artificial"
        ));
        for row in rows {
            surprises.extend(print(row)?);
        }
        println!();
    }
    Ok(surprises)
}

fn print(row: &Row) -> Result<Vec<String>, Failure> {
    let mut surprises = Vec::new();
    for (column, map, count) in columns(row) {
        let counted = count(&solids(row, map)?).to_string();
        let printed = map.printed.to_string();
        surprises.extend(print_row(&format!("{} {column}", row.name), &counted, &printed, map.why));
        let mut notes: Vec<String> = Vec::new();
        if row.maps_of != row.models {
            notes.push(names(row.maps_of));
        }
        if map.turn != AS_FILED {
            notes.push(format!("turned by {}", map.turn.map(|c| c.to_string()).join(",")));
        }
        if !map.note.is_empty() {
            notes.push(map.note.into());
        }
        if !notes.is_empty() {
            println!("{:<30} | {:<15} | {:<15} |   {}", "", "", "", notes.join(", "));
        }
    }
    Ok(surprises)
}

/// How cells of the map of a sum are counted.
pub(super) type Count = fn(&[Polytope]) -> MapCounts;

/// The columns of both kinds of maps.
pub(super) fn columns(row: &Row) -> [(&'static str, &Map, Count); 2] {
    [("SGM", &row.spherical, library::spherical_counts), ("CGM", &row.cubical, library::cubical_counts)]
}

/// The summands, where they lie for this map.
fn solids(row: &Row, map: &Map) -> Result<Vec<Polytope>, Failure> {
    let models = match map.points {
        [] => library::polytopes(&paths(row.maps_of))?,
        points => vec![library::hull(points)],
    };
    Ok(models.iter().map(|model| library::turned(model, map.turn)).collect())
}

/// Table 3.2.
fn sides() -> Result<Vec<String>, Failure> {
    head("Table 3.2, the six sides of the cube for DP: V/HE/F");
    let row = &POLYTOPES[3];
    let counted = library::cubical_side_counts(&solids(row, &row.cubical)?);
    let mut surprises = Vec::new();
    for ((name, counted), printed) in counted.into_iter().zip(SIDES) {
        let printed = MapCounts::new(printed).to_string();
        surprises.extend(print_row(&format!("DP, side {name}"), &counted.to_string(), &printed, ""));
    }
    println!("{:<30} | {:<15} | {:<15} |   {}\n", "", "", "", row.cubical.note);
    Ok(surprises)
}
