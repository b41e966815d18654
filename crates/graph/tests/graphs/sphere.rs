//! Graphs of arrangements on a sphere: a pole where nothing is, is no node, and no vertex is at infinity.

use arrangement::models::{Geodesic, GeodesicTraits};
use arrangement::topology::Sphere;
use arrangement::traits::BasicTraits;
use arrangement::{Arrangement, Editor};
use dcel::{EdgeMap, VertexId};
use petgraph::algo::{connected_components, kosaraju_scc, min_spanning_tree};
use petgraph::data::Element;
use petgraph::visit::{
    EdgeCount, EdgeRef, IntoEdgeReferences, IntoEdges, IntoNeighbors, IntoNodeIdentifiers, NodeCount,
    NodeIndexable,
};
use splitstar_graph::{Dual, Numbered, Primal};
use testkit::Rng;

type Direction = <GeodesicTraits as BasicTraits>::Point;
type Globe = Arrangement<GeodesicTraits, Sphere>;

const POLES: [VertexId; 2] = [VertexId(0), VertexId(1)];

fn at(p: [i64; 3]) -> Direction {
    Direction::from_i64(p).expect("a direction is not zero")
}

/// Checks the graph and its dual; tells how many poles are no nodes.
fn check(globe: &Globe, context: &str) -> usize {
    assert_eq!(globe.check_valid(), [], "{context}");
    let stored = globe.counts_with_splits();
    let (primal, dual) = (Primal::new(globe), Dual::new(globe));
    assert_eq!((primal.node_count(), primal.edge_count()), (stored.vertices, stored.edges), "{context}");
    assert_eq!(kosaraju_scc(primal).len(), stored.components, "{context}");
    assert_eq!((dual.node_count(), dual.edge_count()), (stored.faces, stored.edges), "{context}");
    assert_eq!(kosaraju_scc(dual).len(), 1, "{context}");
    check_with_infinity(globe, context);
    POLES.into_iter().filter(|&pole| globe.is_absent(pole)).count()
}

/// No side of a sphere is open, so that there is nothing at infinity: nodes and edges are the same with it.
fn check_with_infinity(globe: &Globe, context: &str) {
    let (without, with) = (Primal::new(globe), Primal::new(globe).with_infinity());
    assert_eq!(with.node_count(), without.node_count(), "{context}");
    assert_eq!(with.edge_count(), without.edge_count(), "{context}");
    assert_eq!(with.node_bound(), without.node_bound(), "{context}");
    let nodes: Vec<VertexId> = with.node_identifiers().collect();
    assert!(without.node_identifiers().eq(nodes.iter().copied()), "{context}");
    assert!(globe.vertices().eq(nodes.iter().copied()), "{context}");
    let ids = |graph: Primal<'_>| graph.edge_references().map(|edge| edge.id()).collect::<Vec<_>>();
    assert_eq!(ids(with), ids(without), "{context}");
    assert!(globe.dcel().edges().eq(ids(with)), "{context}");
    for v in globe.dcel().vertices() {
        assert!(with.neighbors(v).eq(without.neighbors(v)), "{context}: {v:?}");
        assert_eq!(with.edges(v).count(), with.neighbors(v).count(), "{context}: {v:?}");
        assert!(!globe.is_at_infinity(v), "{context}: {v:?}");
    }
    for pole in POLES {
        let is_node = nodes.contains(&pole);
        assert_eq!(is_node, !globe.is_absent(pole), "{context}: {pole:?}");
        assert!(is_node || with.neighbors(pole).next().is_none(), "{context}: {pole:?}");
    }
    assert_eq!(
        connected_components(&Numbered::new(with)),
        globe.counts_with_splits().components,
        "{context}"
    );
    check_forests(globe, with, context);
}

/// The edges that a least spanning forest leaves out are a greatest spanning tree of the dual.
fn check_forests(globe: &Globe, primal: Primal<'_>, context: &str) {
    let weights = EdgeMap::from_fn(globe.dcel(), |e| i64::from(e.0.wrapping_mul(0x9E37_79B9) >> 20));
    let primal = primal.with_edge_weights(|e| weights[e]);
    let dual = Dual::new(globe).with_edge_weights(|e| -weights[e]);
    let all: i64 = globe.dcel().edges().map(|e| weights[e]).sum();
    let sum = |weights: Vec<i64>| (weights.iter().sum::<i64>(), weights.len());
    let (least, in_primal) = sum(weights_of(min_spanning_tree(primal)));
    let (greatest, in_dual) = sum(weights_of(min_spanning_tree(dual)));
    assert_eq!(in_primal + in_dual, globe.dcel().edge_count(), "{context}");
    assert_eq!(least - greatest, all, "{context}");
}

fn weights_of<N>(elements: impl Iterator<Item = Element<N, i64>>) -> Vec<i64> {
    let weight = |element| match element {
        Element::Edge { weight, .. } => Some(weight),
        Element::Node { .. } => None,
    };
    elements.filter_map(weight).collect()
}

fn check_curves(curves: &[Geodesic], context: &str) -> usize {
    check(&Globe::of_curves(GeodesicTraits::new(), Sphere, curves), context)
}

#[test]
fn arcs_on_a_sphere() {
    let [north, south] = [[0, 0, 1], [0, 0, -1]].map(at);
    let meridian =
        Geodesic::arc_via(south.clone(), &at([1, 2, 0]), north.clone()).expect("it is half a circle");
    let through = Geodesic::arc(at([1, 0, 1]), at([-1, 0, 1])).expect("it is short");
    assert_eq!(check_curves(&[], "nothing"), 2);
    assert_eq!(check_curves(&[Geodesic::point(north)], "a pole"), 1);
    assert_eq!(check_curves(&[meridian], "a meridian"), 0);
    assert_eq!(check_curves(&[through], "through a pole"), 1);
}

fn random_direction(rng: &mut Rng) -> Direction {
    loop {
        if let Some(p) = Direction::from_i64([0; 3].map(|_| rng.within(2))) {
            return p;
        }
    }
}

fn random_curve(rng: &mut Rng) -> Geodesic {
    let (p, q) = (random_direction(rng), random_direction(rng));
    if rng.one_in(4) {
        return Geodesic::point(p);
    }
    Geodesic::arc(p.clone(), q).unwrap_or_else(|_| Geodesic::point(p))
}

#[test]
fn random_arcs_on_a_sphere() {
    println!("seed 91");
    let mut rng = Rng::new(91);
    let mut absent = [0; 3];
    for case in 0..200 {
        let curves: Vec<Geodesic> = (0..case % 12).map(|_| random_curve(&mut rng)).collect();
        absent[check_curves(&curves, &format!("case {case}: {curves:?}"))] += 1;
    }
    assert!(absent.iter().all(|&count| count > 10), "{absent:?}");
}

/// Poles become nodes and are none again, and ids have gaps.
#[test]
fn nodes_at_poles_come_and_go() {
    println!("seed 92");
    let mut rng = Rng::new(92);
    let mut changes = 0;
    for case in 0..30 {
        let mut editor = Editor::new(Globe::new(GeodesicTraits::new(), Sphere));
        let mut absent = 2;
        for step in 0..20 {
            let edges: Vec<_> = editor.dcel().edges().collect();
            let vertices: Vec<_> = editor.vertices().collect();
            match rng.below(5) {
                0 if !edges.is_empty() => {
                    editor.remove_edge(*rng.choose(&edges));
                }
                1 if !vertices.is_empty() => {
                    let v = *rng.choose(&vertices);
                    editor.remove_vertex_with_edges(v).expect("it is there");
                }
                2 => {
                    editor.insert_point(&at([0, 0, if rng.one_in(2) { 1 } else { -1 }]));
                }
                _ => {
                    editor.insert_curve(&random_curve(&mut rng));
                }
            }
            let now = check(&editor, &format!("case {case}, step {step}"));
            changes += usize::from(now != absent);
            absent = now;
        }
    }
    assert!(changes > 30, "{changes}");
}
