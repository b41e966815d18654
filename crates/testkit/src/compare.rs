//! Are two polytopes the same?

use exact::Plane;
use polytope::{FacetId, Polytope};
use std::collections::{HashMap, HashSet};

/// What tells two polytopes apart: the first of dimension, counts, vertices, volume, centroid, bounds,
/// facet planes and facet cycles, or a violation of what a polytope promises; `None` if they are the
/// same.
pub fn difference(a: &Polytope, b: &Polytope) -> Option<String> {
    for (name, polytope) in [("first", a), ("second", b)] {
        if let Some(violation) = polytope.check_valid().first() {
            return Some(format!("the {name} is not valid: {violation}"));
        }
    }
    let not_equal = |what: &str, x: String, y: String| Some(format!("{what}: {x} and {y}"));
    if a.dimension() != b.dimension() {
        return not_equal("dimension", a.dimension().to_string(), b.dimension().to_string());
    }
    let counts = [a, b].map(|p| p.counts().to_array());
    if counts[0] != counts[1] {
        return not_equal("vertices, edges, facets", format!("{:?}", counts[0]), format!("{:?}", counts[1]));
    }
    if !a.same_set(b) {
        return Some("other vertices".to_owned());
    }
    let volumes = [a, b].map(Polytope::volume);
    if volumes[0] != volumes[1] {
        return not_equal("volume", volumes[0].to_string(), volumes[1].to_string());
    }
    if a.bounds() != b.bounds() {
        return Some("other bounds".to_owned());
    }
    if a.dimension() == 3 && facet_planes(a) != facet_planes(b) {
        return Some("other facet planes".to_owned());
    }
    if !isomorphic(a, b) {
        return Some("the vertices are joined in another way".to_owned());
    }
    None
}

/// Panics with the difference and the context if two polytopes are not the same.
///
/// # Panics
/// If they are not the same.
#[track_caller]
pub fn assert_same(a: &Polytope, b: &Polytope, context: impl std::fmt::Display) {
    if let Some(difference) = difference(a, b) {
        panic!("{context}: {difference}");
    }
}

/// The planes of the facets: both sides for a polygon, none in lower dimensions.
pub fn facet_planes(polytope: &Polytope) -> HashSet<Plane> {
    if polytope.dimension() < 2 {
        return HashSet::new();
    }
    polytope.mesh().facets().map(|f| polytope.facet_plane(f)).collect()
}

/// Whether the facets of two polytopes with the same vertices have the same cycles, beginning
/// anywhere; a polygon may show its back.
pub fn isomorphic(a: &Polytope, b: &Polytope) -> bool {
    if a.dimension() != b.dimension() || a.dimension() < 2 {
        return a.dimension() == b.dimension();
    }
    let index: HashMap<_, usize> =
        b.points().iter().enumerate().map(|(v, point)| (point.canonical_key(), v)).collect();
    let Some(names) =
        a.points().iter().map(|point| index.get(&point.canonical_key()).copied()).collect::<Option<Vec<_>>>()
    else {
        return false;
    };
    let cycle = |p: &Polytope, f: FacetId, name: &dyn Fn(usize) -> usize| {
        let mut cycle: Vec<usize> = p.facet_cycle(f).map(|v| name(v.index())).collect();
        let first = (0..cycle.len()).min_by_key(|&i| cycle[i]).unwrap_or(0);
        cycle.rotate_left(first);
        cycle
    };
    let cycles = |p: &Polytope, name: &dyn Fn(usize) -> usize| -> HashSet<Vec<usize>> {
        p.mesh().facets().map(|f| cycle(p, f, name)).collect()
    };
    cycles(a, &|v| names[v]) == cycles(b, &|v| v)
}
