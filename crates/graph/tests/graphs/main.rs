//! Arrangements as graphs: the visit traits against copies in a graph of `petgraph`, and its algorithms against oracles.

// A test prints its seed, and fails by panicking, in its helpers too.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod algorithms;
mod cases;
mod contract;
mod duality;
mod edits;
mod sphere;
