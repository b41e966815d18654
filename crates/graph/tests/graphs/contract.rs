//! The visit traits, against a copy of the cells in a graph of `petgraph` that is made from the halfedges alone.

use crate::cases::{Case, cases};
use dcel::{EdgeId, HalfedgeId};
use petgraph::graph::{Graph, NodeIndex};
use petgraph::visit::{
    EdgeCount, EdgeRef, GetAdjacencyMatrix, GraphProp, IntoEdgeReferences, IntoEdges, IntoEdgesDirected,
    IntoNeighborsDirected, IntoNodeIdentifiers, IntoNodeReferences, NodeCount, NodeIndexable, NodeRef,
    VisitMap, Visitable,
};
use petgraph::{Directed, Direction, EdgeType, Undirected};
use splitstar_graph::{CellGraph, Cells, Numbered, Way};
use std::collections::BTreeMap;
use std::fmt::Debug;

const DIRECTIONS: [Direction; 2] = [Direction::Outgoing, Direction::Incoming];

/// A node or an edge by the number of its id.
trait Id: Copy + Ord + Debug {
    fn number(self) -> u32;
}

impl Id for EdgeId {
    fn number(self) -> u32 {
        self.0
    }
}

impl Id for HalfedgeId {
    fn number(self) -> u32 {
        self.0
    }
}

/// Compares the graph with a copy, all of it. `nodes` are the numbers of its nodes, `edges` ends and numbers of its edges.
fn compare<C: Cells, D: Way, Ty: EdgeType>(
    name: &str,
    graph: CellGraph<'_, C, D>,
    nodes: &[u32],
    edges: &[([u32; 2], u32)],
) where
    D::EdgeId: Id,
{
    let mut copy = Graph::<u32, u32, Ty>::with_capacity(0, 0);
    let places: BTreeMap<u32, NodeIndex> = nodes.iter().map(|&n| (n, copy.add_node(n))).collect();
    for &([from, to], id) in edges {
        copy.add_edge(places[&from], places[&to], id);
    }
    let number = |node: C::Id| graph.to_index(node) as u32;
    fn sorted<T: Ord>(items: impl Iterator<Item = T>) -> Vec<T> {
        let mut items: Vec<T> = items.collect();
        items.sort();
        items
    }

    assert_eq!(graph.is_directed(), copy.is_directed(), "{name}");
    assert_eq!((graph.node_count(), graph.edge_count()), (copy.node_count(), copy.edge_count()), "{name}");
    assert!(graph.node_identifiers().map(number).eq(nodes.iter().copied()), "{name}");
    assert!(graph.node_references().all(|node| *node.weight() == node.id()), "{name}");
    assert_eq!(graph.node_references().count(), nodes.len(), "{name}");
    let all = graph.edge_references().map(|e| ([number(e.source()), number(e.target())], e.id().number()));
    assert_eq!(sorted(all), sorted(edges.iter().copied()), "{name}");
    assert!(graph.edge_references().all(|e| *e.weight() == e.id()), "{name}");
    let is_below = |id: D::EdgeId| {
        use petgraph::visit::EdgeIndexable;
        let i = EdgeIndexable::to_index(&graph, id);
        i < graph.edge_bound() && EdgeIndexable::from_index(&graph, i) == id
    };
    assert!(graph.edge_references().all(|e| is_below(e.id())), "{name}");

    let matrix = graph.adjacency_matrix();
    let copied_matrix = copy.adjacency_matrix();
    let numbered = Numbered::new(graph);
    assert_eq!((numbered.node_count(), numbered.node_bound()), (nodes.len(), nodes.len()), "{name}");
    for (place, node) in graph.node_identifiers().enumerate() {
        let copied = places[&number(node)];
        assert_eq!(
            (graph.from_index(graph.to_index(node)), graph.to_index(node) < graph.node_bound()),
            (node, true)
        );
        assert_eq!(
            (NodeIndexable::to_index(&numbered, node), NodeIndexable::from_index(&numbered, place)),
            (place, node)
        );
        for direction in DIRECTIONS {
            let neighbors = sorted(graph.neighbors_directed(node, direction).map(number));
            let expected = sorted(copy.neighbors_directed(copied, direction).map(|n| copy[n]));
            assert_eq!(neighbors, expected, "{name} {node:?} {direction:?}");
            let found = graph.edges_directed(node, direction);
            let found = sorted(found.map(|e| (number(e.source()), number(e.target()), e.id().number())));
            let edges = copy.edges_directed(copied, direction);
            let expected = sorted(edges.map(|e| (copy[e.source()], copy[e.target()], *e.weight())));
            assert_eq!(found, expected, "{name} {node:?} {direction:?}");
        }
        assert!(graph.edges(node).all(|e| e.source() == node), "{name}");
        for other in graph.node_identifiers() {
            let is_adjacent = graph.is_adjacent(&matrix, node, other);
            assert_eq!(
                is_adjacent,
                copy.is_adjacent(&copied_matrix, copied, places[&number(other)]),
                "{name}"
            );
        }
    }

    let mut map = graph.visit_map();
    for node in graph.node_identifiers() {
        assert!(
            !map.is_visited(&node) && map.visit(node) && map.is_visited(&node) && !map.visit(node),
            "{name}"
        );
    }
    assert!(graph.node_identifiers().take(1).all(|node| map.unvisit(node) && !map.unvisit(node)), "{name}");
    graph.reset_map(&mut map);
    assert!(graph.node_identifiers().all(|node| !map.is_visited(&node)), "{name}");
}

fn check(name: &str, case: &dyn Case) {
    let dcel = case.dcel();
    let both = |e: EdgeId| [e.halfedge(), e.halfedge().twin()];
    for has_infinity in [false, true] {
        let is_node = |v| has_infinity || !case.is_at_infinity(v);
        let vertices: Vec<u32> = dcel.vertices().filter(|&v| is_node(v)).map(|v| v.0).collect();
        let inside = |e: &EdgeId| dcel.ends(*e).into_iter().all(is_node);
        let arc = |h: HalfedgeId| [dcel.source(h).0, dcel.target(h).0];
        let edges: Vec<_> = dcel.edges().filter(inside).map(|e| (arc(e.halfedge()), e.0)).collect();
        let halfedges: Vec<_> = dcel.edges().filter(inside).flat_map(both).map(|h| (arc(h), h.0)).collect();
        let plain = case.primal();
        let graph = if has_infinity { plain.with_infinity() } else { plain };
        compare::<_, _, Undirected>(name, graph, &vertices, &edges);
        compare::<_, _, Directed>(name, graph.directed(), &vertices, &halfedges);
        compare::<_, _, Directed>(name, graph.ascending(), &vertices, &edges);
    }
    let faces: Vec<u32> = dcel.faces().map(|f| f.0).collect();
    let arc = |h: HalfedgeId| [dcel.face(h).0, dcel.face(h.twin()).0];
    let edges: Vec<_> = dcel.edges().map(|e| (arc(e.halfedge()), e.0)).collect();
    let halfedges: Vec<_> = dcel.edges().flat_map(both).map(|h| (arc(h), h.0)).collect();
    compare::<_, _, Undirected>(name, case.dual(), &faces, &edges);
    compare::<_, _, Directed>(name, case.dual().directed(), &faces, &halfedges);
    compare::<_, _, Directed>(name, case.dual().ascending(), &faces, &edges);
}

#[test]
fn every_graph_is_that_of_its_copy() {
    let mut seen = [0; 8];
    for (name, case) in cases(20_261_122, 160) {
        check(&name, &*case);
        for (sum, found) in seen.iter_mut().zip(degeneracies(&*case)) {
            *sum += usize::from(found);
        }
    }
    assert!(seen.iter().all(|&cases| cases >= 2), "{seen:?}");
}

/// Whether there are loops, parallel edges, edges with both ends at infinity, edges with one face, faces with several edges in
/// common, faces with three CCBs, isolated vertices, gaps in the ids.
fn degeneracies(case: &dyn Case) -> [bool; 8] {
    let dcel = case.dcel();
    let is_inside = |e: &EdgeId| !dcel.ends(*e).into_iter().any(|v| case.is_at_infinity(v));
    let has_twice = |mut pairs: Vec<[u32; 2]>| {
        pairs.iter_mut().for_each(|pair| pair.sort_unstable());
        pairs.sort_unstable();
        pairs.windows(2).any(|two| two[0] == two[1])
    };
    let faces = |e: EdgeId| [dcel.face(e.halfedge()).0, dcel.face(e.halfedge().twin()).0];
    [
        dcel.edges().filter(is_inside).any(|e| dcel.ends(e)[0] == dcel.ends(e)[1]),
        has_twice(dcel.edges().filter(is_inside).map(|e| dcel.ends(e).map(|v| v.0)).collect()),
        dcel.edges().any(|e| dcel.ends(e).into_iter().all(|v| case.is_at_infinity(v))),
        dcel.edges().any(|e| faces(e)[0] == faces(e)[1]),
        has_twice(dcel.edges().map(faces).collect()),
        dcel.faces().any(|f| dcel.face_ccbs(f).count() >= 3),
        dcel.vertices().any(|v| dcel.isolated_face(v).is_some() && !case.is_at_infinity(v)),
        dcel.vertex_count() < dcel.vertex_bound() && dcel.face_count() < dcel.face_bound(),
    ]
}

#[test]
fn halfedges_run_along_edges() {
    for (name, case) in cases(1, 40) {
        let dcel = case.dcel();
        let graph = case.primal();
        let runs = |e: splitstar_graph::EdgeReference<_, _, _>| {
            [dcel.source(e.halfedge()), dcel.target(e.halfedge())] == [e.source(), e.target()]
        };
        for v in graph.node_identifiers() {
            let at = |direction| graph.edges_directed(v, direction).all(runs);
            assert!(DIRECTIONS.into_iter().all(at), "{name}");
            // Undirected edges are met as they lie around the vertex.
            let around = dcel.around(v).filter(|&h| !case.is_at_infinity(dcel.target(h)));
            let is_loop = |h: HalfedgeId| dcel.source(h) == dcel.target(h);
            let around = around.filter(|&h| h.is_even() || !is_loop(h));
            assert!(graph.edges(v).map(|e| e.halfedge()).eq(around), "{name}");
        }
        let dual = case.dual();
        for f in dual.node_identifiers() {
            // One CCB after the other, however many there are; from each edge with one face on both sides only one halfedge.
            let along = dcel.face_ccbs(f).flat_map(|ccb| dcel.ccb_cycle(ccb));
            let along: Vec<HalfedgeId> = along.filter(|&h| h.is_even() || dcel.face(h.twin()) != f).collect();
            assert!(dual.edges(f).map(|e| e.halfedge()).eq(along), "{name}");
            let runs = |e: splitstar_graph::EdgeReference<_, _, _>| {
                [dcel.face(e.halfedge()), dcel.face(e.halfedge().twin())] == [e.source(), e.target()]
            };
            assert!(
                DIRECTIONS.into_iter().all(|direction| dual.edges_directed(f, direction).all(runs)),
                "{name}"
            );
        }
    }
}

#[test]
fn cells_that_are_not_there_have_no_edges() {
    use dcel::{FaceId, VertexId};
    for (name, case) in cases(2, 40) {
        let (dcel, primal, dual) = (case.dcel(), case.primal(), case.dual());
        for v in (0..dcel.vertex_bound() as u32 + 3).map(VertexId) {
            if !dcel.has_vertex(v) || case.is_at_infinity(v) {
                assert_eq!(primal.neighbors_directed(v, Direction::Outgoing).count(), 0, "{name}");
                assert_eq!(primal.directed().edges_directed(v, Direction::Incoming).count(), 0, "{name}");
            }
        }
        for f in (0..dcel.face_bound() as u32 + 3).map(FaceId).filter(|&f| !dcel.has_face(f)) {
            assert_eq!((dual.edges(f).count(), dual.directed().edges(f).count()), (0, 0), "{name}");
        }
        let mut map = dual.visit_map();
        let far = FaceId(dcel.face_bound() as u32 + 1000);
        assert!(
            !map.is_visited(&far) && !map.unvisit(far) && map.visit(far) && map.is_visited(&far),
            "{name}"
        );
    }
}
