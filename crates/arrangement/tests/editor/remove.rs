//! Edges and vertices go, until nothing is left; and come again when that is taken back.

use crate::scenes::{Law, Scene, check, for_all, take_back, watch};
use dcel::EndFate;
use exact::planar::Point2;
use splitstar_arrangement::topology::Topology;
use splitstar_arrangement::traits::ArrangementTraits;
use testkit::Rng;

struct EveryEdge;

impl Law for EveryEdge {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        let mut editor = watch(scene.sweep_all());
        check(&editor);
        let mut states = Vec::new();
        let mut edges: Vec<_> = editor.arrangement().dcel().edges().collect();
        rng.shuffle(&mut edges);
        for e in edges {
            states.push(editor.arrangement().clone());
            let fates = [0; 2].map(|_| if rng.one_in(6) { EndFate::Isolate } else { EndFate::Remove });
            editor.remove_edge_with(e, fates);
            check(&editor);
        }
        let isolated: Vec<_> = editor.arrangement().vertices().collect();
        for v in isolated {
            states.push(editor.arrangement().clone());
            assert_eq!(editor.remove_vertex(v), Ok(None));
            check(&editor);
        }
        assert_eq!(editor.arrangement().difference(&scene.empty()), None);
        take_back(&mut editor, states);
    }
}

#[test]
fn removing_every_edge_leaves_nothing() {
    for_all(&EveryEdge, 40, 1);
}

struct EveryVertex;

impl Law for EveryVertex {
    fn check<G, T>(&self, scene: &Scene<G, T>, rng: &mut Rng)
    where
        G: ArrangementTraits<Point = Point2> + Clone,
        T: Topology<G>,
    {
        let mut editor = watch(scene.sweep_all());
        let mut states = Vec::new();
        let mut vertices: Vec<_> = editor.arrangement().vertices().collect();
        rng.shuffle(&mut vertices);
        for v in vertices {
            if !editor.arrangement().dcel().has_vertex(v) {
                continue;
            }
            let before = editor.arrangement().clone();
            let degree = before.dcel().degree(v);
            if rng.one_in(2) {
                let edges = editor.remove_vertex_with_edges(v).unwrap();
                assert!(edges.iter().all(|&e| !editor.arrangement().dcel().has_edge(e)));
            } else if let Err(needed) = editor.remove_vertex(v) {
                assert!(degree > 0 && needed.vertex == v, "{needed}");
                assert_eq!(before.stamp(), editor.arrangement().stamp(), "nothing is changed");
                continue;
            }
            assert!(!editor.arrangement().dcel().has_vertex(v));
            states.push(before);
            check(&editor);
        }
        take_back(&mut editor, states);
    }
}

#[test]
fn vertices_go_with_their_edges_or_without() {
    for_all(&EveryVertex, 40, 1000);
}
