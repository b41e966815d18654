//! Cells of a map and of its polytope, compared one by one.

use arrangement::models::GeodesicTraits;
use exact::{Point3, PointKey, Vector3};
use polytope::Polytope;
use splitstar_gauss::SphericalGaussianMap;
use std::collections::{HashMap, HashSet};
use testkit::{assert_same, facet_planes};

/// Identifications: the usual one, its opposite, along axes and oblique ones.
pub(crate) fn identifications() -> Vec<GeodesicTraits> {
    [[-1, 0], [1, 0], [0, 1], [1, 1], [-3, 2]].into_iter().map(identification).collect()
}

pub(crate) fn identification([x, y]: [i64; 2]) -> GeodesicTraits {
    GeodesicTraits::with_identification([x.into(), y.into()]).expect("not zero")
}

/// The greatest first.
fn turned<K: Ord + Clone>(mut cycle: Vec<K>) -> Vec<K> {
    let first = (0..cycle.len()).max_by_key(|&i| cycle[i].clone()).unwrap_or(0);
    cycle.rotate_left(first);
    cycle
}

/// Panics unless a map is valid and is that of a polytope: in its counts, and facet by facet and edge by edge with all neighbours.
#[track_caller]
pub(crate) fn check(map: &SphericalGaussianMap, polytope: &Polytope, context: &str) {
    assert_eq!(map.check_valid(), [], "{context}");
    assert_eq!(map.dimension(), polytope.dimension(), "{context}");
    assert_eq!(map.counts(), polytope.counts(), "{context}");
    let made = map.make_polytope();
    assert_same(&made, polytope, context);
    assert_eq!(facet_planes(&made), facet_planes(polytope), "{context}");
    let (arrangement, mesh) = (map.arrangement(), polytope.mesh());
    let dcel = arrangement.dcel();
    let index: HashMap<PointKey, usize> =
        polytope.points().iter().enumerate().map(|(i, p)| (p.canonical_key(), i)).collect();
    let vertex_of = |f| index[&map.point(f).canonical_key()];

    // Vertices and facets.
    let vertices: HashSet<usize> = dcel.faces().map(vertex_of).collect();
    assert_eq!(vertices.len(), polytope.points().len(), "{context}");
    let mut facets: HashMap<Vector3, Vec<usize>> = HashMap::new();
    if polytope.dimension() >= 2 {
        for f in mesh.facets() {
            let cycle = polytope.facet_cycle(f).map(|v| v.index()).collect();
            facets.insert(polytope.facet_normal(f).primitive(), turned(cycle));
        }
    }
    let view = arrangement.user_view();
    let mut normals = 0;
    for v in view.vertices().filter(|&v| !arrangement.is_artificial(v)) {
        let normal = arrangement.point(v).expect("on a sphere every vertex has a point").vector();
        let cycle = turned(dcel.around(v).map(|h| vertex_of(dcel.face(h))).collect());
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
    let mut seen = HashSet::new();
    for edge in view.edges() {
        let [first, last] = view.end_halfedges(edge);
        for (out, back) in [(first, last), (last, first)] {
            let v = |h| dcel.source(h);
            let normal = |h| {
                let point = arrangement.point(v(h)).filter(|_| !arrangement.is_artificial(v(h)));
                point.map(|point| point.vector())
            };
            let ends = [out.twin(), out].map(|h| vertex_of(dcel.face(h)));
            seen.insert((ends, normal(out), normal(back)));
        }
    }
    assert_eq!(seen, edges, "{context}");
}

/// Panics unless the map of a polytope is right under several identifications, and reflected, and identified anew.
#[track_caller]
pub(crate) fn check_maps(polytope: &Polytope, context: &str) {
    let usual = SphericalGaussianMap::of_polytope(polytope);
    check(&usual, polytope, context);
    let reflected = polytope.reflected();
    for traits in identifications() {
        let context = format!("{context}, identification {}", traits.identification());
        let map = SphericalGaussianMap::of_polytope_with(polytope, traits.clone());
        check(&map, polytope, &context);
        check(&map.reflected(), &reflected, &format!("{context}, reflected"));
        check(&map.reflected().reflected(), polytope, &format!("{context}, reflected twice"));
        let again = usual.reidentified(traits);
        check(&again, polytope, &format!("{context}, identified anew"));
        assert_eq!(again.counts_with_splits(), map.counts_with_splits(), "{context}");
    }
}

/// Panics unless the sum of two maps is right: in both orders, with several identifications.
#[track_caller]
pub(crate) fn check_sum(p: &Polytope, q: &Polytope, context: &str) {
    let expected = polytope::minkowski_sum(&[p, q]);
    let [a, b] = [p, q].map(SphericalGaussianMap::of_polytope);
    let sum = a.minkowski_sum(&b);
    check(&sum, &expected, context);
    let swapped = b.minkowski_sum(&a);
    check(&swapped, &expected, &format!("{context}, swapped"));
    assert_eq!(sum.counts_with_splits(), swapped.counts_with_splits(), "{context}");
    let other = SphericalGaussianMap::of_polytope_with(q, identification([2, 3]));
    check(&a.minkowski_sum(&other), &expected, &format!("{context}, identified anew"));
}

pub(crate) fn hull(points: &[[i64; 3]]) -> Polytope {
    testkit::hull(points)
}

pub(crate) fn point(p: [i64; 3]) -> Polytope {
    Polytope::point(Point3::from_i64(p))
}
