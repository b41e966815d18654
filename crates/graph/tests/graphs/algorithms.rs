//! Algorithms of `petgraph` against counts of the arrangement and against brute force.

use crate::cases::{Bounded, Case, Point2, Torus, Unbounded, cases, line, segment};
use arrangement::models::{LinearTraits, SegmentTraits, TorusSegmentTraits};
use arrangement::topology::{BoundedPlane, FlatTorus, UnboundedPlane};
use dcel::{EdgeMap, HalfedgeMap, VertexId};
use petgraph::algo::{
    astar, connected_components, dijkstra, floyd_warshall, has_path_connecting, is_cyclic_directed,
    is_isomorphic, kosaraju_scc, min_spanning_tree, tarjan_scc, toposort,
};
use petgraph::data::Element;
use petgraph::visit::{
    Bfs, Dfs, EdgeRef, IntoNeighbors, IntoNodeIdentifiers, NodeCount, NodeFiltered, NodeIndexable, Reversed,
    Visitable,
};
use splitstar_graph::{Numbered, Primal};
use std::collections::{BTreeMap, VecDeque};
use testkit::Rng;

/// The edges of which both ends are at infinity: components of an arrangement without a vertex.
fn free_lines(case: &dyn Case) -> usize {
    let dcel = case.dcel();
    dcel.edges().filter(|&e| dcel.ends(e).into_iter().all(|v| case.is_at_infinity(v))).count()
}

/// The number of searches that visit all nodes.
fn searches<G>(graph: G, mut visit: impl FnMut(G::NodeId) -> Vec<G::NodeId>) -> usize
where
    G: IntoNodeIdentifiers + NodeIndexable + Visitable,
{
    let mut is_seen = vec![false; graph.node_bound()];
    let mut count = 0;
    for node in graph.node_identifiers() {
        if is_seen[graph.to_index(node)] {
            continue;
        }
        count += 1;
        for other in visit(node) {
            assert!(!std::mem::replace(&mut is_seen[graph.to_index(other)], true), "visited once");
        }
    }
    count
}

#[test]
fn components_are_those_of_the_counts() {
    for (name, case) in cases(3, 200) {
        let (stored, graph) = (case.stored(), case.primal());
        let expected = stored.components - free_lines(&*case);
        assert_eq!(connected_components(&Numbered::new(graph)), expected, "{name}");
        let bfs = |v| {
            let mut bfs = Bfs::new(graph, v);
            std::iter::from_fn(|| bfs.next(graph)).collect()
        };
        assert_eq!(searches(graph, bfs), expected, "{name}");
        let dfs = |v| {
            let mut dfs = Dfs::new(graph, v);
            std::iter::from_fn(|| dfs.next(graph)).collect()
        };
        assert_eq!(searches(graph, dfs), expected, "{name}");
        assert_eq!(tarjan_scc(graph.directed()).len(), expected, "{name}");
        assert_eq!(kosaraju_scc(graph.directed()).len(), expected, "{name}");

        let whole = Numbered::new(graph.with_infinity());
        assert_eq!(connected_components(&whole), case.dcel().component_count(), "{name}");
        assert_eq!(connected_components(&Numbered::new(case.dual())), 1, "{name}");
        assert_eq!((graph.node_count(), case.dual().node_count()), (stored.vertices, stored.faces), "{name}");
        if case.genus() == 0 {
            let [v, e, f] = [whole.node_count(), case.dcel().edge_count(), case.dual().node_count()];
            assert_eq!(v + f, 1 + e + connected_components(&whole), "{name}: Euler");
        }
    }
}

/// Lengths of shortest ways, by relaxing all edges until nothing changes.
fn brute_force(case: &dyn Case, from: VertexId, lengths: &HalfedgeMap<u64>) -> BTreeMap<VertexId, u64> {
    let dcel = case.dcel();
    let mut known = BTreeMap::from([(from, 0)]);
    loop {
        let mut has_changed = false;
        for h in dcel.halfedges() {
            let (Some(&at), target) = (known.get(&dcel.source(h)), dcel.target(h)) else { continue };
            let length = at + lengths[h];
            if !case.is_at_infinity(target) && known.get(&target).is_none_or(|&other| length < other) {
                known.insert(target, length);
                has_changed = true;
            }
        }
        if !has_changed {
            return known;
        }
    }
}

#[test]
fn shortest_ways_have_the_lengths_of_brute_force() {
    let mut rng = Rng::new(4);
    let mut ways = 0;
    for (name, case) in cases(4, 120) {
        let dcel = case.dcel();
        let Some(from) = dcel.vertices().find(|&v| !case.is_at_infinity(v)) else { continue };
        let edge_lengths = EdgeMap::from_fn(dcel, |_| rng.below(20));
        let same = HalfedgeMap::from_fn(dcel, |h| edge_lengths[h.edge_id()]);
        let graph = case.primal().with_edge_weights(|e| edge_lengths[e]);
        let found: BTreeMap<_, _> = dijkstra(graph, from, None, |edge| *edge.weight()).into_iter().collect();
        assert_eq!(found, brute_force(&*case, from, &same), "{name}");

        // The weights of the two directions differ, and are given by reference.
        let lengths = HalfedgeMap::from_fn(dcel, |_| rng.below(20));
        let graph = case.primal().directed().with_edge_weights(|h| &lengths[h]);
        let found: BTreeMap<_, _> = dijkstra(graph, from, None, |edge| **edge.weight()).into_iter().collect();
        assert_eq!(found, brute_force(&*case, from, &lengths), "{name}");
        let reversed = HalfedgeMap::from_fn(dcel, |h| lengths[h.twin()]);
        let back: BTreeMap<_, _> =
            dijkstra(Reversed(graph), from, None, |edge| **edge.weight()).into_iter().collect();
        assert_eq!(back, brute_force(&*case, from, &reversed), "{name}");

        for (&to, &length) in found.iter().take(3) {
            let (cost, path) =
                astar(graph, from, |v| v == to, |edge| **edge.weight(), |_| 0).expect("it is reached");
            assert_eq!((cost, path.last()), (length, Some(&to)), "{name}");
            assert!(has_path_connecting(graph, from, to, None), "{name}");
            ways += path.len();
        }
        let numbered = Numbered::new(graph);
        let all = floyd_warshall(&numbered, |edge| **edge.weight()).expect("no length is negative");
        assert!(found.iter().all(|(&to, length)| all[&(from, to)] == *length), "{name}");
    }
    assert!(ways > 300, "{ways}");
}

#[test]
fn spanning_trees_are_of_least_weight() {
    let mut rng = Rng::new(5);
    for (name, case) in cases(5, 120) {
        let dcel = case.dcel();
        let weights = EdgeMap::from_fn(dcel, |_| rng.below(50));
        let graph = case.primal().with_edge_weights(|e| weights[e]);
        let (mut nodes, mut edges, mut weight) = (Vec::new(), 0, 0);
        for element in min_spanning_tree(graph) {
            match element {
                Element::Node { weight } => nodes.push(weight),
                Element::Edge { weight: one, .. } => (edges, weight) = (edges + 1, weight + one),
            }
        }
        assert!(nodes.into_iter().eq(graph.node_identifiers()), "{name}");
        assert_eq!(edges, graph.node_count() - connected_components(&Numbered::new(graph)), "{name}");
        // From each vertex the lightest edge that leads out of what is reached, again and again.
        let mut is_reached = vec![false; dcel.vertex_bound()];
        let mut expected = 0;
        for seed in graph.node_identifiers() {
            is_reached[seed.index()] = true;
            let leads_out = |h: &dcel::HalfedgeId, is_reached: &[bool]| {
                let [v, w] = [dcel.source(*h), dcel.target(*h)];
                is_reached[v.index()] && !is_reached[w.index()] && !case.is_at_infinity(w)
            };
            while let Some(h) =
                dcel.halfedges().filter(|h| leads_out(h, &is_reached)).min_by_key(|h| weights[h.edge_id()])
            {
                is_reached[dcel.target(h).index()] = true;
                expected += weights[h.edge_id()];
            }
        }
        assert_eq!(weight, expected, "{name}");
    }
}

#[test]
fn distances_between_faces_are_the_edges_crossed() {
    for (name, case) in cases(6, 120) {
        let (dcel, dual) = (case.dcel(), case.dual());
        let from = case.corner_face();
        let mut expected = BTreeMap::from([(from, 0)]);
        let mut queue = VecDeque::from([from]);
        while let Some(f) = queue.pop_front() {
            for h in dcel.halfedges().filter(|&h| dcel.face(h) == f) {
                let next = dcel.face(h.twin());
                if !expected.contains_key(&next) {
                    expected.insert(next, expected[&f] + 1);
                    queue.push_back(next);
                }
            }
        }
        let found: BTreeMap<_, _> = dijkstra(dual, from, None, |_| 1).into_iter().collect();
        assert_eq!(found, expected, "{name}");
        assert_eq!(found.len(), dual.node_count(), "{name}: all are reached");
        // Breadth first, no face is visited before a nearer one.
        let mut bfs = Bfs::new(dual, from);
        let order: Vec<_> = std::iter::from_fn(|| bfs.next(dual)).collect();
        assert!(order.is_sorted_by_key(|f| expected[f]) && order.len() == expected.len(), "{name}");
    }
}

#[test]
fn ascending_edges_of_the_plane_have_a_topological_order() {
    for (name, case) in cases(7, 160) {
        let (dcel, graph) = (case.dcel(), case.primal().ascending());
        if case.genus() == 0 {
            let order = toposort(graph, None).expect("edges ascend");
            assert_eq!(order.len(), graph.node_count(), "{name}");
            let mut place = vec![usize::MAX; dcel.vertex_bound()];
            for (i, v) in order.into_iter().enumerate() {
                place[v.index()] = i;
            }
            let inside = dcel
                .edges()
                .map(|e| dcel.ends(e))
                .filter(|ends| !ends.iter().any(|&v| case.is_at_infinity(v)));
            assert!(inside.into_iter().all(|[min, max]| place[min.index()] < place[max.index()]), "{name}");
            let has_edge = graph.node_identifiers().any(|v| graph.neighbors(v).next().is_some());
            assert_eq!(toposort(case.primal().directed(), None).is_err(), has_edge, "{name}: there and back");
            assert_eq!(is_cyclic_directed(case.primal().directed()), has_edge, "{name}");
        }
    }
    // With infinity, or round a torus, one comes back.
    let one = Unbounded::of_curves(LinearTraits, UnboundedPlane, &[line([[0, 0], [1, 0]])]);
    assert!(toposort(Primal::new(&one).with_infinity().ascending(), None).is_err());
    let traits = TorusSegmentTraits::new([4.into(), 4.into()]).expect("the periods are positive");
    let around = traits.closed_path(&Point2::from_i64([1, 1]), [1, 0]).expect("it is short");
    let torus = Torus::of_curves(traits, FlatTorus, &[around]);
    assert!(toposort(Primal::new(&torus).ascending(), None).is_err());
}

#[test]
fn nodes_can_be_filtered() {
    // A cross; without its middle it falls in four.
    let cross = [segment([[0, 1], [2, 1]]), segment([[1, 0], [1, 2]])];
    let cross = Bounded::of_curves(SegmentTraits, BoundedPlane, &cross);
    let graph = Primal::new(&cross);
    let ends = NodeFiltered::from_fn(graph, |v| cross.dcel().degree(v) == 1);
    assert_eq!((&ends).node_identifiers().count(), 4);
    assert!((&ends).node_identifiers().all(|v| (&ends).neighbors(v).next().is_none()));
    // A property of vertices as their weight.
    let degrees = graph.with_node_weights(|v| cross.dcel().degree(v));
    let nodes = min_spanning_tree(degrees).filter_map(|element| match element {
        Element::Node { weight } => Some(weight),
        Element::Edge { .. } => None,
    });
    assert_eq!(nodes.max(), Some(4));
}

#[test]
fn graphs_are_isomorphic_or_not() {
    let triangle = |[x, y]: [i64; 2]| {
        let sides = [[[x, y], [x + 3, y]], [[x + 3, y], [x, y + 3]], [[x, y + 3], [x, y]]].map(segment);
        Bounded::of_curves(SegmentTraits, BoundedPlane, &sides)
    };
    let (one, other) = (triangle([0, 0]), triangle([7, -2]));
    let path = [segment([[0, 0], [1, 0]]), segment([[1, 0], [2, 1]]), segment([[2, 1], [3, 0]])];
    let path = Bounded::of_curves(SegmentTraits, BoundedPlane, &path);
    let [one, other, path] = [&one, &other, &path].map(|arrangement| Numbered::new(Primal::new(arrangement)));
    assert!(is_isomorphic(&&one, &&other));
    assert!(!is_isomorphic(&&one, &&path));
}
