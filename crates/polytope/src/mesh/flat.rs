//! Surfaces that enclose no volume.

use super::strict::Surface;
use super::weld::Compact;
use crate::Polytope;
use crate::polytope::nonzero_axis;
use dcel::{FacetId, HalfedgeId, VertexId};
use exact::Point3;
use std::collections::{BTreeMap, HashMap};

/// Whether the facets of a flat surface that face the front of a polygon cover it exactly once.
///
/// They do if and only if, where their edges do not cancel, these run once around the polygon: a
/// chain of facets in a plane is determined by its boundary, and what of that lies on one edge of
/// the polygon is determined by its ends.
pub(super) fn covers_once(surface: &Surface<'_>, compact: &Compact, polygon: &Polytope) -> bool {
    let mesh = surface.mesh;
    let front = &polygon.vectors().normals[0];
    let axis = nonzero_axis(front);
    let faces_front = |f: &FacetId| surface.normals[f.index()].sign(axis) == front.sign(axis);
    // How often the boundary runs from the first to the second of two positions.
    let welded = compact.weld_labels();
    let mut runs: HashMap<[u32; 2], i32> = HashMap::new();
    for h in mesh.facets().filter(faces_front).flat_map(|f| mesh.facet_cycle(f)) {
        let [a, b] = [mesh.source(h), mesh.target(h)].map(|v| welded[v.index()]);
        if a != b {
            *runs.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
    }
    // On each edge of the polygon: how often the boundary ends at a position, less how often it starts.
    let around: Vec<HalfedgeId> = polygon.mesh.facet_cycle(FacetId(0)).collect();
    let mut ends: BTreeMap<(usize, &Point3), i32> = BTreeMap::new();
    let mut by_direction: HashMap<_, Vec<usize>> = HashMap::new();
    for (edge, h) in around.iter().enumerate() {
        let along = polygon.edge_vector(*h).primitive();
        by_direction.entry((-&along).coordinates()).or_default().push(edge);
        by_direction.entry(along.coordinates()).or_default().push(edge);
    }
    let corner = |v: VertexId| &polygon.points[v.index()];
    for ([a, b], count) in runs.into_iter().filter(|(_, count)| *count != 0) {
        let [p, q] = [a, b].map(|v| &compact.points[v as usize]);
        let along = p.direction_to(q).primitive();
        let on = |edge: &&usize| {
            let source = corner(polygon.mesh.source(around[**edge]));
            source.direction_to(p).cross(&along).is_zero()
        };
        let parallel = by_direction.get(&along.coordinates());
        let Some(&edge) = parallel.and_then(|edges| edges.iter().find(on)) else { return false };
        *ends.entry((edge, p)).or_default() -= count;
        *ends.entry((edge, q)).or_default() += count;
    }
    for (edge, h) in around.iter().enumerate() {
        *ends.entry((edge, corner(polygon.mesh.source(*h)))).or_default() += 1;
        *ends.entry((edge, corner(polygon.mesh.target(*h)))).or_default() -= 1;
    }
    ends.values().all(|count| *count == 0)
}
