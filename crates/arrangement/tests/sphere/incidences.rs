//! What bounds the faces, told by points and circles only: two oracles that agree on it have the same cells, joined in the same way.

use crate::graph::Graph;
use crate::space::{P, opposite};
use splitstar_arrangement::Counts;
use std::collections::BTreeMap;

/// Where an edge begins, and the normal round which it goes counterclockwise: no other edge leaves that vertex this way. On a circle without
/// vertices an edge has no beginning, and at an isolated vertex the normal is zero.
pub(crate) type Dart = (Option<P>, P);

/// All around: the edges with the face on their left, one after the other. The first is the least.
pub(crate) type Cycle = Vec<Dart>;

/// The vertices, edges and faces as a user sees them.
#[derive(PartialEq, Eq, Debug)]
pub(crate) struct Incidences {
    pub(crate) counts: Counts,
    /// How many edges leave each vertex.
    pub(crate) degrees: BTreeMap<P, usize>,
    /// The ends of edges, the lesser one first, and how many edges have them.
    pub(crate) joined: BTreeMap<[P; 2], usize>,
    /// For each face, the cycles around it, sorted.
    pub(crate) faces: Vec<Vec<Cycle>>,
}

impl Incidences {
    /// Of the cycles of each face, in which every edge has an item for each side.
    pub(crate) fn new(counts: Counts, mut faces: Vec<Vec<Cycle>>) -> Self {
        let (mut degrees, mut joined) = (BTreeMap::new(), BTreeMap::<[P; 2], usize>::new());
        for cycle in faces.iter_mut().flatten() {
            let first = (0..cycle.len()).min_by_key(|&i| &cycle[i]).expect("a cycle is not empty");
            cycle.rotate_left(first);
            for (i, (source, normal)) in cycle.iter().enumerate() {
                let target = &cycle[(i + 1) % cycle.len()].0;
                let (Some(source), Some(target)) = (source, target) else { continue };
                let degree: &mut usize = degrees.entry(source.clone()).or_default();
                if !crate::space::is_zero(normal) {
                    *degree += 1;
                    let ends = [source.min(target).clone(), source.max(target).clone()];
                    *joined.entry(ends).or_default() += 1;
                }
            }
        }
        for sides in joined.values_mut() {
            assert!(sides.is_multiple_of(2), "an edge has two sides");
            *sides /= 2;
        }
        faces.iter_mut().for_each(|cycles| cycles.sort());
        faces.sort();
        Self { counts, degrees, joined, faces }
    }

    /// As brute force found them.
    pub(crate) fn of_graph(graph: &Graph) -> Self {
        let free = graph.has_free_circle.then(|| graph.vertices.len() - 1);
        let source = |v: usize| (Some(v) != free).then(|| graph.vertices[v].clone());
        let mut cycles: BTreeMap<usize, Cycle> = BTreeMap::new();
        for start in 0..graph.boundaries.len() {
            if cycles.contains_key(&graph.boundaries[start]) {
                continue;
            }
            let mut cycle = Cycle::new();
            let mut dart = start;
            loop {
                let normal = &graph.edges[dart / 2].normal;
                let normal = if dart.is_multiple_of(2) { normal.clone() } else { opposite(normal) };
                cycle.push((source(graph.source(dart)), normal));
                dart = graph.next(dart);
                if dart == start {
                    break;
                }
            }
            cycles.insert(graph.boundaries[start], cycle);
        }
        let zero = crate::space::at([0; 3]);
        for (&v, &boundary) in &graph.isolated {
            cycles.insert(boundary, vec![(source(v), zero.clone())]);
        }
        let mut faces = vec![Vec::new(); graph.counts.faces];
        for (boundary, cycle) in cycles {
            faces[graph.faces[boundary]].push(cycle);
        }
        Self::new(graph.counts, faces)
    }
}

#[test]
fn a_triangle_and_a_point() {
    use crate::arcs::{point, short};
    let [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let curves = [short(x, y), short(y, z), short(z, x), point([1, 1, 1]), point([1, 1, 2])];
    let found = Incidences::of_graph(&Graph::new(&curves));
    let [p, q, r, a, b] = [x, y, z, [1, 1, 1], [1, 1, 2]].map(crate::space::at);
    let dart = |source: &P, normal: P| (Some(source.clone()), normal);
    let zero = crate::space::at([0; 3]);
    // Around the octant counterclockwise, and round all the others clockwise.
    let inner = vec![dart(&r, q.clone()), dart(&p, r.clone()), dart(&q, p.clone())];
    let outer = vec![dart(&r, opposite(&p)), dart(&q, opposite(&r)), dart(&p, opposite(&q))];
    assert_eq!(found.faces.len(), 2);
    let isolated = [a, b].map(|p| vec![(Some(p), zero.clone())]);
    let [first, second] = isolated;
    assert!(found.faces.contains(&vec![inner, first, second]), "{:?}", found.faces);
    assert!(found.faces.contains(&vec![outer]), "{:?}", found.faces);
    assert_eq!(found.degrees.values().copied().collect::<Vec<_>>(), [2, 2, 2, 0, 0]);
    assert_eq!(found.joined.into_values().collect::<Vec<_>>(), [1, 1, 1]);
}
