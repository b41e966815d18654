//! Proximity against brute force in plain integers: all pairs of features for distances, all candidates of separating directions for
//! penetration. No set of differences is built.

#![allow(clippy::print_stdout, reason = "tests print their seeds and what they have met")]

mod check;
mod contact;
mod distance;
mod invariance;
mod models;
mod number;
mod pairs;
mod placements;
mod planes;
mod random;
mod rows;
mod solid;
