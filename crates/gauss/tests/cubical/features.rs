//! Cells of a map and of its polytope, compared one by one.

use cubical::At;
use dcel::HalfedgeId;
use exact::{PointKey, Vector3};
use polytope::Polytope;
use splitstar_gauss::CubicalGaussianMap;
use std::collections::{HashMap, HashSet};
use testkit::{assert_same, facet_planes};

/// The greatest first.
fn turned<K: Ord + Clone>(mut cycle: Vec<K>) -> Vec<K> {
    let first = (0..cycle.len()).max_by_key(|&i| cycle[i].clone()).unwrap_or(0);
    cycle.rotate_left(first);
    cycle
}

/// Panics unless a map is valid and is that of a polytope: in its counts, and facet by facet and edge by edge with all neighbours.
#[track_caller]
pub(crate) fn check(map: &CubicalGaussianMap, polytope: &Polytope, context: &str) {
    assert_eq!(map.check_valid(), [], "{context}");
    assert_eq!(map.dimension(), polytope.dimension(), "{context}");
    assert_eq!(map.counts(), polytope.counts(), "{context}");
    let made = map.make_polytope();
    assert_same(&made, polytope, context);
    assert_eq!(facet_planes(&made), facet_planes(polytope), "{context}");
    let (cube, mesh) = (map.arrangement(), polytope.mesh());
    let index: HashMap<PointKey, usize> =
        polytope.points().iter().enumerate().map(|(i, p)| (p.canonical_key(), i)).collect();
    let vertex_of = |h: At<HalfedgeId>| index[&map.point(cube.face(h)).canonical_key()];

    // Vertices and facets.
    let vertices: HashSet<usize> = map.points().iter().map(|p| index[&p.canonical_key()]).collect();
    assert_eq!(vertices.len(), polytope.points().len(), "{context}");
    let mut facets: HashMap<Vector3, Vec<usize>> = HashMap::new();
    if polytope.dimension() >= 2 {
        for f in mesh.facets() {
            let cycle = polytope.facet_cycle(f).map(|v| v.index()).collect();
            facets.insert(polytope.facet_normal(f).primitive(), turned(cycle));
        }
    }
    let mut normals = 0;
    for v in cube.real_vertices() {
        let normal = cube.direction(v).vector();
        let cycle = turned(cube.real_around(v).map(vertex_of).collect());
        assert_eq!(Some(&cycle), facets.get(&normal), "{context}: facet {normal:?}");
        normals += 1;
    }
    assert_eq!(normals, facets.len(), "{context}");

    // Edges with the vertices and facets beside them.
    let mut edges = HashSet::new();
    for h in mesh.edges().flat_map(|h| [h, h.twin()]) {
        let normal = |h| match polytope.dimension() {
            0 | 1 => None,
            _ => Some(polytope.facet_normal(mesh.facet(h)).primitive()),
        };
        edges.insert(([mesh.source(h), mesh.target(h)].map(|v| v.index()), normal(h), normal(h.twin())));
    }
    let view = cube.real_view();
    let mut seen = HashSet::new();
    for edge in 0..view.edge_count() {
        let [first, last] = view.end_halfedges(edge);
        for (out, back) in [(first, last), (last, first)] {
            let normal = |h| {
                let v = cube.source(h);
                cube.is_real_vertex(v).then(|| cube.direction(v).vector())
            };
            let ends = [cube.twin(out), out].map(vertex_of);
            seen.insert((ends, normal(out), normal(back)));
        }
        let parts: HashSet<_> = view.halfedges(edge).map(vertex_of).collect();
        assert_eq!(parts.len(), 1, "{context}: one vertex along an edge");
    }
    assert_eq!(seen, edges, "{context}");
}

/// Panics unless the map of a polytope is right, reflected too.
#[track_caller]
pub(crate) fn check_map(polytope: &Polytope, context: &str) {
    let map = CubicalGaussianMap::of_polytope(polytope);
    check(&map, polytope, context);
    let reflected = map.reflected();
    check(&reflected, &polytope.reflected(), &format!("{context}, reflected"));
    check(&reflected.reflected(), polytope, &format!("{context}, reflected twice"));
}

/// Panics unless the sum of two maps is right in both orders.
#[track_caller]
pub(crate) fn check_sum(p: &Polytope, q: &Polytope, context: &str) {
    let expected = polytope::minkowski_sum(&[p, q]);
    let [a, b] = [p, q].map(CubicalGaussianMap::of_polytope);
    let sum = a.minkowski_sum(&b);
    check(&sum, &expected, context);
    let swapped = b.minkowski_sum(&a);
    check(&swapped, &expected, &format!("{context}, swapped"));
    let [stored, of_swapped] = [&sum, &swapped].map(|map| map.arrangement().counts_with_artificial());
    assert_eq!(stored, of_swapped, "{context}");
}
