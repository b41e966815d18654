//! The laws of vertical decompositions, which are the same on every surface.

#[path = "../decomposition/laws.rs"]
mod laws;

pub(crate) use laws::check;
use splitstar_arrangement::Arrangement;
use splitstar_arrangement::decomposition::{
    DecompositionComplex, EdgeOrigin, VertexOrigin, VerticalDecomposition,
};
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::UMonotoneTraits;
