//! Geodesic arcs: the laws of the traits, against plain integers and floats far from ties.

#![allow(clippy::unwrap_used, clippy::print_stderr)]

mod arcs;
mod chains;
mod laws;
mod oracle;
mod pairs;
mod sets;
