//! `cargo xtask tables`: the primal columns of thesis tables 3.3 and 3.4, counted again.
//!
//! The thesis is *Minkowski Sum Construction and other Applications of Arrangements of Geodesic Arcs on the Sphere*
//! (E. Fogel, 2009). Its models are not published; ours are built from what it says of them (`models/README.md`), so that a
//! row may differ. Each row is counted at run time; only what was printed is a constant here.

use crate::library::{self, Counts};
use crate::{Failure, shell};

/// One row of a printed table.
struct Row {
    name: &'static str,
    /// The solid the name stands for, or both summands.
    models: &'static [&'static str],
    printed: [usize; 3],
    /// Why counted and printed differ; empty where they must agree.
    why: &'static str,
    /// Other readings of the name, counted as well.
    others: &'static [&'static [&'static str]],
}

const fn row(name: &'static str, models: &'static [&'static str], printed: [usize; 3]) -> Row {
    Row { name, models, printed, why: "", others: &[] }
}

/// Table 3.3, columns V, E, F of the primal representation.
const POLYTOPES: [Row; 8] = [
    row("Tetrahedron", &["tetrahedron.off"], [4, 6, 4]),
    row("Octahedron", &["octahedron.off"], [6, 12, 8]),
    row("Icosahedron", &["icosahedron.off"], [12, 30, 20]),
    row("DP", &["dp.off"], [17, 32, 17]),
    Row {
        name: "PH",
        models: &["pentagonal_hexecontahedron.xoff"],
        printed: [60, 150, 92],
        why: "printed counts are those of the dual solid, the snub dodecahedron",
        others: &[&["ph_snub_dodecahedron.off"]],
    },
    row("TI", &["truncated_icosidodecahedron.xoff"], [120, 180, 62]),
    Row {
        name: "GS4",
        models: &["gs_freq4.off"],
        printed: [252, 750, 500],
        why: "4^l triangles per face cannot give 500; printed counts are those of edges in 5 parts",
        others: &[&["gs4.off"]],
    },
    row("El16", &["el16.off"], [482, 992, 512]),
];

/// Table 3.4, columns V, E, F of the primal representation of the sum.
const SUMS: [Row; 5] = [
    row("Icosahedron + Icosahedron", &["icosahedron.off", "icosahedron.off"], [12, 30, 20]),
    row("DP + ODP", &["dp.off", "odp.xoff"], [131, 261, 132]),
    Row {
        name: "PH + TI",
        models: &["pentagonal_hexecontahedron.xoff", "truncated_icosidodecahedron.xoff"],
        printed: [248, 586, 340],
        why: "impossible for these summands: 340 facets leave too few edge sides for the facets of TI; \
              the printed Gaussian map (429 faces) fits snub dodecahedron + turned TI",
        others: &[
            &["ph_snub_dodecahedron.off", "truncated_icosidodecahedron.xoff"],
            &["ph_snub_dodecahedron.off", "truncated_icosidodecahedron_rotated.xoff"],
        ],
    },
    Row {
        name: "GS4 + RGS4",
        models: &["gs4.off", "rgs4.xoff"],
        printed: [1048, 2582, 1536],
        why: "angle not published; an exact turn about a twofold axis makes 2 mod 4 crossings, \
              the 536 of the printed row need rounding",
        others: &[&["gs4.off", "rgs4_6degrees.xoff"], &["gs4.off", "rgs4_general.xoff"]],
    },
    row("El16 + OEl16", &["el16.off", "oel16.xoff"], [2260, 4580, 2322]),
];

/// Counts every row and prints both tables.
///
/// # Errors
/// If a model cannot be read, or if a row without a reason differs or a row with a reason agrees.
pub(crate) fn run() -> Result<(), Failure> {
    let mut surprises = Vec::new();
    for (title, rows) in [("Table 3.3, primal", &POLYTOPES[..]), ("Table 3.4, primal", &SUMS[..])] {
        println!("{title}: V/E/F\n");
        println!("{:<26} | {:<15} | {:<15} | why they differ", "", "counted", "printed");
        println!("{:-<26}-|-{:-<15}-|-{:-<15}-|-{:-<16}", "", "", "", "");
        for row in rows {
            let counted = count(row.models)?;
            let [v, e, f] = row.printed;
            let printed = Counts { vertices: v, edges: e, facets: f };
            println!(
                "{:<26} | {:<15} | {:<15} | {}",
                row.name,
                counted.to_string(),
                printed.to_string(),
                row.why
            );
            if (counted == printed) != row.why.is_empty() {
                surprises.push(row.name);
            }
            for other in row.others {
                let counted = count(other)?;
                let agrees = if counted == printed { "as printed" } else { "" };
                let names: Vec<&str> =
                    other.iter().map(|name| name.split('.').next().unwrap_or(name)).collect();
                println!(
                    "{:<26} | {:<15} | {:<15} |   {}",
                    "",
                    counted.to_string(),
                    agrees,
                    names.join(" + ")
                );
            }
        }
        println!();
    }
    if surprises.is_empty() {
        Ok(())
    } else {
        Err(format!("not as expected: {}", surprises.join(", ")).into())
    }
}

/// The counts of one convex model, or of the sum of two.
fn count(models: &[&str]) -> Result<Counts, Failure> {
    let paths: Vec<_> = models.iter().map(|name| shell::root().join("models/convex").join(name)).collect();
    library::sum_counts(&paths)
}
