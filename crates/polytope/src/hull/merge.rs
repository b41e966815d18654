//! From triangles to facets.

use super::quickhull::{Surface, next};
use crate::facets::Facets;

/// Joins neighbouring triangles of one plane, and returns the boundaries of the facets without vertices
/// inside edges.
///
/// No arithmetic: a facet of a convex surface is connected, so its triangles are those reached over flat
/// edges. A vertex on the boundary of a facet is inside an edge of it if the boundary has the same other
/// facet before and behind the vertex: both pieces then lie on the line where the two planes meet. At an
/// extreme point they are different.
///
/// # Complexity
/// Linear in the number of triangles.
pub(super) fn facets(surface: &Surface) -> Facets {
    let facet_of = label(surface);
    let mut facets = Facets::new();
    let mut is_done = vec![false; surface.source.len()];
    let mut cycle = Vec::new();
    for start in 0..surface.source.len() as u32 {
        if surface.is_flat[start as usize] || is_done[start as usize] {
            continue;
        }
        // The facet is a convex polygon: it has one boundary, and this is all of it.
        let beyond = |h: u32| facet_of[(surface.twin[h as usize] / 3) as usize];
        let mut h = start;
        cycle.clear();
        loop {
            is_done[h as usize] = true;
            let following = next_on_boundary(surface, h);
            if beyond(h) != beyond(following) {
                cycle.push(surface.source[following as usize]);
            }
            h = following;
            if h == start {
                break;
            }
        }
        facets.push(&cycle);
    }
    facets
}

/// Returns the boundary halfedge that follows `h`. Around its vertex each flat edge of the facet is passed
/// once, so that a whole boundary costs no more than the facet has triangles.
fn next_on_boundary(surface: &Surface, h: u32) -> u32 {
    let mut g = next(h);
    while surface.is_flat[g as usize] {
        g = next(surface.twin[g as usize]);
    }
    g
}

/// Numbers the facets; returns for each triangle the facet that it belongs to.
fn label(surface: &Surface) -> Vec<u32> {
    let count = surface.source.len() / 3;
    let mut root: Vec<u32> = (0..count as u32).collect();
    for (h, (&is_flat, &g)) in surface.is_flat.iter().zip(&surface.twin).enumerate() {
        if is_flat {
            let (a, b) = (find(&mut root, h as u32 / 3), find(&mut root, g / 3));
            root[a.max(b) as usize] = a.min(b);
        }
    }
    (0..count as u32).map(|t| find(&mut root, t)).collect()
}

/// Returns the representative of the set of `t`, and halves the way to it.
fn find(root: &mut [u32], mut t: u32) -> u32 {
    while root[t as usize] != t {
        let above = root[root[t as usize] as usize];
        root[t as usize] = above;
        t = above;
    }
    t
}
