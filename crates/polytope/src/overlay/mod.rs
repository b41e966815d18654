//! The Minkowski sum of two polytopes as the overlay of their Gaussian maps.
//!
//! | file | what it does |
//! |---|---|
//! | `map` | reads the Gaussian map off the mesh |
//! | `locate` | finds the place of one normal |
//! | `trace`, `search` | walks one map through the other; searches along the ring of a face |
//! | `record` | what a walk records |
//! | `assemble` | joins both walks to the mesh of the sum |
//!
//! # References
//! Thesis, section 3.1 (Gaussian maps and their overlay); L. Guibas, R. Seidel, "Computing convolutions
//! by reciprocal search" (1987) for the linear overlay of convex subdivisions.

mod assemble;
mod locate;
mod map;
mod record;
mod search;
mod trace;

use crate::Polytope;
use map::{Boundary, GaussianMap};

/// How the arcs of two Gaussian maps meet: what degeneracies a sum has met.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OverlayCounts {
    /// Arcs of both maps that cross in a point interior to both.
    pub crossings: usize,
    /// Normals that both polytopes have.
    pub common_normals: usize,
    /// Normals of one polytope in the interior of an arc of the other.
    pub normals_on_arcs: usize,
    /// Times that an arc ran along one of the other map.
    pub overlaps: usize,
}

/// The sum of two polytopes of dimension 1 to 3, not two parallel segments; and how their maps meet.
pub(crate) fn sum(p: &Polytope, q: &Polytope) -> (Polytope, OverlayCounts) {
    let (p, q) = (Boundary::of(p), Boundary::of(q));
    // The maps go before the sum is assembled: it needs the memory.
    let (in_blue, in_red) = {
        let (red, blue) = (GaussianMap::new(&p), GaussianMap::new(&q));
        (trace::trace(&red, &blue), trace::trace(&blue, &red))
    };
    let counts = OverlayCounts {
        crossings: in_blue.counts.crossings,
        common_normals: in_blue.counts.common_normals,
        normals_on_arcs: in_blue.counts.normals_on_arcs + in_red.counts.normals_on_arcs,
        overlaps: in_blue.counts.overlaps,
    };
    (assemble::assemble([&p, &q], [in_blue, in_red]), counts)
}
