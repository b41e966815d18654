//! Time and memory for inputs of growing size: both are linear in operands plus result.

use crate::Failure;
use crate::solids::{Solid, TURN, TURN_ABOUT_Z, bipyramid, geodesic_sphere};

use super::{Case, measure, write_input};

/// The time per feature may grow by this factor from the second case of a family to its last: caches are left behind.
const LINEAR: f64 = 3.0;
/// Bytes per feature, in a fresh process: the program itself counts.
const MEMORY: f64 = 1024.0;

/// Solids of growing size, and how the second operand is turned.
struct Family {
    name: &'static str,
    solid: fn(usize) -> Solid,
    sizes: &'static [usize],
    turn: [i128; 4],
}

/// What grows. Turned about its axis a bipyramid has a sum of linear size, whose two apexes are faces of n arcs in both Gaussian
/// maps, crossing 2n times; turned otherwise its meridians cross, and the sum has a size of about n²/2.
const FAMILIES: [Family; 3] = [
    Family { name: "sphere, frequency", solid: geodesic_sphere, sizes: &[4, 8, 16, 32, 64], turn: TURN },
    Family {
        name: "bipyramid, about axis,",
        solid: bipyramid,
        sizes: &[100, 1_000, 10_000, 100_000],
        turn: TURN_ABOUT_Z,
    },
    Family { name: "bipyramid", solid: bipyramid, sizes: &[100, 1_000, 10_000], turn: TURN },
];

/// Prints the table, and checks both bounds.
///
/// # Errors
/// If a case fails, or a bound does not hold.
pub(super) fn run() -> Result<(), Failure> {
    println!(
        "{:<30} {:>10} {:>10} {:>8} {:>8} {:>8} {:>8}",
        "", "", "", "ns per", "of which", "", "bytes per"
    );
    println!(
        "{:<30} {:>10} {:>10} {:>8} {:>8} {:>8} {:>8}",
        "each and its turn", "features", "seconds", "feature", "operands", "sum", "feature"
    );
    let mut broken = Vec::new();
    for family in &FAMILIES {
        let mut times = Vec::new();
        for &size in family.sizes {
            let name = format!("{} {size}", family.name);
            let case = case(family, size)?;
            let per_feature = |seconds: f64| 1e9 * seconds / case.features;
            let [operands, sum] = case.phases.map(per_feature);
            let (time, memory) = (per_feature(case.seconds), case.peak_bytes / case.features);
            println!(
                "{name:<30} {:>10} {:>10.6} {time:>8.0} {operands:>8.0} {sum:>8.0} {memory:>8.0}",
                case.features, case.seconds
            );
            if memory > MEMORY {
                broken.push(format!("{name}: {memory:.0} bytes per feature, at most {MEMORY} are allowed"));
            }
            times.push(time);
        }
        let (base, last) = (times[1], times[times.len() - 1]);
        if last > LINEAR * base {
            broken.push(format!("{}: the time per feature grew from {base:.0} to {last:.0} ns", family.name));
        }
    }
    if broken.is_empty() { Ok(()) } else { Err(broken.join("; ").into()) }
}

/// Measures the solid of that size and its turned copy.
fn case(family: &Family, size: usize) -> Result<Case, Failure> {
    let solid = (family.solid)(size);
    let a = write_input("growing", &solid.off())?;
    let b = write_input("growing_turned", &solid.turned(family.turn).off())?;
    measure(&a, &b)
}
