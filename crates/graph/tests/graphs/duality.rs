//! What the graph and its dual know of each other, and what filters of the dual give.

use crate::cases::{Bounded, Unbounded, bounded, cases, line, lines, segment, segments, thinned, unbounded};
use arrangement::models::{LinearTraits, SegmentTraits};
use arrangement::overlay::{Cell, overlay_all};
use arrangement::topology::{BoundedPlane, UnboundedPlane};
use dcel::{EdgeId, EdgeMap, FaceId};
use petgraph::algo::{
    bridges::bridges, connected_components, dijkstra, is_bipartite_undirected, min_spanning_tree,
};
use petgraph::data::Element;
use petgraph::visit::{EdgeFiltered, EdgeRef, IntoEdgeReferences, NodeCount, NodeIndexable};
use splitstar_graph::{Dual, Numbered, Primal};
use std::collections::BTreeSet;
use testkit::Rng;

/// The weight and the number of edges of a least spanning forest.
fn forest<I, N>(elements: I) -> (i64, usize)
where
    I: Iterator<Item = Element<N, i64>>,
{
    let weights = elements.filter_map(|element| match element {
        Element::Edge { weight, .. } => Some(weight),
        Element::Node { .. } => None,
    });
    weights.fold((0, 0), |(sum, count), weight| (sum + weight, count + 1))
}

#[test]
fn the_rest_of_a_least_spanning_forest_is_a_greatest_spanning_tree_of_the_dual() {
    let mut rng = Rng::new(8);
    for (name, case) in cases(8, 160) {
        if case.genus() != 0 {
            continue;
        }
        let weights = EdgeMap::from_fn(case.dcel(), |_| rng.below(1000) as i64);
        let primal = case.primal().with_infinity().with_edge_weights(|e| weights[e]);
        let dual = case.dual().with_edge_weights(|e| -weights[e]);
        let [(least, in_primal), (greatest, in_dual)] =
            [forest(min_spanning_tree(primal)), forest(min_spanning_tree(dual))];
        assert_eq!(in_primal + in_dual, case.dcel().edge_count(), "{name}");
        let all: i64 = case.dcel().edges().map(|e| weights[e]).sum();
        assert_eq!(least - greatest, all, "{name}");
    }
}

#[test]
fn bridges_are_the_loops_of_the_dual() {
    println!("seed 9");
    let mut rng = Rng::new(9);
    let mut found = 0;
    for case in 0..120 {
        let whole = bounded(&mut rng);
        let arrangement = if case % 2 == 0 { whole } else { thinned(&mut rng, whole, 3) };
        let primal = Numbered::new(Primal::new(&arrangement));
        let of_primal: BTreeSet<EdgeId> = bridges(&primal).map(|edge| edge.id()).collect();
        let loops = Dual::new(&arrangement).edge_references().filter(|edge| edge.source() == edge.target());
        assert_eq!(loops.map(|edge| edge.id()).collect::<BTreeSet<_>>(), of_primal, "case {case}");
        found += of_primal.len();
    }
    assert!(found > 100, "{found}");
}

#[test]
fn lines_divide_the_plane_into_faces_of_two_colours() {
    println!("seed 10");
    let mut rng = Rng::new(10);
    for case in 0..60 {
        let (most, range) = (9, rng.between(2, 8));
        let arrangement = Unbounded::of_curves(LinearTraits, UnboundedPlane, &lines(&mut rng, most, range));
        let dual = Dual::new(&arrangement);
        assert!(arrangement.dcel().faces().all(|f| is_bipartite_undirected(dual, f)), "case {case}");
    }
    // Three faces around a point, and an edge with one face on both sides.
    let ends = [
        [[0, 0], [6, 0]],
        [[6, 0], [0, 6]],
        [[0, 6], [0, 0]],
        [[1, 1], [0, 0]],
        [[1, 1], [6, 0]],
        [[1, 1], [0, 6]],
    ];
    for (curves, colours) in
        [(&ends[..3], true), (&ends[..6], false), (&ends[..4], false), (&ends[..0], true)]
    {
        let curves: Vec<_> = curves.iter().map(|&ends| segment(ends)).collect();
        let arrangement = Bounded::of_curves(SegmentTraits, BoundedPlane, &curves);
        assert_eq!(
            is_bipartite_undirected(Dual::new(&arrangement), arrangement.corner_face()),
            colours,
            "{curves:?}"
        );
    }
}

#[test]
fn between_faces_of_a_grid_lie_as_many_lines_as_rows_and_columns() {
    let (columns, rows) = (4, 3);
    let grid = (0..columns).map(|x| line([[x, 0], [x, 1]])).chain((0..rows).map(|y| line([[0, y], [1, y]])));
    let grid = Unbounded::of_curves(LinearTraits, UnboundedPlane, &grid.collect::<Vec<_>>());
    let dual = Dual::new(&grid);
    let distances = grid.dcel().faces().flat_map(|f| dijkstra(dual, f, None, |_| 1_i64).into_values());
    let mut expected = Vec::new();
    let faces: Vec<_> = (0..=columns).flat_map(|i| (0..=rows).map(move |j| (i, j))).collect();
    for &(i, j) in &faces {
        expected.extend(faces.iter().map(|&(k, l)| (i - k).abs() + (j - l).abs()));
    }
    let mut distances: Vec<_> = distances.collect();
    distances.sort_unstable();
    expected.sort_unstable();
    assert_eq!(distances, expected);
}

#[test]
fn ascending_edges_of_lines_lead_from_above_to_below() {
    // Left of a line from left to right is above it.
    let curves = [0, 1, 2].map(|y| line([[0, y], [1, y]]));
    let arrangement = Unbounded::of_curves(LinearTraits, UnboundedPlane, &curves);
    let order =
        petgraph::algo::toposort(Dual::new(&arrangement).ascending(), None).expect("above is before below");
    let (dcel, top) = (arrangement.dcel(), order[0]);
    let below =
        |f: FaceId| dcel.halfedges().find(|h| h.is_even() && dcel.face(*h) == f).map(|h| dcel.face(h.twin()));
    assert!(order.windows(2).all(|pair| below(pair[0]) == Some(pair[1])));
    assert_eq!((order.len(), below(order[3])), (4, None));
    assert_eq!(order[3], arrangement.corner_face());
    assert_ne!(top, arrangement.corner_face());
}

#[test]
fn faces_joined_across_some_curves_are_those_of_the_others() {
    println!("seed 11");
    let mut rng = Rng::new(11);
    let mut joined = 0;
    for case in 0..80 {
        let range = rng.between(2, 8);
        let [red, blue] =
            [0; 2].map(|_| Bounded::of_curves(SegmentTraits, BoundedPlane, &segments(&mut rng, 10, range)));
        let (overlay, provenance) = overlay_all(&[&red, &blue]);
        for (operand, one) in [&red, &blue].into_iter().enumerate() {
            // An edge that lies in a face of the operand is none of its edges.
            let is_open = |e: EdgeId| matches!(provenance.of_edge(e)[operand], Cell::Face(_));
            let dual = Numbered::new(Dual::new(&overlay));
            let open = EdgeFiltered::from_fn(&dual, |edge| is_open(edge.id()));
            assert_eq!(connected_components(&open), one.counts().faces, "case {case}");
            joined += overlay.counts().faces - one.counts().faces;
        }
    }
    assert!(joined > 200, "{joined}");
}

#[test]
fn adaptors_of_one_family_are_of_one_type() {
    // The type does not name curves or surface, so graphs of different arrangements can stand in one list.
    println!("seed 12");
    let mut rng = Rng::new(12);
    let (plane, whole) = (bounded(&mut rng), unbounded(&mut rng));
    let graphs = [Primal::new(&plane), Primal::new(&whole), Primal::new(&whole).with_infinity()];
    let expected = [plane.counts().vertices, whole.counts().vertices, whole.counts().vertices + 1];
    assert_eq!(graphs.map(|graph| graph.node_count()), expected);
    assert_eq!(graphs[2].to_index(graphs[2].from_index(0)), 0);
}
