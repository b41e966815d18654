//! Vertices, halfedges and faces of Gaussian maps.

use super::rows::{Map, POLYTOPES, Row, SIDES, SUMS};
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
        head(&format!("{title}, spherical (SGM) and cubical (CGM) Gaussian maps: V/HE/F with what is artificial"));
        for row in rows {
            surprises.extend(print(row)?);
        }
        println!();
    }
    Ok(surprises)
}

fn print(row: &Row) -> Result<Vec<String>, Failure> {
    let models = library::polytopes(&paths(row.maps_of))?;
    if row.maps_of != row.models {
        println!("{:<30} |   {}", row.name, names(row.maps_of));
    }
    let columns: [(&str, &Map, fn(&[Polytope]) -> MapCounts); 2] =
        [("SGM", &row.spherical, library::spherical_counts), ("CGM", &row.cubical, library::cubical_counts)];
    let mut surprises = Vec::new();
    for (column, map, count) in columns {
        let turned: Vec<Polytope> = models.iter().map(|model| library::turned(model, map.turn)).collect();
        let name = format!("{} {column}", row.name);
        let (counted, printed) = (count(&turned).to_string(), map.printed.to_string());
        let [w, x, y, z] = map.turn;
        let place = if map.turn == [1, 0, 0, 0] { String::new() } else { format!(" (turned by {w},{x},{y},{z})") };
        surprises.extend(print_row(&name, &counted, &printed, map.why));
        if !place.is_empty() {
            println!("{:<30} | {:<15} | {:<15} | {place}", "", "", "");
        }
    }
    Ok(surprises)
}

/// Table 3.2.
fn sides() -> Result<Vec<String>, Failure> {
    head("Table 3.2, the six sides of the cube for DP: V/HE/F");
    let row = &POLYTOPES[3];
    let models = library::polytopes(&paths(row.models))?;
    let turned: Vec<Polytope> = models.iter().map(|model| library::turned(model, row.cubical.turn)).collect();
    let counted = library::cubical_side_counts(&turned);
    let mut surprises = Vec::new();
    for ((name, counted), printed) in counted.into_iter().zip(SIDES) {
        let printed = MapCounts::new(printed).to_string();
        surprises.extend(print_row(&format!("DP, side {name}"), &counted.to_string(), &printed, ""));
    }
    println!();
    Ok(surprises)
}
