//! Surfaces that enclose no volume.

use super::strict::Surface;
use super::weld::Compact;
use super::{MeshError, Note};
use crate::measure::twice_area;
use crate::polytope::nonzero_axis;
use crate::{Polytope, convex_hull};
use dcel::{FacetId, HalfedgeId, VertexId};
use exact::{Point3, Sign, Vector3};
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

/// The segment that facets of two vertices make up.
pub(super) fn segment(compact: &Compact, notes: &mut Vec<Note>) -> Result<Polytope, MeshError> {
    let apart = |facet: usize| MeshError::ScatteredEdges { facet: compact.facet_names[facet] };
    let ends = |facet: usize| {
        let [a, b] = [0, 1].map(|i| &compact.points[compact.facets.get(facet)[i] as usize]);
        if a <= b { [a, b] } else { [b, a] }
    };
    let hull = convex_hull(&compact.points).ok_or(MeshError::Empty)?;
    let count = compact.facets.len();
    if hull.dimension > 1 {
        let [a, b] = ends((0..count).find(|&f| ends(f)[0] != ends(f)[1]).unwrap_or(0));
        let along = a.direction_to(b);
        let on_line = |p: &&Point3| a.direction_to(p).cross(&along).is_zero();
        let off = (0..count).find(|&f| !ends(f).iter().all(on_line));
        return Err(apart(off.unwrap_or(0)));
    }
    // Along a line the lexicographic order is that of the points: the facets must leave no gap.
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|&f| ends(f));
    let mut reached = ends(order[0])[1];
    for &f in &order[1..] {
        let [from, to] = ends(f);
        if from > reached {
            return Err(apart(f));
        }
        reached = reached.max(to);
    }
    if count > 1 {
        notes.push(Note::Joined { from: [compact.points.len(), count], to: [hull.points.len(), 1] });
        return Ok(hull);
    }
    // A single facet keeps its direction.
    let [a, b] = [0, 1].map(|i| compact.points[compact.facets.get(0)[i] as usize].clone());
    Ok(Polytope::segment(a, b))
}

/// The first corner of a planar polygon that turns against the sense in which the polygon winds.
pub(super) fn reflex_corner(points: &[Point3], cycle: &[u32]) -> Option<u32> {
    let corner = |i: usize| &points[cycle[i % cycle.len()] as usize];
    let turn = |i: usize| {
        let (a, b, c) = (corner(i), corner(i + 1), corner(i + 2));
        a.direction_to(b).cross(&b.direction_to(c))
    };
    let turns: Vec<Vector3> = (0..cycle.len()).map(turn).collect();
    let axis = nonzero_axis(turns.iter().find(|normal| !normal.is_zero())?);
    let corners: Vec<&Point3> = (0..cycle.len()).map(corner).collect();
    let area = twice_area(&corners, axis);
    let against = |normal: &Vector3| normal.sign(axis) * area.sign() == Sign::Negative;
    turns.iter().position(against).map(|i| cycle[(i + 1) % cycle.len()])
}
