//! Ids with gaps.

use crate::cases::{Bounded, square};
use arrangement::Arrangement;
use arrangement::models::SegmentTraits;
use arrangement::topology::BoundedPlane;
use dcel::{EdgeId, EndFate, FaceId, Side};
use petgraph::algo::{connected_components, dijkstra};
use petgraph::visit::{EdgeCount, IntoEdgeReferences, IntoNodeIdentifiers, NodeCount, NodeIndexable};
use splitstar_graph::{Dual, Numbered, Primal};

/// Two squares beside each other and one in the left of them, of which a side is gone.
fn edited() -> Bounded {
    let curves: Vec<_> = [([0, 0], 4), ([10, 0], 4), ([1, 1], 2)]
        .into_iter()
        .flat_map(|(at, side)| square(at, side))
        .collect();
    let whole = Bounded::of_curves(SegmentTraits, BoundedPlane, &curves);
    assert_eq!(whole.counts().faces, 4);
    let mut parts = whole.into_parts();
    // A side of the first square goes, then the two that hang on it, then the last.
    let of_first = |dcel: &dcel::Dcel, e: EdgeId| {
        let inside = |v: dcel::VertexId| {
            let point = parts.points[v.index()].as_ref().map(|point| point.to_string());
            point.is_some_and(|p| ["(0, 0)", "(4, 0)", "(4, 4)", "(0, 4)"].contains(&p.as_str()))
        };
        dcel.ends(e).into_iter().all(inside)
    };
    let sides: Vec<_> = parts.dcel.edges().filter(|&e| of_first(&parts.dcel, e)).collect();
    assert_eq!(sides.len(), 4);
    let mut left = sides;
    while let Some(place) = left.iter().position(|&e| {
        let dcel = &parts.dcel;
        let [even, odd] = [e.halfedge(), e.halfedge().twin()];
        dcel.face(even) != dcel.face(odd) || dcel.ends(e).into_iter().any(|v| dcel.degree(v) == 1)
    }) {
        let e = left.remove(place);
        let survivor = if parts.dcel.face(e.halfedge().twin()) == FaceId(0) { Side::Odd } else { Side::Even };
        parts.dcel.remove_edge(e, [EndFate::Remove; 2], survivor);
    }
    assert!(left.is_empty());
    Arrangement::from_parts(SegmentTraits, BoundedPlane, parts).expect("two squares are left")
}

#[test]
fn gaps_are_stepped_over() {
    let arrangement = edited();
    let (dcel, primal, dual) = (arrangement.dcel(), Primal::new(&arrangement), Dual::new(&arrangement));
    assert!(dcel.vertex_bound() > dcel.vertex_count() && dcel.face_bound() > dcel.face_count());
    assert_eq!((primal.node_count(), primal.edge_count(), primal.node_bound()), (8, 8, dcel.vertex_bound()));
    assert_eq!((dual.node_count(), dual.edge_count(), dual.node_bound()), (3, 8, dcel.face_bound()));
    assert_eq!((primal.node_identifiers().count(), primal.edge_references().count()), (8, 8));
    assert_eq!((primal.directed().edge_count(), dual.directed().edge_references().count()), (16, 16));

    let [numbered, of_dual] = [Numbered::new(primal).node_bound(), Numbered::new(dual).node_bound()];
    assert_eq!((numbered, of_dual), (8, 3));
    assert_eq!(connected_components(&Numbered::new(primal)), arrangement.counts().components);
    let distances = dijkstra(dual, arrangement.corner_face(), None, |_| 1);
    assert_eq!((distances.len(), distances.into_values().max()), (3, Some(1)));
}
