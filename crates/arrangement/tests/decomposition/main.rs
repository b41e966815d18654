//! The vertical decomposition on surfaces of mixed sides, and counts of simple cases.

#![allow(clippy::unwrap_used)]

mod counts;
mod holes;
mod laws;
#[path = "../surfaces/paths.rs"]
#[allow(dead_code, reason = "the tests of surfaces use all of it")]
mod paths;
#[path = "../surfaces/strip.rs"]
#[allow(dead_code, reason = "the tests of surfaces use all of it")]
mod strip;
mod strips;
mod walls;

use splitstar_arrangement::Arrangement;
use splitstar_arrangement::decomposition::{
    DecompositionComplex, EdgeOrigin, VertexOrigin, VerticalDecomposition,
};
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::UMonotoneTraits;
