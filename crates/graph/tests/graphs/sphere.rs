//! Graphs of arrangements on a sphere: a pole where nothing is, is no node.

use arrangement::Arrangement;
use arrangement::models::{Geodesic, GeodesicTraits};
use arrangement::topology::Sphere;
use arrangement::traits::BasicTraits;
use petgraph::algo::kosaraju_scc;
use petgraph::visit::{EdgeCount, NodeCount};
use splitstar_graph::{Dual, Primal};
use testkit::Rng;

type Direction = <GeodesicTraits as BasicTraits>::Point;

fn check(curves: &[Geodesic], context: &str) {
    let globe = Arrangement::of_curves(GeodesicTraits::new(), Sphere, curves);
    assert_eq!(globe.check_valid(), [], "{context}");
    let stored = globe.counts_with_splits();
    let (primal, dual) = (Primal::new(&globe), Dual::new(&globe));
    assert_eq!((primal.node_count(), primal.edge_count()), (stored.vertices, stored.edges), "{context}");
    assert_eq!(kosaraju_scc(primal).len(), stored.components, "{context}");
    assert_eq!((dual.node_count(), dual.edge_count()), (stored.faces, stored.edges), "{context}");
    assert_eq!(kosaraju_scc(dual).len(), 1, "{context}");
}

#[test]
fn arcs_on_a_sphere() {
    check(&[], "nothing");
    let at = |p: [i64; 3]| Direction::from_i64(p).expect("a direction is not zero");
    let [north, south] = [[0, 0, 1], [0, 0, -1]].map(at);
    check(&[Geodesic::point(north.clone())], "a pole");
    let meridian = Geodesic::arc_via(south, &at([1, 2, 0]), north).expect("it is half a circle");
    check(std::slice::from_ref(&meridian), "a meridian");
    println!("seed 91");
    let mut rng = Rng::new(91);
    for case in 0..200 {
        let mut any = || loop {
            if let Some(p) = Direction::from_i64([0; 3].map(|_| rng.within(2))) {
                return p;
            }
        };
        let mut curve = |i: usize| match i % 4 {
            0 => Geodesic::point(any()),
            _ => {
                let (p, q) = (any(), any());
                Geodesic::arc(p.clone(), q).unwrap_or_else(|_| Geodesic::point(p))
            }
        };
        let curves: Vec<Geodesic> = (0..case % 12).map(&mut curve).collect();
        check(&curves, &format!("case {case}: {curves:?}"));
    }
}
