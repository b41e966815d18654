//! Prints for two to five summands how many facets their sum has and how many it can have, and checks that they meet.

#![allow(clippy::print_stdout, reason = "the table is what the program is for")]

use splitstar_polytope::{MaximalError, max_facets, maximal_summands, minkowski_sum};

/// The numbers of facets of the summands.
const ROWS: [&[usize]; 12] = [
    &[4, 4],
    &[5, 5],
    &[11, 11],
    &[12, 4],
    &[4, 4, 4],
    &[4, 5, 6],
    &[9, 9, 9],
    &[4, 4, 4, 4],
    &[7, 6, 5, 4],
    &[4, 4, 4, 4, 4],
    &[5, 5, 5, 5, 5],
    &[8, 7, 6, 5, 4],
];

fn main() -> Result<(), MaximalError> {
    println!("{:>2}  {:24} {:>6} {:>6}", "k", "facets of the summands", "sum", "bound");
    for row in ROWS {
        let summands = maximal_summands(row)?;
        let sum = minkowski_sum(&summands.iter().collect::<Vec<_>>());
        let facets = row.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
        let bound = max_facets(row).expect("the bounds of the rows are small");
        assert_eq!(sum.counts().facets, bound, "{facets}");
        println!("{:2}  {facets:24} {:6} {bound:>6}", row.len(), sum.counts().facets);
    }
    Ok(())
}
