//! Table 3.5: how long sums take, by our methods and by those of CGAL, in one run.

use std::path::PathBuf;

use super::paths;
use super::rows::{Row, SUMS};
use crate::Failure;
use crate::library::{self, Method};
use crate::peers::Cgal;

/// What was printed for one row, in seconds on a processor of 1.7 GHz.
struct Printed {
    /// SGM, CGM, NGM, Fuk, CH.
    seconds: [f64; 5],
    /// F1 F2 / F.
    ratio: f64,
    /// Why that differs; empty where it agrees.
    why: &'static str,
}

/// In the order of table 3.4.
const PRINTED: [Printed; 5] = [
    Printed { seconds: [0.01, 0.01, 0.12, 0.01, 0.01], ratio: 20.0, why: "" },
    Printed { seconds: [0.04, 0.02, 0.33, 0.35, 0.05], ratio: 2.2, why: "" },
    Printed {
        seconds: [0.13, 0.03, 0.84, 1.55, 0.20],
        ratio: 10.9,
        why: "printed is 60 62 / 340: with the facets of the solid that the name stands for",
    },
    Printed { seconds: [0.71, 0.12, 6.81, 5.80, 1.89], ratio: 163.3, why: "the sum has other facets" },
    Printed {
        seconds: [1.01, 0.14, 7.06, 13.04, 6.91],
        ratio: 161.3,
        why: "printed is 612 612 / 2322: with the faces of cubical maps, not the facets",
    },
];

/// A driver of CGAL, its name in the table, how often it runs at least and for how many seconds.
const DRIVERS: [(&str, &str, usize, f64); 3] =
    [("sgm", "CGAL SGM", 3, 0.5), ("nef", "CGAL NGM", 1, 0.0), ("hull", "CGAL CH", 3, 0.5)];

/// Prints the table.
///
/// # Errors
/// If a model cannot be read.
pub(super) fn run() -> Result<(), Failure> {
    let drivers = DRIVERS.map(|(driver, ..)| Cgal::new(driver));
    println!(
        "Table 3.5: seconds from parsed meshes to the sum; LP is Fuk, hull is CH; printed: SGM, CGM, NGM, Fuk, CH\n"
    );
    let mut names: Vec<&str> = Method::ALL.iter().map(|method| method.name()).collect();
    names.extend(DRIVERS.map(|(_, name, ..)| name));
    let columns: Vec<String> = names.iter().map(|name| format!("{name:>9}")).collect();
    println!("{:<26} | {} | {:>8} | {:<36}", "", columns.join(" "), "F1 F2/F", "printed, and F1 F2/F");
    let mut missing = Vec::new();
    for (row, printed) in SUMS.iter().zip(PRINTED) {
        missing.extend(print(row, &printed, &drivers)?);
    }
    missing.dedup();
    for sentence in missing {
        println!("not run: {sentence}");
    }
    println!();
    Ok(())
}

/// Prints one row, and gives a sentence for each peer that did not run.
fn print(row: &Row, printed: &Printed, drivers: &[Cgal; 3]) -> Result<Vec<String>, Failure> {
    let operands: Vec<PathBuf> = paths(row.maps_of);
    let mut times = Vec::new();
    let mut ratio = 0.0;
    for method in Method::ALL {
        let measured = library::measured_sum_by(method, &operands, 3, 0.5)?;
        let facets = measured.operands.iter().map(|counts| counts.facets as f64);
        ratio = facets.product::<f64>() / measured.sum.facets as f64;
        times.push(Some(measured.seconds));
    }
    let mut missing = Vec::new();
    for ((_, name, least, budget), driver) in DRIVERS.iter().zip(drivers) {
        let seconds = driver.seconds(&operands, *least, *budget);
        times.push(seconds.as_ref().ok().copied());
        missing.extend(seconds.err().map(|why| format!("{name}: {why}")));
    }
    let shown: Vec<String> = times
        .iter()
        .map(|seconds| {
            seconds.map_or_else(|| format!("{:>9}", "not run"), |seconds| format!("{seconds:>9.6}"))
        })
        .collect();
    let old: Vec<String> = printed.seconds.iter().map(|seconds| format!("{seconds:>5.2}")).collect();
    println!(
        "{:<26} | {} | {ratio:>8.1} | {} {:>6.1}",
        row.name,
        shown.join(" "),
        old.join(" "),
        printed.ratio
    );
    if !printed.why.is_empty() {
        println!("{:<26} | F1 F2/F differs: {}", "", printed.why);
    }
    Ok(missing)
}
