//! The cells of an arrangement against those that brute force found: which is which, if they are the same.

use crate::graph::{Graph, Place, edge_key};
use crate::own::{Globe, coordinates, normal_of};
use crate::space::{P, is_pole, north, opposite};
use dcel::{HalfedgeId, VertexId};
use splitstar_arrangement::UserView;
use splitstar_arrangement::models::GeodesicTraits;
use splitstar_arrangement::overlay::Cell;
use splitstar_arrangement::topology::Sphere;
use std::collections::BTreeMap;

/// For each cell of an arrangement, the one that it is.
pub(crate) struct Matching<'a> {
    view: UserView<'a, GeodesicTraits, Sphere>,
    vertices: BTreeMap<VertexId, usize>,
    /// For each edge of the user's view.
    edges: Vec<usize>,
    faces: Vec<usize>,
}

const NONE: usize = usize::MAX;

impl<'a> Matching<'a> {
    /// Finds it, and panics if there is none: vertices are the same points, edges the same arcs, in the same order around vertices, and
    /// faces have the same boundaries.
    pub(crate) fn new(graph: &Graph, globe: &'a Globe, context: &str) -> Self {
        let view = globe.user_view();
        assert_eq!(globe.counts(), graph.counts, "{context}");
        let mut vertices = BTreeMap::new();
        let mut is_met = vec![false; graph.vertices.len()];
        for v in view.vertices() {
            let p = coordinates(globe, v);
            let real = graph.vertices.len() - usize::from(graph.has_free_circle);
            let found = match globe.is_artificial(v) {
                true => Some(real).filter(|_| graph.has_free_circle),
                false => graph.vertices[..real].binary_search(&p).ok(),
            };
            let found = found.unwrap_or_else(|| panic!("{context}: no vertex at {p:?}"));
            assert!(!std::mem::replace(&mut is_met[found], true), "{context}: two vertices at {p:?}");
            vertices.insert(v, found);
        }
        let mut dart_of = vec![NONE; globe.dcel().halfedge_bound()];
        let mut edges = vec![NONE; view.edge_count()];
        for edge in view.edges() {
            let [first, last] = view.end_halfedges(edge);
            let dart = dart(graph, globe, first, &vertices, &view, context);
            edges[edge.index()] = dart / 2;
            (dart_of[first.index()], dart_of[last.index()]) = (dart, dart ^ 1);
        }
        let mut matching = Self { view, vertices, edges, faces: vec![NONE; globe.dcel().face_bound()] };
        matching.check_around(graph, globe, &dart_of, context);
        matching.match_faces(graph, globe, &dart_of, context);
        check_poles(graph, globe, context);
        matching
    }

    fn check_around(&self, graph: &Graph, globe: &Globe, dart_of: &[usize], context: &str) {
        for (&v, &found) in &self.vertices {
            let mut around: Vec<usize> = globe.dcel().around(v).map(|h| dart_of[h.index()]).collect();
            let expected = &graph.around[found];
            let start = expected.first().and_then(|first| around.iter().position(|dart| dart == first));
            around.rotate_left(start.unwrap_or(0));
            assert_eq!(around, *expected, "{context}: around {:?}", graph.vertices[found]);
        }
    }

    fn match_faces(&mut self, graph: &Graph, globe: &Globe, dart_of: &[usize], context: &str) {
        let dcel = globe.dcel();
        let mut pairs = Vec::new();
        for h in dcel.halfedges().filter(|h| dart_of[h.index()] != NONE) {
            pairs.push((dcel.face(h), graph.faces[graph.boundaries[dart_of[h.index()]]]));
        }
        for (&v, found) in &self.vertices {
            let isolated = graph.isolated.get(found).map(|&boundary| graph.faces[boundary]);
            assert_eq!(dcel.isolated_face(v).is_some(), isolated.is_some(), "{context}");
            pairs.extend(dcel.isolated_face(v).zip(isolated));
        }
        if pairs.is_empty() {
            pairs.push((globe.corner_face(), 0));
        }
        let mut back = vec![None; graph.counts.faces];
        for (f, found) in pairs {
            let known = &mut self.faces[f.index()];
            assert!(*known == NONE || *known == found, "{context}: face {f:?} is two");
            *known = found;
            assert_eq!(*back[found].get_or_insert(f), f, "{context}: one face is two");
        }
        assert!(dcel.faces().all(|f| self.faces[f.index()] != NONE), "{context}: a face without a boundary");
    }

    /// The place that a cell is; artificial vertices are of their edges.
    pub(crate) fn place(&self, cell: Cell) -> Place {
        match cell {
            Cell::Vertex(v) => match self.vertices.get(&v) {
                Some(&found) if !self.view.arrangement().is_artificial(v) => Place::Vertex(found),
                _ => {
                    let globe = self.view.arrangement();
                    assert!(globe.is_artificial(v), "no cell: {v:?}");
                    let h = globe.dcel().outgoing(v).expect("an artificial vertex has edges");
                    self.place(Cell::Edge(h.edge_id()))
                }
            },
            Cell::Edge(e) => Place::Edge(self.edges[self.view.edge_of(e).index()]),
            Cell::Face(f) => Place::Face(self.faces[f.index()]),
        }
    }
}

/// The dart along which an edge of the user's view leaves a vertex.
fn dart(
    graph: &Graph,
    globe: &Globe,
    first: HalfedgeId,
    vertices: &BTreeMap<VertexId, usize>,
    view: &UserView<'_, GeodesicTraits, Sphere>,
    context: &str,
) -> usize {
    let normal_along = |h: HalfedgeId| {
        let normal = normal_of(globe.curve_of(h.edge_id()));
        if h.is_even() { normal } else { opposite(&normal) }
    };
    let normal = normal_along(first);
    let mut last = first;
    for h in view.chain(first) {
        assert_eq!(normal_along(h), normal, "{context}: an edge is on one circle");
        last = h;
    }
    let ends = [globe.dcel().source(first), globe.dcel().target(last)];
    let is_free = globe.is_artificial(ends[0]);
    let points: [P; 2] = ends.map(|v| graph.vertices[vertices[&v]].clone());
    let key = edge_key(&normal, (!is_free).then_some(points));
    let e = *graph.keys.get(&key).unwrap_or_else(|| panic!("{context}: no edge {key:?}"));
    2 * e + usize::from(key.0 != normal)
}

/// A pole is a vertex if something is there.
fn check_poles(graph: &Graph, globe: &Globe, context: &str) {
    for (v, pole) in [(VertexId(0), opposite(&north())), (VertexId(1), north())] {
        assert_eq!(coordinates(globe, v), pole, "{context}");
        let is_met = graph.vertices.contains(&pole) || graph.edges.iter().any(|edge| edge.has(&pole));
        assert_eq!(globe.is_absent(v), !is_met, "{context}: the pole {pole:?}");
        assert_eq!(globe.vertices().any(|other| other == v), is_met, "{context}: the pole {pole:?}");
    }
    assert!(
        globe.vertices().all(|v| v.0 < 2 || !is_pole(&coordinates(globe, v))),
        "{context}: poles are 0 and 1"
    );
}
