//! Time of Gaussian maps, on the sphere and on a cube: making both operands, and their overlay, for geodesic spheres of growing size.

use crate::Failure;
use crate::library::{self, Method};
use crate::solids::{TURN, geodesic_sphere};

use super::write_input;

/// Parts of the edges of the icosahedron; each sphere has about four times as many cells as the one before.
const FREQUENCIES: [usize; 4] = [4, 8, 16, 32];
/// The time per feature, divided by the binary logarithm of their number, may grow by this factor from the second size to the last: caches are
/// left behind.
const GROWTH: f64 = 2.0;

/// Prints the table, and checks the bound.
///
/// # Errors
/// If a case fails, or the bound does not hold.
pub(super) fn run() -> Result<(), Failure> {
    println!("{:<26} {:>10} {:>10} {:>10} {:>8} {:>12}", "", "", "seconds:", "", "ns per", "ns per fea-");
    println!(
        "{:<26} {:>10} {:>10} {:>10} {:>8} {:>12}",
        "a sphere and its turn", "features", "maps", "sum", "feature", "ture, by log"
    );
    let mut broken = Vec::new();
    for method in [Method::Walk, Method::Sgm, Method::Cgm] {
        let mut rows = Vec::new();
        for frequency in FREQUENCIES {
            let solid = geodesic_sphere(frequency);
            let a = write_input("growing", &solid.off())?;
            let b = write_input("growing_turned", &solid.turned(TURN).off())?;
            let measured = library::measured_sum_by(method, &[a, b], 3, 1.0)?;
            let [_, maps, sum] = measured.phases;
            let counts = measured.operands.iter().chain([&measured.sum]);
            let features = counts.map(|counts| counts.features()).sum::<usize>() as f64;
            let nanoseconds = 1e9 * (maps + sum) / features;
            let by_log = nanoseconds / features.log2();
            let name = format!("{}, frequency {frequency}", method.name());
            println!("{name:<26} {features:>10} {maps:>10.6} {sum:>10.6} {nanoseconds:>8.0} {by_log:>12.1}");
            rows.push(by_log);
        }
        let (base, last) = (rows[1], rows[rows.len() - 1]);
        if last > GROWTH * base {
            broken.push(format!(
                "{}: the time per feature and logarithm grew from {base:.1} to {last:.1} ns",
                method.name()
            ));
        }
    }
    if broken.is_empty() { Ok(()) } else { Err(broken.join("; ").into()) }
}
