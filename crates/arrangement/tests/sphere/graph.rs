//! What the cells on the sphere are, found by brute force on all pairs of arcs.
//!
//! Vertices are ends and crossings; edges are what is between neighbours on an arc; the edges around a vertex are sorted by their
//! directions. So the boundaries of faces are known, and which of them belong to one face, arcs tell that go from one component to
//! another (`walks`).

use crate::arcs::{Arc, Curve};
use crate::space::{P, compare_way, cross, opposite};
use splitstar_arrangement::Counts;
use std::collections::{BTreeMap, BTreeSet};

/// The circle of an edge by the greater of its normals, and the ends counterclockwise round it; none for a circle without vertices.
pub(crate) type EdgeKey = (P, Option<[P; 2]>);

/// Cells, named by numbers.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Place {
    Vertex(usize),
    Edge(usize),
    Face(usize),
}

/// Vertices, edges and faces as a user sees them.
///
/// A circle without vertices has an artificial one: the last.
#[derive(Clone, Debug)]
pub(crate) struct Graph {
    pub(crate) vertices: Vec<P>,
    pub(crate) edges: Vec<Arc>,
    pub(crate) keys: BTreeMap<EdgeKey, usize>,
    /// The numbers of the vertices of edges.
    pub(crate) ends: Vec<[usize; 2]>,
    /// Whether the last vertex is artificial.
    pub(crate) has_free_circle: bool,
    /// The darts that leave each vertex, counterclockwise. Dart 2e goes along edge e, 2e + 1 comes back.
    pub(crate) around: Vec<Vec<usize>>,
    /// For each dart, its boundary; after the boundaries come the isolated vertices.
    pub(crate) boundaries: Vec<usize>,
    pub(crate) isolated: BTreeMap<usize, usize>,
    /// For each boundary and isolated vertex, its face.
    pub(crate) faces: Vec<usize>,
    pub(crate) counts: Counts,
}

/// The same for all arcs that run along one edge.
pub(crate) fn edge_key(normal: &P, ends: Option<[P; 2]>) -> EdgeKey {
    let turned = opposite(normal);
    if turned > *normal { (turned, ends.map(|[a, b]| [b, a])) } else { (normal.clone(), ends) }
}

/// The vertices of curves: ends, and crossings of all pairs.
pub(crate) fn vertices_of(arcs: &[Arc]) -> BTreeSet<P> {
    let mut vertices: BTreeSet<P> = arcs.iter().flat_map(|arc| arc.ends.clone()).flatten().collect();
    for (i, a) in arcs.iter().enumerate() {
        vertices.extend(arcs[..i].iter().flat_map(|b| a.crossings(b)));
    }
    vertices
}

/// The edges along an arc between some vertices.
pub(crate) fn edges_along(arc: &Arc, vertices: &BTreeSet<P>) -> Vec<EdgeKey> {
    let mut stops: Vec<P> = vertices.iter().filter(|v| arc.has(v)).cloned().collect();
    stops.sort_by(|a, b| arc.compare(a, b));
    let is_closed = arc.ends.as_ref().is_none_or(|[a, b]| a == b);
    match stops.first().cloned() {
        None => return vec![edge_key(&arc.normal, None)],
        Some(first) if is_closed => stops.push(first),
        Some(_) => {}
    }
    let key = |pair: &[P]| edge_key(&arc.normal, Some([pair[0].clone(), pair[1].clone()]));
    stops.windows(2).map(key).collect()
}

impl Graph {
    pub(crate) fn new(curves: &[Curve]) -> Self {
        let arcs: Vec<Arc> = curves.iter().map(Curve::arc).collect();
        let real = vertices_of(&arcs);
        let along = arcs.iter().filter(|arc| !arc.is_point()).flat_map(|arc| edges_along(arc, &real));
        let all: BTreeSet<EdgeKey> = along.collect();
        let mut vertices: Vec<P> = real.into_iter().collect();
        let (mut edges, mut ends, mut keys) = (Vec::new(), Vec::new(), BTreeMap::new());
        let mut has_free_circle = false;
        for key in all {
            let mut arc = Arc { normal: key.0.clone(), ends: key.1.clone() };
            let numbers = match &key.1 {
                Some(points) => {
                    let number = |p: &P| vertices.binary_search(p).expect("ends are vertices");
                    points.each_ref().map(number)
                }
                None => {
                    assert!(!has_free_circle, "two circles cross");
                    has_free_circle = true;
                    [usize::MAX; 2]
                }
            };
            arc.ends.get_or_insert_with(|| [(); 2].map(|()| crate::space::orthogonal(&key.0)));
            keys.insert(key, edges.len());
            edges.push(arc);
            ends.push(numbers);
        }
        if let Some(free) = ends.iter().position(|ends| *ends == [usize::MAX; 2]) {
            ends[free] = [vertices.len(); 2];
            vertices.push(edges[free].start());
        }
        let mut graph = Self {
            around: vec![Vec::new(); vertices.len()],
            boundaries: vec![usize::MAX; 2 * edges.len()],
            vertices,
            edges,
            keys,
            ends,
            has_free_circle,
            isolated: BTreeMap::new(),
            faces: Vec::new(),
            counts: Counts::default(),
        };
        graph.sort_around();
        graph.find_boundaries();
        graph.find_faces();
        graph
    }

    pub(crate) fn source(&self, dart: usize) -> usize {
        self.ends[dart / 2][dart % 2]
    }

    /// Where a dart goes when it leaves its source.
    pub(crate) fn tangent(&self, dart: usize) -> P {
        let forward = cross(&self.edges[dart / 2].normal, &self.vertices[self.source(dart)]);
        if dart.is_multiple_of(2) { forward } else { opposite(&forward) }
    }

    fn sort_around(&mut self) {
        for dart in 0..self.boundaries.len() {
            let source = self.source(dart);
            self.around[source].push(dart);
        }
        for v in 0..self.vertices.len() {
            let mut darts: Vec<(usize, P)> =
                self.around[v].iter().map(|&dart| (dart, self.tangent(dart))).collect();
            let Some((_, start)) = darts.first().cloned() else { continue };
            let axis = &self.vertices[v];
            darts.sort_by(|(_, a), (_, b)| compare_way(axis, &start, a, b));
            for pair in darts.windows(2) {
                assert!(compare_way(axis, &start, &pair[0].1, &pair[1].1).is_lt(), "edges do not overlap");
            }
            self.around[v] = darts.into_iter().map(|(dart, _)| dart).collect();
        }
    }

    /// The dart that follows on the boundary of the face on the left: the next clockwise after the one back.
    pub(crate) fn next(&self, dart: usize) -> usize {
        let around = &self.around[self.source(dart ^ 1)];
        let back = around.iter().position(|&other| other == dart ^ 1).expect("a dart leaves its source");
        around[(back + around.len() - 1) % around.len()]
    }

    fn find_boundaries(&mut self) {
        let mut count = 0;
        for start in 0..self.boundaries.len() {
            if self.boundaries[start] != usize::MAX {
                continue;
            }
            let mut dart = start;
            while self.boundaries[dart] == usize::MAX {
                self.boundaries[dart] = count;
                dart = self.next(dart);
            }
            count += 1;
        }
        for v in (0..self.vertices.len()).filter(|&v| self.around[v].is_empty()) {
            self.isolated.insert(v, count);
            count += 1;
        }
        self.faces = (0..count).collect();
    }

    /// A vertex of each component.
    fn components(&self) -> Vec<usize> {
        let mut is_seen = vec![false; self.vertices.len()];
        let mut firsts = Vec::new();
        for first in 0..self.vertices.len() {
            if std::mem::replace(&mut is_seen[first], true) {
                continue;
            }
            firsts.push(first);
            let mut stack = vec![first];
            while let Some(v) = stack.pop() {
                for &dart in &self.around[v] {
                    let w = self.source(dart ^ 1);
                    if !std::mem::replace(&mut is_seen[w], true) {
                        stack.push(w);
                    }
                }
            }
        }
        firsts
    }

    /// Joins boundaries along arcs between components, and numbers the faces. Euler's relation tells how many there have to be.
    fn find_faces(&mut self) {
        let firsts = self.components();
        for &v in firsts.iter().skip(1) {
            for [a, b] in self.faces_along(&self.arc_between(v, firsts[0])) {
                let [kept, gone] = [self.faces[a], self.faces[b]];
                for face in self.faces.iter_mut().filter(|face| **face == gone) {
                    *face = kept;
                }
            }
        }
        let used: BTreeSet<usize> = self.faces.iter().copied().collect();
        let numbers: BTreeMap<usize, usize> = used.into_iter().zip(0..).collect();
        for face in &mut self.faces {
            *face = numbers[face];
        }
        let (v, e, c) = (self.vertices.len(), self.edges.len(), firsts.len());
        self.counts = Counts {
            vertices: v,
            edges: e,
            faces: e + c + 1 - v,
            isolated: self.isolated.len(),
            components: c,
        };
        assert_eq!(numbers.len().max(1), self.counts.faces, "Euler's relation");
    }
}
