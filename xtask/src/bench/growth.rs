//! Time and memory for inputs of growing size: both are linear in operands plus result.

use crate::Failure;
use crate::solids::{Solid, TURN, bipyramid, geodesic_sphere};

use super::{Case, measure, write_input};

/// The time per feature may grow by this factor from the second smallest to the largest of a family: caches are left behind.
const LINEAR: f64 = 3.0;
/// Bytes per feature, in a fresh process, for inputs that outweigh the program itself.
const MEMORY: f64 = 1024.0;
/// Below this many features the program itself is most of its memory.
const SMALL: f64 = 20_000.0;

/// Prints the table, and checks both bounds.
///
/// # Errors
/// If a case fails, or a bound does not hold.
pub(super) fn run() -> Result<(), Failure> {
    println!(
        "{:<22} {:>10} {:>12} {:>10} {:>12}",
        "each and its turn", "features", "seconds", "ns/feature", "bytes/feature"
    );
    let spheres = [4, 8, 16, 32, 64].map(|f| (format!("sphere{}", 10 * f * f + 2), geodesic_sphere(f)));
    let bipyramids = [100, 1_000, 10_000].map(|n| (format!("bipyramid{n}"), bipyramid(n)));
    let mut broken = Vec::new();
    for family in [&spheres[..], &bipyramids[..]] {
        let mut cases = Vec::new();
        for (name, solid) in family {
            let case = twice(name, solid)?;
            let (time, memory) = (1e9 * case.seconds / case.features, case.peak_bytes / case.features);
            println!("{name:<22} {:>10} {:>12.6} {time:>10.0} {memory:>12.0}", case.features, case.seconds);
            if memory > MEMORY && case.features > SMALL {
                broken.push(format!(
                    "{name} takes {memory:.0} bytes per feature, at most {MEMORY} are allowed"
                ));
            }
            cases.push((name, time));
        }
        let (base, (largest, last)) = (cases[1].1, cases[cases.len() - 1]);
        if last > LINEAR * base {
            broken.push(format!("{largest}: the time per feature grew from {base:.0} to {last:.0} ns"));
        }
    }
    if broken.is_empty() { Ok(()) } else { Err(broken.join("; ").into()) }
}

/// The solid and its turned copy.
fn twice(name: &str, solid: &Solid) -> Result<Case, Failure> {
    let a = write_input(name, &solid.off())?;
    let b = write_input(&format!("{name}_turned"), &solid.turned(TURN).off())?;
    measure(&a, &b)
}
