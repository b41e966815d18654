//! The directions of the edges of several polytopes.

use crate::Polytope;
use dcel::HalfedgeId;
use exact::{Sign, Vector3};
use std::collections::HashMap;

/// The distinct directions of the edges of some polytopes, both ways: `2 i` and `2 i + 1` are opposite.
///
/// Halfedges have the same number exactly if they point the same way, so that parallel edges of
/// different summands are told by comparing numbers.
pub(super) struct Directions {
    vectors: Vec<Vector3>,
    /// By summand and edge: the direction of the even halfedge.
    of_edges: Vec<Vec<u32>>,
}

impl Directions {
    /// # Panics
    /// If there are 2^31 distinct directions or more.
    ///
    /// # Complexity
    /// Linear; a greatest common divisor per edge.
    pub(super) fn of(polytopes: &[&Polytope]) -> Self {
        let mut vectors = Vec::new();
        let mut numbers = HashMap::new();
        let mut number = |vector: Vector3| {
            let vector = vector.primitive();
            let first = crate::polytope::nonzero_axis(&vector);
            let is_turned = vector.sign(first) == Sign::Negative;
            let key = if is_turned { -vector } else { vector };
            let even = *numbers.entry(key).or_insert_with_key(|key| {
                let even = u32::try_from(vectors.len()).expect("there are fewer than 2^32 directions");
                vectors.extend([key.clone(), -key]);
                even
            });
            even | u32::from(is_turned)
        };
        let of_edges =
            polytopes.iter().map(|p| p.vectors().edges.iter().map(&mut number).collect()).collect();
        Self { vectors, of_edges }
    }

    /// The number of the direction of a halfedge.
    pub(super) fn of_halfedge(&self, summand: usize, h: HalfedgeId) -> u32 {
        self.of_edges[summand][h.edge()] ^ (h.0 & 1)
    }

    /// The primitive vector of a direction.
    pub(super) fn vector(&self, direction: u32) -> &Vector3 {
        &self.vectors[direction as usize]
    }
}
